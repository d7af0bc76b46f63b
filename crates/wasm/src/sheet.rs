//! The sheet on which requirements are drawn.

use crate::diagrams::{paint, style_of};
use levalab_chart::Diagram;
use levalab_core::Column;
use levalab_edge::value;
use levalab_format::Study;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// Steps of a turn in which a joined curve is drawn.
const STEPS: usize = 360;

/// Room above the highest requirement, to draw one that is higher, and below the base circle, for its handles: parts of the height.
const ABOVE: f64 = 0.3;
const BELOW: f64 = 0.04;

/// Draws the sheet for requirements of the `heights` given: over empty axes, or over the displacement of a joined design. Shows exactly the
/// heights `held` (low and high) when there are two, and otherwise all there is, with room to draw. Says where the plot is.
///
/// # Errors
/// When the style lacks a number, or the canvas cannot be drawn on.
#[wasm_bindgen(unchecked_return_type = "PlotArea")]
pub fn draw_sheet(
    canvas: HtmlCanvasElement,
    #[wasm_bindgen(unchecked_param_type = "Design | null")] design: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "ChartStyle")] style: &JsValue,
    heights: &[f64],
    held: &[f64],
) -> Result<JsValue, JsError> {
    let (style, _) = style_of(style)?;
    let study = Study::open(&value(design), STEPS).ok();
    let top = study.as_ref().and_then(|study| study.first().report().range(Column::S)).map(|range| range.max);
    let (low, high) = match *held {
        [low, high] => (low, high),
        _ => {
            let low = heights.iter().copied().fold(0.0, f64::min);
            let high = heights.iter().copied().fold(low, f64::max);
            // A curve that swings high above what is asked for is shown too.
            let high = (high + ABOVE * (high - low)).max(top.map_or(high, |top| top * (1.0 + BELOW)));
            let high = if high > low { high } else { low + 1.0 };
            (low - BELOW * (high - low), high)
        }
    };
    let drawn = study.as_ref().map(|study| (study.first().cam(), study.first().analysis()));
    paint(canvas, &Diagram::sheet(drawn, low, high), &style)
}
