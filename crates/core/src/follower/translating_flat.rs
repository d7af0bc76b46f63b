//! Flat face that moves along +y, turned counter-clockwise by the face angle γ from the horizontal.

use super::place::FACE_ANGLE;
use super::{Body, ContactKind, Element, FollowerKind, Motion, Point};
use crate::{GeometryError, GeometryProblem};
use std::f64::consts::FRAC_PI_2;

/// Support p = Rb + s·cos γ; with γ = 0 the contact walks by v and ρ = Rb + s + a.
pub const KIND: FollowerKind = FollowerKind {
    id: "translating-flat",
    motion: Motion::Translating,
    contact: ContactKind::Flat,
    parameters: &[FACE_ANGLE],
    place: |base_radius, &[angle, ..]| {
        if angle.abs() >= FRAC_PI_2 {
            let problem = GeometryProblem::Outside { found: angle, min: -FRAC_PI_2, max: FRAC_PI_2 };
            return Err(GeometryError { key: FACE_ANGLE.key, problem });
        }
        let normal = Point::new(-angle.sin(), angle.cos());
        Ok((Body::Slide, Element::Face { normal, point: normal * base_radius }))
    },
};
