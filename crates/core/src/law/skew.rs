//! Symmetrical laws made skewed: the crossover, where the acceleration changes sign, moves away from the middle.

use super::{ArgumentProblem, Piece};
use crate::{Parameter, Quantity};

/// Where the crossover is, as a part of β.
pub(super) const CROSSOVER: Parameter =
    Parameter { key: "crossover", symbol: "xc", quantity: Quantity::Ratio, default: Some(0.4), optional: false };

/// Nearer than this to an end, one of the two halves would need an acceleration over ten times that of the symmetrical law.
const NEAREST: f64 = 0.05;

/// The law whose halves are those of a symmetrical one, stretched to `crossover` and to what is left.
///
/// With xc the crossover: y(x) = 2xc·Y(x/2xc) up to xc, and 1 − 2(1 − xc)·(1 − Y(½ + (x − xc)/(2(1 − xc)))) beyond. The rises xc and 1 − xc are
/// those with which the velocities agree; the peak velocity stays what it was, the accelerations become 1/2xc and 1/(2(1 − xc)) times as large,
/// so that what the one half gains the other pays: a⁺·xc = a⁻·(1 − xc) (Norton, *Cam Design and Manufacturing Handbook*, ch. 4; Rothbart,
/// *Cam Design Handbook*, ch. 3, asymmetrical curves).
///
/// # Errors
/// When the crossover, which is the parameter number `parameter` of the law, lies too near an end.
pub(super) fn skewed(symmetrical: &[Piece], crossover: f64, parameter: usize) -> Result<Vec<Piece>, ArgumentProblem> {
    if !(NEAREST..=1.0 - NEAREST).contains(&crossover) {
        return Err(ArgumentProblem { parameter, min: NEAREST, max: 1.0 - NEAREST });
    }
    if crossover == 0.5 {
        return Ok(symmetrical.to_vec());
    }
    let (first, second) = (2.0 * crossover, 2.0 * (1.0 - crossover));
    let mut pieces = Vec::with_capacity(symmetrical.len() + 1);
    let mut from = 0.0;
    for piece in symmetrical {
        if from < 0.5 {
            let until = if piece.until < 0.5 { first * piece.until } else { crossover };
            let curve = piece.curve.clone().scaled(first, 0.0);
            pieces.push(Piece { until, curve, origin: first * piece.origin, span: first * piece.span });
        }
        if piece.until > 0.5 {
            let along = |x: f64| crossover + second * (x - 0.5);
            let until = if piece.until < 1.0 { along(piece.until) } else { 1.0 };
            let curve = piece.curve.clone().scaled(second, 1.0 - second);
            pieces.push(Piece { until, curve, origin: along(piece.origin), span: second * piece.span });
        }
        from = piece.until;
    }
    Ok(pieces)
}
