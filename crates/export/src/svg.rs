//! SVG as text: what is data is escaped, numbers have three decimals.

use levalab_core::Point;
use std::fmt::Write;

/// Text as it may stand between tags and in attributes.
pub(crate) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}

/// A number with three decimals at most.
pub(crate) fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The data of a path through points that are on paper already.
pub(crate) fn through(points: impl IntoIterator<Item = Point>, closed: bool) -> String {
    let mut data = String::new();
    for (k, point) in points.into_iter().enumerate() {
        // Writing into a String cannot fail.
        let _ = write!(data, "{}{} {}", if k == 0 { "M" } else { "L" }, short(point.re), short(point.im));
    }
    if closed { data + "Z" } else { data }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_stays_text() {
        assert_eq!(escaped("<b>'A' & \"B\"\u{7}"), "&lt;b&gt;&#39;A&#39; &amp; &quot;B&quot; ");
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([1.0, -0.0001, 12.3456, -2.5, 100.0].map(short), ["1", "0", "12.346", "-2.5", "100"]);
    }
}
