//! Measured points, joined by the spline that is smooth up to its fourth derivative.

use super::conditions::solve;
use super::matched::matched_polynomial;
use super::smoothing::{Ends, smoothed};
use super::{Condition, Data, DataKind, DataProblem, Free, Given, Group, Law, Piece, Shape, Solved};
use crate::series::chebyshev;
use crate::{Parameter, Quantity, Series, Svaj};
use nalgebra::{Matrix2, Vector2};

/// The interpolating quintic spline (C⁴): between two points, the quintic with *s*, *v*, *a* at both; *v* and *a* are those with which *j* and its
/// derivative are continuous as well. At its ends it takes *v* and *a* from its neighbours; where it cannot, from the six points nearest; and one
/// table that covers the whole turn joins itself. With a `smoothing` it misses the inner points by as much on the average (root mean square), and has
/// the least jerk that this allows.
pub const LAW: Law = Law {
    id: "table",
    group: Group::Free,
    parameters: &[Parameter {
        key: "smoothing",
        symbol: "δ",
        quantity: Quantity::Height,
        default: Some(0.0),
        optional: true,
    }],
    shape: Shape::Free(Free { data: DataKind::Points, first: few, solve: pieces }),
};

/// Most points: with more of them the jerk, which goes with the cube of their number, would drown in rounding.
pub const MAX_POINTS: usize = 128;

/// Points closer than this part of β are one.
const CLOSEST: f64 = 1e-6;

/// A place this close to an end of the segment (parts of it) is the end.
const AT_AN_END: f64 = 1e-12;

/// Points from which *v* and *a* at an open end are taken.
const NEAREST: usize = 6;

/// *v* and *a* at a point.
pub(super) type Slope = Vector2<f64>;

fn pieces(given: &Given) -> Result<Solved, DataProblem> {
    let points = checked(given)?;
    let last = points.len() - 1;
    // A unit of z is the mean distance of the points.
    let unit = 1.0 / last as f64;
    let z: Vec<f64> = points.iter().map(|point| point[0] / unit).collect();
    let mut heights: Vec<f64> = points.iter().map(|point| point[1]).collect();
    let in_z = |motion: Svaj| {
        let step = given.beta * unit;
        Slope::new(motion.v * step, motion.a * step * step)
    };
    let tolerance = given.parameters[0];
    // Written so that NaN is refused too.
    if !(tolerance >= 0.0 && tolerance.is_finite()) {
        return Err(DataProblem::Parameter { parameter: 0, min: 0.0, max: f64::MAX });
    }
    let ends = [given.before, given.after].map(|end| end.map(in_z));
    let slopes = if tolerance > 0.0 {
        let ends = if given.alone { Ends::Joined } else { Ends::Held(ends[0], ends[1]) };
        let (let_go, start, end) = smoothed(&z, &heights, ends, tolerance);
        heights = let_go;
        // Once more through the heights found, which leaves the curve as smooth as one through the points.
        if given.alone { closed(&z, &heights) } else { clamped(&z, &heights, start, end) }
    } else if given.alone {
        closed(&z, &heights)
    } else {
        let start = ends[0].unwrap_or_else(|| estimated(&z, &heights, false));
        let end = ends[1].unwrap_or_else(|| estimated(&z, &heights, true));
        clamped(&z, &heights, start, end)
    };
    let piece = |k: usize| {
        let (from, until) = (points[k][0], points[k + 1][0]);
        let step = z[k + 1] - z[k];
        let end = |i: usize| Svaj::new(heights[i], slopes[i][0] * step, slopes[i][1] * step * step, 0.0);
        Piece::between(from, until, matched_polynomial(3, end(k), end(k + 1)))
    };
    Ok(Solved { pieces: (0..last).map(piece).collect(), condition: 1.0 })
}

/// The points with their places as parts of β.
fn checked(given: &Given) -> Result<Vec<[f64; 2]>, DataProblem> {
    let Data::Points(points) = given.data else { return Err(DataProblem::Kind) };
    let found = points.len();
    if !(2..=MAX_POINTS).contains(&found) {
        return Err(DataProblem::Count { found, min: 2, max: MAX_POINTS });
    }
    if let Some(item) = points.iter().position(|point| !point.iter().all(|value| value.is_finite())) {
        return Err(DataProblem::NotFinite { item });
    }
    let mut scaled: Vec<[f64; 2]> = points.iter().map(|point| [point[0] / given.beta, point[1]]).collect();
    for (item, end) in [(0, 0.0), (found - 1, 1.0)] {
        if (scaled[item][0] - end).abs() > AT_AN_END {
            return Err(DataProblem::NotAtEnd {
                item,
                found: points[item][0],
                expected: end * given.beta,
                beta: given.beta,
            });
        }
        scaled[item][0] = end;
    }
    match scaled.windows(2).position(|pair| pair[1][0] - pair[0][0] < CLOSEST) {
        Some(before) => Err(DataProblem::Unordered { item: before + 1 }),
        None => Ok(scaled),
    }
}

