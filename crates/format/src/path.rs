//! Where in a design something is: `segments[2].beta`.

use serde::{Serialize, Serializer};
use std::fmt;

/// One step into a design.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum PathPart {
    /// Into a field of an object.
    Key(String),
    /// Into an item of a list, from 0.
    Index(usize),
}

/// The place of a value in a design, from the outside in; empty for the design itself.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Path(pub Vec<PathPart>);

/// A name longer than this is cut short when it is shown: it came from a file, and an error takes one line.
const LONGEST_NAME: usize = 40;

impl Path {
    /// The path with one more step.
    #[must_use]
    pub fn join(&self, part: impl Into<PathPart>) -> Self {
        let mut parts = self.0.clone();
        parts.push(part.into());
        Self(parts)
    }

    /// The name of the last field on the way, such as `beta`.
    #[must_use]
    pub fn field(&self) -> Option<&str> {
        self.0.iter().rev().find_map(|part| match part {
            PathPart::Key(key) => Some(key.as_str()),
            PathPart::Index(_) => None,
        })
    }
}

impl From<&str> for PathPart {
    fn from(key: &str) -> Self {
        Self::Key(key.to_owned())
    }
}

impl From<usize> for PathPart {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

impl<P: Into<PathPart>, const N: usize> From<[P; N]> for Path {
    fn from(parts: [P; N]) -> Self {
        Self(parts.map(Into::into).into())
    }
}

impl From<&str> for Path {
    fn from(key: &str) -> Self {
        Self(vec![key.into()])
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, part) in self.0.iter().enumerate() {
            match part {
                PathPart::Index(index) => write!(f, "[{index}]")?,
                PathPart::Key(key) if is_plain(key) => write!(f, "{}{key}", if i == 0 { "" } else { "." })?,
                PathPart::Key(key) => write!(f, "[{}]", quoted(key))?,
            }
        }
        Ok(())
    }
}

impl Serialize for PathPart {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Key(key) => serializer.serialize_str(key),
            Self::Index(index) => serializer.serialize_u64(*index as u64),
        }
    }
}

fn is_plain(key: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    !key.is_empty() && key.len() <= LONGEST_NAME && key.chars().all(plain)
}

/// A text from a file made safe to show: in quotes, on one line, cut short, nothing invisible.
#[must_use]
pub fn quoted(text: &str) -> String {
    let shown: String = text.chars().take(LONGEST_NAME).flat_map(visible).collect();
    let more = if text.chars().nth(LONGEST_NAME).is_some() { "…" } else { "" };
    format!("\"{shown}{more}\"")
}

fn visible(c: char) -> impl Iterator<Item = char> {
    let hidden = c.is_control() || crate::limits::is_bidirectional(c) || c == '"' || c == '\\';
    let escaped = hidden.then(|| c.escape_unicode());
    let shown = (!hidden).then_some(c);
    escaped.into_iter().flatten().chain(shown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_read_as_in_javascript() {
        let path = Path::from("segments").join(2).join("beta");
        assert_eq!(path.to_string(), "segments[2].beta");
        assert_eq!(Path::default().to_string(), "");
        assert_eq!(path.field(), Some("beta"));
    }

    #[test]
    fn strange_names_stay_on_one_visible_line() {
        let path = Path::from(["cam", "a\nb\u{202e}c"]);
        assert_eq!(path.to_string(), r#"cam["a\u{a}b\u{202e}c"]"#);
        assert!(quoted(&"x".repeat(1000)).chars().count() < 50);
    }
}
