//! Bytes in base 62, the letters and digits: 29 bytes are a number of 39 digits, with hardly a bit to spare.

/// Letters and digits in the order of their values.
pub(super) const DIGITS: &[u8; 62] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

/// Bytes of a whole block.
const BLOCK: usize = 29;

/// Digits that a block of so many bytes takes: the fewest that tell all such blocks apart.
const DIGITS_OF: [usize; BLOCK + 1] =
    [0, 2, 3, 5, 6, 7, 9, 10, 11, 13, 14, 15, 17, 18, 19, 21, 22, 23, 25, 26, 27, 29, 30, 31, 33, 34, 35, 37, 38, 39];

/// The value of a letter or digit.
pub(super) fn value_of(digit: char) -> Option<u32> {
    match digit {
        '0'..='9' => Some(digit as u32 - '0' as u32),
        'A'..='Z' => Some(digit as u32 - 'A' as u32 + 10),
        'a'..='z' => Some(digit as u32 - 'a' as u32 + 36),
        _ => None,
    }
}

/// The bytes as text: block after block, the most significant first.
pub(super) fn to_base_62(bytes: &[u8]) -> String {
    let mut text = String::new();
    for block in bytes.chunks(BLOCK) {
        let mut number = block.to_vec();
        let mut digits = vec![0; DIGITS_OF[block.len()]];
        for digit in digits.iter_mut().rev() {
            let mut rest = 0_u32;
            for byte in &mut number {
                rest = rest * 256 + u32::from(*byte);
                *byte = (rest / 62) as u8;
                rest %= 62;
            }
            *digit = DIGITS[rest as usize];
        }
        text.extend(digits.into_iter().map(char::from));
    }
    text
}

/// The bytes that a text stands for; `None` for any text that [`to_base_62`] does not write.
pub(super) fn from_base_62(text: &str) -> Option<Vec<u8>> {
    let values: Vec<u32> = text.chars().map(value_of).collect::<Option<_>>()?;
    let mut bytes = Vec::with_capacity(values.len());
    for digits in values.chunks(DIGITS_OF[BLOCK]) {
        let length = DIGITS_OF.iter().position(|&count| count == digits.len())?;
        let mut block = vec![0_u8; length];
        for &digit in digits {
            let mut carry = digit;
            for byte in block.iter_mut().rev() {
                carry += u32::from(*byte) * 62;
                *byte = carry as u8;
                carry >>= 8;
            }
            if carry > 0 {
                return None;
            }
        }
        bytes.extend(block);
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_take_the_fewest_digits_that_tell_them_apart() {
        for (bytes, &digits) in DIGITS_OF.iter().enumerate() {
            let bits = 8.0 * bytes as f64;
            assert_eq!(digits, (bits / 62_f64.log2()).ceil() as usize, "{bytes} bytes");
        }
    }

    #[test]
    fn what_is_not_written_is_not_read() {
        for text in ["1", "zz", "000a", "a.b", "a_", "zzz", &"z".repeat(39)] {
            assert_eq!(from_base_62(text), None, "{text}");
        }
        assert_eq!(from_base_62(""), Some(Vec::new()));
        assert_eq!(from_base_62("00"), Some(vec![0]));
        assert_eq!(from_base_62("47"), Some(vec![255]));
        assert_eq!(from_base_62("48"), None, "256 is no byte");
    }

    proptest::proptest! {
        #[test]
        fn bytes_come_back(bytes in proptest::collection::vec(proptest::num::u8::ANY, 0..200)) {
            let text = to_base_62(&bytes);
            proptest::prop_assert!(text.bytes().all(|byte| byte.is_ascii_alphanumeric()));
            proptest::prop_assert_eq!(from_base_62(&text), Some(bytes));
        }
    }
}
