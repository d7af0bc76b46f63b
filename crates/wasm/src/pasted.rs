//! Text that is typed or pasted: points of a table, and pairs to hit.

use levalab_core::law::MAX_POINTS;
use levalab_edge::{Failure, language, object};
use levalab_format::limits::{MAX_MEASURED_POINTS, MAX_TABLE_POINTS_OF_VERSION_1};
use levalab_format::measured::{Measured, MeasuredProblem};
use levalab_words::measured_problem;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// What the text of a table says.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum TableText {
    /// The points of the table.
    Points(Vec<[f64; 2]>),
    /// Measured data of which columns and points are to be chosen: the number of lines.
    Measured(usize),
    Error(Failure),
}

/// Pairs of numbers of a text in any order, or the line that is none.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Pairs {
    Points(Vec<[f64; 2]>),
    Line(usize),
}

/// The points of a table from its text: those of two columns, unless there are more columns or more points than are taken without a
/// question, of which a text that was pasted has fewer than one that was typed.
///
/// # Errors
/// Never: a line that cannot be read is an answer.
#[wasm_bindgen(unchecked_return_type = "TableText")]
pub fn read_table(
    text: &str,
    pasted: bool,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    object(&table(text, pasted).unwrap_or_else(|problem| {
        let message = measured_problem(language(words), &problem);
        TableText::Error(Failure { path: String::new(), message })
    }))
}

/// The pairs of numbers of a text, a line for each.
///
/// # Errors
/// Never: a line that cannot be read is an answer.
#[wasm_bindgen(unchecked_return_type = "Pairs")]
pub fn pairs(text: &str) -> Result<JsValue, JsError> {
    object(&match Measured::read(text).and_then(|measured| measured.pairs()) {
        Ok(points) => Pairs::Points(points),
        Err(MeasuredProblem::NotNumbers { line } | MeasuredProblem::NoValue { line, .. }) => Pairs::Line(line),
        // More of them than anything takes: beyond the last that is read.
        Err(_) => Pairs::Line(MAX_MEASURED_POINTS + 1),
    })
}

fn table(text: &str, pasted: bool) -> Result<TableText, MeasuredProblem> {
    let measured = Measured::read(text)?;
    if measured.is_empty() {
        return Ok(TableText::Points(Vec::new()));
    }
    let unasked = if pasted { MAX_TABLE_POINTS_OF_VERSION_1 } else { MAX_POINTS };
    if !measured.is_plain() || measured.len() > unasked {
        return Ok(TableText::Measured(measured.len()));
    }
    let [angle, lift] = measured.guess();
    Ok(TableText::Points(measured.curve(angle, lift)?.points))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_table_is_taken_at_once_and_a_long_one_that_is_pasted_is_not() {
        for (lines, pasted, taken) in [(128, true, true), (129, true, false), (361, false, true), (1025, false, false)]
        {
            let text: String = (0..lines).map(|k| format!("{k} 1\n")).collect();
            let points = match table(&text, pasted) {
                Ok(TableText::Points(points)) => points.len(),
                _ => 0,
            };
            assert_eq!(points, if taken { lines } else { 0 }, "{lines} lines");
        }
        assert!(matches!(table("0 0 1\n60 5 2\n360 0 3", false), Ok(TableText::Measured(3))), "which columns?");
        assert!(matches!(table(" \n", true), Ok(TableText::Points(points)) if points.is_empty()));
        assert!(matches!(table("0 0\n60 five5\n360 0", false), Err(MeasuredProblem::NotNumbers { line: 2 })));
    }
}
