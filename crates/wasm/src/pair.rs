//! Why a design has no second cam. For the module that is loaded on demand.

use crate::tie_of;
use levalab_edge::language;
use levalab_format::Design;
use wasm_bindgen::prelude::*;

/// What fails in the nearest that there is to a second cam tied by `distance`, `angle` or `base_radius`; nothing when there is no room for any.
#[wasm_bindgen]
pub fn why_no_second(
    design: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "TieKey")] key: &str,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Option<String> {
    let mut value = levalab_edge::value(design);
    let (tie, radius) = tie_of(&mut value, key);
    let design = Design::from_value(&value).ok()?;
    let (tie, report) = design.nearest_second(tie, radius)?;
    Some(levalab_words::no_second(language(words), &design, tie, &report))
}
