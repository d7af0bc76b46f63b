//! Simple harmonic: half a cosine wave.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, scca::sine_constant_cosine};

/// y = (1 − cos πx)/2: the SCCA point b = 0, c = 0.
pub const LAW: Law = Law { id: "simple-harmonic", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(sine_constant_cosine(0.0, 0.0))
}
