//! Numbers of fields and readouts: read and written as everywhere else.

use levalab_edge::{language, object};
use levalab_numbers::{read, write};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A number that was read, or the sentence that says why there is none.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Reading {
    Value(f64),
    Problem(String),
}

/// The ways in which the page writes a number.
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub enum NumberForm {
    /// As many digits as it takes, twelve at most.
    Exact,
    /// So many decimals exactly.
    Fixed,
    /// Four significant digits, no zeros at the end.
    Measured,
    /// Four significant digits, zeros at the end included.
    MeasuredWhole,
    /// Every digit, for a field that is being edited.
    Editable,
    /// For a field that nobody edits, with room for so many characters.
    AtRest,
}

/// Reads what was typed into a field whose number is in the given unit.
///
/// # Errors
/// Never: a text that is no number is an answer.
#[wasm_bindgen(unchecked_return_type = "NumberReading")]
pub fn read_number(
    text: &str,
    unit: &str,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    object(&match read(text, unit) {
        Ok(value) => Reading::Value(value),
        Err(problem) => Reading::Problem(levalab_words::number_problem(language(words), text, &problem)),
    })
}

/// Writes a number. `digits` is the number of decimals of [`NumberForm::Fixed`] and the room of [`NumberForm::AtRest`].
#[must_use]
#[wasm_bindgen]
pub fn write_number(
    value: f64,
    form: NumberForm,
    digits: usize,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> String {
    let sign = language(words).decimal_sign();
    match form {
        NumberForm::Exact => write::exact(value, sign),
        NumberForm::Fixed => write::fixed(value, digits.min(MAX_DECIMALS), sign),
        NumberForm::Measured => write::measured(value, sign),
        NumberForm::MeasuredWhole => write::measured_whole(value, sign),
        NumberForm::Editable => write::editable(value, sign),
        NumberForm::AtRest => write::at_rest(value, digits, sign),
    }
}

/// Maximum number of decimals: an `f64` has no more that count.
const MAX_DECIMALS: usize = 17;
