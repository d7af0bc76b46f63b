//! What the files of the followers share: their parameters, and how a sliding disc is placed.

use super::{Body, Element, Point};
use crate::{GeometryError, GeometryProblem, Misfit, Parameter, Quantity};

/// Where body and element lie at s = 0, or the magnitude that makes it impossible.
pub(super) type Placement = Result<(Body, Element), GeometryError>;

/// Refuses what is not a positive finite number.
pub(crate) fn positive(key: &'static str, found: f64) -> Result<(), GeometryError> {
    let problem = if !found.is_finite() {
        GeometryProblem::NotFinite
    } else if found <= 0.0 {
        GeometryProblem::NotPositive { found }
    } else {
        return Ok(());
    };
    Err(GeometryError { key, problem })
}

pub(super) const ROLLER_RADIUS: Parameter =
    Parameter { key: "roller_radius", symbol: "Rf", quantity: Quantity::Length, default: None, optional: false };
pub(super) const FACE_RADIUS: Parameter =
    Parameter { key: "face_radius", symbol: "Rf", quantity: Quantity::Length, default: None, optional: false };
pub(super) const ECCENTRICITY: Parameter =
    Parameter { key: "eccentricity", symbol: "e", quantity: Quantity::Length, default: Some(0.0), optional: true };
pub(super) const PIVOT_DISTANCE: Parameter =
    Parameter { key: "pivot_distance", symbol: "m", quantity: Quantity::Length, default: None, optional: false };
pub(super) const PIVOT_ANGLE: Parameter =
    Parameter { key: "pivot_angle", symbol: "ψ", quantity: Quantity::Angle, default: Some(0.0), optional: true };
pub(super) const ARM: Parameter =
    Parameter { key: "arm", symbol: "A", quantity: Quantity::Length, default: None, optional: false };
pub(super) const FACE_OFFSET: Parameter =
    Parameter { key: "face_offset", symbol: "f", quantity: Quantity::Length, default: Some(0.0), optional: true };
pub(super) const FACE_ANGLE: Parameter =
    Parameter { key: "face_angle", symbol: "γ", quantity: Quantity::Angle, default: Some(0.0), optional: true };

/// A translating disc of that radius on an axis at eccentricity e: F = e + i·(s₀ + s), s₀ = √(Rp² − e²).
pub(super) fn sliding_disc(base_radius: f64, radius: f64, eccentricity: f64) -> Placement {
    let prime_radius = base_radius + radius;
    if eccentricity.abs() >= prime_radius {
        let problem = GeometryProblem::Misfit(Misfit::Eccentricity { eccentricity, prime_radius });
        return Err(GeometryError { key: ECCENTRICITY.key, problem });
    }
    let start = ((prime_radius - eccentricity) * (prime_radius + eccentricity)).sqrt();
    Ok((Body::Slide, Element::Disc { centre: Point::new(eccentricity, start), radius }))
}
