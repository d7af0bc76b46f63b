//! Interval arithmetic, rounded outwards: the bounds hold the true value in spite of the rounding of every operation.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::{Add, Mul, Neg, Sub};

/// One operation, or one function of the standard library, is wrong by less than this part of its value.
const RELATIVE_ERROR: f64 = 2.0 * f64::EPSILON;

/// The part of a product that underflows is less than this.
const UNDERFLOW: f64 = 1e-300;

/// All values from `low` to `high`; either may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    pub low: f64,
    pub high: f64,
}

impl Interval {
    pub const ZERO: Self = Self { low: 0.0, high: 0.0 };
    /// Nothing is known.
    pub const ANY: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// A single value.
    pub fn of(value: f64) -> Self {
        Self::between(value, value)
    }

    /// All values between two; any value when one of them is not a number.
    pub fn between(low: f64, high: f64) -> Self {
        if low <= high { Self { low, high } } else { Self::ANY }
    }

    /// A value that rounding may have changed.
    pub fn about(value: f64) -> Self {
        Self::between(value, value).outwards()
    }

    /// Both bounds moved outwards by the error of one operation.
    fn outwards(self) -> Self {
        Self::between(self.low - self.low.abs() * RELATIVE_ERROR, self.high + self.high.abs() * RELATIVE_ERROR)
    }

    pub fn width(self) -> f64 {
        self.high - self.low
    }

    pub fn contains_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    /// The largest absolute value.
    pub fn largest(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// The smallest absolute value.
    pub fn smallest(self) -> f64 {
        if self.contains_zero() { 0.0 } else { self.low.abs().min(self.high.abs()) }
    }

    /// The values that lie in both; this interval when rounding has left none.
    pub fn within(self, other: Self) -> Self {
        let (low, high) = (self.low.max(other.low), self.high.min(other.high));
        if low <= high { Self { low, high } } else { self }
    }

    /// Bounds of a function that never falls.
    pub fn rising(self, f: impl Fn(f64) -> f64) -> Self {
        Self::between(f(self.low), f(self.high)).outwards()
    }

    /// The product with a number.
    pub fn times(self, k: f64) -> Self {
        let (a, b) = (self.low * k, self.high * k);
        Self::between(a.min(b), a.max(b)).outwards()
    }

    /// u², which is never negative.
    pub fn squared(self) -> Self {
        let (small, large) = (self.smallest(), self.largest());
        Self::between(small * small, large * large).outwards()
    }

    /// 1/u; any value when u may be zero.
    pub fn reciprocal(self) -> Self {
        if self.contains_zero() { Self::ANY } else { Self::between(1.0 / self.high, 1.0 / self.low).outwards() }
    }

    /// u to a whole power, which may be negative.
    pub fn whole_power(self, n: i32) -> Self {
        if n < 0 {
            return self.whole_power(-n).reciprocal();
        }
        if n % 2 == 0 {
            return Self::between(self.smallest().powi(n), self.largest().powi(n)).widened(n);
        }
        Self::between(self.low.powi(n), self.high.powi(n)).widened(n)
    }

    /// u to any power, for u that is not negative.
    pub fn real_power(self, p: f64) -> Self {
        if self.low < 0.0 {
            return Self::ANY;
        }
        let (a, b) = (self.low.powf(p), self.high.powf(p));
        Self::between(a.min(b), a.max(b)).widened(8)
    }

    /// Bounds moved outwards by the errors of so many operations.
    fn widened(self, operations: i32) -> Self {
        let error = RELATIVE_ERROR * f64::from(operations.max(1));
        Self::between(self.low - self.low.abs() * error, self.high + self.high.abs() * error)
    }

    pub fn cos(self) -> Self {
        // A long way from zero the argument itself is rounded; its width has that already.
        if self.width() >= TAU || !self.width().is_finite() {
            return Self::between(-1.0, 1.0);
        }
        let holds = |phase: f64| ((self.low - phase) / TAU).ceil() * TAU + phase <= self.high;
        let (a, b) = (self.low.cos(), self.high.cos());
        let error = RELATIVE_ERROR;
        let low = if holds(TAU / 2.0) { -1.0 } else { (a.min(b) - error).max(-1.0) };
        Self::between(low, if holds(0.0) { 1.0 } else { (a.max(b) + error).min(1.0) })
    }

    pub fn sin(self) -> Self {
        if self.low == 0.0 && self.high == 0.0 {
            return Self::ZERO;
        }
        if self.width() < FRAC_PI_2 && self.largest() < FRAC_PI_2 {
            return self.rising(f64::sin);
        }
        (self - Self::about(FRAC_PI_2)).cos()
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let exact = self == Self::ZERO || other == Self::ZERO;
        let sum = Self::between(self.low + other.low, self.high + other.high);
        if exact { sum } else { sum.outwards() }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self == Self::ZERO || other == Self::ZERO {
            return Self::ZERO;
        }
        let all = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        // Zero times infinity is a bound of nothing: the finite values beside it are what counts.
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in all {
            let value = if value.is_nan() { 0.0 } else { value };
            (low, high) = (low.min(value), high.max(value));
        }
        let product = Self::between(low, high).outwards();
        if low.abs() < UNDERFLOW || high.abs() < UNDERFLOW {
            let spread = |value: f64, by: f64| if value.abs() < UNDERFLOW && value != 0.0 { value + by } else { value };
            return Self { low: spread(product.low, -UNDERFLOW), high: spread(product.high, UNDERFLOW) };
        }
        product
    }
}
