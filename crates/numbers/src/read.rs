//! What is typed into a field, read as a number in the unit of the field.

use crate::calculation::calculation;
use crate::unit::Unit;

/// What is wrong with a text that should be a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NumberProblem {
    /// There is nothing.
    Empty,
    /// It has more than one decimal sign: `1.234,5`.
    TwoSigns,
    /// Its exponent is missing: `1.5e`.
    Exponent,
    /// It is too large for any field.
    Huge,
    /// It divides by zero.
    DivisionByZero,
    /// It may be read in two ways: `1 500/2`.
    Ambiguous,
    /// It is no number.
    Unreadable,
    /// No unit is known by the text that follows the number.
    UnknownUnit {
        /// The text.
        found: String,
    },
    /// The unit measures something else than the field.
    OtherUnit {
        /// The unit that was given.
        found: String,
        /// A unit that the field takes; empty for a plain number.
        expected: String,
    },
}

/// Reads a number with a decimal comma or point, as digits or as a calculation (`22/7`, `2*pi`, `1 1/4`), with or without a unit, and gives it
/// in the unit `own` of its field: `250 mm` is 0.25 where the field is in metres. Without a unit the number is one of `own`.
///
/// # Errors
/// Returns an error if the text is no number, or if its unit does not measure what `own` measures.
pub fn read(text: &str, own: &str) -> Result<f64, NumberProblem> {
    let text = text.trim();
    if text.is_empty() || text == own {
        return Err(NumberProblem::Empty);
    }
    let (value, unit) = calculation(text)?;
    let value = if unit.is_empty() || unit == own { value } else { value * factor(unit, own)? };
    // Adding 0 makes 0 of −0.
    if value.is_finite() { Ok(value + 0.0) } else { Err(NumberProblem::Huge) }
}

/// How many of the unit `own` one `found` is.
fn factor(found: &str, own: &str) -> Result<f64, NumberProblem> {
    // A text that does not begin as a unit does is not taken for one.
    let begins = found.starts_with(|c: char| c.is_alphabetic() || "°º\"″1/·".contains(c));
    if !begins || found.chars().count() > MAX_UNIT {
        return Err(NumberProblem::Unreadable);
    }
    let Some(unit) = Unit::read(found) else {
        return Err(NumberProblem::UnknownUnit { found: found.to_owned() });
    };
    match Unit::read(own) {
        Some(field) if field.dimension == unit.dimension => Ok(ratio(unit.factor, field.factor)),
        _ => Err(NumberProblem::OtherUnit { found: found.to_owned(), expected: own.to_owned() }),
    }
}

/// Maximum length of a unit, characters.
const MAX_UNIT: usize = 12;

