//! Products of powers joined into one power of each base: x^2.5·x is smooth at 0 as x^3.5, though its factor x^2.5 is not.

use super::{Constant, Expression, Op, Variables, domain};

/// A factor of a product: operations that give its base, and its exponent.
#[derive(Clone)]
struct Factor {
    base: Vec<Op>,
    exponent: f64,
}

/// An operand on the stack as a product of factors.
type Product = Vec<Factor>;

/// The same expression with the powers of each base joined, where x from 0 to 1 allows it.
pub(super) fn joined(expression: &Expression, variables: &Variables) -> Expression {
    let mut stack: Vec<Product> = Vec::new();
    for op in &expression.ops {
        let mut pop = || stack.pop().unwrap_or_default();
        let product = match *op {
            Op::Number(_) | Op::Constant(_) => single(vec![*op]),
            Op::Neg => multiplied(single(vec![Op::Number(-1.0)]), pop()),
            Op::Call(super::Function::Sqrt) => raised(pop(), 0.5, variables),
            Op::Call(_) => {
                let mut ops = written(pop());
                ops.push(*op);
                single(ops)
            }
            Op::Mul | Op::Div | Op::Pow | Op::Add | Op::Sub => {
                let (right, left) = (pop(), pop());
                match (*op, constant(&right, variables)) {
                    (Op::Mul, _) => multiplied(left, right),
                    (Op::Div, _) => multiplied(left, inverted(right)),
                    (Op::Pow, Some(exponent)) => raised(left, exponent, variables),
                    _ => {
                        let mut ops = written(left);
                        ops.extend(written(right));
                        ops.push(*op);
                        single(ops)
                    }
                }
            }
        };
        stack.push(product);
    }
    Expression { ops: written(stack.pop().unwrap_or_default()) }
}

fn single(base: Vec<Op>) -> Product {
    vec![Factor { base, exponent: 1.0 }]
}

fn inverted(mut product: Product) -> Product {
    product.iter_mut().for_each(|factor| factor.exponent = -factor.exponent);
    product
}

/// The product of two products: equal bases are joined when one of them has a fractional exponent.
fn multiplied(mut left: Product, right: Product) -> Product {
    for factor in right {
        let same = |other: &&mut Factor| {
            other.base == factor.base && (other.exponent.fract() != 0.0 || factor.exponent.fract() != 0.0)
        };
        match left.iter_mut().find(same) {
            Some(other) => other.exponent += factor.exponent,
            None => left.push(factor),
        }
    }
    left
}

/// A product raised to a power, factor by factor where they have one sign; as a whole where they may not.
fn raised(product: Product, exponent: f64, variables: &Variables) -> Product {
    let never_negative = |factor: &Factor| {
        let base = Expression { ops: factor.base.clone() };
        domain::bounds(&base, variables).is_some_and(|(low, _)| low >= 0.0)
    };
    if exponent.fract() != 0.0 && !product.iter().all(never_negative) {
        let base = written(product);
        return vec![Factor { base, exponent }];
    }
    product.into_iter().map(|factor| Factor { exponent: factor.exponent * exponent, ..factor }).collect()
}

/// The value of an operand that does not vary with x.
fn constant(product: &Product, variables: &Variables) -> Option<f64> {
    let varies = |op: &Op| matches!(op, Op::Constant(Constant::X | Constant::Theta));
    let still = product.iter().all(|factor| !factor.base.iter().any(varies));
    still.then(|| Expression { ops: written(product.clone()) }.at(0.0, variables).0[0])
}

/// The operations of a product.
fn written(product: Product) -> Vec<Op> {
    let mut ops = Vec::new();
    for (k, Factor { base, exponent }) in product.into_iter().enumerate() {
        ops.extend(base);
        if exponent != 1.0 {
            ops.extend([Op::Number(exponent), Op::Pow]);
        }
        if k > 0 {
            ops.push(Op::Mul);
        }
    }
    ops
}
