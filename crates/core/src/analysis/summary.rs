//! Extremes of every quantity over the cycle.

use super::hollow::{Inflections, flattest};
use crate::extreme::extremes;
use crate::samples::{Quantity, Samples};
use crate::{Body, Cam, Closure, Extremes};
use std::f64::consts::PI;

/// Extremes over the cycle, refined between stations. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Displacement.
    pub s: Extremes,
    /// ds/dθ.
    pub v: Extremes,
    /// d²s/dθ².
    pub a: Extremes,
    /// d³s/dθ³.
    pub j: Extremes,
    /// φ, radians.
    pub pressure_angle: Extremes,
    /// ρ of the profile. Where the profile is convex in part and hollow in part, ρ has no bounds: these are infinite, and both places are the first
    /// one where it is straight. Of a profile that turns hollow by jumps of its curvature alone, the flattest hollow and the flattest convex place.
    pub rho: Extremes,
    /// ρp of the pitch curve; none for a flat face.
    pub rho_pitch: Option<Extremes>,
    /// The contact on a flat face (see [`Contact::reach`](crate::Contact::reach)); none for others.
    pub reach: Option<Extremes>,
    /// The least ρ where the profile is convex, and its θ; negative when it is undercut there.
    pub least_convex: Option<(f64, f64)>,
    /// The tightest hollow, as a negative ρ, and its θ.
    pub tightest_hollow: Option<(f64, f64)>,
    /// The breadth of a cam held by a yoke, measured over the turn; least and greatest differ by rounding alone.
    pub breadth: Option<Extremes>,
}

/// The part of a flat face that the contact uses, and the minimum length of a face that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Where the contact begins to work: from the axis of the follower, or from the foot of the perpendicular from the pivot.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The minimum length. A face that slides is as long as the part in use; one that swings begins at the foot, where its arm carries it.
    pub length: f64,
}

impl Summary {
    /// The face that this motion needs under a follower with these dimensions, with a margin at each end of the part in use; none without a flat face.
    #[must_use]
    pub fn face(&self, cam: &Cam, margin: f64) -> Option<Face> {
        let reach = self.reach?;
        let (from, to) = (reach.min - margin, reach.max + margin);
        let length = match cam.follower.body {
            Body::Slide => to - from,
            Body::Swing { .. } => to.max(0.0) - from.min(0.0),
        };
        Some(Face { from, to, length })
    }
}

pub(super) fn summarise(cam: &Cam, samples: &Samples, inflections: &Inflections) -> Summary {
    let of = |quantity: Quantity| extremes(cam, samples, quantity);
    let bend = of(Quantity::Bend);
    let flat = cam.follower.is_flat();
    let radius = cam.follower.disc_radius();
    let radii = |radius: f64| match (bend.min < 0.0 && bend.max > 0.0, inflections.straight) {
        (true, Some(at)) => Extremes { min: f64::NEG_INFINITY, min_at: at, max: f64::INFINITY, max_at: at },
        (true, None) => flattest(cam, samples, radius),
        _ => radii(&bend, radius),
    };
    let (rho, rho_pitch) = if flat { (bend, None) } else { (radii(radius), Some(radii(0.0))) };
    let least = (cam.follower.profile_radius(bend.max), bend.max_at);
    Summary {
        s: of(Quantity::S),
        v: of(Quantity::V),
        a: of(Quantity::A),
        j: of(Quantity::J),
        pressure_angle: of(Quantity::PressureAngle),
        rho,
        rho_pitch,
        reach: flat.then(|| of(Quantity::Reach)),
        least_convex: if flat { Some((bend.min, bend.min_at)) } else { (bend.max > 0.0).then_some(least) },
        tightest_hollow: (!flat && bend.min < 0.0).then(|| (1.0 / bend.min - radius, bend.min_at)),
        breadth: (cam.closure == Closure::Yoke).then(|| measured_breadth(cam, samples)),
    }
}

/// The distance between the two parallel tangents of the profile (or between the near sides of two rollers on the same
/// diameter), station by station: half a turn away is as many stations away.
fn measured_breadth(cam: &Cam, samples: &Samples) -> Extremes {
    let (s, _) = samples.rows(Quantity::S, 1);
    let half = s.len() / 2;
    let facing = |i: usize| 2.0 * cam.follower.base_radius + s[i] + cam.program.at(samples.station(i) + PI).s;
    let mut found = Extremes { min: f64::INFINITY, min_at: 0.0, max: f64::NEG_INFINITY, max_at: 0.0 };
    for i in 0..half.max(1) {
        let (breadth, theta) = (facing(i), samples.station(i));
        if breadth < found.min {
            (found.min, found.min_at) = (breadth, theta);
        }
        if breadth > found.max {
            (found.max, found.max_at) = (breadth, theta);
        }
    }
    found
}

/// Extremes of 1/κ − `radius` from the extremes of κ, which keeps its sign, so that it is monotone.
fn radii(curvature: &Extremes, radius: f64) -> Extremes {
    let Extremes { min, min_at, max, max_at } = *curvature;
    // Hollow all along and straight somewhere: ρ comes from −∞.
    let max = if max == 0.0 && min < 0.0 { -0.0 } else { max };
    Extremes { min: 1.0 / max - radius, min_at: max_at, max: 1.0 / min - radius, max_at: min_at }
}
