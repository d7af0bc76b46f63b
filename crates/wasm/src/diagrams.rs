//! Diagrams on the page: plotters-canvas where they are looked at, SVG where they are printed.

use crate::lab::{Beside, Lab};
use levalab_chart::{Diagram, PlotArea, Quantity, SUBPIXELS, Style, Timing, colour};
use levalab_edge::object;
use levalab_format::CamStudy;
use levalab_numbers::write::DecimalSign;
use plotters::prelude::IntoDrawingArea;
use plotters_canvas::CanvasBackend;
use serde::Serialize;
use serde_json::Value;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

/// How the page wants a diagram: `ChartStyle` of `web/types.d.ts`.
struct PageStyle(Value);

#[derive(Serialize)]
struct PageArea {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    x_min: f64,
    x_max: f64,
    y_min: f64,
    y_max: f64,
}

#[wasm_bindgen]
impl Lab {
    /// Draws a diagram of the current cam over the whole of a canvas; says where the plot is.
    ///
    /// # Errors
    /// When there is no cam yet, no such diagram or style, or the canvas cannot be drawn on.
    #[wasm_bindgen(unchecked_return_type = "PlotArea")]
    pub fn draw(
        &self,
        canvas: HtmlCanvasElement,
        #[wasm_bindgen(unchecked_param_type = "Diagram")] diagram: &str,
        #[wasm_bindgen(unchecked_param_type = "ChartStyle")] style: &JsValue,
        second: Option<bool>,
    ) -> Result<JsValue, JsError> {
        let (diagram, style) = prepare(self, diagram, style, second)?;
        paint(canvas, &diagram, &style)
    }

    /// The same diagram as SVG text.
    ///
    /// # Errors
    /// When there is no cam yet, or no such diagram or style.
    pub fn svg(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Diagram")] diagram: &str,
        #[wasm_bindgen(unchecked_param_type = "ChartStyle")] style: &JsValue,
        second: Option<bool>,
    ) -> Result<String, JsError> {
        let (diagram, style) = prepare(self, diagram, style, second)?;
        Ok(levalab_chart::svg(&diagram, &style).0)
    }
}

/// Draws over the whole of a canvas; says where the plot is.
pub(crate) fn paint(canvas: HtmlCanvasElement, diagram: &Diagram, style: &Style) -> Result<JsValue, JsError> {
    let context = context_of(&canvas)?;
    let backend =
        CanvasBackend::with_canvas_object(canvas).ok_or_else(|| JsError::new("the canvas cannot be drawn on"))?;
    let area = backend.into_drawing_area();
    let scale = 1.0 / f64::from(SUBPIXELS);
    context.save();
    let drawn = context.set_transform(scale, 0.0, 0.0, scale, 0.0, 0.0).and_then(|()| {
        context.set_line_join("round");
        let set_dash = |lengths: &[f64]| {
            let lengths: js_sys::Array = lengths.iter().copied().map(JsValue::from_f64).collect();
            // Refused only for lengths that are negative or not finite, which a style's are not.
            let _ = context.set_line_dash(&lengths);
        };
        levalab_chart::draw(&area, diagram, style, set_dash).map_err(|error| JsValue::from_str(&error.to_string()))
    });
    context.restore();
    match drawn {
        Ok(area) => object(&PageArea::from(area)),
        Err(error) => Err(JsError::new(&error.as_string().unwrap_or_default())),
    }
}

/// A style from the page's own, and whether it is by time.
pub(crate) fn style_of(style: &JsValue) -> Result<(Style, bool), JsError> {
    let wanted = PageStyle(levalab_edge::value(style));
    let style = wanted.style().ok_or_else(|| JsError::new(NO_STYLE))?;
    Ok((style, wanted.is("per_second")))
}

const NO_STYLE: &str = "the style lacks a number";

