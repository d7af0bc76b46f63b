//! The demands in their places around the turn, or which of them cannot be met there.

use super::{Demand, JoinError, JoinProblem};
use crate::program::MIN_BETA;
use crate::{MAX_SEGMENTS, Svaj};
use std::f64::consts::TAU;

/// What the follower does where a gap begins or ends.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Side {
    Rest,
    Line,
    Instant,
}

/// A demand in its place.
#[derive(Clone, Copy)]
pub(super) struct Anchor {
    pub demand: usize,
    pub from: f64,
    pub to: f64,
    pub start: Svaj,
    pub end: Svaj,
    pub side: Side,
    /// False for a point, even where the follower rests for an instant.
    pub lasts: bool,
}

/// A height or a velocity that differs by less than this part of the greatest height (a radian) does not differ.
pub(super) const SAME: f64 = 1e-9;

/// A velocity that is not asked for: it is told apart by being larger than any that could be.
pub(super) const FREE: f64 = f64::MAX;

/// The demands in order: those with a length or at θ = 0, and the points between them.
pub(super) fn sorted(demands: &[Demand]) -> Result<(Vec<Anchor>, Vec<Anchor>), JoinError> {
    let refuse = |demand, problem| Err(JoinError { demand, problem });
    if demands.is_empty() {
        return refuse(0, JoinProblem::Nothing);
    }
    if demands.len() > MAX_SEGMENTS / 2 {
        return refuse(MAX_SEGMENTS / 2, JoinProblem::TooMany);
    }
    let mut all: Vec<Anchor> = demands.iter().enumerate().map(|(k, demand)| placed(k, demand)).collect();
    let scale = all.iter().map(|anchor| anchor.start.s.max(anchor.end.s)).fold(0.0, f64::max);
    for anchor in &all {
        let Anchor { demand, from, to, start, end, side, .. } = *anchor;
        let finite = [from, to, start.s, end.s, start.v].iter().all(|value| value.is_finite());
        let wide = side == Side::Instant || to - from >= MIN_BETA;
        if !finite || !wide || from < 0.0 || to > TAU + MIN_BETA {
            return refuse(demand, JoinProblem::Place);
        }
        let grounded = |motion: Svaj| motion.s <= SAME * scale && motion.v.abs() > SAME * scale;
        if start.s < 0.0 || end.s < 0.0 || grounded(start) || grounded(end) {
            return refuse(demand, JoinProblem::Low);
        }
    }
    all.sort_by(|one, other| one.from.total_cmp(&other.from));
    if all[0].from > MIN_BETA {
        all.insert(
            0,
            Anchor { demand: all[0].demand, ..placed(0, &Demand::Pass { at: 0.0, height: 0.0, velocity: None }) },
        );
    }
    all[0].from = 0.0;
    if all[0].start.s > SAME * scale {
        return refuse(all[0].demand, JoinProblem::StartsHigh);
    }
    for pair in all.windows(2) {
        let [before, after] = [pair[0], pair[1]];
        let twice = before.side == Side::Instant && after.side == Side::Instant && after.from - before.to < MIN_BETA;
        if after.from < before.to - MIN_BETA || twice {
            return refuse(after.demand, JoinProblem::Overlap { other: before.demand });
        }
        meets(before, after, after.from - before.to, scale)?;
    }
    let (first, last) = (all[0], all[all.len() - 1]);
    if all.len() > 1 || first.side != Side::Instant {
        meets(last, Anchor { from: TAU, ..first }, TAU - last.to, scale)?;
    }
    if scale == 0.0 {
        return refuse(0, JoinProblem::Nothing);
    }
    Ok(all.into_iter().partition(|anchor| anchor.side != Side::Instant || anchor.from == 0.0))
}

/// Refuses demands that touch and do not agree.
fn meets(before: Anchor, after: Anchor, gap: f64, scale: f64) -> Result<(), JoinError> {
    let [one, other] = [before.end, after.start];
    let free = one.v == FREE || other.v == FREE;
    let agree = (one.s - other.s).abs() <= SAME * scale && (free || (one.v - other.v).abs() <= SAME * scale);
    if gap < MIN_BETA && !agree {
        return Err(JoinError { demand: after.demand, problem: JoinProblem::Clash { other: before.demand } });
    }
    Ok(())
}

fn placed(demand: usize, what: &Demand) -> Anchor {
    let at = |s: f64, v: f64| Svaj::new(s, v, 0.0, 0.0);
    match *what {
        Demand::Dwell { from, to, height } => {
            Anchor { demand, from, to, start: at(height, 0.0), end: at(height, 0.0), side: Side::Rest, lasts: true }
        }
        Demand::Straight { from, to, start, end } => {
            let slope = (end - start) / (to - from);
            let side = if start == end { Side::Rest } else { Side::Line };
            Anchor { demand, from, to, start: at(start, slope), end: at(end, slope), side, lasts: true }
        }
        // Where no velocity is asked for it is free; on the base circle there is only one.
        Demand::Pass { at: place, height, velocity } => {
            let v = velocity.unwrap_or(if height == 0.0 { 0.0 } else { FREE });
            let v = if v.is_nan() { FREE } else { v };
            Anchor {
                demand,
                from: place,
                to: place,
                start: at(height, v),
                end: at(height, v),
                side: Side::Instant,
                lasts: false,
            }
        }
    }
}
