//! The user's own formula for s.

use super::{Data, DataKind, DataProblem, Free, Given, Group, Law, Piece, Shape, Solved};
use crate::expression::{Expression, Variables};

/// *s* above the base circle as an expression of x = θ/β, θ (from the segment's start), β, L (the rise) and s₀ (the height before it).
pub const LAW: Law = Law {
    id: "formula",
    group: Group::Free,
    parameters: &[],
    shape: Shape::Free(Free { data: DataKind::Expression, first, solve: pieces }),
};

fn pieces(given: &Given) -> Result<Solved, DataProblem> {
    let Data::Expression(text) = given.data else { return Err(DataProblem::Kind) };
    let expression = Expression::parse(text).map_err(DataProblem::Expression)?;
    let variables = Variables { beta: given.beta, rise: given.rise, start: given.start };
    let formula = expression.with(variables).map_err(DataProblem::Rough)?;
    Ok(Solved { pieces: vec![Piece::new(1.0, formula)], condition: 1.0 })
}

/// The 3-4-5 polynomial, as a student would write it.
fn first(_: f64, _: f64, _: f64) -> Data {
    Data::Expression("s₀ + L (10x³ − 15x⁴ + 6x⁵)".to_owned())
}
