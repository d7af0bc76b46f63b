//! Round values along an axis.

use levalab_numbers::write::{DecimalSign, fixed};

/// Most ticks along the y axis.
const MOST: usize = 6;

/// The most characters of a label without a power of ten, its minus included; the gutter has room for so many.
pub(crate) const LONGEST_LABEL: usize = 5;

/// Steps of θ in degrees, all of them parts of a turn.
const ANGLES: [u32; 5] = [30, 45, 60, 90, 180];

/// Ticks of the y axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ticks {
    /// The first is `first`·`step`, the last `last`·`step`.
    first: i64,
    last: i64,
    step: f64,
    decimals: usize,
    /// Labels are divided by 10 to this power.
    pub exponent: i32,
}

impl Ticks {
    /// The finest 1-2-5 steps that leave `gap` (in the unit of the axis) between ticks.
    pub fn within(low: f64, high: f64, gap: f64) -> Self {
        let coarsest = gap.max((high - low) / MOST as f64).max(f64::MIN_POSITIVE);
        let mut power = coarsest.log10().floor() as i32;
        let mantissa = [1, 2, 5].into_iter().find(|&m| f64::from(m) * ten_to(power) >= coarsest * (1.0 - ROUNDING));
        let mantissa = mantissa.unwrap_or_else(|| {
            power += 1;
            1
        });
        let step = f64::from(mantissa) * ten_to(power);
        let (first, last) = ((low / step - ROUNDING).ceil() as i64, (high / step + ROUNDING).floor() as i64);
        let largest = first.unsigned_abs().max(last.unsigned_abs()) as f64 * step;
        let mut ticks = Self { first, last, step, decimals: (-power).max(0) as usize, exponent: 0 };
        if ticks.longest_label() > LONGEST_LABEL {
            ticks.exponent = (largest.log10() / 3.0).floor() as i32 * 3;
            ticks.decimals = (ticks.exponent - power).max(0) as usize;
        }
        ticks
    }

    /// Only zero.
    pub fn zero() -> Self {
        Self { first: 0, last: 0, step: 1.0, decimals: 0, exponent: 0 }
    }

    /// Their values.
    pub fn values(self) -> impl Iterator<Item = f64> {
        (self.first..=self.last).map(move |k| k as f64 * self.step)
    }

    /// The label of one of them.
    pub fn label(self, value: f64, sign: DecimalSign) -> String {
        if value == 0.0 { "0".to_owned() } else { fixed(value / ten_to(self.exponent), self.decimals, sign) }
    }

    fn longest_label(self) -> usize {
        let ends = [self.first, self.last].map(|k| self.label(k as f64 * self.step, DecimalSign::Point));
        ends.iter().map(|label| label.chars().filter(|&c| c != '\u{202f}').count()).max().unwrap_or(0)
    }
}

/// A tick this near to the end of the axis (in steps) is on it.
const ROUNDING: f64 = 1e-9;

/// 10ⁿ, exact where an f64 can be.
pub(crate) fn ten_to(power: i32) -> f64 {
    if power < 0 { 1.0 / 10_f64.powi(-power) } else { 10_f64.powi(power) }
}

/// Degrees between ticks of θ, when a tick needs `gap` degrees.
pub(crate) fn angle_step(gap: f64) -> u32 {
    ANGLES.into_iter().find(|&step| f64::from(step) >= gap).unwrap_or(360)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64, gap: f64) -> (Vec<String>, i32) {
        let ticks = Ticks::within(low, high, gap);
        (ticks.values().map(|value| ticks.label(value, DecimalSign::Point)).collect(), ticks.exponent)
    }

    #[test]
    fn ticks_are_round_and_in_the_right_digits() {
        assert_eq!(labels(0.0, 11.0, 2.2).0, ["0", "5", "10"]);
        assert_eq!(
            labels(-0.21, 0.08, 0.05).0,
            ["\u{2212}0.20", "\u{2212}0.15", "\u{2212}0.10", "\u{2212}0.05", "0", "0.05"]
        );
        assert_eq!(labels(-31.0, 31.0, 10.0).0.len(), 3, "20 by 20, because 10 by 10 would be seven");
        assert_eq!(labels(-950.0, 1300.0, 400.0).0, ["\u{2212}500", "0", "500", "1000"]);
    }

    #[test]
    fn a_power_of_ten_is_taken_only_when_labels_would_not_fit() {
        assert_eq!(
            labels(-20_000.0, 52_000.0, 15_000.0),
            (vec!["\u{2212}20".into(), "0".into(), "20".into(), "40".into()], 3)
        );
        assert_eq!(labels(0.0, 9_999.0, 2_500.0).1, 0);
        assert_eq!(labels(-0.0025, 0.0025, 0.001).1, -3);
        assert_eq!(labels(0.0, 0.3, 0.1).1, 0);
    }

    #[test]
    fn theta_is_parted_evenly() {
        assert_eq!([20.0, 31.0, 50.0, 61.0, 100.0, 200.0].map(angle_step), [30, 45, 60, 90, 180, 360]);
    }
}
