//! A cam: a motion program, the follower that it moves, and what kind of cam it is.

use crate::{CamError, Contact, Drive, Follower, Point, Program, Svaj};
use std::f64::consts::PI;

/// A curvature that bends the profile by less than this part of a turn over the cam's size is rounding of the acceleration: there
/// the profile is straight. That of a swift stretch comes to some 10⁻¹³.
const STRAIGHT: f64 = 1e-11;

/// A cam that can be analysed. What it holds has been checked; everything computed from it is total.
#[derive(Clone, Debug)]
pub struct Cam {
    /// The motion of the follower over one cycle.
    pub program: Program,
    /// The follower on its base circle.
    pub follower: Follower,
    /// How cam and follower are kept together.
    pub closure: Closure,
}

/// How cam and follower are kept together, which decides what is judged besides the profile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Closure {
    /// By a force, or by a second cam on the same shaft: one profile, touched in one place.
    #[default]
    Force,
    /// By a groove, whose walls are both offsets of the pitch curve.
    Groove,
    /// By a yoke that holds the cam between two parallel faces, or two rollers: constant breadth, or diameter.
    Yoke,
}

impl Cam {
    /// Joins a program and a follower that a force keeps on the cam.
    #[must_use]
    pub fn new(program: Program, follower: Follower) -> Self {
        Self { program, follower, closure: Closure::Force }
    }

    /// The same cam, closed in another way.
    #[must_use]
    pub fn closed_by(self, closure: Closure) -> Self {
        Self { closure, ..self }
    }

    /// Motion and contact at θ, radians of any turn, or a place along the travel; on a joint, the limits from the right.
    #[must_use]
    pub fn at(&self, theta: f64) -> (Svaj, Contact) {
        let motion = self.program.at(theta);
        (motion, self.contact(motion))
    }

    /// The contact when the follower's motion is `motion`, the pitch curve of a disc straight where its curvature is rounding.
    #[must_use]
    #[inline]
    pub fn contact(&self, motion: Svaj) -> Contact {
        let contact = self.follower.contact(motion);
        let straight = !self.follower.is_flat() && (contact.bend * self.size()).abs() < STRAIGHT;
        if straight { Contact { bend: 0.0, ..contact } } else { contact }
    }

    /// The same cam with another program.
    #[must_use]
    pub fn with_program(&self, program: Program) -> Self {
        Self { program, ..self.clone() }
    }

    /// The same cam with another follower.
    #[must_use]
    pub fn with_follower(&self, follower: Follower) -> Self {
        Self { follower, ..self.clone() }
    }

    /// The same cam on another base circle.
    ///
    /// # Errors
    /// When the follower cannot rest on that base circle, or the cam has none.
    pub fn with_base_radius(&self, base_radius: f64) -> Result<Self, CamError> {
        Ok(self.with_follower(self.follower.with_base_radius(base_radius)?))
    }

    /// A point of the fixed frame, at cam angle θ, in the cam's frame: p·e^(−iσθ), or p + θ for a cam that travels.
    #[must_use]
    pub fn in_cam_frame(&self, point: Point, theta: f64) -> Point {
        match self.follower.drive {
            Drive::Turns => point * Point::from_polar(1.0, -self.follower.rotation.sigma() * theta),
            Drive::Travels => point + theta,
        }
    }

    /// Where the far side of the yoke touches at θ, in the fixed frame: opposite to where the near side does half a turn later. None for
    /// a cam that no yoke holds.
    #[must_use]
    pub fn far_contact(&self, theta: f64) -> Option<Point> {
        (self.closure == Closure::Yoke).then(|| -self.at(theta + PI).1.point)
    }

    /// The distance between the parallel faces of the yoke, or between the near sides of its rollers: 2Rb + s(θ) + s(θ + π),
    /// which its program keeps constant; a length. None for a cam that no yoke holds.
    #[must_use]
    pub fn breadth(&self) -> Option<f64> {
        let facing = self.program.at(0.0).s + self.program.at(PI).s;
        (self.closure == Closure::Yoke).then_some(2.0 * self.follower.base_radius + facing)
    }

    /// A length to compare other lengths with: the base radius, or what a cam that travels is long.
    #[must_use]
    #[inline]
    pub(crate) fn size(&self) -> f64 {
        match self.follower.drive {
            Drive::Turns => self.follower.base_radius,
            Drive::Travels => self.program.span(),
        }
    }
}
