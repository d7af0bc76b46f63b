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
///
/// Its fields follow from each other, so they are read by methods and changed by `with_…` only: what a constructor returns can be.
///
/// ```
/// use levalab_core::{Follower, Rotation};
///
/// let follower = Follower::translating_roller(35.0, 7.0)?.with_eccentricity(6.0)?.turned(Rotation::Clockwise);
/// assert_eq!(follower.value("eccentricity"), Some(6.0));
/// assert!(Follower::translating_roller(35.0, -7.0).is_err());
/// # Ok::<(), levalab_core::GeometryError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Follower {
    pub(crate) kind: &'static FollowerKind,
    pub(crate) base_radius: f64,
    pub(crate) values: FollowerValues,
    pub(crate) drive: Drive,
    pub(crate) rotation: Rotation,
    pub(crate) reversed: Option<f64>,
    pub(crate) body: Body,
    pub(crate) element: Element,
}

/// Constructors for each kind. Lengths are in the unit of the design, angles in radians; the cam turns counter-clockwise.
impl Follower {
    /// A roller of radius Rf on an axis through the centre of the cam; see [`with_eccentricity`](Self::with_eccentricity).
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn translating_roller(base_radius: f64, roller_radius: f64) -> Result<Self, GeometryError> {
        Self::new(&translating_roller::KIND, base_radius, &[roller_radius], Rotation::default())
    }

    /// A knife edge on an axis through the centre of the cam.
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn translating_knife(base_radius: f64) -> Result<Self, GeometryError> {
        Self::new(&translating_knife::KIND, base_radius, &[], Rotation::default())
    }

    /// A curved face of radius Rf that slides on the cam, its centre on an axis through the centre of the cam.
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn translating_curved(base_radius: f64, face_radius: f64) -> Result<Self, GeometryError> {
        Self::new(&translating_curved::KIND, base_radius, &[face_radius], Rotation::default())
    }

    /// A flat face normal to its axis.
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn translating_flat(base_radius: f64) -> Result<Self, GeometryError> {
        Self::new(&translating_flat::KIND, base_radius, &[], Rotation::default())
    }

    /// A roller of radius Rf on an arm of length A that swings about a pivot at distance m from the centre of the cam.
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn oscillating_roller(
        base_radius: f64,
        roller_radius: f64,
        arm: f64,
        pivot_distance: f64,
    ) -> Result<Self, GeometryError> {
        let values = [roller_radius, arm, pivot_distance];
        Self::new(&oscillating_roller::KIND, base_radius, &values, Rotation::default())
    }

    /// A flat face that swings about a pivot at distance m from the centre of the cam, with the face through the pivot; see
    /// [`with`](Self::with) for its offset.
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn oscillating_flat(base_radius: f64, pivot_distance: f64) -> Result<Self, GeometryError> {
        Self::new(&oscillating_flat::KIND, base_radius, &[0.0, pivot_distance], Rotation::default())
    }

    /// The same follower with its axis at a distance e to the right of the centre of the cam.
    ///
    /// # Errors
    /// As [`Follower::new`]; a follower without an eccentricity is unsuited.
    pub fn with_eccentricity(self, eccentricity: f64) -> Result<Self, GeometryError> {
        self.with(ECCENTRICITY.key, eccentricity)
    }

    /// The same follower with the parameter of that key, a length or an angle in radians, changed.
    ///
    /// # Errors
    /// As [`Follower::new`]; a parameter that the kind does not have is unsuited.
    pub fn with(self, key: &'static str, value: f64) -> Result<Self, GeometryError> {
        let unsuited = GeometryError { key, problem: GeometryProblem::Unsuited };
        self.with_value(self.kind.index_of(key).ok_or(unsuited)?, value)
    }

    /// The same follower on a cam that turns in that sense.
    #[must_use]
    pub fn turned(self, rotation: Rotation) -> Self {
        Self { rotation, ..self }
    }
}

