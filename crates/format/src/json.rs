//! JSON text to a tree of values, refusing what an ordinary reader lets pass: fields given twice, numbers that no `f64` holds, and
//! objects in objects without end.
//!
//! One reader for the command and for the page. It is written out because it must name each fault with its place, because it is a
//! fraction of a general reader in the module that a page downloads, and because the depth of its recursion is bounded.

use crate::limits::{MAX_FILE_BYTES, MAX_FILE_DEPTH};
use crate::{DesignError, JsonFault, Path, PathPart, Problem};
use serde_json::{Map, Number, Value};

/// The mark that some editors put before UTF-8 text.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Reads a text, with or without a byte-order mark, as one JSON value.
///
/// # Errors
/// Says where the text stops being JSON and why, or which field is there twice or holds a number beyond an `f64`.
pub fn parse(text: &str) -> Result<Value, DesignError> {
    if text.len() > MAX_FILE_BYTES {
        return Err(too_large(text.len()));
    }
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let mut reader = Reader { text, at: 0, path: Vec::new() };
    reader.document().map_err(|fault| match fault {
        Fault::Json(fault) => {
            let (line, column) = place(text, reader.at);
            DesignError::at(Path::default(), Problem::NotJson { line, column, fault })
        }
        Fault::Field(problem) => DesignError::at(Path(reader.path), problem),
    })
}

/// Reads bytes as one JSON value.
///
/// # Errors
/// As [`parse`], and when they are not UTF-8 text.
pub fn parse_bytes(bytes: &[u8]) -> Result<Value, DesignError> {
    if bytes.len() > MAX_FILE_BYTES {
        return Err(too_large(bytes.len()));
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => parse(text),
        Err(_) => Err(DesignError::at(Path::default(), Problem::NotText)),
    }
}

fn too_large(bytes: usize) -> DesignError {
    DesignError::at(Path::default(), Problem::FileTooLarge { bytes, limit: MAX_FILE_BYTES })
}

/// Line and column of a place in a text, both from 1; columns are characters.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = &text.as_bytes()[..at.min(text.len())];
    let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
    let start = before.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
    let begins = |byte: &&u8| **byte & 0xc0 != 0x80;
    (line, before[start..].iter().filter(begins).count() + 1)
}

/// Why reading stops.
enum Fault {
    /// The text is not JSON at the place where the reader is.
    Json(JsonFault),
    /// The field on the reader's path is refused.
    Field(Problem),
}

type Read<T> = Result<T, Fault>;

/// A reader on its way through a text; after a fault it stays where it stopped.
struct Reader<'a> {
    text: &'a str,
    /// Bytes read so far.
    at: usize,
    path: Vec<PathPart>,
}

