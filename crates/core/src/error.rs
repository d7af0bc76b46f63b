//! What cannot be a cam, and why. Words for people are made elsewhere; here are the facts.

use crate::law::DataProblem;
use std::fmt;

/// Why a cam cannot be built.
#[derive(Clone, Debug, PartialEq)]
pub enum CamError {
    /// The motion program cannot be.
    Program(ProgramError),
    /// The base circle or the follower cannot be.
    Geometry(GeometryError),
}

/// What is wrong with a motion program, and the segment to look at.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramError {
    /// Index of the segment, from 0.
    pub segment: usize,
    /// What is wrong with it. Angles in radians.
    pub problem: ProgramProblem,
}

/// What can be wrong with a motion program.
#[derive(Clone, Debug, PartialEq)]
pub enum ProgramProblem {
    /// No segments, or too many.
    Count {
        /// How many there are.
        found: usize,
    },
    /// A β that is not finite, not positive, or more than a turn.
    Beta {
        /// The β given, radians.
        found: f64,
    },
    /// A rise that is not finite.
    Rise {
        /// The rise given.
        found: f64,
    },
    /// A dwell with a rise.
    DwellRises {
        /// The rise given.
        found: f64,
    },
    /// A law's own parameter out of its range.
    Parameter {
        /// Name of the parameter.
        key: &'static str,
        /// The value given.
        found: f64,
        /// Least value accepted.
        min: f64,
        /// Greatest value accepted.
        max: f64,
    },
    /// The data of a free law do not make a curve.
    Data(DataProblem),
    /// Two generic polynomials side by side.
    AdjacentPolynomials {
        /// Index of the other one.
        next: usize,
    },
    /// The β's do not add up to the cycle: a turn, half of one, or the length of a travel.
    Turn {
        /// Their sum, radians or length.
        found: f64,
    },
    /// The last segment does not come back to the height of the first.
    Closing {
        /// The height at the end.
        found: f64,
    },
    /// The first segment does not begin at the height 0, and so the turn cannot close.
    Beginning {
        /// The height at which it begins.
        found: f64,
    },
    /// A segment ends below the base circle.
    BelowBase {
        /// The height it ends at.
        found: f64,
    },
}

/// What is wrong with the geometry, and the magnitude to look at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeometryError {
    /// `base_radius`, or the key of a follower's parameter.
    pub key: &'static str,
    /// What is wrong with it.
    pub problem: GeometryProblem,
}

/// What can be wrong with a magnitude. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GeometryProblem {
    /// Not a finite number.
    NotFinite,
    /// Zero or negative where a positive value is needed.
    NotPositive {
        /// The value given.
        found: f64,
    },
    /// It has no meaning for this kind of cam: a base circle of a cam that travels, a flat face on one.
    Unsuited,
    /// Outside an open interval.
    Outside {
        /// The value given.
        found: f64,
        /// It must be greater than this.
        min: f64,
        /// It must be less than this.
        max: f64,
    },
    /// The follower does not come together with its base circle.
    Misfit(Misfit),
}

/// Lengths that no follower on its base circle has together. In whatever unit the design uses: no angle is among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Misfit {
    /// The eccentricity reaches the prime circle, so the follower's axis misses it: |e| ≥ Rp.
    Eccentricity {
        /// e, signed.
        eccentricity: f64,
        /// Rp.
        prime_radius: f64,
    },
    /// Pivot distance, arm and prime radius make no triangle: one of them is not less than the other two together.
    Triangle {
        /// m.
        pivot_distance: f64,
        /// A.
        arm: f64,
        /// Rp.
        prime_radius: f64,
    },
    /// The face cannot touch the base circle from a pivot so near: m ≤ |Rb − f|.
    FaceOutOfReach {
        /// m.
        pivot_distance: f64,
        /// |Rb − f|, which m must exceed.
        needed: f64,
    },
}

impl From<ProgramError> for CamError {
    fn from(error: ProgramError) -> Self {
        Self::Program(error)
    }
}

impl From<GeometryError> for CamError {
    fn from(error: GeometryError) -> Self {
        Self::Geometry(error)
    }
}

impl fmt::Display for CamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Program(error) => write!(f, "segment {}: {:?}", error.segment + 1, error.problem),
            Self::Geometry(error) => write!(f, "{}: {:?}", error.key, error.problem),
        }
    }
}

impl std::error::Error for CamError {}
