//! Motion laws: how a follower goes from one height to the next.
//!
//! A law is a list of smooth pieces ([`Piece`]) over x ∈ [0, 1]; each piece is one [`Curve`]. Everything else (scaling
//! to β and L, one-sided limits, extremes, formulas on paper) follows from that list. To add a law, write one file with
//! a `pub const LAW: Law` and name it in [`LAWS`].

mod asymmetric_3_4_5;
mod bezier;
mod bspline;
mod circular_arc;
mod conditions;
mod constant_velocity;
mod cubic_1;
mod cubic_2;
mod cycloidal;
mod data;
mod double_harmonic;
mod dwell;
mod formula;
mod freudenstein_1_3_5;
mod half_cycloidal_end;
mod half_cycloidal_start;
mod half_harmonic_end;
mod half_harmonic_start;
mod matched;
mod modified_sine;
mod modified_trapezoidal;
mod parabolic;
mod parabolic_blend;
mod piece;
mod polynomial;
mod polynomial_3_4_5;
mod polynomial_4_5_6_7;
mod polynomial_5;
mod polynomial_7;
mod scca;
mod simple_harmonic;
mod skew;
mod skewed_scca;
mod system;
mod table;
#[cfg(test)]
mod tests;

pub use bezier::MAX_ORDINATES;
pub use bspline::{MAX_SPLINE_CONDITIONS, usual_knots};
pub use circular_arc::LAW as CIRCULAR_ARC;
pub use data::{Condition, Data, DataKind, DataProblem, Given, Solved};
pub use matched::end_system;
pub use piece::Piece;
pub use polynomial::MAX_CONDITIONS;
pub use system::{ConditionSystem, System, condition_system};
pub use table::MAX_POINTS;

pub(crate) use matched::matched_polynomial;

use crate::{Curve, Parameter, Svaj};
use piece::{halves, single};

/// Every law there is, in the order in which a menu shows them.
pub const LAWS: &[&Law] = &[
    &dwell::LAW,
    &constant_velocity::LAW,
    &parabolic::LAW,
    &parabolic_blend::LAW,
    &cubic_1::LAW,
    &cubic_2::LAW,
    &simple_harmonic::LAW,
    &double_harmonic::LAW,
    &cycloidal::LAW,
    &freudenstein_1_3_5::LAW,
    &polynomial_3_4_5::LAW,
    &polynomial_4_5_6_7::LAW,
    &modified_trapezoidal::LAW,
    &modified_sine::LAW,
    &scca::LAW,
    &skewed_scca::LAW,
    &asymmetric_3_4_5::LAW,
    &half_harmonic_start::LAW,
    &half_harmonic_end::LAW,
    &half_cycloidal_start::LAW,
    &half_cycloidal_end::LAW,
    &polynomial_5::LAW,
    &polynomial_7::LAW,
    &polynomial::LAW,
    &bspline::LAW,
    &bezier::LAW,
    &table::LAW,
    &formula::LAW,
];

/// Most parameters of its own that a law takes.
pub const MAX_LAW_PARAMETERS: usize = 3;

/// A motion law.
#[derive(Debug)]
pub struct Law {
    /// The name used in design files and links, such as `cycloidal`.
    pub id: &'static str,
    /// Where a menu files it.
    pub group: Group,
    /// What it takes besides β and L.
    pub parameters: &'static [Parameter],
    /// How its curve is found.
    pub shape: Shape,
}

/// The families that a menu shows apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Pieces that every program is built from: dwell, constant velocity.
    Basic,
    /// Whole rises and returns, at rest at both ends.
    Standard,
    /// Half motions, at rest at one end only.
    Half,
    /// Polynomials that take their end conditions from their neighbours.
    Matched,
    /// Curves from the user's own data.
    Free,
}

/// How the curve of a law is found.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Stays where it is: y = 0, and no rise is possible.
    Rest,
    /// A fixed curve from (0, 0) to (1, 1).
    Unit(fn(Arguments) -> Result<Vec<Piece>, ArgumentProblem>),
    /// One polynomial that agrees with both neighbours in this many orders (*s* is the first).
    Matched(usize),
    /// A curve from data of the segment's own, which say where it begins and ends: its rise follows from them.
    Free(Free),
}

/// How a law is found from data.
#[derive(Clone, Copy, Debug)]
pub struct Free {
    /// What data it takes.
    pub data: DataKind,
    /// The data that a form starts with, for β, a starting height and a rise.
    pub first: fn(f64, f64, f64) -> Data,
    /// The curve, in the units of the design.
    pub solve: fn(&Given) -> Result<Solved, DataProblem>,
}

/// What a unit curve may depend on.
#[derive(Clone, Copy, Debug)]
pub struct Arguments {
    /// The law's own parameters, in the order of [`Law::parameters`].
    pub parameters: [f64; MAX_LAW_PARAMETERS],
    /// True for a return (L < 0).
    pub falling: bool,
    /// The β spanned, radians.
    pub beta: f64,
}

/// Why a law refuses its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArgumentProblem {
    /// Index into [`Law::parameters`] of the one to correct.
    pub parameter: usize,
    /// Least value that would do.
    pub min: f64,
    /// Greatest value that would do.
    pub max: f64,
}

/// Laws are the entries of [`LAWS`]: the same name is the same law.
impl PartialEq for Law {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Law {
    /// The law of that name.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static Law> {
        LAWS.iter().copied().find(|law| law.id == id)
    }

    /// True when the law takes its end conditions from its neighbours.
    #[must_use]
    pub fn is_matched(&self) -> bool {
        matches!(self.shape, Shape::Matched(_))
    }

    /// True when the follower stays still.
    #[must_use]
    pub fn is_dwell(&self) -> bool {
        matches!(self.shape, Shape::Rest)
    }

    /// How it is found from data, for a law that is.
    #[must_use]
    pub fn free(&self) -> Option<&Free> {
        match &self.shape {
            Shape::Free(free) => Some(free),
            _ => None,
        }
    }

    /// The data that a form starts with, for β, a starting height and a rise.
    #[must_use]
    pub fn first_data(&self, beta: f64, start: f64, rise: f64) -> Data {
        self.free().map_or(Data::None, |free| (free.first)(beta, start, rise))
    }

    /// The law's own parameters at the values a form starts with.
    #[must_use]
    pub fn default_parameters(&self) -> [f64; MAX_LAW_PARAMETERS] {
        let mut values = [0.0; MAX_LAW_PARAMETERS];
        for (value, parameter) in values.iter_mut().zip(self.parameters) {
            *value = parameter.default.unwrap_or(0.0);
        }
        values
    }

    /// The law between two rests, from (0, 0) to (1, 1), as smooth pieces; a free law with the data that a form starts with.
    ///
    /// # Errors
    /// When a parameter of the law is outside the range that makes a curve.
    pub fn unit(&self, arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
        match self.shape {
            Shape::Rest => Ok(single(Curve::polynomial(&[0.0]))),
            Shape::Unit(pieces) => pieces(arguments),
            Shape::Matched(orders) => {
                let curve = matched_polynomial(orders, Svaj::default(), Svaj::new(1.0, 0.0, 0.0, 0.0));
                Ok(single(curve))
            }
            Shape::Free(Free { first, solve, .. }) => {
                let data = first(1.0, 0.0, 1.0);
                Ok(solve(&Given { data: &data, rise: 1.0, parameters: arguments.parameters, ..Given::default() })
                    .map_or_else(|_| Vec::new(), |solved| solved.pieces))
            }
        }
    }
}
