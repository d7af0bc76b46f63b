//! What would put a finding right: computed for the cam at hand, and tried before it is offered.

use crate::sizing::geometry_passes;
use crate::{
    Cam, Finding, FindingKind, LAWS, Law, Level, Program, Segment, balanced_eccentricity, smallest_base_radius,
};

/// A change that removes a finding.
#[derive(Clone, Debug, PartialEq)]
pub enum Cure {
    /// The smallest base radius with which the geometry passes.
    BaseRadius(f64),
    /// The eccentricity that makes |φ| equal in rise and return; |φ| (radians) is then `pressure_angle`.
    Eccentricity {
        /// e.
        value: f64,
        /// The greatest |φ| that remains, radians.
        pressure_angle: f64,
    },
    /// Other laws for some segments, by index; β and L stay.
    Laws {
        /// The segments to change.
        changes: Vec<(usize, &'static Law)>,
        /// The lowest order that still jumps anywhere, when one does.
        remaining_jump: Option<u8>,
    },
}

/// Most alternatives offered for one finding.
const MOST_CURES: usize = 3;

/// |φ| gained by a balancing eccentricity must be worth it: this many radians (half a degree) at least.
const WORTHWHILE: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// The cures of a finding, the best first. Each has been tried: the finding is gone in the cam it gives, or (for an
/// eccentricity) the pressure angle is lower.
#[must_use]
pub fn cures(cam: &Cam, finding: &Finding) -> Vec<Cure> {
    match finding.kind {
        FindingKind::Jump(order) => law_cures(cam, |trial| trial.lowest_jump.is_none_or(|jump| jump > order)),
        FindingKind::BelowBase => law_cures(cam, |trial| !trial.below_base),
        FindingKind::PressureAngle => {
            smaller_first(smallest_base_radius(cam).map(Cure::BaseRadius), eccentricity(cam, finding))
        }
        FindingKind::Cusp
        | FindingKind::Undercut
        | FindingKind::ConcaveFlat
        | FindingKind::SelfCrossing
        | FindingKind::ArmCutsCam
        | FindingKind::PivotInsideCam
        | FindingKind::FaceOvertaken
        | FindingKind::ContactPastPivot => {
            let size = smallest_base_radius(cam).filter(|size| (size / cam.follower.base_radius - 1.0).abs() > 1e-9);
            size.map(Cure::BaseRadius).into_iter().collect()
        }
    }
}

/// An eccentricity that passes by itself goes before a larger cam; one that only helps goes after.
fn smaller_first(base_radius: Option<Cure>, eccentricity: Option<(Cure, bool)>) -> Vec<Cure> {
    let mut cures: Vec<Cure> = base_radius.into_iter().collect();
    if let Some((cure, passes)) = eccentricity {
        cures.insert(if passes { 0 } else { cures.len() }, cure);
    }
    cures
}

fn eccentricity(cam: &Cam, finding: &Finding) -> Option<(Cure, bool)> {
    let value = balanced_eccentricity(cam)?;
    let index = cam.follower.kind.index_of("eccentricity")?;
    let moved = Cam::new(cam.program.clone(), cam.follower.with_value(index, value).ok()?);
    let analysis = crate::Analysis::of(&moved, 720);
    let pressure_angle = analysis.summary.pressure_angle.greatest_size().0;
    let clean = analysis.findings.iter().all(|f| matches!(f.kind, FindingKind::Jump(_) | FindingKind::PressureAngle));
    let worthwhile = clean && pressure_angle < finding.value - WORTHWHILE;
    worthwhile.then(|| (Cure::Eccentricity { value, pressure_angle }, geometry_passes(&moved)))
}

/// A program tried as a cure.
struct Trial {
    changes: Vec<(usize, &'static Law)>,
    lowest_jump: Option<u8>,
    below_base: bool,
    peak_acceleration: f64,
    geometry: bool,
}

/// Programs in which the same law replaces every segment that a joint blames, or the fewest of them; the smoothest first and
/// among equals the gentlest.
fn law_cures(cam: &Cam, cured: impl Fn(&Trial) -> bool) -> Vec<Cure> {
    let segments = cam.program.segments();
    let blamed = blamed_segments(cam);
    let mut trials: Vec<Trial> = Vec::new();
    for law in LAWS.iter().copied().filter(|law| !law.is_dwell()) {
        let all: Vec<(usize, &'static Law)> = blamed.iter().map(|&k| (k, law)).collect();
        trials.extend(attempt(cam, segments, all).filter(&cured));
        if blamed.len() > 1 {
            for &k in &blamed {
                trials.extend(attempt(cam, segments, vec![(k, law)]).filter(&cured));
            }
        }
    }
    let was_sound = geometry_passes(cam);
    trials.retain(|trial| trial.geometry || !was_sound);
    trials.sort_by(|a, b| {
        let smoothness = |trial: &Trial| std::cmp::Reverse(trial.lowest_jump.unwrap_or(u8::MAX));
        smoothness(a).cmp(&smoothness(b)).then(a.peak_acceleration.total_cmp(&b.peak_acceleration))
    });
    // The smoothest there is, and the gentlest that is less smooth: a choice, not a catalogue.
    let mut kept: Vec<Trial> = Vec::new();
    for trial in trials {
        if kept.len() < MOST_CURES && kept.iter().all(|other| other.changes.len() != trial.changes.len() || other.lowest_jump != trial.lowest_jump) {
            kept.push(trial);
        }
    }
    kept.into_iter().map(|trial| Cure::Laws { changes: trial.changes, remaining_jump: trial.lowest_jump }).collect()
}

/// Moving segments that touch a jump, contain one, or go below the base circle.
fn blamed_segments(cam: &Cam) -> Vec<usize> {
    let analysis = crate::Analysis::of(cam, 720);
    let segments = cam.program.segments();
    let n = segments.len();
    let mut blamed = vec![false; n];
    for joint in analysis.joints.iter().filter(|joint| joint.jump.is_some()) {
        let at_border = cam.program.borders()[..n].contains(&joint.theta);
        blamed[joint.segment] = true;
        if at_border {
            blamed[(joint.segment + n - 1) % n] = true;
        }
    }
    if analysis.findings.iter().any(|finding| finding.kind == FindingKind::BelowBase) {
        let low = analysis.summary.s.min_at;
        blamed[cam.program.stretches()[cam.program.stretch_index(low)].segment] = true;
    }
    (0..n).filter(|&k| blamed[k] && !segments[k].law.is_dwell()).collect()
}

fn attempt(cam: &Cam, segments: &[Segment], changes: Vec<(usize, &'static Law)>) -> std::option::IntoIter<Trial> {
    let mut changed = segments.to_vec();
    for &(k, law) in &changes {
        changed[k] = Segment { parameters: law.default_parameters(), law, ..changed[k] };
    }
    let same = changes.iter().all(|&(k, law)| segments[k].law == law);
    let trial = (!same).then(|| Program::new(&changed).ok()).flatten().map(|program| {
        let moved = Cam::new(program, cam.follower);
        let analysis = crate::Analysis::of(&moved, 720);
        Trial {
            changes,
            lowest_jump: analysis.joints.iter().filter_map(|joint| joint.jump).min(),
            below_base: analysis.findings.iter().any(|finding| finding.kind == FindingKind::BelowBase),
            peak_acceleration: analysis.summary.a.greatest_size().0,
            geometry: analysis.findings.iter().all(|f| f.kind.severity() < Level::Unacceptable || matches!(f.kind, FindingKind::Jump(_))),
        }
    });
    trial.into_iter()
}
