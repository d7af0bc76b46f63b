//! Where a formula has to be sampled: [0, 1] is split until the bounds of its derivatives leave no room for a feature between two samples.

use super::enclosure::{Enclosure, ORDERS};
use super::interval::Interval;
use super::{Expression, Variables};
use crate::search::root;
use std::collections::VecDeque;
use std::f64::consts::TAU;

/// Operations on enclosures that one formula may cost; a moderate one takes less than a tenth of them.
const MAX_OPERATIONS: usize = 3 << 17;

/// A part narrower than this is not split: its ends hardly differ.
const MIN_WIDTH: f64 = 1e-13;

/// A variation this small, as a part of the largest height of the formula, shows in no verdict: such a variation of *s*, *ds*/dθ or
/// *d*²*s*/dθ² changes neither φ nor ρ of a cam that is larger than its lift.
const NEGLIGIBLE: f64 = 1e-3;

/// A variation this small beside the largest value of the same derivative is negligible, too: a sampled extreme is refined afterwards.
const FINE: f64 = 1e-6;

/// The same for the jerk, on which neither φ nor ρ depends.
const FINE_JERK: f64 = 1e-3;

/// Between two samples *v* and *a* vary by no more than this part of their smaller value, or by this part of the largest height of the
/// formula per radian: φ and ρ, which follow from them, are then resolved as well.
const GRADUAL: f64 = 0.5;

/// Variations of *v* and *a* smaller than this part of their largest value are left to the samples between turning points.
const COARSE: f64 = 1.0 / 64.0;

/// Operations after which parts are no longer split for the sake of φ and ρ alone: a formula of so many waves is sampled densely anyway.
const OPERATIONS_FOR_CONTACT: usize = MAX_OPERATIONS / 12;

/// Places closer than this part of the part they lie in are one: between two of them only rounding would be compared.
const COINCIDENT: f64 = 1e-6;

/// Samples between two neighbouring turning points: enough to refine a turning point of φ or ρ that lies between them.
const SAMPLES_BETWEEN_TURNS: f64 = 8.0;

/// Places at which a formula is evaluated to estimate its size, at uneven steps so that no wave vanishes at all of them.
const FIRST_PLACES: usize = 23;

/// What is known about a formula over [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Survey {
    /// Places between 0 and 1, in order: every turning point of the value and its three derivatives is one, and between two
    /// neighbours none of them has any other variation that matters.
    pub places: Vec<f64>,
    /// Lowest and highest value and derivatives.
    pub ranges: [Interval; 4],
    /// Errors of rounding of value and derivatives at x = 0 and x = 1.
    pub rounding: [[f64; 4]; 2],
    /// Parts for which this could not be proved.
    pub unproved: Option<Unproved>,
}

/// What a bound on work left without proof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unproved {
    /// The lowest order whose extremes are not proved: 0 for *s* to 3 for *j*.
    pub order: u8,
    /// The x at which the first such part begins.
    pub from: f64,
    /// The x at which the last one ends.
    pub to: f64,
}

/// Surveys an expression that is smooth over [0, 1].
pub(super) fn survey(expression: &Expression, variables: &Variables) -> Survey {
    let mut surveyor = Surveyor::new(expression, variables);
    let (borders, unproved) = surveyor.split();
    let turns = surveyor.turns(&borders);
    let places = with_samples_between(&borders, turns);
    for &x in &places {
        surveyor.note(x);
    }
    let end = |surveyor: &mut Surveyor, x: f64| {
        let bounds = surveyor.bounds(x, x);
        std::array::from_fn(|order| bounds[order].width())
    };
    let rounding = [end(&mut surveyor, 0.0), end(&mut surveyor, 1.0)];
    Survey { places, ranges: surveyor.ranges, rounding, unproved }
}

struct Surveyor<'a> {
    expression: &'a Expression,
    variables: &'a Variables,
    stack: Vec<Enclosure>,
    /// What has been met of the value and its derivatives.
    ranges: [Interval; 4],
    operations: usize,
}

impl<'a> Surveyor<'a> {
    fn new(expression: &'a Expression, variables: &'a Variables) -> Self {
        let ranges = at(expression, variables, 0.0).map(Interval::of);
        let mut surveyor = Self { expression, variables, stack: Vec::new(), ranges, operations: 0 };
        for i in 0..FIRST_PLACES {
            surveyor.note((i as f64 + 0.37) / FIRST_PLACES as f64);
        }
        surveyor.note(1.0);
        surveyor
    }

    /// Takes the values at a place into account.
    fn note(&mut self, x: f64) {
        let values = at(self.expression, self.variables, x);
        for (range, value) in self.ranges.iter_mut().zip(values) {
            (range.low, range.high) = (range.low.min(value), range.high.max(value));
        }
    }

    /// Bounds of the value and its derivatives for x between two values.
    fn bounds(&mut self, from: f64, to: f64) -> [Interval; ORDERS] {
        self.operations += self.expression.ops.len();
        let x = Interval::between(from, to);
        Enclosure::of(self.expression, x, self.variables, &mut self.stack).derivatives()
    }

