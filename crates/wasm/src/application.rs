//! What a follower drives: the list for a menu, the figures of a design's application, and its diagrams. For the module that is loaded on demand.

use crate::diagrams::{paint, style_of};
use levalab_chart::{Diagram, Style, svg};
use levalab_core::application::{APPLICATIONS, Magnitude};
use levalab_edge::{language, object};
use levalab_format::report::Range;
use levalab_format::{ApplicationDesign, LengthUnit, Outcome, Study};
use levalab_words::{Language, application_title, part_head, part_name};
use serde::Serialize;
use std::f64::consts::TAU;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
import type { ApplicationEntry, ApplicationReport } from "../types.d.ts";
"#;

/// Rows that are drawn.
const STEPS: usize = 720;

#[derive(Serialize)]
struct Entry {
    id: &'static str,
    title: String,
    parameters: Vec<Named>,
    outputs: Vec<Named>,
}

/// A parameter, an output or a figure.
#[derive(Serialize)]
struct Named {
    id: &'static str,
    symbol: &'static str,
    name: String,
    unit: &'static str,
    /// The usual value of a parameter, in the units of the design; the value of a figure.
    value: Option<f64>,
}

#[derive(Serialize)]
struct Report {
    /// Which output the targets are of.
    main: usize,
    outputs: Vec<OutputReport>,
    figures: Vec<Named>,
    targets: Vec<TargetReport>,
}

#[derive(Serialize)]
struct OutputReport {
    id: &'static str,
    symbol: &'static str,
    name: String,
    unit: &'static str,
    #[serde(flatten)]
    range: Range,
    per_cycle: Option<f64>,
    per_second: Option<f64>,
}

#[derive(Serialize)]
struct TargetReport {
    theta: f64,
    time: f64,
    value: f64,
    found: f64,
    error: f64,
}

/// Every application with its names, and units beside lengths in `unit`.
///
/// # Errors
/// Never: the lists are plain.
#[wasm_bindgen(unchecked_return_type = "ApplicationEntry[]")]
pub fn applications(
    unit: &str,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    let language = language(words);
    let unit = LengthUnit::ALL.into_iter().find(|other| other.symbol() == unit).unwrap_or_default();
    let named = |id: &'static str, symbol: &'static str, magnitude: Magnitude, value: Option<f64>| {
        let angle = magnitude == Magnitude::Angle;
        let value = value.map(|value| if angle { value.to_degrees() } else { value });
        Named { id, symbol, name: part_head(language, id), unit: unit.unit_of(magnitude), value }
    };
    let entry = |application: &&levalab_core::application::Application| Entry {
        id: application.id,
        title: application_title(language, application),
        parameters: application.parameters.iter().map(|p| named(p.key, p.symbol, p.magnitude, p.default)).collect(),
        outputs: application.outputs.iter().map(|o| named(o.id, o.symbol, o.magnitude, None)).collect(),
    };
    object(&APPLICATIONS.iter().map(entry).collect::<Vec<_>>())
}

/// A design's application at work.
#[wasm_bindgen]
pub struct Driven {
    study: Study,
    set: ApplicationDesign,
    outcome: Outcome,
}

#[wasm_bindgen]
impl Driven {
    /// The application of a good design; nothing when it has none.
    pub fn of(#[wasm_bindgen(unchecked_param_type = "Design")] design: &JsValue) -> Option<Driven> {
        let study = Study::open(&levalab_edge::value(design), STEPS).ok()?;
        let (set, outcome) = (study.design().application.clone()?, study.outcome()?);
        Some(Self { study, set, outcome })
    }

    /// Extremes of each output, figures, and every target with its error.
    ///
    /// # Errors
    /// Never: figures are plain.
    #[wasm_bindgen(unchecked_return_type = "ApplicationReport")]
    pub fn report(&self, #[wasm_bindgen(unchecked_param_type = "Language")] words: &str) -> Result<JsValue, JsError> {
        object(&self.told(language(words)))
    }

    /// Every output at θ (degrees, or length of a cam that travels), in their order.
    pub fn at(&self, place: f64) -> Vec<f64> {
        let program = &self.study.first().cam().program;
        let theta = if program.is_cyclic() { place.to_radians().rem_euclid(TAU) } else { place };
        let (values, motion) = (self.set.core_values(), program.at(theta));
        let each = self.outcome.outputs.iter();
        each.map(|found| found.told(found.output.of(&values, motion, self.study.design().omega()))).collect()
    }

    /// Draws an output with the points that it is to hit over the whole of a canvas; says where the plot is.
    ///
    /// # Errors
    /// When there is no such output or style, or the canvas cannot be drawn on.
    #[wasm_bindgen(unchecked_return_type = "PlotArea")]
    pub fn draw(
        &self,
        canvas: HtmlCanvasElement,
        output: usize,
        #[wasm_bindgen(unchecked_param_type = "ChartStyle")] style: &JsValue,
    ) -> Result<JsValue, JsError> {
        let (diagram, style) = self.prepare(output, style)?;
        paint(canvas, &diagram, &style)
    }

    /// The same diagram as SVG text.
    ///
    /// # Errors
    /// When there is no such output or style.
    pub fn svg(
        &self,
        output: usize,
        #[wasm_bindgen(unchecked_param_type = "ChartStyle")] style: &JsValue,
    ) -> Result<String, JsError> {
        let (diagram, style) = self.prepare(output, style)?;
        Ok(svg(&diagram, &style).0)
    }
}

impl Driven {
    fn prepare(&self, output: usize, style: &JsValue) -> Result<(Diagram, Style), JsError> {
        let wanted = self.set.application.outputs.get(output).ok_or_else(|| JsError::new("no such output"))?;
        let targets: Vec<(f64, f64)> = match output == self.set.output {
            true => self.outcome.targets.iter().map(|target| (target.theta, target.value)).collect(),
            false => Vec::new(),
        };
        let (values, omega) = (self.set.core_values(), self.study.design().omega());
        let first = self.study.first();
        let diagram = Diagram::of_output(wanted, &values, first.cam(), first.analysis(), omega, &targets);
        let (style, timed) = style_of(style)?;
        Ok((if timed { diagram.against_time(omega) } else { diagram }, style))
    }

    fn told(&self, language: Language) -> Report {
        let unit = |magnitude: Magnitude| self.study.design().length_unit.unit_of(magnitude);
        let name = |id: &'static str| part_name(language, id).to_owned();
        let outputs = self.outcome.outputs.iter().map(|found| OutputReport {
            id: found.output.id,
            symbol: found.output.symbol,
            name: name(found.output.id),
            unit: unit(found.output.magnitude),
            range: found.range,
            per_cycle: found.per_cycle,
            per_second: found.per_second,
        });
        let figures = self.outcome.figures.iter().map(|(figure, value)| Named {
            id: figure.id,
            symbol: figure.symbol,
            name: part_head(language, figure.id),
            unit: unit(figure.magnitude),
            value: Some(*value),
        });
        let targets = self.outcome.targets.iter().map(|target| TargetReport {
            theta: target.theta,
            time: target.time,
            value: target.value,
            found: target.found,
            error: target.error,
        });
        Report {
            main: self.set.output,
            outputs: outputs.collect(),
            figures: figures.collect(),
            targets: targets.collect(),
        }
    }
}
