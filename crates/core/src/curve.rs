//! The one kind of smooth curve that every motion law is made of: a polynomial plus sine waves.

use crate::Svaj;
use std::sync::Arc;

/// Most coefficients a curve may have: degree 8, the highest of a spline.
pub const MAX_COEFFICIENTS: usize = 9;

/// `amplitude · sin(frequency · x + phase)`, frequency and phase in radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wave {
    /// Height of the wave.
    pub amplitude: f64,
    /// Radians a unit of x.
    pub frequency: f64,
    /// Angle at x = 0.
    pub phase: f64,
}

/// y(x) = Σ cₖ·xᵏ + Σ A·sin(ωx + φ), with exact derivatives. A copy shares the waves of the original.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    coefficients: [f64; MAX_COEFFICIENTS],
    terms: usize,
    waves: Arc<[Wave]>,
}

impl Curve {
    /// A polynomial from its coefficients, constant term first; at most [`MAX_COEFFICIENTS`] of them.
    #[must_use]
    pub fn polynomial(coefficients: &[f64]) -> Self {
        let mut curve = Self { terms: coefficients.len(), ..Self::default() };
        curve.coefficients[..coefficients.len()].copy_from_slice(coefficients);
        curve
    }

    /// The same curve with a wave added to those it has.
    #[must_use]
    pub fn with_wave(self, amplitude: f64, frequency: f64, phase: f64) -> Self {
        let added = Wave { amplitude, frequency, phase };
        Self { waves: self.waves.iter().copied().chain([added]).collect(), ..self }
    }

    /// The coefficients of the polynomial part, constant term first.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients[..self.terms]
    }

    /// The sine waves added to the polynomial.
    #[must_use]
    pub fn waves(&self) -> &[Wave] {
        &self.waves
    }

    /// The highest frequency of its waves, radians per unit of x; 0 without waves.
    pub(crate) fn highest_frequency(&self) -> f64 {
        self.waves.iter().map(|wave| wave.frequency.abs()).fold(0.0, f64::max)
    }

    /// y and its three derivatives with respect to x.
    #[must_use]
    #[inline]
    pub fn at(&self, x: f64) -> Svaj {
        self.waves().iter().fold(horner(self.coefficients(), x), |sum, wave| sum + wave.at(x))
    }

    /// k·y(x) + c.
    #[must_use]
    pub fn scaled(mut self, k: f64, c: f64) -> Self {
        self.coefficients.iter_mut().for_each(|term| *term *= k);
        Arc::make_mut(&mut self.waves).iter_mut().for_each(|wave| wave.amplitude *= k);
        self.coefficients[0] += c;
        self.terms = self.terms.max(1);
        self
    }
}

impl Wave {
    #[inline]
    fn at(&self, x: f64) -> Svaj {
        let (sin, cos) = (self.frequency * x + self.phase).sin_cos();
        let first = self.amplitude * self.frequency;
        let second = -first * self.frequency;
        let third = second * self.frequency;
        Svaj::new(self.amplitude * sin, first * cos, second * sin, third * cos)
    }
}

/// Value and three derivatives of a polynomial by Horner's rule applied to itself (synthetic division).
#[inline]
fn horner(coefficients: &[f64], x: f64) -> Svaj {
    let (mut y, mut y1, mut y2, mut y3) = (0.0, 0.0, 0.0, 0.0);
    for c in coefficients.iter().rev() {
        y3 = y3 * x + y2;
        y2 = y2 * x + y1;
        y1 = y1 * x + y;
        y = y * x + c;
    }
    Svaj::new(y, y1, 2.0 * y2, 6.0 * y3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_a_polynomial_with_waves_match_the_closed_form() {
        let curve = Curve::polynomial(&[1.0, -2.0, 0.5, 3.0]).with_wave(0.25, 4.0, 0.3);
        let x: f64 = 0.37;
        let angle = 4.0 * x + 0.3;
        let expect = Svaj::new(
            1.0 - 2.0 * x + 0.5 * x * x + 3.0 * x.powi(3) + 0.25 * angle.sin(),
            -2.0 + x + 9.0 * x * x + angle.cos(),
            1.0 + 18.0 * x - 4.0 * angle.sin(),
            18.0 - 16.0 * angle.cos(),
        );
        let found = curve.at(x);
        for order in 0..4 {
            assert!((found.order(order) - expect.order(order)).abs() < 1e-13, "order {order}");
        }
    }

    #[test]
    fn a_curve_has_as_many_waves_as_are_added() {
        let wave = |n: u32| (1.0 / f64::from(n * n), f64::from(n), 0.1 * f64::from(n));
        let add = |curve: Curve, n| {
            let (amplitude, frequency, phase) = wave(n);
            curve.with_wave(amplitude, frequency, phase)
        };
        let curve = (1..=7).fold(Curve::polynomial(&[0.5, 1.0]), add);
        let x = 0.83;
        let sum: f64 =
            (1..=7).map(wave).map(|(amplitude, frequency, phase)| amplitude * (frequency * x + phase).sin()).sum();
        assert_eq!(curve.waves().len(), 7);
        assert!((curve.at(x).s - (0.5 + x + sum)).abs() < 1e-14);
    }

    #[test]
    fn scaling_a_curve_leaves_a_copy_of_it_as_it_was() {
        let curve = Curve::polynomial(&[0.0]).with_wave(1.0, 2.0, 0.0);
        let copy = curve.clone();
        let scaled = curve.scaled(2.0, 0.0);
        assert_eq!((copy.waves()[0].amplitude, scaled.waves()[0].amplitude), (1.0, 2.0));
    }

    #[test]
    fn scaling_moves_the_value_and_stretches_the_derivatives() {
        let curve = Curve::polynomial(&[0.0, 0.0, 1.0]).with_wave(1.0, 2.0, 0.0);
        let (plain, scaled) = (curve.at(0.6), curve.clone().scaled(3.0, 5.0).at(0.6));
        assert!((scaled.s - (3.0 * plain.s + 5.0)).abs() < 1e-14);
        assert!((scaled.j - 3.0 * plain.j).abs() < 1e-14);
    }
}
