//! Bounds of an expression and of its first five derivatives over a part of [0, 1].

use super::interval::Interval;
use super::{Constant, Expression, Function, Op, Variables, value_of};
use std::f64::consts::LN_10;

/// The value and five derivatives: those of *j* and of *a* tell where *j* and *v* turn.
pub(super) const ORDERS: usize = 6;

/// Coefficients of the Taylor series: the derivative of order k, divided by k!.
#[derive(Clone, Copy, Debug)]
pub(super) struct Enclosure([Interval; ORDERS]);

const FACTORIALS: [f64; ORDERS] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];

impl Enclosure {
    /// Bounds of an expression for x in an interval.
    pub fn of(expression: &Expression, x: Interval, variables: &Variables, stack: &mut Vec<Self>) -> Self {
        stack.clear();
        let constant = |value: f64| Self::constant(Interval::about(value));
        for op in &expression.ops {
            let value = match *op {
                Op::Number(value) => Self::constant(Interval::of(value)),
                Op::Constant(Constant::X) => Self::variable(x, Interval::of(1.0)),
                Op::Constant(Constant::Theta) => {
                    let beta = Interval::of(variables.beta);
                    Self::variable(x * beta, beta)
                }
                Op::Constant(Constant::Pi | Constant::Euler) => constant(value_of_fixed(op)),
                Op::Constant(other) => Self::constant(Interval::of(value_of(other, 0.0, variables))),
                Op::Neg => pop(stack).negated(),
                Op::Call(function) => call(function, pop(stack)),
                Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Pow => {
                    let (right, left) = (pop(stack), pop(stack));
                    match op {
                        Op::Add => left.plus(right),
                        Op::Sub => left.plus(right.negated()),
                        Op::Mul => left.times(right),
                        Op::Div => left.times(right.power(-1.0)),
                        _ => power(left, right),
                    }
                }
            };
            stack.push(value);
        }
        pop(stack)
    }

    /// Bounds of the derivative of each order.
    pub fn derivatives(&self) -> [Interval; ORDERS] {
        std::array::from_fn(|k| if k < 2 { self.0[k] } else { self.0[k].times(FACTORIALS[k]) })
    }

    fn constant(value: Interval) -> Self {
        let mut terms = [Interval::ZERO; ORDERS];
        terms[0] = value;
        Self(terms)
    }

    fn variable(value: Interval, rate: Interval) -> Self {
        let mut variable = Self::constant(value);
        variable.0[1] = rate;
        variable
    }

    fn is_constant(&self) -> bool {
        self.0[1..].iter().all(|term| *term == Interval::ZERO)
    }

    fn plus(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }

    fn negated(self) -> Self {
        Self(self.0.map(|term| -term))
    }

    fn times(self, other: Self) -> Self {
        if other.is_constant() {
            return Self(self.0.map(|term| term * other.0[0]));
        }
        if self.is_constant() {
            return Self(other.0.map(|term| term * self.0[0]));
        }
        let term = |k: usize| (0..=k).fold(Interval::ZERO, |sum, i| sum + self.0[i] * other.0[k - i]);
        Self(std::array::from_fn(term))
    }

    /// f(u), from bounds of f and its derivatives at u: Σ f⁽ᵏ⁾(u₀)/k!·(u − u₀)ᵏ by Horner's rule, cut off after the last order.
    fn through(self, derivatives: [Interval; ORDERS]) -> Self {
        if self.is_constant() {
            return Self::constant(derivatives[0]);
        }
        let mut step = self;
        step.0[0] = Interval::ZERO;
        let coefficient = |k: usize| Self::constant(derivatives[k].times(1.0 / FACTORIALS[k]));
        (0..ORDERS - 1).rev().fold(coefficient(ORDERS - 1), |sum, k| sum.times(step).plus(coefficient(k)))
    }

    /// u^p, for a constant exponent.
    fn power(self, p: f64) -> Self {
        let u = self.0[0];
        if p == 2.0 {
            let mut square = self.times(self);
            square.0[0] = u.squared();
            return square;
        }
        let mut factor = 1.0;
        self.through(std::array::from_fn(|k| {
            if k > 0 {
                factor *= p - (k as f64 - 1.0);
            }
            // Past its last derivative a power is gone, even at u = 0.
            if factor == 0.0 { Interval::ZERO } else { raised(u, p - k as f64).times(factor) }
        }))
    }
}

fn value_of_fixed(op: &Op) -> f64 {
    match op {
        Op::Constant(constant) => value_of(*constant, 0.0, &Variables::default()),
        _ => 0.0,
    }
}

/// The parser leaves an operand for every operator.
fn pop(stack: &mut Vec<Enclosure>) -> Enclosure {
    stack.pop().unwrap_or(Enclosure::constant(Interval::ZERO))
}

