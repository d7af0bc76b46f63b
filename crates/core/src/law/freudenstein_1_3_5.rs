//! Freudenstein 1-3-5: a cycloidal with a third and a fifth harmonic that flatten its acceleration.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, single};
use crate::Curve;
use std::f64::consts::TAU;

/// y = x − (1125/1192)/2π · (sin 2πx + sin 6πx/54 + sin 10πx/1250).
pub const LAW: Law =
    Law { id: "freudenstein-1-3-5", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

/// The share of the first harmonic with which v = 0 at both ends: 1/(1 + 1/18 + 1/250).
const SHARE: f64 = 1125.0 / 1192.0;

fn pieces(_: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    let curve = [(1.0, 1.0), (3.0, 54.0), (5.0, 1250.0)]
        .into_iter()
        .fold(Curve::polynomial(&[0.0, 1.0]), |curve, (n, by)| curve.with_wave(-SHARE / (TAU * by), n * TAU, 0.0));
    Ok(single(curve))
}
