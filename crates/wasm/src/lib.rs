//! The browser edge of LevaLab: converts, calls, copies out. No mathematics and no words of its own.
//!
//! One call a change ([`Lab::open`]); columns are copied out as typed arrays, an instant into an array that the page keeps.
//! The shapes that cross are those of `web/types.d.ts`. A design file crosses as its bytes, so that the page refuses what the command
//! refuses; all other JSON is read by the browser.

mod application;
mod compare;
mod diagrams;
mod edit;
mod instant;
mod lab;
mod marks;
mod mechanism;
mod numbers;
mod pair;
mod pasted;
mod report;
mod sheet;

pub use lab::Lab;

use levalab_core::Tie;
use levalab_edge::{Failure, language, object, value};
use levalab_format::Design;
use levalab_format::link::{self, LinkError};
use serde::Serialize;
use serde_json::Value;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
import type { ChartStyle, ColumnName, Cure, Design, Diagram, Edit, Language, NumberReading, Opened, OpenedLink, Pairs, PlotArea, Read, Room, TableText, TieKey } from "../types.d.ts";
"#;

/// The room for a second cam tied in one way: a good value, and between which values it has its place (no greatest for a distance).
#[derive(Serialize)]
struct PageRoom {
    value: f64,
    least: f64,
    most: Option<f64>,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Read {
    Design(Box<Design>),
    Error(Failure),
}

/// What an address holds: a design and what is to be said about how it came, or why it does not open; nothing when
/// there is no link in it.
#[derive(Default, Serialize)]
struct OpenedLink {
    #[serde(skip_serializing_if = "Option::is_none")]
    design: Option<Design>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<Failure>,
}

/// The design of a share link, given as the whole address or by itself.
///
/// # Errors
/// Never: a link that does not open is an answer.
#[wasm_bindgen(unchecked_return_type = "OpenedLink")]
pub fn open_link(
    address: &str,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    let language = language(words);
    object(&match link::open(address) {
        Ok(link::Opened { design, from_query, .. }) => OpenedLink {
            design: Some(design),
            note: from_query.then(|| levalab_words::link_from_query(language)),
            error: None,
        },
        Err(LinkError::Empty) => OpenedLink::default(),
        Err(error) => {
            let message = levalab_words::link_error(language, &error);
            OpenedLink { error: Some(Failure { path: String::new(), message }), ..OpenedLink::default() }
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
    object(&match Design::from_value(&value(design)) {
        Ok(design) => Read::Design(Box::new(design)),
        Err(error) => Read::Error(Failure::of(language(words), &error)),
    })
}

/// The design of a design file, from its bytes: read as the command reads it.
///
/// # Errors
/// Never: what is no design is an answer.
#[wasm_bindgen(unchecked_return_type = "Read")]
pub fn open_file(
    bytes: &[u8],
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    object(&match Design::from_bytes(bytes) {
        Ok(design) => Read::Design(Box::new(design)),
        Err(error) => Read::Error(Failure::of(language(words), &error)),
    })
}

/// The room that a design leaves for a second cam tied by `distance`, `angle` or `base_radius`; nothing when there is none, or
/// the first cam is no good.
///
/// # Errors
/// Never: no room is an answer.
#[wasm_bindgen(unchecked_return_type = "Room | null")]
pub fn room_for_second(
    design: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "TieKey")] key: &str,
) -> Result<JsValue, JsError> {
    let mut given = value(design);
    let (tie, radius) = tie_of(&mut given, key);
    let room = Design::from_value(&given).and_then(|design| design.room_for_second(tie, radius));
    let finite = |value: f64| value.is_finite().then_some(value);
    object(&room.ok().flatten().map(|room| PageRoom {
        value: room.tie.value(),
        least: room.least,
        most: finite(room.most),
    }))
}

/// A kind of tie by its key, and the radius of the second roller. A pair that cannot be is asked about as well: it is taken out, and
/// only that radius counts.
pub(crate) fn tie_of(design: &mut Value, key: &str) -> (Tie, Option<f64>) {
    let pair = design.as_object_mut().and_then(|design| design.remove("conjugate"));
    let radius =
        pair.and_then(|pair| ["roller_radius", "face_radius"].into_iter().find_map(|key| pair.get(key)?.as_f64()));
    let tie = match key {
        "distance" => Tie::Distance(0.0),
        "angle" => Tie::Angle(0.0),
        _ => Tie::BaseRadius(0.0),
    };
    (tie, radius)
}