fn raised(u: Interval, exponent: f64) -> Interval {
    if exponent == 0.0 {
        Interval::of(1.0)
    } else if exponent.fract() == 0.0 && exponent.abs() <= f64::from(i32::MAX) {
        u.whole_power(exponent as i32)
    } else {
        u.real_power(exponent)
    }
}

fn power(base: Enclosure, exponent: Enclosure) -> Enclosure {
    let p = exponent.0[0];
    if exponent.is_constant() && p.low == p.high {
        return base.power(p.low);
    }
    // u^w = e^(w·ln u).
    call(Function::Exp, exponent.times(call(Function::Ln, base)))
}

fn call(function: Function, u: Enclosure) -> Enclosure {
    match function {
        Function::Sqrt => return u.power(0.5),
        Function::Log => return call(Function::Ln, u).times(Enclosure::constant(Interval::about(1.0 / LN_10))),
        _ => {}
    }
    u.through(derivatives(function, u.0[0]))
}

/// A function and its five derivatives.
fn derivatives(function: Function, u: Interval) -> [Interval; ORDERS] {
    let one = Interval::of(1.0);
    match function {
        Function::Sin => [u.sin(), u.cos(), -u.sin(), -u.cos(), u.sin(), u.cos()],
        Function::Cos => [u.cos(), -u.sin(), -u.cos(), u.sin(), u.cos(), -u.sin()],
        Function::Sinh | Function::Cosh => {
            let (sinh, near) = (u.rising(f64::sinh), u.smallest().cosh());
            let cosh = Interval::between(near, u.largest().cosh()).rising(|value| value);
            if function == Function::Sinh {
                [sinh, cosh, sinh, cosh, sinh, cosh]
            } else {
                [cosh, sinh, cosh, sinh, cosh, sinh]
            }
        }
        Function::Tan => {
            let t = if u.width() < 3.0 { u.rising(f64::tan) } else { Interval::ANY };
            in_tangent(t, one + t.squared(), 1.0)
        }
        Function::Tanh => {
            let t = u.rising(f64::tanh);
            let (near, far) = (u.smallest().cosh(), u.largest().cosh());
            let slope = Interval::between(1.0 / far / far, 1.0 / near / near).rising(|value| value);
            in_tangent(t, slope, -1.0)
        }
        Function::Asin => arc_sine(u, u.rising(f64::asin), 1.0),
        Function::Acos => arc_sine(u, (-u).rising(|value| (-value).acos()), -1.0),
        Function::Atan => {
            let r = (one + u.squared()).reciprocal();
            let (u2, r2) = (u.squared(), r.squared());
            [
                u.rising(f64::atan),
                r,
                u.times(-2.0) * r2,
                (u2.times(6.0) - Interval::of(2.0)) * r2 * r,
                (u.times(24.0) * (one - u2)) * r2 * r2,
                (Interval::of(24.0) + u2.times(-240.0) + u2.squared().times(120.0)) * r2 * r2 * r,
            ]
        }
        Function::Exp => [u.rising(f64::exp); ORDERS],
        // ln, and what was dealt with before.
        _ => {
            let value = if u.low > 0.0 { u.rising(f64::ln) } else { Interval::ANY };
            let of = |n: i32, factor: f64| u.whole_power(-n).times(factor);
            [value, of(1, 1.0), of(2, -1.0), of(3, 2.0), of(4, -6.0), of(5, 24.0)]
        }
    }
}

/// Derivatives of the tangent (sign 1) or of the hyperbolic tangent (sign −1) from t and t′ = 1 ± t².
fn in_tangent(t: Interval, slope: Interval, sign: f64) -> [Interval; ORDERS] {
    let t2 = t.squared();
    let n = Interval::of;
    [
        t,
        slope,
        t.times(2.0 * sign) * slope,
        (t2.times(6.0) + n(2.0 * sign)) * slope,
        (t * (n(16.0) + t2.times(24.0 * sign))) * slope,
        (n(16.0) + t2.times(120.0 * sign) + t2.squared().times(120.0)) * slope,
    ]
}

/// Derivatives of the arc sine (sign 1) or arc cosine (sign −1).
fn arc_sine(u: Interval, value: Interval, sign: f64) -> [Interval; ORDERS] {
    let u2 = u.squared();
    let r = (Interval::of(1.0) - u2).reciprocal();
    let root = |power: f64| if r.low > 0.0 { r.real_power(power) } else { Interval::ANY };
    let n = Interval::of;
    [
        value,
        root(0.5).times(sign),
        (u * root(1.5)).times(sign),
        ((n(1.0) + u2.times(2.0)) * root(2.5)).times(sign),
        ((u * (n(9.0) + u2.times(6.0))) * root(3.5)).times(sign),
        ((n(9.0) + u2.times(72.0) + u2.squared().times(24.0)) * root(4.5)).times(sign),
    ]
}
