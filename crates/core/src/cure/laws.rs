//! Other laws for some segments: what may be changed, which programs are tried, and in which order they are offered.

use super::Cure;
use super::choice::{Joining, SegmentOption, cheapest};
use crate::{Analysis, Cam, Finding, FindingKind, LAWS, Law, Program, Replay, Segment, Stretch};

/// Most alternatives offered for one finding.
const MOST_CURES: usize = 3;

/// The lift may change by this part of itself, which is rounding.
const LIFT_TOLERANCE: f64 = 1e-9;

/// Where a polynomial already rises above the heights at its borders, as after a stretch of constant velocity, another may rise
/// above them by this part of the lift more or less.
const OVERSHOOT_TOLERANCE: f64 = 0.05;

/// A stretch whose velocity changes by less than this part of it is one of constant velocity.
const STRAIGHT_TOLERANCE: f64 = 1e-9;

/// How far below the base circle rounding may take the follower.
const BELOW_TOLERANCE: f64 = 1e-9;

/// A change of laws: the segments, each with its new law.
type Changes = Vec<(usize, &'static Law)>;

/// A program that was tried as a cure.
struct Trial {
    changes: Changes,
    lowest_jump: Option<u8>,
    peak_acceleration: f64,
}

/// Programs in which other laws replace those of as few segments as possible: dwells, stretches of constant velocity and free laws
/// stay, and polynomials that match their neighbours come first.
pub(super) fn law_cures(cam: &Cam, analysis: &Analysis, kind: FindingKind, replay: &Replay) -> Vec<Cure> {
    let program = &cam.program;
    let kept: Vec<bool> = kept_segments(program);
    let proposals = match kind {
        FindingKind::Jump(order) => smooth_proposals(program, &kept, order),
        _ => raised_proposals(program, &kept),
    };
    let jumps_now = lowest_jump(program);
    let cured = |trial: &Trial, below: bool| match kind {
        FindingKind::Jump(order) => trial.lowest_jump.is_none_or(|jump| jump > order),
        _ => !below && smoothness(trial.lowest_jump) >= smoothness(jumps_now),
    };
    let mut trials: Vec<Trial> = Vec::new();
    for changes in proposals {
        let [fits, jump, below, peak_acceleration] = replay.values(|| {
            changed(program, &changes).map_or([0.0; 4], |program| {
                let jump = lowest_jump(&program).map_or(-1.0, f64::from);
                let below = program.ranges()[0].0 < -BELOW_TOLERANCE;
                [1.0, jump, f64::from(u8::from(below)), program.sizes()[2]]
            })
        });
        let lowest_jump = (jump >= 0.0).then_some(jump as u8);
        let trial = Trial { changes, lowest_jump, peak_acceleration };
        if fits == 1.0 && cured(&trial, below == 1.0) {
            trials.push(trial);
        }
    }
    trials.sort_by_key(rank);
    let mut offered: Vec<Trial> = Vec::new();
    for trial in trials {
        let alike =
            |other: &Trial| other.changes.len() == trial.changes.len() && other.lowest_jump == trial.lowest_jump;
        let is_new = offered.len() < MOST_CURES && !offered.iter().any(alike);
        if is_new && replay.holds(|| harmless(cam, analysis, &trial.changes)) {
            offered.push(trial);
        }
    }
    let cure = |trial: Trial| Cure::Laws { changes: trial.changes, remaining_jump: trial.lowest_jump };
    offered.into_iter().map(cure).collect()
}

/// Lower is better: first what is kept (fewer segments changed, then the smoother program, then polynomials that match their
/// neighbours), then the price, the peak of the acceleration. Peaks are compared in steps of their logarithm, because the same curve
/// by two formulas differs in its last digits; the sort is stable, so that the first law of the list is then named.
fn rank(trial: &Trial) -> (usize, u8, usize, i64) {
    let unmatched = trial.changes.iter().filter(|(_, law)| !law.is_matched()).count();
    let price = (trial.peak_acceleration.ln() * 1e6).round() as i64;
    (trial.changes.len(), u8::MAX - smoothness(trial.lowest_jump), unmatched, price)
}

/// The number of orders that are continuous: the higher, the smoother.
fn smoothness(lowest_jump: Option<u8>) -> u8 {
    lowest_jump.unwrap_or(u8::MAX)
}

fn lowest_jump(program: &Program) -> Option<u8> {
    program.classified_joints().iter().filter_map(|joint| joint.jump).min()
}

/// Judges the cam that a change of laws gives: its heights at the borders and its lift are the same, nothing geometric is wrong in it when nothing was before, and
/// it goes below the base circle only when it did before.
fn harmless(cam: &Cam, before: &Analysis, changes: &Changes) -> bool {
    let Some(program) = changed(&cam.program, changes) else { return false };
    let after = Analysis::of(&cam.with_program(program), 1);
    let lift = before.summary.s.max;
    let highest = cam.program.heights().iter().copied().fold(0.0, f64::max);
    let overshoots = lift > highest * (1.0 + LIFT_TOLERANCE);
    let tolerance = if overshoots { OVERSHOOT_TOLERANCE } else { LIFT_TOLERANCE };
    let geometric = |finding: &Finding| !finding.kind.is_of_the_motion();
    let sound = !before.findings.iter().any(geometric);
    let low = before.findings.iter().any(|finding| finding.kind == FindingKind::BelowBase);
    (after.summary.s.max - lift).abs() <= tolerance * lift.abs()
        && after.findings.iter().all(|finding| match finding.kind {
            FindingKind::Jump(_) | FindingKind::Doubtful | FindingKind::NotProved(_) => true,
            FindingKind::BelowBase => low,
            _ => !sound,
        })
}

/// The program with other laws in some segments; `None` when they do not join.
fn changed(program: &Program, changes: &Changes) -> Option<Program> {
    let mut segments = program.given().to_vec();
    for &(k, law) in changes {
        segments[k] = Segment::new(law, segments[k].beta, segments[k].rise);
    }
    Program::on(program.cycle(), &segments).ok()
}

/// The segments that are data of the problem: dwells, free laws, and those with a stretch at rest or of constant velocity.
fn kept_segments(program: &Program) -> Vec<bool> {
    let given = program.given();
    let mut kept: Vec<bool> = given.iter().map(|segment| segment.law.free().is_some()).collect();
    for stretch in program.stretches().iter().filter(|stretch| stretch.segment < given.len()) {
        kept[stretch.segment] |= stretch.is_still() || is_straight(stretch);
    }
    kept
}

fn is_straight(stretch: &Stretch) -> bool {
    let length = stretch.to - stretch.from;
    (0..=4).all(|i| {
        let motion = stretch.at(stretch.from + length * f64::from(i) / 4.0);
        motion.a.abs() * length <= STRAIGHT_TOLERANCE * motion.v.abs()
            && motion.j.abs() * length * length <= STRAIGHT_TOLERANCE * motion.v.abs()
    })
}

/// The laws of a fixed curve that may replace another.
fn standard_laws() -> impl Iterator<Item = &'static Law> {
    LAWS.iter().copied().filter(|law| !law.is_dwell() && !law.is_matched() && law.free().is_none())
}

