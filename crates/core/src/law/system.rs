//! The linear system of a polynomial as it is written on paper: its unknowns are the coefficients of the powers of x.

use super::conditions::checked;
use super::matched::falling_factorial;
use super::{Data, MAX_CONDITIONS};
use nalgebra::DMatrix;

/// A linear system: `matrix`·unknowns = `known`.
#[derive(Clone, Debug, PartialEq)]
pub struct System {
    /// The rows of the matrix.
    pub matrix: Vec<Vec<f64>>,
    /// The right side.
    pub known: Vec<f64>,
}

/// The system of a polynomial through conditions, those at x = 0 put in: each of them gives a coefficient by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct ConditionSystem {
    /// The coefficients that conditions at x = 0 give: which power, and its value.
    pub given: Vec<(usize, f64)>,
    /// The powers whose coefficients are left to find.
    pub unknown: Vec<usize>,
    /// For each row of the system, the condition that it is: its index in the data.
    pub rows: Vec<usize>,
    /// What is left to solve.
    pub system: System,
}

/// What is less than this part of a row's greatest entry, after elimination, is rounding.
const ROUNDING: f64 = 1e-12;

impl System {
    /// The inverse of the matrix; none when it is singular.
    #[must_use]
    pub fn inverse(&self) -> Option<Vec<Vec<f64>>> {
        let n = self.known.len();
        let inverse = DMatrix::from_fn(n, n, |row, column| self.matrix[row][column]).try_inverse()?;
        Some((0..n).map(|row| inverse.row(row).iter().copied().collect()).collect())
    }

    /// The same system after Gauss's elimination: below the diagonal there is nothing. Rows change places so that the greatest
    /// pivot is divided by.
    #[must_use]
    pub fn eliminated(&self) -> Self {
        let mut rows: Vec<Vec<f64>> =
            self.matrix.iter().zip(&self.known).map(|(row, known)| [&row[..], &[*known]].concat()).collect();
        let n = rows.len();
        for k in 0..n {
            let size = |row: &[f64]| row[k].abs();
            let pivot = (k..n).max_by(|&a, &b| size(&rows[a]).total_cmp(&size(&rows[b]))).unwrap_or(k);
            rows.swap(k, pivot);
            let (above, below) = rows.split_at_mut(k + 1);
            let pivot = &above[k];
            if pivot[k] == 0.0 {
                continue;
            }
            for row in below {
                let factor = row[k] / pivot[k];
                let largest = row.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
                for (value, taken) in row.iter_mut().zip(pivot).skip(k) {
                    *value -= factor * taken;
                    if value.abs() < ROUNDING * largest {
                        *value = 0.0;
                    }
                }
                row[k] = 0.0;
            }
        }
        let known = rows.iter_mut().filter_map(Vec::pop).collect();
        Self { matrix: rows, known }
    }
}

/// The system of the polynomial through these conditions, in powers of x = θ/β; none when they are not the data of a polynomial.
#[must_use]
pub fn condition_system(data: &Data, beta: f64) -> Option<ConditionSystem> {
    let conditions = checked(data, beta, 1..=MAX_CONDITIONS).ok()?;
    let of_start = |power: usize| conditions.iter().find(|c| c.at == 0.0 && usize::from(c.order) == power);
    let given: Vec<(usize, f64)> = (0..conditions.len().min(4))
        .filter_map(|power| Some((power, of_start(power)?.value / falling_factorial(power, power))))
        .collect();
    let is_given = |power: usize| given.iter().any(|(known, _)| *known == power);
    let unknown: Vec<usize> = (0..conditions.len()).filter(|&power| !is_given(power)).collect();
    // The derivative of xᵏ: nothing where it is differentiated away.
    let entry = |power: usize, order: usize, x: f64| {
        if power < order { 0.0 } else { falling_factorial(power, order) * x.powi((power - order) as i32) }
    };
    let left = |(_, c): &(usize, &super::Condition)| !(c.at == 0.0 && is_given(c.order.into()));
    let rest: Vec<(usize, &super::Condition)> = conditions.iter().enumerate().filter(left).collect();
    let row = |c: &super::Condition| unknown.iter().map(|&power| entry(power, c.order.into(), c.at)).collect();
    let known = |c: &super::Condition| {
        c.value - given.iter().map(|&(power, value)| value * entry(power, c.order.into(), c.at)).sum::<f64>()
    };
    let system = System {
        matrix: rest.iter().map(|(_, c)| row(c)).collect(),
        known: rest.iter().map(|(_, c)| known(c)).collect(),
    };
    let rows = rest.iter().map(|(index, _)| *index).collect();
    Some(ConditionSystem { given, unknown, rows, system })
}

#[cfg(test)]
mod tests {
    use super::super::Condition;
    use super::*;

    #[test]
    fn elimination_leaves_a_triangle_with_the_same_solution() {
        let system = System {
            matrix: vec![vec![0.0, 2.0, 1.0], vec![1.0, 1.0, 1.0], vec![4.0, -1.0, 0.5]],
            known: vec![7.0, 6.0, 3.5],
        };
        let solved = system.eliminated();
        let mut x = [0.0; 3];
        for row in (0..3).rev() {
            assert!(solved.matrix[row][..row].iter().all(|&value| value == 0.0), "{solved:?}");
            let rest: f64 = (row + 1..3).map(|k| solved.matrix[row][k] * x[k]).sum();
            x[row] = (solved.known[row] - rest) / solved.matrix[row][row];
        }
        for (found, expected) in x.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - expected).abs() < 1e-12, "{x:?}");
        }
    }

    #[test]
    fn conditions_at_the_start_give_their_coefficients_by_themselves() {
        let at = |at: f64, order: u8, value: f64| Condition { at, order, value };
        let data = Data::Conditions(vec![at(0.0, 0, 3.0), at(2.0, 0, 1.0), at(0.0, 2, 4.0), at(2.0, 1, 0.0)]);
        let system = condition_system(&data, 2.0).expect("a polynomial");
        assert_eq!(system.given, [(0, 3.0), (2, 8.0)]);
        assert_eq!((system.unknown, system.rows), (vec![1, 3], vec![1, 3]));
        assert_eq!(system.system, System { matrix: vec![vec![1.0, 1.0], vec![1.0, 3.0]], known: vec![-10.0, -16.0] });
    }
}
