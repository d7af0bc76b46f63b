//! A design in another unit.

use crate::Read;
use levalab_edge::{Failure, language, object};
use levalab_format::{Design, LengthUnit, SpeedUnit};
use wasm_bindgen::prelude::*;

/// The same cam with its lengths in another unit (`in`), or its speed (`rpm`).
///
/// # Errors
/// When there is no such unit. A design that is no good in it is an answer.
#[wasm_bindgen(unchecked_return_type = "Read")]
pub fn in_unit(
    #[wasm_bindgen(unchecked_param_type = "Design")] design: &JsValue,
    unit: &str,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    let length = LengthUnit::ALL.into_iter().find(|known| known.symbol() == unit);
    let speed = SpeedUnit::ALL.into_iter().find(|known| known.symbol(LengthUnit::default()) == unit);
    let found = Design::from_value(&levalab_edge::value(design)).and_then(|design| match (length, speed) {
        (Some(unit), _) => design.in_unit(unit).map(Some),
        (None, Some(unit)) => design.in_speed_unit(unit).map(Some),
        (None, None) => Ok(None),
    });
    object(&match found {
        Ok(Some(design)) => Read::Design(Box::new(design)),
        Ok(None) => return Err(JsError::new("no such unit")),
        Err(error) => Read::Error(Failure::of(language(words), &error)),
    })
}
