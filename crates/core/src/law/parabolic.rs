//! Parabolic: constant acceleration, then constant deceleration of the same size.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, scca::sine_constant_cosine};

/// y = 2x² up to x = ½, then 1 − 2(1 − x)²: the SCCA point b = 0, c = 1.
pub const LAW: Law = Law { id: "parabolic", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(sine_constant_cosine(0.0, 1.0))
}
