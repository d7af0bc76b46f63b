//! Claims about expressions.

use super::ExpressionFault as Fault;
use super::*;

const VARIABLES: Variables = Variables { beta: 2.5, rise: 10.0, start: 3.0 };

fn formula(text: &str) -> Formula {
    Expression::parse(text).unwrap_or_else(|problem| panic!("{text}: {problem:?}")).with(VARIABLES).expect(text)
}

fn value(text: &str, x: f64) -> f64 {
    formula(text).at(x).s
}

#[test]
fn expressions_are_read_as_they_are_written() {
    let x: f64 = 0.3;
    for (text, expected) in [
        ("2,5x", 2.5 * x),
        ("2.5·x", 2.5 * x),
        ("10x³ − 15x⁴ + 6x^5", 10.0 * x.powi(3) - 15.0 * x.powi(4) + 6.0 * x.powi(5)),
        ("-x^2", -x * x),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("x**2", x * x),
        ("L/2 (1 − cos πx)", f64::NAN),
        ("L/2(1-cos(πx))", 5.0 * (1.0 - (PI * x).cos())),
        ("L(θ/β − sin(2πθ/β)/(2π))", 10.0 * (x - (2.0 * PI * x).sin() / (2.0 * PI))),
        ("s₀ + s0 + L", 16.0),
        ("xsen(x)", x * x.sin()),
        ("1e-3x", 1e-3 * x),
        ("2e x", 2.0 * E * x),
        ("exp(-x)+ln(1+x)", (-x).exp() + (1.0 + x).ln()),
        (".5 + ,5", 1.0),
        ("theta/beta", x),
        ("+x - -x", 2.0 * x),
        ("(1+x)(1-x)", 1.0 - x * x),
        ("x(1)", x),
        ("asin(x/2)+acos(x/2)", PI / 2.0),
    ] {
        if expected.is_nan() {
            assert!(
                matches!(Expression::parse(text), Err(ExpressionProblem { kind: Fault::NoArgument(_), .. })),
                "{text}"
            );
        } else {
            assert!((value(text, x) - expected).abs() < 1e-13, "{text}: {} not {expected}", value(text, x));
        }
    }
}

#[test]
fn refusals_point_at_a_character() {
    for (text, at, kind) in [
        ("", 0, Fault::Ends),
        ("  ", 2, Fault::Ends),
        ("2+", 2, Fault::Ends),
        ("2 + * x", 4, Fault::Unexpected('*')),
        ("(1+x", 0, Fault::Open),
        ("1+x)", 3, Fault::Unexpected(')')),
        ("3y", 1, Fault::Unknown("y".to_owned())),
        ("x2", 1, Fault::Unexpected('2')),
        ("1 000", 2, Fault::Unexpected('0')),
        ("sin x", 0, Fault::NoArgument("sin".to_owned())),
        ("1.2.3", 3, Fault::Unexpected('.')),
        (".", 0, Fault::Number),
        ("1e999", 0, Fault::Number),
        ("x; alert(1)", 1, Fault::Unexpected(';')),
    ] {
        assert_eq!(Expression::parse(text).expect_err(text), ExpressionProblem { at, kind }, "{text}");
    }
    let deep = "(".repeat(200) + "x" + &")".repeat(200);
    assert!(matches!(Expression::parse(&deep).expect_err("deep").kind, Fault::TooDeep));
    assert!(matches!(Expression::parse(&"-".repeat(400)).expect_err("deep").kind, Fault::TooDeep));
    assert!(matches!(Expression::parse(&"1+".repeat(400)).expect_err("long").kind, Fault::TooLong { .. }));
}

