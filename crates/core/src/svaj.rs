//! Displacement and its first three derivatives, travelling together.

use std::ops::{Add, Mul, Sub};

/// Displacement *s* and its derivatives *v*, *a*, *j* with respect to the cam angle θ.
///
/// Units: *s* in the design's length (or radians, for an oscillating follower); the others per radian, per
/// radian² and per radian³.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Svaj {
    /// Displacement.
    pub s: f64,
    /// ds/dθ.
    pub v: f64,
    /// d²s/dθ².
    pub a: f64,
    /// d³s/dθ³.
    pub j: f64,
}

impl Svaj {
    /// Gathers a value and its three derivatives.
    #[must_use]
    pub const fn new(s: f64, v: f64, a: f64, j: f64) -> Self {
        Self { s, v, a, j }
    }

    /// The same curve when the independent variable is stretched by `beta`: θ = β·x, so d/dθ = (1/β)·d/dx, and the derivative of order n is divided by βⁿ.
    #[must_use]
    pub fn stretched(self, beta: f64) -> Self {
        let k = 1.0 / beta;
        Self::new(self.s, self.v * k, self.a * k * k, self.j * k * k * k)
    }

    /// The derivative of the given order, 0 for *s* to 3 for *j*.
    #[must_use]
    pub fn order(self, order: usize) -> f64 {
        [self.s, self.v, self.a, self.j][order]
    }
}

impl Add for Svaj {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.s + o.s, self.v + o.v, self.a + o.a, self.j + o.j)
    }
}

impl Sub for Svaj {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + o * -1.0
    }
}

impl Mul<f64> for Svaj {
    type Output = Self;
    fn mul(self, k: f64) -> Self {
        Self::new(self.s * k, self.v * k, self.a * k, self.j * k)
    }
}
