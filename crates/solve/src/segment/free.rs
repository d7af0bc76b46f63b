//! A free law: its data, and the way from them to the pieces.

use super::Part;
use super::pieces::formulas;
use crate::board::{Board, Two, cell, two};
use crate::{expression, number, system};
use levalab_core::law::Data;

/// Writes what the data of a segment are and what they come to.
pub fn write(board: &mut Board, part: &Part) {
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
