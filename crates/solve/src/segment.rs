//! One segment: its conditions, its formulas with numbers put in, and where its derivatives vanish.

use crate::board::{Board, Two, cell, two};
use crate::curve::derivative;
use crate::document::{Line, formula};
use crate::layout::width;
use crate::number::{self, Terms, symbol};
use crate::{expression, extremes, system};
use levalab_core::law::{Arguments, Data, Shape};
use levalab_core::{Form, MAX_COEFFICIENTS, Segment, Stretch};
use levalab_formula::Formula;
use levalab_formula::curve::{ORDERS, Written, written};

/// Pieces of a segment that are written out one by one; more of them go into a table of coefficients.
const WRITTEN_OUT: usize = 5;

/// A sum this wide stands without the fraction before it.
const WIDE: usize = 46;

/// A segment of the motion with what belongs to it.
pub struct Part<'a> {
    pub segment: &'a Segment,
    pub from: f64,
    pub to: f64,
    pub start: f64,
    pub stretches: Vec<&'a Stretch>,
}

impl<'a> Part<'a> {
    pub fn of(board: &Board<'a>, k: usize) -> Self {
        let program = &board.cam().program;
        Self {
            segment: &program.segments()[k],
            from: program.borders()[k],
            to: program.borders()[k + 1],
            start: program.heights()[k],
            stretches: program.stretches().iter().filter(|stretch| stretch.segment == k).collect(),
        }
    }

    pub fn beta(&self) -> f64 {
        self.to - self.from
    }

    /// The curve of a segment that has only one, in x.
    pub fn whole(&self) -> Option<&'a Form> {
        match self.stretches[..] {
            [only] if !self.has_own_variable(only) => Some(only.formula().0),
            _ => None,
        }
    }

    /// True when the variable of a stretch is not the x of the segment.
    fn has_own_variable(&self, stretch: &Stretch) -> bool {
        /// Radians that tell two places apart.
        const NEAR: f64 = 1e-9;
        let (_, origin, beta) = stretch.formula();
        (origin - self.from).abs() > NEAR || (beta - self.beta()).abs() > NEAR
    }
}

/// Writes segment `k`; `alone` when no other is written.
pub fn write(board: &mut Board, k: usize, alone: bool) {
    let part = Part::of(board, k);
    let (from, to) = (board.place(part.from), board.place(part.to));
    let law = levalab_words::law(board.language, part.segment.law);
    board.heading(
        2,
        two("Segment {n}: {law}, $ {from} ≤ θ ≤ {to}$", "Tramo {n}: ley {law}, $ {from} ≤ θ ≤ {to}$"),
        &[("n", &(k + 1).to_string()), ("law", law), ("from", &from), ("to", &to)],
    );
    if part.stretches.iter().all(|stretch| stretch.is_still()) {
        let height = board.height(part.start);
        board.say(two("The follower rests:", "El seguidor está en reposo:"), &[]);
        board.show(&format!("s = {height}, v = 0, a = 0, j = 0"));
        return;
    }
    variable(board, "x", part.from, part.beta());
    match part.segment.law.shape {
        Shape::Rest => {}
        Shape::Unit(_) => unit(board, &part, if alone { 0 } else { k }),
        Shape::Matched(orders) => {
            system::between_neighbours(board, &part, orders);
            formulas(board, &part);
        }
        Shape::Free(_) => free(board, &part),
    }
    extremes::within(board, &part);
}

/// x = (θ − 90°)/60°, β = 60° = 1.0472 rad
fn variable(board: &mut Board, letter: &str, from: f64, beta: f64) {
    let of = if letter == "x" { "β" } else { "β_u" };
    let above = match board.place(from) {
        _ if from == 0.0 => "θ".to_owned(),
        before if before.starts_with('-') => format!("θ + {}", before.trim_start_matches('-')),
        after => format!("θ - {after}"),
    };
    let own = board.place(beta);
    let radians = if board.travels() { String::new() } else { format!(" = {} {{rad}}", number::result(beta)) };
    board.show(&format!("{letter} = ({above})/({own}), {of} = {own}{radians}"));
}

/// A law as books write it; none for one whose numbers are not those of books.
fn as_written(&Segment { law, parameters, beta, rise, .. }: &Segment) -> Option<Written> {
    matches!(law.shape, Shape::Unit(_)).then_some(())?;
    written(&law.unit(Arguments { parameters, falling: rise < 0.0, beta }).ok()?)
}

