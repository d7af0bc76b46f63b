//! Cubic 2: one cubic over the whole stretch, with a step of acceleration at each end.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;

/// y = 3x² − 2x³.
pub const LAW: Law = Law { id: "cubic-2", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(single(Curve::polynomial(&[0.0, 0.0, 3.0, -2.0])))
}
