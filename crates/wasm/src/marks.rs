//! What the diagram of s shows of the data of free laws.

use levalab_format::{MarkKind, Study, marks};
use wasm_bindgen::prelude::*;

/// Points of tables, ordinates of Bézier curves and knots of splines, seven numbers each: 0 point, 1 ordinate or 2 knot; segment; item; where
/// from the segment's start, and in the cycle; height; how much higher the curve lies there. Empty for what is no design.
#[wasm_bindgen]
pub fn data_marks(design: &JsValue) -> Vec<f64> {
    let Ok(study) = Study::open(&levalab_edge::value(design), 1) else { return Vec::new() };
    let numbers = marks(study.design(), study.first().cam()).into_iter().flat_map(|mark| {
        let kind = match mark.kind {
            MarkKind::Point => 0.0,
            MarkKind::Ordinate => 1.0,
            MarkKind::Knot => 2.0,
        };
        [kind, mark.segment as f64, mark.item as f64, mark.at, mark.theta, mark.height, mark.residual]
    });
    numbers.collect()
}
