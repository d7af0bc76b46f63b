//! A law between 0 and 1 as books write it, scaled to β and L.

use super::Part;
use super::pieces::formulas;
use crate::board::{Board, KnownLaw, LETTERS, two};
use crate::document::formula;
use crate::number::{self, Terms, symbol};
use levalab_core::law::{Arguments, Shape};
use levalab_core::{Quantity, Segment};
use levalab_formula::curve::{ORDERS, Written, written};

/// A law as books write it, and the first segment with the same; `None` for one whose numbers are not those of books.
fn recognised(board: &mut Board, k: usize, segment: &Segment) -> Option<(usize, Written)> {
    let Segment { law, parameters, beta, rise, .. } = *segment;
    matches!(law.shape, Shape::Unit(_)).then_some(())?;
    let arguments = Arguments { parameters, falling: rise < 0.0, beta };
    let depends_on_beta = law.parameters.iter().any(|parameter| parameter.quantity == Quantity::Span);
    let is_it = |known: &KnownLaw| {
        let other = known.arguments;
        known.id == law.id
            && other.parameters == parameters
            && other.falling == arguments.falling
            && (other.beta == beta || !depends_on_beta)
    };
    let written = match board.known_laws.iter().find(|known| is_it(known)) {
        Some(known) => return known.written.clone().map(|written| (known.segment, written)),
        None => law.unit(arguments).ok().and_then(|pieces| written(&pieces)),
    };
    // A return may be written as the rise is.
    let alike = |known: &&KnownLaw| known.id == law.id && known.written == written;
    let segment = board.known_laws.iter().find(alike).map_or(k, |known| known.segment);
    board.known_laws.push(KnownLaw { segment, id: law.id, arguments, written: written.clone() });
    written.map(|written| (segment, written))
}

/// A law that books write, scaled to β and L; one that they do not is given by its numbers. It is that of segment `k`.
pub fn write(board: &mut Board, part: &Part, k: usize) {
    let Segment { law, parameters, beta, rise, .. } = *part.segment;
    for (parameter, value) in law.parameters.iter().zip(parameters) {
        let symbol = match parameter.symbol {
            "β1" => "β_1",
            "β3" => "β_3",
            "xc" => "x_c",
            other => other,
        };
        match parameter.quantity {
            Quantity::Span => board.show(&format!("{symbol} = {}", board.place(value * beta))),
            _ => board.show(&format!("{symbol} = {}", number::datum(value))),
        }
    }
    let Some((first, known)) = recognised(board, k, part.segment) else {
        board.say(
            two(
                "The law with its numbers, each piece scaled by $L$ and $β$ and begun where the one before it ends:",
                "La ley con sus números, cada trozo llevado a $L$ y $β$ y empezado donde acaba el anterior:",
            ),
            &[],
        );
        return formulas(board, part);
    };
    match (first < k).then_some(first) {
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
    for (order, left) in LETTERS.iter().enumerate().skip(1) {
        if still(order) {
            board.show(&format!("{left} = 0"));
            continue;
        }
        let primes = "'".repeat(order);
        let raised = if order == 1 { String::new() } else { format!("^{order}") };
        let factor = number::result(lift * board.scale() / beta.powi(order as i32));
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