impl Reader<'_> {
    fn document(&mut self) -> Read<Value> {
        let value = self.value()?;
        self.skip_space();
        if self.at < self.text.len() { self.broken() } else { Ok(value) }
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn skip_space(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    fn broken<T>(&self) -> Read<T> {
        Err(Fault::Json(if self.at < self.text.len() { JsonFault::Syntax } else { JsonFault::End }))
    }

    /// The next sign after white space, when it is this one.
    fn takes(&mut self, sign: u8) -> bool {
        self.skip_space();
        let is_here = self.peek() == Some(sign);
        self.at += usize::from(is_here);
        is_here
    }

    fn expect(&mut self, sign: u8) -> Read<()> {
        if self.takes(sign) { Ok(()) } else { self.broken() }
    }

    fn value(&mut self) -> Read<Value> {
        self.skip_space();
        match self.peek() {
            Some(b'{' | b'[') if self.path.len() >= MAX_FILE_DEPTH => Err(Fault::Json(JsonFault::Depth)),
            Some(b'{') => self.object(),
            Some(b'[') => self.list(),
            Some(b'"') => self.string().map(Value::String),
            Some(b'-' | b'0'..=b'9') => self.number(),
            Some(b't') => self.word("true", Value::Bool(true)),
            Some(b'f') => self.word("false", Value::Bool(false)),
            Some(b'n') => self.word("null", Value::Null),
            _ => self.broken(),
        }
    }

    fn word(&mut self, word: &str, value: Value) -> Read<Value> {
        for letter in word.bytes() {
            if self.peek() != Some(letter) {
                return self.broken();
            }
            self.at += 1;
        }
        Ok(value)
    }

    fn list(&mut self) -> Read<Value> {
        self.expect(b'[')?;
        let mut items = Vec::new();
        if self.takes(b']') {
            return Ok(Value::Array(items));
        }
        loop {
            self.path.push(items.len().into());
            items.push(self.value()?);
            self.path.pop();
            if self.takes(b']') {
                return Ok(Value::Array(items));
            }
            self.expect(b',')?;
        }
    }

    fn object(&mut self) -> Read<Value> {
        self.expect(b'{')?;
        let mut fields = Map::new();
        if self.takes(b'}') {
            return Ok(Value::Object(fields));
        }
        loop {
            self.skip_space();
            let key = self.string()?;
            self.path.push(PathPart::Key(key.clone()));
            if fields.contains_key(&key) {
                return Err(Fault::Field(Problem::DuplicateField));
            }
            self.expect(b':')?;
            let value = self.value()?;
            if value.is_number() && self.decimal_comma_follows() {
                return Err(Fault::Json(JsonFault::DecimalComma));
            }
            fields.insert(key, value);
            self.path.pop();
            if self.takes(b'}') {
                return Ok(Value::Object(fields));
            }
            self.expect(b',')?;
        }
    }

    /// In an object a comma after a number is followed by the name of a field, never by a digit.
    fn decimal_comma_follows(&self) -> bool {
        matches!(self.text.as_bytes()[self.at..], [b',', b'0'..=b'9', ..])
    }

    fn string(&mut self) -> Read<String> {
        if self.peek() != Some(b'"') {
            return self.broken();
        }
        self.at += 1;
        let mut string = String::new();
        loop {
            let rest = &self.text[self.at..];
            let plain = rest.bytes().position(|byte| byte < b' ' || byte == b'"' || byte == b'\\');
            let plain = plain.unwrap_or(rest.len());
            string.push_str(&rest[..plain]);
            self.at += plain;
            match self.peek() {
                Some(b'"') => {
                    self.at += 1;
                    return Ok(string);
                }
                Some(b'\\') => string.push(self.escape()?),
                _ => return self.broken(),
            }
        }
    }

    fn escape(&mut self) -> Read<char> {
        let start = self.at;
        self.at += 1;
        let letter = match self.peek() {
            Some(sign @ (b'"' | b'\\' | b'/')) => char::from(sign),
            Some(b'b') => '\u{8}',
            Some(b'f') => '\u{c}',
            Some(b'n') => '\n',
            Some(b'r') => '\r',
            Some(b't') => '\t',
            Some(b'u') => return self.unicode_escape(start),
            _ => return self.broken(),
        };
        self.at += 1;
        Ok(letter)
    }

    /// A character by its number, or by the two halves of a surrogate pair; one half alone is no character.
    fn unicode_escape(&mut self, start: usize) -> Read<char> {
        self.at += 1;
        let unit = self.four_digits()?;
        let code = match unit {
            0xd800..=0xdbff if self.text.as_bytes()[self.at..].starts_with(b"\\u") => {
                self.at += 2;
                match self.four_digits()? {
                    low @ 0xdc00..=0xdfff => 0x10000 + ((unit - 0xd800) << 10) + (low - 0xdc00),
                    _ => unit,
                }
            }
            _ => unit,
        };
        char::from_u32(code).ok_or_else(|| {
            self.at = start;
            Fault::Json(JsonFault::Surrogate)
        })
    }

    fn four_digits(&mut self) -> Read<u32> {
        let mut code = 0;
        for _ in 0..4 {
            let Some(digit) = self.peek().and_then(|sign| char::from(sign).to_digit(16)) else { return self.broken() };
            code = code * 16 + digit;
            self.at += 1;
        }
        Ok(code)
    }

    fn number(&mut self) -> Read<Value> {
        let start = self.at;
        self.at += usize::from(self.peek() == Some(b'-'));
        match self.peek() {
            Some(b'0') => self.at += 1,
            _ => self.digits()?,
        }
        if self.peek() == Some(b'.') {
            self.at += 1;
            self.digits()?;
        }
        if matches!(self.peek(), Some(b'e' | b'E')) {
            self.at += 1;
            self.at += usize::from(matches!(self.peek(), Some(b'+' | b'-')));
            self.digits()?;
        }
        let number = self.text[start..self.at].parse().ok().and_then(Number::from_f64);
        number.map(Value::Number).ok_or(Fault::Field(Problem::NotFinite))
    }

    fn digits(&mut self) -> Read<()> {
        let start = self.at;
        while matches!(self.peek(), Some(b'0'..=b'9')) {
            self.at += 1;
        }
        if self.at == start { self.broken() } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(text: &str) -> (String, Problem) {
        let error = parse(text).expect_err(text);
        (error.path.to_string(), error.problem)
    }

    #[test]
    fn a_field_given_twice_is_named() {
        assert_eq!(refusal(r#"{"a": [1, {"b": 2, "b": 2}]}"#), ("a[1].b".to_owned(), Problem::DuplicateField));
    }

    #[test]
    fn a_number_beyond_an_f64_is_named() {
        assert_eq!(refusal(r#"{"a": {"b": 1e999}}"#), ("a.b".to_owned(), Problem::NotFinite));
    }

    #[test]
    fn broken_json_is_placed() {
        let syntax = Problem::NotJson { line: 2, column: 10, fault: JsonFault::Syntax };
        assert_eq!(refusal("{\n  \"a\": nux\n}").1, syntax);
        for text in [
            "",
            "{",
            "[1,]",
            "{} {}",
            "NaN",
            "{\"a\": NaN}",
            "'a'",
            "{a: 1}",
            "01",
            "1.",
            "-",
            "+1",
            "\"a",
            "\"\t\"",
            "\"\\x\"",
        ] {
            assert!(matches!(refusal(text).1, Problem::NotJson { .. }), "{text}");
        }
    }

    #[test]
    fn a_huge_text_is_not_even_looked_at() {
        let text = " ".repeat(MAX_FILE_BYTES + 1);
        assert!(matches!(refusal(&text).1, Problem::FileTooLarge { .. }));
    }

    #[test]
    fn every_decimal_becomes_the_nearest_number() {
        for text in ["33.333333333333336", "0.1", "1.7976931348623157e308", "123456789.123456789", "4.35"] {
            assert_eq!(parse(text).ok().and_then(|value| value.as_f64()), text.parse().ok(), "{text}");
        }
    }

    #[test]
    fn columns_are_counted_in_characters_and_a_mark_is_none() {
        let expected = Problem::NotJson { line: 1, column: 8, fault: JsonFault::Syntax };
        assert_eq!(refusal("{\"ñθ\": ?}").1, expected);
        assert_eq!(refusal("\u{feff}{\"ñθ\": ?}").1, expected);
        assert_eq!(parse("\u{feff}{}").ok(), Some(Map::new().into()));
        assert_eq!(parse_bytes(b"\xef\xbb\xbf{}").ok(), Some(Map::new().into()));
    }

    #[test]
    fn a_text_that_nests_without_end_is_refused_as_a_whole() {
        for nested in
            ["[".repeat(100_000), "{\"a\":".repeat(100_000), format!("{}{}", "[".repeat(200), "]".repeat(200))]
        {
            let (path, problem) = refusal(&nested);
            assert_eq!(path, "");
            assert!(matches!(problem, Problem::NotJson { line: 1, fault: JsonFault::Depth, .. }), "{problem:?}");
        }
        assert!(parse(&format!("{}{}", "[".repeat(MAX_FILE_DEPTH), "]".repeat(MAX_FILE_DEPTH))).is_ok());
    }

    #[test]
    fn half_a_surrogate_pair_is_no_character() {
        for text in [r#""\ud83d""#, r#""\ud83d x""#, r#""\ude00\ud83d""#, r#""\ud83dA""#, r#""\udc00""#] {
            let expected = Problem::NotJson { line: 1, column: 2, fault: JsonFault::Surrogate };
            assert_eq!(refusal(text).1, expected, "{text}");
        }
        assert_eq!(parse(r#""\ud83d\ude00 \u00f1\n""#).ok(), Some("\u{1f600} ñ\n".into()));
    }

    #[test]
    fn a_decimal_comma_is_named() {
        let expected = Problem::NotJson { line: 1, column: 8, fault: JsonFault::DecimalComma };
        assert_eq!(refusal(r#"{"a": 1,5, "b": 2}"#).1, expected);
        assert!(parse(r#"{"a": 1,"b": [1,5]}"#).is_ok());
    }

    #[test]
    fn a_text_that_ends_too_soon_is_placed_at_its_end() {
        let expected = Problem::NotJson { line: 2, column: 5, fault: JsonFault::End };
        assert_eq!(refusal("{\n\"a\":").1, expected);
    }

    #[test]
    fn it_reads_what_another_reader_reads() {
        let texts = [
            r#"{"a": [1, -2.5e-3, true, false, null, {}, [], "b\\\"\/\b\f\n\r\t"], "": 0}"#,
            " 0 ",
            "-0.0",
            "1E+2",
            "\"\u{7f}ñ\"",
        ];
        for text in texts {
            let other: Value = serde_json::from_str(text).expect(text);
            let floats = |value: &Value| value.to_string().replace(".0", "");
            assert_eq!(parse(text).map(|value| floats(&value)).ok(), Some(floats(&other)), "{text}");
        }
    }
}