    /// The borders of parts that leave no room for a feature, and what could not be proved of them.
    fn split(&mut self) -> (Vec<f64>, Option<Unproved>) {
        let mut borders = vec![0.0, 1.0];
        let mut unproved: Option<Unproved> = None;
        let mut parts = VecDeque::from([(0.0, 1.0)]);
        while let Some((from, to)) = parts.pop_front() {
            let natural = self.bounds(from, to);
            if self.unresolved(&natural).is_none() {
                continue;
            }
            let middle = 0.5 * (from + to);
            let bounds = self.sharpened(natural, middle, 0.5 * (to - from));
            let Some(order) = self.unresolved(&bounds) else { continue };
            if to - from < MIN_WIDTH || self.operations > MAX_OPERATIONS {
                let known = unproved.unwrap_or(Unproved { order, from, to });
                let (order, from, to) = (known.order.min(order), known.from.min(from), known.to.max(to));
                unproved = Some(Unproved { order, from, to });
                continue;
            }
            borders.push(middle);
            parts.extend([(from, middle), (middle, to)]);
        }
        borders.sort_by(f64::total_cmp);
        (borders, unproved)
    }

    /// Sharper bounds by the mean value theorem: a derivative is what it is in the middle, and half a width of the next one.
    fn sharpened(&mut self, mut bounds: [Interval; ORDERS], middle: f64, half: f64) -> [Interval; ORDERS] {
        let centre = self.bounds(middle, middle);
        self.note(middle);
        let step = Interval { low: -half, high: half };
        for order in (0..ORDERS - 1).rev() {
            bounds[order] = bounds[order].within(centre[order] + step * bounds[order + 1]);
        }
        bounds
    }

    /// The lowest order that may vary between the ends of a part in a way that its ends do not show.
    fn unresolved(&self, bounds: &[Interval; ORDERS]) -> Option<u8> {
        let height = self.ranges[0].width().max(NEGLIGIBLE * self.ranges[0].largest());
        let rate = self.variables.beta.abs().min(TAU);
        let eager = self.operations < OPERATIONS_FOR_CONTACT;
        (0..4_u8).find(|&order| {
            let k = usize::from(order);
            let (width, own) = (bounds[k].width(), self.ranges[k].largest());
            let per_radian = height * rate.powi(i32::from(order));
            let small = if k == 3 { FINE_JERK * own } else { (NEGLIGIBLE * per_radian).max(FINE * own) };
            if width <= small {
                return false;
            }
            // A derivative that keeps its sign lets the one before it turn nowhere, and the one before that once at most.
            let turns_once = !bounds[k + 1].contains_zero() || !bounds[k + 2].contains_zero();
            let varies = GRADUAL * bounds[k].smallest().max(per_radian).max(COARSE * own);
            let gradual = !eager || k == 0 || k == 3 || width <= varies;
            !(turns_once && gradual)
        })
    }

    /// Where the value and its three derivatives turn, in order.
    fn turns(&self, borders: &[f64]) -> Vec<f64> {
        let slope = |order: usize, x: f64| self.expression.at(x, self.variables).0[order];
        let mut turns = Vec::new();
        let mut before = self.expression.at(borders[0], self.variables).0;
        for pair in borders.windows(2) {
            let after = self.expression.at(pair[1], self.variables).0;
            let near = COINCIDENT * (pair[1] - pair[0]);
            let mut own: Vec<f64> = (1..4)
                .filter(|&order| before[order] * after[order] < 0.0)
                .map(|order| root(pair[0], pair[1], |x| slope(order, x)))
                .filter(|x| x - pair[0] > near && pair[1] - x > near)
                .collect();
            own.sort_by(f64::total_cmp);
            own.dedup_by(|later, earlier| *later - *earlier <= near);
            turns.append(&mut own);
            before = after;
        }
        turns
    }
}

fn at(expression: &Expression, variables: &Variables, x: f64) -> [f64; 4] {
    let motion = expression.at(x, variables).motion();
    std::array::from_fn(|order| motion.order(order))
}

/// The borders and the turning points, in order and without 0 and 1, and so many more that no step is long beside the distance between
/// neighbouring turning points.
fn with_samples_between(borders: &[f64], turns: Vec<f64>) -> Vec<f64> {
    let mut ends = turns;
    ends.push(1.0);
    let mut places: Vec<f64> = Vec::new();
    let (mut last, mut border) = (0.0, 0);
    for end in ends {
        let longest = (end - last) / SAMPLES_BETWEEN_TURNS;
        while last < end {
            while border < borders.len() && borders[border] <= last {
                border += 1;
            }
            let next = borders.get(border).copied().unwrap_or(1.0).min(end);
            let steps = ((next - last) / longest).ceil().max(1.0);
            places.extend((1..steps as usize).map(|i| last + (next - last) * i as f64 / steps));
            places.push(next);
            last = next;
        }
    }
    places.pop();
    places
}
