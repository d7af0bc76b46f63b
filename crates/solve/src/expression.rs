//! A formula of the user: typeset as it was written, and differentiated by the rules.

mod derivative;
mod product;
mod simple;
mod tree;
mod typeset;

use crate::board::{Board, LETTERS, two};
use crate::layout::width;
use crate::number;
use crate::segment::Part;
use derivative::derivative;
use levalab_core::{Expression, ExpressionConstant as Constant};
use simple::simple;
use tree::{names, tree_of};
use typeset::formula;

/// A derivative wider than this says nothing to the eye; it is left to the core.
const WIDEST: usize = 200;

/// Writes the formula of a segment and its derivatives.
pub fn write(board: &mut Board, part: &Part, text: &str) {
    let Some(tree) = Expression::parse(text).ok().and_then(|expression| tree_of(expression.ops())) else { return };
    board.say(
        two(
            "The formula of the design, with $θ$ from the start of the segment, $s_0$ the height before it and $L$ the rise that is told:",
            "La fórmula del diseño, con $θ$ desde el comienzo del tramo, $s_0$ la altura anterior y $L$ la elevación indicada:",
        ),
        &[],
    );
    let mut known = Vec::new();
    let named = |name: Constant| names(&tree, name);
    if named(Constant::Start) {
        known.push(format!("s_0 = {}", board.height(part.start)));
    }
    if named(Constant::Rise) {
        known.push(format!("L = {}", board.height(part.segment.rise)));
    }
    if !known.is_empty() {
        board.show(&known.join(", "));
    }
    board.equate(number::symbol("s"), vec![('=', formula(&tree))]);
    board.say(
        two(
            "Its derivatives with respect to $θ$, by the chain rule ($x$ changes by $1/β$ for each radian):",
            "Sus derivadas respecto a $θ$, por la regla de la cadena ($x$ varía $1/β$ por cada radián):",
        ),
        &[],
    );
    let mut derived = tree;
    for letter in &LETTERS[1..] {
        derived = simple(derivative(&derived));
        let right = formula(&derived);
        if width(&right) > WIDEST {
            board.say(
                two(
                    "(${letter}$ would not fit on a line; its values are exact all the same, since value and derivatives are computed together.)",
                    "(${letter}$ no cabría en una línea; sus valores son igualmente exactos, porque valor y derivadas se calculan a la vez.)",
                ),
                &[("letter", letter)],
            );
            return;
        }
        board.equate(number::symbol(letter), vec![('=', right)]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_core::Variables;
    use nalgebra::Complex;

    #[test]
    fn derivatives_are_as_short_as_by_hand() {
        let expression = Expression::parse("s0 + L (x - sin(2π x)/(2π))").expect("read");
        let mut tree = tree_of(expression.ops()).expect("a tree");
        let mut found = Vec::new();
        for _ in 1..4 {
            tree = simple(derivative(&tree));
            found.push(levalab_formula::latex(&formula(&tree), levalab_words::Language::En));
        }
        assert_eq!(
            found,
            [
                "L \\left(\\frac{1}{\\beta} - \\frac{\\cos 2 \\pi x}{\\beta}\\right)",
                "\\frac{2 \\pi L \\sin 2 \\pi x}{\\beta^{2}}",
                "\\frac{4 \\pi^{2} L \\cos 2 \\pi x}{\\beta^{3}}"
            ]
        );
    }

    #[test]
    fn printed_derivatives_are_those_of_the_core() {
        let variables = Variables { beta: 1.3, rise: 4.0, start: 0.7 };
        for text in [
            "0.05x³",
            "s0 + L (10x^3 - 15x^4 + 6x^5)",
            "L/2 (1 - cos(pi x))",
            "L (x - sin(2pi x)/(2pi))",
            "2θ^2/(1 + θ) - e^(-θ)",
            "sqrt(1 + x) ln(2 + x) + tan(x/2)",
            "(1 + x)^(1 + x) + atan(3x) - asin(x/3) acos(x/4)",
            "sinh(x) cosh(x)/tanh(1 + x) + log(4 - x)",
            "-(x - 2)^-3 + beta/(x+1)",
        ] {
            let expression = Expression::parse(text).expect(text);
            let mut tree = tree_of(expression.ops()).expect(text);
            let core = expression.clone().with(variables).expect(text);
            for order in 0..4 {
                for x in [0.15, 0.4, 0.85] {
                    let known = |name: &str| {
                        Some(Complex::from(match name {
                            "x" => x,
                            "θ" => 1.3 * x,
                            "β" => 1.3,
                            "L" => 4.0,
                            "s_0" => 0.7,
                            "e" => std::f64::consts::E,
                            _ => return None,
                        }))
                    };
                    let printed = formula(&tree).value(&known).expect(text).re;
                    let expected = core.at(x).stretched(1.3).order(order);
                    assert!(
                        (printed - expected).abs() < 1e-9 * (1.0 + expected.abs()),
                        "{text} {order}: {printed} {expected}"
                    );
                }
                tree = simple(derivative(&tree));
            }
        }
    }
}
