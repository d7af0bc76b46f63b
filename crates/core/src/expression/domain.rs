//! Where an expression is defined: interval arithmetic over [0, 1], halved until every part is known to be sound.

use super::{Constant, Expression, Function, Op, Roughness, RoughnessCause, Variables, value_of};
use std::f64::consts::{FRAC_PI_2, PI};

/// A formula larger than this has derivatives that no cam has.
const LARGEST: f64 = 1e12;

/// An intermediate value may be larger, as the exponential in a logistic curve is; beyond this the third derivative of its reciprocal
/// leaves the range of numbers.
const LARGEST_WITHIN: f64 = 1e75;

/// A divisor may not come closer to zero, nor an argument to the edge of where a function is smooth.
const NEAREST: f64 = 1e-12;

/// Parts that are looked at before the expression is called undefined: a sound one takes a few dozen.
const MOST_PARTS: usize = 4096;

/// A part narrower than this that is not sound holds a place where the expression is not defined.
const NARROWEST: f64 = 1e-9;

/// Refuses an expression that is not smooth up to its third derivative somewhere in [0, 1]; returns where, and why.
pub(super) fn check(expression: &Expression, variables: &Variables) -> Result<(), Roughness> {
    let fault = |from: f64, to: f64| range(expression, variables, from, to).err();
    let mut parts = vec![(0.0, 1.0)];
    let mut looked = 0;
    while let Some((from, to)) = parts.pop() {
        looked += 1;
        let Some(cause) = fault(from, to) else { continue };
        let middle = 0.5 * (from + to);
        // The ends are where formulas fail most: 1/x, √x.
        for end in [from, to] {
            if let Some(cause) = fault(end, end) {
                return Err(Roughness { x: end, cause });
            }
        }
        if to - from < NARROWEST || looked > MOST_PARTS {
            return Err(Roughness { x: middle, cause });
        }
        parts.extend([(middle, to), (from, middle)]);
    }
    Ok(())
}

/// Bounds of an expression over [0, 1], when it is smooth there.
pub(super) fn bounds(expression: &Expression, variables: &Variables) -> Option<(f64, f64)> {
    range(expression, variables, 0.0, 1.0).ok()
}

/// Bounds of the expression for x from `from` to `to`, or why it may not be smooth there.
fn range(expression: &Expression, variables: &Variables, from: f64, to: f64) -> Result<(f64, f64), RoughnessCause> {
    let mut stack: Vec<(f64, f64)> = Vec::new();
    let pop = |stack: &mut Vec<(f64, f64)>| stack.pop().ok_or(RoughnessCause::Edge);
    for op in &expression.ops {
        let bounds = match *op {
            Op::Number(value) => (value, value),
            Op::Constant(constant @ (Constant::X | Constant::Theta)) => {
                (value_of(constant, from, variables), value_of(constant, to, variables))
            }
            Op::Constant(constant) => {
                let value = value_of(constant, from, variables);
                (value, value)
            }
            Op::Neg => {
                let (low, high) = pop(&mut stack)?;
                (-high, -low)
            }
            Op::Call(function) => {
                let argument = pop(&mut stack)?;
                let root = function == Function::Sqrt && argument.1 >= 0.0;
                call(function, argument).ok_or(if root { RoughnessCause::Power } else { RoughnessCause::Edge })?
            }
            Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Pow => {
                let (right, left) = (pop(&mut stack)?, pop(&mut stack)?);
                match op {
                    Op::Add => (left.0 + right.0, left.1 + right.1),
                    Op::Sub => (left.0 - right.1, left.1 - right.0),
                    Op::Mul => product(left, right),
                    Op::Div => product(left, reciprocal(right).ok_or(RoughnessCause::Division)?),
                    _ => power(left, right).ok_or(cause_of_power(left, right))?,
                }
            }
        };
        if !(bounds.0 >= -LARGEST_WITHIN && bounds.1 <= LARGEST_WITHIN) {
            return Err(RoughnessCause::TooLarge);
        }
        stack.push(bounds);
    }
    let bounds = pop(&mut stack)?;
    if bounds.0 >= -LARGEST && bounds.1 <= LARGEST { Ok(bounds) } else { Err(RoughnessCause::TooLarge) }
}

