//! What would put a finding right: computed for the cam at hand, and tried before it is offered.

use crate::samples::LEAST_STEPS;
use crate::{
    Analysis, Cam, Closure, Finding, FindingKind, LAWS, Law, Level, Program, Segment, balanced_eccentricity,
    shortest_travel, smallest_base_radius,
};

/// A change that removes a finding.
#[derive(Clone, Debug, PartialEq)]
pub enum Cure {
    /// The smallest base radius with which the geometry passes.
    BaseRadius(f64),
    /// The shortest travel with which the geometry passes, all β's in proportion.
    Travel(f64),
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

/// The cures of each finding of an analysis, in the order of the findings, the best cure first.
///
/// Each has been tried: the finding is gone in the cam it gives, and nothing geometric is wrong there that was not before; or,
/// for an eccentricity that does not suffice, the pressure angle is lower.
#[must_use]
pub fn prescribe(cam: &Cam, analysis: &Analysis) -> Vec<Vec<Cure>> {
    let geometric = |finding: &Finding| !finding.kind.is_of_the_motion();
    let sound = !analysis.findings.iter().any(geometric);
    let size = if sound {
        None
    } else {
        smallest_base_radius(cam).map(Cure::BaseRadius).or_else(|| shortest_travel(cam).map(Cure::Travel))
    };
    let low = analysis.findings.iter().any(|finding| finding.kind == FindingKind::BelowBase);
    let of = |finding: &Finding| match finding.kind {
        // What is tolerated needs no cure; a second cam moves as the first makes it.
        FindingKind::Jump(_) | FindingKind::BelowBase
            if finding.level == Level::Acceptable || cam.follower.reversed.is_some() =>
        {
            Vec::new()
        }
        FindingKind::Jump(order) => {
            law_cures(cam, spared(sound, low), |trial| trial.lowest_jump.is_none_or(|jump| jump > order))
        }
        FindingKind::Doubtful => Vec::new(),
        FindingKind::BelowBase => law_cures(cam, spared(sound, false), |trial| !trial.below_base),
        FindingKind::PressureAngle => size.clone().into_iter().chain(eccentricity(cam, finding)).collect(),
        FindingKind::Cusp
        | FindingKind::Undercut
        | FindingKind::GrooveUndercut
        | FindingKind::ConcaveFlat
        | FindingKind::SelfCrossing
        | FindingKind::ArmCutsCam
        | FindingKind::PivotInsideCam
        | FindingKind::FaceOvertaken
        | FindingKind::ContactPastPivot => size.clone().into_iter().collect(),
    };
    analysis.findings.iter().map(of).collect()
}

/// The balancing eccentricity, when it is worth having: the follower's axis moves, but the cam does not grow.
fn eccentricity(cam: &Cam, finding: &Finding) -> Option<Cure> {
    if cam.closure == Closure::Yoke || cam.follower.reversed.is_some() {
        return None;
    }
    let value = balanced_eccentricity(cam)?;
    let index = cam.follower.kind.index_of("eccentricity")?;
    let moved = cam.with_follower(cam.follower.with_value(index, value).ok()?);
    let analysis = Analysis::of(&moved, 720);
    let pressure_angle = analysis.summary.pressure_angle.greatest_size().0;
    let motion_or_angle = |f: &Finding| f.kind.is_of_the_motion() || f.kind == FindingKind::PressureAngle;
    let worthwhile = analysis.findings.iter().all(motion_or_angle) && pressure_angle < finding.value - WORTHWHILE;
    worthwhile.then_some(Cure::Eccentricity { value, pressure_angle })
}

/// Judges a cam that a cure gives: nothing geometric may be wrong in it when it was `sound` before, and it may go below the
/// base circle only when it did (`low`) before.
fn spared(sound: bool, low: bool) -> impl Fn(&Cam) -> bool {
    move |cam| {
        Analysis::of(cam, LEAST_STEPS).findings.iter().all(|finding| match finding.kind {
            FindingKind::Jump(_) | FindingKind::Doubtful => true,
            FindingKind::BelowBase => low,
            _ => !sound,
        })
    }
}

/// A program tried as a cure.
struct Trial {
    changes: Vec<(usize, &'static Law)>,
    program: Program,
    lowest_jump: Option<u8>,
    below_base: bool,
    peak_acceleration: f64,
}

/// Programs in which one law replaces every segment that a joint blames, or just one of them: the smoothest that there is, and
/// gentler ones that are less smooth; a choice, not a catalogue.
fn law_cures(cam: &Cam, harmless: impl Fn(&Cam) -> bool, cured: impl Fn(&Trial) -> bool) -> Vec<Cure> {
    let blamed = blamed_segments(&cam.program);
    let mut trials: Vec<Trial> = Vec::new();
    for law in LAWS.iter().copied().filter(|law| !law.is_dwell() && law.free().is_none()) {
        trials.extend(attempt(&cam.program, blamed.iter().map(|&k| (k, law)).collect()));
        if blamed.len() > 1 {
            trials.extend(blamed.iter().filter_map(|&k| attempt(&cam.program, vec![(k, law)])));
        }
    }
    trials.retain(&cured);
    let mut kept: Vec<Trial> = Vec::new();
    while kept.len() < MOST_CURES {
        // The first of the best, so that among laws which come to the same curve the first of the list is named.
        let Some(best) = (0..trials.len()).min_by_key(|&k| (rank(&trials[k]), k)) else { break };
        let trial = trials.remove(best);
        let alike =
            |other: &Trial| other.changes.len() == trial.changes.len() && other.lowest_jump == trial.lowest_jump;
        let fits = || harmless(&cam.with_program(trial.program.clone()));
        if !kept.iter().any(alike) && fits() {
            kept.push(trial);
        }
    }
    kept.into_iter().map(|trial| Cure::Laws { changes: trial.changes, remaining_jump: trial.lowest_jump }).collect()
}

/// Lower is better: the smoother, then the gentler. Peaks are compared in steps of their logarithm, because the same curve by two
/// formulas differs in its last digits.
fn rank(trial: &Trial) -> (u8, i64) {
    (u8::MAX - trial.lowest_jump.unwrap_or(u8::MAX), (trial.peak_acceleration.ln() * 1e6).round() as i64)
}

/// Moving segments that touch a jump, contain one, or go below the base circle.
fn blamed_segments(program: &Program) -> Vec<usize> {
    let n = program.given().len();
    let mut blamed = vec![false; n];
    for joint in program.classified_joints().iter().filter(|joint| joint.jump.is_some()) {
        blamed[joint.segment % n] = true;
        if (program.is_cyclic() || joint.segment > 0)
            && program.borders()[..program.segments().len()].contains(&joint.theta)
        {
            blamed[(joint.segment + n - 1) % n] = true;
        }
    }
    for stretch in program.stretches() {
        blamed[stretch.segment % n] |= goes_below(std::iter::once(stretch.at(0.5 * (stretch.from + stretch.to))));
    }
    (0..n).filter(|&k| blamed[k] && !program.given()[k].law.is_dwell()).collect()
}

fn attempt(program: &Program, changes: Vec<(usize, &'static Law)>) -> Option<Trial> {
    let mut changed = program.given().to_vec();
    if changes.iter().all(|&(k, law)| changed[k].law == law) {
        return None;
    }
    for &(k, law) in &changes {
        let risen = program.heights()[k + 1] - program.heights()[k];
        let rise = if changed[k].law.free().is_some() { risen } else { changed[k].rise };
        changed[k] = Segment::new(law, changed[k].beta, rise);
    }
    let program = Program::on(program.cycle(), &changed).ok()?;
    Some(Trial {
        lowest_jump: program.classified_joints().iter().filter_map(|joint| joint.jump).min(),
        below_base: goes_below(program.look()),
        peak_acceleration: program.look().map(|motion| motion.a.abs()).fold(0.0, f64::max),
        changes,
        program,
    })
}

fn goes_below(mut motions: impl Iterator<Item = crate::Svaj>) -> bool {
    motions.any(|motion| motion.s < -1e-9)
}
