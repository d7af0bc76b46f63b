//! Extremes and crossings of a piecewise smooth quantity, refined between samples.

use crate::Cam;
use crate::samples::{Quantity, Samples};
use crate::search::{crest, root, summit, vertex};
use std::f64::consts::TAU;

/// Where a quantity is least and greatest over the cycle; θ in radians, or length for a cam that travels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Least value.
    pub min: f64,
    /// Where it is.
    pub min_at: f64,
    /// Greatest value.
    pub max: f64,
    /// Where it is.
    pub max_at: f64,
}

impl Extremes {
    /// The maximum absolute value and its place; the first place if minimum and maximum have the same size.
    #[must_use]
    pub fn greatest_size(&self) -> (f64, f64) {
        let (high, low) = (self.max.abs(), self.min.abs());
        let first = if (high - low).abs() <= EQUAL * high.max(low) { self.max_at <= self.min_at } else { high > low };
        (high.max(low), if first { self.max_at } else { self.min_at })
    }
}

/// θ is refined to this (radians, or the same part of a travel): the value of an extreme is then exact to its square.
const THETA_TOLERANCE: f64 = 1e-8;

/// Samples lower than the best by more than this part of the range cannot hide the true extreme between them.
const SLACK: f64 = 1e-2;

/// Estimates (by a parabola through three samples) that differ by less than this part of the range are all refined.
const TIE: f64 = 1e-4;

/// Most bumps refined for one extreme, the most promising first: a program of many equal segments has many equal bumps.
const MOST_BUMPS: usize = 4;

/// The same two where a formula has places of its own: its bumps are many and their estimates rough.
const TIE_OF_FORMULAS: f64 = 1e-2;
const MOST_BUMPS_OF_FORMULAS: usize = 24;

/// A quantity that varies by less than this part of its size is constant, but for rounding.
const ROUNDING: f64 = 1e-12;

/// Extremes and jumps that differ by less than this part of their size (or of the range) are equal: the first one by θ is named, so that its
/// place does not depend on the number of samples.
pub(crate) const EQUAL: f64 = 1e-9;

/// Extremes of a quantity over the turn.
pub(crate) fn extremes(cam: &Cam, samples: &Samples, quantity: Quantity) -> Extremes {
    let values = samples.of_all(quantity);
    let of_each: Vec<(f64, f64)> = samples.spans.iter().map(|span| bounds(&values[span.clone()])).collect();
    let (low, high) = of_each.iter().fold(NOTHING, |all, each| (all.0.min(each.0), all.1.max(each.1)));
    // An angle of rounding alone has no size of its own to compare with; a radian has.
    let floor = if quantity == Quantity::PressureAngle { 1.0 } else { 0.0 };
    if high - low <= ROUNDING * high.abs().max(low.abs()).max(floor) {
        return Extremes { min: low, min_at: 0.0, max: high, max_at: 0.0 };
    }
    let upside_down: Vec<(f64, f64)> = of_each.iter().map(|&(low, high)| (-high, -low)).collect();
    let search = Search { cam, samples, quantity };
    let (max, max_at) = search.greatest(1.0, (low, high), &of_each);
    let (min, min_at) = search.greatest(-1.0, (-high, -low), &upside_down);
    Extremes { min: -min, min_at, max, max_at }
}

/// Bounds of no values at all.
const NOTHING: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// Least and greatest of some values, eight at a time so that the processor can compare them together.
fn bounds(values: &[f64]) -> (f64, f64) {
    let (mut low, mut high) = NOTHING;
    let (mut lows, mut highs) = ([low; 8], [high; 8]);
    let chunks = values.chunks_exact(8);
    for value in chunks.remainder() {
        (low, high) = (low.min(*value), high.max(*value));
    }
    for chunk in chunks {
        for k in 0..8 {
            lows[k] = if chunk[k] < lows[k] { chunk[k] } else { lows[k] };
            highs[k] = if chunk[k] > highs[k] { chunk[k] } else { highs[k] };
        }
    }
    for k in 0..8 {
        (low, high) = (low.min(lows[k]), high.max(highs[k]));
    }
    (low, high)
}

/// A place where the greatest value of the cycle may be.
struct Bump {
    stretch: usize,
    /// The sample.
    at: usize,
    /// The height of the summit that it promises.
    promise: f64,
    /// The place of the summit and its height, once it has been refined.
    summit: Option<(f64, f64)>,
}

/// A quantity whose summits are searched.
struct Search<'a> {
    cam: &'a Cam,
    samples: &'a Samples,
    quantity: Quantity,
}

