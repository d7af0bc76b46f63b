//! A smooth stretch of the motion.

use crate::extreme::root;
use crate::{Form, Svaj};
use std::f64::consts::PI;

/// Places of a stretch at which a derivative is looked at for changes of its sign.
const LOOKS: usize = 240;

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

    /// What the rounding of heights of a size makes of a derivative over so short a stretch, as a spline of many points has.
    pub(crate) fn rounding(&self, height: f64, order: usize) -> f64 {
        const DIGITS: f64 = 64.0 * f64::EPSILON;
        if self.is_still() { 0.0 } else { DIGITS * height / (self.to - self.from).powi(order as i32) }
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
        let theta = |i: usize| self.from + (self.to - self.from) * i as f64 / LOOKS as f64;
        let scale = (0..=LOOKS).map(|i| at(theta(i)).abs()).fold(0.0, f64::max);
        let floor = ROUNDING * scale;
        let mut zeros = Vec::new();
        let mut last: Option<(f64, f64)> = None;
        for i in 0..=LOOKS {
            let here = (theta(i), at(theta(i)));
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
