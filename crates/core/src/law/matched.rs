//! The polynomial that agrees with two neighbours in value and derivatives.

use super::System;
use crate::{Curve, Svaj};
use nalgebra::{Const, DimMin, SMatrix, SVector};

/// The polynomial in x ∈ [0, 1] of degree 2·`orders` − 1 with the given value and derivatives (with respect to x) at
/// both ends; `orders` is 3 (*s*, *v*, *a*) or 4 (and *j*).
///
/// Hermite's two-point problem: the lower half of the coefficients is read off the start, cₖ = y⁽ᵏ⁾(0)/k!, and the
/// upper half solves a small linear system at x = 1, whose matrix depends on `orders` alone and is well conditioned.
pub(crate) fn matched_polynomial(orders: usize, start: Svaj, end: Svaj) -> Curve {
    match orders {
        3 => solve::<3>(start, end),
        _ => solve::<4>(start, end),
    }
}

fn solve<const N: usize>(start: Svaj, end: Svaj) -> Curve
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut coefficients = [0.0; 8];
    for (k, coefficient) in coefficients.iter_mut().enumerate().take(N) {
        *coefficient = start.order(k) / falling_factorial(k, k);
    }
    let matrix = SMatrix::<f64, N, N>::from_fn(|order, column| falling_factorial(N + column, order));
    let known = SVector::<f64, N>::from_fn(|order, _| {
        let from_start: f64 = (order..N).map(|k| coefficients[k] * falling_factorial(k, order)).sum();
        end.order(order) - from_start
    });
    let upper = matrix.lu().solve(&known).unwrap_or_else(SVector::zeros);
    coefficients[N..2 * N].copy_from_slice(upper.as_slice());
    Curve::polynomial(&coefficients[..2 * N])
}

/// The same as it is written on paper: the lower coefficients, and the system of the upper ones.
#[must_use]
pub fn end_system(orders: usize, start: Svaj, end: Svaj) -> (Vec<f64>, System) {
    let orders = orders.clamp(1, 4);
    let lower: Vec<f64> = (0..orders).map(|k| start.order(k) / falling_factorial(k, k)).collect();
    let row = |order: usize| (orders..2 * orders).map(|k| falling_factorial(k, order)).collect();
    let from_start = |order: usize| -> f64 { (order..orders).map(|k| lower[k] * falling_factorial(k, order)).sum() };
    let known = (0..orders).map(|order| end.order(order) - from_start(order)).collect();
    let matrix = (0..orders).map(row).collect();
    (lower, System { matrix, known })
}

/// k·(k − 1)·…, `order` factors: the `order`-th derivative of xᵏ at x = 1.
pub(super) fn falling_factorial(k: usize, order: usize) -> f64 {
    (0..order).map(|i| k as f64 - i as f64).product()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_rests_it_is_the_3_4_5_and_the_4_5_6_7() {
        let (start, end) = (Svaj::default(), Svaj::new(1.0, 0.0, 0.0, 0.0));
        for (orders, expect) in
            [(3, vec![0.0, 0.0, 0.0, 10.0, -15.0, 6.0]), (4, vec![0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0])]
        {
            let found = matched_polynomial(orders, start, end);
            for (f, e) in found.coefficients().iter().zip(&expect) {
                assert!((f - e).abs() < 1e-11, "{found:?}");
            }
        }
    }

    #[test]
    fn the_system_on_paper_has_the_same_solution() {
        let (start, end) = (Svaj::new(0.3, -1.0, 2.0, 5.0), Svaj::new(0.8, 0.5, -4.0, 1.0));
        for orders in [3, 4] {
            let curve = matched_polynomial(orders, start, end);
            let (lower, system) = end_system(orders, start, end);
            let inverse = system.inverse().expect("regular");
            let upper = |row: &Vec<f64>| row.iter().zip(&system.known).map(|(a, b)| a * b).sum::<f64>();
            let all: Vec<f64> = lower.into_iter().chain(inverse.iter().map(upper)).collect();
            for (found, expected) in all.iter().zip(curve.coefficients()) {
                assert!((found - expected).abs() < 1e-10 * (1.0 + expected.abs()), "{all:?} {curve:?}");
            }
        }
    }

    #[test]
    fn all_end_conditions_are_met() {
        let (start, end) = (Svaj::new(0.3, -1.0, 2.0, 5.0), Svaj::new(0.8, 0.5, -4.0, 1.0));
        let curve = matched_polynomial(4, start, end);
        for order in 0..4 {
            assert!((curve.at(0.0).order(order) - start.order(order)).abs() < 1e-11);
            assert!((curve.at(1.0).order(order) - end.order(order)).abs() < 1e-10);
        }
    }
}
