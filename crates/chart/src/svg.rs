//! The same drawing as SVG text.

use crate::frame::{Frame, PlotArea};
use crate::paint::{Drawing, Medium, lay_out, pattern};
use crate::sketch::{Dash, Mark, Sketch};
use crate::{Diagram, Style};
use plotters::prelude::IntoDrawingArea;
use plotters_svg::SVGBackend;
use std::cell::RefCell;
use std::fmt::Write;

/// What plotters-svg closes a drawing with.
const END: &str = "</svg>\n";

/// A diagram as an SVG drawing of `style.width` × `style.height` CSS pixels, whatever the pixel ratio.
#[must_use]
pub fn svg(diagram: &Diagram, style: &Style) -> (String, PlotArea) {
    let style = &Style { pixel_ratio: 1.0, ..style.clone() };
    let (frame, sketch) = lay_out(diagram, style);
    let mut text = head(&frame, style);
    for marks in sketch.marks.chunk_by(|a, b| a.dash() == b.dash()) {
        let body = body(&frame, &sketch, marks, style);
        let lengths = pattern(marks[0].dash(), &frame, style);
        if lengths.is_empty() || marks[0].dash() == Dash::Full {
            text.push_str(&body);
        } else {
            let lengths: Vec<String> = lengths.iter().map(f64::to_string).collect();
            // Writing into a String cannot fail.
            let _ = write!(text, "<g stroke-dasharray=\"{}\">\n{body}</g>\n", lengths.join(" "));
        }
    }
    text.push_str(END);
    (text, frame.area(style))
}

fn head(frame: &Frame, style: &Style) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" \
         stroke-linejoin=\"round\" font-variant-numeric=\"tabular-nums\">\n",
        style.width, style.height, frame.width, frame.height
    )
}

/// Marks as elements. Dashes are attributes that plotters-svg does not write, so the caller puts them around.
fn body(frame: &Frame, sketch: &Sketch, marks: &[Mark], style: &Style) -> String {
    let mut text = String::new();
    let area = SVGBackend::with_string(&mut text, (frame.width.unsigned_abs(), frame.height.unsigned_abs()))
        .into_drawing_area();
    let drawing = Drawing { frame, sketch, marks, style, medium: Medium::SVG, set_dash: RefCell::new(|_: &[f64]| {}) };
    let drawn = area.draw(&drawing).and_then(|()| area.present());
    drop(area);
    // Only a file can fail, and this is text in memory.
    debug_assert!(drawn.is_ok(), "text in memory takes everything");
    let from = text.find('\n').map_or(0, |end| end + 1);
    text[from..].strip_suffix(END).unwrap_or(&text[from..]).to_owned()
}
