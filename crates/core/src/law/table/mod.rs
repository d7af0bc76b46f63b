//! Measured points, joined by the spline that is smooth up to its fourth derivative.

mod smoothing;
mod spline;
#[cfg(test)]
mod tests;

use super::matched::matched_polynomial;
use super::{Data, DataKind, DataProblem, Free, Given, Group, Law, Piece, Shape, Solved};
use crate::{Parameter, Quantity, Svaj};
use smoothing::{Ends, smoothed};
use spline::{Slope, clamped, closed, estimated};

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

/// Most points. The rounding of heights appears in the jerk multiplied by the cube of their number: at the limit, in a table of a whole
/// turn, some 10⁻⁷ of the lift per radian³, which is below the last digit of anything measured.
pub const MAX_POINTS: usize = 1024;

/// Points closer than this part of β are one.
const CLOSEST: f64 = 1e-6;

/// A place this close to an end of the segment (parts of it) is the end.
const AT_AN_END: f64 = 1e-12;

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
