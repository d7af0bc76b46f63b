//! Everything there is to say about a cam.

use crate::extreme::{extremes, intervals};
use crate::interference::{arm_cut, crossing};
use crate::samples::{Quantity, Samples};
use crate::{Body, Cam, Closure, Contact, Extremes, Finding, FindingKind, Joint, Level, Point, Program};
use std::f64::consts::{PI, TAU};

/// |φ| may pass its limit by this much (radians), which is rounding: a cure that is solved for lands on the limit.
const ANGLE_TOLERANCE: f64 = 1e-9;

/// ρ this small beside the base radius is a cusp; so is a cam that a cure has brought to the edge.
const CUSP_TOLERANCE: f64 = 1e-9;

/// How far below the base circle rounding may take the follower, as a part of its whole travel.
const BELOW_TOLERANCE: f64 = 1e-9;

/// Extremes over the cycle, refined between stations. Angles in radians.
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
    /// The breadth of a cam held by a yoke, measured over the turn; least and greatest differ by rounding alone.
    pub breadth: Option<Extremes>,
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
    /// Outer wall of a groove in the cam's frame.
    OuterX,
    /// Outer wall of a groove in the cam's frame.
    OuterY,
}

impl Column {
    /// Every column, in the order of reports.
    pub const ALL: [Self; 15] = [
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
        Self::OuterX,
        Self::OuterY,
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
            Self::OuterX => "outer_x",
            Self::OuterY => "outer_y",
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
        let level = findings.iter().map(|finding| finding.level).max().unwrap_or(Level::Acceptable);
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
        breadth: (cam.closure == Closure::Yoke).then(|| measured_breadth(cam, samples)),
    }
}

/// The distance between the two parallel tangents of the profile (or between the near sides of two rollers on the same
/// diameter), station by station: half a turn away is as many stations away.
fn measured_breadth(cam: &Cam, samples: &Samples) -> Extremes {
    let s = samples.grid(Quantity::S);
    let half = s.len() / 2;
    let facing = |i: usize| 2.0 * cam.follower.base_radius + s[i] + cam.program.at(samples.theta[i] + PI).s;
    let mut found = Extremes { min: f64::INFINITY, min_at: 0.0, max: f64::NEG_INFINITY, max_at: 0.0 };
    for i in 0..half.max(1) {
        let (breadth, theta) = (facing(i), samples.theta[i]);
        if breadth < found.min {
            (found.min, found.min_at) = (breadth, theta);
        }
        if breadth > found.max {
            (found.max, found.max_at) = (breadth, theta);
        }
    }
    found
}

/// Extremes of 1/κ − `radius` from those of κ: monotone while κ keeps its sign, unbounded when it does not.
fn radii(curvature: &Extremes, radius: f64) -> Extremes {
    let Extremes { min, min_at, max, max_at } = *curvature;
    if min < 0.0 && max > 0.0 {
        return Extremes { min: f64::NEG_INFINITY, min_at, max: f64::INFINITY, max_at };
    }
    // Hollow all along and straight somewhere: ρ comes from −∞.
    let max = if max == 0.0 && min < 0.0 { -0.0 } else { max };
    Extremes { min: 1.0 / max - radius, min_at: max_at, max: 1.0 / min - radius, max_at: min_at }
}

fn judge(cam: &Cam, samples: &Samples, summary: &Summary, joints: &[Joint]) -> Vec<Finding> {
    let (mild, mut findings): (Vec<Finding>, Vec<Finding>) =
        jumps(cam, joints).into_iter().partition(|finding| finding.level < Level::Unacceptable);
    findings.extend(doubtful(&cam.program));
    findings.extend(steep(cam, samples, summary));
    findings.extend(below_base(cam, samples, summary));
    let mut cuts = irregular(cam, samples, summary);
    cuts.extend(groove_cuts(cam, samples));
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
fn jumps(cam: &Cam, joints: &[Joint]) -> Vec<Finding> {
    let size = |joint: &Joint, order: u8| {
        (joint.after.order(usize::from(order)) - joint.before.order(usize::from(order))).abs()
    };
    let of_order = |order: u8| {
        let here: Vec<&Joint> = joints.iter().filter(|joint| joint.jump == Some(order)).collect();
        let worst = here.iter().copied().max_by(|a, b| size(a, order).total_cmp(&size(b, order)))?;
        Some(Finding {
            kind: FindingKind::Jump(order),
            level: FindingKind::Jump(order).severity(cam.closure),
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
        finding(FindingKind::PressureAngle, theta, value, limit, around(cam, &stretches, theta))
    })
}

fn below_base(cam: &Cam, samples: &Samples, summary: &Summary) -> Option<Finding> {
    let Extremes { min, min_at, .. } = summary.s;
    (min < -BELOW_TOLERANCE * summary.s.max.abs().max(f64::MIN_POSITIVE)).then(|| {
        let stretches = intervals(cam, samples, Quantity::S, min_at, |s| -s);
        finding(FindingKind::BelowBase, min_at, min, 0.0, around(cam, &stretches, min_at))
    })
}

/// Cusps and undercut stretches, each stretch with its own worst place.
fn irregular(cam: &Cam, samples: &Samples, summary: &Summary) -> Vec<Finding> {
    let Some((least, theta)) = summary.least_convex else { return Vec::new() };
    let edge = CUSP_TOLERANCE * cam.size();
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
        let inside = (0..bends.len()).filter(|&i| within(cam, (from, to), samples.theta[i]));
        let worst = inside.min_by(|&a, &b| follower.regularity(bends[a]).total_cmp(&follower.regularity(bends[b])));
        let (value, at) = match worst {
            _ if within(cam, (from, to), theta) => (least, theta),
            Some(i) => (follower.profile_radius(bends[i]), samples.theta[i]),
            // So short that no station falls in it: anywhere in it is as good.
            None => {
                let middle = (0.5 * (from + to)) % cam.program.span();
                (follower.profile_radius(cam.at(middle).1.bend), middle)
            }
        };
        finding(kind, at, value, 0.0, Some((from, to)))
    });
    each.collect()
}

