//! ρ where the profile is convex in part and hollow in part: where one passes into the other, and the flattest place of each.

use crate::samples::{Quantity, Samples};
use crate::search::{root, summit};
use crate::{Cam, Extremes};
use std::f64::consts::TAU;

/// Curvature smaller than this part of its maximum is rounding, and has no sign: the profile is straight there.
const STRAIGHT: f64 = 1e-12;

/// θ of the flattest place is refined to this (radians, or the same part of a travel).
const THETA_TOLERANCE: f64 = 1e-8;

/// Where the curvature of a disc's profile changes its sign, in the order of θ.
pub(super) struct Inflections {
    /// Their places; each between 0 and the end of the cycle.
    pub places: Vec<f64>,
    /// θ of the first one where the curvature is zero, so that ρ has no bounds; none when every change of sign is a jump.
    pub straight: Option<f64>,
}

/// The places where the profile under a disc passes from convex to hollow or back: the zeros of the curvature of the pitch curve, the beginnings of
/// straight parts between a convex and a hollow one, and the joints where the curvature jumps past zero.
pub(super) fn inflections(cam: &Cam, samples: &Samples) -> Inflections {
    let mut found = Inflections { places: Vec::new(), straight: None };
    if cam.follower.is_flat() {
        return found;
    }
    let bends = samples.of_all(Quantity::Bend);
    let floor = STRAIGHT * bends.iter().fold(0.0_f64, |most, bend| most.max(bend.abs()));
    let sign = |bend: f64| {
        if bend.abs() <= floor {
            0_i8
        } else if bend > 0.0 {
            1
        } else {
            -1
        }
    };
    let mut note = |theta: f64, straight: bool| {
        found.places.push(theta);
        found.straight = found.straight.or(straight.then_some(theta));
    };
    // The last sign met, and where the profile became straight after it.
    let mut last: Option<(i8, f64)> = samples_before(cam, bends, samples, sign);
    let mut level_from: Option<f64> = None;
    for (k, span) in samples.spans.iter().enumerate() {
        let stretch = &cam.program.stretches()[k];
        let bend = |theta: f64| Quantity::Bend.at(cam, stretch, theta);
        for i in span.clone() {
            let (theta, here) = (samples.theta[i], sign(bends[i]));
            if here == 0 {
                level_from = level_from.or(Some(theta));
                continue;
            }
            if let Some((before, at)) = last.filter(|last| last.0 == -here) {
                debug_assert!(before != here);
                match level_from {
                    Some(from) => note(from, true),
                    None if i == span.start => note(theta, false),
                    None => note(root(at, theta, bend), true),
                }
            }
            (last, level_from) = (Some((here, theta)), None);
        }
    }
    for place in &mut found.places {
        *place = if cam.program.is_cyclic() && *place >= TAU { *place - TAU } else { *place };
    }
    found.places.sort_by(f64::total_cmp);
    found.places.dedup();
    found
}

/// The sign with which the turn ends, since it goes on at θ = 0; none for a travel.
fn samples_before(cam: &Cam, bends: &[f64], samples: &Samples, sign: impl Fn(f64) -> i8) -> Option<(i8, f64)> {
    let last = (0..bends.len()).rev().find(|&i| sign(bends[i]) != 0)?;
    cam.program.is_cyclic().then(|| (sign(bends[last]), samples.theta[last] - TAU))
}

/// Bounds of ρ of a curve that lies `radius` inside the pitch curve, which is convex in part and hollow in part and nowhere straight: the flattest hollow
/// and the flattest convex place.
pub(super) fn flattest(cam: &Cam, samples: &Samples, radius: f64) -> Extremes {
    let (hollow, min_at) = least_bend(cam, samples, -1.0);
    let (convex, max_at) = least_bend(cam, samples, 1.0);
    // A flattest place whose curvature is rounding is straight.
    let radius_of = |bend: f64| if bend > 0.0 { 1.0 / bend } else { f64::INFINITY };
    Extremes { min: -radius_of(hollow) - radius, min_at, max: radius_of(convex) - radius, max_at }
}

/// The minimum of `sign`·κ where that is positive, and its θ.
fn least_bend(cam: &Cam, samples: &Samples, sign: f64) -> (f64, f64) {
    let bends = samples.of_all(Quantity::Bend);
    let mut best = (f64::INFINITY, 0.0);
    for (k, span) in samples.spans.iter().enumerate() {
        let stretch = &cam.program.stretches()[k];
        let Some(at) = span
            .clone()
            .filter(|&i| sign * bends[i] > 0.0)
            .min_by(|&a, &b| (sign * bends[a]).total_cmp(&(sign * bends[b])))
        else {
            continue;
        };
        let ends = (samples.theta[at.max(span.start + 1) - 1], samples.theta[(at + 1).min(span.end - 1)]);
        let tolerance = THETA_TOLERANCE * (cam.program.span() / TAU);
        let (theta, value) = summit(ends, (samples.theta[at], -sign * bends[at]), tolerance, |theta| {
            -sign * Quantity::Bend.at(cam, stretch, theta)
        });
        if -value < best.0 {
            best = (-value, theta);
        }
    }
    if cam.program.is_cyclic() && best.1 >= TAU { (best.0, best.1 - TAU) } else { best }
}
