//! Polynomial 3-4-5: velocity and acceleration vanish at both ends.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;

/// y = 10x³ − 15x⁴ + 6x⁵.
pub const LAW: Law =
    Law { id: "polynomial-3-4-5", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(single(Curve::polynomial(&[0.0, 0.0, 0.0, 10.0, -15.0, 6.0])))
}