#[test]
fn what_is_not_smooth_everywhere_is_refused_where_it_is_not() {
    let refused = |text: &str| Expression::parse(text).expect(text).with(VARIABLES).expect_err(text);
    for (text, x) in [
        ("1/x", 0.0),
        ("sqrt(x)", 0.0),
        ("x^2,5", 0.0),
        ("1/(1-x)", 1.0),
        ("ln(1-x)", 1.0),
        ("sqrt(0.5-x)", 1.0),
        ("sin(x)/x", 0.0),
    ] {
        assert_eq!(refused(text).x, x, "{text}");
    }
    for (text, x) in
        [("1/(x-0,3)", 0.3), ("tan(πx)", 0.5), ("1/(x²-x+0,25)", 0.5), ("ln(x-0.25)", 0.0), ("1/cos(3x)", PI / 6.0)]
    {
        let found = refused(text).x;
        assert!((found - x).abs() < 1e-6, "{text}: {found}");
    }
    for text in ["x^3,5", "1/(x²-2x+2)", "sqrt(1+x)", "tan(x)", "e^x", "x^x + 1", "ln(1+x)^2", "cosh(x)/exp(x)"] {
        let sound = Expression::parse(text).expect(text).with(VARIABLES);
        assert_eq!(sound.is_ok(), text != "x^x + 1", "{text}: {sound:?}");
    }
}

#[test]
fn powers_of_one_base_are_judged_by_their_product() {
    for (text, exponent) in [
        ("(x^2.5)*x", 3.5),
        ("sqrt(x^7)", 3.5),
        ("x·sqrt(x)·x²", 3.5),
        ("x^5/sqrt(x)", 4.5),
        ("(x^1.5)^3", 4.5),
        ("sqrt(x)·sqrt(x)", 1.0),
        ("sqrt(4x^7)/2", 3.5),
    ] {
        let found = formula(text);
        for x in [0.0_f64, 0.25, 1.0] {
            assert!((found.at(x).s - x.powf(exponent)).abs() < 1e-14, "{text} at {x}: {}", found.at(x).s);
        }
        assert_eq!(found.at(0.0).j, 0.0, "{text}");
    }
    let logistic = formula("1/(1+exp(-60*(x-0.5)))");
    assert!((logistic.at(0.5).v - 15.0).abs() < 1e-12 && logistic.at(0.0).s < 1e-12);
}

#[test]
fn a_refusal_says_why_it_is_not_smooth() {
    for (text, cause) in [
        ("sqrt(x)", RoughnessCause::Power),
        ("x^2,5", RoughnessCause::Power),
        ("sqrt(x-x²)", RoughnessCause::Power),
        ("1/x", RoughnessCause::Division),
        ("x^-1", RoughnessCause::Division),
        ("1/(1+exp(-600(x-0.5)))", RoughnessCause::TooLarge),
        ("ln(x)", RoughnessCause::Edge),
        ("sqrt(x-2)", RoughnessCause::Edge),
    ] {
        let refusal = Expression::parse(text).expect(text).with(VARIABLES).expect_err(text);
        assert_eq!(refusal.cause, cause, "{text}");
    }
}

#[test]
fn enclosures_hold_the_derivatives_of_random_expressions() {
    let mut seed = 19;
    let mut stack = Vec::new();
    for _ in 0..300 {
        let tree = Tree::random(&mut seed, 3);
        let expression = Expression::parse(&tree.text()).expect("it is written as it is read");
        let from = 0.01 * (seed % 97) as f64;
        let part = interval::Interval::between(from, from + 0.03);
        let bounds = enclosure::Enclosure::of(&expression, part, &VARIABLES, &mut stack).derivatives();
        let mut derivative = tree.clone();
        for (order, bounds) in bounds.iter().enumerate() {
            for i in 0..=6 {
                let value = derivative.value(from + 0.005 * f64::from(i));
                let error = 1e-9 * value.abs().max(1e-9);
                let inside = !value.is_finite() || bounds.low - error <= value && value <= bounds.high + error;
                assert!(inside, "{}, order {order}: {value} is not in {bounds:?}", tree.text());
            }
            if order < 4 {
                derivative = derivative.derivative();
            } else {
                break;
            }
        }
    }
}

