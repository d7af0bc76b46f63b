//! Conjugate cams: a second element, fixed to the same follower across the shaft, that rides a second cam.

mod across;
mod coincide;
mod search;

pub use coincide::profiles_coincide;
pub use search::{nearest_tie, working_ties, working_ties_in_parts};

use crate::follower::positive;
use crate::{Body, Cam, Closure, Drive, Element, Follower, GeometryError, GeometryProblem};
use across::{Across, along, radius_index};
use std::f64::consts::TAU;

/// What ties the second element to the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tie {
    /// Distance between the parallel faces, or between the centres of the rollers, of a follower that translates.
    Distance(f64),
    /// Angle between the arms, or between the faces, of one that swings; radians.
    Angle(f64),
    /// Base radius of the second cam, of one that swings: the angle follows from it.
    BaseRadius(f64),
}

impl Tie {
    /// The field that gives it.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Distance(_) => "distance",
            Self::Angle(_) => "angle",
            Self::BaseRadius(_) => "base_radius",
        }
    }

    /// Its value: a length, or radians.
    #[must_use]
    pub fn value(self) -> f64 {
        let (Self::Distance(value) | Self::Angle(value) | Self::BaseRadius(value)) = self;
        value
    }

    /// The same kind of tie with another value.
    #[must_use]
    pub fn with(self, value: f64) -> Self {
        match self {
            Self::Distance(_) => Self::Distance(value),
            Self::Angle(_) => Self::Angle(value),
            Self::BaseRadius(_) => Self::BaseRadius(value),
        }
    }
}

/// The second cam of a pair, analysed like any other. Its displacement is its own, from its own base circle: the greatest of
/// the first less that of the first. Its profile is where it is on the shaft, in the frame of the first.
///
/// `radius` is that of the second disc; that of the first when none is given.
///
/// * translating flat: Rb₂ = D − Rb − smax·cos γ;
/// * translating disc: its centre D below the first; Rp₂² = e² + (D − s₀ − smax)²;
/// * oscillating disc: its arm at the angle Γ from the first; Rp₂² = m² + A² − 2mA·cos(Γ − ξ₀ − smax);
/// * oscillating flat: Rb₂ = f + m·sin(Γ − ξ₀ − smax).
///
/// # Errors
/// Says between which values the tie must be, when it leaves no room for a second cam or is of the wrong kind for the follower.
pub fn conjugate(cam: &Cam, tie: Tie, radius: Option<f64>) -> Result<Cam, GeometryError> {
    let follower = &cam.follower;
    let unsuited = GeometryError { key: tie.key(), problem: GeometryProblem::Unsuited };
    if follower.drive == Drive::Travels || follower.reversed.is_some() || cam.closure == Closure::Groove {
        return Err(unsuited);
    }
    if !tie.value().is_finite() {
        return Err(GeometryError { key: tie.key(), problem: GeometryProblem::NotFinite });
    }
    let mut values = follower.values;
    if let (Some(radius), Some(index)) = (radius, radius_index(follower)) {
        positive(follower.kind.parameters[index].key, radius)?;
        values[index] = radius;
    }
    let across = Across::of(cam, radius);
    let (min, max) = across.bounds(tie).ok_or(unsuited)?;
    let found = tie.value();
    if !(found > min && found < max) {
        return Err(GeometryError { key: tie.key(), problem: GeometryProblem::Outside { found, min, max } });
    }
    let (base_radius, element) = across.place(tie).ok_or(unsuited)?;
    let second = Follower { base_radius, values, reversed: Some(across.top), element, ..*follower };
    Ok(Cam { program: cam.program.reversed(across.top), follower: second, closure: cam.closure })
}

/// The tie of that kind with which the second base circle is as large as the first; none when it leaves no room, or is of the
/// wrong kind for the follower.
///
/// Translating, D = 2Rb + smax·cos γ for a face and D = 2s₀ + smax for a disc; oscillating, Γ = ξ₀ + smax + ξ₂, with ξ₂ the opening of
/// the second element on a base circle of radius Rb.
#[must_use]
pub fn balanced_tie(cam: &Cam, kind: Tie) -> Option<Tie> {
    let follower = &cam.follower;
    let across = Across::of(cam, None);
    let (min, max) = across.bounds(kind)?;
    let value = match (follower.body, follower.element, kind) {
        (Body::Slide, Element::Face { normal, point }, _) => {
            along(point, normal) + follower.base_radius + across.top * normal.im
        }
        (Body::Slide, Element::Disc { centre, .. }, _) => 2.0 * centre.im + across.top,
        (Body::Swing { .. }, _, Tie::BaseRadius(_)) => follower.base_radius,
        (Body::Swing { pivot }, element, _) => {
            let opening = across.opening_for(pivot, element, follower.base_radius);
            follower.opening()? + across.top + opening
        }
    };
    (value > min && value < max).then(|| kind.with(value))
}

/// Γ: the angle between the arms, or the faces, of a pair that swings, radians in [0, 2π); none for a pair that translates.
#[must_use]
pub fn angle_between(first: &Cam, second: &Cam) -> Option<f64> {
    let Body::Swing { pivot } = first.follower.body else { return None };
    let turn = match (first.follower.element, second.follower.element) {
        (Element::Disc { centre: one, .. }, Element::Disc { centre: two, .. }) => (two - pivot) / (one - pivot),
        (Element::Face { normal: one, .. }, Element::Face { normal: two, .. }) => -two / one,
        _ => return None,
    };
    Some(turn.arg().rem_euclid(TAU))
}
