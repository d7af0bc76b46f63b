//! An expression as a tree.

use levalab_core::{ExpressionConstant as Constant, ExpressionFunction as Function, ExpressionOp as Op};

/// An expression as a tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    Number(f64),
    Name(Constant),
    Add(Box<Tree>, Box<Tree>),
    Sub(Box<Tree>, Box<Tree>),
    Mul(Box<Tree>, Box<Tree>),
    Div(Box<Tree>, Box<Tree>),
    Neg(Box<Tree>),
    Pow(Box<Tree>, Box<Tree>),
    Call(Function, Box<Tree>),
}

/// The tree of operations whose operands come before them.
pub fn tree_of(ops: &[Op]) -> Option<Tree> {
    let mut stack: Vec<Box<Tree>> = Vec::new();
    for op in ops {
        let tree = match *op {
            Op::Number(value) => Tree::Number(value),
            Op::Constant(name) => Tree::Name(name),
            Op::Neg => Tree::Neg(stack.pop()?),
            Op::Call(function) => Tree::Call(function, stack.pop()?),
            Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Pow => {
                let (right, left) = (stack.pop()?, stack.pop()?);
                match op {
                    Op::Add => Tree::Add(left, right),
                    Op::Sub => Tree::Sub(left, right),
                    Op::Mul => Tree::Mul(left, right),
                    Op::Div => Tree::Div(left, right),
                    _ => Tree::Pow(left, right),
                }
            }
        };
        stack.push(Box::new(tree));
    }
    stack.pop().map(|tree| *tree)
}

/// True when the tree names a variable or a constant.
pub fn names(tree: &Tree, name: Constant) -> bool {
    match tree {
        Tree::Number(_) => false,
        Tree::Name(known) => *known == name,
        Tree::Neg(a) | Tree::Call(_, a) => names(a, name),
        Tree::Add(a, b) | Tree::Sub(a, b) | Tree::Mul(a, b) | Tree::Div(a, b) | Tree::Pow(a, b) => {
            names(a, name) || names(b, name)
        }
    }
}

/// True when the tree changes along the segment.
pub fn varies(tree: &Tree) -> bool {
    names(tree, Constant::X) || names(tree, Constant::Theta)
}
