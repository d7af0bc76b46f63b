//! Pages of text: a little markup for prose, everything escaped.
//!
//! `$…$` is a formula, `$$…$$` alone in a paragraph a displayed one, `*…*` emphasis, `[words](#place)` a link, `{key}` a label of
//! the page's own controls. Blank lines part paragraphs; lines that begin with `- ` are a list.

use levalab_formula::{self as formula, escape, parse};
use levalab_words::{Language, two};
use std::collections::BTreeMap;

/// Labels of the page's controls by key.
pub type Labels = BTreeMap<String, String>;

/// What turns words into markup.
#[derive(Clone, Copy)]
pub struct Pen<'a> {
    /// The language they are in.
    pub language: Language,
    /// Labels that they may name.
    pub labels: &'a Labels,
}

/// Characters of the notation of a formula that fits everywhere.
const NARROW: usize = 34;

impl Pen<'_> {
    /// Paragraphs.
    ///
    /// # Panics
    /// When a formula or a label of ours is wrong: the pages are not written then.
    #[must_use]
    pub fn paragraphs(self, text: &str) -> String {
        text.split("\n\n").map(|paragraph| self.paragraph(paragraph.trim())).collect()
    }

    fn paragraph(self, text: &str) -> String {
        if let Some(formula) = text.strip_prefix("$$").and_then(|rest| rest.strip_suffix("$$")) {
            return self.displayed(formula);
        }
        if text.starts_with("- ") {
            let items =
                text.split("\n").map(|item| format!("<li>{}</li>", self.line(item.trim().trim_start_matches("- "))));
            return format!("<ul>{}</ul>", items.collect::<String>());
        }
        format!("<p>{}</p>", self.line(text))
    }

    /// Where something is found in books, on a line of its own.
    #[must_use]
    pub fn source(self, source: Option<&str>) -> String {
        let within = |en, es| two(en, es).within(self.language);
        let told = match source {
            Some(book) => format!("{}: <cite>{}</cite>.", within("In books", "En los libros"), escape(book)),
            None => within("Own derivation.", "Deducción propia.").to_owned(),
        };
        format!("<p class=\"source\">{told}</p>")
    }

    /// A formula on a line of its own.
    ///
    /// # Panics
    /// When the formula is misprinted.
    #[must_use]
    pub fn displayed(self, text: &str) -> String {
        let formula = parse(text).unwrap_or_else(|misprint| panic!("{misprint}"));
        // What may be wider than a phone can be scrolled by the keyboard too.
        let reached = if text.chars().count() > NARROW { " tabindex=\"0\"" } else { "" };
        format!("<div class=\"formula\"{reached}>{}</div>", formula::block(&formula, self.language))
    }

    /// A formula within a line.
    ///
    /// # Panics
    /// When the formula is misprinted.
    #[must_use]
    pub fn formula(self, text: &str) -> String {
        let formula = parse(text).unwrap_or_else(|misprint| panic!("{misprint}"));
        formula::inline(&formula, self.language)
    }

    /// Words in a line.
    ///
    /// # Panics
    /// When a formula or a label of ours is wrong.
    #[must_use]
    pub fn line(self, text: &str) -> String {
        let mut written = String::new();
        let mut rest = text;
        while let Some(at) = rest.find(['$', '*', '[', '{']) {
            written += &escape(&rest[..at]);
            let mark = &rest[at..=at];
            let after = &rest[at + 1..];
            let close = match mark {
                "[" => "]",
                "{" => "}",
                same => same,
            };
            let (inner, beyond) = after.split_once(close).unwrap_or_else(|| panic!("{mark} is not closed in: {text}"));
            rest = beyond;
            match mark {
                "$" => {
                    // What ends the phrase stays with the formula.
                    let stops = rest.len() - rest.trim_start_matches([',', '.', ';', ':', ')']).len();
                    let formula = self.formula(inner);
                    written += &match &rest[..stops] {
                        "" => formula,
                        stop => format!("<span class=\"kept\">{formula}{stop}</span>"),
                    };
                    rest = &rest[stops..];
                }
                "*" => written += &format!("<em>{}</em>", escape(inner)),
                "{" => written += &self.label(inner),
                _ => {
                    let target = beyond.strip_prefix('(').and_then(|target| target.split_once(')'));
                    let (target, beyond) = target.unwrap_or_else(|| panic!("a link without a target in: {text}"));
                    written += &format!("<a href=\"{}\">{}</a>", escape(target), self.line(inner));
                    rest = beyond;
                }
            }
        }
        written + &escape(rest)
    }

    fn label(self, key: &str) -> String {
        let label = self.labels.get(key).unwrap_or_else(|| panic!("the page has no label `{key}`"));
        format!("<b class=\"label\">{}</b>", escape(label.trim_end_matches('…')))
    }
}

