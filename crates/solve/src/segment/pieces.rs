//! The pieces of a segment in numbers: written out, or as a table of coefficients when there are many.

use super::{Part, variable};
use crate::board::{Board, LETTERS, cell, two};
use crate::curve::derivative;
use crate::document::{Line, formula};
use crate::layout::width;
use crate::number::{self, symbol};
use levalab_core::MAX_COEFFICIENTS;
use levalab_formula::Formula;

/// Pieces of a segment that are written out one by one; more of them go into a table of coefficients.
const WRITTEN_OUT: usize = 5;

/// A sum this wide stands without the fraction before it.
const WIDE: usize = 46;

/// s and its derivatives in numbers: for each piece, or in a table when there are many.
pub fn formulas(board: &mut Board, part: &Part) {
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
    let left = symbol(LETTERS[order]);
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
