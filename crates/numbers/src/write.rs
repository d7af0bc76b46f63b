//! Numbers in print: decimal point or comma, a thin space between thousands, a true minus sign, powers of ten where they are needed.

/// The decimal sign of a language.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DecimalSign {
    /// 1.5
    #[default]
    Point,
    /// 1,5
    Comma,
}

/// Groups of three digits are parted by a narrow no-break space (ISO 80000-1), from five whole digits on.
const GROUP: char = '\u{202f}';
const MAX_UNGROUPED: usize = 4;

const MINUS: char = '−';

/// What stands for a value that is not there.
const NOTHING: &str = "–";

/// Numbers of these powers of ten are written without one.
const PLAIN: std::ops::Range<i32> = -4..7;

/// Significant digits of a measured quantity.
const MEASURED: usize = 4;

/// Significant digits of an exact number: beyond them lies the rounding of a sum.
const EXACT: usize = 12;

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

impl DecimalSign {
    fn char(self) -> char {
        match self {
            Self::Point => '.',
            Self::Comma => ',',
        }
    }
}

/// A measured quantity: four significant digits, whole digits never rounded away, no zeros at the end.
#[must_use]
pub fn measured(value: f64, sign: DecimalSign) -> String {
    significant(value, MEASURED, sign)
}

/// A measured quantity with all of its four digits, zeros at the end included, so that its width does not change from value to value.
#[must_use]
pub fn measured_whole(value: f64, sign: DecimalSign) -> String {
    written(value, MEASURED, sign, Zeros::Kept)
}

/// An exact number: as many digits as it takes, twelve at most.
#[must_use]
pub fn exact(value: f64, sign: DecimalSign) -> String {
    significant(value, EXACT, sign)
}

/// A number with so many significant digits at most, no zeros at the end. Whole digits are never rounded away: of 48 185.28 with four digits
/// 48 185 is left. Numbers below 10⁻⁴ and from 10⁷ on are written with a power of ten.
#[must_use]
pub fn significant(value: f64, digits: usize, sign: DecimalSign) -> String {
    written(value, digits, sign, Zeros::Dropped)
}

/// A number with so many decimals exactly.
#[must_use]
pub fn fixed(value: f64, decimals: usize, sign: DecimalSign) -> String {
    signed(value, |size| grouped(&format!("{size:.decimals$}"), sign))
}

/// A number with so many decimals at most, no zeros at the end.
#[must_use]
pub fn rounded(value: f64, decimals: usize, sign: DecimalSign) -> String {
    signed(value, |size| grouped(without_zeros(&format!("{size:.decimals$}")), sign))
}

/// A number compared with a limit: with one decimal, or as many as it takes to tell the two apart.
#[must_use]
pub fn compared(value: f64, limit: f64, sign: DecimalSign) -> String {
    const MAX_DECIMALS: usize = 6;
    let differs = |&decimals: &usize| rounded(value, decimals, sign) != rounded(limit, decimals, sign);
    rounded(value, (1..MAX_DECIMALS).find(differs).unwrap_or(MAX_DECIMALS), sign)
}

/// A number in a field that is being edited: every digit that makes it the number it is, no groups. [`read`](crate::read) gives it back.
#[must_use]
pub fn editable(value: f64, sign: DecimalSign) -> String {
    /// Powers of ten beyond which the zeros would be too many to read.
    const PLAIN_TO_EDIT: std::ops::Range<i32> = -6..21;
    signed(value, |size| {
        let (digits, exponent) = decimal_digits(&format!("{size:e}"));
        let text = if PLAIN_TO_EDIT.contains(&exponent) {
            without_zeros(&pointed(&digits, exponent)).to_owned()
        } else {
            let mantissa = pointed(&digits, 0);
            let power = if exponent < 0 { format!("-{}", -exponent) } else { format!("+{exponent}") };
            format!("{}e{power}", without_zeros(&mantissa))
        };
        text.replace('.', &sign.char().to_string())
    })
}

/// What stands for the digits of a number that are cut off.
pub const CUT: char = '…';

