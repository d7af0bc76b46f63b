//! How large the derivatives of a joining are, and how low it goes.

use super::leg::Leg;
use crate::Svaj;
use crate::search::root;

/// Places at which a piece is looked at.
const LOOKS: usize = 64;

/// Peaks of |v|, |a| and |j| over legs, and the lowest height.
pub(super) fn figures(legs: &[Leg]) -> ([f64; 3], f64) {
    let mut peaks = [0.0_f64; 3];
    let mut lowest = f64::INFINITY;
    for leg in legs {
        let mut from = 0.0;
        for piece in &leg.pieces {
            let motion = |x: f64| piece.at(x).stretched(leg.segment.beta);
            let step = (piece.until - from) / LOOKS as f64;
            let looks: Vec<Svaj> = (0..=LOOKS).map(|i| motion(from + step * i as f64)).collect();
            for (order, peak) in (1..).zip(&mut peaks) {
                let size = |i: usize| looks[i].order(order).abs();
                let best = (0..=LOOKS).max_by(|&i, &k| size(i).total_cmp(&size(k))).unwrap_or(0);
                // The peak is that of the parabola through the greatest and its neighbours.
                let top = if (1..LOOKS).contains(&best) {
                    let (left, here, right) = (size(best - 1), size(best), size(best + 1));
                    let bend = left - 2.0 * here + right;
                    if bend < 0.0 { here - (right - left).powi(2) / (8.0 * bend) } else { here }
                } else {
                    size(best)
                };
                *peak = peak.max(top);
            }
            lowest = lowest.min(bottom(from, piece.until, motion));
            from = piece.until;
        }
    }
    (peaks, lowest)
}

/// The lowest height between two places: at a look, or in a valley between two, where the velocity changes its sign.
///
/// Towards both ends the looks halve their distance from it: what comes to rest on the base circle may do so from below, in a valley as
/// shallow as the third power of its length.
fn bottom(from: f64, until: f64, motion: impl Fn(f64) -> Svaj) -> f64 {
    const HALVINGS: i32 = 20;
    let step = (until - from) / LOOKS as f64;
    let near = (1..=HALVINGS).map(|k| step * 0.5_f64.powi(k));
    let evenly = (1..LOOKS).map(|i| from + step * i as f64);
    let places = near.clone().rev().map(|apart| from + apart).chain(evenly).chain(near.map(|apart| until - apart));
    let looks: Vec<(f64, Svaj)> = std::iter::once(from).chain(places).chain([until]).map(|x| (x, motion(x))).collect();
    let valleys = looks.windows(2).filter(|pair| pair[0].1.v < 0.0 && pair[1].1.v > 0.0);
    let valleys = valleys.map(|pair| motion(root(pair[0].0, pair[1].0, |x| motion(x).v)).s);
    looks.iter().map(|look| look.1.s).chain(valleys).fold(f64::INFINITY, f64::min)
}