fn prepare(lab: &Lab, diagram: &str, style: &JsValue, second: Option<bool>) -> Result<(Diagram, Style), JsError> {
    let current = lab.drawn(second)?;
    let quantity = Quantity::by_name(diagram).ok_or_else(|| JsError::new("no such diagram"))?;
    let wanted = PageStyle(levalab_edge::value(style));
    let style = wanted.style().ok_or_else(|| JsError::new(NO_STYLE))?;
    let per_second = wanted.is("per_second");
    let seen = |study: &CamStudy| {
        if per_second { Timing::PerSecond(study.design().omega()) } else { Timing::PerRadian }
    };
    let mut all = Vec::with_capacity(lab.beside.len() + 1);
    let mut others = Vec::with_capacity(lab.beside.len());
    for Beside { study: other, colour, dash } in &lab.beside {
        let other = other.first();
        if alike(quantity, current, other) {
            all.push((other.cam(), other.analysis(), seen(other)));
            others.push((*colour, dash.clone()));
        }
    }
    all.push((current.cam(), current.analysis(), seen(current)));
    let mut diagram = Diagram::among(quantity, &all).ok_or_else(|| JsError::new("nothing to draw"))?;
    if let Some(margin) = wanted.number("margin") {
        diagram = diagram.with_face(current.analysis(), margin);
    }
    Ok((diagram, Style { others, ..style }))
}

/// True when the values of both can be put on one axis: they exist and have the same unit.
fn alike(quantity: Quantity, current: &CamStudy, other: &CamStudy) -> bool {
    let (one, two) = (current.design(), other.design());
    let lengths = one.length_unit == two.length_unit;
    quantity.applies(other.cam())
        && one.kind.travel() == two.kind.travel()
        && match quantity {
            Quantity::PressureAngle => true,
            Quantity::Rho | Quantity::Contact => lengths,
            Quantity::S | Quantity::V | Quantity::A | Quantity::J => {
                one.is_oscillating() == two.is_oscillating() && (lengths || one.is_oscillating())
            }
        }
}

fn context_of(canvas: &HtmlCanvasElement) -> Result<CanvasRenderingContext2d, JsError> {
    let context = canvas.get_context("2d").ok().flatten();
    let context = context.and_then(|context| context.dyn_into().ok());
    context.ok_or_else(|| JsError::new("the canvas has no 2d context"))
}

impl PageStyle {
    fn number(&self, key: &str) -> Option<f64> {
        self.0[key].as_f64()
    }

    fn is(&self, key: &str) -> bool {
        self.0[key] == true
    }

    /// None when a number is missing.
    fn style(&self) -> Option<Style> {
        let usual = Style::default();
        let colour_of = |key: &str, other| self.0[key].as_str().and_then(colour).unwrap_or(other);
        let dash = self.0["dash"].as_array().into_iter().flatten().filter_map(Value::as_f64);
        Some(Style {
            width: self.number("width")?,
            height: self.number("height")?,
            pixel_ratio: self.number("pixel_ratio")?,
            font: self.0["font"].as_str().map_or(usual.font, str::to_owned),
            font_size: self.number("font_size")?,
            ink: colour_of("ink", usual.ink),
            muted: colour_of("muted", usual.muted),
            grid: colour_of("grid", usual.grid),
            background: colour_of("background", usual.background),
            curve: colour_of("curve", usual.curve),
            limit: colour_of("limit", usual.limit),
            mark: colour_of("mark", usual.mark),
            dash: dash.collect(),
            others: Vec::new(),
            stroke: self.number("stroke")?,
            x_labels: self.is("x_labels"),
            decimal_sign: if self.is("decimal_comma") { DecimalSign::Comma } else { DecimalSign::Point },
        })
    }
}

impl From<PlotArea> for PageArea {
    fn from(area: PlotArea) -> Self {
        let PlotArea { left, top, width, height, x_min, x_max, y_min, y_max } = area;
        Self { left, top, width, height, x_min, x_max, y_min, y_max }
    }
}
