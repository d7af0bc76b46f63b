//! Everything there is to say about a cam.

use crate::extreme::{extremes, intervals};
use crate::interference::{arm_cut, crossing};
use crate::samples::{Quantity, Samples};
use crate::{Body, Cam, Extremes, Finding, FindingKind, Joint, Level, Point, Program};
use std::f64::consts::TAU;

/// |φ| may pass its limit by this much (radians), which is rounding: a cure that is solved for lands on the limit.
const ANGLE_TOLERANCE: f64 = 1e-9;

/// ρ this small beside the base radius is a cusp; so is a cam that a cure has brought to the edge.
const CUSP_TOLERANCE: f64 = 1e-9;

/// How far below the base circle rounding may take the follower, as a part of its whole travel.
const BELOW_TOLERANCE: f64 = 1e-9;

/// Extremes over the turn, refined between stations. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Displacement.
    pub s: Extremes,
    /// ds/dθ.
    pub v: Extremes,
    /// d²s/dθ².
    pub a: Extremes,
    /// d³s/dθ³.
    pub j: Extremes,
    /// φ, radians.
    pub pressure_angle: Extremes,
    /// ρ of the profile. Where the profile is partly hollow, ρ runs off to ±∞ where it straightens, and these are infinite.
    pub rho: Extremes,
    /// ρp of the pitch curve; none for a flat face.
    pub rho_pitch: Option<Extremes>,
    /// The contact on a flat face (see [`Contact::reach`](crate::Contact::reach)); none for others.
    pub reach: Option<Extremes>,
    /// The least ρ where the profile is convex, and its θ; negative when it is undercut there.
    pub least_convex: Option<(f64, f64)>,
    /// The tightest hollow, as a negative ρ, and its θ.
    pub tightest_hollow: Option<(f64, f64)>,
}

/// A column of the analysis, in the units of the core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// θ, radians.
    Theta,
    /// Displacement.
    S,
    /// ds/dθ.
    V,
    /// d²s/dθ².
    A,
    /// d³s/dθ³.
    J,
    /// φ, radians.
    PressureAngle,
    /// ρ of the profile.
    Rho,
    /// ρp of the pitch curve.
    RhoPitch,
    /// Profile in the cam's frame.
    X,
    /// Profile in the cam's frame.
    Y,
    /// Pitch curve in the cam's frame.
    PitchX,
    /// Pitch curve in the cam's frame.
    PitchY,
    /// Contact on a flat face.
    Contact,
}

impl Column {
    /// Every column, in the order of reports.
    pub const ALL: [Self; 13] = [
        Self::Theta,
        Self::S,
        Self::V,
        Self::A,
        Self::J,
        Self::PressureAngle,
        Self::Rho,
        Self::RhoPitch,
        Self::X,
        Self::Y,
        Self::PitchX,
        Self::PitchY,
        Self::Contact,
    ];

    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Theta => "theta",
            Self::S => "s",
            Self::V => "v",
            Self::A => "a",
            Self::J => "j",
            Self::PressureAngle => "pressure_angle",
            Self::Rho => "rho",
            Self::RhoPitch => "rho_pitch",
            Self::X => "x",
            Self::Y => "y",
            Self::PitchX => "pitch_x",
            Self::PitchY => "pitch_y",
            Self::Contact => "contact",
        }
    }
}

/// A cam analysed.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// Extremes over the turn.
    pub summary: Summary,
    /// Every joint, the one at θ = 0 first.
    pub joints: Vec<Joint>,
    /// What is wrong, the worst kinds first.
    pub findings: Vec<Finding>,
    /// The verdict.
    pub level: Level,
    columns: Vec<Vec<f64>>,
}

impl Analysis {
    /// Analyses a cam at `steps` equal steps over the turn: `steps` + 1 rows, the last repeating the first, a row on a joint
    /// holding the limits from the right. At least one step is taken.
    ///
    /// The summary and the verdict are exact whatever `steps` is.
    #[must_use]
    pub fn of(cam: &Cam, steps: usize) -> Self {
        let steps = steps.max(1);
        let mut samples = Samples::of(cam, steps);
        if let Body::Swing { .. } = cam.follower.body {
            samples.measure_radius(cam);
        }
        let summary = summarise(cam, &samples);
        let joints = cam.program.classified_joints();
        let findings = judge(cam, &samples, &summary, &joints);
        let level = findings.iter().map(|finding| finding.kind.severity()).max().unwrap_or(Level::Acceptable);
        Self { columns: tabulate(cam, samples, steps), summary, joints, findings, level }
    }

    /// A column, or nothing when it does not apply to this follower.
    #[must_use]
    pub fn column(&self, column: Column) -> Option<&[f64]> {
        let values = &self.columns[column as usize];
        (!values.is_empty()).then_some(values)
    }
}