/// Why a power may not be smooth.
fn cause_of_power(base: (f64, f64), exponent: (f64, f64)) -> RoughnessCause {
    if exponent.0 == exponent.1 && exponent.0 < 0.0 {
        RoughnessCause::Division
    } else if base.1 >= 0.0 {
        RoughnessCause::Power
    } else {
        RoughnessCause::Edge
    }
}

fn product(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let all = [a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1];
    (all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

fn reciprocal((low, high): (f64, f64)) -> Option<(f64, f64)> {
    (low > NEAREST || high < -NEAREST).then(|| (1.0 / high, 1.0 / low))
}

fn power(base: (f64, f64), exponent: (f64, f64)) -> Option<(f64, f64)> {
    let p = exponent.0;
    if exponent.0 == exponent.1 {
        let raise = |u: f64| if p.fract() == 0.0 { u.powi(p as i32) } else { u.powf(p) };
        let whole = p.fract() == 0.0 && p.abs() <= f64::from(i32::MAX);
        if p < 0.0 && base.0 <= NEAREST && base.1 >= -NEAREST {
            return None;
        }
        // From the third power on, a fractional one is smooth at zero as well; below zero there is none.
        let smooth = whole || base.0 > NEAREST || base.0 >= 0.0 && p >= 3.0;
        let ends = (raise(base.0), raise(base.1));
        let mut bounds = (ends.0.min(ends.1), ends.0.max(ends.1));
        if base.0 < 0.0 && base.1 > 0.0 {
            bounds = (bounds.0.min(0.0), bounds.1.max(0.0));
        }
        return smooth.then_some(bounds);
    }
    let logarithm = call(Function::Ln, base)?;
    call(Function::Exp, product(exponent, logarithm))
}

fn call(function: Function, (low, high): (f64, f64)) -> Option<(f64, f64)> {
    let rising = |f: fn(f64) -> f64| Some((f(low), f(high)));
    match function {
        Function::Sin => Some(wave(low - FRAC_PI_2, high - FRAC_PI_2)),
        Function::Cos => Some(wave(low, high)),
        Function::Tan => {
            let pole = ((low - FRAC_PI_2) / PI).ceil() * PI + FRAC_PI_2;
            let sound = pole > high + NEAREST && pole - PI < low - NEAREST;
            sound.then(|| (low.tan(), high.tan())).filter(|(low, high)| low <= high)
        }
        Function::Asin => (low > NEAREST - 1.0 && high < 1.0 - NEAREST).then(|| (low.asin(), high.asin())),
        Function::Acos => (low > NEAREST - 1.0 && high < 1.0 - NEAREST).then(|| (high.acos(), low.acos())),
        Function::Atan => rising(f64::atan),
        Function::Sinh => rising(f64::sinh),
        Function::Tanh => rising(f64::tanh),
        Function::Exp => rising(f64::exp),
        Function::Cosh => {
            let ends = (low.cosh(), high.cosh());
            let least = if low <= 0.0 && high >= 0.0 { 1.0 } else { ends.0.min(ends.1) };
            Some((least, ends.0.max(ends.1)))
        }
        Function::Ln if low > NEAREST => rising(f64::ln),
        Function::Log if low > NEAREST => rising(f64::log10),
        Function::Sqrt if low > NEAREST => rising(f64::sqrt),
        Function::Ln | Function::Log | Function::Sqrt => None,
    }
}

/// Bounds of the cosine.
fn wave(low: f64, high: f64) -> (f64, f64) {
    let holds = |phase: f64| ((low - phase) / (2.0 * PI)).ceil() * 2.0 * PI + phase <= high;
    let (a, b) = (low.cos(), high.cos());
    (if holds(PI) { -1.0 } else { a.min(b) }, if holds(0.0) { 1.0 } else { a.max(b) })
}
