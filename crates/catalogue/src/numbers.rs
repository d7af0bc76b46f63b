//! Numbers as people write them: decimal point or comma, thin spaces between thousands, a true minus sign.

/// Groups of three digits are parted by a narrow no-break space, from five whole digits on (ISO 80000-1).
const GROUP: char = '\u{202f}';

/// Whole digits that are still read at a glance.
const UNGROUPED: usize = 4;

const MINUS: char = '−';

/// Numbers from 10⁻⁴ to 10⁷ are written without a power of ten.
const PLAIN: std::ops::Range<i32> = -4..7;

/// A number with so many significant digits at most, and no zeros at the end.
pub fn significant(value: f64, digits: usize, sign: char) -> String {
    if value == 0.0 || !value.is_finite() {
        return fixed(value, 0, sign);
    }
    let scientific = format!("{:.*e}", digits - 1, value.abs());
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    // That of the rounded number, so that 9 999 999.9 is written as the power of ten that it rounds to.
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if PLAIN.contains(&exponent) {
        plain(&pointed(&mantissa.replace('.', ""), exponent), sign)
    } else {
        format!("{}·10{}", plain(mantissa, sign), superscript(exponent))
    };
    signed(value, text)
}

/// A number with so many significant digits at most in the notation of formulas: `-12340.5`, `4.3·10^-6`, `∞`.
#[must_use]
pub fn notation(value: f64, digits: usize) -> String {
    let mut text = String::new();
    let (mut exponent, mut raised) = (String::new(), false);
    for c in significant(value, digits, '.').chars() {
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

/// Digits with the point after the one that counts 10^exponent.
fn pointed(digits: &str, exponent: i32) -> String {
    let zeros = |count: i32| "0".repeat(count.max(0) as usize);
    let digits = format!("{}{digits}{}", zeros(-exponent), zeros(exponent + 1 - digits.len() as i32));
    let (whole, fraction) = digits.split_at(exponent.max(0) as usize + 1);
    format!("{whole}.{fraction}")
}

/// A number with so many decimals at most, and no zeros at the end.
pub fn fixed(value: f64, decimals: usize, sign: char) -> String {
    if value.is_nan() {
        return "–".to_owned();
    }
    let text = if value.is_infinite() { "∞".to_owned() } else { plain(&format!("{:.decimals$}", value.abs()), sign) };
    signed(value, text)
}

/// A number told beside a limit: with as many decimals, one or more, as it takes to tell them apart.
pub fn beside(value: f64, limit: f64, sign: char) -> String {
    const MOST: usize = 6;
    let decimals = (1..MOST).find(|&decimals| fixed(value, decimals, sign) != fixed(limit, decimals, sign));
    fixed(value, decimals.unwrap_or(MOST), sign)
}

fn signed(value: f64, text: String) -> String {
    let nothing = text.chars().all(|c| !matches!(c, '1'..='9' | '∞'));
    if value < 0.0 && !nothing { format!("{MINUS}{text}") } else { text }
}

/// Digits with a point, grouped, with the sign of the language and without zeros at the end.
fn plain(digits: &str, sign: char) -> String {
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let fraction = fraction.trim_end_matches('0');
    let mut text = String::new();
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && whole.len() > UNGROUPED && (whole.len() - i).is_multiple_of(3) {
            text.push(GROUP);
        }
        text.push(digit);
    }
    if !fraction.is_empty() {
        text.push(sign);
        text.push_str(fraction);
    }
    text
}

fn superscript(exponent: i32) -> String {
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    exponent.to_string().chars().map(raised).collect()
}

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_in_books() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (33.2, "33.2"),
            (43.298, "43.3"),
            (-1.25, "−1.25"),
            (1234.5, "1234"),
            (12_345.0, "12\u{202f}340"),
            (0.001, "0.001"),
            (0.000_012_34, "1.234·10⁻⁵"),
            (9_999_999.9, "1·10⁷"),
            (f64::NEG_INFINITY, "−∞"),
        ] {
            assert_eq!(significant(value, 4, '.'), expected);
        }
        assert_eq!(significant(360.000_000_002, 12, ','), "360,000000002");
        assert_eq!(significant(0.1 + 0.2, 12, ','), "0,3");
    }

    #[test]
    fn formulas_have_a_notation_of_their_own() {
        for (value, expected) in [
            (-12_345.0, "-12340"),
            (0.000_012_34, "1.234·10^-5"),
            (-3e9, "-3·10^9"),
            (f64::INFINITY, "∞"),
            (0.25, "0.25"),
        ] {
            assert_eq!(notation(value, 4), expected);
        }
    }

    #[test]
    fn angles_keep_one_decimal() {
        assert_eq!(fixed(58.04, 1, '.'), "58");
        assert_eq!(fixed(-30.37, 1, ','), "−30,4");
        assert_eq!(fixed(-0.01, 1, '.'), "0");
    }

    #[test]
    fn a_value_is_told_apart_from_its_limit() {
        assert_eq!(beside(33.2, 30.0, '.'), "33.2");
        assert_eq!(beside(30.02, 30.0, '.'), "30.02");
        assert_eq!(beside(30.0, 30.0, '.'), "30");
    }
}
