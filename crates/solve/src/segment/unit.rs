//! A law between 0 and 1 as books write it, scaled to β and L.

use super::Part;
use super::pieces::formulas;
use crate::board::{Board, LETTERS, two};
use crate::document::formula;
use crate::number::{self, Terms, symbol};
use levalab_core::law::{Arguments, Shape};
use levalab_core::{Quantity, Segment};
use levalab_formula::curve::{ORDERS, Written, written};

/// A law as books write it; none for one whose numbers are not those of books.
fn as_written(&Segment { law, parameters, beta, rise, .. }: &Segment) -> Option<Written> {
    matches!(law.shape, Shape::Unit(_)).then_some(())?;
    written(&law.unit(Arguments { parameters, falling: rise < 0.0, beta }).ok()?)
}

/// A law that books write, scaled to β and L; one that they do not is given by its numbers. The first `before` segments are written already.
pub fn write(board: &mut Board, part: &Part, before: usize) {
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
