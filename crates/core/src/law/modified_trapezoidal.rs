//! Modified trapezoidal: the lowest peak acceleration of the usual laws.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, scca::sine_constant_cosine};

/// The SCCA point b = ¼, c = ½.
pub const LAW: Law =
    Law { id: "modified-trapezoidal", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(sine_constant_cosine(0.25, 0.5))
}