/// A number in a field that nobody edits, which has room for so many characters. A number with more digits is cut, and shows it by
/// [`CUT`]: rounded, the angles of a program would seem to add up to more than a turn.
#[must_use]
pub fn at_rest(value: f64, room: usize, sign: DecimalSign) -> String {
    /// Digits that a number keeps, whatever the room.
    const MIN_DIGITS: usize = 3;
    /// Characters that take the width of the sign of the cut.
    const CUT_WIDTH: usize = 2;
    let whole = editable(to_digits(value, EXACT), sign);
    let (mantissa, power) = whole.split_at(whole.find('e').unwrap_or(whole.len()));
    let mantissa: Vec<char> = mantissa.chars().collect();
    let Some(point) = mantissa.iter().position(|&c| c == sign.char()) else { return whole };
    if mantissa.len() + power.len() <= room {
        return whole;
    }
    let counts =
        |text: &[char]| text.iter().skip_while(|c| !matches!(c, '1'..='9')).filter(|c| c.is_ascii_digit()).count();
    let least = (0..=mantissa.len()).find(|&end| counts(&mantissa[..end]) >= MIN_DIGITS).unwrap_or(mantissa.len());
    let kept = least.max(point + 1).max(room.saturating_sub(CUT_WIDTH + power.len()));
    if kept + 1 >= mantissa.len() {
        return whole;
    }
    mantissa[..kept].iter().chain(&[CUT]).collect::<String>() + power
}

/// A number in the notation of formulas, with so many significant digits at most: `-12345`, `4.3·10^-6`, `∞`.
#[must_use]
pub fn in_formula(value: f64, digits: usize) -> String {
    let mut text = String::new();
    let (mut exponent, mut raised) = (String::new(), false);
    for c in significant(value, digits, DecimalSign::Point).chars() {
        match c {
            GROUP => {}
            '⁻' => exponent.push('-'),
            c if RAISED.contains(&c) => {
                raised = true;
                exponent.extend(RAISED.iter().zip('0'..='9').find(|(known, _)| **known == c).map(|(_, digit)| digit));
            }
            MINUS => text.push('-'),
            c => text.push(c),
        }
    }
    if raised { format!("{text}^{exponent}") } else { text }
}

/// 10ⁿ in print.
#[must_use]
pub fn power_of_ten(exponent: i32) -> String {
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    let exponent: String = exponent.to_string().chars().map(raised).collect();
    format!("10{exponent}")
}

#[derive(Clone, Copy, PartialEq)]
enum Zeros {
    Kept,
    Dropped,
}

fn written(value: f64, digits: usize, sign: DecimalSign, zeros: Zeros) -> String {
    signed(value, |size| {
        if size == 0.0 {
            return "0".to_owned();
        }
        // The exponent is that of the rounded number, so that 9 999 999.9 is written as the power of ten that it rounds to.
        let (rounded, exponent) = decimal_digits(&format!("{size:.*e}", digits.max(1) - 1));
        let keep = |text: &str| if zeros == Zeros::Kept { text.to_owned() } else { without_zeros(text).to_owned() };
        if !PLAIN.contains(&exponent) {
            let mantissa = without_zeros(&pointed(&rounded, 0)).replace('.', &sign.char().to_string());
            return format!("{mantissa}·{}", power_of_ten(exponent));
        }
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        grouped(&keep(&format!("{size:.decimals$}")), sign)
    })
}

/// A number rounded to so many significant digits.
fn to_digits(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}

/// Digits without a point, and the power of ten of the first one, of a number in the form `1.25e-3`.
fn decimal_digits(scientific: &str) -> (String, i32) {
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((scientific, "0"));
    (mantissa.replace('.', ""), exponent.parse().unwrap_or(0))
}

/// Digits with the point after the one that counts 10^exponent.
fn pointed(digits: &str, exponent: i32) -> String {
    let zeros = |count: i32| "0".repeat(count.max(0) as usize);
    let digits = format!("{}{digits}{}", zeros(-exponent), zeros(exponent + 1 - digits.len() as i32));
    let (whole, fraction) = digits.split_at(exponent.max(0) as usize + 1);
    format!("{whole}.{fraction}")
}

/// Digits with a point, without zeros at the end.
fn without_zeros(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

/// Digits with a point, in groups of three, with the decimal sign of the language.
fn grouped(digits: &str, sign: DecimalSign) -> String {
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mut text = String::with_capacity(digits.len() + 8);
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && whole.len() > MAX_UNGROUPED && (whole.len() - i).is_multiple_of(3) {
            text.push(GROUP);
        }
        text.push(digit);
    }
    if !fraction.is_empty() {
        text.push(sign.char());
        text.push_str(fraction);
    }
    text
}

