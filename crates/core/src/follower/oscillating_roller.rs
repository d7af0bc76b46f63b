//! Roller at the end of an arm that swings about a fixed pivot.

use super::place::{ARM, PIVOT_ANGLE, PIVOT_DISTANCE, ROLLER_RADIUS, positive};
use super::{Body, ContactKind, Element, FollowerKind, Motion, Point};
use crate::{GeometryError, GeometryProblem, Misfit};

/// cos ξ₀ = (m² + A² − Rp²)/(2mA), ξ = ξ₀ + s, F = (m − A·e^(−iξ))·e^(iψ): the pivot at distance m and angle ψ, the arm
/// above it. Positive *s* turns the arm clockwise.
pub const KIND: FollowerKind = FollowerKind {
    id: "oscillating-roller",
    motion: Motion::Oscillating,
    contact: ContactKind::Roller,
    parameters: &[ROLLER_RADIUS, ARM, PIVOT_DISTANCE, PIVOT_ANGLE],
    place: |base_radius, &[radius, arm, pivot_distance, pivot_angle]| {
        positive(ROLLER_RADIUS.key, radius)?;
        positive(ARM.key, arm)?;
        positive(PIVOT_DISTANCE.key, pivot_distance)?;
        let prime_radius = base_radius + radius;
        let xi = opening(pivot_distance, arm, prime_radius).ok_or(GeometryError {
            key: PIVOT_DISTANCE.key,
            problem: GeometryProblem::Misfit(Misfit::Triangle { pivot_distance, arm, prime_radius }),
        })?;
        let pivot = Point::from_polar(pivot_distance, pivot_angle);
        let centre = pivot - Point::from_polar(arm, pivot_angle - xi);
        Ok((Body::Swing { pivot }, Element::Disc { centre, radius }))
    },
};

/// ξ₀, the angle between the arm and the line of centres; none unless the three lengths make a proper triangle.
fn opening(pivot_distance: f64, arm: f64, prime_radius: f64) -> Option<f64> {
    let difference = (pivot_distance - arm).abs();
    let proper = prime_radius > difference && prime_radius < pivot_distance + arm;
    // Half-angle form: tan²(ξ₀/2) keeps its digits where the cosine rule loses them.
    proper.then(|| {
        let near = (prime_radius - difference) * (prime_radius + difference);
        let far = (pivot_distance + arm - prime_radius) * (pivot_distance + arm + prime_radius);
        2.0 * (near / far).sqrt().atan()
    })
}
