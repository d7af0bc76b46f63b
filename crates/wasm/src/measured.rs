//! Measured data: the columns of a text, and the points that a segment's table takes from them.

use levalab_core::law::MAX_POINTS;
use levalab_edge::{Failure, language, object};
use levalab_format::Design;
use levalab_format::limits::{MAX_MEASURED_POINTS, MAX_TABLE_POINTS_OF_VERSION_1};
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
    /// True when the whole curve can be taken without a question.
    is_plain: bool,
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
    /// True for a text that was pasted: a long one is not taken without a question.
    pasted: bool,
}

impl Order {
    fn of(order: &Value) -> Self {
        let number = |key: &str| order.get(key).and_then(Value::as_f64);
        let whole = |key: &str| number(key).filter(|value| *value >= 0.0).map(|value| value as usize);
        Self {
            columns: [whole("angle"), whole("lift")],
            count: whole("count"),
            within: number("within"),
            pasted: order.get("pasted").is_some_and(|value| *value == true),
        }
    }
}

/// Reads measured data for a segment of a design. The order may name columns (`angle`, `lift`), a number of points (`count`) or a
/// residual (`within`), and say that the text was `pasted`.
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

/// Pairs of numbers of a text in any order, or the line that is none.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Pairs {
    Points(Vec<[f64; 2]>),
    Line(usize),
}

/// The pairs of numbers of a text, a line for each.
///
/// # Errors
/// Never: a line that cannot be read is an answer.
#[wasm_bindgen(unchecked_return_type = "Pairs")]
pub fn pairs(text: &str) -> Result<JsValue, JsError> {
    object(&match Measured::read(text).and_then(|measured| measured.pairs()) {
        Ok(points) => Pairs::Points(points),
        Err(MeasuredProblem::NotNumbers { line } | MeasuredProblem::NoValue { line, .. }) => Pairs::Line(line),
        // More of them than anything takes: beyond the last that is read.
        Err(_) => Pairs::Line(MAX_MEASURED_POINTS + 1),
    })
}

fn answer(bytes: &[u8], order: &Order, ends: Ends, language: Language) -> PageMeasured {
    let refused =
        |problem: &MeasuredProblem| Some(Failure { path: String::new(), message: measured_problem(language, problem) });
    let measured = match Measured::read_bytes(bytes) {
        Ok(measured) => measured,
        Err(problem) => return PageMeasured { error: refused(&problem), ..PageMeasured::nothing() },
    };
    if measured.is_empty() {
        return PageMeasured { is_plain: true, ..PageMeasured::nothing() };
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
    let unasked = if order.pasted { MAX_TABLE_POINTS_OF_VERSION_1 } else { MAX_POINTS };
    let is_plain = measured.is_plain() && curve.points.len() <= unasked;
    let curve = if is_plain { curve } else { curve.completed() };
    let most = MAX_POINTS.min(curve.points.len());
    let Reduced { points, residual, at } = if is_plain { whole(&curve) } else { reduced(&curve, ends, order, most) };
    PageMeasured {
        all: curve.points.len(),
        most,
        is_plain,
        points,
        residual,
        at,
        note: measured_note(language, &curve),
        ..page
    }
}

fn whole(curve: &Curve) -> Reduced {
    Reduced { points: curve.points.clone(), residual: 0.0, at: 0.0 }
}

fn reduced(curve: &Curve, ends: Ends, order: &Order, most: usize) -> Reduced {
    let heights = curve.points.iter().map(|point| point[1]);
    let lift = heights.clone().fold(f64::MIN, f64::max) - heights.fold(f64::MAX, f64::min);
    match (order.count, order.within) {
        (Some(count), _) => reduce(&curve.points, ends, count.min(most), 0.0),
        (None, within) => reduce(&curve.points, ends, most, within.unwrap_or(USUAL_RESIDUAL * lift)),
    }
}

impl PageMeasured {
    fn nothing() -> Self {
        Self {
            columns: Vec::new(),
            angle: 0,
            lift: 0,
            all: 0,
            most: 0,
            is_plain: false,
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
    fn a_short_table_is_taken_at_once_and_a_long_one_that_is_pasted_is_not() {
        let pasted = serde_json::json!({ "pasted": true });
        for (lines, order, plain) in
            [(128, &pasted, true), (129, &pasted, false), (361, &Value::Null, true), (1025, &Value::Null, false)]
        {
            let page = page(&turn(lines), order);
            assert_eq!((page.is_plain, page.all), (plain, lines as usize));
            assert_eq!(page.points.len() == page.all, plain, "{lines} lines: {} points", page.points.len());
        }
        assert!(!page("0 0 1\n60 5 2\n360 0 3", &pasted).is_plain, "three columns are a choice");
        let empty = page(" \n", &pasted);
        assert!(empty.is_plain && empty.points.is_empty() && empty.error.is_none());
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
