//! Plain JavaScript values as JSON values.
//!
//! A reader of its own for the one shape that crosses inwards: serde's for any shape takes three times the room.

use js_sys::{Array, Object};
use serde_json::{Number, Value};
use wasm_bindgen::prelude::*;

/// How deep objects and lists are read: a design has six levels. Whatever expects less refuses a deeper value at a level that is read,
/// and nothing that a page was given to keep can exhaust the stack.
const MAX_DEPTH: usize = 16;

/// An object, a list, a text, a number or a truth value, with all that is in it. What JSON cannot hold becomes null, and so does what
/// lies deeper than `MAX_DEPTH`.
pub fn value(given: &JsValue) -> Value {
    value_within(given, MAX_DEPTH)
}

fn value_within(given: &JsValue, depth: usize) -> Value {
    if let Some(number) = given.as_f64() {
        Number::from_f64(number).map_or(Value::Null, Value::Number)
    } else if let Some(text) = given.as_string() {
        Value::String(text)
    } else if let Some(truth) = given.as_bool() {
        Value::Bool(truth)
    } else if depth == 0 {
        Value::Null
    } else if let Some(list) = given.dyn_ref::<Array>() {
        list.iter().map(|item| value_within(&item, depth - 1)).collect()
    } else if let Some(object) = given.dyn_ref::<Object>().filter(|_| !given.is_function()) {
        let fields = Object::entries(object);
        let field = |field: JsValue| {
            let pair: Array = field.unchecked_into();
            (pair.get(0).as_string().unwrap_or_default(), value_within(&pair.get(1), depth - 1))
        };
        fields.iter().map(field).collect()
    } else {
        Value::Null
    }
}
