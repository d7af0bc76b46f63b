//! Formulas as data: written in a plain notation, printed as MathML and LaTeX, and evaluated, so that what is printed can be tested.
//!
//! `tan(φ) = (v - σe)/(s_0 + s)` reads as in a book: letters side by side are multiplied, `_` lowers, `^` raises, `/` makes a
//! fraction of the factor before it and the factor after it, `'` is a derivative, `{…}` is text. [`curve`] writes the formulas of a law
//! from the curve that the core computes with, and [`exact`] finds the fractions and powers of π behind its decimals.

pub mod curve;
mod evaluate;
pub mod exact;
mod latex;
mod markup;
mod mathml;
mod parse;

pub use latex::{latex, latex_lacks, latex_text};
pub use markup::{Element, Node, escape};
pub use mathml::{block, inline, math};
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
    /// Rows of a matrix in parentheses; one column is a vector. Not of the plain notation.
    Matrix(Vec<Vec<Formula>>),
    /// An equation over several lines, each with the sign before it; + and − go on with the line above. Not of the plain notation.
    Lines(Box<Formula>, Vec<(char, Formula)>),
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

    /// The parts that it is made of, one level down.
    pub fn parts_mut(&mut self) -> Vec<&mut Formula> {
        match self {
            Self::Number(_) | Self::Symbol(_) | Self::Text(_) => Vec::new(),
            Self::Negative(a) | Self::Size(a) | Self::Bracket(a) | Self::Call(_, a) => vec![a],
            Self::Times(_, a, b) | Self::Fraction(a, b) | Self::Power(a, b) | Self::Apply(a, b) => vec![a, b],
            Self::Product(parts) | Self::List(parts) => parts.iter_mut().collect(),
            Self::Sum(terms) => terms.iter_mut().map(|(_, term)| term).collect(),
            Self::Relation(first, rest) | Self::Lines(first, rest) => {
                std::iter::once(&mut **first).chain(rest.iter_mut().map(|(_, side)| side)).collect()
            }
            Self::Matrix(rows) => rows.iter_mut().flatten().collect(),
        }
    }
}

/// How tightly a formula holds together: parentheses go around what is looser than its surroundings.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Bond {
    List,
    Relation,
    Sum,
    Product,
    Atom,
}

fn bond(formula: &Formula) -> Bond {
    match formula {
        Formula::List(_) => Bond::List,
        Formula::Relation(..) | Formula::Lines(..) => Bond::Relation,
        Formula::Sum(_) | Formula::Negative(_) => Bond::Sum,
        Formula::Product(_) | Formula::Times(..) => Bond::Product,
        _ => Bond::Atom,
    }
}

/// What a function is applied to stands bare when nothing could be taken for what follows.
fn is_bare(argument: &Formula) -> bool {
    let plain = |formula: &Formula| matches!(formula, Formula::Symbol(_) | Formula::Number(_));
    match argument {
        Formula::Product(factors) => factors.iter().all(plain),
        other => plain(other),
    }
}

/// True for what begins with the name of a function.
fn is_named(formula: &Formula) -> bool {
    match formula {
        Formula::Call(name, _) => !["sqrt", "exp"].contains(name),
        Formula::Power(base, _) => is_named(base),
        _ => false,
    }
}

/// A letter, its index and how many primes it has.
fn letter_of(symbol: &str) -> (&str, &str, usize) {
    let bare = symbol.trim_end_matches('\'');
    let (letter, index) = bare.split_once('_').unwrap_or((bare, ""));
    (letter, index, symbol.len() - bare.len())
}

/// True for what follows a number without a space: degrees, and the sign of a factorial.
fn is_close(unit: &str) -> bool {
    unit.starts_with(['°', '!'])
}

/// True for an index that counts: a number, or a letter that stands for one. Others say what is meant, as b does of a base circle.
fn is_variable(index: &str) -> bool {
    index.chars().all(|c| c.is_ascii_digit()) || ["i", "k", "m", "n"].contains(&index)
}
