//! Flat face that swings about a fixed pivot, the face at offset f from it.

use super::place::{FACE_OFFSET, PIVOT_ANGLE, PIVOT_DISTANCE, positive};
use super::{Body, ContactKind, Element, FollowerKind, Motion, Point};
use crate::{GeometryError, GeometryProblem, Misfit};
use std::f64::consts::FRAC_PI_2;

/// sin ξ₀ = (Rb − f)/m, ξ = ξ₀ + s, support p = f + m·sin ξ.
pub const KIND: FollowerKind = FollowerKind {
    id: "oscillating-flat",
    motion: Motion::Oscillating,
    contact: ContactKind::Flat,
    parameters: &[FACE_OFFSET, PIVOT_DISTANCE, PIVOT_ANGLE],
    place: |base_radius, &[offset, pivot_distance, pivot_angle, _]| {
        positive(PIVOT_DISTANCE.key, pivot_distance)?;
        let needed = (base_radius - offset).abs();
        if needed >= pivot_distance {
            let problem = GeometryProblem::Misfit(Misfit::FaceOutOfReach { pivot_distance, needed });
            return Err(GeometryError { key: PIVOT_DISTANCE.key, problem });
        }
        let xi = ((base_radius - offset) / pivot_distance).asin();
        let pivot = Point::from_polar(pivot_distance, pivot_angle);
        let normal = Point::from_polar(1.0, pivot_angle + FRAC_PI_2 - xi);
        Ok((Body::Swing { pivot }, Element::Face { normal, point: pivot + normal * offset }))
    },
};
