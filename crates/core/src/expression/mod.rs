//! The user's own formula: read once, then computed with its derivatives up to the third.
//!
//! All an expression can do is compute a number, in a bounded number of steps: its text and its depth are bounded, and it runs as a list of
//! operations on a stack of its own.

mod domain;
mod enclosure;
mod interval;
mod jet;
mod lengths;
mod names;
mod parse;
mod powers;
mod problem;
mod remembered;
mod survey;
#[cfg(test)]
mod tests;

pub use survey::Unproved;

pub use problem::{ExpressionFault, ExpressionProblem, MAX_EXPRESSION, Roughness, RoughnessCause};

use crate::Svaj;
use jet::Jet;
use remembered::remembered;
use std::f64::consts::{E, LN_10, PI};
use std::sync::{Arc, OnceLock};
use survey::Survey;

/// An expression that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    /// Operands before operators.
    ops: Vec<Op>,
}

/// What an expression may name besides x.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Variables {
    /// β, radians; θ goes from 0 to it.
    pub beta: f64,
    /// L.
    pub rise: f64,
    /// s₀, the height at which the segment before ends.
    pub start: f64,
}

/// An expression with its variables: s = k·f(x) + c.
#[derive(Clone, Debug)]
pub struct Formula {
    expression: Expression,
    variables: Variables,
    scale: f64,
    shift: f64,
    survey: Arc<OnceLock<Arc<Survey>>>,
}

/// An operation of an expression; operands come before operators.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    /// A number.
    Number(f64),
    /// A variable or a constant.
    Constant(Constant),
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a·b
    Mul,
    /// a/b
    Div,
    /// −a
    Neg,
    /// a raised to b
    Pow,
    /// A function of a.
    Call(Function),
}

/// What an expression may name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Constant {
    /// x = θ/β
    X,
    /// θ, radians from the start of the segment.
    Theta,
    /// β, radians.
    Beta,
    /// L
    Rise,
    /// s₀
    Start,
    /// π
    Pi,
    /// e
    Euler,
}

/// The functions of expressions.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "their names say it")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Log,
    Sqrt,
}

impl Expression {
    /// Its operations in their order, operands before operators.
    #[must_use]
    pub fn ops(&self) -> &[Op] {
        &self.ops
    }

    /// True when L is named, so that a rise must be told.
    #[must_use]
    pub fn names_rise(&self) -> bool {
        self.ops.contains(&Op::Constant(Constant::Rise))
    }

    /// With its variables: a formula for x ∈ [0, 1].
    ///
    /// # Errors
    /// An x near which it, or one of its derivatives, is not defined.
    pub fn with(self, variables: Variables) -> Result<Formula, Roughness> {
        let checked = match domain::check(&self, &variables) {
            Ok(()) => self,
            Err(roughness) => {
                let joined = powers::joined(&self, &variables);
                domain::check(&joined, &variables).map_err(|_| roughness)?;
                joined
            }
        };
        Ok(Formula { expression: checked, variables, scale: 1.0, shift: 0.0, survey: Arc::default() })
    }

    fn at(&self, x: f64, variables: &Variables) -> Jet {
        let mut stack: Vec<Jet> = Vec::with_capacity(self.ops.len().min(64));
        for op in &self.ops {
            let value = match *op {
                Op::Number(value) => Jet::constant(value),
                Op::Constant(Constant::X) => Jet::variable(x, 1.0),
                Op::Constant(Constant::Theta) => Jet::variable(variables.beta * x, variables.beta),
                Op::Constant(constant) => Jet::constant(value_of(constant, x, variables)),
                Op::Neg => -pop(&mut stack),
                Op::Call(function) => {
                    let argument = pop(&mut stack);
                    argument.through(function.derivatives(argument.0[0]))
                }
                Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Pow => {
                    let (right, left) = (pop(&mut stack), pop(&mut stack));
                    match op {
                        Op::Add => left + right,
                        Op::Sub => left - right,
                        Op::Mul => left * right,
                        Op::Div => left / right,
                        _ => power(left, right),
                    }
                }
            };
            stack.push(value);
        }
        pop(&mut stack)
    }
}

impl PartialEq for Formula {
    /// The survey follows from the expression, and may not have been made yet.
    fn eq(&self, other: &Self) -> bool {
        let numbers = |formula: &Self| (formula.variables, formula.scale, formula.shift);
        self.expression == other.expression && numbers(self) == numbers(other)
    }
}

