//! CSV that spreadsheets open with a double click.

use crate::sheets::{Cell, sheet};
use crate::{Step, Subject, Table};
use csv::{QuoteStyle, Terminator, WriterBuilder};
use levalab_format::limits::is_invisible;

/// What parts cells, and with it the decimal sign: spreadsheets of a country expect both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// Comma between cells, decimal point: English.
    Comma,
    /// Semicolon between cells, decimal comma: Spanish.
    Semicolon,
}

impl Separator {
    /// What spreadsheets expect where a language is spoken.
    #[must_use]
    pub fn of(language: levalab_words::Language) -> Self {
        match language {
            levalab_words::Language::En => Self::Comma,
            levalab_words::Language::Es => Self::Semicolon,
        }
    }
}

/// Says that the text is UTF-8: without it some spreadsheets take θ and ° for something else.
const MARK: char = '\u{feff}';

/// A table as CSV, with the mark that spreadsheets look for at the beginning; empty but for it when the table does not apply.
///
/// Every text is in quotes and no number is. An apostrophe stands before what a spreadsheet would take for a formula, wherever in the
/// text that is: a reader that parts cells at another sign sees through the quotes.
#[must_use]
pub fn csv(subject: &Subject, table: Table, step: Step, separator: Separator) -> String {
    let delimiter = match separator {
        Separator::Comma => b',',
        Separator::Semicolon => b';',
    };
    let mut writer = WriterBuilder::new()
        .delimiter(delimiter)
        .flexible(true)
        .terminator(Terminator::CRLF)
        // Cells come with their quotes.
        .quote_style(QuoteStyle::Never)
        .from_writer(Vec::new());
    for row in sheet(subject, table, step).map_or_else(Vec::new, |sheet| sheet.rows) {
        let cells = row.cells.iter().map(|cell| match cell {
            Cell::Number(value) => number(*value, separator),
            Cell::Text(text) => format!("\"{}\"", harmless(text).replace('"', "\"\"")),
        });
        let cells: Vec<String> = cells.collect();
        // Writing to memory cannot fail.
        let _ = if cells.is_empty() { writer.write_record([""]) } else { writer.write_record(cells) };
    }
    let text = String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default();
    // A row without cells is an empty line, and not one empty cell in quotes.
    format!("{MARK}{}", text.replace("\r\n\"\"\r\n", "\r\n\r\n"))
}

fn number(value: f64, separator: Separator) -> String {
    let text = value.to_string();
    match separator {
        Separator::Comma => text,
        Separator::Semicolon => text.replace('.', ","),
    }
}

/// What comes before a character, for a reader that looks for cells.
#[derive(Clone, Copy, PartialEq)]
enum Before {
    /// The beginning of a cell for some reader, and nothing visible since.
    Separator,
    /// A blank or invisible character within a cell.
    Blank,
    /// Anything else.
    Text,
}

/// Text that no spreadsheet takes for a formula, in whatever way it parts cells: an apostrophe goes before the sign of a formula that
/// begins the text, or follows any separator, blank or invisible character. A sign between blanks, as in "cam = 2", is none.
fn harmless(text: &str) -> String {
    let mut safe = String::new();
    let mut before = Before::Separator;
    let mut characters = text.chars().peekable();
    while let Some(c) = characters.next() {
        let stands_alone = characters.peek().is_none_or(|next| is_invisible(*next));
        let guarded = before == Before::Separator || before == Before::Blank && !stands_alone;
        if guarded && begins_formula(c) {
            safe.push('\'');
        }
        safe.push(c);
        before = match c {
            ',' | ';' | ':' | '|' => Before::Separator,
            c if c.is_control() => Before::Separator,
            // A quote may be taken away on the way to a cell.
            '"' => before,
            c if is_invisible(c) && before == Before::Text => Before::Blank,
            c if is_invisible(c) => before,
            _ => Before::Text,
        };
    }
    safe
}

/// The signs with which spreadsheets begin a formula, in their usual, full and small widths.
fn begins_formula(c: char) -> bool {
    matches!(c, '=' | '+' | '-' | '@' | '＝' | '＋' | '－' | '＠' | '﹦' | '﹢' | '﹣' | '﹫')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_becomes_text() {
        for (text, written) in [
            ("=1+1", "'=1+1"),
            ("+x", "'+x"),
            ("-2 cams", "'-2 cams"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("cam = 2", "cam = 2"),
            ("a;=HYPERLINK(\"x\")", "a;'=HYPERLINK(\"x\")"),
            ("a,@b", "a,'@b"),
            ("a\t=1", "a\t'=1"),
            ("a|-1", "a|'-1"),
            (" =1", " '=1"),
            ("\u{200b}\u{feff}=1", "\u{200b}\u{feff}'=1"),
            ("\u{a0}+1", "\u{a0}'+1"),
            ("a; \"=1", "a; \"'=1"),
            ("a =1", "a '=1"),
            ("＝1", "'＝1"),
            ("3-4-5", "3-4-5"),
            ("a; = b", "a; '= b"),
            ("", ""),
        ] {
            assert_eq!(harmless(text), written);
        }
    }

    #[test]
    fn numbers_take_the_decimal_sign_of_the_separator() {
        assert_eq!(number(-0.5, Separator::Semicolon), "-0,5");
        assert_eq!(number(1e-7, Separator::Semicolon), "0,0000001");
        assert_eq!(number(12.25, Separator::Comma), "12.25");
    }
}
