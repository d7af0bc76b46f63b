//! The title in a link: letters and digits as they are, `_` for a space, an escape for everything else.
//!
//! `-` and two base-62 digits are a character below U+0F04 (Latin, Greek, Cyrillic and more), `--` and four are any other.
//! A lone `-` is the empty title.

use super::number::{base_62, from_base_62};

/// What an empty title is written as.
const EMPTY: &str = "-";

/// Characters below this take the short escape: 62².
const SHORT: u32 = 62 * 62;

pub(super) fn write(text: &mut String, title: &str) {
    if title.is_empty() {
        text.push_str(EMPTY);
    }
    for c in title.chars() {
        match c {
            ' ' => text.push('_'),
            c if c.is_ascii_alphanumeric() => text.push(c),
            c if u32::from(c) < SHORT => {
                text.push('-');
                text.push_str(&base_62(c.into(), 2));
            }
            c => {
                text.push_str("--");
                text.push_str(&base_62(c.into(), 4));
            }
        }
    }
}

/// The title that a text stands for; none when an escape is cut short or means no character.
pub(super) fn read(text: &str) -> Option<String> {
    if text == EMPTY {
        return Some(String::new());
    }
    let mut title = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        let escaped = match c {
            '-' => {
                let (digits, after) = match rest.strip_prefix('-') {
                    Some(long) => long.split_at_checked(4)?,
                    None => rest.split_at_checked(2)?,
                };
                rest = after;
                char::from_u32(from_base_62(digits)?)?
            }
            '_' => ' ',
            c => c,
        };
        title.push(escaped);
    }
    Some(title)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(title: &str) -> String {
        let mut text = String::new();
        write(&mut text, title);
        text
    }

    #[test]
    fn plain_titles_stay_readable() {
        assert_eq!(written("Example 9RT"), "Example_9RT");
        assert_eq!(written(""), "-");
        assert_eq!(written("Leva nº 3"), "Leva_n-30_3");
    }

    #[test]
    fn broken_escapes_are_no_title() {
        for text in ["a-", "a-1", "--", "--123", "-.."] {
            assert_eq!(read(text), None, "{text}");
        }
    }

    proptest::proptest! {
        #[test]
        fn every_title_reads_back(title in "\\PC{0,64}") {
            let text = written(&title);
            proptest::prop_assert!(text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_'));
            proptest::prop_assert_eq!(read(&text), Some(title));
        }
    }
}
