//! The B-spline through conditions: many of them, without the swings of one polynomial of a high degree.

use super::conditions::{checked, solve};
use super::polynomial::at_rest;
use super::{Condition, Data, DataKind, DataProblem, Free, Given, Group, Law, Piece, Shape, Solved};
use crate::{Curve, Parameter, Quantity};

/// As many B-splines of degree 4 to 8 as conditions. Unless they are told, the knots are the means of as many neighbouring conditions as the
/// degree, so that there is always a solution (de Boor, *A Practical Guide to Splines*, ch. XIII); knots that are told must leave every condition
/// within its own B-spline (Schoenberg and Whitney). It is smooth up to the order below its degree.
pub const LAW: Law = Law {
    id: "bspline",
    group: Group::Free,
    parameters: &[Parameter {
        key: "degree",
        symbol: "n",
        quantity: Quantity::Ratio,
        default: Some(5.0),
        optional: true,
    }],
    shape: Shape::Free(Free { data: DataKind::Spline, first: at_rest, solve: pieces }),
};

/// Lowest degree with a continuous jerk, and the highest that is of use.
const DEGREES: std::ops::RangeInclusive<usize> = 4..=8;

/// Knots closer than this part of β are one, which would cost the curve a derivative.
const CLOSEST_KNOTS: f64 = 1e-6;

/// Most conditions.
pub const MAX_SPLINE_CONDITIONS: usize = 64;

fn pieces(given: &Given) -> Result<Solved, DataProblem> {
    let degree = DEGREES.clone().find(|&degree| degree as f64 == given.parameters[0]);
    let (min, max) = (*DEGREES.start() as f64, *DEGREES.end() as f64);
    let degree = degree.ok_or(DataProblem::Parameter { parameter: 0, min, max })?;
    let mut conditions = checked(given.data, given.beta, degree + 1..=MAX_SPLINE_CONDITIONS)?;
    let order_given: Vec<usize> = {
        let mut order: Vec<usize> = (0..conditions.len()).collect();
        order.sort_by(|&a, &b| {
            let (a, b) = (&conditions[a], &conditions[b]);
            a.at.total_cmp(&b.at).then(a.order.cmp(&b.order))
        });
        order
    };
    conditions = order_given.iter().map(|&k| conditions[k]).collect();
    let inner = match given.data {
        Data::Spline { knots, .. } => {
            told(knots, &conditions, degree, given.beta).map_err(|problem| match problem {
                DataProblem::KnotPlace { item, from, to, beta } => {
                    DataProblem::KnotPlace { item: order_given[item], from, to, beta }
                }
                other => other,
            })?
        }
        _ => means(&conditions, degree),
    };
    let knots = clamped(&inner, degree);
    let solution = solve(&conditions, |order, x| basis(&knots, degree, order, x));
    let (coefficients, condition) = solution.map_err(|problem| match problem {
        DataProblem::Dependent { items } => {
            let mut items: Vec<usize> = items.into_iter().map(|item| order_given[item]).collect();
            items.sort_unstable();
            DataProblem::Dependent { items }
        }
        other => other,
    })?;
    let spans = knots.windows(2).filter(|pair| pair[1] > pair[0]);
    let pieces =
        spans.map(|pair| Piece::between(pair[0], pair[1], taylor(&knots, &coefficients, degree, pair[0], pair[1])));
    Ok(Solved { pieces: pieces.collect(), condition })
}

/// The inner knots that a spline takes when none are told, as places along the segment, in the unit of β: each the mean of as many
/// neighbouring conditions as the degree (de Boor's averages). None where there are too few conditions for a spline.
#[must_use]
pub fn usual_knots(conditions: &[Condition], degree: usize, beta: f64) -> Vec<f64> {
    let mut sites: Vec<Condition> = conditions.to_vec();
    sites.sort_by(|a, b| a.at.total_cmp(&b.at));
    if sites.len() <= degree {
        Vec::new()
    } else {
        means(&sites, degree).iter().map(|knot| knot.clamp(0.0, beta)).collect()
    }
}

/// Inner knots for sites in order: each the mean of `degree` sites.
fn means(sites: &[Condition], degree: usize) -> Vec<f64> {
    let mean = |i: usize| sites[i..i + degree].iter().map(|site| site.at).sum::<f64>() / degree as f64;
    (1..sites.len() - degree).map(mean).collect()
}

