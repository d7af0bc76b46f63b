//! Cycloidal: a full sine of acceleration, zero at both ends.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, scca::sine_constant_cosine};

/// y = x − sin(2πx)/2π: the SCCA point b = ½, c = 0.
pub const LAW: Law = Law { id: "cycloidal", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(sine_constant_cosine(0.5, 0.0))
}
