//! A smooth stretch of the motion.

use crate::search::root;
use crate::{Form, Svaj};
use std::f64::consts::{PI, TAU};

/// Places of a stretch at which a derivative is looked at for changes of its sign.
const LOOKS: usize = 240;

/// Halvings of the step before an end at which a derivative is looked at too: one that leaves zero there may change its sign at once.
const END_HALVINGS: i32 = 10;

/// Parts, for each period of its fastest wave, between the places at which the size of a curve is taken: with a degree of 8 at most it
/// cannot vanish at all of them, unless it is zero.
const CURVE_PARTS: usize = 8;

/// A wave longer than a period by less than this part of it has one period: the rest is rounding.
const PERIOD_TOLERANCE: f64 = 1e-9;

/// What is smaller beside the greatest value of a derivative is rounding.
const ROUNDING: f64 = 1e-9;

/// A smooth stretch of the cycle: s = curve((θ − origin)/beta), for θ from `from` to `to`.
#[derive(Clone, Debug)]
pub struct Stretch {
    /// First θ, radians.
    pub from: f64,
    /// Last θ, radians.
    pub to: f64,
    /// The segment it belongs to.
    pub segment: usize,
    pub(crate) origin: f64,
    pub(crate) beta: f64,
    pub(crate) per_beta: f64,
    pub(crate) curve: Form,
}

impl Stretch {
    /// Displacement and derivatives; at `from` and `to`, the one-sided limits from inside.
    #[must_use]
    #[inline]
    pub fn at(&self, theta: f64) -> Svaj {
        let y = self.curve.at((theta - self.origin) * self.per_beta);
        let (k, k2) = (self.per_beta, self.per_beta * self.per_beta);
        Svaj::new(y.s, y.v * k, y.a * k2, y.j * (k2 * k))
    }

    /// The number of periods of its fastest wave that it spans, rounded up; 1 for a curve without waves. As many times more places are
    /// needed to see its extremes.
    pub(crate) fn periods(&self) -> usize {
        let Form::Curve(curve) = &self.curve else { return 1 };
        let turned = curve.highest_frequency() * ((self.to - self.from) * self.per_beta).abs();
        ((turned / TAU - PERIOD_TOLERANCE).ceil() as usize).max(1)
    }

    /// The error of rounding of a derivative at the ends of the stretch: of heights of a size over so short a stretch, as a spline of many
    /// points has, or of the operations of a formula.
    pub(crate) fn rounding(&self, height: f64, order: usize) -> f64 {
        const DIGITS: f64 = 64.0 * f64::EPSILON;
        let of_heights = if self.is_still() { 0.0 } else { DIGITS * height / (self.to - self.from).powi(order as i32) };
        match &self.curve {
            Form::Formula(formula) => of_heights + formula.rounding(order) * self.per_beta.abs().powi(order as i32),
            Form::Curve(_) | Form::Series(_) => of_heights,
        }
    }

    /// The lowest and the highest value of *s* and its derivatives, as far as a scale needs them: those of a formula are true extremes,
    /// those of other curves no less than the √2th part of them.
    pub(crate) fn ranges(&self) -> [(f64, f64); 4] {
        let in_theta = |order: usize, (low, high): (f64, f64)| {
            let factor = self.per_beta.powi(order as i32);
            (low * factor, high * factor)
        };
        let parts = match &self.curve {
            Form::Formula(formula) => return std::array::from_fn(|order| in_theta(order, formula.range(order))),
            Form::Curve(_) if self.is_still() => 1,
            Form::Curve(_) => CURVE_PARTS * self.periods(),
            // Ehlich and Zeller (1964): a polynomial of degree n is nowhere larger than sec(π/4) times its largest value at these places.
            Form::Series(series) => (2 * series.degree()).max(1),
        };
        let is_series = matches!(self.curve, Form::Series(_));
        let mut ranges = [(f64::INFINITY, f64::NEG_INFINITY); 4];
        for i in 0..=parts {
            let even = i as f64 / parts as f64;
            let share = if is_series { 0.5 - 0.5 * (PI * even).cos() } else { even };
            let motion = self.at(self.from + (self.to - self.from) * share);
            for (order, range) in ranges.iter_mut().enumerate() {
                let value = motion.order(order);
                *range = (range.0.min(value), range.1.max(value));
            }
        }
        ranges
    }

