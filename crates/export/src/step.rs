//! The angle between two rows of a table, or two points of a curve.

use crate::Refusal;

/// How far the steps may miss a whole turn, as a part of a step: what typing 360/7 with a few digits leaves.
const WHOLE: f64 = 1e-6;

/// Most steps to a turn: a hundredth of a degree.
const MOST: f64 = 36_000.0;

/// A turn divided evenly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step(usize);

impl Step {
    /// A degree, as the tables in books.
    pub const OF_TABLES: Self = Self(360);

    /// Half a degree: the chord of a curve of 100 mm radius then passes within a micrometre of it.
    pub const OF_CURVES: Self = Self(720);

    /// Steps of so many degrees.
    ///
    /// # Errors
    /// When a turn is not a whole number of them, or more than 36 000.
    pub fn of_degrees(degrees: f64) -> Result<Self, Refusal> {
        let count = 360.0 / degrees;
        let whole = count.round();
        if (1.0..=MOST).contains(&whole) && (count - whole).abs() <= WHOLE {
            Ok(Self(whole as usize))
        } else {
            Err(Refusal::Step { found: degrees })
        }
    }

    /// How many make a turn.
    #[must_use]
    pub fn count(self) -> usize {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_divides_the_turn() {
        for (degrees, count) in [(1.0, 360), (0.5, 720), (7.5, 48), (360.0, 1), (0.01, 36_000), (360.0 / 7.0, 7)] {
            assert_eq!(Step::of_degrees(degrees).map(Step::count), Ok(count));
        }
        for degrees in [0.0, -1.0, 7.0, 0.001, 400.0, f64::NAN, f64::INFINITY] {
            assert!(Step::of_degrees(degrees).is_err(), "{degrees}");
        }
    }
}
