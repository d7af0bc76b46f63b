//! Numbers in a link: the shortest decimal digits that read back exactly, in the shorter of two forms.

use super::base_62::{DIGITS, value_of};

/// Writes a number that is not negative: `35`, `.05`, `12.5`, or with a power of ten where that is shorter: `12e6`, `5e-9`.
///
/// The digits are the fewest that read back as the same `f64` (as Rust's `{:e}` gives them).
pub(super) fn write(text: &mut String, value: f64) {
    let shortest = format!("{value:e}");
    let (mantissa, exponent) = shortest.split_once('e').unwrap_or((&shortest, "0"));
    let digits = mantissa.replace('.', "");
    let power = exponent.parse::<i32>().unwrap_or(0) - (digits.len() as i32 - 1);
    let plain = plain(&digits, power);
    let scientific = format!("{digits}e{power}");
    text.push_str(if scientific.len() < plain.len() { &scientific } else { &plain });
}

/// digits·10^power without an exponent.
fn plain(digits: &str, power: i32) -> String {
    let (places, length) = (power.unsigned_abs() as usize, digits.len());
    if power >= 0 {
        digits.to_owned() + &"0".repeat(places)
    } else if places < length {
        let (whole, fraction) = digits.split_at(length - places);
        format!("{whole}.{fraction}")
    } else {
        format!(".{}{digits}", "0".repeat(places - length))
    }
}

/// A number in base 62 (0–9, A–Z, a–z), in so many digits.
pub(super) fn base_62(mut value: u32, length: usize) -> String {
    let mut digits = vec!['0'; length];
    for digit in digits.iter_mut().rev() {
        *digit = char::from(DIGITS[(value % 62) as usize]);
        value /= 62;
    }
    digits.into_iter().collect()
}

/// The number that base-62 digits stand for; none when one of them is not a digit, or there are too many.
pub(super) fn from_base_62(digits: &str) -> Option<u32> {
    digits.chars().try_fold(0_u32, |value, digit| value.checked_mul(62)?.checked_add(value_of(digit)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(value: f64) -> String {
        let mut text = String::new();
        write(&mut text, value);
        text
    }

    #[test]
    fn numbers_take_their_shortest_form() {
        for (value, expected) in [
            (0.0, "0"),
            (35.0, "35"),
            (12.5, "12.5"),
            (0.05, ".05"),
            (0.005, ".005"),
            (0.0005, "5e-4"),
            (100.0, "100"),
            (1e6, "1e6"),
            (1_200_000.0, "12e5"),
            (33.333333333333336, "33.333333333333336"),
            (1.0 / 3.0, ".3333333333333333"),
        ] {
            assert_eq!(written(value), expected);
        }
    }

    #[test]
    fn base_62_reads_back() {
        for value in [0, 1, 61, 62, 3843, 0x0010_ffff, u32::MAX] {
            assert_eq!(from_base_62(&base_62(value, 6)), Some(value));
        }
        assert_eq!(from_base_62("zzzzzz"), None, "beyond 32 bits");
        assert_eq!(from_base_62("a.b"), None);
    }

    proptest::proptest! {
        #[test]
        fn every_number_reads_back_exactly(bits in proptest::num::u64::ANY) {
            let value = f64::from_bits(bits).abs();
            if value.is_finite() {
                proptest::prop_assert_eq!(written(value).parse::<f64>(), Ok(value));
            }
        }
    }
}
