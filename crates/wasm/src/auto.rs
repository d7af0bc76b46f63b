//! A design from what its machine must do.

use crate::{Failure, language, object, plain, speak};
use levalab_format::{Design, joined};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A design that was joined, and a sentence for each gap.
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

/// Joins the requirements of an object such as `levalab auto` reads.
///
/// # Errors
/// Never: what cannot be joined is an answer.
#[wasm_bindgen]
pub fn join_requirements(wanted: &JsValue, words: &str) -> Result<JsValue, JsError> {
    let language = language(words);
    object(&match joined(&plain::value(wanted)) {
        Ok(joined) => {
            let say = |choice| levalab_words::join_choice(language, &joined.design, choice, joined.taste);
            let choices = joined.choices.iter().map(say).collect();
            Answer::Joined(Box::new(PageJoined { design: joined.design, choices }))
        }
        Err(error) => Answer::Error(speak(language, &error)),
    })
}
