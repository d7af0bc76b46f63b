//! Tables that are met, smoothed, closed and refused.

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

#[test]
fn the_jerk_of_the_largest_table_is_not_drowned_in_rounding() {
    let points: Vec<[f64; 2]> = (0..MAX_POINTS)
        .map(|k| TAU * k as f64 / (MAX_POINTS - 1) as f64)
        .map(|at| [at, 0.5 * (1.0 - at.cos())])
        .collect();
    let pieces = solved(points, true, false);
    for piece in &pieces {
        let x = 0.5 * (piece.until - piece.span) + 0.5 * piece.until;
        let jerk = piece.at(x).j / TAU.powi(3);
        assert!((jerk + 0.5 * (TAU * x).sin()).abs() < 1e-6, "jerk {jerk} at {x}");
    }
}
