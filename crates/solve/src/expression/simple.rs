//! A tree as short as by hand.

use super::product;
use super::tree::Tree::{self, Number};

/// Without what adds nothing, and with like factors of a product together.
pub fn simple(tree: Tree) -> Tree {
    let zero = |tree: &Tree| *tree == Number(0.0);
    let lighter = |tree: Box<Tree>| Box::new(simple(*tree));
    match tree {
        Tree::Add(a, b) => match (lighter(a), lighter(b)) {
            (a, b) if zero(&a) => *b,
            (a, b) if zero(&b) => *a,
            (a, b) => match *b {
                Tree::Neg(b) => Tree::Sub(a, b),
                b => Tree::Add(a, Box::new(b)),
            },
        },
        Tree::Sub(a, b) => match (lighter(a), lighter(b)) {
            (a, b) if zero(&b) => *a,
            (a, b) if zero(&a) => simple(Tree::Neg(b)),
            (a, b) => match *b {
                Tree::Neg(b) => Tree::Add(a, b),
                b => Tree::Sub(a, Box::new(b)),
            },
        },
        Tree::Neg(a) => product::of(&Tree::Neg(lighter(a))),
        Tree::Mul(a, b) => product::of(&Tree::Mul(lighter(a), lighter(b))),
        Tree::Div(a, b) => product::of(&Tree::Div(lighter(a), lighter(b))),
        Tree::Pow(a, b) => product::of(&Tree::Pow(lighter(a), lighter(b))),
        Tree::Call(function, a) => Tree::Call(function, lighter(a)),
        other => other,
    }
}
