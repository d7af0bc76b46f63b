//! Products in order: one number, like factors together as powers, functions last.

use super::tree::Tree::{self, Number};
use levalab_core::ExpressionConstant as Constant;

/// A product of a fraction and of factors raised to numbers.
struct Product {
    above: f64,
    below: f64,
    factors: Vec<(Tree, f64)>,
}

/// The same product, quotient, power or opposite in order.
pub fn of(tree: &Tree) -> Tree {
    let mut product = Product { above: 1.0, below: 1.0, factors: Vec::new() };
    product.take(tree, 1.0);
    product.tree()
}

impl Product {
    /// Multiplies by a tree raised to a number.
    fn take(&mut self, tree: &Tree, raised: f64) {
        // A root of a product is not the product of the roots when there are signs.
        let whole = raised.fract() == 0.0;
        match tree {
            Number(value) if whole && *value != 0.0 => {
                if raised > 0.0 {
                    self.above *= value.powf(raised);
                } else {
                    self.below *= value.powf(-raised);
                }
            }
            Number(value) if raised == 1.0 => self.above *= value,
            Tree::Neg(a) if whole => {
                self.above *= (-1.0_f64).powf(raised);
                self.take(a, raised);
            }
            Tree::Mul(a, b) if whole => {
                self.take(a, raised);
                self.take(b, raised);
            }
            Tree::Div(a, b) if whole => {
                self.take(a, raised);
                self.take(b, -raised);
            }
            Tree::Pow(a, b) => match **b {
                Number(k) if whole || k.fract() == 0.0 && raised == 1.0 => self.take(a, k * raised),
                _ => self.factor(tree, raised),
            },
            _ => self.factor(tree, raised),
        }
    }

    fn factor(&mut self, tree: &Tree, raised: f64) {
        match self.factors.iter_mut().find(|(known, _)| known == tree) {
            Some((_, power)) => *power += raised,
            None => self.factors.push((tree.clone(), raised)),
        }
    }

    fn tree(mut self) -> Tree {
        if self.above == 0.0 {
            return Number(0.0);
        }
        // Decimals above and below are left as they were typed, but for what one goes into the other.
        let (above, below) = (self.above.abs(), self.below.abs());
        let negative = (self.above < 0.0) != (self.below < 0.0);
        let (above, below) = match (above / below, below / above) {
            (ratio, _) if ratio.fract() == 0.0 => (ratio, 1.0),
            (_, ratio) if ratio.fract() == 0.0 => (1.0, ratio),
            _ => (above, below),
        };
        self.factors.retain(|(_, raised)| *raised != 0.0);
        self.factors.sort_by_key(|(tree, _)| rank(tree));
        let (top, bottom): (Vec<_>, Vec<_>) = self.factors.into_iter().partition(|(_, raised)| *raised > 0.0);
        let top = joined(above, top);
        let bottom = joined(below, bottom);
        let whole = match bottom {
            Number(1.0) => top,
            bottom => Tree::Div(Box::new(top), Box::new(bottom)),
        };
        match (negative, whole) {
            (true, Number(value)) => Number(-value),
            (true, other) => Tree::Neg(Box::new(other)),
            (false, other) => other,
        }
    }
}

fn joined(number: f64, factors: Vec<(Tree, f64)>) -> Tree {
    let each = factors.into_iter().map(|(tree, raised)| match raised.abs() {
        1.0 => tree,
        raised => Tree::Pow(Box::new(tree), Box::new(Number(raised))),
    });
    let number = (number != 1.0).then_some(Number(number));
    let product = number.into_iter().chain(each).reduce(|before, factor| Tree::Mul(Box::new(before), Box::new(factor)));
    product.unwrap_or(Number(1.0))
}

/// The place of a factor: constants, then what varies, sums, and functions, whose argument would swallow what follows.
fn rank(tree: &Tree) -> u8 {
    match tree {
        Number(_) | Tree::Name(Constant::Pi) => 0,
        Tree::Name(Constant::Rise | Constant::Start | Constant::Euler) => 1,
        Tree::Name(Constant::Beta) => 2,
        Tree::Name(Constant::X | Constant::Theta) => 3,
        Tree::Pow(base, _) => rank(base),
        Tree::Call(..) => 5,
        _ => 4,
    }
}
