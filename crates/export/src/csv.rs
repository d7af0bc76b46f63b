//! CSV that spreadsheets open with a double click.

use crate::sheets::{Cell, sheet};
use crate::{Step, Subject, Table};
use csv::{Terminator, WriterBuilder};

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
/// Text that a spreadsheet would take for a formula is quoted by an apostrophe.
#[must_use]
pub fn csv(subject: &Subject, table: Table, step: Step, separator: Separator) -> String {
    let delimiter = match separator {
        Separator::Comma => b',',
        Separator::Semicolon => b';',
    };
    let mut writer =
        WriterBuilder::new().delimiter(delimiter).flexible(true).terminator(Terminator::CRLF).from_writer(Vec::new());
    for row in sheet(subject, table, step).map_or_else(Vec::new, |sheet| sheet.rows) {
        let cells = row.cells.iter().map(|cell| match cell {
            Cell::Number(value) => number(*value, separator),
            Cell::Text(text) => harmless(text),
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

/// Text that no spreadsheet takes for a formula.
fn harmless(text: &str) -> String {
    let risky = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    if risky { format!("'{text}") } else { text.to_owned() }
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