impl Formula {
    /// s and its three derivatives with respect to x.
    #[must_use]
    pub fn at(&self, x: f64) -> Svaj {
        let motion = self.expression.at(x, &self.variables).motion() * self.scale;
        Svaj { s: motion.s + self.shift, ..motion }
    }

    /// What is known about it over [0, 1], worked out when it is first asked for.
    fn survey(&self) -> &Survey {
        self.survey.get_or_init(|| remembered(&self.expression, &self.variables))
    }

    /// Every x between 0 and 1, in order, at which it must be sampled so that nothing is missed.
    #[must_use]
    pub fn places(&self) -> &[f64] {
        &self.survey().places
    }

    /// What could not be proved of its extremes, if anything.
    #[must_use]
    pub fn unproved(&self) -> Option<Unproved> {
        self.survey().unproved
    }

    /// The lowest and the highest value of the derivative of that order, 0 to 3, with respect to x.
    pub(crate) fn range(&self, order: usize) -> (f64, f64) {
        let range = self.survey().ranges[order].times(self.scale);
        let shift = if order == 0 { self.shift } else { 0.0 };
        (range.low + shift, range.high + shift)
    }

    /// The error of rounding of the derivative of that order, 0 to 3, at x = 0 or at x = 1.
    pub(crate) fn rounding(&self, order: usize) -> f64 {
        self.survey().rounding.map(|end| end[order]).into_iter().fold(0.0, f64::max) * self.scale.abs()
    }

    /// k·s(x) + c.
    #[must_use]
    pub fn scaled(mut self, k: f64, c: f64) -> Self {
        self.scale *= k;
        self.shift = self.shift * k + c;
        self
    }
}

/// The parser leaves an operand for every operator.
fn pop(stack: &mut Vec<Jet>) -> Jet {
    stack.pop().unwrap_or(Jet::constant(0.0))
}

fn value_of(constant: Constant, x: f64, variables: &Variables) -> f64 {
    match constant {
        Constant::X => x,
        Constant::Theta => variables.beta * x,
        Constant::Beta => variables.beta,
        Constant::Rise => variables.rise,
        Constant::Start => variables.start,
        Constant::Pi => PI,
        Constant::Euler => E,
    }
}

fn power(base: Jet, exponent: Jet) -> Jet {
    if exponent.0[1..] == [0.0; 3] {
        return base.power(exponent.0[0]);
    }
    // u^w = e^(w·ln u).
    let product = exponent * base.through(Function::Ln.derivatives(base.0[0]));
    product.through(Function::Exp.derivatives(product.0[0]))
}

impl Function {
    /// The function and its three derivatives.
    fn derivatives(self, u: f64) -> [f64; 4] {
        match self {
            Self::Sin => [u.sin(), u.cos(), -u.sin(), -u.cos()],
            Self::Cos => [u.cos(), -u.sin(), -u.cos(), u.sin()],
            Self::Tan => {
                let t = u.tan();
                let d = 1.0 + t * t;
                [t, d, 2.0 * t * d, 2.0 * d * (1.0 + 3.0 * t * t)]
            }
            Self::Asin => {
                let r = 1.0 / (1.0 - u * u);
                let d = r.sqrt();
                [u.asin(), d, u * d * r, (1.0 + 2.0 * u * u) * d * r * r]
            }
            Self::Acos => {
                let [_, d1, d2, d3] = Self::Asin.derivatives(u);
                [u.acos(), -d1, -d2, -d3]
            }
            Self::Atan => {
                let r = 1.0 / (1.0 + u * u);
                [u.atan(), r, -2.0 * u * r * r, (6.0 * u * u - 2.0) * r * r * r]
            }
            Self::Sinh => [u.sinh(), u.cosh(), u.sinh(), u.cosh()],
            Self::Cosh => [u.cosh(), u.sinh(), u.cosh(), u.sinh()],
            Self::Tanh => {
                let t = u.tanh();
                let d = 1.0 - t * t;
                [t, d, -2.0 * t * d, 2.0 * d * (3.0 * t * t - 1.0)]
            }
            Self::Exp => [u.exp(); 4],
            Self::Ln => [u.ln(), 1.0 / u, -1.0 / (u * u), 2.0 / (u * u * u)],
            Self::Log => Self::Ln.derivatives(u).map(|value| value / LN_10),
            Self::Sqrt => {
                let r = u.sqrt();
                [r, 0.5 / r, -0.25 / (r * u), 0.375 / (r * u * u)]
            }
        }
    }
}
