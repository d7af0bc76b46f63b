//! Sums of decimals without rounding: what was typed adds up as on paper.

use crate::digits::decimal;
use std::iter::Sum;
use std::ops::{Add, Neg, Sub};

/// A decimal number in units of 10⁻¹⁸: exact for the shortest decimal form of any `f64` below 10²⁰ that has no digits
/// beyond the eighteenth decimal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Decimal(i128);

/// Decimals kept.
pub(crate) const DECIMALS: i32 = 18;

/// One, in units of 10⁻¹⁸.
const ONE: i128 = 10_i128.pow(DECIMALS as u32);

/// Below this size every whole number is an `f64`, and its digits are its own.
const EXACT: f64 = 9_007_199_254_740_992.0;

impl Decimal {
    /// The shortest decimal that reads back as `value`; zero when there is none.
    ///
    /// `value` must be below 10²⁰ in size, as everything in a design is.
    #[must_use]
    pub fn of(value: f64) -> Self {
        // Most numbers of a design, without a detour through their digits.
        if value.abs() < EXACT && value.trunc() == value {
            return Self(i128::from(value as i64) * ONE);
        }
        let text = format!("{value:e}");
        let Some((digits, exponent)) = text.split_once('e') else { return Self(0) };
        let decimals = digits.split_once('.').map_or(0, |(_, fraction)| fraction.len()) as i32;
        let (Ok(mantissa), Ok(exponent)) = (digits.replace('.', "").parse::<i128>(), exponent.parse::<i32>()) else {
            return Self(0);
        };
        let shift = exponent - decimals + DECIMALS;
        let power = 10_i128.checked_pow(shift.unsigned_abs());
        Self(match power {
            Some(power) if shift >= 0 => mantissa.saturating_mul(power),
            Some(power) => mantissa / power,
            None => 0,
        })
    }

    /// The decimals that it has: 0 for a whole number.
    #[must_use]
    pub(crate) fn places(self) -> i32 {
        let mut places = DECIMALS;
        let mut rest = self.0;
        while places > 0 && rest % 10 == 0 {
            rest /= 10;
            places -= 1;
        }
        places
    }

    /// How many steps of 10^−`decimals` it is, with as many decimals as it has or more.
    #[must_use]
    pub(crate) fn in_steps(self, decimals: i32) -> i128 {
        self.0 / step(decimals)
    }

    /// So many steps of 10^−`decimals`.
    #[must_use]
    pub(crate) fn of_steps(steps: i128, decimals: i32) -> Self {
        Self(steps.saturating_mul(step(decimals)))
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        let whole = (self.0 / ONE) as f64;
        if whole.abs() < EXACT && self.0 % ONE == 0 {
            return whole;
        }
        // Through its digits, which read back to the nearest; dividing would round twice.
        let value = decimal(self.0.unsigned_abs(), -DECIMALS);
        if self.0 < 0 { -value } else { value }
    }
}

/// 10^−`decimals` in units of 10⁻¹⁸.
fn step(decimals: i32) -> i128 {
    10_i128.pow(DECIMALS.saturating_sub(decimals).clamp(0, DECIMALS) as u32)
}

impl Add for Decimal {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Sub for Decimal {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }
}

impl Neg for Decimal {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Sum for Decimal {
    fn sum<I: Iterator<Item = Self>>(values: I) -> Self {
        values.fold(Self(0), Add::add)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tenths_add_up_as_on_paper() {
        let sum: Decimal = [0.1, 0.2, -0.3].into_iter().map(Decimal::of).sum();
        assert_eq!(sum, Decimal::default());
        let sum: Decimal = [333_333.3; 3].into_iter().map(Decimal::of).sum();
        assert_eq!(sum.to_f64(), 999_999.9);
    }

    #[test]
    fn a_decimal_reads_back_as_the_number_it_came_from() {
        for value in [0.0, 1.0, -12.5, 360.0, 1e6, 0.001, 33.333333333333336, 1e-9, 123456.789] {
            assert_eq!(Decimal::of(value).to_f64(), value);
        }
    }

    #[test]
    fn what_is_too_small_counts_as_nothing_and_what_is_too_large_stays_large() {
        assert_eq!(Decimal::of(5e-324), Decimal::default());
        assert_eq!(Decimal::of(f64::NAN), Decimal::default());
        assert!(Decimal::of(1e19).to_f64() >= 1e19);
    }
}
