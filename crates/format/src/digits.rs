//! Numbers as a person would write them: with few digits, but with as many as it takes.

/// Significant digits that a number is told with when they are enough.
pub(crate) const DIGITS: i32 = 4;

/// More digits than an `f64` has.
const ALL_DIGITS: i32 = 17;

/// The number rounded to the fewest digits, four or more, with which it is good.
pub(crate) fn shortest(exact: f64, how: fn(f64) -> f64, good: impl Fn(&f64) -> bool) -> Option<f64> {
    (DIGITS..ALL_DIGITS).map(|digits| round(exact, digits, how)).find(good)
}

/// The number nearest to `wanted` with few digits that lies between two others.
pub(crate) fn short_within(wanted: f64, least: f64, most: f64) -> Option<f64> {
    let how = if wanted <= least {
        f64::ceil
    } else if wanted >= most {
        f64::floor
    } else {
        f64::round
    };
    let inside = |value: &f64| (least..=most).contains(value);
    shortest(wanted, how, inside)
}

/// A number rounded to so many significant digits, by way of its decimal form so that it stays short.
pub(crate) fn round(value: f64, digits: i32, how: fn(f64) -> f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let place = value.abs().log10().floor() as i32 + 1 - digits;
    let units = how(value / 10_f64.powi(place));
    decimal(units.abs() as u128, place).copysign(value)
}

/// The `f64` nearest to `digits`·10^`power`; infinite beyond the greatest.
pub(crate) fn decimal(digits: u128, power: i32) -> f64 {
    // A number in this form is always read.
    format!("{digits}e{power}").parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_in_decimal() {
        assert_eq!(round(43.281_234, 4, f64::ceil), 43.29);
        assert_eq!(round(0.201_230_1, 4, f64::ceil), 0.2013);
        assert_eq!(round(123_456.0, 4, f64::ceil), 123_500.0);
        assert_eq!(round(-2.345_67, 4, f64::round), -2.346);
        assert_eq!(round(0.0, 4, f64::round), 0.0);
    }
}