/// What a follower is made of.
impl Follower {
    /// The kind.
    #[must_use]
    pub fn kind(&self) -> &'static FollowerKind {
        self.kind
    }

    /// Rb; 0 for a cam that travels, which has no base circle.
    #[must_use]
    pub fn base_radius(&self) -> f64 {
        self.base_radius
    }

    /// The parameters, in the order of [`FollowerKind::parameters`]; lengths, and angles in radians.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values[..self.kind.parameters.len()]
    }

    /// How the cam moves.
    #[must_use]
    pub fn drive(&self) -> Drive {
        self.drive
    }

    /// The sense in which the cam turns.
    #[must_use]
    pub fn rotation(&self) -> Rotation {
        self.rotation
    }

    /// Of a second element across the shaft, the maximum displacement of the follower that it belongs to. Its own displacement is that less
    /// the follower's, so it advances on its cam when the first element retreats. `None` for a first element.
    #[must_use]
    pub fn reversed(&self) -> Option<f64> {
        self.reversed
    }

    /// The rigid motion.
    #[must_use]
    pub fn body(&self) -> Body {
        self.body
    }

    /// What touches the cam, at s = 0.
    #[must_use]
    pub fn element(&self) -> Element {
        self.element
    }
}

impl Follower {
    /// Places a follower at s = 0 on its base circle of radius Rb. The values are those of the parameters of its kind, in their order: lengths,
    /// and angles in radians. Parameters without a value take their default.
    ///
    /// # Errors
    /// Names the magnitude that makes the geometry impossible: one that is missing or not finite, a size that is not positive, or lengths that
    /// do not go together ([`Misfit`](crate::Misfit)).
    pub fn new(
        kind: &'static FollowerKind,
        base_radius: f64,
        given: &[f64],
        rotation: Rotation,
    ) -> Result<Self, GeometryError> {
        positive("base_radius", base_radius)?;
        let mut values = [0.0; MAX_FOLLOWER_PARAMETERS];
        for (index, parameter) in kind.parameters.iter().enumerate() {
            let value = given.get(index).copied().or(parameter.default).unwrap_or(f64::NAN);
            if !value.is_finite() {
                return Err(GeometryError { key: parameter.key, problem: GeometryProblem::NotFinite });
            }
            values[index] = value;
        }
        let (body, element) = (kind.place)(base_radius, &values)?;
        Ok(Self { kind, base_radius, values, drive: Drive::Turns, rotation, reversed: None, body, element })
    }

    /// Places a translating disc on the base line of a cam that travels: its trace point at height Rf, on the y axis.
    ///
    /// # Errors
    /// Names the magnitude that makes it impossible. A follower that swings or has a flat face has no place on such a cam.
    pub fn on_travel(kind: &'static FollowerKind, values: &[f64]) -> Result<Self, GeometryError> {
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
        Self::new(self.kind, base_radius, self.values(), self.rotation)
    }

    /// The same follower with one parameter changed.
    ///
    /// # Errors
    /// As [`Follower::new`].
    pub fn with_value(&self, index: usize, value: f64) -> Result<Self, GeometryError> {
        let mut values = self.values;
        values[index] = value;
        match self.drive {
            Drive::Turns => Self::new(self.kind, self.base_radius, &values, self.rotation),
            Drive::Travels => Self::on_travel(self.kind, &values),
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

    fn opening(follower: Result<Follower, GeometryError>) -> f64 {
        follower.expect("a follower").opening().expect("it swings").to_degrees()
    }

    #[test]
    fn the_opening_is_that_of_the_triangle_or_of_the_face() {
        // Example 2RO: cos ξ₀ = (80² + 80² − 50²)/(2·80·80).
        assert!((opening(Follower::oscillating_roller(40.0, 10.0, 80.0, 80.0)) - 36.42).abs() < 0.005);
        // sin ξ₀ = (Rb − f)/m, wherever the pivot is.
        let flat = |base_radius, offset| {
            Follower::new(&oscillating_flat::KIND, base_radius, &[offset, 80.0, 1.2], Rotation::default())
        };
        assert!((opening(flat(50.0, 10.0)) - 30.0).abs() < 1e-12);
        // A face that passes the cam's centre lies beyond the line of centres.
        assert!((opening(flat(10.0, 50.0)) + 30.0).abs() < 1e-12);
    }

    #[test]
    fn a_value_that_is_left_out_takes_its_default_or_is_missed_by_name() {
        let roller = Follower::translating_roller(35.0, 7.0).expect("a roller");
        assert_eq!(roller.values(), [7.0, 0.0]);
        let missing = Follower::new(&translating_roller::KIND, 35.0, &[], Rotation::default());
        assert_eq!(missing.err().map(|error| error.key), Some("roller_radius"));
    }

    #[test]
    fn a_parameter_that_a_kind_does_not_have_is_unsuited() {
        let error =
            Follower::translating_flat(40.0).expect("a face").with_eccentricity(3.0).expect_err("no eccentricity");
        assert_eq!((error.key, error.problem), ("eccentricity", GeometryProblem::Unsuited));
    }
}
