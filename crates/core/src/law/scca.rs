//! The sine–constant–cosine acceleration family (Norton, *Cam Design and Manufacturing Handbook*, ch. 3).
//!
//! Acceleration grows as a sine over b/2, stays constant over c/2, swings to its opposite as a cosine over d, and mirrors
//! what came before; b + c + d = 1. Five classic laws are points of this family.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape};
use crate::{Curve, Parameter, Quantity};
use std::f64::consts::{FRAC_PI_2, PI};

/// The family with its two free fractions, b of the sine and c of the constant; d = 1 − b − c is the cosine's.
///
/// y″ = Cₐ·sin(πx/b) up to b/2, Cₐ up to (b + c)/2, Cₐ·cos(π(x − (b + c)/2)/d) up to 1 − (b + c)/2, and then the beginning backwards with its
/// sign changed; Cₐ = 4π²/((π² − 8)(b² − d²) − 2π(π − 2)b + π²).
pub const LAW: Law = Law {
    id: "scca",
    group: Group::Standard,
    parameters: &[
        Parameter { key: "b", symbol: "b", quantity: Quantity::Ratio, default: Some(0.25), optional: false },
        Parameter { key: "c", symbol: "c", quantity: Quantity::Ratio, default: Some(0.25), optional: false },
    ],
    shape: Shape::Unit(pieces),
};

/// A zone narrower than this is taken as absent: it would be shorter than a thousandth of a second of arc.
const NARROWEST_ZONE: f64 = 1e-9;

/// Two zones are the same formula when their curves differ by no more than the rounding of their own coefficients.
const SAME_FORMULA: f64 = 1e-13;

fn pieces(arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    let [b, c, _] = arguments.parameters;
    if !(0.0..=1.0).contains(&b) {
        return Err(ArgumentProblem { parameter: 0, min: 0.0, max: 1.0 });
    }
    if !(0.0..=1.0 - b + NARROWEST_ZONE).contains(&c) {
        return Err(ArgumentProblem { parameter: 1, min: 0.0, max: 1.0 - b });
    }
    Ok(sine_constant_cosine(b, c))
}

/// The pieces of the law with sine fraction `b` and constant fraction `c`; d = 1 − b − c is the cosine's.
///
/// Each zone's acceleration is integrated twice, the constants fixed by continuity of *y* and *y*′ from (0, 0), and the
/// whole divided by its value at x = 1, which gives the peak acceleration factor Cₐ.
pub(super) fn sine_constant_cosine(b: f64, c: f64) -> Vec<Piece> {
    let d = 1.0 - b - c;
    let cosine_from = 0.5 - 0.5 * d;
    let zones = [
        (0.5 * b, sine(b, 0.0)),
        (cosine_from, Curve::polynomial(&[0.0, 0.0, 0.5])),
        (1.0 - cosine_from, sine(d, cosine_from - 0.5 * d)),
        (1.0 - 0.5 * b, Curve::polynomial(&[0.0, 0.0, -0.5])),
        (1.0, sine(b, 1.0)),
    ];
    let mut joined: Vec<(f64, Curve)> = Vec::with_capacity(zones.len());
    let (mut from, mut height, mut slope) = (0.0, 0.0, 0.0);
    for (until, shape) in zones {
        if until - from < NARROWEST_ZONE {
            continue;
        }
        let start = shape.at(from);
        let line = slope - start.v;
        let curve = add_line(&shape, height - start.s - line * from, line);
        let end = curve.at(until);
        (from, height, slope) = (until, end.s, end.v);
        match joined.last_mut() {
            Some(last) if same_formula(&last.1, &curve) => last.0 = until,
            _ => joined.push((until, curve)),
        }
    }
    if let Some(last) = joined.last_mut() {
        last.0 = 1.0;
    }
    joined.into_iter().map(|(until, curve)| Piece::new(until, curve.scaled(1.0 / height, 0.0))).collect()
}

/// A curve whose second derivative is sin(π(x − `from`)/`span`).
fn sine(span: f64, from: f64) -> Curve {
    let frequency = PI / span;
    let curve = Curve::polynomial(&[0.0, 0.0]);
    if span < NARROWEST_ZONE {
        curve
    } else {
        curve.with_wave(-1.0 / (frequency * frequency), frequency, -frequency * from)
    }
}

fn add_line(shape: &Curve, constant: f64, slope: f64) -> Curve {
    let mut coefficients = [0.0; 3];
    coefficients[..shape.coefficients().len()].copy_from_slice(shape.coefficients());
    coefficients[0] += constant;
    coefficients[1] += slope;
    let terms = if coefficients[2] == 0.0 { 2 } else { 3 };
    let line = Curve::polynomial(&coefficients[..terms]);
    shape.waves().iter().fold(line, |curve, w| curve.with_wave(w.amplitude, w.frequency, w.phase))
}

/// Compares formulas by what they give over a quarter wave and beyond.
fn same_formula(one: &Curve, other: &Curve) -> bool {
    [0.0, 0.2, FRAC_PI_2 / 2.0, 1.0].iter().all(|&x| {
        let (p, q) = (one.at(x), other.at(x));
        (0..4).all(|order| (p.order(order) - q.order(order)).abs() <= SAME_FORMULA * (1.0 + p.order(3).abs()) * 50.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_of_acceleration_is_the_factor_of_the_handbook_in_closed_form() {
        for (b, c) in
            [(0.0, 0.0), (0.5, 0.0), (0.25, 0.0), (0.25, 0.5), (0.25, 0.25), (0.1, 0.7), (0.0, 1.0), (0.6, 0.1)]
        {
            let d = 1.0 - b - c;
            let factor = 4.0 * PI * PI / ((PI * PI - 8.0) * (b * b - d * d) - 2.0 * PI * (PI - 2.0) * b + PI * PI);
            let pieces = sine_constant_cosine(b, c);
            let piece = pieces.iter().find(|piece| 0.5 * b < piece.until).expect("a piece");
            let peak = piece.at(0.5 * b).a;
            assert!((peak - factor).abs() < 1e-10 * factor, "b = {b}, c = {c}: {peak}, not {factor}");
        }
    }
}