/// The changes with which no order up to the given one should jump: for each pair of a polynomial that matches its neighbours and a
/// law of a fixed curve, the cheapest choice for each segment. A joint that jumps between two kept segments leaves none.
fn smooth_proposals(program: &Program, kept: &[bool], order: u8) -> Vec<Changes> {
    let mut proposals: Vec<Changes> = Vec::new();
    let matched = || LAWS.iter().copied().filter(|law| law.is_matched());
    let joining = Joining::of(program, kept);
    for target in order..4 {
        if joining.is_refuted(target) {
            break;
        }
        for polynomial in matched() {
            for law in standard_laws() {
                let joined = joining.with(program, law, polynomial);
                let Some(choices) = cheapest(&joined, target) else { continue };
                let change = |(k, choice): (usize, SegmentOption)| match choice {
                    SegmentOption::Keep => None,
                    SegmentOption::Match => Some((k, polynomial)),
                    SegmentOption::Replace => Some((k, law)),
                };
                let changes: Changes = choices.into_iter().enumerate().filter_map(change).collect();
                if !changes.is_empty() && !proposals.contains(&changes) {
                    proposals.push(changes);
                }
            }
        }
    }
    proposals
}

/// The changes in which a law of a fixed curve moves every segment that goes below the base circle, or a polynomial does. A kept
/// segment that goes below leaves none.
fn raised_proposals(program: &Program, kept: &[bool]) -> Vec<Changes> {
    let mut low = vec![false; kept.len()];
    for stretch in program.stretches().iter().filter(|stretch| stretch.segment < kept.len()) {
        low[stretch.segment] |= stretch.ranges()[0].0 < -BELOW_TOLERANCE;
    }
    if low.iter().zip(kept).any(|(&low, &kept)| low && kept) {
        return Vec::new();
    }
    let laws = LAWS.iter().copied().filter(|law| law.is_matched()).chain(standard_laws());
    let all = |law| low.iter().enumerate().filter(|(_, low)| **low).map(|(k, _)| (k, law)).collect::<Changes>();
    laws.map(all).filter(|changes| !changes.is_empty()).collect()
}
