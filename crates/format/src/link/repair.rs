//! Opens a link from what people paste and click: a whole address, and one that was mangled on the way without losing anything.
//!
//! Programs that carry links escape characters with percent signs or backslashes, break lines, put angle brackets around and
//! sentences or parameters of their own behind. Such marks are no part of any link, so they are removed; the result counts only
//! when its checksum matches and it is a link as this program would write it.

use super::{CRC_32, LinkError, decode, is_of_a_link, number};
use crate::Design;
use crate::limits::{MAX_LINK_OPENED, is_invisible};
use std::borrow::Cow;

/// A design from a link, and what was done to open it.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// The design.
    pub design: Design,
    /// Its link as it was before it was mangled.
    pub link: String,
    /// True when the link came as the query of an address, behind `?`: unlike a fragment, a query is sent to the server.
    pub from_query: bool,
}

/// Rounds of percent-encoding that are undone: an address that is passed on twice is encoded twice.
const MAX_ENCODINGS: usize = 3;

/// Longest text that is searched for a link, in bytes: the longest link with every character encoded, and as much around it.
const MAX_TEXT: usize = 6 * MAX_LINK_OPENED;

/// Characters of the checksum.
const CHECKSUM_LENGTH: usize = 6;

/// Opens the link in a text: an address whose fragment is a link, else whose query is one, or a link by itself.
///
/// # Errors
/// Says why the text is no link, or why its design is refused. [`LinkError::Empty`] when the text is an address without a link.
pub fn open(text: &str) -> Result<Opened, LinkError> {
    let (part, from_query) = find(text.trim());
    let opened = |link: &str, design: Design| Opened { design, link: link.to_owned(), from_query };
    let refusal = match decode(part) {
        Ok(design) => return Ok(opened(part, design)),
        Err(refusal) => refusal,
    };
    if part.len() > MAX_TEXT
        || !matches!(refusal, LinkError::Character { .. } | LinkError::Damaged | LinkError::TooLong(_))
    {
        return Err(refusal);
    }
    match repaired(part) {
        Some(link) => decode(&link).map(|design| opened(&link, design)),
        None => Err(refusal),
    }
}

/// The part of a text that should be a link, and whether it is the query of an address.
fn find(text: &str) -> (&str, bool) {
    if has_version(&cleaned(text)) && !text.starts_with('?') {
        return (text, false);
    }
    let is_address = text.split_once(':').is_some_and(|(_, rest)| rest.starts_with("//"));
    match (text.split_once('#').or_else(|| encoded_fragment(text)), text.split_once('?')) {
        (Some((_, fragment)), _) if !fragment.is_empty() => (fragment, false),
        // Other queries are none of the page's business.
        (_, Some((_, query))) => (if has_version(&cleaned(query)) { query } else { "" }, true),
        (Some(_), None) => ("", false),
        (None, None) => (if is_address { "" } else { text }, false),
    }
}

/// Address and fragment, when the `#` between them is encoded.
fn encoded_fragment(text: &str) -> Option<(&str, &str)> {
    let at = text.bytes().enumerate().find(|&(at, _)| text.as_bytes()[at..].starts_with(b"%23"))?.0;
    Some((&text[..at], &text[at + 3..]))
}

/// True when a text begins as links of every version do.
fn has_version(text: &str) -> bool {
    let rest = text.trim_start_matches(|c: char| c.is_ascii_digit());
    rest.len() < text.len() && rest.starts_with('.')
}

/// The longest link that a mangled text begins with, as far as its checksum says.
fn repaired(text: &str) -> Option<String> {
    let text = cleaned(text);
    let length = text.find(|c| !is_of_a_link(c)).unwrap_or(text.len()).min(MAX_LINK_OPENED);
    // All bytes up to there are ASCII, so every place is a border of characters.
    let text = &text[..length];
    let mut sum = CRC_32.digest();
    let mut found = None;
    for (at, byte) in text.bytes().enumerate() {
        let end = at + 1 + CHECKSUM_LENGTH;
        if byte == b'.'
            && text.get(at + 1..end) == Some(number::base_62(sum.clone().finalize(), CHECKSUM_LENGTH).as_str())
        {
            found = Some(end);
        }
        sum.update(&[byte]);
    }
    found.map(|end| text[..end].to_owned())
}

