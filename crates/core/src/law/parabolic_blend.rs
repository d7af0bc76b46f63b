//! Modified uniform motion: a parabola, a straight line, a parabola.

use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape};
use crate::{Curve, Parameter, Quantity};

/// Acceleration constant over β₁, none over β₂, constant over β₃ = β − β₁ − β₂; the velocity of the line is 1/(β₁/2 + β₂ + β₃/2), so that the
/// three rises L₁ : L₂ : L₃ are as β₁/2 : β₂ : β₃/2.
pub const LAW: Law = Law {
    id: "parabolic-blend",
    group: Group::Standard,
    parameters: &[
        Parameter { key: "beta1", symbol: "β1", quantity: Quantity::Span, default: Some(0.25), optional: false },
        Parameter { key: "beta3", symbol: "β3", quantity: Quantity::Span, default: Some(0.25), optional: false },
    ],
    shape: Shape::Unit(pieces),
};

/// What β₁ and β₃ may exceed β by together (parts of it): the rounding of typed degrees.
const ROUNDING: f64 = 1e-12;

/// A zone narrower than this part of β is taken as absent.
const NARROWEST_ZONE: f64 = 1e-9;

fn pieces(arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    let [first, last, _] = arguments.parameters;
    if !(0.0..=1.0).contains(&first) {
        return Err(ArgumentProblem { parameter: 0, min: 0.0, max: 1.0 });
    }
    if !(0.0..=1.0 - first + ROUNDING).contains(&last) {
        return Err(ArgumentProblem { parameter: 1, min: 0.0, max: 1.0 - first });
    }
    let velocity = 1.0 / (1.0 - 0.5 * (first + last));
    let (parabola, line) = (0.5 * velocity * first, velocity * (1.0 - first - last));
    let fall = 0.5 * velocity * last;
    // Each in its own u ∈ [0, 1]: a parabola from rest, a line, and 1 − L₃·(1 − u)².
    let zones = [
        (0.0, first, Curve::polynomial(&[0.0, 0.0, parabola])),
        (first, 1.0 - last, Curve::polynomial(&[parabola, line])),
        (1.0 - last, 1.0, Curve::polynomial(&[1.0 - fall, 2.0 * fall, -fall])),
    ];
    let wide = zones.into_iter().filter(|(from, until, _)| until - from > NARROWEST_ZONE);
    let mut pieces: Vec<Piece> = wide.map(|(from, until, curve)| Piece::between(from, until, curve)).collect();
    if let Some(piece) = pieces.last_mut() {
        piece.until = 1.0;
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rising(first: f64, last: f64) -> Vec<Piece> {
        pieces(Arguments { parameters: [first, last, 0.0], falling: false, beta: 1.0 }).expect("a law")
    }

    #[test]
    fn half_and_half_is_the_parabolic_law_and_nothing_is_constant_velocity() {
        for (parameters, id) in [([0.5, 0.5], "parabolic"), ([0.0, 0.0], "constant-velocity")] {
            let known = Law::by_id(id).expect(id);
            let known = known.unit(Arguments { parameters: [0.0; 3], falling: false, beta: 1.0 }).expect(id);
            let found = rising(parameters[0], parameters[1]);
            assert_eq!(found.len(), known.len(), "{id}");
            for (found, known) in found.iter().zip(&known) {
                let (f, k) = (found.at(0.3), known.at(0.3));
                assert!((f.s - k.s).abs() < 1e-14 && (f.v - k.v).abs() < 1e-14, "{id}");
            }
        }
    }

    #[test]
    fn the_rises_are_as_the_books_divide_them() {
        // β₁ : β₂ : β₃ = 0.2 : 0.5 : 0.3 gives L₁ : L₂ : L₃ = 0.1 : 0.5 : 0.15, and a velocity of 1/0.75.
        let pieces = rising(0.2, 0.3);
        assert!((pieces[0].at(0.2).s - 0.1 / 0.75).abs() < 1e-15);
        assert!((pieces[1].at(0.7).s - 0.6 / 0.75).abs() < 1e-15);
        assert!((pieces[1].at(0.5).v - 1.0 / 0.75).abs() < 1e-15);
        for pair in pieces.windows(2) {
            let (left, right) = (pair[0].at(pair[0].until), pair[1].at(pair[0].until));
            assert!((left.s - right.s).abs() < 1e-15 && (left.v - right.v).abs() < 1e-14);
        }
    }

    #[test]
    fn parabolas_that_do_not_fit_are_refused() {
        let refused = |first: f64, last: f64| {
            pieces(Arguments { parameters: [first, last, 0.0], falling: false, beta: 1.0 }).is_err()
        };
        assert!(refused(-0.1, 0.2) && refused(0.6, 0.5) && refused(1.1, 0.0) && refused(f64::NAN, 0.1));
        assert!(!refused(1.0, 0.0) && !refused(0.7, 0.3));
    }
}