fn summarise(cam: &Cam, samples: &Samples) -> Summary {
    let of = |quantity: Quantity| extremes(cam, samples, quantity);
    let bend = of(Quantity::Bend);
    let flat = cam.follower.is_flat();
    let radius = cam.follower.disc_radius();
    let (rho, rho_pitch) = if flat { (bend, None) } else { (radii(&bend, radius), Some(radii(&bend, 0.0))) };
    let least = (cam.follower.profile_radius(bend.max), bend.max_at);
    Summary {
        s: of(Quantity::S),
        v: of(Quantity::V),
        a: of(Quantity::A),
        j: of(Quantity::J),
        pressure_angle: of(Quantity::PressureAngle),
        rho,
        rho_pitch,
        reach: flat.then(|| of(Quantity::Reach)),
        least_convex: if flat { Some((bend.min, bend.min_at)) } else { (bend.max > 0.0).then_some(least) },
        tightest_hollow: (!flat && bend.min < 0.0).then(|| (1.0 / bend.min - radius, bend.min_at)),
    }
}

/// Extremes of 1/κ − `radius` from those of κ: monotone while κ keeps its sign, unbounded when it does not.
fn radii(curvature: &Extremes, radius: f64) -> Extremes {
    let Extremes { min, min_at, max, max_at } = *curvature;
    if min < 0.0 && max > 0.0 {
        return Extremes { min: f64::NEG_INFINITY, min_at, max: f64::INFINITY, max_at };
    }
    Extremes { min: 1.0 / max - radius, min_at: max_at, max: 1.0 / min - radius, max_at: min_at }
}

fn judge(cam: &Cam, samples: &Samples, summary: &Summary, joints: &[Joint]) -> Vec<Finding> {
    let (mild, mut findings): (Vec<Finding>, Vec<Finding>) =
        jumps(joints).into_iter().partition(|finding| finding.kind.severity() < Level::Unacceptable);
    findings.extend(doubtful(&cam.program));
    findings.extend(steep(cam, samples, summary));
    findings.extend(below_base(cam, samples, summary));
    let cuts = irregular(cam, samples, summary);
    let regular = cuts.is_empty();
    findings.extend(cuts);
    findings.extend(misplaced(cam, samples, summary));
    if regular {
        findings.extend(crossing(samples));
        findings.extend(arm_cut(cam, samples));
    }
    findings.extend(mild);
    findings
}

/// One finding for each order that jumps, with all its places.
fn jumps(joints: &[Joint]) -> Vec<Finding> {
    let size = |joint: &Joint, order: u8| {
        (joint.after.order(usize::from(order)) - joint.before.order(usize::from(order))).abs()
    };
    let of_order = |order: u8| {
        let here: Vec<&Joint> = joints.iter().filter(|joint| joint.jump == Some(order)).collect();
        let worst = here.iter().copied().max_by(|a, b| size(a, order).total_cmp(&size(b, order)))?;
        Some(Finding {
            kind: FindingKind::Jump(order),
            theta: worst.theta,
            interval: None,
            places: here.iter().map(|joint| joint.theta).collect(),
            value: size(worst, order),
            limit: 0.0,
        })
    };
    (0..4).filter_map(of_order).collect()
}

/// Free laws whose curve is not to be trusted.
fn doubtful(program: &Program) -> impl Iterator<Item = Finding> {
    program.doubts().iter().map(|doubt| {
        let stretch = (program.borders()[doubt.segment], program.borders()[doubt.segment + 1]);
        finding(FindingKind::Doubtful, stretch.0, doubt.condition, doubt.limit, Some(stretch))
    })
}

fn steep(cam: &Cam, samples: &Samples, summary: &Summary) -> Option<Finding> {
    let limit = cam.follower.pressure_angle_limit();
    let (value, theta) = summary.pressure_angle.greatest_size();
    (value > limit + ANGLE_TOLERANCE).then(|| {
        let stretches = intervals(cam, samples, Quantity::PressureAngle, theta, |angle| angle.abs() - limit);
        finding(FindingKind::PressureAngle, theta, value, limit, around(&stretches, theta))
    })
}

fn below_base(cam: &Cam, samples: &Samples, summary: &Summary) -> Option<Finding> {
    let Extremes { min, min_at, .. } = summary.s;
    (min < -BELOW_TOLERANCE * summary.s.max.abs().max(f64::MIN_POSITIVE)).then(|| {
        let stretches = intervals(cam, samples, Quantity::S, min_at, |s| -s);
        finding(FindingKind::BelowBase, min_at, min, 0.0, around(&stretches, min_at))
    })
}

