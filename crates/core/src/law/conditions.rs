//! The linear system of boundary conditions: one equation a condition, one unknown a function of a basis.

use super::{Condition, Data, DataProblem};
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;

/// A place this close to the end of a segment (parts of it) is the end, which typed degrees come to but for their rounding.
const AT_THE_END: f64 = 1e-12;

/// A pivot smaller than this part of the greatest one is rounding: the system has no single solution.
const NO_PIVOT: f64 = 1e-13;

/// Items whose part in a dependency is smaller than this one of the greatest have no part in it.
const NO_PART: f64 = 1e-6;

/// The conditions of a segment, checked, with their places as parts of β and their derivatives with respect to that part.
pub(super) fn checked(data: &Data, beta: f64, count: RangeInclusive<usize>) -> Result<Vec<Condition>, DataProblem> {
    let Some(conditions) = data.conditions() else { return Err(DataProblem::Kind) };
    if !count.contains(&conditions.len()) {
        return Err(DataProblem::Count { found: conditions.len(), min: *count.start(), max: *count.end() });
    }
    let mut scaled: Vec<Condition> = Vec::with_capacity(conditions.len());
    for (item, &Condition { at, order, value }) in conditions.iter().enumerate() {
        if !at.is_finite() || !value.is_finite() {
            return Err(DataProblem::NotFinite { item });
        }
        if order > 3 {
            return Err(DataProblem::Order { item, found: order });
        }
        let x = if (at / beta - 1.0).abs() < AT_THE_END { 1.0 } else { at / beta };
        if !(0.0..=1.0).contains(&x) {
            return Err(DataProblem::Outside { item, found: at, beta });
        }
        if let Some(other) = scaled.iter().position(|c| c.order == order && (c.at - x).abs() < AT_THE_END) {
            return Err(DataProblem::Repeated { item, other });
        }
        scaled.push(Condition { at: x, order, value: value * beta.powi(order.into()) });
    }
    if scaled.iter().all(|condition| condition.order > 0) {
        return Err(DataProblem::NoHeight);
    }
    Ok(scaled)
}

/// The coefficients of the functions of a basis that meet as many conditions, and the condition number (1-norm) of the system.
///
/// `basis` gives the derivative of an order of every function at a place. Rows are scaled to one size first, so that a jerk weighs as
/// much as a height; the residual is solved for once more, which takes back what the elimination rounded away.
pub(super) fn solve(
    conditions: &[Condition],
    basis: impl Fn(usize, f64) -> Vec<f64>,
) -> Result<(Vec<f64>, f64), DataProblem> {
    let n = conditions.len();
    let mut matrix = DMatrix::zeros(n, n);
    let mut known = DVector::zeros(n);
    for (i, condition) in conditions.iter().enumerate() {
        let row = basis(condition.order.into(), condition.at);
        let size = row.iter().fold(0.0_f64, |size, value| size.max(value.abs())).max(f64::MIN_POSITIVE);
        row.iter().enumerate().for_each(|(k, value)| matrix[(i, k)] = value / size);
        known[i] = condition.value / size;
    }
    let factors = matrix.clone().full_piv_lu();
    let pivots = factors.u().diagonal();
    let largest = pivots[0].abs();
    let solved = factors.solve(&known).filter(|_| pivots.iter().all(|pivot| pivot.abs() > NO_PIVOT * largest));
    let (Some(first), Some(inverse)) = (solved, factors.try_inverse()) else {
        return Err(DataProblem::Dependent { items: dependent(&matrix) });
    };
    let residual = &known - &matrix * &first;
    let solution = factors.solve(&residual).map_or(first.clone(), |correction| first + correction);
    let norm = |matrix: &DMatrix<f64>| matrix.column_iter().map(|column| column.lp_norm(1)).fold(0.0, f64::max);
    Ok((solution.iter().copied().collect(), norm(&matrix) * norm(&inverse)))
}

/// The rows of a singular matrix that depend on each other: those with a part in a combination of rows that gives nothing.
fn dependent(matrix: &DMatrix<f64>) -> Vec<usize> {
    let factors = matrix.transpose().full_piv_lu();
    let upper = factors.u();
    let n = upper.ncols();
    let rank = (0..n).find(|&k| upper[(k, k)].abs() <= NO_PIVOT * upper[(0, 0)].abs()).unwrap_or(n - 1);
    let mut parts = DVector::zeros(n);
    parts[rank] = 1.0;
    for row in (0..rank).rev() {
        let sum: f64 = (row + 1..=rank).map(|k| upper[(row, k)] * parts[k]).sum();
        parts[row] = -sum / upper[(row, row)];
    }
    factors.q().inv_permute_rows(&mut parts);
    let most = parts.amax();
    (0..n).filter(|&item| parts[item].abs() > NO_PART * most).collect()
}