/// Inner knots as they are told, checked against sites in order.
fn told(knots: &[f64], sites: &[Condition], degree: usize, beta: f64) -> Result<Vec<f64>, DataProblem> {
    let (found, expected) = (knots.len(), sites.len() - degree - 1);
    if found != expected {
        return Err(DataProblem::KnotCount { found, expected });
    }
    let inner: Vec<f64> = knots.iter().map(|knot| knot / beta).collect();
    let before = |knot: usize| if knot == 0 { 0.0 } else { inner[knot - 1] };
    // Written so that NaN is out of order too.
    let in_order = |&knot: &usize| inner[knot] - before(knot) > CLOSEST_KNOTS && 1.0 - inner[knot] > CLOSEST_KNOTS;
    if let Some(knot) = (0..found).find(|knot| !in_order(knot)) {
        return Err(DataProblem::KnotOrder { knot });
    }
    let all = clamped(&inner, degree);
    let outside = sites.iter().enumerate().find(|(i, site)| {
        let (from, to) = (all[*i], all[i + degree + 1]);
        site.at > 0.0 && site.at <= from || site.at < 1.0 && site.at >= to
    });
    match outside {
        Some((item, _)) => {
            let [from, to] = [all[item], all[item + degree + 1]].map(|knot| knot * beta);
            Err(DataProblem::KnotPlace { item, from, to, beta })
        }
        None => Ok(inner),
    }
}

/// All knots: each end as often as the order of the spline, so that it begins and ends there.
fn clamped(inner: &[f64], degree: usize) -> Vec<f64> {
    [&vec![0.0; degree + 1][..], inner, &vec![1.0; degree + 1]].concat()
}

/// The derivative of an order of every B-spline of a degree at x; on a knot, from the right.
fn basis(knots: &[f64], degree: usize, order: usize, x: f64) -> Vec<f64> {
    let share = |part: f64, from: f64, to: f64| if to > from { part / (to - from) } else { 0.0 };
    if order > degree {
        return vec![0.0; knots.len() - degree - 1];
    }
    if order > 0 {
        let lower = basis(knots, degree - 1, order - 1, x);
        let derivative = |i: usize| {
            let left = share(lower[i], knots[i], knots[i + degree]);
            left - share(lower[i + 1], knots[i + 1], knots[i + degree + 1])
        };
        return (0..lower.len() - 1).map(|i| degree as f64 * derivative(i)).collect();
    }
    let last = knots.partition_point(|&knot| knot < 1.0) - 1;
    let span = (knots.partition_point(|&knot| knot <= x).max(1) - 1).min(last);
    let mut values = vec![0.0; knots.len() - 1];
    values[span] = 1.0;
    for d in 1..=degree {
        for i in 0..values.len() - 1 {
            let left = share((x - knots[i]) * values[i], knots[i], knots[i + d]);
            values[i] = left + share((knots[i + d + 1] - x) * values[i + 1], knots[i + 1], knots[i + d + 1]);
        }
        values.pop();
    }
    values
}