/// Cusps and undercut stretches, each stretch with its own worst place.
fn irregular(cam: &Cam, samples: &Samples, summary: &Summary) -> Vec<Finding> {
    let Some((least, theta)) = summary.least_convex else { return Vec::new() };
    let edge = CUSP_TOLERANCE * cam.follower.base_radius;
    if least > edge {
        return Vec::new();
    }
    if least >= -edge {
        return vec![finding(FindingKind::Cusp, theta, 0.0, 0.0, None)];
    }
    let kind = if cam.follower.is_flat() { FindingKind::ConcaveFlat } else { FindingKind::Undercut };
    let follower = &cam.follower;
    let stretches = intervals(cam, samples, Quantity::Bend, theta, |bend| -follower.regularity(bend));
    let bends = samples.grid(Quantity::Bend);
    let each = stretches.iter().map(|&(from, to)| {
        let inside = (0..bends.len()).filter(|&i| within((from, to), samples.theta[i]));
        let worst = inside.min_by(|&a, &b| follower.regularity(bends[a]).total_cmp(&follower.regularity(bends[b])));
        let (value, at) = match worst {
            _ if within((from, to), theta) => (least, theta),
            Some(i) => (follower.profile_radius(bends[i]), samples.theta[i]),
            // So short that no station falls in it: anywhere in it is as good.
            None => (follower.profile_radius(cam.at(0.5 * (from + to)).1.bend), (0.5 * (from + to)) % TAU),
        };
        finding(kind, at, value, 0.0, Some((from, to)))
    });
    each.collect()
}

/// A pivot or a swinging face where it cannot be.
fn misplaced(cam: &Cam, samples: &Samples, summary: &Summary) -> Vec<Finding> {
    let mut findings = Vec::new();
    let Body::Swing { pivot } = cam.follower.body else { return findings };
    let radius = extremes(cam, samples, Quantity::Radius);
    if radius.max >= pivot.norm() {
        findings.push(finding(FindingKind::PivotInsideCam, radius.max_at, radius.max, pivot.norm(), None));
    }
    if let Some(reach) = summary.reach {
        let lead = extremes(cam, samples, Quantity::Lead);
        if lead.min <= 0.0 {
            findings.push(finding(FindingKind::FaceOvertaken, lead.min_at, 1.0 - lead.min, 1.0, None));
        } else if reach.min <= 0.0 {
            let stretches = intervals(cam, samples, Quantity::Reach, reach.min_at, |reach| -reach);
            let interval = around(&stretches, reach.min_at);
            findings.push(finding(FindingKind::ContactPastPivot, reach.min_at, reach.min, 0.0, interval));
        }
    }
    findings
}

pub(crate) fn finding(kind: FindingKind, theta: f64, value: f64, limit: f64, interval: Option<(f64, f64)>) -> Finding {
    Finding { kind, theta, interval, places: vec![theta], value, limit }
}

fn within((from, to): (f64, f64), theta: f64) -> bool {
    from <= theta && theta <= to || from <= theta + TAU && theta + TAU <= to
}

fn around(stretches: &[(f64, f64)], theta: f64) -> Option<(f64, f64)> {
    stretches.iter().copied().find(|&stretch| within(stretch, theta))
}

/// The columns asked for: the grid's own arrays, thinned when the grid is finer, closed by repeating the first row.
fn tabulate(cam: &Cam, mut samples: Samples, steps: usize) -> Vec<Vec<f64>> {
    let every = samples.theta.len() / steps;
    let finish = |mut values: Vec<f64>| {
        if every > 1 {
            values = values.into_iter().step_by(every).collect();
        }
        values.extend(values.first().copied());
        values
    };
    let follower = &cam.follower;
    let bend = samples.take(Quantity::Bend);
    let part = |points: &[Point], part: fn(&Point) -> f64| points.iter().map(part).collect::<Vec<f64>>();
    let of = |column: Column| match column {
        Column::Theta => std::mem::take(&mut samples.theta),
        Column::S => samples.take(Quantity::S),
        Column::V => samples.take(Quantity::V),
        Column::A => samples.take(Quantity::A),
        Column::J => samples.take(Quantity::J),
        Column::PressureAngle => samples.take(Quantity::PressureAngle),
        Column::Rho => bend.iter().map(|&bend| follower.profile_radius(bend)).collect(),
        Column::RhoPitch if follower.is_flat() => Vec::new(),
        Column::RhoPitch => bend.iter().map(|bend| 1.0 / bend).collect(),
        Column::X => part(&samples.profile, |point| point.re),
        Column::Y => part(&samples.profile, |point| point.im),
        Column::PitchX => part(&samples.pitch, |point| point.re),
        Column::PitchY => part(&samples.pitch, |point| point.im),
        Column::Contact => samples.take(Quantity::Reach),
    };
    let mut columns: Vec<Vec<f64>> = Column::ALL.map(of).map(finish).into();
    if let Some(last) = columns[Column::Theta as usize].last_mut() {
        *last = TAU;
    }
    columns
}
