//! The derivative of a tree by the rules of the blackboard.

use super::tree::Tree::{self, Number};
use super::tree::varies;
use levalab_core::{ExpressionConstant as Constant, ExpressionFunction as Function};

/// With respect to θ.
pub fn derivative(tree: &Tree) -> Tree {
    let d = |tree: &Tree| Box::new(derivative(tree));
    let number = |value: f64| Box::new(Number(value));
    let mul = |a: Box<Tree>, b: Box<Tree>| Box::new(Tree::Mul(a, b));
    match tree {
        _ if !varies(tree) => Number(0.0),
        Tree::Name(Constant::X) => Tree::Div(number(1.0), Box::new(Tree::Name(Constant::Beta))),
        Number(_) => Number(0.0),
        Tree::Name(_) => Number(1.0),
        Tree::Neg(a) => Tree::Neg(d(a)),
        Tree::Add(a, b) => Tree::Add(d(a), d(b)),
        Tree::Sub(a, b) => Tree::Sub(d(a), d(b)),
        Tree::Mul(a, b) if !varies(a) => Tree::Mul(a.clone(), d(b)),
        Tree::Mul(a, b) => Tree::Add(mul(d(a), b.clone()), mul(a.clone(), d(b))),
        Tree::Div(a, b) if !varies(b) => Tree::Div(d(a), b.clone()),
        Tree::Div(a, b) => Tree::Div(
            Box::new(Tree::Sub(mul(d(a), b.clone()), mul(a.clone(), d(b)))),
            Box::new(Tree::Pow(b.clone(), number(2.0))),
        ),
        Tree::Pow(a, b) if !varies(b) => {
            let lower = match **b {
                Number(value) => Number(value - 1.0),
                _ => Tree::Sub(b.clone(), number(1.0)),
            };
            Tree::Mul(mul(b.clone(), Box::new(Tree::Pow(a.clone(), Box::new(lower)))), d(a))
        }
        Tree::Pow(a, b) => {
            // u^w = e^(w ln u).
            let exponent = mul(b.clone(), Box::new(Tree::Call(Function::Ln, a.clone())));
            Tree::Mul(Box::new(tree.clone()), d(&exponent))
        }
        Tree::Call(function, a) => Tree::Mul(Box::new(outer(*function, a)), d(a)),
    }
}

/// The derivative of a function at its argument.
fn outer(function: Function, u: &Tree) -> Tree {
    let call = |function: Function| Box::new(Tree::Call(function, Box::new(u.clone())));
    let number = |value: f64| Box::new(Number(value));
    let square = |tree: Box<Tree>| Box::new(Tree::Pow(tree, number(2.0)));
    let own = || Box::new(u.clone());
    match function {
        Function::Sin => *call(Function::Cos),
        Function::Cos => Tree::Neg(call(Function::Sin)),
        Function::Tan => Tree::Add(number(1.0), square(call(Function::Tan))),
        Function::Asin => Tree::Div(
            number(1.0),
            Box::new(Tree::Call(Function::Sqrt, Box::new(Tree::Sub(number(1.0), square(own()))))),
        ),
        Function::Acos => Tree::Neg(Box::new(outer(Function::Asin, u))),
        Function::Atan => Tree::Div(number(1.0), Box::new(Tree::Add(number(1.0), square(own())))),
        Function::Sinh => *call(Function::Cosh),
        Function::Cosh => *call(Function::Sinh),
        Function::Tanh => Tree::Sub(number(1.0), square(call(Function::Tanh))),
        Function::Exp => *call(Function::Exp),
        Function::Ln => Tree::Div(number(1.0), own()),
        Function::Log => {
            Tree::Div(number(1.0), Box::new(Tree::Mul(own(), Box::new(Tree::Call(Function::Ln, number(10.0))))))
        }
        Function::Sqrt => Tree::Div(number(1.0), Box::new(Tree::Mul(number(2.0), call(Function::Sqrt)))),
    }
}
