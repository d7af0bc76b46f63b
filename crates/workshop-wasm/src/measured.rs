//! Measured data: the columns of a text, and the points that a segment's table takes from them.

use levalab_core::law::MAX_POINTS;
use levalab_edge::{Failure, language, object};
use levalab_format::Design;
use levalab_format::limits::MAX_TABLE_POINTS_OF_VERSION_1;
use levalab_format::measured::{Curve, Ends, Measured, MeasuredProblem, Reduced, measured_ends, reduce};
use levalab_words::{Language, measured_note, measured_problem};
use serde::Serialize;
use serde_json::Value;
use wasm_bindgen::prelude::*;

/// Numbers by which a column is recognised.
const SAMPLE: usize = 3;

/// The residual that is aimed at when none is asked for, as a part of the lift.
const USUAL_RESIDUAL: f64 = 1e-4;

/// What a text of measured data holds, and what is taken of it.
#[derive(Serialize)]
struct PageMeasured {
    columns: Vec<PageColumn>,
    /// Indices of the columns of angle and displacement.
    angle: usize,
    lift: usize,
    /// Points of the whole curve.
    all: usize,
    /// The most that may be taken.
    most: usize,
    /// What is taken: the points of the table, how far its curve is from the points that were measured, and where.
    points: Vec<[f64; 2]>,
    residual: f64,
    at: f64,
    /// What was done to the points.
    note: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<Failure>,
}

#[derive(Serialize)]
struct PageColumn {
    index: usize,
    heading: String,
    unit: String,
    sample: Vec<f64>,
}

/// What the page asks for.
struct Order {
    /// Columns, those that are most likely unless chosen.
    columns: [Option<usize>; 2],
    /// So many points, or as many as a residual asks for.
    count: Option<usize>,
    within: Option<f64>,
}

impl Order {
    fn of(order: &Value) -> Self {
        let number = |key: &str| order.get(key).and_then(Value::as_f64);
        let whole = |key: &str| number(key).filter(|value| *value >= 0.0).map(|value| value as usize);
        Self { columns: [whole("angle"), whole("lift")], count: whole("count"), within: number("within") }
    }
}

/// Reads measured data for a segment of a design. The order may name columns (`angle`, `lift`), and a number of points (`count`) or
/// a residual (`within`).
///
/// # Errors
/// Never: what cannot be read is an answer.
#[wasm_bindgen(unchecked_return_type = "Measured")]
pub fn measured(
    bytes: &[u8],
    #[wasm_bindgen(unchecked_param_type = "MeasuredOrder")] order: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Design")] design: &JsValue,
    segment: usize,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    let ends =
        Design::from_value(&levalab_edge::value(design)).map_or(Ends::Free, |design| measured_ends(&design, segment));
    object(&answer(bytes, &Order::of(&levalab_edge::value(order)), ends, language(words)))
}

fn answer(bytes: &[u8], order: &Order, ends: Ends, language: Language) -> PageMeasured {
    let refused =
        |problem: &MeasuredProblem| Some(Failure { path: String::new(), message: measured_problem(language, problem) });
    let measured = match Measured::read_bytes(bytes) {
        Ok(measured) => measured,
        Err(problem) => return PageMeasured { error: refused(&problem), ..PageMeasured::nothing() },
    };
    if measured.is_empty() {
        return PageMeasured { error: refused(&MeasuredProblem::TooFewPoints { found: 0 }), ..PageMeasured::nothing() };
    }
    let guess = measured.guess();
    let [angle, lift] = [order.columns[0].unwrap_or(guess[0]), order.columns[1].unwrap_or(guess[1])];
    let columns = measured.columns.iter().enumerate().filter(|(_, column)| column.is_number);
    let columns = columns.map(|(index, column)| PageColumn {
        index,
        heading: column.heading.clone(),
        unit: column.unit.clone(),
        sample: measured.sample(index).take(SAMPLE).collect(),
    });
    let page = PageMeasured { columns: columns.collect(), angle, lift, ..PageMeasured::nothing() };
    let curve = match measured.curve(angle, lift) {
        Ok(curve) => curve,
        Err(problem) => return PageMeasured { error: refused(&problem), ..page },
    };
    let curve = curve.completed();
    let most = MAX_POINTS.min(curve.points.len());
    let Reduced { points, residual, at } = reduced(&curve, ends, order, most);
    let (all, note) = (curve.points.len(), measured_note(language, &curve));
    PageMeasured { all, most, points, residual, at, note, ..page }
}

/// The points asked for; of a short curve all unless asked for otherwise.
fn reduced(curve: &Curve, ends: Ends, order: &Order, most: usize) -> Reduced {
    let heights = curve.points.iter().map(|point| point[1]);
    let lift = heights.clone().fold(f64::MIN, f64::max) - heights.fold(f64::MAX, f64::min);
    let count = order.count.unwrap_or(most).min(most);
    let is_short = most <= MAX_TABLE_POINTS_OF_VERSION_1;
    let usual = if order.count.is_some() || is_short { 0.0 } else { USUAL_RESIDUAL * lift };
    reduce(&curve.points, ends, count, order.within.unwrap_or(usual))
}

impl PageMeasured {
    fn nothing() -> Self {
        Self {
            columns: Vec::new(),
            angle: 0,
            lift: 0,
            all: 0,
            most: 0,
            points: Vec::new(),
            residual: 0.0,
            at: 0.0,
            note: String::new(),
            error: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(text: &str, order: &Value) -> PageMeasured {
        answer(text.as_bytes(), &Order::of(order), Ends::Joined, Language::En)
    }

    fn turn(lines: u32) -> String {
        let line = |k: u32| {
            let at = 360.0 * f64::from(k) / f64::from(lines - 1);
            format!("{at} {}\n", 8.0 - 8.0 * at.to_radians().cos())
        };
        (0..lines).map(line).collect()
    }

    #[test]
    fn a_short_curve_is_offered_whole_and_a_long_one_reduced() {
        for (lines, whole) in [(6, true), (128, true), (361, false), (2000, false)] {
            let page = page(&turn(lines), &Value::Null);
            assert_eq!((page.points.len() == page.all, page.all), (whole, lines as usize));
        }
        assert!(page(" \n", &Value::Null).error.is_some());
    }

    #[test]
    fn points_are_as_many_as_asked_for_or_as_the_residual_needs() {
        let text = turn(2000);
        let usual = page(&text, &Value::Null);
        assert!(usual.residual.abs() <= 16e-4 && usual.points.len() < 40, "{} points", usual.points.len());
        let counted = page(&text, &serde_json::json!({ "count": 12 }));
        assert_eq!(counted.points.len(), 12);
        let close = page(&text, &serde_json::json!({ "within": 1e-6 }));
        assert!(close.residual.abs() <= 1e-6 && close.points.len() > usual.points.len());
        assert_eq!(page(&text, &serde_json::json!({ "count": 5000 })).points.len(), 1024);
    }

    #[test]
    fn a_line_that_cannot_be_read_is_in_the_answer() {
        let message = |text: &str| page(text, &Value::Null).error.map(|error| error.message);
        assert!(message("0 0\n60 five5\n360 0").is_some_and(|message| message.starts_with("Line 2 ")));
        assert_eq!(message("0 0\n60 5\n360 0"), None);
    }
}