/// *v* and *a* at every point, those at the ends being given.
///
/// Continuity of *j* and of its derivative at each inner point are two equations in the slopes there and at both neighbours: a block-tridiagonal
/// system, which dominant blocks let be eliminated as it stands.
fn clamped(z: &[f64], y: &[f64], start: Slope, end: Slope) -> Vec<Slope> {
    let last = z.len() - 1;
    let mut slopes = vec![start; z.len()];
    slopes[last] = end;
    let mut reduced: Vec<(Matrix2<f64>, Slope)> = Vec::with_capacity(last);
    for i in 1..last {
        let (l, r) = (z[i] - z[i - 1], z[i + 1] - z[i]);
        let (dl, dr) = (y[i] - y[i - 1], y[i + 1] - y[i]);
        let lower = Matrix2::new(-24.0 / (l * l), -3.0 / l, -168.0 / l.powi(3), -24.0 / (l * l));
        let upper = Matrix2::new(24.0 / (r * r), -3.0 / r, -168.0 / r.powi(3), 24.0 / (r * r));
        let mut here = Matrix2::new(
            36.0 / (r * r) - 36.0 / (l * l),
            9.0 / l + 9.0 / r,
            -192.0 / l.powi(3) - 192.0 / r.powi(3),
            36.0 / (l * l) - 36.0 / (r * r),
        );
        let mut known =
            Slope::new(60.0 * (dr / r.powi(3) - dl / l.powi(3)), -360.0 * (dl / l.powi(4) + dr / r.powi(4)));
        match reduced.last() {
            Some((factor, value)) => {
                here -= lower * factor;
                known -= lower * value;
            }
            None => known -= lower * start,
        }
        if i + 1 == last {
            known -= upper * end;
        }
        let inverse = here.try_inverse().unwrap_or_else(Matrix2::zeros);
        reduced.push((inverse * upper, inverse * known));
    }
    for i in (1..last).rev() {
        let (factor, value) = &reduced[i - 1];
        slopes[i] = if i + 1 == last { *value } else { value - factor * slopes[i + 1] };
    }
    slopes
}

/// The same for a curve that closes: the slope at the joint is the one with which *j* and its derivative agree across it.
fn closed(z: &[f64], y: &[f64]) -> Vec<Slope> {
    let flat = vec![0.0; y.len()];
    let with = |y: &[f64], joint: Slope| {
        let slopes = clamped(z, y, joint, joint);
        let gap = gap(z, y, &slopes);
        (slopes, gap)
    };
    let (plain, miss) = with(y, Slope::zeros());
    let answers = [Slope::x(), Slope::y()].map(|unit| with(&flat, unit));
    let matrix = Matrix2::from_columns(&[answers[0].1, answers[1].1]);
    let joint = matrix.try_inverse().unwrap_or_else(Matrix2::zeros) * -miss;
    let sum = |k: usize| plain[k] + answers[0].0[k] * joint[0] + answers[1].0[k] * joint[1];
    (0..z.len()).map(sum).collect()
}

/// What *j* and its derivative gain from the end of a curve to its start.
pub(super) fn gap(z: &[f64], y: &[f64], slopes: &[Slope]) -> Slope {
    let last = z.len() - 1;
    let (h, d) = (z[1] - z[0], y[1] - y[0]);
    let (p, q) = (slopes[0], slopes[1]);
    let start = Slope::new(
        60.0 * d / h.powi(3) - (36.0 * p[0] + 24.0 * q[0]) / (h * h) - (9.0 * p[1] - 3.0 * q[1]) / h,
        -360.0 * d / h.powi(4) + (192.0 * p[0] + 168.0 * q[0]) / h.powi(3) + (36.0 * p[1] - 24.0 * q[1]) / (h * h),
    );
    let (h, d) = (z[last] - z[last - 1], y[last] - y[last - 1]);
    let (p, q) = (slopes[last - 1], slopes[last]);
    let end = Slope::new(
        60.0 * d / h.powi(3) - (24.0 * p[0] + 36.0 * q[0]) / (h * h) - (3.0 * p[1] - 9.0 * q[1]) / h,
        360.0 * d / h.powi(4) - (168.0 * p[0] + 192.0 * q[0]) / h.powi(3) - (24.0 * p[1] - 36.0 * q[1]) / (h * h),
    );
    start - end
}

