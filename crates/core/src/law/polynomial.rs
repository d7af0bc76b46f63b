//! The polynomial through any conditions: heights, velocities, accelerations and jerks wherever they are known.

use super::conditions::{checked, solve};
use super::{Condition, Data, DataKind, DataProblem, Free, Given, Group, Law, Piece, Shape, Solved};
use crate::Series;
use crate::series::chebyshev;

/// As many coefficients as conditions (Norton, *Cam Design and Manufacturing Handbook*, ch. 4); interior points as well as ends, a
/// Hermite–Birkhoff problem. It is solved in Chebyshev polynomials and stays in them.
pub const LAW: Law = Law {
    id: "polynomial",
    group: Group::Free,
    parameters: &[],
    shape: Shape::Free(Free { data: DataKind::Conditions, first: at_rest, solve: pieces }),
};

/// Most conditions: a polynomial of a higher degree swings wide between its points, and a spline is what is wanted.
pub const MAX_CONDITIONS: usize = 24;

fn pieces(given: &Given) -> Result<Solved, DataProblem> {
    let conditions = checked(given.data, given.beta, 1..=MAX_CONDITIONS)?;
    let n = conditions.len();
    let (coefficients, condition) = solve(&conditions, |order, x| {
        let per_x = 2_f64.powi(order as i32);
        chebyshev(n, order, 2.0 * x - 1.0).into_iter().map(|value| value * per_x).collect()
    })?;
    Ok(Solved { pieces: vec![Piece::new(1.0, Series::new(&coefficients))], condition })
}

/// *s*, *v* and *a* at both ends, at rest: the 3-4-5 polynomial.
pub(super) fn at_rest(beta: f64, start: f64, rise: f64) -> Data {
    let end = |at: f64, height: f64| {
        (0..3).map(move |order| Condition { at, order, value: if order == 0 { height } else { 0.0 } })
    };
    Data::Conditions(end(0.0, start).chain(end(beta, start + rise)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(beta: f64, conditions: &[(f64, u8, f64)]) -> Result<Solved, DataProblem> {
        let conditions = conditions.iter().map(|&(at, order, value)| Condition { at, order, value }).collect();
        pieces(&Given { data: &Data::Conditions(conditions), beta, ..Given::default() })
    }

    #[test]
    fn at_rest_it_is_the_3_4_5() {
        let data = at_rest(1.0, 0.0, 1.0);
        let solved = pieces(&Given { data: &data, ..Given::default() }).expect("solved");
        let found = solved.pieces[0].curve.coefficients().expect("a polynomial");
        for (found, expected) in found.iter().zip([0.0, 0.0, 0.0, 10.0, -15.0, 6.0]) {
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
    }

    /// Every condition is met to 1e-9 of the lift, the jerks to as much of the greatest jerk.
    fn check(name: &str, beta: f64, conditions: &[(f64, u8, f64)]) {
        let solved = solved(beta, conditions).expect(name);
        let curve = &solved.pieces[0].curve;
        for order in 0..4 {
            let scale = (0..=400).map(|i| curve.at(f64::from(i) / 400.0).order(order).abs()).fold(0.0, f64::max);
            for &(at, _, value) in conditions.iter().filter(|condition| usize::from(condition.1) == order) {
                let found = curve.at(at / beta).order(order);
                let residual = (found - value * beta.powi(order as i32)).abs();
                assert!(residual <= 1e-11 * scale, "{name}: order {order} at {at} misses by {residual} of {scale}");
            }
        }
        assert!(solved.condition < crate::program::LEAST_TRUSTED, "{name}: {:e}", solved.condition);
    }

    #[test]
    fn twelve_conditions_and_more_are_met() {
        let all: Vec<(f64, u8, f64)> =
            [(0.0, 0.0), (1.1, 9.0), (2.4, 3.0)].iter().flat_map(|&(at, s)| (0..4).map(move |k| (at, k, s))).collect();
        check("three points with s, v, a and j", 2.4, &all);
        let mut points: Vec<(f64, u8, f64)> =
            (0..8).map(|k| (2.0 * f64::from(k) / 7.0, 0, f64::from(k * (7 - k)))).collect();
        points.extend([(0.0, 1, 0.0), (2.0, 1, 0.0), (0.0, 2, 0.0), (2.0, 2, 0.0)]);
        check("eight points, at rest at both ends", 2.0, &points);
        let many: Vec<(f64, u8, f64)> =
            (0..6).flat_map(|i| (0..4).map(move |k| (f64::from(i) * 0.8, k, f64::from(i % 2)))).collect();
        check("twenty-four", 4.0, &many);
        check("in metres over a degree", 0.017, &[(0.0, 0, 1e-3), (0.0, 1, 0.0), (0.017, 0, 2e-3), (0.017, 1, 0.0)]);
    }

    #[test]
    fn what_no_single_polynomial_meets_is_named() {
        let refused = |conditions: &[(f64, u8, f64)]| solved(2.0, conditions).expect_err("refused");
        assert_eq!(refused(&[]), DataProblem::Count { found: 0, min: 1, max: 24 });
        assert_eq!(
            refused(&[(0.0, 0, 1.0), (0.5, 1, 0.0), (0.0, 0, 1.0)]),
            DataProblem::Repeated { item: 2, other: 0 }
        );
        assert_eq!(refused(&[(0.0, 0, 0.0), (2.1, 0, 0.0)]), DataProblem::Outside { item: 1, found: 2.1, beta: 2.0 });
        assert_eq!(refused(&[(0.0, 1, 0.0), (2.0, 2, 0.0)]), DataProblem::NoHeight);
        assert_eq!(refused(&[(0.0, 0, 0.0), (f64::NAN, 0, 0.0)]), DataProblem::NotFinite { item: 1 });
        assert_eq!(refused(&[(0.0, 0, 0.0), (0.0, 4, 0.0)]), DataProblem::Order { item: 1, found: 4 });
        // A parabola's slope in the middle is that of its chord, whatever the heights: Birkhoff's classic.
        assert_eq!(
            refused(&[(0.0, 0, 0.0), (1.0, 1, 5.0), (2.0, 0, 1.0)]),
            DataProblem::Dependent { items: vec![0, 1, 2] }
        );
        // A cubic's jerk is the same everywhere, and the two heights have nothing to do with it.
        assert_eq!(
            refused(&[(0.0, 0, 0.0), (0.5, 3, 1.0), (2.0, 0, 1.0), (1.5, 3, 1.0)]),
            DataProblem::Dependent { items: vec![1, 3] }
        );
    }
}
