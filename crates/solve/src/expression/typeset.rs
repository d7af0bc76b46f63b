//! A tree as a formula, with no more parentheses, points and signs than by hand.

use super::tree::Tree::{self, Number};
use crate::number;
use levalab_core::{ExpressionConstant as Constant, ExpressionFunction as Function};
use levalab_formula::Formula;

/// The formula of a tree.
pub fn formula(tree: &Tree) -> Formula {
    let of = |tree: &Tree| Box::new(formula(tree));
    match tree {
        Number(value) => number::number(&number::datum(*value)),
        Tree::Name(name) => Formula::Symbol(
            match name {
                Constant::X => "x",
                Constant::Theta => "θ",
                Constant::Beta => "β",
                Constant::Rise => "L",
                Constant::Start => "s_0",
                Constant::Pi => "π",
                Constant::Euler => "e",
            }
            .to_owned(),
        ),
        Tree::Neg(a) => Formula::Negative(of(a)),
        Tree::Add(a, b) => sum(a, '+', b),
        Tree::Sub(a, b) => sum(a, '−', b),
        Tree::Mul(a, b) => times(formula(a), formula(b)),
        Tree::Div(a, b) => Formula::Fraction(of(a), of(b)),
        Tree::Pow(a, b) => {
            // A sign, a product or a fraction below a power is told apart by the writers' parentheses.
            Formula::Power(of(a), of(b))
        }
        Tree::Call(Function::Sqrt, a) => Formula::Call("sqrt", of(a)),
        Tree::Call(Function::Exp, a) => Formula::Call("exp", of(a)),
        Tree::Call(function, a) => Formula::Call(
            match function {
                Function::Sin => "sin",
                Function::Cos => "cos",
                Function::Tan => "tan",
                Function::Asin => "arcsin",
                Function::Acos => "arccos",
                Function::Atan => "arctan",
                Function::Sinh => "sinh",
                Function::Cosh => "cosh",
                Function::Tanh => "tanh",
                Function::Log => "log",
                _ => "ln",
            },
            of(a),
        ),
    }
}

fn sum(a: &Tree, sign: char, b: &Tree) -> Formula {
    let mut terms = match formula(a) {
        Formula::Sum(terms) => terms,
        Formula::Negative(inner) => vec![('−', *inner)],
        other => vec![('+', other)],
    };
    terms.push((sign, formula(b)));
    Formula::Sum(terms)
}

/// True for what ends with the argument of a function, which would swallow a factor after it.
fn ends_with_function(formula: &Formula) -> bool {
    match formula {
        Formula::Call(name, _) => !["sqrt", "exp"].contains(name),
        Formula::Power(base, _) => ends_with_function(base),
        Formula::Product(factors) => factors.last().is_some_and(ends_with_function),
        Formula::Times(_, _, last) => ends_with_function(last),
        _ => false,
    }
}

fn times(a: Formula, b: Formula) -> Formula {
    let pointed = ends_with_function(&a)
        || matches!(b, Formula::Number(_) | Formula::Negative(_))
        || matches!(&b, Formula::Power(base, _) if matches!(**base, Formula::Number(_)));
    if pointed {
        return Formula::Times('·', Box::new(a), Box::new(b));
    }
    let mut factors = match a {
        Formula::Product(factors) => factors,
        other => vec![other],
    };
    match b {
        Formula::Product(more) if !matches!(more.first(), Some(Formula::Number(_))) => factors.extend(more),
        other => factors.push(other),
    }
    Formula::Product(factors)
}
