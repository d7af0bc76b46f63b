//! First half of a harmonic: from rest to full speed.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;
use std::f64::consts::FRAC_PI_2;

/// y = 1 − cos(πx/2).
pub const LAW: Law = Law { id: "half-harmonic-start", group: Group::Half, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    Ok(single(Curve::polynomial(&[1.0]).with_wave(-1.0, FRAC_PI_2, FRAC_PI_2)))
}
