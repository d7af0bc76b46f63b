//! Numbers as they are set: U+2212 for minus, thin spaces in long ones, the language's decimal sign.

/// Digits before the decimal sign from which they are set in groups of three.
const GROUPED: usize = 5;

/// Digits of a value beside the curve.
const SIGNIFICANT: i32 = 4;

/// How numbers are set in a language.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numerals {
    pub decimal_comma: bool,
}

impl Numerals {
    /// A number with so many decimals.
    pub fn fixed(self, value: f64, decimals: usize) -> String {
        let digits = format!("{:.decimals$}", value.abs());
        let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
        let mut text = String::with_capacity(digits.len() + 8);
        if value < 0.0 && digits.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
            text.push('\u{2212}');
        }
        for (i, digit) in whole.chars().enumerate() {
            if i > 0 && whole.len() >= GROUPED && (whole.len() - i).is_multiple_of(3) {
                text.push('\u{2009}');
            }
            text.push(digit);
        }
        if !fraction.is_empty() {
            text.push(if self.decimal_comma { ',' } else { '.' });
            text.push_str(fraction);
        }
        text
    }

    /// A number with four significant digits, zeros at the end left out.
    pub fn significant(self, value: f64) -> String {
        let magnitude = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
        let decimals = (SIGNIFICANT - 1 - magnitude).max(0) as usize;
        let mut text = self.fixed(value, decimals);
        if decimals > 0 {
            let kept = text.trim_end_matches('0').trim_end_matches(['.', ',']).len();
            text.truncate(kept);
        }
        text
    }
}

/// ×10ⁿ.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let sign = if exponent < 0 { "⁻" } else { "" };
    let digits = exponent.unsigned_abs().to_string();
    let raised: String = digits.bytes().map(|digit| RAISED[usize::from(digit - b'0')]).collect();
    format!("×10{sign}{raised}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_set_as_in_print() {
        let (point, comma) = (Numerals { decimal_comma: false }, Numerals { decimal_comma: true });
        assert_eq!(point.fixed(-0.5, 1), "\u{2212}0.5");
        assert_eq!(comma.fixed(1234.5, 1), "1234,5");
        assert_eq!(point.fixed(-48185.0, 0), "\u{2212}48\u{2009}185");
        assert_eq!(point.fixed(-0.04, 1), "0.0", "no minus before zero");
        assert_eq!(point.significant(10.0), "10");
        assert_eq!(comma.significant(-0.188_314), "\u{2212}0,1883");
        assert_eq!(point.significant(48185.28), "48\u{2009}185");
        assert_eq!(point.significant(1000.0), "1000");
        assert_eq!(point.significant(0.0), "0");
        assert_eq!(power_of_ten(6), "×10⁶");
        assert_eq!(power_of_ten(-12), "×10⁻¹²");
    }
}