/// Stretches of a groove whose outer wall, the pitch curve offset outwards, is cut away in a hollow: 1 + Rf·κp < 0.
fn groove_cuts(cam: &Cam, samples: &Samples) -> Option<Finding> {
    if cam.closure != Closure::Groove {
        return None;
    }
    let radius = cam.follower.disc_radius();
    let Extremes { min, min_at, .. } = extremes(cam, samples, Quantity::Bend);
    (1.0 + radius * min < -CUSP_TOLERANCE).then(|| {
        let stretches = intervals(cam, samples, Quantity::Bend, min_at, |bend| -1.0 - radius * bend);
        let place = around(cam, &stretches, min_at);
        finding(FindingKind::GrooveUndercut, min_at, -1.0 / min, radius, place)
    })
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
            let interval = around(cam, &stretches, reach.min_at);
            findings.push(finding(FindingKind::ContactPastPivot, reach.min_at, reach.min, 0.0, interval));
        }
    }
    findings
}

pub(crate) fn finding(kind: FindingKind, theta: f64, value: f64, limit: f64, interval: Option<(f64, f64)>) -> Finding {
    // Only jumps are ever less than unacceptable.
    Finding { kind, level: Level::Unacceptable, theta, interval, places: vec![theta], value, limit }
}

fn within(cam: &Cam, (from, to): (f64, f64), theta: f64) -> bool {
    let again = theta + TAU;
    from <= theta && theta <= to || cam.program.is_cyclic() && from <= again && again <= to
}

fn around(cam: &Cam, stretches: &[(f64, f64)], theta: f64) -> Option<(f64, f64)> {
    stretches.iter().copied().find(|&stretch| within(cam, stretch, theta))
}

/// The columns asked for: the grid's own arrays, thinned when the grid is finer, closed by the row at the end of the cycle: the
/// first again when it comes round, the last limit from within when it does not.
fn tabulate(cam: &Cam, mut samples: Samples, steps: usize) -> Vec<Vec<f64>> {
    let every = samples.theta.len() / steps;
    let span = cam.program.span();
    let end = (!cam.program.is_cyclic()).then(|| cam.at(span).1);
    let finish = |(mut values, last): (Vec<f64>, Option<f64>)| {
        if every > 1 {
            values = values.into_iter().step_by(every).collect();
        }
        if let Some(&first) = values.first() {
            values.push(last.filter(|_| end.is_some()).unwrap_or(first));
        }
        values
    };
    let follower = &cam.follower;
    let bends = (samples.take(Quantity::Bend), samples.last(Quantity::Bend));
    let of_bend = |radius: &dyn Fn(f64) -> f64| {
        (bends.0.iter().map(|&bend| radius(bend)).collect::<Vec<f64>>(), bends.1.map(radius))
    };
    let part = |points: &[Point], of: fn(&Contact) -> Point, part: fn(&Point) -> f64| {
        let last = end.as_ref().map(|contact| part(&cam.in_cam_frame(of(contact), span)));
        (points.iter().map(part).collect::<Vec<f64>>(), last)
    };
    // The outer wall lies as far from the trace point as the inner one, on the other side.
    let outer = |part: fn(&Point) -> f64| {
        let mirrored = |inner: &Point, trace: &Point| part(&(trace * 2.0 - inner));
        let walls = samples.profile.iter().zip(&samples.pitch).map(|(inner, trace)| mirrored(inner, trace)).collect();
        (walls, end.as_ref().map(|contact| part(&cam.in_cam_frame(contact.trace * 2.0 - contact.point, span))))
    };
    let walls = if cam.closure == Closure::Groove { [outer(|p| p.re), outer(|p| p.im)] } else { Default::default() };
    let [outer_x, outer_y] = walls;
    let mut walls = [Some(outer_x), Some(outer_y)];
    let mut of = |column: Column| {
        let mut own = |quantity: Quantity| (samples.take(quantity), samples.last(quantity));
        match column {
            Column::Theta => (std::mem::take(&mut samples.theta), Some(span)),
            Column::S => own(Quantity::S),
            Column::V => own(Quantity::V),
            Column::A => own(Quantity::A),
            Column::J => own(Quantity::J),
            Column::PressureAngle => own(Quantity::PressureAngle),
            Column::Rho => of_bend(&|bend| follower.profile_radius(bend)),
            Column::RhoPitch if follower.is_flat() => Default::default(),
            Column::RhoPitch => of_bend(&|bend| 1.0 / bend),
            Column::X => part(&samples.profile, |contact| contact.point, |point| point.re),
            Column::Y => part(&samples.profile, |contact| contact.point, |point| point.im),
            Column::PitchX => part(&samples.pitch, |contact| contact.trace, |point| point.re),
            Column::PitchY => part(&samples.pitch, |contact| contact.trace, |point| point.im),
            Column::Contact => own(Quantity::Reach),
            Column::OuterX => walls[0].take().unwrap_or_default(),
            Column::OuterY => walls[1].take().unwrap_or_default(),
        }
    };
    let mut columns: Vec<Vec<f64>> = Column::ALL.into_iter().map(|column| finish(of(column))).collect();
    if let Some(last) = columns[Column::Theta as usize].last_mut() {
        *last = span;
    }
    columns
}
