//! Why a change of a design is not possible, whatever the design would be after it.

/// Why an edit is not possible, apart from what is wrong with the design after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EditRefusal {
    /// There is no such item.
    NoItem {
        /// Its index.
        found: usize,
        /// How many there are.
        count: usize,
    },
    /// Nothing is left of the cycle, or nothing of the height.
    NothingLeft,
    /// The last segment is shorter than what is to be given back.
    LastTooShort,
    /// No segment can take the height.
    NothingMoves,
    /// The segment has no conditions.
    NoConditions,
    /// The segment has no formula.
    NoFormula,
    /// The design drives nothing.
    NoApplication,
    /// The cam is not one of constant breadth.
    NoGenerator,
    /// No second cam tied in that way works.
    NoSecondCam,
}
