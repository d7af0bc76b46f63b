//! What is wrong with the data of a free law, in English.

use super::EN;
use crate::voice::{measured, row};
use levalab_core::{ExpressionFault, ExpressionProblem, RoughnessCause};
use levalab_format::{DataRefusal, quoted};

pub(super) fn refusal(refusal: &DataRefusal) -> String {
    match refusal {
        DataRefusal::WrongOrder { found } => {
            format!("The order must be 0 for s, 1 for v, 2 for a or 3 for j, and it is {}.", EN.exact(*found))
        }
        DataRefusal::WrongCount { found: 0, min, .. } => format!("The list is empty; it needs {min} at least."),
        DataRefusal::WrongCount { found, min, max } => {
            format!("There are {found} in the list; there must be from {min} to {max}.")
        }
        DataRefusal::Repeated { other } => {
            format!("Condition {} already says this value at this place.", other + 1)
        }
        DataRefusal::NoHeight => {
            "No condition says a height s, so the curve could lie at any height: give s somewhere.".to_owned()
        }
        DataRefusal::Dependent { items } if items.len() < 2 => {
            let item = items.first().map_or(1, |item| item + 1);
            format!(
                "A polynomial of so few conditions has no such derivative: add conditions, or remove number {item}."
            )
        }
        DataRefusal::Dependent { items } => {
            let named: Vec<String> = items.iter().map(|item| (item + 1).to_string()).collect();
            format!(
                "No single polynomial meets them: conditions {} depend on each other, whatever their values. Move or change one of them.",
                row(&named, "and")
            )
        }
        DataRefusal::KnotCount { found, expected: 0 } => {
            format!("With so few conditions the spline is one polynomial and has no knots, and {found} are given.")
        }
        DataRefusal::KnotCount { found, expected } => {
            format!("There are {found} knots; these conditions and this degree need {expected}.")
        }
        DataRefusal::KnotOrder => "Knots must lie within the segment, each after the one before it.".to_owned(),
        DataRefusal::KnotPlace { item, from, to, measure } => {
            let [from, to] = [from, to].map(|value| measured(*value, *measure, EN));
            format!(
                "With these knots condition {} would have to lie between {from} and {to}: put more knots where there are more conditions.",
                item + 1
            )
        }
        DataRefusal::NotAtEnd { found, expected, measure } => {
            let [found, expected] = [found, expected].map(|value| measured(*value, *measure, EN));
            format!(
                "The table must begin and end with its segment: this point is at {found}, and should be at {expected}."
            )
        }
        DataRefusal::Unordered => "The point does not come after the one before it.".to_owned(),
        DataRefusal::Expression(problem) => expression(problem),
        DataRefusal::Undefined { x, cause } => {
            let x = EN.number(*x);
            match cause {
                RoughnessCause::Power => format!(
                    "The formula is not smooth up to its third derivative near x = {x}: it has a root, or a fractional power below 3, of what is zero there. Join the powers of one base into a single one of 3 or more, such as x^3.5."
                ),
                RoughnessCause::Division => {
                    format!(
                        "The formula divides by zero near x = {x}: simplify the fraction, or move the zero of its divisor out of the segment."
                    )
                }
                RoughnessCause::TooLarge => format!(
                    "A value within the formula is too large to be computed with near x = {x}: a steep step is written with tanh, such as L(1+tanh(500(x-0.5)))/2."
                ),
                RoughnessCause::Edge => format!(
                    "The formula is not smooth up to its third derivative near x = {x}, at the edge of where one of its functions is defined."
                ),
            }
        }
        DataRefusal::RiseDisagrees { found, expected, measure } => {
            let [found, expected] = [found, expected].map(|value| measured(*value, *measure, EN));
            format!(
                "The data of the segment make it rise {expected}, not {found}: leave the rise out, or correct one of them."
            )
        }
    }
}

/// Characters are counted from 1.
fn expression(ExpressionProblem { at, kind }: &ExpressionProblem) -> String {
    let at = at + 1;
    match kind {
        ExpressionFault::Ends => {
            format!("A number, a variable or a parenthesis is missing at character {at}, where the formula ends.")
        }
        ExpressionFault::TooLong { limit } => format!("The formula is too long: there is room for {limit} characters."),
        ExpressionFault::TooDeep => format!("Too many parentheses or signs within each other at character {at}."),
        ExpressionFault::Unexpected(c) => format!("{} has no meaning here, at character {at}.", quoted(&c.to_string())),
        ExpressionFault::Unknown(name) => format!(
            "{} at character {at} is not known: there are x, θ, β, L, s₀, π, e, and functions such as sin, cos, exp, ln, sqrt.",
            quoted(name)
        ),
        ExpressionFault::Open => format!("The parenthesis at character {at} is not closed."),
        ExpressionFault::NoArgument(name) => {
            format!("{name} at character {at} needs its argument in parentheses, as in {name}(x).")
        }
        ExpressionFault::Number => format!("The number at character {at} cannot be read."),
    }
}
