//! How the segments of a program make a whole cycle.

use std::f64::consts::{PI, TAU};

/// How segments make a whole cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cycle {
    /// They cover one turn, and the last joins the first.
    Turn,
    /// They cover half a turn, and the other half is theirs upside down: s(θ + π) = L − s(θ), with L the whole rise. Cams of
    /// constant breadth move so.
    Mirrored,
    /// They cover a travel of this length, forth and then back, so that each end joins itself.
    Travel(f64),
}

impl Cycle {
    /// What the segments must add up to: radians, or length.
    pub(crate) fn given(self) -> f64 {
        match self {
            Self::Turn => TAU,
            Self::Mirrored => PI,
            Self::Travel(length) => length,
        }
    }

    /// What the program covers: radians, or length.
    pub(crate) fn span(self) -> f64 {
        match self {
            Self::Turn | Self::Mirrored => TAU,
            Self::Travel(length) => length,
        }
    }
}