#[test]
fn scaling_moves_the_value_and_stretches_the_derivatives() {
    let plain = formula("sin(2x)");
    let (before, after) = (plain.at(0.4), plain.clone().scaled(3.0, 5.0).scaled(2.0, 1.0).at(0.4));
    assert!((after.s - (2.0 * (3.0 * before.s + 5.0) + 1.0)).abs() < 1e-13 && (after.j - 6.0 * before.j).abs() < 1e-12);
}

/// An expression as a tree, which can be differentiated on paper.
#[derive(Clone, Debug)]
enum Tree {
    X,
    Number(f64),
    Add(Box<Tree>, Box<Tree>),
    Mul(Box<Tree>, Box<Tree>),
    Div(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, i32),
    Call(&'static str, Box<Tree>),
}

impl Tree {
    fn random(seed: &mut u64, depth: usize) -> Self {
        let mut next = |n: u64| {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 33) % n
        };
        if depth == 0 {
            return if next(3) == 0 { Self::Number(0.25 * next(20) as f64 + 0.25) } else { Self::X };
        }
        let kind = next(9);
        let power = 2 + next(4) as i32;
        let function = ["sin", "cos", "exp", "atan", "tanh", "sinh", "cosh"][next(7) as usize];
        let mut part = || Box::new(Self::random(seed, depth - 1));
        match kind {
            0 | 1 => Self::Add(part(), part()),
            2 | 3 => Self::Mul(part(), part()),
            // Kept away from zero, and from large arguments of the exponential.
            4 => Self::Div(part(), Box::new(Self::Add(Box::new(Self::Number(1.5)), Box::new(Self::Power(part(), 2))))),
            5 => Self::Power(part(), power),
            6 => Self::Call("ln", Box::new(Self::Add(Box::new(Self::Number(1.0)), Box::new(Self::Power(part(), 2))))),
            7 => Self::Call("sqrt", Box::new(Self::Add(Box::new(Self::Number(2.0)), Box::new(Self::Power(part(), 2))))),
            _ => Self::Call(function, Box::new(Self::Call("sin", part()))),
        }
    }

    fn text(&self) -> String {
        match self {
            Self::X => "x".to_owned(),
            Self::Number(value) => format!("{value}"),
            Self::Add(a, b) => format!("({}+{})", a.text(), b.text()),
            Self::Mul(a, b) => format!("{}·{}", a.text(), b.text()),
            Self::Div(a, b) => format!("({})/({})", a.text(), b.text()),
            Self::Power(a, n) => format!("({})^{n}", a.text()),
            Self::Call(name, a) => format!("{name}({})", a.text()),
        }
    }

    fn value(&self, x: f64) -> f64 {
        match self {
            Self::X => x,
            Self::Number(value) => *value,
            Self::Add(a, b) => a.value(x) + b.value(x),
            Self::Mul(a, b) => a.value(x) * b.value(x),
            Self::Div(a, b) => a.value(x) / b.value(x),
            Self::Power(a, n) => a.value(x).powi(*n),
            Self::Call(name, a) => {
                let u = a.value(x);
                match *name {
                    "sin" => u.sin(),
                    "cos" => u.cos(),
                    "exp" => u.exp(),
                    "atan" => u.atan(),
                    "tanh" => u.tanh(),
                    "sinh" => u.sinh(),
                    "cosh" => u.cosh(),
                    "ln" => u.ln(),
                    _ => u.sqrt(),
                }
            }
        }
    }

