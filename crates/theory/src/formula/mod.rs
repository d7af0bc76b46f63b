//! Formulas as data: written in a plain notation, printed as MathML, and evaluated, so that what is printed can be tested.
//!
//! `tan(φ) = (v - σe)/(s_0 + s)` reads as in a book: letters side by side are multiplied, `_` lowers, `^` raises, `/` makes a
//! fraction of the factor before it and the factor after it, `'` is a derivative, `{…}` is text.

mod evaluate;
mod mathml;
mod parse;

pub use mathml::{block, inline};
pub use parse::{Misprint, parse};

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// A number, as it is written.
    Number(String),
    /// A magnitude: a letter with its index after `_` and its primes.
    Symbol(String),
    /// Words or a unit within a formula.
    Text(String),
    /// −a
    Negative(Box<Formula>),
    /// a + b − c: the sign before each term.
    Sum(Vec<(char, Formula)>),
    /// a b c
    Product(Vec<Formula>),
    /// a · b, or the cross product a × b.
    Times(char, Box<Formula>, Box<Formula>),
    /// a over b.
    Fraction(Box<Formula>, Box<Formula>),
    /// a raised to b.
    Power(Box<Formula>, Box<Formula>),
    /// A function of something.
    Call(&'static str, Box<Formula>),
    /// The value of a function at a place: y(x).
    Apply(Box<Formula>, Box<Formula>),
    /// |a|
    Size(Box<Formula>),
    /// `[a]`, where the brackets are meant to be seen.
    Bracket(Box<Formula>),
    /// a = b ≤ c: the first side, and what follows with the sign before it.
    Relation(Box<Formula>, Vec<(char, Formula)>),
    /// a, b, c
    List(Vec<Formula>),
}

impl Formula {
    /// The sides of an equation; a formula that relates nothing has one.
    #[must_use]
    pub fn sides(&self) -> Vec<&Formula> {
        match self {
            Self::Relation(first, rest) => std::iter::once(&**first).chain(rest.iter().map(|(_, side)| side)).collect(),
            other => vec![other],
        }
    }
}