/// One page.
pub struct Page<'a> {
    /// Name of its file.
    pub file: String,
    /// Its language.
    pub language: Language,
    /// Its heading.
    pub title: &'a str,
    /// What it is about, for search engines.
    pub about: &'a str,
    /// Links to its sisters: file and name; itself among them.
    pub sisters: Vec<(String, &'a str)>,
    /// The same page in the other language.
    pub other: (String, &'a str),
    /// Back to LevaLab.
    pub home: &'a str,
    /// What the list of contents is called.
    pub contents: &'a str,
    /// Places and their names, grouped by a heading of their own.
    pub places: Vec<(String, Vec<(String, String)>)>,
    /// Everything below the heading.
    pub body: String,
}

/// The policy under which the pages are shown: nothing from elsewhere, no script but the one that sets the theme, and no text that
/// becomes markup or script.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; base-uri 'none'; \
    form-action 'none'; require-trusted-types-for 'script'; trusted-types 'none'";

impl Page<'_> {
    /// The whole file. It lies in a folder beside `styles/`.
    #[must_use]
    pub fn html(&self) -> String {
        let language = self.language.tag();
        let (title, about) = (escape(self.title), escape(self.about));
        let sisters: String = self.sisters.iter().map(|(file, name)| self.sister(file, name)).collect();
        let (other_file, other_name) = &self.other;
        let other = if language == "en" { "es" } else { "en" };
        let contents: String = self.places.iter().map(|(group, places)| contents_group(group, places)).collect();
        let contents = if self.places.is_empty() {
            String::new()
        } else {
            format!("<nav class=\"contents\" aria-label=\"{}\">{contents}</nav>", escape(self.contents))
        };
        format!(
            "<!doctype html>\n<html lang=\"{language}\" data-page>\n<head>\n<meta charset=\"utf-8\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"referrer\" content=\"no-referrer\">\n<meta name=\"description\" content=\"{about}\">\n\
             <title>{title} – LevaLab</title>\n<link rel=\"icon\" href=\"../icon.svg\" type=\"image/svg+xml\">\n\
             <link rel=\"stylesheet\" href=\"../styles/theory.css\">\n<script src=\"../early.js\"></script>\n</head>\n<body>\n\
             <header><a class=\"home\" href=\"../../index.html\">LevaLab</a><nav aria-label=\"LevaLab\">{sisters}</nav>\
             <a class=\"other\" lang=\"{other}\" hreflang=\"{other}\" href=\"{other_file}\">{other_name}</a></header>\n\
             {contents}\n<main>\n<h1>{title}</h1>\n{body}</main>\n<footer><a href=\"../../index.html\">{home}</a></footer>\n</body>\n</html>\n",
            body = self.body,
            home = escape(self.home),
        )
    }

    fn sister(&self, file: &str, name: &str) -> String {
        let here = if file == self.file { " aria-current=\"page\"" } else { "" };
        format!("<a href=\"{file}\"{here}>{}</a>", escape(name))
    }
}

fn contents_group(group: &str, places: &[(String, String)]) -> String {
    let items: String =
        places.iter().map(|(place, name)| format!("<li><a href=\"#{place}\">{}</a></li>", escape(name))).collect();
    let heading = if group.is_empty() { String::new() } else { format!("<h2>{}</h2>", escape(group)) };
    format!("{heading}<ul>{items}</ul>")
}

/// A section with its heading, which is also a link to itself.
#[must_use]
pub fn section(level: u8, id: &str, heading: &str, body: &str) -> String {
    let heading = escape(heading);
    format!("<section id=\"{id}\"><h{level}><a href=\"#{id}\">{heading}</a></h{level}>{body}</section>\n")
}
