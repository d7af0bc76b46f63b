//! The smoothing spline: heights let go from the measured points, as far as they may on the average, to make the jerk small.
//!
//! Of all curves whose residuals have a given root mean square, it is the one with the least ∫j² (Reinsch's problem for the third derivative; its
//! answer is a quintic spline with its knots at the points). Written in heights and slopes at the points, that is a sum over the stretches between
//! them, K·x + μ·(x − measured) = 0 with μ the weight of the points, a block-tridiagonal system; μ is searched for.

use super::spline::{Slope, gap};
use nalgebra::{Matrix3, Vector3};

/// What the ends of a table are held to.
#[derive(Clone, Copy)]
pub(super) enum Ends {
    /// *v* and *a* at both, where they are known.
    Held(Option<Slope>, Option<Slope>),
    /// The end joins the start.
    Joined,
}

/// Height, *v* and *a* at a point.
type State = Vector3<f64>;

/// Weights of the points between which the one is searched for that leaves the residuals wanted: those of the smoothest curve, and of one that goes
/// through the points but for the rounding of their digits.
const WEIGHTS: [f64; 2] = [1e-9, 1e12];

/// The residuals wanted are met to this part.
const CLOSE_ENOUGH: f64 = 1e-9;

/// Steps of the search, which takes about ten.
const MOST_STEPS: usize = 60;

/// Heights at the points whose root mean square residual at the inner points is `tolerance`, with *v* and *a* at both ends; the smoothest there are
/// when no curve needs as much.
///
/// A unit of `z` is the mean distance of the points, which keeps the system's numbers of one size.
pub(super) fn smoothed(z: &[f64], measured: &[f64], ends: Ends, tolerance: f64) -> (Vec<f64>, Slope, Slope) {
    let inner = z.len().saturating_sub(2).max(1) as f64;
    let with = |weight: f64| {
        let states = relaxed(z, measured, ends, weight);
        let squares = states.iter().zip(measured).map(|(state, height)| (state[0] - height).powi(2));
        let residual = (squares.sum::<f64>() / inner).sqrt();
        (states, (residual / tolerance).clamp(f64::MIN_POSITIVE, f64::MAX).ln())
    };
    let [mut low, mut high] = WEIGHTS.map(f64::ln);
    let (smoothest, mut over) = with(WEIGHTS[0]);
    let mut states = smoothest;
    if over > 0.0 {
        let (closest, mut under) = with(WEIGHTS[1]);
        states = closest;
        // What is asked for may lie below the rounding that even the closest curve leaves. Else the residual falls as the weight grows:
        // regula falsi in logarithms, with Illinois's remedy for an end that stays.
        let steps = if under < 0.0 { MOST_STEPS } else { 0 };
        for _ in 0..steps {
            let weight = (low * under - high * over) / (under - over);
            let (next, excess) = with(weight.exp());
            states = next;
            if excess.abs() < CLOSE_ENOUGH {
                break;
            }
            if excess > 0.0 {
                (low, over, under) = (weight, excess, 0.5 * under);
            } else {
                (high, under, over) = (weight, excess, 0.5 * over);
            }
        }
    }
    let slope = |state: &State| Slope::new(state[1], state[2]);
    let (start, end) = (slope(&states[0]), slope(&states[states.len() - 1]));
    (states.iter().map(|state| state[0]).collect(), start, end)
}

/// The states with the least ∫j² + weight·Σ residual².
fn relaxed(z: &[f64], measured: &[f64], ends: Ends, weight: f64) -> Vec<State> {
    match ends {
        Ends::Held(start, end) => held(z, measured, [start, end], weight),
        Ends::Joined => {
            let with = |measured: &[f64], joint: Slope| {
                let states = held(z, measured, [Some(joint); 2], weight);
                let heights: Vec<f64> = states.iter().map(|state| state[0]).collect();
                let slopes: Vec<Slope> = states.iter().map(|state| Slope::new(state[1], state[2])).collect();
                let gap = gap(z, &heights, &slopes);
                (states, gap)
            };
            let flat = vec![0.0; measured.len()];
            let (plain, miss) = with(measured, Slope::zeros());
            let answers = [Slope::x(), Slope::y()].map(|unit| with(&flat, unit));
            let matrix = nalgebra::Matrix2::from_columns(&[answers[0].1, answers[1].1]);
            let joint = matrix.try_inverse().unwrap_or_else(nalgebra::Matrix2::zeros) * -miss;
            let sum = |k: usize| plain[k] + answers[0].0[k] * joint[0] + answers[1].0[k] * joint[1];
            (0..z.len()).map(sum).collect()
        }
    }
}

