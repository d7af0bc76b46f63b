//! The quintic spline through points: *v* and *a* at each, with which *j* and its derivative are continuous.

use crate::law::Condition;
use crate::law::conditions::solve;
use crate::series::chebyshev;
use crate::{Series, Svaj};
use nalgebra::{Matrix2, Vector2};

/// Points from which *v* and *a* at an open end are taken.
const NEAREST: usize = 6;

/// *v* and *a* at a point.
pub(super) type Slope = Vector2<f64>;

/// *v* and *a* at every point, those at the ends being given.
///
/// Continuity of *j* and of its derivative at each inner point are two equations in the slopes there and at both neighbours: a block-tridiagonal
/// system, which dominant blocks let be eliminated as it stands.
pub(super) fn clamped(z: &[f64], y: &[f64], start: Slope, end: Slope) -> Vec<Slope> {
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
pub(super) fn closed(z: &[f64], y: &[f64]) -> Vec<Slope> {
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
pub(super) fn estimated(z: &[f64], y: &[f64], at_end: bool) -> Slope {
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
