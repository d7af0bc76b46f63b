//! The tournament: one program moved by every law that fits.

use levalab_core::LAWS;
use levalab_edge::{figures, object, value};
use levalab_format::{Design, Study, by_law, tournament};
use wasm_bindgen::prelude::*;

/// The contenders of a design's tournament, fifteen numbers each: the place of the law in the catalogue (−1 for the design
/// as it is), the smallest base radius (NaN without one), and the figures of [`levalab_edge::figures`]. Empty when the
/// design is no cam.
#[wasm_bindgen]
pub fn tournament_of(#[wasm_bindgen(unchecked_param_type = "Design")] design: &JsValue) -> Vec<f64> {
    let contenders = Design::from_value(&value(design)).and_then(|design| tournament(&design)).unwrap_or_default();
    let mut numbers = Vec::new();
    for contender in &contenders {
        let law = contender.law.and_then(|law| LAWS.iter().position(|&other| other == law));
        numbers.push(law.map_or(-1.0, |place| place as f64));
        numbers.push(contender.smallest_base_radius.unwrap_or(f64::NAN));
        numbers.extend(figures(&contender.figures));
    }
    numbers
}

/// A design with one law, given by its place in the catalogue, for every segment that moves.
///
/// # Errors
/// Returns an error if there is no such law or the design is no cam.
#[wasm_bindgen(unchecked_return_type = "Design")]
pub fn design_by_law(
    #[wasm_bindgen(unchecked_param_type = "Design")] design: &JsValue,
    place: usize,
) -> Result<JsValue, JsError> {
    let law = LAWS.get(place).ok_or_else(|| JsError::new("no such law"))?;
    let study = Study::open(&value(design), 1).map_err(|error| JsError::new(&error.path.to_string()))?;
    object(&by_law(study.design(), study.first().cam(), law))
}