/// The same with the heights at both ends held to the points, and *v* and *a* where they are given. Where they are not, the curve bends there as
/// it likes: *j* and its derivative vanish.
fn held(z: &[f64], measured: &[f64], slopes: [Option<Slope>; 2], weight: f64) -> Vec<State> {
    let last = z.len() - 1;
    let mut here = vec![Matrix3::zeros(); last + 1];
    let mut lower = here.clone();
    let mut upper = here.clone();
    let mut known: Vec<State> = measured.iter().map(|height| State::new(weight * height, 0.0, 0.0)).collect();
    for k in 0..last {
        let stretch = stretch(z[k + 1] - z[k]);
        here[k] += stretch[0][0];
        upper[k] += stretch[0][1];
        lower[k + 1] += stretch[1][0];
        here[k + 1] += stretch[1][1];
    }
    for block in &mut here {
        block[(0, 0)] += weight;
    }
    for (k, slope) in [(0, slopes[0]), (last, slopes[1])] {
        let fixed = [Some(measured[k]), slope.map(|slope| slope[0]), slope.map(|slope| slope[1])];
        for (row, value) in fixed.into_iter().enumerate().filter_map(|(row, value)| Some((row, value?))) {
            for block in [&mut here[k], &mut lower[k], &mut upper[k]] {
                block.row_mut(row).fill(0.0);
            }
            here[k][(row, row)] = 1.0;
            known[k][row] = value;
        }
    }
    let mut reduced: Vec<(Matrix3<f64>, State)> = Vec::with_capacity(last + 1);
    for k in 0..=last {
        let (mut block, mut value) = (here[k], known[k]);
        if let Some((factor, before)) = reduced.last() {
            block -= lower[k] * factor;
            value -= lower[k] * before;
        }
        let inverse = block.try_inverse().unwrap_or_else(Matrix3::zeros);
        reduced.push((inverse * upper[k], inverse * value));
    }
    let mut states: Vec<State> = reduced.iter().map(|(_, value)| *value).collect();
    for k in (0..last).rev() {
        states[k] = states[k] - reduced[k].0 * states[k + 1];
    }
    states
}

/// The quadratic form ∫j² of a quintic over a stretch of length `h`, in the states at its two ends: four blocks.
fn stretch(h: f64) -> [[Matrix3<f64>; 2]; 2] {
    // Gauss's three points are exact for j², of the fourth degree.
    let off = 0.6_f64.sqrt() / 2.0;
    let mut blocks = [[Matrix3::zeros(); 2]; 2];
    for (u, part) in [(0.5 - off, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.5 + off, 5.0 / 18.0)] {
        let powers = |constant: f64, first: f64, second: f64| constant + u * (first + u * second);
        let (h2, h3) = (h * h, h * h * h);
        // The third derivatives of Hermite's quintics.
        let start = State::new(
            powers(-60.0, 360.0, -360.0) / h3,
            powers(-36.0, 192.0, -180.0) / h2,
            powers(-9.0, 36.0, -30.0) / h,
        );
        let end = State::new(
            powers(60.0, -360.0, 360.0) / h3,
            powers(-24.0, 168.0, -180.0) / h2,
            powers(3.0, -24.0, 30.0) / h,
        );
        let ends = [start, end];
        for (row, one) in ends.iter().enumerate() {
            for (column, other) in ends.iter().enumerate() {
                blocks[row][column] += one * other.transpose() * (part * h);
            }
        }
    }
    blocks
}
