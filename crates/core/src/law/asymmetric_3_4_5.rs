//! Polynomial 3-4-5 with its crossover moved: velocity and acceleration vanish at both ends, and the peaks of acceleration differ.

use super::skew::{CROSSOVER, skewed};
use super::{ArgumentProblem, Arguments, Group, Law, Piece, Shape, polynomial_3_4_5};

/// Both halves of the 3-4-5, each stretched to its own part of β.
pub const LAW: Law =
    Law { id: "asymmetric-3-4-5", group: Group::Standard, parameters: &[CROSSOVER], shape: Shape::Unit(pieces) };

fn pieces(arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
    let symmetrical = polynomial_3_4_5::LAW.unit(arguments)?;
    skewed(&symmetrical, arguments.parameters[0], 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_peaks_are_those_of_the_3_4_5_shared_out() {
        // |y″| of the 3-4-5 is 10/√3 where its jerk is zero, at x = ½ ∓ 1/√12; its |y′| is 15/8 and its |y‴| 60.
        let crossover = 0.4;
        let pieces = pieces(Arguments { parameters: [crossover, 0.0, 0.0], falling: false, beta: 1.0 }).expect("a law");
        let [up, down] = [&pieces[0], &pieces[1]];
        let (rising, falling) = (2.0 * crossover, 2.0 - 2.0 * crossover);
        let off = 1.0 / 12_f64.sqrt();
        let greatest = 10.0 / 3_f64.sqrt();
        assert!((up.at(rising * (0.5 - off)).a - greatest / rising).abs() < 1e-13);
        assert!((down.at(crossover + falling * off).a + greatest / falling).abs() < 1e-13);
        assert!(up.at(rising * (0.5 - off)).j.abs() < 1e-12 && down.at(crossover + falling * off).j.abs() < 1e-12);
        for piece in [up, down] {
            let there = piece.at(crossover);
            assert!((there.v - 1.875).abs() < 1e-14 && there.a.abs() < 1e-13 && (there.s - crossover).abs() < 1e-15);
        }
        assert!((up.at(0.0).j - 60.0 / rising.powi(2)).abs() < 1e-12);
        assert!((down.at(1.0).j - 60.0 / falling.powi(2)).abs() < 1e-11);
    }

    #[test]
    fn a_crossover_at_an_end_is_refused() {
        let refused = pieces(Arguments { parameters: [0.96, 0.0, 0.0], falling: false, beta: 1.0 });
        assert_eq!(refused, Err(ArgumentProblem { parameter: 0, min: 0.05, max: 0.95 }));
    }
}
