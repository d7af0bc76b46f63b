//! The few tags of `index.html` that load something: read, and written anew for the packed page.

use std::ops::Range;

/// A tag that loads a file of ours.
#[derive(Debug, PartialEq)]
pub struct Load {
    /// Where the tag stands, a script's end tag included.
    range: Range<usize>,
    /// The tag itself.
    pub tag: String,
    /// What it loads, relative to the checkout.
    pub file: String,
    /// What kind of thing that is.
    pub kind: Kind,
}

/// What a tag loads.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A module script.
    Module,
    /// A classic script.
    Script,
    /// A style sheet, with its `media`.
    Style(String),
    /// A hint to load early.
    Hint,
    /// A page of its own, to which one may go.
    Page,
    /// An icon, a manifest.
    Other,
}

/// Every `<script>` and `<link>` that names a file under `web/`, in order.
pub fn loads(html: &str) -> Vec<Load> {
    let mut found = Vec::new();
    let mut start = 0;
    while let Some(offset) = html[start..].find('<') {
        start += offset;
        let end = html[start..].find('>').map_or(html.len(), |length| start + length + 1);
        found.extend(load(html, start..end));
        start = end;
    }
    found
}

fn load(html: &str, range: Range<usize>) -> Option<Load> {
    let tag = &html[range.clone()];
    let relation = attribute(tag, "rel").unwrap_or_default();
    let (name, kind) = if tag.starts_with("<script") {
        ("src", if attribute(tag, "type") == Some("module") { Kind::Module } else { Kind::Script })
    } else if tag.starts_with("<link") {
        let kind = match relation {
            "stylesheet" => Kind::Style(attribute(tag, "media").unwrap_or_default().to_owned()),
            "modulepreload" | "preload" | "prefetch" => Kind::Hint,
            "help" => Kind::Page,
            _ => Kind::Other,
        };
        ("href", kind)
    } else {
        return None;
    };
    let file = attribute(tag, name)?.trim_start_matches("./").to_owned();
    let close = "</script>";
    let end = if name == "src" && html[range.end..].starts_with(close) { range.end + close.len() } else { range.end };
    file.starts_with("web/").then(|| Load { range: range.start..end, tag: tag.to_owned(), file, kind })
}

fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let (_, value) = tag.split_once(&format!(" {name}=\""))?;
    Some(value.split_once('"')?.0)
}

/// The page with each of those tags replaced; an empty replacement takes its line away.
pub fn rewrite(html: &str, loads: &[Load], mut replacement: impl FnMut(&Load) -> String) -> String {
    let mut written = String::new();
    let mut end = 0;
    for load in loads {
        written.push_str(&html[end..load.range.start]);
        let text = replacement(load);
        end = load.range.end;
        if text.is_empty() {
            written.truncate(written.trim_end().len());
        }
        written.push_str(&text);
    }
    written.push_str(&html[end..]);
    written
}

/// Tells the page how it was packed, for what only works one way.
pub fn packed_as(html: &str, how: &str) -> String {
    html.replacen("<html ", &format!("<html data-packed=\"{how}\" "), 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = r#"<head>
  <link rel="icon" href="web/icon.svg">
  <link rel="stylesheet" href="./web/a.css">
  <link rel="stylesheet" href="web/p.css" media="print">
  <script type="module" src="web/main.js"></script>
</head>"#;

    #[test]
    fn scripts_styles_and_icons_are_found() {
        let found: Vec<_> = loads(PAGE).into_iter().map(|load| (load.file, load.kind)).collect();
        let expected = [
            ("web/icon.svg", Kind::Other),
            ("web/a.css", Kind::Style(String::new())),
            ("web/p.css", Kind::Style("print".into())),
            ("web/main.js", Kind::Module),
        ];
        assert_eq!(found, expected.map(|(file, kind)| (file.to_owned(), kind)));
    }

    #[test]
    fn tags_are_replaced_whole_and_dropped_with_their_line() {
        let written = rewrite(PAGE, &loads(PAGE), |load| match load.kind {
            Kind::Module => "<script src=\"x/main.js\"></script>".into(),
            _ => String::new(),
        });
        assert_eq!(written, "<head>\n  <script src=\"x/main.js\"></script>\n</head>");
    }
}
