//! Everything at one instant, as plain numbers that the page reads by position.

use levalab_core::{Cam, Motion};
use std::f64::consts::TAU;

/// How many numbers [`fill`] writes.
pub const LENGTH: usize = 23;

/// Writes the instant at θ (degrees, any turn) of a cam turning at `omega` rad/s; or at x (length) of one that travels at so much
/// length per second.
///
/// 0 s, 1 v, 2 a, 3 j (per radian; degrees for an oscillating follower), 4 φ in degrees, 5 ρ, 6 ρp, 7 contact on a flat face,
/// 8 sliding velocity (length per radian), 9–10 contact point, 11–12 trace point, 13–14 outward unit normal, 15–16 centre of
/// curvature, 17 segment, 18 V, 19 A, 20 J (per second), 21 seconds since θ = 0, 22 sliding velocity (length per second). The fixed frame has its origin at the cam's centre
/// and the follower on top. What does not apply is NaN.
pub fn fill(cam: &Cam, omega: f64, place: f64, out: &mut [f64]) {
    let Some(out) = out.first_chunk_mut::<LENGTH>() else { return };
    let theta = match cam.program.is_cyclic() {
        true => place.to_radians().rem_euclid(TAU),
        false => place.clamp(0.0, cam.program.span()),
    };
    let (motion, contact) = cam.at(theta);
    let travel = match cam.follower.kind().motion {
        Motion::Translating => 1.0,
        Motion::Oscillating => 360.0 / TAU,
    };
    let [s, v, a, j] = [motion.s, motion.v, motion.a, motion.j].map(|value| value * travel);
    let flat = cam.follower.is_flat();
    let rho = cam.follower.profile_radius(contact.bend);
    let centre = contact.point - contact.normal * rho;
    let or_none = |applies: bool, value: f64| if applies { value } else { f64::NAN };
    *out = [
        s,
        v,
        a,
        j,
        contact.pressure_angle.to_degrees(),
        rho,
        or_none(!flat, 1.0 / contact.bend),
        or_none(flat, contact.reach),
        contact.sliding,
        contact.point.re,
        contact.point.im,
        contact.trace.re,
        contact.trace.im,
        contact.normal.re,
        contact.normal.im,
        or_none(rho.is_finite(), centre.re),
        or_none(rho.is_finite(), centre.im),
        cam.program.stretches()[cam.program.stretch_index(theta)].segment as f64,
        v * omega,
        a * omega * omega,
        j * omega.powi(3),
        theta / omega,
        contact.sliding * omega,
    ];
}