    /// The derivative by the rules of school.
    fn derivative(&self) -> Self {
        let boxed = |tree: Self| Box::new(tree);
        let times = |a: Self, b: Self| Self::Mul(boxed(a), boxed(b));
        let plus = |a: Self, b: Self| Self::Add(boxed(a), boxed(b));
        let over = |a: Self, b: Self| Self::Div(boxed(a), boxed(b));
        match self {
            Self::X => Self::Number(1.0),
            Self::Number(_) | Self::Power(_, 0) => Self::Number(0.0),
            Self::Add(a, b) => plus(a.derivative(), b.derivative()),
            Self::Mul(a, b) => plus(times(a.derivative(), (**b).clone()), times((**a).clone(), b.derivative())),
            Self::Div(a, b) => {
                let low = times(times(Self::Number(-1.0), (**a).clone()), b.derivative());
                over(plus(times(a.derivative(), (**b).clone()), low), Self::Power(b.clone(), 2))
            }
            Self::Power(a, n) => {
                times(times(Self::Number(f64::from(*n)), Self::Power(a.clone(), n - 1)), a.derivative())
            }
            Self::Call(name, a) => {
                let same = |name: &'static str| Self::Call(name, a.clone());
                let square = |tree: Self| Self::Power(boxed(tree), 2);
                let outer = match *name {
                    "sin" => same("cos"),
                    "cos" => times(Self::Number(-1.0), same("sin")),
                    "exp" => same("exp"),
                    "sinh" => same("cosh"),
                    "cosh" => same("sinh"),
                    "tanh" => plus(Self::Number(1.0), times(Self::Number(-1.0), square(same("tanh")))),
                    "atan" => over(Self::Number(1.0), plus(Self::Number(1.0), square((**a).clone()))),
                    "ln" => over(Self::Number(1.0), (**a).clone()),
                    _ => over(Self::Number(0.5), same("sqrt")),
                };
                times(outer, a.derivative())
            }
        }
    }
}

#[test]
fn derivatives_are_those_of_the_rules_of_school_on_a_hundred_random_expressions() {
    let mut seed = 7;
    let mut done = 0;
    while done < 100 {
        let tree = Tree::random(&mut seed, 3);
        let (text, mut derivative) = (tree.text(), tree.clone());
        let Ok(formula) =
            Expression::parse(&text).unwrap_or_else(|problem| panic!("{text}: {problem:?}")).with(VARIABLES)
        else {
            continue;
        };
        let places: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
        for order in 0..4 {
            let expected: Vec<f64> = places.iter().map(|&x| derivative.value(x)).collect();
            let scale = expected.iter().fold(1.0_f64, |scale, value| scale.max(value.abs()));
            for (x, expected) in places.iter().zip(&expected) {
                let found = formula.at(*x).order(order);
                assert!(
                    (found - expected).abs() <= 1e-12 * scale,
                    "{text}, order {order} at {x}: {found}, not {expected}"
                );
            }
            derivative = derivative.derivative();
        }
        done += 1;
    }
}

/// Random strings: half of them of what expressions are made of. `LEVALAB_SOAK` says how many.
#[test]
fn any_text_is_an_expression_or_a_refusal() {
    let count: usize = std::env::var("LEVALAB_SOAK").map_or(20_000, |text| text.parse().expect("a number"));
    let pieces = [
        "x", "θ", "β", "L", "π", "s₀", "e", "sin(", "cos(", "sqrt(", "ln(", "tan(", ")", "(", "+", "-", "·", "/", "^",
        "2", "0,5", "1e3", "³", " ", "exp(", "asin(", "y", "\u{301}", "日", "..", "\0", "10^10^",
    ];
    let mut seed = 11_u64;
    let (mut read, mut smooth) = (0, 0);
    for _ in 0..count {
        let mut next = |n: usize| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as usize % n
        };
        let length = 1 + next(12);
        let text: String =
            (0..length).map(|_| if next(40) == 0 { "\u{1f3a1}" } else { pieces[next(pieces.len())] }).collect();
        match Expression::parse(&text) {
            Err(problem) => assert!(problem.at <= text.chars().count(), "{text:?}: {problem:?}"),
            Ok(expression) => {
                read += 1;
                if let Ok(formula) = expression.with(VARIABLES) {
                    smooth += 1;
                    for x in [0.0, 0.123, 0.5, 1.0] {
                        let motion = formula.at(x);
                        assert!((0..4).all(|order| motion.order(order).is_finite()), "{text:?} at {x}: {motion:?}");
                    }
                }
            }
        }
    }
    assert!(read > count / 100 && smooth > count / 200, "{read} of {count} are read, {smooth} are smooth");
}
