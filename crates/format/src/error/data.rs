//! What can be wrong with the data of a free law.

use crate::Measure;
use levalab_core::{ExpressionProblem, RoughnessCause};

/// What can be wrong with the data of a free law. Angles are in degrees and lengths in the unit of the design.
#[derive(Clone, Debug, PartialEq)]
pub enum DataRefusal {
    /// An order of a derivative that is none of 0, 1, 2 and 3.
    WrongOrder {
        /// The order.
        found: f64,
    },
    /// Too few items in a list, or too many.
    WrongCount {
        /// How many there are.
        found: usize,
        /// The least there may be.
        min: usize,
        /// The most there may be.
        max: usize,
    },
    /// A condition on the same derivative at the same place as one before it.
    Repeated {
        /// Index of that one.
        other: usize,
    },
    /// No condition says a height.
    NoHeight,
    /// No single curve meets the conditions, since some depend on each other.
    Dependent {
        /// Indices of those that do.
        items: Vec<usize>,
    },
    /// Another number of knots than the conditions and the degree of a spline need.
    KnotCount {
        /// How many there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A knot that does not lie within the segment, after the one before it.
    KnotOrder,
    /// Knots that leave a condition outside the part of the curve that it would hold.
    KnotPlace {
        /// Index of the condition.
        item: usize,
        /// It should lie after this place.
        from: f64,
        /// And before this one.
        to: f64,
        /// What places are measured in.
        measure: Measure,
    },
    /// The first or the last point of a table is not where the segment begins or ends.
    NotAtEnd {
        /// Where it is.
        found: f64,
        /// Where it should be.
        expected: f64,
        /// What places are measured in.
        measure: Measure,
    },
    /// A point of a table that does not come after the one before it.
    Unordered,
    /// A text that is no expression.
    Expression(ExpressionProblem),
    /// An expression that has no value, or no derivative, near an x.
    Undefined {
        /// The x.
        x: f64,
        /// Why.
        cause: RoughnessCause,
    },
    /// A rise that is not what the data of the segment come to.
    RiseDisagrees {
        /// The rise.
        found: f64,
        /// What the data come to.
        expected: f64,
        /// What it measures.
        measure: Measure,
    },
}
