//! Bézier's form of a polynomial: ordinates that the curve follows without passing through them.

use super::{Data, DataKind, DataProblem, Free, Given, Group, Law, Piece, Shape, Solved};
use crate::Series;

/// s = Σ yᵢ·Bᵢⁿ(x), Bernstein's polynomials, the control points evenly spaced over β. The first and last ordinates are met; three equal ones at
/// an end make *v* and *a* zero there.
pub const LAW: Law = Law {
    id: "bezier",
    group: Group::Free,
    parameters: &[],
    shape: Shape::Free(Free { data: DataKind::Ordinates, first: at_rest, solve: pieces }),
};

/// Most ordinates: the degree is one less.
pub const MAX_ORDINATES: usize = 25;

fn pieces(given: &Given) -> Result<Solved, DataProblem> {
    let Data::Ordinates(ordinates) = given.data else { return Err(DataProblem::Kind) };
    if !(2..=MAX_ORDINATES).contains(&ordinates.len()) {
        return Err(DataProblem::Count { found: ordinates.len(), min: 2, max: MAX_ORDINATES });
    }
    if let Some(item) = ordinates.iter().position(|ordinate| !ordinate.is_finite()) {
        return Err(DataProblem::NotFinite { item });
    }
    let series = Series::through(ordinates.len(), |x| de_casteljau(ordinates, x));
    Ok(Solved { pieces: vec![Piece::new(1.0, series)], condition: 1.0 })
}

/// De Casteljau's repeated interpolation, which loses nothing to rounding.
fn de_casteljau(ordinates: &[f64], x: f64) -> f64 {
    let mut points = ordinates.to_vec();
    for last in (1..points.len()).rev() {
        for i in 0..last {
            points[i] += x * (points[i + 1] - points[i]);
        }
    }
    points[0]
}

/// Three equal ordinates at either end: the 3-4-5 polynomial.
fn at_rest(_: f64, start: f64, rise: f64) -> Data {
    Data::Ordinates([[start; 3], [start + rise; 3]].concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_and_three_are_the_3_4_5() {
        let data = at_rest(1.0, 0.0, 1.0);
        let solved = pieces(&Given { data: &data, beta: 1.0, ..Given::default() }).expect("solved");
        let found = solved.pieces[0].curve.coefficients().expect("a polynomial");
        for (found, expected) in found.iter().zip([0.0, 0.0, 0.0, 10.0, -15.0, 6.0]) {
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
    }

    #[test]
    fn ends_are_met_and_slopes_are_those_of_the_first_and_last_sides() {
        let ordinates: Vec<f64> = (0..25).map(|k| f64::from(k * k % 11)).collect();
        let data = Data::Ordinates(ordinates.clone());
        let solved = pieces(&Given { data: &data, beta: 1.0, ..Given::default() }).expect("solved");
        let (start, end) = (solved.pieces[0].at(0.0), solved.pieces[0].at(1.0));
        assert!((start.s - ordinates[0]).abs() < 1e-12 && (end.s - ordinates[24]).abs() < 1e-12);
        assert!((start.v - 24.0 * (ordinates[1] - ordinates[0])).abs() < 1e-9);
        assert!((end.v - 24.0 * (ordinates[24] - ordinates[23])).abs() < 1e-9);
    }
}
