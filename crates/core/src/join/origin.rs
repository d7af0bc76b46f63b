//! What the follower does at θ = 0, when it only touches the base circle there.

use super::demand::{Anchor, Side};
use super::leg::{condition, free, known, motion};
use crate::program::MIN_BETA;
use crate::{Law, Svaj};
use std::f64::consts::TAU;

/// Digits of an acceleration or a jerk that is chosen here, so that both sides write the same.
const CHOSEN_DIGITS: i32 = 4;

/// *a* and *j* at θ = 0, when the follower only touches the base circle there: those of the polynomial through what is on both sides.
pub(super) fn instant(anchors: &[Anchor], passes: &[Anchor]) -> Svaj {
    let first = anchors[0];
    if first.side != Side::Instant {
        return Svaj::default();
    }
    let all = || anchors[1..].iter().chain(passes);
    let (Some(next), Some(last)) = (
        all().min_by(|one, other| one.from.total_cmp(&other.from)),
        all().max_by(|one, other| one.to.total_cmp(&other.to)),
    ) else {
        return Svaj::default();
    };
    let back = TAU - last.to;
    // What ends on the base circle at the end of the turn rests there.
    if back < MIN_BETA {
        return Svaj::default();
    }
    let span = back + next.from;
    let ends = [(0.0, last.end, last.side), (span, next.start, next.side)];
    let mut conditions = vec![condition(back, 0, 0.0), condition(back, 1, 0.0)];
    for (at, motion, side) in ends {
        conditions.extend(known(at, motion, if side == Side::Instant { 2 } else { 3 }));
    }
    let Some(law) = Law::by_id("polynomial") else { return Svaj::default() };
    let Some(leg) = free(law, span, conditions) else { return Svaj::default() };
    let there = motion(&leg, back / span);
    // On the base circle the follower cannot but turn upwards.
    if there.a <= 0.0 { Svaj::default() } else { Svaj::new(0.0, 0.0, chosen(there.a), chosen(there.j)) }
}

pub(super) fn chosen(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let unit = 10_f64.powi(value.abs().log10().floor() as i32 + 1 - CHOSEN_DIGITS);
    (value / unit).round() * unit
}
