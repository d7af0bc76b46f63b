//! Which ties give a second cam that keeps every geometric limit, and which comes nearest where none does.

use super::across::Across;
use super::{Tie, conjugate};
use crate::samples::LEAST_STEPS;
use crate::search::{boundary, golden_maximum};
use crate::sizing::{geometry_passes, shortfall_of};
use crate::{Cam, Replay};
use std::ops::Range;

/// Samples of the first, coarse look at a candidate.
const COARSE_STEPS: usize = 120;

/// Ties tried over the range that the geometry allows.
const CANDIDATES: usize = 96;

/// The gap between a tie that fails and one that passes is halved down to this part of itself.
const EDGE_TOLERANCE: f64 = 1e-12;

/// Steps of a golden section between three candidates: they shorten the interval by 5·10⁻⁹.
const GOLDEN_STEPS: usize = 40;

/// How many times the size of the first cam the distance of a second is looked for.
const FARTHEST: f64 = 1000.0;

/// How many times that size the nearest distance to a pair is looked for, where none passes.
const NEAR: f64 = 10.0;

/// Ratio of the room beside one distance tried to that beside the one before it.
const STRIDE: f64 = 1.25;

/// Parts by which the ends of a range are set inside, so that rounding does not put them outside.
const INSIDE: f64 = 1e-9;

/// The ties of that kind with which the second cam keeps every geometric limit, least and greatest, lengths or radians; the greatest
/// distance is infinite. None when no tie does. `radius` is that of the second disc, that of the first when none is given.
///
/// Ties are tried evenly over the room that there is, and the ends of those that pass are then halved down to.
/// When the ties that pass are not all side by side, the longest run of them is given.
#[must_use]
pub fn working_ties(cam: &Cam, kind: Tie, radius: Option<f64>) -> Option<(f64, f64)> {
    Replay::whole(|replay| working_ties_in_parts(cam, kind, radius, replay))
}

/// The same as [`working_ties`], as a search that runs in parts.
#[must_use]
pub fn working_ties_in_parts(cam: &Cam, kind: Tie, radius: Option<f64>, replay: &Replay) -> Option<(f64, f64)> {
    let (low, high) = Across::of(cam, radius).bounds(kind)?;
    let search = Search { cam, kind, radius, replay };
    if high.is_infinite() { search.least_distance(low).map(|least| (least, high)) } else { search.range(low, high) }
}

/// The tie of that kind with which the second cam passes its geometric limits by least: the nearest there is to a pair where none
/// is possible. None when the kind of tie leaves no room at all. `radius` as for [`working_ties`].
#[must_use]
pub fn nearest_tie(cam: &Cam, kind: Tie, radius: Option<f64>) -> Option<Tie> {
    let (low, high) = Across::of(cam, radius).bounds(kind)?;
    let high = if high.is_finite() { high } else { low + NEAR * cam.size() };
    let best = |replay: &Replay| Search { cam, kind, radius, replay }.least_excess(&evenly(low, high));
    let (best, excess) = Replay::whole(best)?;
    excess.is_finite().then(|| kind.with(best))
}

/// Ties of one kind, tried on a cam.
struct Search<'a> {
    cam: &'a Cam,
    kind: Tie,
    radius: Option<f64>,
    replay: &'a Replay,
}

impl Search<'_> {
    fn second(&self, value: f64) -> Option<Cam> {
        conjugate(self.cam, self.kind.with(value), self.radius).ok()
    }

    fn passes(&self, value: f64) -> bool {
        self.replay.holds(|| self.second(value).is_some_and(|second| geometry_passes(&second)))
    }

    /// How far the second cam is beyond its limits, looked at in so many steps.
    fn excess(&self, value: f64, steps: usize) -> f64 {
        self.replay.value(|| self.second(value).map_or(f64::INFINITY, |second| shortfall_of(&second, steps)))
    }

    /// The last value that passes on the way from one that does to one that does not.
    fn edge(&self, inside: f64, outside: f64) -> f64 {
        let close = EDGE_TOLERANCE * (outside - inside).abs();
        boundary((inside, outside), |inside, outside| (outside - inside).abs() <= close, |value| self.passes(value))
    }

    /// The least distance that passes: any larger one does too.
    fn least_distance(&self, low: f64) -> Option<f64> {
        let size = self.cam.size();
        let strides = std::iter::successors(Some(size / CANDIDATES as f64), |room| Some(room * STRIDE));
        let mut before = low;
        for distance in strides.take_while(|&room| room < FARTHEST * size).map(|room| low + room) {
            if self.passes(distance) {
                let least = self.edge(distance, before);
                return Some(least + INSIDE * least.abs());
            }
            before = distance;
        }
        None
    }

    /// The longest run of passing values between two bounds.
    fn range(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        let mut tried = evenly(low, high);
        if !tried.iter().any(|&value| self.passes(value)) {
            // A window narrower than a step is found where the limits are passed by least.
            let (best, _) = self.least_excess(&tried)?;
            tried.insert(tried.partition_point(|&value| value < best), best);
        }
        let run = longest_run(tried.len(), |i| self.passes(tried[i]));
        let (first, last) = (run.start, run.end.checked_sub(1)?);
        let least = if first == 0 { tried[0] } else { self.edge(tried[first], tried[first - 1]) };
        let greatest = if last + 1 == tried.len() { tried[last] } else { self.edge(tried[last], tried[last + 1]) };
        let inside = INSIDE * (greatest - least).max(INSIDE);
        Some((least + inside, greatest - inside))
    }

    /// The value with the least excess, refined between its neighbours, and the excess of the best that was tried.
    fn least_excess(&self, tried: &[f64]) -> Option<(f64, f64)> {
        let excess: Vec<f64> = tried.iter().map(|&value| self.excess(value, COARSE_STEPS)).collect();
        let least = (1..tried.len() - 1).min_by(|&a, &b| excess[a].total_cmp(&excess[b]))?;
        let best =
            golden_maximum(tried[least - 1], tried[least + 1], GOLDEN_STEPS, |value| -self.excess(value, LEAST_STEPS))
                .0;
        Some((best, excess[least]))
    }
}

fn evenly(low: f64, high: f64) -> Vec<f64> {
    (0..=CANDIDATES).map(|i| low + (high - low) * i as f64 / CANDIDATES as f64).collect()
}

/// The longest run of indices below `count` that are good, the first of them where several are as long.
fn longest_run(count: usize, good: impl Fn(usize) -> bool) -> Range<usize> {
    let (mut longest, mut start) = (0..0, 0);
    for i in 0..count {
        if !good(i) {
            start = i + 1;
        } else if i + 1 - start > longest.len() {
            longest = start..i + 1;
        }
    }
    longest
}
