//! A polynomial in the basis that keeps its digits: a series of Chebyshev polynomials over x ∈ [0, 1].

use crate::Svaj;

/// y(x) = Σ cₖ·Tₖ(2x − 1), with exact derivatives.
///
/// Powers of x lose about a digit for every degree and a half; this basis loses none, because |Tₖ| ≤ 1 over the whole of [0, 1]
/// (Trefethen, *Approximation Theory and Approximation Practice*, ch. 3). The series of the derivatives are worked out once, and all
/// four are summed together by Clenshaw's recurrence.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// The coefficients of Tₖ in y, y′, y″ and y‴, for each k.
    terms: Box<[[f64; 4]]>,
}

impl Series {
    /// A series from its coefficients, that of T₀ first.
    #[must_use]
    pub fn new(coefficients: &[f64]) -> Self {
        let mut terms: Box<[[f64; 4]]> = coefficients.iter().map(|&c| [c, 0.0, 0.0, 0.0]).collect();
        for order in 1..4 {
            // With u = 2x − 1: c′ₖ₋₁ = c′ₖ₊₁ + 2k·cₖ, the first of them halved, and d/dx = 2·d/du.
            for k in (1..terms.len()).rev() {
                let beyond = terms.get(k + 1).map_or(0.0, |term| term[order]);
                terms[k - 1][order] = beyond + 4.0 * k as f64 * terms[k][order - 1];
            }
            if let Some(first) = terms.first_mut() {
                first[order] *= 0.5;
            }
        }
        Self { terms }
    }

    /// The polynomial of so many coefficients through a function, met at the zeros of the Chebyshev polynomial of that degree: exact for a
    /// polynomial of a lower one.
    #[must_use]
    pub fn through(terms: usize, function: impl Fn(f64) -> f64) -> Self {
        let n = terms as f64;
        let angles: Vec<f64> = (0..terms).map(|i| std::f64::consts::PI * (i as f64 + 0.5) / n).collect();
        let values: Vec<f64> = angles.iter().map(|angle| function(0.5 + 0.5 * angle.cos())).collect();
        let coefficient = |k: usize| {
            let sum: f64 = angles.iter().zip(&values).map(|(angle, value)| value * (k as f64 * angle).cos()).sum();
            sum * if k == 0 { 1.0 } else { 2.0 } / n
        };
        Self::new(&(0..terms).map(coefficient).collect::<Vec<_>>())
    }

    /// y and its three derivatives with respect to x.
    #[must_use]
    #[inline]
    pub fn at(&self, x: f64) -> Svaj {
        let twice = 2.0 * (2.0 * x - 1.0);
        let (mut next, mut after) = ([0.0; 4], [0.0; 4]);
        for term in self.terms.iter().rev() {
            let here: [f64; 4] = std::array::from_fn(|order| term[order] + twice * next[order] - after[order]);
            (next, after) = (here, next);
        }
        // The recurrence counts the first term as any other, but T₋₁ = T₁: half of its step is taken back.
        let [s, v, a, j] = std::array::from_fn(|order| next[order] - 0.5 * twice * after[order]);
        Svaj::new(s, v, a, j)
    }

    /// Its degree.
    pub(crate) fn degree(&self) -> usize {
        self.terms.len().saturating_sub(1)
    }

    /// k·y(x) + c.
    #[must_use]
    pub fn scaled(mut self, k: f64, c: f64) -> Self {
        self.terms.iter_mut().flatten().for_each(|term| *term *= k);
        if let Some(first) = self.terms.first_mut() {
            first[0] += c;
        }
        self
    }

