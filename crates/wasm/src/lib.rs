//! The browser edge of LevaLab: converts, calls, copies out. No mathematics and no words of its own.
//!
//! One call a change ([`Lab::open`]); columns are copied out as typed arrays, an instant into an array that the page keeps.
//! The shapes that cross are those of `web/types.d.ts`. Text that is JSON stays outside: the browser has a parser of its own, and the
//! tables of a second one would be a fifth of this module.

mod catalogue;
mod compare;
mod diagrams;
mod instant;
mod lab;
mod plain;
mod report;

pub use lab::Lab;

use levalab_format::{Design, DesignError, link};
use levalab_words::Language;
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
import type { Catalogue, ChartStyle, ColumnName, Cure, Design, Diagram, Language, Opened, PlotArea, Read } from "../types.d.ts";
"#;

/// What is wrong, where, in the language of the page.
#[derive(Serialize)]
pub struct Failure {
    path: String,
    message: String,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Read {
    Design(Box<Design>),
    Error(Failure),
}

/// Everything that forms are built from.
///
/// # Errors
/// Never: the lists are plain.
#[wasm_bindgen(unchecked_return_type = "Catalogue")]
pub fn catalogue() -> Result<JsValue, JsError> {
    object(&catalogue::Catalogue::new())
}

/// The design of a share link, given with or without its `#`.
///
/// # Errors
/// Never: a link that does not open is an answer.
#[wasm_bindgen(unchecked_return_type = "Read")]
pub fn open_link(
    fragment: &str,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    let language = language(words);
    object(&match link::decode(link::within(fragment)) {
        Ok(design) => Read::Design(Box::new(design)),
        Err(error) => {
            Read::Error(Failure { path: String::new(), message: levalab_words::link_error(language, &error) })
        }
    })
}

/// A design from the object that a design file holds: checked, and in its canonical form.
///
/// # Errors
/// Never: what is no design is an answer.
#[wasm_bindgen(unchecked_return_type = "Read")]
pub fn read_design(
    design: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    object(&match Design::from_value(&plain::value(design)) {
        Ok(design) => Read::Design(Box::new(design)),
        Err(error) => Read::Error(speak(language(words), &error)),
    })
}

fn speak(language: Language, error: &DesignError) -> Failure {
    Failure { path: error.path.to_string(), message: levalab_words::design_error(language, error) }
}

fn language(code: &str) -> Language {
    Language::from_tag(code).unwrap_or_default()
}

/// A plain JavaScript object.
fn object<T: Serialize>(value: &T) -> Result<JsValue, JsError> {
    Ok(value.serialize(&serde_wasm_bindgen::Serializer::json_compatible())?)
}
