//! A formula of the user: typeset as it was written, and differentiated by the rules.

use crate::board::{Board, LETTERS, two};
use crate::layout::width;
use crate::number;
use crate::segment::Part;
use levalab_core::{Expression, ExpressionConstant as Constant, ExpressionFunction as Function, ExpressionOp as Op};
use levalab_formula::Formula;

/// A derivative wider than this says nothing to the eye; it is left to the core.
const WIDEST: usize = 200;

/// An expression as a tree.
#[derive(Clone, Debug, PartialEq)]
enum Tree {
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

mod product;

use Tree::Number;

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

fn tree_of(ops: &[Op]) -> Option<Tree> {
    let mut stack: Vec<Box<Tree>> = Vec::new();
    for op in ops {
        let tree = match *op {
            Op::Number(value) => Number(value),
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

fn names(tree: &Tree, name: Constant) -> bool {
    match tree {
        Number(_) => false,
        Tree::Name(known) => *known == name,
        Tree::Neg(a) | Tree::Call(_, a) => names(a, name),
        Tree::Add(a, b) | Tree::Sub(a, b) | Tree::Mul(a, b) | Tree::Div(a, b) | Tree::Pow(a, b) => {
            names(a, name) || names(b, name)
        }
    }
}

fn varies(tree: &Tree) -> bool {
    names(tree, Constant::X) || names(tree, Constant::Theta)
}

/// With respect to θ.
fn derivative(tree: &Tree) -> Tree {
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

/// Without what adds nothing, and with like factors of a product together.
fn simple(tree: Tree) -> Tree {
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

fn formula(tree: &Tree) -> Formula {
    let of = |tree: &Tree| Box::new(formula(tree));
    match tree {
        Number(value) => number::number(&number::datum(*value)),
        Tree::Name(name) => Formula::Symbol(
            match name {
                Constant::X => "x",
                Constant::Theta => "θ",
                Constant::Beta => "β",
                Constant::Rise => "L",
                Constant::Start => "s_0",
                Constant::Pi => "π",
                Constant::Euler => "e",
            }
            .to_owned(),
        ),
        Tree::Neg(a) => Formula::Negative(of(a)),
        Tree::Add(a, b) => sum(a, '+', b),
        Tree::Sub(a, b) => sum(a, '−', b),
        Tree::Mul(a, b) => times(formula(a), formula(b)),
        Tree::Div(a, b) => Formula::Fraction(of(a), of(b)),
        Tree::Pow(a, b) => {
            // A sign, a product or a fraction below a power is told apart by the writers' parentheses.
            Formula::Power(of(a), of(b))
        }
        Tree::Call(Function::Sqrt, a) => Formula::Call("sqrt", of(a)),
        Tree::Call(Function::Exp, a) => Formula::Call("exp", of(a)),
        Tree::Call(function, a) => Formula::Call(
            match function {
                Function::Sin => "sin",
                Function::Cos => "cos",
                Function::Tan => "tan",
                Function::Asin => "arcsin",
                Function::Acos => "arccos",
                Function::Atan => "arctan",
                Function::Sinh => "sinh",
                Function::Cosh => "cosh",
                Function::Tanh => "tanh",
                Function::Log => "log",
                _ => "ln",
            },
            of(a),
        ),
    }
}

fn sum(a: &Tree, sign: char, b: &Tree) -> Formula {
    let mut terms = match formula(a) {
        Formula::Sum(terms) => terms,
        Formula::Negative(inner) => vec![('−', *inner)],
        other => vec![('+', other)],
    };
    terms.push((sign, formula(b)));
    Formula::Sum(terms)
}

/// True for what ends with the argument of a function, which would swallow a factor after it.
fn ends_with_function(formula: &Formula) -> bool {
    match formula {
        Formula::Call(name, _) => !["sqrt", "exp"].contains(name),
        Formula::Power(base, _) => ends_with_function(base),
        Formula::Product(factors) => factors.last().is_some_and(ends_with_function),
        Formula::Times(_, _, last) => ends_with_function(last),
        _ => false,
    }
}

fn times(a: Formula, b: Formula) -> Formula {
    let pointed = ends_with_function(&a)
        || matches!(b, Formula::Number(_) | Formula::Negative(_))
        || matches!(&b, Formula::Power(base, _) if matches!(**base, Formula::Number(_)));
    if pointed {
        return Formula::Times('·', Box::new(a), Box::new(b));
    }
    let mut factors = match a {
        Formula::Product(factors) => factors,
        other => vec![other],
    };
    match b {
        Formula::Product(more) if !matches!(more.first(), Some(Formula::Number(_))) => factors.extend(more),
        other => factors.push(other),
    }
    Formula::Product(factors)
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