impl Search<'_> {
    /// The maximum of `sign`·quantity and the first place that has it; `low` and `high` bound all its samples, `of_each` those of each stretch.
    fn greatest(&self, sign: f64, (low, high): (f64, f64), of_each: &[(f64, f64)]) -> (f64, f64) {
        let Self { cam, .. } = *self;
        let range = high - low;
        let mut bumps = self.bumps(sign, (low, high), of_each);
        let has_formulas = cam.program.stretches().iter().any(|stretch| stretch.places().next().is_some());
        let (tie, most) = if has_formulas { (TIE_OF_FORMULAS, MOST_BUMPS_OF_FORMULAS) } else { (TIE, MOST_BUMPS) };
        let top = bumps.iter().map(|bump| bump.promise).fold(f64::NEG_INFINITY, f64::max);
        bumps.retain(|bump| bump.promise >= top - tie * range);
        let mut promising: Vec<usize> = (0..bumps.len()).collect();
        promising.sort_by(|&a, &b| bumps[b].promise.total_cmp(&bumps[a].promise));
        let mut best = high;
        for index in promising.into_iter().take(most) {
            best = best.max(self.refined(sign, &mut bumps[index]).1);
        }
        let first =
            bumps.iter_mut().map(|bump| self.refined(sign, bump)).find(|&(_, value)| value >= best - EQUAL * range);
        let (at, value) = first.unwrap_or((0.0, best));
        // The value of that place, where another exceeds it by rounding alone: 0 at the start, not what the end of a fall leaves of it.
        let greatest = if best - value <= ROUNDING * range { value } else { best };
        let past_the_end = cam.program.is_cyclic() && at >= TAU;
        (greatest, if past_the_end { at - TAU } else { at })
    }

    /// The places where the maximum may be, in the order of θ: the summits among the samples, and the beginnings of level stretches.
    fn bumps(&self, sign: f64, (low, high): (f64, f64), of_each: &[(f64, f64)]) -> Vec<Bump> {
        let Self { cam, samples, quantity } = *self;
        let values = samples.of_all(quantity);
        let range = high - low;
        let (worth_a_look, as_good) = (high - SLACK * range, high - EQUAL * range);
        let mut bumps: Vec<Bump> = Vec::new();
        for (stretch, (span, &(lowest, highest))) in samples.spans.iter().zip(of_each).enumerate() {
            if highest < worth_a_look {
                continue;
            }
            if highest - lowest <= ROUNDING * range {
                // Level, as in a dwell: any place is as good as the first.
                if highest >= as_good {
                    let summit = Some((cam.program.stretches()[stretch].from, highest));
                    bumps.push(Bump { stretch, at: span.start, promise: highest, summit });
                }
                continue;
            }
            for at in span.clone() {
                let here = sign * values[at];
                if here < worth_a_look {
                    continue;
                }
                let beside = |inside: bool, at: usize| if inside { sign * values[at] } else { f64::NEG_INFINITY };
                let (before, after) = (beside(at > span.start, at.wrapping_sub(1)), beside(at + 1 < span.end, at + 1));
                if here >= before && here > after || here > before && here >= after {
                    let steps = [at.max(span.start + 1) - 1, at, (at + 1).min(span.end - 1)].map(|k| samples.theta[k]);
                    bumps.push(Bump { stretch, at, promise: vertex(steps, [before, here, after]), summit: None });
                }
            }
        }
        bumps
    }

    /// The place and the height of a summit, refined once.
    fn refined(&self, sign: f64, bump: &mut Bump) -> (f64, f64) {
        let summit = bump.summit.unwrap_or_else(|| self.summit(sign, bump));
        bump.summit = Some(summit);
        summit
    }

    /// The stretch that a sample lies on.
    fn stretch_of(&self, sample: usize) -> usize {
        self.samples.spans.partition_point(|span| span.end <= sample)
    }

    /// Where `sign`·quantity is greatest beside a sample that is higher than its neighbours, and the value there.
    fn summit(&self, sign: f64, bump: &Bump) -> (f64, f64) {
        let Self { cam, samples, quantity } = *self;
        let (span, piece) = (&samples.spans[bump.stretch], &cam.program.stretches()[bump.stretch]);
        let neighbours = [bump.at.max(span.start + 1) - 1, bump.at, (bump.at + 1).min(span.end - 1)];
        let (theta, values) = (&samples.theta, samples.of_all(quantity));
        match quantity.slope() {
            Some(slope) => {
                let slopes = samples.of_all(slope);
                let along = neighbours.map(|at| (theta[at], sign * slopes[at]));
                let at = crest(along, |theta| sign * slope.at(cam, piece, theta));
                let value = at.map_or(values[bump.at], |at| quantity.at(cam, piece, at));
                (at.unwrap_or(theta[bump.at]), sign * value)
            }
            None => {
                let tolerance = THETA_TOLERANCE * (cam.program.span() / TAU);
                let start = (theta[bump.at], sign * values[bump.at]);
                let ends = (theta[neighbours[0]], theta[neighbours[2]]);
                summit(ends, start, tolerance, |theta| sign * quantity.at(cam, piece, theta))
            }
        }
    }
}