/// A law that books write, scaled to β and L; one that they do not is given by its numbers. The first `before` segments are written already.
fn unit(board: &mut Board, part: &Part, before: usize) {
    let Segment { law, parameters, beta, rise, .. } = *part.segment;
    for (parameter, value) in law.parameters.iter().zip(parameters) {
        let symbol = match parameter.symbol {
            "β1" => "β_1",
            "β3" => "β_3",
            "xc" => "x_c",
            other => other,
        };
        match parameter.quantity {
            levalab_core::Quantity::Span => board.show(&format!("{symbol} = {}", board.place(value * beta))),
            _ => board.show(&format!("{symbol} = {}", number::datum(value))),
        }
    }
    let Some(known) = as_written(part.segment) else {
        board.say(
            two(
                "The law with its numbers, each piece scaled by $L$ and $β$ and begun where the one before it ends:",
                "La ley con sus números, cada trozo llevado a $L$ y $β$ y empezado donde acaba el anterior:",
            ),
            &[],
        );
        return formulas(board, part);
    };
    let earlier = &board.cam().program.segments()[..before];
    let same = earlier.iter().position(|other| other.law.id == law.id && as_written(other).as_ref() == Some(&known));
    match same {
        Some(other) => board.say(
            two(
                "The law $y(x)$ and its derivatives are those of segment {n}.",
                "La ley $y(x)$ y sus derivadas son las del tramo {n}.",
            ),
            &[("n", &(other + 1).to_string())],
        ),
        None => law_between(board, &known),
    }
    let (start, lift) = (part.start, rise);
    board.say(
        two("From $s_i = {start}$ with $L = {rise}$:", "Desde $s_i = {start}$ con $L = {rise}$:"),
        &[("start", &board.height(start)), ("rise", &board.height(lift))],
    );
    let mut terms = Terms::default();
    terms.add(&board.figure(0, start), None);
    terms.add(&number::height(lift * board.scale()), Some(symbol("y")));
    board.equate(symbol("s"), vec![('=', formula("s_i + L y")), ('=', terms.sum())]);
    let still = |order: usize| known.pieces.iter().all(|piece| piece.orders[order] == "0");
    for order in 1..4 {
        if still(order) {
            board.show(&format!("{} = 0", crate::board::LETTERS[order]));
            continue;
        }
        let primes = "'".repeat(order);
        let raised = if order == 1 { String::new() } else { format!("^{order}") };
        let factor = number::result(lift * board.scale() / beta.powi(order as i32));
        let left = crate::board::LETTERS[order];
        board.show(&format!("{left} = (L)/(β{raised}) y{primes} = {factor} y{primes}"));
    }
}

/// y(x) of a law and its derivatives.
fn law_between(board: &mut Board, known: &Written) {
    board.say(
        two(
            "The law between $y(0) = 0$ and $y(1) = 1$, with its derivatives with respect to $x$:",
            "La ley entre $y(0) = 0$ e $y(1) = 1$, con sus derivadas respecto a $x$:",
        ),
        &[],
    );
    if let Some(factor) = &known.factor {
        board.show(&format!("C_a = {factor}"));
    }
    for piece in &known.pieces {
        if known.pieces.len() > 1 {
            board.say(two("For $ {span}$:", "Para $ {span}$:"), &[("span", &piece.span)]);
        }
        for (left, right) in ORDERS.iter().zip(&piece.orders) {
            board.show(&format!("{left} = {right}"));
        }
    }
}

/// s and its derivatives in numbers: for each piece, or in a table when there are many.
fn formulas(board: &mut Board, part: &Part) {
    if part.stretches.len() > WRITTEN_OUT {
        return coefficients(board, part);
    }
    for stretch in &part.stretches {
        let (form, origin, beta) = stretch.formula();
        let own = part.has_own_variable(stretch);
        if part.stretches.len() > 1 {
            let (from, to) = (board.place(stretch.from), board.place(stretch.to));
            board.say(two("For $ {from} ≤ θ ≤ {to}$:", "Para $ {from} ≤ θ ≤ {to}$:"), &[("from", &from), ("to", &to)]);
        }
        if own {
            variable(board, "u", origin, beta);
        }
        let letter = if own { "u" } else { "x" };
        let scaled = form.clone().scaled(board.scale(), 0.0);
        for order in 0..4 {
            let Some(sum) = derivative(&scaled, order, letter) else { continue };
            let (left, right) = sided(order, sum, if own { "β_u" } else { "β" });
            board.equate(left, vec![('=', right)]);
        }
    }
}

/// v = 1/β·[…]; β v = … when the sum is wide.
pub fn sided(order: usize, sum: Formula, beta: &str) -> (Formula, Formula) {
    let left = symbol(crate::board::LETTERS[order]);
    let zero = sum == Formula::Number("0".into());
    if order == 0 || zero {
        return (left, sum);
    }
    let beta = if order == 1 { formula(beta) } else { formula(&format!("{beta}^{order}")) };
    if width(&sum) > WIDE {
        return (Formula::Product(vec![beta, left]), sum);
    }
    let one = Formula::Fraction(Box::new(Formula::Number("1".into())), Box::new(beta));
    let right = match sum {
        Formula::Sum(_) | Formula::Negative(_) => Formula::Product(vec![one, Formula::Bracket(Box::new(sum))]),
        // A point keeps the numbers of a single term apart from those of the fraction.
        other => Formula::Times('·', Box::new(one), Box::new(other)),
    };
    (left, right)
}

