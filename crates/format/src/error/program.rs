//! What can be wrong with the segments of a design, taken together.

use crate::Measure;

/// Why segments make no program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProgramRefusal {
    /// No segments at all.
    NoSegments,
    /// More segments than a program may have.
    TooManySegments {
        /// How many there are.
        found: usize,
        /// The most there may be.
        limit: usize,
    },
    /// More points in all tables together than a design may have.
    TooManyPoints {
        /// How many there are.
        found: usize,
        /// The most there may be.
        limit: usize,
    },
    /// A dwell with a rise.
    DwellRises {
        /// The rise.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
    /// Two polynomials side by side that would take their end conditions from each other.
    AdjacentPolynomials {
        /// Index of the other segment.
        next: usize,
    },
    /// The β's do not add up to the cycle.
    Turn {
        /// Their sum.
        found: f64,
        /// What they should add up to: 360° (180° for half a turn that is mirrored), or the length of a travel.
        whole: f64,
        /// What they measure.
        measure: Measure,
    },
    /// The rises do not lead back to the starting height.
    Closing {
        /// The height they lead to.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
    /// The first segment does not begin on the base circle.
    Beginning {
        /// The height at which it begins.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
    /// A segment ends below the base circle.
    BelowBase {
        /// The height it ends at.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
}
