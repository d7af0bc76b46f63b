//! Tables as rows of cells, whatever the file they end in.

use crate::application_sheet::{application, columns};
use crate::table::{Measure, Table};
use crate::verdict_sheet::verdict;
use crate::words::{Word, field};
use crate::{Step, Subject};
use levalab_core::{FOLLOWERS, LAWS, Law, Parameter, Quantity};
use levalab_words::Language;
use serde_json::Value;

/// A table with its name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sheet {
    pub name: &'static str,
    pub rows: Vec<Row>,
}

/// A row of a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row {
    /// It names what stands below.
    pub head: bool,
    pub cells: Vec<Cell>,
}

/// What stands in a cell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Number(f64),
    Text(String),
}

impl Row {
    /// A row that names columns.
    pub fn head(cells: impl IntoIterator<Item = String>) -> Self {
        Self { head: true, cells: cells.into_iter().map(Cell::Text).collect() }
    }

    /// A row of values.
    pub fn of(cells: impl IntoIterator<Item = Cell>) -> Self {
        Self { head: false, cells: cells.into_iter().collect() }
    }

    /// Between two parts of a table.
    pub fn gap() -> Self {
        Self::of([])
    }
}

impl Cell {
    /// Nothing.
    pub fn empty() -> Self {
        Self::Text(String::new())
    }

    /// A number, when there is one.
    pub fn maybe(value: Option<f64>) -> Self {
        value.map_or_else(Self::empty, Self::from)
    }
}

