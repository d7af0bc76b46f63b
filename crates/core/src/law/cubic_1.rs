//! Cubic 1, the constant pulse: the same jerk all along, and a step of acceleration from +12 to −12 at x = ½.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, halves};
use crate::Curve;

/// y = 4x³ up to x = ½, then 1 − 4(1 − x)³.
pub const LAW: Law = Law { id: "cubic-1", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    // 1 − 4(1 − x)³, expanded.
    let second = Curve::polynomial(&[-3.0, 12.0, -12.0, 4.0]);
    Ok(halves(Curve::polynomial(&[0.0, 0.0, 0.0, 4.0]), second))
}