/// A quotient that is a whole number, or one over a whole number, but for rounding, is that number: 250 mm are 0.25 m and not 0.25000000000000006 m.
fn ratio(one: f64, other: f64) -> f64 {
    const ROUNDING: f64 = 1e-14;
    let quotient = one / other;
    let whole = |value: f64| ((value - value.round()).abs() <= ROUNDING * value).then_some(value.round());
    whole(quotient).or_else(|| whole(1.0 / quotient).map(|inverse| 1.0 / inverse)).unwrap_or(quotient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::write::{DecimalSign, editable};
    use proptest::prelude::*;

    #[test]
    fn comma_point_spaces_and_minus_signs_are_understood() {
        for (text, value) in [
            ("1,5", 1.5),
            ("1.5", 1.5),
            ("-3", -3.0),
            ("−3", -3.0),
            ("+2", 2.0),
            (" 12 ", 12.0),
            ("1,5e3", 1500.0),
            ("2E-3", 0.002),
            (".5", 0.5),
            ("5,", 5.0),
            ("48 185,28", 48_185.28),
            ("48\u{202f}185.28", 48_185.28),
            ("1 000 000", 1e6),
            ("1'000", 1000.0),
            ("- 3", -3.0),
        ] {
            assert_eq!(read(text, "mm"), Ok(value), "{text}");
        }
    }

    #[test]
    fn a_calculation_is_a_number() {
        use std::f64::consts::PI;
        for (text, value) in [
            ("22/7", 22.0 / 7.0),
            ("2*pi", 2.0 * PI),
            ("2π", 2.0 * PI),
            ("2 pi", 2.0 * PI),
            ("π/3", PI / 3.0),
            ("3^2", 9.0),
            ("3²", 9.0),
            ("2^-1", 0.5),
            ("-2^2", -4.0),
            ("2^3^2", 512.0),
            ("(1+2)*3", 9.0),
            ("1 1/4", 1.25),
            ("-1 1/2", -1.5),
            ("1 1/2 + 1/4", 1.75),
            ("360/7", 360.0 / 7.0),
            ("1,5·2", 3.0),
            ("3 × 4", 12.0),
            ("10 : 4", 2.5),
            ("2*-3", -6.0),
            ("1/2/2", 0.25),
        ] {
            assert_eq!(read(text, ""), Ok(value), "{text}");
        }
    }

    #[test]
    fn a_unit_of_the_kind_of_the_field_is_converted_into_the_unit_of_the_field() {
        use std::f64::consts::PI;
        for (text, own, value) in [
            ("35 mm", "mm", 35.0),
            ("250 mm", "m", 0.25),
            ("250mm", "m", 0.25),
            ("1 1/4 in", "mm", 31.75),
            ("1 1/4\"", "in", 1.25),
            ("30°", "°", 30.0),
            ("30", "°", 30.0),
            ("pi/6 rad", "°", 30.0),
            ("0.5 rev", "°", 180.0),
            ("390 rpm", "rad/s", 13.0 * PI),
            ("2 rev/s", "rpm", 120.0),
            ("2 r/min", "rpm", 2.0),
            ("1 in/s", "mm/s", 25.4),
            ("12,73 mm/rad", "mm/rad", 12.73),
            ("1 m/rad2", "mm/rad²", 1000.0),
            ("1 kN", "N", 1000.0),
            ("2 N/mm", "N/m", 2000.0),
            ("0.1 1/mm", "1/mm", 0.1),
        ] {
            let found = read(text, own).expect(text);
            assert!((found - value).abs() <= 1e-14 * value.abs(), "{text}: {found}");
        }
        assert_eq!(read("250 mm", "m"), Ok(0.25));
        assert_eq!(read("6 in", "cm"), Ok(6.0 * 2.54));
    }

    #[test]
    fn a_unit_of_another_kind_is_refused_by_name() {
        let other = |found: &str, expected: &str| {
            Err(NumberProblem::OtherUnit { found: found.to_owned(), expected: expected.to_owned() })
        };
        assert_eq!(read("30 °", "mm"), other("°", "mm"));
        assert_eq!(read("30 mm", "°"), other("mm", "°"));
        assert_eq!(read("30 mm", ""), other("mm", ""));
        assert_eq!(read("5 Hz", "rpm"), Err(NumberProblem::UnknownUnit { found: "Hz".to_owned() }));
    }

    #[test]
    fn what_is_not_a_number_says_why() {
        use NumberProblem::{Ambiguous, DivisionByZero, Empty, Exponent, Huge, TwoSigns, Unreadable};
        for (text, problem) in [
            ("", Empty),
            ("   ", Empty),
            ("mm", Empty),
            ("1.234,5", TwoSigns),
            ("1,2,3", TwoSigns),
            ("1.234.567", TwoSigns),
            ("1,5e", Exponent),
            ("1e-", Exponent),
            ("1e999", Huge),
            ("9^9^9", Huge),
            ("1/0", DivisionByZero),
            ("1 500/2", Ambiguous),
            ("1 5/4", Ambiguous),
            ("abc", Unreadable),
            ("-", Unreadable),
            ("12 3", Unreadable),
            ("1/", Unreadable),
            ("(1", Unreadable),
            ("1)", Unreadable),
            ("1 - ", Unreadable),
            ("--", Unreadable),
            ("NaN", Unreadable),
            ("Infinity", Unreadable),
            ("<b>1</b>", Unreadable),
            ("1; 2", Unreadable),
        ] {
            assert_eq!(read(text, "mm"), Err(problem), "{text}");
        }
    }

    #[test]
    fn deep_brackets_and_endless_signs_are_refused_at_once() {
        assert_eq!(read(&"(".repeat(100_000), "mm"), Err(NumberProblem::Unreadable));
        assert_eq!(read(&"-".repeat(100_000), "mm"), Err(NumberProblem::Unreadable));
    }

    proptest! {
        #[test]
        fn a_field_gives_back_exactly_the_number_it_shows(value in proptest::num::f64::NORMAL | proptest::num::f64::ZERO) {
            for sign in [DecimalSign::Point, DecimalSign::Comma] {
                prop_assert_eq!(read(&editable(value, sign), "mm"), Ok(value));
            }
        }

        #[test]
        fn no_text_stops_the_reader(text in "[0-9.,eE+*/^()πpi° mrads'−-]{0,24}|\\PC{0,16}") {
            if let Ok(value) = read(&text, "mm") {
                prop_assert!(value.is_finite());
            }
        }
    }
}
