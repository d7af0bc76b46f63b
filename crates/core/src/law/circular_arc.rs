//! The motion that an arc of a circle gives to a flat face: not for menus, but for cams made of such arcs.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, halves};
use crate::Curve;
use std::f64::consts::FRAC_PI_2;

/// From rest over one arc to rest over another of the same angle: y = (1 − cos βx)/(4 sin²(β/4)) up to x = ½, then the same
/// from above. The support of a circle of radius R whose centre lies at distance c is R ± c·cos θ, hence ρ = Rb + s + a is
/// constant on each half, and the halves differ in it by 2c with c = L/(4 sin²(β/4)).
///
/// It is not among [`LAWS`](super::LAWS): its arcs are circles under a flat face only.
pub const LAW: Law = Law { id: "circular-arc", group: Group::Standard, parameters: &[], shape: Shape::Unit(pieces) };

fn pieces(arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    let beta = arguments.beta;
    let quarter = (0.25 * beta).sin();
    let height = 0.25 / (quarter * quarter);
    let first = Curve::polynomial(&[height]).with_wave(-height, beta, FRAC_PI_2);
    // sin(βx − β + π/2) = cos(β(1 − x)).
    let second = Curve::polynomial(&[1.0 - height]).with_wave(height, beta, FRAC_PI_2 - beta);
    Ok(halves(first, second))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_radius_of_curvature_is_constant_on_each_arc() {
        for beta in [0.2, 1.0, 3.0, 6.0] {
            let pieces =
                LAW.unit(Arguments { parameters: [0.0; 3], falling: false, beta }).expect("any angle makes arcs");
            let of = |piece: &Piece, x: f64| {
                let motion = piece.curve.at(x);
                motion.s + motion.a / (beta * beta)
            };
            let height = 0.25 / (0.25 * beta).sin().powi(2);
            for i in 0..=10 {
                let x = 0.05 * f64::from(i);
                assert!((of(&pieces[0], x) - height).abs() < 1e-13 * height, "β {beta}");
                assert!((of(&pieces[1], 0.5 + x) - (1.0 - height)).abs() < 1e-12 * height, "β {beta}");
            }
            let (left, right) = (pieces[0].curve.at(0.5), pieces[1].curve.at(0.5));
            assert!((left.s - right.s).abs() < 1e-13 * height && (left.v - right.v).abs() < 1e-13 * height);
            assert!(
                pieces[0].curve.at(0.0).s.abs() < 1e-13 * height
                    && (pieces[1].curve.at(1.0).s - 1.0).abs() < 1e-13 * height
            );
        }
    }
}
