//! Titles and formulas in a link: letters and digits as they are, an escape for everything else.
//!
//! `-` and two base-62 digits are a character below U+0F04 (Latin, Greek, Cyrillic and more), `--` and four are any other.
//! A lone `-` is the empty title. A space is `_` in version 1, which Markdown drops; in version 2 it is `-s`, and `+` is `-p`: there a
//! character whose two digits would begin with `s` or `p` takes four.

use super::number::{base_62, from_base_62};
use crate::Version;

/// What an empty title is written as.
const EMPTY: &str = "-";

/// Characters below this take the short escape: 62².
const SHORT: u32 = 62 * 62;

/// The characters of version 2 that have an escape of their own, a letter behind `-`.
const NAMED: [(char, char); 2] = [(' ', 's'), ('+', 'p')];

pub(super) fn write(text: &mut String, title: &str, version: Version) {
    if title.is_empty() {
        text.push_str(EMPTY);
    }
    for c in title.chars() {
        match named(c, version) {
            _ if c.is_ascii_alphanumeric() => text.push(c),
            _ if c == ' ' && version == Version::One => text.push('_'),
            Some(letter) => text.extend(['-', letter]),
            None => {
                let short =
                    Some(base_62(c.into(), 2)).filter(|digits| u32::from(c) < SHORT && !is_named(digits, version));
                match short {
                    Some(digits) => text.extend(["-", digits.as_str()]),
                    None => text.extend(["--", base_62(c.into(), 4).as_str()]),
                }
            }
        }
    }
}

/// The title that a text stands for; none when an escape is cut short or means no character.
pub(super) fn read(text: &str, version: Version) -> Option<String> {
    if text == EMPTY {
        return Some(String::new());
    }
    let mut title = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        let escaped = match c {
            '-' if is_named(rest, version) => {
                let letter = rest.chars().next()?;
                rest = &rest[letter.len_utf8()..];
                NAMED.iter().find(|entry| entry.1 == letter)?.0
            }
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

/// The letter of a character that has an escape of its own.
fn named(c: char, version: Version) -> Option<char> {
    NAMED.iter().find(|entry| version > Version::One && entry.0 == c).map(|entry| entry.1)
}

/// True for what begins, behind its `-`, as an escape with a letter of its own.
fn is_named(escape: &str, version: Version) -> bool {
    version > Version::One && NAMED.iter().any(|entry| escape.starts_with(entry.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(title: &str, version: Version) -> String {
        let mut text = String::new();
        write(&mut text, title, version);
        text
    }

    #[test]
    fn plain_titles_stay_readable() {
        for (title, first, second) in [
            ("Example 9RT", "Example_9RT", "Example-s9RT"),
            ("", "-", "-"),
            ("Leva nº 3", "Leva_n-30_3", "Leva-sn-30-s3"),
            ("a+b", "a-0hb", "a-pb"),
            // Their two digits would be s0 and p0.
            ("\u{d14}\u{c5a}", "-s0-p0", "--00s0--00p0"),
        ] {
            assert_eq!(
                Version::ALL.map(|version| written(title, version)),
                [first, second].map(str::to_owned),
                "{title}"
            );
        }
    }

    #[test]
    fn broken_escapes_are_no_title() {
        for text in ["a-", "a-1", "--", "--123", "-.."] {
            assert_eq!(Version::ALL.map(|version| read(text, version)), [None, None], "{text}");
        }
    }

    proptest::proptest! {
        #[test]
        fn every_title_reads_back(title in "\\PC{0,64}") {
            for version in Version::ALL {
                let text = written(&title, version);
                let space = |c| c == '_' && version == Version::One;
                proptest::prop_assert!(text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || space(c)));
                proptest::prop_assert_eq!(read(&text, version), Some(title.clone()));
            }
        }
    }
}
