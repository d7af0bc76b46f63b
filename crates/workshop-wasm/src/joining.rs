//! A design joined from requirements: dwells, straight stretches and points.

use levalab_edge::{Failure, language, object, value};
use levalab_format::{Design, joined};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A joined design, and a sentence for the law chosen in each gap.
#[derive(Serialize)]
struct PageJoined {
    design: Design,
    choices: Vec<String>,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Answer {
    Joined(Box<PageJoined>),
    Error(Failure),
}

/// Joins the requirements of an object with the fields that `levalab auto` reads.
///
/// # Errors
/// Never: requirements that cannot be joined are an answer.
#[wasm_bindgen]
pub fn join_requirements(wanted: &JsValue, words: &str) -> Result<JsValue, JsError> {
    let language = language(words);
    object(&match joined(&value(wanted)) {
        Ok(joined) => {
            let choices = levalab_words::join_choices(language, &joined.design, &joined.choices, joined.taste);
            Answer::Joined(Box::new(PageJoined { design: joined.design, choices }))
        }
        Err(error) => Answer::Error(Failure::of(language, &error)),
    })
}