    /// The coefficients of the powers of x, constant term first, as they are printed; high degrees cost them their last digits.
    #[must_use]
    pub fn coefficients(&self) -> Vec<f64> {
        let n = self.terms.len();
        let (mut sum, mut before, mut here) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        for (k, term) in self.terms.iter().enumerate() {
            let mut next = vec![0.0; n];
            match k {
                0 => next[0] = 1.0,
                _ => {
                    // Tₖ = 2u·Tₖ₋₁ − Tₖ₋₂ with u = 2x − 1, and T₁ = u.
                    let factor = if k == 1 { 1.0 } else { 2.0 };
                    for (power, value) in next.iter_mut().enumerate() {
                        let raised = if power == 0 { 0.0 } else { 2.0 * here[power - 1] };
                        *value = factor * (raised - here[power]) - before[power];
                    }
                }
            }
            sum.iter_mut().zip(&next).for_each(|(sum, value)| *sum += term[0] * value);
            before = if k == 0 { before } else { here };
            here = next;
        }
        sum
    }
}

/// The derivative of that order of T₀ … Tₙ₋₁ at u ∈ [−1, 1], with respect to u.
///
/// Differentiating Tₖ₊₁ = 2u·Tₖ − Tₖ₋₁ m times gives Tₖ₊₁⁽ᵐ⁾ = 2u·Tₖ⁽ᵐ⁾ + 2m·Tₖ⁽ᵐ⁻¹⁾ − Tₖ₋₁⁽ᵐ⁾.
pub(crate) fn chebyshev(n: usize, order: usize, u: f64) -> Vec<f64> {
    let mut lower = vec![0.0; n];
    for m in 0..=order {
        let mut values = vec![0.0; n];
        for k in 0..n {
            values[k] = match (k, m) {
                (0, 0) | (1, 1) => 1.0,
                (1, 0) => u,
                (0 | 1, _) => 0.0,
                _ => 2.0 * u * values[k - 1] + 2.0 * m as f64 * lower[k - 1] - values[k - 2],
            };
        }
        lower = values;
    }
    lower
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_is_the_polynomial_that_it_stands_for() {
        // 1·T₀ + 2·T₁ − T₂ + ½·T₃ + 3·T₄ at u = 2x − 1, written out in powers of u.
        let series = Series::new(&[1.0, 2.0, -1.0, 0.5, 3.0]);
        for x in [0.0, 0.2, 0.5, 0.83, 1.0_f64] {
            let u = 2.0 * x - 1.0;
            let expected = Svaj::new(
                5.0 + 0.5 * u - 26.0 * u * u + 2.0 * u.powi(3) + 24.0 * u.powi(4),
                2.0 * (0.5 - 52.0 * u + 6.0 * u * u + 96.0 * u.powi(3)),
                4.0 * (-52.0 + 12.0 * u + 288.0 * u * u),
                8.0 * (12.0 + 576.0 * u),
            );
            for order in 0..4 {
                let (found, expected) = (series.at(x).order(order), expected.order(order));
                assert!((found - expected).abs() < 1e-11, "order {order} at {x}: {found}, not {expected}");
            }
            let by_powers: f64 = series.coefficients().iter().rev().fold(0.0, |sum, c| sum * x + c);
            assert!((by_powers - expected.s).abs() < 1e-11, "{by_powers} at {x}");
        }
    }

    #[test]
    fn the_basis_is_what_the_series_sums() {
        let (n, x) = (9, 0.37);
        for k in 0..n {
            let mut coefficients = vec![0.0; n];
            coefficients[k] = 1.0;
            let motion = Series::new(&coefficients).at(x);
            for order in 0..4 {
                let expected = chebyshev(n, order, 2.0 * x - 1.0)[k] * 2_f64.powi(order as i32);
                assert!((motion.order(order) - expected).abs() <= 1e-12 * (1.0 + expected.abs()), "T{k} order {order}");
            }
        }
    }

    #[test]
    fn scaling_moves_the_value_and_stretches_the_derivatives() {
        let series = Series::new(&[0.3, -2.0, 0.7, 1.1]);
        let (plain, scaled) = (series.at(0.6), series.scaled(3.0, 5.0).at(0.6));
        assert!((scaled.s - (3.0 * plain.s + 5.0)).abs() < 1e-14 && (scaled.a - 3.0 * plain.a).abs() < 1e-12);
    }
}
