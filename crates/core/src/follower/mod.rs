//! Followers: what touches the cam, and how it moves.
//!
//! A follower is a rigid [`Body`] that slides along +y or swings about a pivot, and carries a contact [`Element`]: a disc
//! (roller, knife edge, curved face) or a straight face. The disc's profile is an *offset of the pitch curve*, the face's an
//! *envelope of a line* (see [`contact`]). To add a follower, write one file with a `pub const KIND: FollowerKind` that
//! places body and element from its parameters, and name it in [`FOLLOWERS`].

mod contact;
mod kind;
mod oscillating_flat;
mod oscillating_roller;
mod place;
mod translating_curved;
mod translating_flat;
mod translating_knife;
mod translating_roller;

pub use contact::Contact;
pub use kind::{ContactKind, FOLLOWERS, FollowerKind, FollowerValues, MAX_FOLLOWER_PARAMETERS, Motion};
pub(crate) use place::positive;

use crate::{GeometryError, GeometryProblem};
use nalgebra::Complex;
use place::ECCENTRICITY;

/// A point or vector of the plane: x + i·y.
pub type Point = Complex<f64>;

/// The rigid motion of the follower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body {
    /// Slides along +y by *s*.
    Slide,
    /// Turns clockwise about the pivot by *s*.
    Swing {
        /// The fixed pivot.
        pivot: Point,
    },
}

/// The contact element, placed at s = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Element {
    /// A circle about the trace point; radius 0 is a knife edge.
    Disc {
        /// The trace point.
        centre: Point,
        /// Radius of the circle.
        radius: f64,
    },
    /// A straight face.
    Face {
        /// Unit normal, away from the cam.
        normal: Point,
        /// A point of the face that moves with it.
        point: Point,
    },
}

/// The sense in which the cam turns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rotation {
    /// σ = +1.
    #[default]
    CounterClockwise,
    /// σ = −1.
    Clockwise,
}

impl Rotation {
    /// σ: +1 counter-clockwise, −1 clockwise.
    #[must_use]
    pub fn sigma(self) -> f64 {
        match self {
            Self::CounterClockwise => 1.0,
            Self::Clockwise => -1.0,
        }
    }
}

/// How the cam itself moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drive {
    /// It turns about the origin; θ is an angle.
    #[default]
    Turns,
    /// It travels towards −x, so that the follower meets what lies at x = θ; θ is a length.
    Travels,
}

/// A follower resting on a base circle, or on the base line of a cam that travels.
#[derive(Clone, Copy, Debug)]
pub struct Follower {
    /// What kind it is.
    pub kind: &'static FollowerKind,
    /// Rb; 0 for a cam that travels.
    pub base_radius: f64,
    /// Its parameters, in the order of [`FollowerKind::parameters`]; angles in radians.
    pub values: FollowerValues,
    /// How the cam moves.
    pub drive: Drive,
    /// Sense of rotation of the cam.
    pub rotation: Rotation,
    /// The greatest displacement of the follower that this is the second element of, on the other side of the shaft. Its own
    /// displacement is that less the follower's, so it advances on its cam when the first retreats.
    pub reversed: Option<f64>,
    /// Its rigid motion.
    pub body: Body,
    /// What touches the cam, at s = 0.
    pub element: Element,
}

impl Follower {
    /// Places a follower at s = 0 on its base circle of radius Rb; angles of its parameters in radians.
    ///
    /// # Errors
    /// Names the magnitude that makes the geometry impossible: one that is not finite, a size that is not positive, or lengths that do not
    /// go together ([`Misfit`](crate::Misfit)).
    pub fn new(
        kind: &'static FollowerKind,
        base_radius: f64,
        values: FollowerValues,
        rotation: Rotation,
    ) -> Result<Self, GeometryError> {
        positive("base_radius", base_radius)?;
        for (parameter, value) in kind.parameters.iter().zip(values) {
            if !value.is_finite() {
                return Err(GeometryError { key: parameter.key, problem: GeometryProblem::NotFinite });
            }
        }
        let (body, element) = (kind.place)(base_radius, &values)?;
        Ok(Self { kind, base_radius, values, drive: Drive::Turns, rotation, reversed: None, body, element })
    }

