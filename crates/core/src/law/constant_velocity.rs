//! Constant velocity: a straight line, with a step of velocity at each end beside a dwell.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;

/// y = x.
pub const LAW: Law = Law { id: "constant-velocity", group: Group::Basic, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(single(Curve::polynomial(&[0.0, 1.0])))
}