/// A number by its sign and the text of its size; no minus before what is written as zero.
fn signed(value: f64, write: impl Fn(f64) -> String) -> String {
    if value.is_nan() {
        return NOTHING.to_owned();
    }
    let text = if value.is_infinite() { "∞".to_owned() } else { write(value.abs()) };
    let zero = text.chars().all(|c| !matches!(c, '1'..='9' | '∞'));
    if value < 0.0 && !zero { format!("{MINUS}{text}") } else { text }
}

#[cfg(test)]
mod tests {
    use super::DecimalSign::{Comma, Point};
    use super::*;

    #[test]
    fn a_quantity_keeps_four_digits_and_all_whole_ones() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (33.2, "33.2"),
            (43.298, "43.3"),
            (-1.25, "−1.25"),
            (1234.5, "1234"),
            (48_185.28, "48\u{202f}185"),
            (0.001, "0.001"),
            (0.000_012_34, "1.234·10⁻⁵"),
            (9_999_999.9, "1·10⁷"),
            (f64::NEG_INFINITY, "−∞"),
            (f64::NAN, "–"),
        ] {
            assert_eq!(measured(value, Point), expected);
        }
        assert_eq!(measured_whole(10.0, Point), "10.00");
        assert_eq!(measured_whole(9.999_99, Point), "10.00");
        assert_eq!(measured_whole(0.001_234_56, Comma), "0,001235");
        assert_eq!(exact(360.000_000_002, Comma), "360,000000002");
        assert_eq!(exact(0.1 + 0.2, Comma), "0,3");
        assert_eq!(exact(-48_185.28, Comma), "−48\u{202f}185,28");
    }

    #[test]
    fn decimals_are_kept_or_dropped() {
        assert_eq!(fixed(3.0, 2, Point), "3.00");
        assert_eq!(fixed(-28.18, 1, Comma), "−28,2");
        assert_eq!(fixed(-0.01, 1, Point), "0.0");
        assert_eq!(rounded(58.04, 1, Point), "58");
        assert_eq!(rounded(-30.37, 1, Comma), "−30,4");
        assert_eq!(rounded(-0.01, 1, Point), "0");
    }

    #[test]
    fn a_value_is_told_apart_from_its_limit() {
        assert_eq!(compared(33.2, 30.0, Point), "33.2");
        assert_eq!(compared(30.02, 30.0, Point), "30.02");
        assert_eq!(compared(30.0, 30.0, Point), "30");
    }

    #[test]
    fn a_field_at_rest_shows_that_there_is_more_of_a_number() {
        assert_eq!(at_rest(256.32, 6, Comma), "256,32");
        assert_eq!(at_rest(0.1 + 0.2, 6, Point), "0.3");
        // Rounded, seven of them would add up to more than a turn.
        assert_eq!(at_rest(360.0 / 7.0, 6, Comma), "51,4…");
        assert_eq!(at_rest(359.999_999, 6, Point), "359.…");
        assert_eq!(at_rest(-1.377_952_755_905, 7, Point), "−1.37…");
        assert_eq!(at_rest(0.000_123_456_789, 7, Point), "0.000123…");
        assert_eq!(at_rest(1.234_567_89e-9, 7, Point), "1.23…e-9");
        assert_eq!(at_rest(123_456_789.0, 6, Point), "123456789");
    }

    #[test]
    fn a_number_to_edit_has_all_its_digits() {
        assert_eq!(editable(0.1 + 0.2, Point), "0.30000000000000004");
        assert_eq!(editable(-2.5e21, Comma), "−2,5e+21");
        assert_eq!(editable(1e-9, Point), "1e-9");
        assert_eq!(editable(48_185.28, Comma), "48185,28");
        assert_eq!(editable(100.0, Point), "100");
    }

    #[test]
    fn formulas_have_a_notation_of_their_own() {
        for (value, expected) in [
            (-12_345.0, "-12345"),
            (0.000_012_34, "1.234·10^-5"),
            (-3e9, "-3·10^9"),
            (f64::INFINITY, "∞"),
            (0.25, "0.25"),
        ] {
            assert_eq!(in_formula(value, 4), expected);
        }
        assert_eq!(power_of_ten(-12), "10⁻¹²");
    }
}
