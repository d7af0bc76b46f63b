//! From what a machine must do to a whole program: dwells, straight stretches and points are joined by the smoothest law that may stand there.
//!
//! The rule: every law that keeps *v* and *a* continuous (and *j*, for high speeds) and stays on or above the base circle is tried in each gap, and
//! the one with the lowest peak of the derivative asked for is taken. What was tried is told along with the choice.

mod demand;
mod figures;
mod gap;
mod leg;
mod origin;
#[cfg(test)]
mod tests;

use crate::program::MIN_BETA;
use crate::{LAWS, Law, Program, Segment, Svaj};
use demand::{Anchor, Side, sorted};
use gap::fill;
use origin::instant;
use std::f64::consts::TAU;

/// Something that the machine must do. Angles in radians, heights above the base circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Demand {
    /// Stay at a height.
    Dwell {
        /// From this θ.
        from: f64,
        /// To this one.
        to: f64,
        /// The height.
        height: f64,
    },
    /// Go from a height to another at constant velocity.
    Straight {
        /// From this θ.
        from: f64,
        /// To this one.
        to: f64,
        /// The height at `from`.
        start: f64,
        /// The height at `to`.
        end: f64,
    },
    /// Pass through a point.
    Pass {
        /// Its θ.
        at: f64,
        /// Its height.
        height: f64,
        /// The velocity there, when it matters.
        velocity: Option<f64>,
    },
}

/// How smooth the joining has to be, and what is to be small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Taste {
    /// True when *j* must be continuous too, as high speeds need.
    pub high_speed: bool,
    /// The order of the derivative whose peak is to be low: 1 *v*, 2 *a*, 3 *j*.
    pub least: usize,
}

/// A joined program, and why it is as it is.
#[derive(Clone, Debug)]
pub struct Joining {
    /// The segments of the whole turn.
    pub segments: Vec<Segment>,
    /// What was chosen in each gap, in order.
    pub choices: Vec<Choice>,
}

/// What was chosen in a gap.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Where the gap begins, radians.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The first of its segments.
    pub segment: usize,
    /// Why.
    pub reason: Reason,
    /// Everything that was tried, the chosen one first and then by its peak; none where there was nothing to choose.
    pub tried: Vec<Tried>,
}

/// Why a way of joining was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The follower is already at its height.
    Stays,
    /// Both sides lie on one straight line.
    InLine,
    /// Nothing else is smooth enough there.
    Only,
    /// It has the lowest peak.
    Least,
}

/// A way of joining.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// How.
    pub way: Way,
    /// Its peaks of |v|, |a| and |j|.
    pub peaks: [f64; 3],
    /// False when it would go below the base circle.
    pub above: bool,
}

/// How a gap is joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// By one segment of a law.
    Law(&'static Law),
    /// At rest for a while, beside a segment of a law.
    Waiting(&'static Law),
    /// By a polynomial from point to point, with the velocity at each taken from the points beside it.
    Pieces,
    /// By a polynomial from point to point, at rest for an instant at each.
    Stops,
}

/// What makes a joining impossible, and the demand to blame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoinError {
    /// Its index in the list as it was given.
    pub demand: usize,
    /// What is wrong.
    pub problem: JoinProblem,
}

/// What can be wrong with a list of demands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JoinProblem {
    /// There is none, or nothing moves.
    Nothing,
    /// There are more than a program has room for.
    TooMany,
    /// It does not lie within the turn, ends before it begins, or has a number that is not finite.
    Place,
    /// It begins before another one ends.
    Overlap {
        /// The other one.
        other: usize,
    },
    /// It begins where another one ends, and *s* or *v* would jump.
    Clash {
        /// The other one.
        other: usize,
    },
    /// It is below the base circle, or goes on below it.
    Low,
    /// At θ = 0 the follower is on the base circle, and this one begins there at another height.
    StartsHigh,
    /// After it no law comes by without going below the base circle.
    NoWay,
}

/// Joins demands, in any order, into a program of a whole turn that begins on the base circle.
///
/// In each gap every law is tried that keeps *v* and *a* continuous (and *j*, for high speeds) and stays on or above the base circle; the one
/// with the lowest peak of the derivative that the taste names is taken, and [`Choice`] tells what was tried.
///
/// # Errors
/// Says which demand cannot be met, and why.
pub fn join(demands: &[Demand], taste: Taste) -> Result<Joining, JoinError> {
    let (anchors, passes) = sorted(demands)?;
    let estimated = instant(&anchors, &passes);
    // A bend at θ = 0 that leaves no way for a gap is straightened.
    joined(&anchors, &passes, estimated, taste).or_else(|_| joined(&anchors, &passes, Svaj::default(), taste))
}

fn joined(anchors: &[Anchor], passes: &[Anchor], bend: Svaj, taste: Taste) -> Result<Joining, JoinError> {
    let mut anchors = anchors.to_vec();
    if anchors[0].side == Side::Instant {
        let jerk = if taste.high_speed { bend.j } else { 0.0 };
        let state = Svaj::new(0.0, 0.0, bend.a, jerk);
        (anchors[0].start, anchors[0].end) = (state, state);
        // Without a bend it is a rest, if only for an instant.
        if state == Svaj::default() {
            anchors[0].side = Side::Rest;
        }
    }
    let mut joining = Joining { segments: Vec::new(), choices: Vec::new() };
    for (k, &before) in anchors.iter().enumerate() {
        let round = k + 1 == anchors.len();
        let after = if round { Anchor { from: TAU, ..anchors[0] } } else { anchors[k + 1] };
        if before.side != Side::Instant && before.to > before.from {
            let law = if before.side == Side::Rest { "dwell" } else { "constant-velocity" };
            let law = Law::by_id(law).unwrap_or(LAWS[0]);
            let beta = before.to.min(TAU) - before.from;
            joining.segments.push(Segment::new(law, beta, before.end.s - before.start.s));
        }
        if after.from - before.to < MIN_BETA {
            continue;
        }
        let between: Vec<Anchor> =
            passes.iter().filter(|pass| pass.from > before.to && pass.from < after.from).copied().collect();
        let (reason, tried, legs) = fill(before, &between, after, taste)
            .ok_or(JoinError { demand: before.demand, problem: JoinProblem::NoWay })?;
        let segment = joining.segments.len();
        joining.choices.push(Choice { from: before.to, to: after.from, segment, reason, tried });
        joining.segments.extend(legs.into_iter().map(|leg| leg.segment));
    }
    let checked = Program::new(&joining.segments);
    let orders = if taste.high_speed { 4 } else { 3 };
    let smooth = |program: &Program| {
        program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| usize::from(order) >= orders))
    };
    match checked {
        Ok(program) if smooth(&program) => Ok(joining),
        _ => Err(JoinError { demand: anchors[0].demand, problem: JoinProblem::NoWay }),
    }
}
