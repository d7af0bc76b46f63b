//! The SCCA family with its crossover moved: a long soft acceleration and a short hard one, or the other way round.

use super::skew::{CROSSOVER, skewed};
use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, scca};

/// Both halves of a law of the SCCA family, each stretched to its own part of β.
pub const LAW: Law = Law {
    id: "skewed-scca",
    group: Group::Standard,
    parameters: &[scca::LAW.parameters[0], scca::LAW.parameters[1], CROSSOVER],
    shape: Shape::Unit(pieces),
};

fn pieces(arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    let symmetrical = scca::LAW.unit(arguments)?;
    skewed(&symmetrical, arguments.parameters[2], 2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Svaj;
    use std::f64::consts::TAU;

    fn unit(b: f64, c: f64, crossover: f64) -> Vec<Piece> {
        pieces(Arguments { parameters: [b, c, crossover], falling: false, beta: 1.0 }).expect("a law")
    }

    fn at(pieces: &[Piece], x: f64) -> Svaj {
        pieces.iter().find(|piece| x < piece.until).or(pieces.last()).expect("a piece").at(x)
    }

    fn peak(pieces: &[Piece], order: usize, from: f64, to: f64) -> f64 {
        let steps = 20_000;
        let places = (0..=steps).map(|i| from + (to - from) * f64::from(i) / f64::from(steps));
        places.map(|x| at(pieces, x).order(order).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn a_skewed_cycloidal_is_two_half_cycloids() {
        // y = x − (xc/π)·sin(πx/xc) up to xc; the mirror of the same with 1 − xc beyond.
        for crossover in [0.2, 0.35, 0.6] {
            let pieces = unit(0.5, 0.0, crossover);
            for i in 0..=40 {
                let x = f64::from(i) / 40.0;
                let half = |x: f64, span: f64| x - span / (TAU / 2.0) * (TAU / 2.0 * x / span).sin();
                let closed = if x <= crossover { half(x, crossover) } else { 1.0 - half(1.0 - x, 1.0 - crossover) };
                assert!((at(&pieces, x).s - closed).abs() < 1e-14, "xc = {crossover} at {x}");
            }
        }
    }

    #[test]
    fn the_peak_velocity_stays_and_the_accelerations_share_out() {
        // Modified sine: 1.7596, 5.5280, 69.47; modified trapezoidal: 2, 4.8881, 61.43 (Norton, table 3-2).
        for (b, c, [velocity, acceleration, jerk]) in
            [(0.25, 0.0, [1.7596, 5.5280, 69.47]), (0.25, 0.5, [2.0, 4.8881, 61.43])]
        {
            for crossover in [0.3, 0.45, 0.7] {
                let pieces = unit(b, c, crossover);
                let close = |found: f64, expected: f64| (found - expected).abs() < 1e-4 * expected;
                assert!(close(peak(&pieces, 1, 0.0, 1.0), velocity), "|y′| with xc = {crossover}");
                assert!(close(peak(&pieces, 2, 0.0, crossover), acceleration / (2.0 * crossover)), "{crossover}");
                assert!(close(peak(&pieces, 2, crossover, 1.0), acceleration / (2.0 - 2.0 * crossover)), "{crossover}");
                let narrow = f64::min(crossover, 1.0 - crossover);
                assert!(
                    close(peak(&pieces, 3, 0.0, 1.0), jerk / (4.0 * narrow * narrow)),
                    "|y‴| with xc = {crossover}"
                );
                assert!(at(&pieces, crossover).a.abs() < 1e-12, "the crossover is at xc");
            }
        }
    }

    #[test]
    fn in_the_middle_it_is_the_family_itself() {
        let arguments = Arguments { parameters: [0.3, 0.2, 0.5], falling: false, beta: 1.0 };
        assert_eq!(pieces(arguments), scca::LAW.unit(arguments));
    }

    #[test]
    fn a_crossover_at_an_end_is_refused() {
        for crossover in [0.0, 0.01, 0.99, f64::NAN] {
            let refused = pieces(Arguments { parameters: [0.25, 0.0, crossover], falling: false, beta: 1.0 });
            assert_eq!(refused.expect_err("too near").parameter, 2);
        }
    }
}