    /// Every θ inside the stretch (radians, or length of a cam that travels), in order, at which it must be sampled besides the rows of
    /// an analysis so that nothing is missed: places of a formula, none of other laws.
    pub fn places(&self) -> impl Iterator<Item = f64> {
        let theta = |x: &f64| self.origin + self.beta * x;
        self.curve.places().iter().map(theta).filter(|theta| self.from < *theta && *theta < self.to)
    }

    /// What could not be proved of its extremes: the lowest order concerned, and where it begins and ends.
    pub(crate) fn unproved(&self) -> Option<(u8, f64, f64)> {
        let Form::Formula(formula) = &self.curve else { return None };
        formula
            .unproved()
            .map(|part| (part.order, self.origin + self.beta * part.from, self.origin + self.beta * part.to))
    }

    /// Its ends, every place at which it must be sampled, and so many even steps.
    pub(crate) fn places_and_steps(&self, steps: usize) -> Vec<f64> {
        let even = (1..steps).map(|i| self.from + (self.to - self.from) * i as f64 / steps as f64);
        let mut places: Vec<f64> = [self.from, self.to].into_iter().chain(self.places()).chain(even).collect();
        places.sort_by(f64::total_cmp);
        places
    }

    /// True when the follower rests.
    #[must_use]
    pub fn is_still(&self) -> bool {
        self.curve.is_constant()
    }

    /// The same stretch half a turn later and upside down, from `top`; its segment comes `count` later.
    pub(crate) fn image(&self, count: usize, top: f64) -> Self {
        Self {
            from: self.from + PI,
            to: self.to + PI,
            segment: self.segment + count,
            origin: self.origin + PI,
            beta: self.beta,
            per_beta: self.per_beta,
            curve: self.curve.clone().scaled(-1.0, top),
        }
    }

    /// Every θ inside the stretch, its ends apart, where the derivative of that order (1 for *v* to 3 for *j*) changes its sign: the one
    /// before it is greatest or least there.
    #[must_use]
    pub fn zeros(&self, order: usize) -> Vec<f64> {
        let at = |theta: f64| self.at(theta).order(order);
        let looks = LOOKS.max(CURVE_PARTS * self.periods());
        let mut places = self.places_and_steps(looks);
        let step = (self.to - self.from) / looks as f64;
        places.extend(
            (1..=END_HALVINGS).flat_map(|k| [self.from + step * 0.5_f64.powi(k), self.to - step * 0.5_f64.powi(k)]),
        );
        places.sort_by(f64::total_cmp);
        let along: Vec<(f64, f64)> = places.into_iter().map(|theta| (theta, at(theta))).collect();
        let floor = match &self.curve {
            // Beside a narrow feature, which is steep, all the others are small.
            Form::Formula(formula) => formula.rounding(order) * self.per_beta.powi(order as i32),
            Form::Curve(_) | Form::Series(_) => ROUNDING * along.iter().map(|place| place.1.abs()).fold(0.0, f64::max),
        };
        let mut zeros = Vec::new();
        let mut last: Option<(f64, f64)> = None;
        for here in along {
            // What is nothing but rounding has no sign; where it begins or ends is of no interest.
            if here.1.abs() <= floor {
                continue;
            }
            if let Some((before, value)) = last
                && (value > 0.0) != (here.1 > 0.0)
            {
                zeros.push(root(before, here.0, at));
            }
            last = Some(here);
        }
        zeros
    }

    /// The formula in x = (θ − origin)/β, with its origin and β.
    #[must_use]
    pub fn formula(&self) -> (&Form, f64, f64) {
        (&self.curve, self.origin, self.beta)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Curve;

    #[test]
    fn a_derivative_that_turns_just_inside_an_end_is_found() {
        // a = 3x(2w − x): it leaves zero at the start and is zero again at 2w, nearer than a step of the search.
        for w in [1e-3, 1e-4] {
            let curve = Curve::polynomial(&[0.0, 0.0, 0.0, w, -0.25]).into();
            let stretch = Stretch { from: 0.0, to: 1.0, segment: 0, origin: 0.0, beta: 1.0, per_beta: 1.0, curve };
            let zeros = stretch.zeros(2);
            assert!(zeros.len() == 1 && (zeros[0] - 2.0 * w).abs() < 1e-9, "{w}: {zeros:?}");
        }
    }
}
