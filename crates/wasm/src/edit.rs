//! Edits of the design on screen, which need not make a cam.

use crate::Read;
use levalab_edge::{Failure, language, object, value};
use levalab_format::{Edit, apply_to_value};
use wasm_bindgen::prelude::*;

/// The design with edits made, whether or not it makes a cam; or why one of them is not possible.
///
/// # Errors
/// Never: a refusal is an answer.
#[wasm_bindgen(unchecked_return_type = "Read")]
pub fn edit(
    #[wasm_bindgen(unchecked_param_type = "Design")] design: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Edit[]")] edits: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    let edited = Edit::list(&value(edits)).and_then(|edits| apply_to_value(value(design), &edits));
    object(&match edited {
        Ok(design) => Read::Design(Box::new(design)),
        Err(error) => Read::Error(Failure::of(language(words), &error)),
    })
}
