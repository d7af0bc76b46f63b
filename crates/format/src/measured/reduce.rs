//! Fewer points of a measured curve, with which the spline of the table law stays close to all of them.
//!
//! The points that are kept are points of the measurement. Beginning with a few, the stretches between two of them on which the spline
//! misses the measurement most are halved, some at a time, until there are as many points as asked for or the spline is close enough.

use levalab_core::law::{Data, Given};
use levalab_core::{Law, Svaj};

/// What the spline joins at its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends {
    /// Neighbours whose motion is not known.
    Free,
    /// The motion of the neighbours, where it is known, per unit of the places.
    Held(Option<Svaj>, Option<Svaj>),
    /// Itself.
    Joined,
}

/// A reduced curve, and how far its spline is from the points that it was made from.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduced {
    /// The points that are kept.
    pub points: Vec<[f64; 2]>,
    /// The largest residual, curve − point, by its size.
    pub residual: f64,
    /// Where it is.
    pub at: f64,
}

/// Points that every reduction begins with, as evenly spread as they lie.
const FIRST_POINTS: usize = 5;

/// One stretch for so many points is halved at a time.
const HALVED_AT_ONCE: usize = 8;

/// Stretches are halved together when they miss by this part of the largest residual or more.
const SIMILAR: f64 = 0.5;

/// The points of a curve that are kept: `count` of them, or fewer when the spline then misses by no more than `within`.
///
/// There are two points at least, and no more than there are.
#[must_use]
pub fn reduce(points: &[[f64; 2]], ends: Ends, count: usize, within: f64) -> Reduced {
    let all = points.len();
    let count = count.clamp(2.min(all), all);
    let begin = FIRST_POINTS.min(count);
    let mut kept: Vec<usize> = (0..begin).map(|k| k * (all - 1) / (begin - 1).max(1)).collect();
    kept.dedup();
    loop {
        let residuals = residuals(points, &kept, ends);
        let size = |k: usize| residuals[k].abs();
        let worst = (0..all).fold(0, |worst, k| if size(k) > size(worst) { k } else { worst });
        if kept.len() >= count || size(worst) <= within {
            let at = points.get(worst).map_or(0.0, |point| point[0]);
            let residual = residuals.get(worst).copied().unwrap_or(0.0);
            return Reduced { points: kept.into_iter().map(|k| points[k]).collect(), residual, at };
        }
        let stretch = |pair: &[usize]| (pair[0] + 1..pair[1]).map(size).fold(0.0, f64::max);
        let mut open: Vec<(f64, usize)> = kept
            .windows(2)
            .filter(|pair| pair[1] - pair[0] > 1)
            .map(|pair| (stretch(pair), usize::midpoint(pair[0], pair[1])))
            .collect();
        open.sort_by(|one, other| other.0.total_cmp(&one.0));
        let least = SIMILAR * open.first().map_or(0.0, |first| first.0);
        let most = (kept.len() / HALVED_AT_ONCE).max(1).min(count - kept.len());
        kept.extend(open.iter().take(most).filter(|stretch| stretch.0 >= least).map(|stretch| stretch.1));
        kept.sort_unstable();
    }
}

/// What the spline through the kept points misses each point by, curve − point.
fn residuals(points: &[[f64; 2]], kept: &[usize], ends: Ends) -> Vec<f64> {
    let none = || vec![0.0; points.len()];
    let (Some(&[start, _]), Some(&[end, _])) = (points.first(), points.last()) else { return none() };
    let beta = end - start;
    let table: Vec<[f64; 2]> = kept.iter().map(|&k| [points[k][0] - start, points[k][1]]).collect();
    let (before, after) = match ends {
        Ends::Held(before, after) => (before, after),
        Ends::Free | Ends::Joined => (None, None),
    };
    let data = Data::Points(table);
    let given = Given { data: &data, beta, before, after, alone: ends == Ends::Joined, ..Given::default() };
    let Some(solved) = Law::by_id("table").and_then(Law::free).and_then(|free| (free.solve)(&given).ok()) else {
        return none();
    };
    let mut pieces = solved.pieces.iter().peekable();
    let residual = |&[at, s]: &[f64; 2]| {
        let x = (at - start) / beta;
        while pieces.next_if(|piece| piece.until < x && piece.until < 1.0).is_some() {}
        pieces.peek().map_or(0.0, |piece| piece.at(x).s - s)
    };
    points.iter().map(residual).collect()
}
