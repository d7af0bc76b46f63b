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
    rounded_at(value, magnitude(value) + 1 - digits, how)
}

/// The power of ten of the leading digit; any size of a number, endless ones too.
pub(crate) fn magnitude(value: f64) -> i32 {
    /// Beyond the powers that an `f64` has.
    const MOST: f64 = 400.0;
    value.abs().log10().floor().clamp(-MOST, MOST) as i32
}

/// A number rounded to a multiple of 10^`place`, likewise.
pub(crate) fn rounded_at(value: f64, place: i32, how: fn(f64) -> f64) -> f64 {
    let units = how(value / 10_f64.powi(place));
    if !units.is_finite() {
        return value;
    }
    decimal(units.abs() as u128, place).copysign(value)
}

/// Digits that sums and quotients of typed decimals keep: what they leave beyond them is rounding.
const TYPED_DIGITS: i32 = 12;

/// A number without the rounding that sums and quotients leave: twelve digits of it; −0 becomes 0.
#[must_use]
pub fn clean(value: f64) -> f64 {
    round(value, TYPED_DIGITS, f64::round) + 0.0
}

/// A sum or a difference of heights without that rounding, where leaving it away cannot be seen in another sum.
pub(crate) fn clean_sum(value: f64) -> f64 {
    let short = clean(value);
    if (short - value).abs() <= crate::limits::SUM_ROUNDING { short } else { value }
}

/// The nearest, or the next, of 1, 1.5, 2, 2.5 … 10 times a power of ten; `value` is positive.
pub(crate) fn half_figures(value: f64, how: fn(f64) -> f64) -> f64 {
    /// What division may add to a number that is one of them already.
    const ROUNDING: f64 = 1e-9;
    if value <= 0.0 || !value.is_finite() {
        return value;
    }
    let place = magnitude(value);
    let halves = how(2.0 * value / 10_f64.powi(place) - ROUNDING);
    decimal(5 * halves as u128, place - 1)
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

    #[test]
    fn sizes_to_begin_with_have_half_figures() {
        for (value, nearest, next) in
            [(7.0, 7.0, 7.0), (67.2, 65.0, 70.0), (0.3, 0.3, 0.3), (9.8, 10.0, 10.0), (1.2, 1.0, 1.5)]
        {
            assert_eq!((half_figures(value, f64::round), half_figures(value, f64::ceil)), (nearest, next), "{value}");
        }
        assert_eq!(clean(0.1 + 0.2), 0.3);
        assert_eq!(clean(-1e-13 * 0.0), 0.0);
    }
}