    /// Places a translating disc on the base line of a cam that travels: its trace point at height Rf, on the y axis.
    ///
    /// # Errors
    /// Names the magnitude that makes it impossible. A follower that swings or has a flat face has no place on such a cam.
    pub fn on_travel(kind: &'static FollowerKind, values: FollowerValues) -> Result<Self, GeometryError> {
        // On a unit circle all its checks are made; what it rests on is then changed for the base line.
        let resting = Self::new(kind, 1.0, values, Rotation::CounterClockwise)?;
        let unsuited = |key| Err(GeometryError { key, problem: GeometryProblem::Unsuited });
        let Element::Disc { centre, radius } = resting.element else { return unsuited("contact") };
        if resting.body != Body::Slide {
            return unsuited("motion");
        }
        if centre.re != 0.0 {
            return unsuited(ECCENTRICITY.key);
        }
        let element = Element::Disc { centre: Point::new(0.0, radius), radius };
        Ok(Self { base_radius: 0.0, drive: Drive::Travels, element, ..resting })
    }

    /// The same follower on another base circle.
    ///
    /// # Errors
    /// As [`Follower::new`]; a cam that travels has no base circle, and a second element is placed by the first.
    pub fn with_base_radius(&self, base_radius: f64) -> Result<Self, GeometryError> {
        if self.drive == Drive::Travels || self.reversed.is_some() {
            return Err(GeometryError { key: "base_radius", problem: GeometryProblem::Unsuited });
        }
        Self::new(self.kind, base_radius, self.values, self.rotation)
    }

    /// The same follower with one parameter changed.
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn with_value(&self, index: usize, value: f64) -> Result<Self, GeometryError> {
        let mut values = self.values;
        values[index] = value;
        match self.drive {
            Drive::Turns => Self::new(self.kind, self.base_radius, values, self.rotation),
            Drive::Travels => Self::on_travel(self.kind, values),
        }
    }

    /// The value of a parameter by its name.
    #[must_use]
    pub fn value(&self, key: &str) -> Option<f64> {
        self.kind.index_of(key).map(|index| self.values[index])
    }

    /// Radius of the disc that touches: Rf; 0 for a knife edge and for a flat face.
    #[must_use]
    pub fn disc_radius(&self) -> f64 {
        match self.element {
            Element::Disc { radius, .. } => radius,
            Element::Face { .. } => 0.0,
        }
    }

    /// True for a straight face.
    #[must_use]
    pub fn is_flat(&self) -> bool {
        matches!(self.element, Element::Face { .. })
    }

    /// ξ₀, radians: the angle at the pivot between the line of centres and the arm (or the flat face) at s = 0, negative where a face lies
    /// beyond that line; none for a follower that translates. Of a second element it is the angle while the first rests, at its own
    /// greatest *s*.
    ///
    /// cos ξ₀ = (m² + A² − Rp²)/(2mA) for an arm, sin ξ₀ = (Rb − f)/m for a face.
    #[must_use]
    pub fn opening(&self) -> Option<f64> {
        let Body::Swing { pivot } = self.body else { return None };
        let along = match self.element {
            Element::Disc { centre, .. } => centre - pivot,
            // The face points away from the pivot a quarter turn ahead of its normal, which is upside down across the shaft.
            Element::Face { normal, .. } => normal * Point::i() * self.advance(),
        };
        Some(-self.advance() * (along / -pivot).arg())
    }

    /// The |φ| that good practice allows, radians: 30° translating, 35° oscillating (Norton, *Cam Design and Manufacturing Handbook*,
    /// ch. 7).
    #[must_use]
    pub fn pressure_angle_limit(&self) -> f64 {
        match self.kind.motion {
            Motion::Translating => 30_f64.to_radians(),
            Motion::Oscillating => 35_f64.to_radians(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opening(id: &str, base_radius: f64, values: FollowerValues) -> f64 {
        let kind = FollowerKind::by_id(id).expect(id);
        Follower::new(kind, base_radius, values, Rotation::default())
            .expect(id)
            .opening()
            .expect("it swings")
            .to_degrees()
    }

    #[test]
    fn the_opening_is_that_of_the_triangle_or_of_the_face() {
        // Example 2RO: cos ξ₀ = (80² + 80² − 50²)/(2·80·80).
        assert!((opening("oscillating-roller", 40.0, [10.0, 80.0, 80.0, 0.0]) - 36.42).abs() < 0.005);
        // sin ξ₀ = (Rb − f)/m, wherever the pivot is.
        assert!((opening("oscillating-flat", 50.0, [10.0, 80.0, 1.2, 0.0]) - 30.0).abs() < 1e-12);
        // A face that passes the cam's centre lies beyond the line of centres.
        assert!((opening("oscillating-flat", 10.0, [50.0, 80.0, 1.2, 0.0]) + 30.0).abs() < 1e-12);
    }
}