/// The greatest value of `sign`·quantity between two θ (the second beyond 2π when they enclose 0), and where: the quantity and its θ.
pub(crate) fn greatest_within(
    cam: &Cam,
    samples: &Samples,
    quantity: Quantity,
    sign: f64,
    (from, to): (f64, f64),
) -> (f64, f64) {
    let search = Search { cam, samples, quantity };
    let mut best = (f64::NEG_INFINITY, from);
    let tolerance = THETA_TOLERANCE * (cam.program.span() / TAU);
    for (stretch, span) in cam.program.stretches().iter().zip(&samples.spans) {
        for turn in [0.0, TAU].into_iter().take(if cam.program.is_cyclic() { 2 } else { 1 }) {
            let (low, high) = (stretch.from.max(from - turn), stretch.to.min(to - turn));
            if low > high {
                continue;
            }
            let value = |theta: f64| sign * quantity.at(cam, stretch, theta);
            let (low_value, high_value) = (value(low), value(high));
            let ends = if low_value >= high_value { (low_value, low) } else { (high_value, high) };
            let inside = span.clone().filter(|&i| low < samples.theta[i] && samples.theta[i] < high);
            let values = samples.of_all(quantity);
            let top = inside.max_by(|&a, &b| (sign * values[a]).total_cmp(&(sign * values[b])));
            let (at, found) = match top {
                Some(i) => {
                    search.summit(sign, &Bump { stretch: search.stretch_of(i), at: i, promise: 0.0, summit: None })
                }
                // So short that no sample lies in it.
                None => summit((low, high), (0.5 * (low + high), value(0.5 * (low + high))), tolerance, value),
            };
            let here = if found > ends.0 && low <= at && at <= high { (found, at) } else { ends };
            if here.0 > best.0 {
                best = here;
            }
        }
    }
    (sign * best.0, best.1)
}

/// The intervals of θ (radians) in which `excess` of a quantity is positive; one that passes 2π ends beyond it.
///
/// `peak` is a place already known to be positive. Intervals so short that no sample falls in them are found by the samples around them.
pub(crate) fn intervals(
    cam: &Cam,
    samples: &Samples,
    quantity: Quantity,
    peak: f64,
    excess: impl Fn(f64) -> f64,
) -> Vec<(f64, f64)> {
    let mut found: Vec<(f64, f64)> = Vec::new();
    let mut open: Option<f64> = None;
    let values = samples.of_all(quantity);
    for (stretch, span) in cam.program.stretches().iter().zip(&samples.spans) {
        let at = |theta: f64| excess(quantity.at(cam, stretch, theta));
        let sampled: Vec<(f64, f64)> =
            span.clone().map(|sample| (samples.theta[sample], excess(values[sample]))).collect();
        let mut along = with_summits_across(&sampled, THETA_TOLERANCE * (cam.program.span() / TAU), at);
        if stretch.from < peak && peak < stretch.to {
            let after = along.partition_point(|point| point.0 < peak);
            along.insert(after, (peak, at(peak)));
        }
        if along[0].1 > 0.0 {
            open = open.or(Some(stretch.from));
        } else if let Some(from) = open.take() {
            found.push((from, stretch.from));
        }
        for pair in along.windows(2) {
            let [(low, before), (high, after)] = [pair[0], pair[1]];
            if before <= 0.0 && after > 0.0 {
                open = Some(root(low, high, at));
            } else if before > 0.0 && after <= 0.0 {
                found.push((open.take().unwrap_or(low), root(low, high, at)));
            }
        }
    }
    if let Some(from) = open {
        match found.first_mut() {
            Some(first) if first.0 <= 0.0 && cam.program.is_cyclic() => *first = (from, first.1 + TAU),
            _ => found.push((from, cam.program.span())),
        }
    }
    found
}

/// Samples of a function with the summits and the bottoms between them that are on the other side of zero: intervals so short that no
/// sample falls in them.
fn with_summits_across(sampled: &[(f64, f64)], tolerance: f64, f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let mut along = sampled.to_vec();
    for near in sampled.windows(3) {
        let [before, here, after] = [near[0], near[1], near[2]];
        let sign = if here.1 > 0.0 { -1.0 } else { 1.0 };
        let [low, middle, high] = [before.1, here.1, after.1].map(|value| sign * value);
        if low > middle || high > middle {
            continue;
        }
        // The parabola through three samples may rise half as high as the function.
        let rise = vertex([before.0, here.0, after.0], [low, middle, high]) - middle;
        if middle + 2.0 * rise > 0.0 {
            let (theta, value) = summit((before.0, after.0), (here.0, middle), tolerance, |theta| sign * f(theta));
            if value > 0.0 && theta != here.0 {
                along.push((theta, sign * value));
            }
        }
    }
    along.sort_by(|a, b| a.0.total_cmp(&b.0));
    along
}