/// A row of coefficients for each piece.
fn coefficients(board: &mut Board, part: &Part) {
    board.say(
        two(
            "Each piece is a polynomial in $u = (θ - θ_u)/(β_u)$, with $θ_u$ and $θ_u + β_u$ its ends: $s = c_0 + c_1 u + c_2 u^2 + …$, $β_u v = c_1 + 2 c_2 u + …$, and so on.",
            "Cada trozo es un polinomio en $u = (θ - θ_u)/(β_u)$, con $θ_u$ y $θ_u + β_u$ sus extremos: $s = c_0 + c_1 u + c_2 u^2 + …$, $β_u v = c_1 + 2 c_2 u + …$, y así sucesivamente.",
        ),
        &[],
    );
    let scale = board.scale();
    let all: Vec<Vec<f64>> = part
        .stretches
        .iter()
        .map(|stretch| stretch.formula().0.clone().scaled(scale, 0.0).coefficients().unwrap_or_default())
        .collect();
    let most = all.iter().map(Vec::len).max().unwrap_or(0).min(MAX_COEFFICIENTS);
    let mut heads: Vec<Line> = vec![board.line(two("from $θ$ to", "de $θ$ a"), &[])];
    heads.extend((0..most).map(|k| cell(&format!("c_{k}"))));
    let rows = part.stretches.iter().zip(&all).map(|(stretch, values)| {
        let mut row = vec![cell(&format!("{} → {}", board.solved_place(stretch.from), board.solved_place(stretch.to)))];
        let texts = number::coefficients(values);
        row.extend((0..most).map(|k| texts.get(k).map_or_else(Line::new, |text| cell(text))));
        row
    });
    let rows = rows.collect();
    board.table(two("Coefficients of the pieces", "Coeficientes de los trozos"), heads, rows);
}

fn free(board: &mut Board, part: &Part) {
    match &part.segment.data {
        Data::Conditions(_) | Data::Spline { .. } => {
            system::conditions(board, part);
            formulas(board, part);
        }
        Data::Points(points) => {
            points_of(board, part, points);
            formulas(board, part);
        }
        Data::Ordinates(ordinates) => {
            bernstein(board, part, ordinates);
            formulas(board, part);
        }
        Data::Expression(text) => expression::write(board, part, text),
        Data::None => formulas(board, part),
    }
}

const SPLINE: Two = two(
    "Between two points the curve is a quintic with $s$, $v$ and $a$ given at both; the $v$ and $a$ of the inner points are those with which $j$ and its derivative are continuous too.",
    "Entre dos puntos la curva es un polinomio de 5.º grado con $s$, $v$ y $a$ dados en ambos; las $v$ y $a$ de los puntos interiores son aquellas con las que también $j$ y su derivada son continuas.",
);

const SMOOTHED: Two = two(
    "The curve does not go through the inner points: their residuals have a root mean square $δ = {smoothing}$, and of all such curves it is the one with the least integral of $j^2$. Its heights at the points take their place below.",
    "La curva no pasa por los puntos interiores: sus residuos tienen una media cuadrática $δ = {smoothing}$, y de todas las curvas así es la de menor integral de $j^2$. Sus alturas en los puntos hacen aquí el papel de las medidas.",
);

fn points_of(board: &mut Board, part: &Part, points: &[[f64; 2]]) {
    let heads = vec![cell("θ"), cell("s")];
    let scale = board.scale();
    let rows = points
        .iter()
        .map(|[at, s]| vec![cell(&board.place(part.from + at)), cell(&(number::height(s * scale) + &board.unit(0)))]);
    let rows = rows.collect();
    board.table(two("Points of the table", "Puntos de la tabla"), heads, rows);
    let smoothing = part.segment.parameters[0];
    if smoothing > 0.0 {
        board.say(SMOOTHED, &[("smoothing", &(number::datum(smoothing * scale) + &board.unit(0)))]);
    }
    board.say(SPLINE, &[]);
}

fn bernstein(board: &mut Board, part: &Part, ordinates: &[f64]) {
    let degree = ordinates.len().saturating_sub(1);
    let scale = board.scale();
    let heads = vec![cell("i"), cell("θ"), cell("y_i")];
    let rows = ordinates.iter().enumerate().map(|(i, y)| {
        let at = part.from + part.beta() * i as f64 / degree.max(1) as f64;
        vec![cell(&i.to_string()), cell(&board.solved_place(at)), cell(&(number::height(y * scale) + &board.unit(0)))]
    });
    let rows = rows.collect();
    board.table(two("Ordinates of Bézier's polygon", "Ordenadas del polígono de Bézier"), heads, rows);
    board.say(
        two(
            "With Bernstein's polynomials of degree $n = {n}$ the curve is $s = y_0 B_0 + y_1 B_1 + … + y_n B_n$; multiplied out:",
            "Con los polinomios de Bernstein de grado $n = {n}$ la curva es $s = y_0 B_0 + y_1 B_1 + … + y_n B_n$; desarrollada:",
        ),
        &[("n", &degree.to_string())],
    );
    board.show("B_i = (n{!})/(i{!} (n - i){!}) x^i (1 - x)^(n - i)");
}
