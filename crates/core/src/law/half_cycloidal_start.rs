//! First half of a cycloidal: from rest to full speed, acceleration zero at both ends.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;
use std::f64::consts::{FRAC_1_PI, PI};

/// y = x − sin(πx)/π.
pub const LAW: Law =
    Law { id: "half-cycloidal-start", group: Group::Half, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(single(Curve::polynomial(&[0.0, 1.0]).with_wave(-FRAC_1_PI, PI, 0.0)))
}
