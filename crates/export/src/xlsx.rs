//! An Excel workbook, a sheet a table.

use crate::sheets::{Cell, Row, Sheet, sheet};
use crate::{Refusal, Step, Subject, Table};
use rust_xlsxwriter::{DocProperties, Format, FormatAlign, Workbook, Worksheet, XlsxError};

/// Widest column, in characters: sentences wrap.
const WIDEST: f64 = 60.0;

/// The workbook: design, motion, profile, pitch curve, verdict. Numbers are numbers with all their digits.
///
/// # Errors
/// When the writer gives up, for which there is no known reason.
pub fn xlsx(subject: &Subject, step: Step) -> Result<Vec<u8>, Refusal> {
    write(subject, step).map_err(|error| Refusal::Failed { said: error.to_string() })
}

fn write(subject: &Subject, step: Step) -> Result<Vec<u8>, XlsxError> {
    let mut book = Workbook::new();
    book.set_properties(&DocProperties::new().set_title(&subject.design().title).set_comment("LevaLab"));
    for table in Table::SHEETS {
        if let Some(sheet) = sheet(subject, table, step) {
            fill(book.add_worksheet(), &sheet)?;
        }
    }
    book.save_to_buffer()
}

fn fill(page: &mut Worksheet, sheet: &Sheet) -> Result<(), XlsxError> {
    let head = Format::new().set_bold().set_text_wrap().set_align(FormatAlign::Top);
    let text = Format::new().set_text_wrap().set_align(FormatAlign::Top);
    let number = Format::new().set_align(FormatAlign::Top);
    page.set_name(sheet.name)?;
    for (k, row) in sheet.rows.iter().enumerate() {
        let at = u32::try_from(k).unwrap_or(u32::MAX);
        for (column, cell) in (0_u16..).zip(&row.cells) {
            match cell {
                Cell::Number(value) => page.write_number_with_format(at, column, *value, &number)?,
                // Text is text, and never becomes a formula.
                Cell::Text(words) => {
                    page.write_string_with_format(at, column, words, if row.head { &head } else { &text })?
                }
            };
        }
    }
    for (column, width) in (0_u16..).zip(widths(&sheet.rows)) {
        page.set_column_width(column, width)?;
    }
    page.set_freeze_panes(1, 0)?;
    Ok(())
}

/// Room for the longest word of heads and for the text of the rows.
fn widths(rows: &[Row]) -> Vec<f64> {
    const NUMBER: usize = 12;
    let columns = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
    let longest = |column: usize| {
        let of_row = |row: &Row| match (row.head, row.cells.get(column)) {
            (_, None) => 0,
            (_, Some(Cell::Number(_))) => NUMBER,
            (true, Some(Cell::Text(text))) => text.split(' ').map(|word| word.chars().count()).max().unwrap_or(0),
            (false, Some(Cell::Text(text))) => text.chars().count(),
        };
        rows.iter().map(of_row).max().unwrap_or(0)
    };
    (0..columns).map(|column| (longest(column) as f64 + 2.0).clamp(NUMBER as f64, WIDEST)).collect()
}
