//! The part that the browser modules of LevaLab have in common: plain JavaScript values in and out, the language of the
//! page, and the sentence for a design that is refused.

mod figures;
mod plain;

pub use figures::figures;
pub use plain::value;

use levalab_format::DesignError;
use levalab_words::Language;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A refusal: the path of the refused entry in the design, and a sentence in the language of the page.
#[derive(Serialize)]
pub struct Failure {
    /// Path of the entry as in a design file; empty when the refusal concerns the whole.
    pub path: String,
    /// The sentence to show.
    pub message: String,
}

impl Failure {
    /// The refusal of a design, in words.
    #[must_use]
    pub fn of(language: Language, error: &DesignError) -> Self {
        Self { path: error.path.to_string(), message: levalab_words::design_error(language, error) }
    }
}

/// The language of a tag such as `es`; English if the tag is unknown.
#[must_use]
pub fn language(tag: &str) -> Language {
    Language::from_tag(tag).unwrap_or_default()
}

/// A plain JavaScript object with the fields of `value`.
///
/// # Errors
/// Returns an error if the serialisation of `value` fails, which it does for no type of these crates.
pub fn object<T: Serialize>(value: &T) -> Result<JsValue, JsError> {
    Ok(value.serialize(&serde_wasm_bindgen::Serializer::json_compatible())?)
}
