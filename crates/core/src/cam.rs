//! A cam: a motion program, the follower that it moves, and the speed at which it turns.

use crate::{CamError, Contact, Follower, Program, Svaj};
use nalgebra::Complex;

/// A cam that can be analysed. What it holds has been checked; everything computed from it is total.
#[derive(Clone, Debug)]
pub struct Cam {
    /// The motion of the follower over one turn.
    pub program: Program,
    /// The follower on its base circle.
    pub follower: Follower,
}

impl Cam {
    /// Joins a program and a follower.
    #[must_use]
    pub fn new(program: Program, follower: Follower) -> Self {
        Self { program, follower }
    }

    /// Motion and contact at θ (radians, any turn).
    #[must_use]
    pub fn at(&self, theta: f64) -> (Svaj, Contact) {
        let motion = self.program.at(theta);
        (motion, self.follower.contact(motion))
    }

    /// The same cam on another base circle.
    ///
    /// # Errors
    /// When the follower cannot rest on that base circle.
    pub fn with_base_radius(&self, base_radius: f64) -> Result<Self, CamError> {
        Ok(Self { follower: self.follower.with_base_radius(base_radius)?, program: self.program.clone() })
    }

    /// A point of the fixed frame, at cam angle θ, in the cam's frame: p·e^(−iσθ).
    #[must_use]
    pub fn in_cam_frame(&self, point: Complex<f64>, theta: f64) -> Complex<f64> {
        point * Complex::from_polar(1.0, -self.follower.rotation.sigma() * theta)
    }
}
