//! Why a text is no expression, pointing at a character.

/// Longest expression, characters.
pub const MAX_EXPRESSION: usize = 512;

/// Why a text is no expression, at which character (from 0).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpressionProblem {
    /// The character to look at; one past the last where something is missing.
    pub at: usize,
    /// What is wrong there.
    pub kind: ExpressionFault,
}

/// Where an expression is not smooth up to its third derivative, and why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roughness {
    /// The x.
    pub x: f64,
    /// Why.
    pub cause: RoughnessCause,
}

/// Why an expression is not smooth up to its third derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoughnessCause {
    /// A fractional power below the third, or a root, of what becomes zero.
    Power,
    /// A division by what becomes zero.
    Division,
    /// A value too large to be computed with.
    TooLarge,
    /// The edge of where a function is defined.
    Edge,
}

/// What can be wrong with the text of an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExpressionFault {
    /// Nothing is there, or it ends where a number, a variable or a parenthesis should come.
    Ends,
    /// More characters than an expression may have.
    TooLong {
        /// The most.
        limit: usize,
    },
    /// Nested deeper than anyone writes.
    TooDeep,
    /// A character that has no meaning, or none here.
    Unexpected(char),
    /// A name that stands for nothing.
    Unknown(String),
    /// A parenthesis that is not closed.
    Open,
    /// A function without its parenthesis.
    NoArgument(String),
    /// A number that cannot be held.
    Number,
}
