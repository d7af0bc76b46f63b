//! The names that an expression may use.

use super::{Constant, Function};

/// What a name stands for.
#[derive(Clone, Copy)]
pub(super) enum Meaning {
    Constant(Constant),
    Function(Function),
}

/// Every name, in the spellings that people type.
const NAMES: &[(&str, Meaning)] = &[
    ("x", Meaning::Constant(Constant::X)),
    ("θ", Meaning::Constant(Constant::Theta)),
    ("theta", Meaning::Constant(Constant::Theta)),
    ("β", Meaning::Constant(Constant::Beta)),
    ("beta", Meaning::Constant(Constant::Beta)),
    ("L", Meaning::Constant(Constant::Rise)),
    ("s0", Meaning::Constant(Constant::Start)),
    ("s₀", Meaning::Constant(Constant::Start)),
    ("π", Meaning::Constant(Constant::Pi)),
    ("pi", Meaning::Constant(Constant::Pi)),
    ("e", Meaning::Constant(Constant::Euler)),
    ("sin", Meaning::Function(Function::Sin)),
    ("sen", Meaning::Function(Function::Sin)),
    ("cos", Meaning::Function(Function::Cos)),
    ("tan", Meaning::Function(Function::Tan)),
    ("asin", Meaning::Function(Function::Asin)),
    ("acos", Meaning::Function(Function::Acos)),
    ("atan", Meaning::Function(Function::Atan)),
    ("sinh", Meaning::Function(Function::Sinh)),
    ("cosh", Meaning::Function(Function::Cosh)),
    ("tanh", Meaning::Function(Function::Tanh)),
    ("exp", Meaning::Function(Function::Exp)),
    ("ln", Meaning::Function(Function::Ln)),
    ("log", Meaning::Function(Function::Log)),
    ("sqrt", Meaning::Function(Function::Sqrt)),
];

/// The longest name with which a text begins.
pub(super) fn longest(text: &str) -> Option<(&'static str, Meaning)> {
    NAMES.iter().filter(|(known, _)| text.starts_with(known)).max_by_key(|(known, _)| known.len()).copied()
}