/// *v* and *a* at an end, by the polynomial through the points nearest to it.
fn estimated(z: &[f64], y: &[f64], at_end: bool) -> Slope {
    let n = z.len().min(NEAREST);
    let from = if at_end { z.len() - n } else { 0 };
    let span = z[from + n - 1] - z[from];
    let point = |k: usize| Condition { at: (z[k] - z[from]) / span, order: 0, value: y[k] };
    let points: Vec<Condition> = (from..from + n).map(point).collect();
    let through = solve(&points, |order, x| chebyshev(n, order, 2.0 * x - 1.0));
    let motion = through.map_or_else(
        |_| Svaj::default(),
        |(coefficients, _)| Series::new(&coefficients).at(if at_end { 1.0 } else { 0.0 }).stretched(span),
    );
    Slope::new(motion.v, motion.a)
}

/// Seven points of a cycloidal.
fn few(beta: f64, start: f64, rise: f64) -> Data {
    const PARTS: u8 = 6;
    let point = |k: u8| {
        let x = f64::from(k) / f64::from(PARTS);
        let y = x - (std::f64::consts::TAU * x).sin() / std::f64::consts::TAU;
        [beta * x, start + rise * (y * 1e4).round() / 1e4]
    };
    Data::Points((0..=PARTS).map(point).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn solved(points: Vec<[f64; 2]>, alone: bool, rest: bool) -> Vec<Piece> {
        let beta = points.last().expect("points")[0];
        let rest = rest.then(Svaj::default);
        let given = Given { data: &Data::Points(points), beta, before: rest, after: rest, alone, ..Given::default() };
        pieces(&given).expect("solved").pieces
    }

    fn assert_smooth(pieces: &[Piece]) {
        let scales: [f64; 4] = std::array::from_fn(|order| {
            pieces.iter().map(|piece| piece.at(piece.until).order(order).abs()).fold(0.0, f64::max)
        });
        for pair in pieces.windows(2) {
            let (left, right) = (pair[0].at(pair[0].until), pair[1].at(pair[0].until));
            for (order, scale) in scales.iter().enumerate() {
                let miss = (left.order(order) - right.order(order)).abs();
                // Rounding of the heights, over the powers of the distance: what a program allows for.
                let rounding = 64.0 * f64::EPSILON * 25.0 / pair[1].span.min(pair[0].span).powi(order as i32);
                assert!(miss <= 1e-10 * scale + rounding, "order {order} jumps by {miss} of {scale}");
            }
        }
    }

    /// Uneven places from 0 to β.
    fn places(n: usize, beta: f64) -> Vec<f64> {
        let uneven = |k: usize| (k as f64 + 0.3 * (k as f64 * 2.1).sin()) / (n - 1) as f64;
        let (first, last) = (uneven(0), uneven(n - 1));
        (0..n).map(|k| if k + 1 == n { beta } else { beta * (uneven(k) - first) / (last - first) }).collect()
    }

    #[test]
    fn a_table_of_sixty_points_is_met_and_smooth() {
        let cycloidal = |x: f64| x - (TAU * x).sin() / TAU;
        for n in [60, MAX_POINTS] {
            let points: Vec<[f64; 2]> = places(n, 2.0).iter().map(|&at| [at, 25.0 * cycloidal(at / 2.0)]).collect();
            let pieces = solved(points.clone(), false, true);
            assert_smooth(&pieces);
            for (piece, point) in pieces.iter().zip(&points) {
                assert!((piece.at(point[0] / 2.0).s - point[1]).abs() <= 1e-12 * 25.0, "{point:?}");
            }
            // Between the points it is as close to the law that was measured as the sixth power of their distance.
            let worst = (0..1000).map(|i| f64::from(i) / 1000.0).map(|x| {
                let piece = pieces.iter().find(|piece| x < piece.until).expect("inside");
                (piece.at(x).s - 25.0 * cycloidal(x)).abs()
            });
            assert!(worst.fold(0.0, f64::max) < 1e-6 * 25.0);
        }
    }

    #[test]
    fn a_table_of_the_whole_turn_joins_itself() {
        let wave = |x: f64| 5.0 - 4.0 * (TAU * x).cos() - (2.0 * TAU * x).sin();
        let points: Vec<[f64; 2]> = places(36, TAU).iter().map(|&at| [at, wave(at / TAU)]).collect();
        let pieces = solved(points, true, false);
        assert_smooth(&pieces);
        let (start, end) = (pieces[0].at(0.0), pieces[pieces.len() - 1].at(1.0));
        for order in 0..4 {
            let miss = (start.order(order) - end.order(order)).abs();
            assert!(miss < 1e-7, "order {order} jumps by {miss} where the turn closes");
        }
    }

    #[test]
    fn a_polynomial_of_the_fifth_degree_comes_back_from_its_points() {
        let quintic = |x: f64| 10.0 * x.powi(3) - 15.0 * x.powi(4) + 6.0 * x.powi(5);
        let points: Vec<[f64; 2]> = places(12, 1.0).iter().map(|&at| [at, quintic(at)]).collect();
        for piece in solved(points, false, false) {
            let x = piece.until - 0.01;
            assert!((piece.at(x).s - quintic(x)).abs() < 1e-12, "at {x}");
            assert!((piece.at(x).j - (60.0 - 360.0 * x + 360.0 * x * x)).abs() < 1e-7, "jerk at {x}");
        }
    }

    /// A cycloidal with an error of measurement that has no pattern a curve could follow.
    fn noisy(n: usize, size: f64) -> Vec<[f64; 2]> {
        let noise = |k: usize| if k == 0 || k + 1 == n { 0.0 } else { size * (k as f64 * k as f64 * 1.7).sin() };
        let cycloidal = |x: f64| x - (TAU * x).sin() / TAU;
        let point = |(k, at): (usize, &f64)| [*at, 25.0 * cycloidal(at / 2.0) + noise(k)];
        places(n, 2.0).iter().enumerate().map(point).collect()
    }

    fn smoothed_by(points: &[[f64; 2]], tolerance: f64, rest: bool, alone: bool) -> Vec<Piece> {
        let rest = rest.then(Svaj::default);
        let (data, beta) = (Data::Points(points.to_vec()), points.last().expect("points")[0]);
        let parameters = [tolerance, 0.0, 0.0];
        let given = Given { data: &data, beta, before: rest, after: rest, alone, parameters, ..Given::default() };
        pieces(&given).expect("solved").pieces
    }

    fn residuals(pieces: &[Piece], points: &[[f64; 2]]) -> Vec<f64> {
        let beta = points.last().expect("points")[0];
        let at = |x: f64| pieces.iter().find(|piece| x < piece.until).or(pieces.last()).expect("a piece").at(x).s;
        points.iter().map(|point| at(point[0] / beta) - point[1]).collect()
    }

    fn greatest_jerk(pieces: &[Piece]) -> f64 {
        let at = |x: f64| pieces.iter().find(|piece| x < piece.until).or(pieces.last()).expect("a piece").at(x).j;
        (0..=2000).map(|i| at(f64::from(i) / 2000.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn a_smoothed_table_misses_its_points_by_as_much_as_it_may() {
        for (n, rest) in [(20, true), (60, true), (60, false), (MAX_POINTS, true)] {
            let points = noisy(n, 0.02);
            let mut jerk = f64::INFINITY;
            for tolerance in [1e-4, 1e-3, 0.01] {
                let pieces = smoothed_by(&points, tolerance, rest, false);
                assert_smooth(&pieces);
                let residuals = residuals(&pieces, &points);
                let mean = residuals.iter().map(|r| r * r).sum::<f64>() / (n - 2) as f64;
                assert!((mean.sqrt() / tolerance - 1.0).abs() < 1e-6, "{n} points: {} of {tolerance}", mean.sqrt());
                assert!(residuals[0].abs() < 1e-12 && residuals[n - 1].abs() < 1e-12, "the ends stay");
                let now = greatest_jerk(&pieces);
                assert!(now < jerk, "{n} points, {tolerance}: {now} after {jerk}");
                jerk = now;
            }
        }
    }

    #[test]
    fn the_smoothest_curve_between_rests_is_the_3_4_5() {
        // Of all curves from rest to rest the 3-4-5 has the least ∫j²: its sixth derivative vanishes, as Euler's equation demands.
        let points = noisy(30, 0.02);
        for piece in smoothed_by(&points, 1e3, true, false) {
            let x = piece.until - 0.01;
            let expected = 25.0 * (10.0 * x.powi(3) - 15.0 * x.powi(4) + 6.0 * x.powi(5));
            assert!((piece.at(x).s - expected).abs() < 1e-5, "{} at {x}, not {expected}", piece.at(x).s);
        }
    }

    #[test]
    fn smoothing_brings_the_measured_law_back() {
        let points = noisy(60, 0.02);
        let error = |pieces: &[Piece]| {
            let at = |x: f64| pieces.iter().find(|piece| x < piece.until).or(pieces.last()).expect("a piece").at(x).a;
            let miss = (0..=1000).map(|i| f64::from(i) / 1000.0).map(|x| at(x) - 25.0 * TAU * (TAU * x).sin());
            miss.map(f64::abs).fold(0.0, f64::max)
        };
        let (through, smooth) =
            (error(&smoothed_by(&points, 0.0, true, false)), error(&smoothed_by(&points, 0.0135, true, false)));
        assert!(smooth < 0.05 * through, "acceleration misses by {smooth}, and by {through} without smoothing");
    }

    #[test]
    fn a_smoothed_table_of_the_whole_turn_joins_itself() {
        let wave = |x: f64| 5.0 - 5.0 * (TAU * x).cos();
        let noise = |k: usize| if k == 0 || k == 71 { 0.0 } else { 0.01 * (k as f64 * k as f64 * 1.7).sin() };
        let point = |(k, at): (usize, &f64)| [*at, wave(at / TAU) + noise(k)];
        let points: Vec<[f64; 2]> = places(72, TAU).iter().enumerate().map(point).collect();
        let pieces = smoothed_by(&points, 0.005, false, true);
        assert_smooth(&pieces);
        let (start, end) = (pieces[0].at(0.0), pieces[pieces.len() - 1].at(1.0));
        for order in 0..4 {
            let miss = (start.order(order) - end.order(order)).abs();
            assert!(miss < 1e-6, "order {order} jumps by {miss} where the turn closes");
        }
        let residuals = residuals(&pieces, &points);
        let mean = residuals.iter().map(|r| r * r).sum::<f64>() / 70.0;
        assert!((mean.sqrt() / 0.005 - 1.0).abs() < 1e-6, "{}", mean.sqrt());
    }

    #[test]
    fn a_smoothing_below_all_rounding_goes_through_the_points() {
        for (least, alone) in [(5e-324, false), (1e-300, true), (1e-18, false)] {
            let mut points = noisy(9, 0.02);
            points[8][1] = if alone { points[0][1] } else { points[8][1] };
            let pieces = smoothed_by(&points, least, !alone, alone);
            let worst = residuals(&pieces, &points)
                .into_iter()
                .map(f64::abs)
                .fold(0.0, |worst, r| if r > worst || r.is_nan() { r } else { worst });
            assert!(worst < 1e-9 * 25.0, "{least:e} leaves {worst:e}");
        }
    }

    #[test]
    fn a_smoothing_below_nothing_is_refused() {
        for bad in [-0.1, f64::NAN, f64::INFINITY] {
            let (data, parameters) = (Data::Points(noisy(9, 0.0)), [bad, 0.0, 0.0]);
            let refused = pieces(&Given { data: &data, beta: 2.0, parameters, ..Given::default() });
            assert!(matches!(refused, Err(DataProblem::Parameter { parameter: 0, .. })), "{bad}");
        }
    }

    #[test]
    fn tables_that_make_no_curve_are_refused() {
        let refused = |points: Vec<[f64; 2]>| {
            pieces(&Given { data: &Data::Points(points), beta: 2.0, ..Given::default() }).expect_err("refused")
        };
        assert_eq!(refused(vec![[0.0, 0.0]]), DataProblem::Count { found: 1, min: 2, max: MAX_POINTS });
        assert_eq!(refused(vec![[0.0, 0.0], [1.0, 1.0], [1.0, 2.0], [2.0, 0.0]]), DataProblem::Unordered { item: 2 });
        assert_eq!(refused(vec![[0.0, 0.0], [f64::NAN, 0.0], [2.0, 0.0]]), DataProblem::NotFinite { item: 1 });
        assert_eq!(
            refused(vec![[0.0, 0.0], [1.5, 0.0]]),
            DataProblem::NotAtEnd { item: 1, found: 1.5, expected: 2.0, beta: 2.0 }
        );
    }
}