/// A text without what programs add to the characters of a link.
fn cleaned(text: &str) -> String {
    let mut text = Cow::from(text);
    for _ in 0..MAX_ENCODINGS {
        match without_percent(&text) {
            Some(decoded) => text = decoded.into(),
            None => break,
        }
    }
    let added = |c: char| is_invisible(c) || matches!(c, '\\' | '<' | '>');
    let kept: String = text.chars().filter(|&c| !added(c)).collect();
    kept.trim_start_matches(['/', '#', '?']).to_owned()
}

/// A text with its percent-encoding undone; `None` when it has none.
fn without_percent(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text;
    let mut any = false;
    while let Some((before, after)) = rest.split_once('%') {
        bytes.extend(before.bytes());
        match after.get(..2).and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
                any = true;
            }
            None => {
                bytes.push(b'%');
                rest = after;
            }
        }
    }
    bytes.extend(rest.bytes());
    any.then(|| String::from_utf8_lossy(&bytes).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::link::encode;
    use crate::testing::{self, Random};

    const LINK: &str = "1.Example_9RT.R35_7M50_10D40C50-10D40Q50_10D40S50-10D40.3Qwl0W";

    /// Every character as a percent sign and two digits, or only those that some program takes for unsafe.
    fn encoded(text: &str, which: impl Fn(char) -> bool) -> String {
        text.chars().map(|c| if which(c) { format!("%{:02X}", u32::from(c)) } else { c.to_string() }).collect()
    }

    /// The text with an insertion after every so many characters.
    fn broken(text: &str, every: usize, insertion: &str) -> String {
        let characters: Vec<char> = text.chars().collect();
        let lines: Vec<String> = characters.chunks(every).map(|line| line.iter().collect()).collect();
        lines.join(insertion)
    }

    /// Ways in which programs mangle a link without losing a character of it.
    fn manglings(link: &str) -> Vec<String> {
        let all = encoded(link, |_| true);
        let dots = encoded(link, |c| c == '.');
        let escaped: String =
            link.chars().flat_map(|c| ['\\', c].into_iter().skip(usize::from(c.is_alphanumeric()))).collect();
        let percent_twice = all.replace('%', "%25");
        let mut ways = vec![
            all.clone(),
            all.to_lowercase(),
            percent_twice.clone(),
            percent_twice.replace('%', "%25"),
            dots.clone(),
            encoded(link, |c| c == '_'),
            encoded(link, |c| !c.is_alphanumeric()),
            escaped.clone(),
            link.replace('_', "\\_"),
            link.replace('-', "\\-"),
            link.replace('.', "\\."),
            format!("<{link}>"),
            format!("< {link} >"),
            format!("%3C{link}%3E"),
            format!("<{escaped}>"),
            format!("/{link}"),
            format!("//{link}"),
            format!("/{dots}"),
            format!("%2F{link}"),
            format!("#{link}"),
        ];
        for every in [1, 7, 40, 72, 76] {
            for insertion in [" ", "\n", "\r\n", "\t", "\r\n> ", "\u{200b}", "\u{a0}", "\u{ad}", "%20", "%0D%0A"] {
                ways.push(broken(link, every, insertion));
            }
        }
        for tail in [
            "&fbclid=IwAR0abc",
            "?utm_source=mail",
            "&utm_medium=chat&x=1",
            "/",
            "/#",
            "#top",
            ".",
            ",",
            ";",
            ":",
            "!",
            "?",
            ")",
            "]",
            "}",
            "\"",
            "'",
            "»",
            "…",
            "*",
            "**",
            "|",
            "~",
            "`",
            ">.",
            ">)",
            ").",
            " thanks!",
            " and more.text",
            "\n\nRegards",
            "%20",
            "%0A",
            "%22",
            "%29.",
            "</a>",
            "\"/>",
            "&amp;x=1",
            "&nbsp;",
            " (cam 3)",
            "\u{feff}",
            "\\",
            "_",
            "-",
            "__",
            "--",
            ".html",
            "=",
            "=\r\n",
            "@example",
            "🙂",
        ] {
            ways.push(format!("{link}{tail}"));
            ways.push(format!("/{link}{tail}"));
            ways.push(format!("{all}{tail}"));
        }
        ways
    }

    #[test]
    fn harmless_manglings_are_repaired() {
        let mut random = Random::new(14);
        let mut links = vec![(LINK.to_owned(), decode(LINK).expect("published"))];
        while links.len() < 50 {
            let make = if links.len() % 4 == 0 { testing::long_design } else { testing::design };
            let design = make(&mut random);
            let Ok(link) = encode(&design) else { continue };
            links.push((link, design));
        }
        for (link, design) in &links {
            let ways = manglings(link);
            assert!(ways.len() >= 200, "{}", ways.len());
            for (k, mangled) in ways.into_iter().enumerate() {
                let address = if k % 2 == 0 { mangled } else { format!("https://example.org/cams/#{mangled}") };
                let (part, _) = find(address.trim());
                assert_eq!(repaired(part).as_ref(), Some(link), "{address}");
                // To open a link is to compute its cam, so only some are.
                if k % 16 == 0 {
                    let opened = open(&address).unwrap_or_else(|error| panic!("{address}: {error:?}"));
                    assert_eq!((&opened.link, &opened.design), (link, design), "{address}");
                }
            }
        }
    }

    #[test]
    fn a_link_is_found_within_what_people_paste() {
        for text in [
            LINK.to_owned(),
            format!("#{LINK}"),
            format!(" {LINK}\n"),
            format!("https://example.org/cams/#{LINK}"),
            format!("file:///C:/cams/index.html?x#{LINK}"),
        ] {
            let opened = open(&text).expect("a link");
            assert_eq!((opened.link.as_str(), opened.from_query), (LINK, false), "{text}");
        }
    }

    #[test]
    fn a_query_is_read_like_a_fragment_and_a_fragment_wins() {
        let other = encode(&crate::example("2RO").expect("2RO")).expect("short");
        for text in
            [format!("?{LINK}"), format!("https://example.org/?{LINK}&fbclid=1"), format!("https://a.org/x?{LINK}#")]
        {
            let opened = open(&text).expect("a link");
            assert_eq!((opened.link.as_str(), opened.from_query), (LINK, true), "{text}");
        }
        let both = open(&format!("https://example.org/?{LINK}#{other}")).expect("a link");
        assert_eq!((both.link, both.from_query), (other, false));
        for text in ["https://example.org/", "https://example.org/#", "https://example.org/?lang=es", "?1", "?v=1.2#"] {
            assert_eq!(open(text), Err(LinkError::Empty), "{text}");
        }
    }

    #[test]
    fn what_lost_a_character_stays_refused_for_its_own_reason() {
        assert_eq!(open(""), Err(LinkError::Empty));
        assert_eq!(open(&LINK.replace("R35", "R36")), Err(LinkError::Damaged));
        assert_eq!(open("1.%E2%82%AC"), Err(LinkError::Character { found: '%', position: 3 }));
        assert!(matches!(open(&"1".repeat(MAX_LINK_OPENED + 1)), Err(LinkError::TooLong(_))));
        assert!(matches!(open(&"%31".repeat(MAX_TEXT)), Err(LinkError::TooLong(_))));
        let newer = format!("3.anything.{}", crate::link::checksum("3.anything"));
        assert_eq!(
            open(&format!("<{newer}>")),
            Err(LinkError::Version { found: "3".to_owned() }),
            "whole behind its brackets"
        );
    }
}