impl From<f64> for Cell {
    /// What is endless, ρ of a straight profile, is no number in any spreadsheet.
    fn from(value: f64) -> Self {
        if value.is_finite() { Self::Number(value) } else { Self::Text("∞".to_owned()) }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

/// A table of the cam; none when nothing in it applies, as the pitch curve of a flat face.
pub(crate) fn sheet(subject: &Subject, table: Table, step: Step) -> Option<Sheet> {
    let name = name(table).said(subject.language);
    let rows = match table {
        Table::Design => design(subject),
        Table::Verdict => verdict(subject),
        Table::Application => application(subject, step)?,
        _ => by_angle(subject, table, step)?,
    };
    Some(Sheet { name, rows })
}

fn name(table: Table) -> Word {
    match table {
        Table::Everything | Table::Motion => Word::Motion,
        Table::Design => Word::Design,
        Table::Polar => Word::Polar,
        Table::Cartesian => Word::Cartesian,
        Table::Pitch => Word::PitchCurve,
        Table::Verdict => Word::Verdict,
        Table::Application => Word::Application,
    }
}

/// A row for each angle, the last repeating the first.
fn by_angle(subject: &Subject, which: Table, step: Step) -> Option<Vec<Row>> {
    // A cam that travels has no centre.
    if which == Table::Polar && subject.travels() {
        return None;
    }
    let mut table: Vec<(String, Vec<f64>)> = Vec::new();
    for (k, cam) in subject.cams().enumerate() {
        let cam = cam.with_rows(step.count());
        let analysis = cam.analysis();
        // Both cams turn together: one θ serves.
        let shared = |measure: Measure| k > 0 && matches!(measure, Measure::Theta | Measure::Time);
        for &measure in which.measures().iter().filter(|measure| !shared(**measure)) {
            let Some(values) = measure.values(subject, analysis) else { continue };
            let head = measure.head(subject);
            let head = if k == 0 { head } else { levalab_words::of_second_cam(subject.language, &head) };
            table.push((head, tidy(measure, values)));
        }
        if let Some(set) = subject.design().application.as_ref().filter(|_| k == 0 && which == Table::Everything) {
            table.extend(columns(subject, set, analysis));
        }
    }
    // θ and what is beside it whatever the table, are no table.
    let rows = table.first().filter(|_| table.len() > 1)?.1.len();
    let head = Row::head(table.iter().map(|(head, _)| head.clone()));
    let row = |k: usize| Row::of(table.iter().map(|(_, values)| values[k].into()));
    Some([head].into_iter().chain((0..rows).map(row)).collect())
}

/// Values without the digits that only rounding makes: twelve count, and what is nothing beside the rest of its column is zero.
/// A radius of curvature has no such scale, since it may be endless.
fn tidy(measure: Measure, values: Vec<f64>) -> Vec<f64> {
    tidied(values, matches!(measure, Measure::Rho | Measure::RhoPitch))
}

/// The same for a column that may be `endless`, or not.
pub(crate) fn tidied(mut values: Vec<f64>, endless: bool) -> Vec<f64> {
    const NOTHING: f64 = 1e-13;
    let greatest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for value in &mut values {
        let nothing = !endless && value.abs() <= NOTHING * greatest;
        *value = if nothing { 0.0 } else { format!("{value:.11e}").parse().unwrap_or(*value) };
    }
    values
}

/// The fields of the design file one below the other, then the segments.
fn design(subject: &Subject) -> Vec<Row> {
    let language = subject.language;
    let said = |word: Word| word.said(language).to_owned();
    let mut rows = vec![Row::head([said(Word::Magnitude), said(Word::Value), said(Word::Unit)])];
    let file = subject.design().to_value();
    let own = |key: &str| file.get(key).and_then(Value::as_object);
    for key in ["title", "length_unit"] {
        rows.push(Row::of([field(key, language).into(), cell(&file[key], language), Cell::empty()]));
    }
    if let Some(speed) = own("speed") {
        let unit = speed.get("unit").and_then(Value::as_str).unwrap_or_default();
        rows.push(Row::of([field("speed", language).into(), cell(&speed["value"], language), unit.into()]));
    }
    let follower = levalab_words::follower(language, subject.design().follower);
    for part in ["cam", "follower", "conjugate"] {
        if part == "follower" {
            rows.push(Row::of([field(part, language).into(), follower.into(), Cell::empty()]));
        }
        let Some(fields) = own(part) else { continue };
        if part == "conjugate" {
            rows.push(Row::of([field(part, language).into()]));
        }
        let told = fields.iter().filter(|(key, _)| !["motion", "contact"].contains(&key.as_str()));
        rows.extend(told.map(|(key, value)| {
            let unit = if value.is_number() { unit(key, subject) } else { "" };
            Row::of([field(key, language).into(), cell(value, language), unit.into()])
        }));
    }
    let segments = segments(subject, &file["segments"]);
    if segments.len() > 1 {
        rows.push(Row::gap());
        rows.extend(segments);
    }
    rows
}

/// A row for each segment; what a law takes besides stands at the end, each under its name.
fn segments(subject: &Subject, segments: &Value) -> Vec<Row> {
    const TOLD: [&str; 3] = ["law", "beta", "rise"];
    let language = subject.language;
    let segments: &[Value] = segments.as_array().map_or(&[], Vec::as_slice);
    let mut others: Vec<&str> = Vec::new();
    for key in segments.iter().filter_map(Value::as_object).flat_map(|segment| segment.keys()) {
        if !TOLD.contains(&key.as_str()) && !others.contains(&key.as_str()) {
            others.push(key);
        }
    }
    let travel = subject.unit(0, false);
    let place = if subject.travels() { subject.design().length_unit.symbol() } else { "°" };
    let said = |word: Word| word.said(language);
    let heads = [
        said(Word::Segment).to_owned(),
        said(Word::Law).to_owned(),
        format!("{} ({place})", said(Word::From)),
        format!("{} ({place})", said(Word::Beta)),
        format!("{} ({travel})", said(Word::Rise)),
    ];
    let heads = heads.into_iter().chain(others.iter().map(|key| field(key, language).to_owned()));
    let mut rows = vec![Row::head(heads)];
    let borders = subject.cam().program.borders();
    for (number, (segment, from)) in segments.iter().zip(borders).enumerate() {
        let law = segment["law"].as_str().unwrap_or_default();
        let law = Law::by_id(law)
            .map_or(law.to_owned(), |law| levalab_words::capital(levalab_words::law_alone(language, law)));
        let told = [
            Cell::Number(number as f64 + 1.0),
            Cell::Text(law),
            subject.design().place(*from).into(),
            cell(&segment["beta"], language),
            segment.get("rise").map_or(Cell::Number(0.0), |rise| cell(rise, language)),
        ];
        let others = others.iter().map(|key| segment.get(*key).map_or_else(Cell::empty, |value| cell(value, language)));
        rows.push(Row::of(told.into_iter().chain(others)));
    }
    rows
}

fn cell(value: &Value, language: Language) -> Cell {
    match value {
        Value::Number(number) => Cell::maybe(number.as_f64()),
        Value::String(text) => field(text, language).into(),
        Value::Null => Cell::empty(),
        other => Cell::Text(other.to_string()),
    }
}

/// The unit of a field of a design file.
fn unit(key: &str, subject: &Subject) -> &'static str {
    let parameters =
        FOLLOWERS.iter().flat_map(|kind| kind.parameters).chain(LAWS.iter().flat_map(|law| law.parameters));
    let known = |parameter: &&Parameter| parameter.key == key;
    match parameters.into_iter().find(known).map(|parameter| parameter.quantity) {
        Some(Quantity::Angle) => "°",
        Some(Quantity::Height) if subject.design().is_oscillating() => "°",
        Some(Quantity::Length | Quantity::Span | Quantity::Height) => subject.design().length_unit.symbol(),
        None if key == "angle" => "°",
        None if ["base_radius", "breadth", "length", "distance"].contains(&key) => {
            subject.design().length_unit.symbol()
        }
        Some(Quantity::Ratio) | None => "",
    }
}
