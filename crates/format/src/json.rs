//! JSON text to a tree of values, refusing what an ordinary reader lets pass: fields given twice, and numbers that no `f64`
//! holds.

use crate::limits::MAX_FILE_BYTES;
use crate::{DesignError, Path, PathPart, Problem};
use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value};
use std::cell::RefCell;
use std::fmt;

/// Reads a text as one JSON value.
///
/// # Errors
/// Says where the text stops being JSON, or which field is there twice or holds a number beyond an `f64`.
pub fn parse(text: &str) -> Result<Value, DesignError> {
    if text.len() > MAX_FILE_BYTES {
        let problem = Problem::FileTooLarge { bytes: text.len(), limit: MAX_FILE_BYTES };
        return Err(DesignError::at(Path::default(), problem));
    }
    let progress = Progress::default();
    let mut reader = serde_json::Deserializer::from_str(text);
    let tree = Tree { progress: &progress }.deserialize(&mut reader);
    let error = match tree.and_then(|value| reader.end().map(|()| value)) {
        Ok(value) => return Ok(value),
        Err(error) => error,
    };
    let problem = if progress.duplicate.take() {
        Problem::DuplicateField
    } else if error.to_string().starts_with(NUMBER_OUT_OF_RANGE) {
        Problem::NotFinite
    } else {
        Problem::NotJson { line: error.line(), column: error.column() }
    };
    Err(DesignError::at(Path(progress.path.take()), problem))
}

/// Reads bytes as one JSON value.
///
/// # Errors
/// As [`parse`], and when they are not UTF-8 text.
pub fn parse_bytes(bytes: &[u8]) -> Result<Value, DesignError> {
    match std::str::from_utf8(bytes) {
        Ok(text) => parse(text),
        Err(_) => Err(DesignError::at(Path::default(), Problem::NotText)),
    }
}

/// How serde_json tells of a number like 1e999; it has no category of its own for it.
const NUMBER_OUT_OF_RANGE: &str = "number out of range";

/// Where the reader is; after an error, where it stopped.
#[derive(Default)]
struct Progress {
    path: RefCell<Vec<PathPart>>,
    duplicate: RefCell<bool>,
}

impl Progress {
    fn within<T, E>(&self, part: PathPart, read: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        self.path.borrow_mut().push(part);
        let value = read()?;
        self.path.borrow_mut().pop();
        Ok(value)
    }
}

#[derive(Clone, Copy)]
struct Tree<'a> {
    progress: &'a Progress,
}

impl<'de> DeserializeSeed<'de> for Tree<'_> {
    type Value = Value;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Tree<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("any JSON value")
    }

    fn visit_unit<E: Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut items = Vec::new();
        loop {
            let read = || list.next_element_seed(self);
            match self.progress.within(items.len().into(), read)? {
                Some(item) => items.push(item),
                None => return Ok(items.into()),
            }
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Value, A::Error> {
        let mut fields = Map::new();
        while let Some(key) = object.next_key::<String>()? {
            let repeated = fields.contains_key(&key);
            let value = self.progress.within(PathPart::Key(key.clone()), || {
                if repeated {
                    self.progress.duplicate.replace(true);
                    return Err(A::Error::custom("duplicate field"));
                }
                object.next_value_seed(self)
            })?;
            fields.insert(key, value);
        }
        Ok(fields.into())
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
        assert_eq!(refusal("{\n  \"a\": nux\n}").1, Problem::NotJson { line: 2, column: 10 });
        for text in ["", "{", "[1,]", "{} {}", "NaN", "{\"a\": NaN}", "'a'", "{a: 1}"] {
            assert!(matches!(refusal(text).1, Problem::NotJson { .. }), "{text}");
        }
        assert!(matches!(refusal(&"[".repeat(100_000)).1, Problem::NotJson { .. }));
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
}
