//! Double harmonic: soft at the start, a step of acceleration at the end; its return is the rise reversed.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// y = ½[(1 − cos πx) − ¼(1 − cos 2πx)]; cosines are sines a quarter turn ahead.
pub const LAW: Law = Law { id: "double-harmonic", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    // Reversing x changes the sign of the second harmonic alone.
    let second = if arguments.falling { -0.125 } else { 0.125 };
    let curve = Curve::polynomial(&[0.5 - second]).with_wave(-0.5, PI, FRAC_PI_2).with_wave(second, TAU, FRAC_PI_2);
    Ok(single(curve))
}
