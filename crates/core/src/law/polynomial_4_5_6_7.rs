//! Polynomial 4-5-6-7: velocity, acceleration and jerk vanish at both ends.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;

/// y = 35x⁴ − 84x⁵ + 70x⁶ − 20x⁷.
pub const LAW: Law =
    Law { id: "polynomial-4-5-6-7", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(single(Curve::polynomial(&[0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0])))
}