/// The polynomial between two knots, in its own u ∈ [0, 1]: cₖ = s⁽ᵏ⁾·hᵏ/k! at its start.
fn taylor(knots: &[f64], coefficients: &[f64], degree: usize, from: f64, to: f64) -> Curve {
    let mut factor = 1.0;
    let terms: Vec<f64> = (0..=degree)
        .map(|order| {
            if order > 0 {
                factor *= (to - from) / order as f64;
            }
            let values = basis(knots, degree, order, from);
            factor * values.iter().zip(coefficients).map(|(value, coefficient)| value * coefficient).sum::<f64>()
        })
        .collect();
    Curve::polynomial(&terms)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(degree: f64, beta: f64, conditions: &[(f64, u8, f64)]) -> Result<Solved, DataProblem> {
        let conditions = conditions.iter().map(|&(at, order, value)| Condition { at, order, value }).collect();
        pieces(&Given { data: &Data::Conditions(conditions), beta, parameters: [degree, 0.0, 0.0], ..Given::default() })
    }

    fn at(solved: &Solved, x: f64) -> crate::Svaj {
        let piece = solved.pieces.iter().find(|piece| x < piece.until).or(solved.pieces.last());
        piece.expect("pieces").at(x)
    }

    /// At rest at both ends, and through points of a hump between them.
    fn hump(n: u8, beta: f64) -> Vec<(f64, u8, f64)> {
        let mut conditions: Vec<(f64, u8, f64)> = vec![(0.0, 0, 0.0), (0.0, 1, 0.0), (0.0, 2, 0.0)];
        conditions.extend((1..n).map(|k| {
            let x = f64::from(k) / f64::from(n);
            (x * beta, 0, 30.0 * (x * (1.0 - x)).powi(2) + f64::from(k % 3))
        }));
        conditions.extend([(beta, 0, 0.0), (beta, 1, 0.0), (beta, 2, 0.0)]);
        conditions
    }

    #[test]
    fn every_condition_is_met_and_the_joints_are_smooth() {
        for degree in [4.0, 5.0, 6.0, 7.0, 8.0] {
            for n in [6, 12, 58] {
                let conditions = hump(n, 3.0);
                let solved = solved(degree, 3.0, &conditions).expect("solved");
                let scale = |order: usize| {
                    (0..=300).map(|i| at(&solved, f64::from(i) / 300.0).order(order).abs()).fold(0.0, f64::max)
                };
                for &(place, order, value) in &conditions {
                    let found = at(&solved, place / 3.0).order(order.into());
                    let miss = (found - value * 3_f64.powi(order.into())).abs();
                    assert!(miss <= 1e-10 * scale(order.into()), "degree {degree}, {n}: {miss} at {place}");
                }
                for pair in solved.pieces.windows(2) {
                    let (left, right) = (pair[0].at(pair[0].until), pair[1].at(pair[0].until));
                    for order in 0..4 {
                        let miss = (left.order(order) - right.order(order)).abs();
                        assert!(miss <= 1e-10 * scale(order), "degree {degree}, {n}: order {order} jumps by {miss}");
                    }
                }
            }
        }
    }

    #[test]
    fn with_as_few_conditions_as_it_can_have_it_is_the_polynomial() {
        let conditions = [(0.0, 0, 0.0), (0.0, 1, 0.0), (0.0, 2, 0.0), (2.0, 0, 1.0), (2.0, 1, 0.0), (2.0, 2, 0.0)];
        let solved = solved(5.0, 2.0, &conditions).expect("solved");
        assert_eq!(solved.pieces.len(), 1);
        let found = solved.pieces[0].curve.coefficients().expect("a polynomial");
        for (found, expected) in found.iter().zip([0.0, 0.0, 0.0, 10.0, -15.0, 6.0]) {
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
    }

    fn knotted(degree: f64, conditions: &[(f64, u8, f64)], knots: &[f64]) -> Result<Solved, DataProblem> {
        let conditions = conditions.iter().map(|&(at, order, value)| Condition { at, order, value }).collect();
        let data = Data::Spline { conditions, knots: knots.to_vec() };
        pieces(&Given { data: &data, beta: 2.0, parameters: [degree, 0.0, 0.0], ..Given::default() })
    }

    #[test]
    fn knots_that_are_told_are_where_the_pieces_join() {
        let conditions = hump(4, 2.0);
        let usual = solved(5.0, 2.0, &conditions).expect("solved");
        let knots: Vec<f64> = usual.pieces[..usual.pieces.len() - 1].iter().map(|piece| piece.until * 2.0).collect();
        let sites: Vec<Condition> =
            conditions.iter().map(|&(at, order, value)| Condition { at, order, value }).collect();
        let named = usual_knots(&sites, 5, 2.0);
        assert!(named.len() == 3 && named.iter().zip(&knots).all(|(named, knot)| (named - knot).abs() < 1e-15));
        assert_eq!(knotted(5.0, &conditions, &knots).expect("the same").pieces.len(), usual.pieces.len());
        let moved = knotted(5.0, &conditions, &[0.5, 1.1, 1.4]).expect("other knots");
        assert!(
            moved.pieces.iter().zip([0.25, 0.55, 0.7, 1.0]).all(|(piece, until)| (piece.until - until).abs() < 1e-15)
        );
        for &(place, order, value) in &conditions {
            let found = at(&moved, place / 2.0).order(order.into()) / 2_f64.powi(order.into());
            assert!((found - value).abs() < 1e-10, "order {order} at {place}: {found}, not {value}");
        }
        for pair in moved.pieces.windows(2) {
            let (left, right) = (pair[0].at(pair[0].until), pair[1].at(pair[0].until));
            assert!((left.j - right.j).abs() < 1e-8 * (1.0 + left.j.abs()), "the jerk is continuous at a knot");
        }
    }

    #[test]
    fn knots_that_make_no_spline_are_refused() {
        let conditions = hump(4, 2.0);
        let refused = |knots: &[f64]| knotted(5.0, &conditions, knots).expect_err("refused");
        assert_eq!(refused(&[0.5]), DataProblem::KnotCount { found: 1, expected: 3 });
        assert_eq!(refused(&[0.5, 0.5, 1.0]), DataProblem::KnotOrder { knot: 1 });
        assert_eq!(refused(&[0.5, 1.0, 2.0]), DataProblem::KnotOrder { knot: 2 });
        assert_eq!(refused(&[f64::NAN, 1.0, 1.5]), DataProblem::KnotOrder { knot: 0 });
        // All knots beyond the last point: the first piece has six coefficients, and fourteen conditions lie on it.
        let late: Vec<f64> = (0..11).map(|k| 1.9 + 0.005 * f64::from(k)).collect();
        let wrong = knotted(5.0, &hump(12, 2.0), &late).expect_err("refused");
        assert!(matches!(wrong, DataProblem::KnotPlace { item: 6, .. }), "{wrong:?}");
    }

    #[test]
    fn what_makes_no_spline_is_refused() {
        let few = hump(2, 1.0);
        assert_eq!(
            solved(5.5, 1.0, &few).expect_err("a fraction"),
            DataProblem::Parameter { parameter: 0, min: 4.0, max: 8.0 }
        );
        assert_eq!(solved(8.0, 1.0, &few).expect_err("few"), DataProblem::Count { found: 7, min: 9, max: 64 });
    }
}
