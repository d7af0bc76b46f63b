//! Decimal digits to the nearest `f64`, by long arithmetic.
//!
//! The standard library does it faster with tables, which are a twentieth of the page's module; a design has some forty numbers.

/// The `f64` nearest to `digits`·10^`power`, halves to even; infinite when it is beyond all of them.
pub fn nearest(digits: &str, power: i32) -> f64 {
    let digits = digits.trim_start_matches('0');
    if digits.is_empty() {
        return 0.0;
    }
    // Beyond every f64, or below half the least.
    let magnitude = i64::from(power) + digits.len() as i64;
    if magnitude > MAX_MAGNITUDE {
        return f64::INFINITY;
    }
    if magnitude < MIN_MAGNITUDE {
        return 0.0;
    }
    let mut value = Whole::default();
    for digit in digits.bytes() {
        value.multiply_add(10, u32::from(digit - b'0'));
    }
    let mut sticky = false;
    let mut exponent = 0;
    for _ in 0..power.max(0) {
        value.multiply_add(10, 0);
    }
    if power < 0 {
        // Room for all the bits of an f64 and the one that decides, whatever the division takes away (10 < 2⁴).
        let room = (4 * power.unsigned_abs() + MANTISSA_BITS + 2).saturating_sub(value.bits());
        value.shift_left(room);
        exponent = -(room as i32);
        for _ in 0..power.unsigned_abs() {
            sticky |= value.divide(10) != 0;
        }
    }
    // The last bit that counts, which of small numbers is the least there is.
    let last = (exponent + value.bits() as i32 - MANTISSA_BITS as i32).max(LEAST_EXPONENT);
    let mantissa = match last - exponent {
        dropped if dropped > 0 => value.rounded(dropped as u32, sticky),
        // All its bits fit, and nothing was divided away: else there would have been room for more.
        _ => value.low(),
    };
    let scale = if last > exponent { last } else { exponent };
    assemble(mantissa, scale)
}

/// Reads `12`, `.5`, `12.`, `12.5e-3`; nothing else.
pub fn parse(text: &str) -> Option<f64> {
    let (number, power) = match text.split_once('e') {
        Some((number, power)) => (number, power.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
    let digits = [whole, fraction].concat();
    if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    Some(nearest(&digits, power.checked_sub(i32::try_from(fraction.len()).ok()?)?))
}

/// 10³⁰⁹ is beyond every f64, 10⁻³²⁴ below half the least.
const MAX_MAGNITUDE: i64 = 309;
const MIN_MAGNITUDE: i64 = -323;

const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS;

/// The least f64 is 2 to this.
const LEAST_EXPONENT: i32 = f64::MIN_EXP - f64::MANTISSA_DIGITS as i32;

/// mantissa·2^exponent, which is exact.
fn assemble(mantissa: u64, exponent: i32) -> f64 {
    // In two steps, since 2^exponent alone may be too small for an f64.
    let half = exponent / 2;
    let power = |exponent: i32| f64::from_bits(((exponent + 1023) as u64) << (MANTISSA_BITS - 1));
    mantissa as f64 * power(half) * power(exponent - half)
}

/// A whole number of any size, the least 32 bits first.
#[derive(Default)]
struct Whole(Vec<u32>);

impl Whole {
    fn multiply_add(&mut self, factor: u32, more: u32) {
        let mut carry = u64::from(more);
        for part in &mut self.0 {
            let product = u64::from(*part) * u64::from(factor) + carry;
            *part = product as u32;
            carry = product >> 32;
        }
        if carry > 0 {
            self.0.push(carry as u32);
        }
    }

    /// Divides, and gives the rest.
    fn divide(&mut self, divisor: u32) -> u32 {
        let mut rest = 0_u64;
        for part in self.0.iter_mut().rev() {
            let value = rest << 32 | u64::from(*part);
            *part = (value / u64::from(divisor)) as u32;
            rest = value % u64::from(divisor);
        }
        rest as u32
    }

    fn shift_left(&mut self, bits: u32) {
        if !bits.is_multiple_of(32) {
            self.multiply_add(1 << (bits % 32), 0);
        }
        self.0.splice(0..0, vec![0; (bits / 32) as usize]);
    }

    fn bits(&self) -> u32 {
        self.0.iter().rposition(|&part| part != 0).map_or(0, |top| 32 * (top as u32 + 1) - self.0[top].leading_zeros())
    }

    fn bit(&self, place: u32) -> bool {
        self.0.get((place / 32) as usize).is_some_and(|part| part >> (place % 32) & 1 == 1)
    }

    fn low(&self) -> u64 {
        self.0.iter().take(2).rev().fold(0, |low, &part| low << 32 | u64::from(part))
    }

    /// Without the lowest bits, rounded to the nearest, halves to even; `sticky` when there was more below them.
    fn rounded(&self, dropped: u32, sticky: bool) -> u64 {
        let kept =
            (dropped..self.bits().max(dropped)).rev().fold(0, |kept, place| kept << 1 | u64::from(self.bit(place)));
        let half = self.bit(dropped - 1);
        let beyond = sticky || (0..dropped - 1).any(|place| self.bit(place));
        kept + u64::from(half && (beyond || kept & 1 == 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_of_a_design_are_read() {
        for text in ["0", "35", ".05", "12.5", "12.", "1e6", "5e-9", "33.333333333333336", "000.100", "1e22", "1e23"] {
            assert_eq!(parse(text), text.parse().ok(), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in ["", ".", "e5", "1e", "1e-", "+1", "-1", "1.2.3", "1e5.5", "inf", "NaN", "1e99999999999", " 1"] {
            assert_eq!(parse(text), None, "{text}");
        }
    }

    #[test]
    fn the_hardest_cases_are_rounded_right() {
        for text in [
            "9007199254740993",
            "9007199254740992.99999999999999999999",
            "9007199254740993.00000000000000000001",
            "2.2250738585072011e-308",
            "2.2250738585072014e-308",
            "5e-324",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "2.47032822920623272e-324",
            "1.7976931348623157e308",
            "1.7976931348623158e308",
            "1.7976931348623159e308",
            "1e309",
            "1e-400",
            "123456789012345678901234567890123456789012345678901234567890e-30",
        ] {
            assert_eq!(parse(text), text.parse().ok(), "{text}");
        }
    }

    proptest! {
        #[test]
        fn any_shortest_form_reads_back(bits in any::<u64>()) {
            let value = f64::from_bits(bits).abs();
            if value.is_finite() {
                prop_assert_eq!(parse(&format!("{value:e}")), Some(value));
            }
        }

        #[test]
        fn any_digits_read_as_the_standard_library_reads_them(digits in "[0-9]{1,25}", fraction in "[0-9]{0,25}", power in -360_i32..340) {
            let text = format!("{digits}.{fraction}e{power}");
            prop_assert_eq!(parse(&text), text.parse().ok());
        }
    }
}
