//! A value with its first three derivatives, carried through arithmetic by the rules of Leibniz and Faà di Bruno.

use crate::Svaj;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// *u*, *u*′, *u*″, *u*‴ at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet(pub [f64; 4]);

impl Jet {
    /// A number that does not vary.
    pub fn constant(value: f64) -> Self {
        Self([value, 0.0, 0.0, 0.0])
    }

    /// What the derivatives are taken with respect to, times a factor.
    pub fn variable(value: f64, rate: f64) -> Self {
        Self([value, rate, 0.0, 0.0])
    }

    /// f(u), from f and its derivatives at u: f′u′, f″u′² + f′u″, f‴u′³ + 3f″u′u″ + f′u‴.
    pub fn through(self, [f, f1, f2, f3]: [f64; 4]) -> Self {
        let [_, u1, u2, u3] = self.0;
        Self([f, f1 * u1, f2 * u1 * u1 + f1 * u2, f3 * u1 * u1 * u1 + 3.0 * f2 * u1 * u2 + f1 * u3])
    }

    /// 1/u.
    pub fn recip(self) -> Self {
        let r = 1.0 / self.0[0];
        self.through([r, -r * r, 2.0 * r * r * r, -6.0 * (r * r) * (r * r)])
    }

    /// u^p, for a constant exponent.
    pub fn power(self, p: f64) -> Self {
        let u = self.0[0];
        let raised = |exponent: f64| if exponent.fract() == 0.0 { u.powi(exponent as i32) } else { u.powf(exponent) };
        let mut factor = 1.0;
        let derivative = |order: usize| {
            if order > 0 {
                factor *= p - (order as f64 - 1.0);
            }
            // Past its last derivative a power is gone, even at u = 0.
            if factor == 0.0 { 0.0 } else { factor * raised(p - order as f64) }
        };
        let derivatives: Vec<f64> = (0..4).map(derivative).collect();
        self.through([derivatives[0], derivatives[1], derivatives[2], derivatives[3]])
    }

    /// As a motion; what is beyond an `f64` counts as nothing.
    pub fn motion(self) -> Svaj {
        let [s, v, a, j] = self.0.map(|value| if value.is_finite() { value } else { 0.0 });
        Svaj::new(s, v, a, j)
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + o.0[k]))
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - o.0[k]))
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|value| -value))
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let ([u, u1, u2, u3], [w, w1, w2, w3]) = (self.0, o.0);
        Self([u * w, u1 * w + u * w1, u2 * w + 2.0 * u1 * w1 + u * w2, u3 * w + 3.0 * (u2 * w1 + u1 * w2) + u * w3])
    }
}

impl Div for Jet {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "a quotient is a product with the reciprocal")]
    fn div(self, o: Self) -> Self {
        self * o.recip()
    }
}
