//! Modified sine: the lowest peak velocity and torque of the usual laws with continuous acceleration.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, scca::sine_constant_cosine};

/// The SCCA point b = ¼, c = 0.
pub const LAW: Law = Law { id: "modified-sine", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(sine_constant_cosine(0.25, 0.0))
}
