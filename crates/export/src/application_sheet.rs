//! The application as a table: its parameters, what comes out at most, the points to hit, and every row.

use crate::sheets::{Cell, Row, tidied};
use crate::table::Measure;
use crate::words::Word;
use crate::{Step, Subject};
use levalab_core::Analysis;
use levalab_core::application::Magnitude;
use levalab_format::ApplicationDesign;

/// Its rows; none without an application.
pub(crate) fn application(subject: &Subject, step: Step) -> Option<Vec<Row>> {
    let set = subject.design().application.as_ref()?;
    let language = subject.language;
    let outcome = subject.study.outcome()?;
    let rows_of = subject.study.first().with_rows(step.count());
    let unit = |magnitude: Magnitude| subject.design().length_unit.unit_of(magnitude);
    let place = if subject.travels() { subject.design().length_unit.symbol() } else { "θ, °" };
    let said = |word: Word| match word {
        Word::At => format!("{} ({place})", word.said(language)),
        _ => word.said(language).to_owned(),
    };
    let title = levalab_words::application_title(language, set.application);
    let mut rows =
        vec![Row::head([title]), Row::gap(), Row::head([Word::Magnitude, Word::Value, Word::Unit].map(said))];
    let magnitude = |id: &'static str, symbol: &str, value: f64, unit: &'static str| {
        let name = format!("{} {symbol}", levalab_words::part_head(language, id));
        Row::of([Cell::Text(name), value.into(), unit.into()])
    };
    let settings = set.application.parameters.iter().zip(set.values);
    rows.extend(settings.map(|(given, value)| magnitude(given.key, given.symbol, value, unit(given.magnitude))));
    let figures = outcome.figures.iter();
    rows.extend(figures.map(|(figure, value)| magnitude(figure.id, figure.symbol, *value, unit(figure.magnitude))));
    rows.push(Row::gap());
    rows.push(Row::head([Word::Quantity, Word::Least, Word::At, Word::Greatest, Word::At, Word::PerCycle].map(said)));
    rows.extend(outcome.outputs.iter().map(|found| {
        let range = found.range;
        let told = [range.min, range.min_at, range.max, range.max_at].map(Cell::from);
        let name = head(subject, found.output.id, found.output.symbol, found.output.magnitude);
        Row::of([Cell::Text(name)].into_iter().chain(told).chain([Cell::maybe(found.per_cycle)]))
    }));
    if !outcome.targets.is_empty() {
        let main = set.main();
        let of_main = format!(" ({})", unit(main.magnitude));
        rows.push(Row::gap());
        let heads = [said(Word::At), Measure::Time.head(subject)];
        let values = [Word::Wanted, Word::Found, Word::Error].map(|word| said(word) + &of_main);
        rows.push(Row::head(heads.into_iter().chain(values)));
        rows.extend(outcome.targets.iter().map(|target| {
            Row::of([target.theta, target.time, target.value, target.found, target.error].map(Cell::from))
        }));
    }
    rows.push(Row::gap());
    rows.extend(by_angle(subject, set, rows_of.analysis()));
    Some(rows)
}

/// The outputs at every row, each under its name.
pub(crate) fn columns(subject: &Subject, set: &ApplicationDesign, analysis: &Analysis) -> Vec<(String, Vec<f64>)> {
    let each = set.application.outputs.iter().map(|output| {
        let name = head(subject, output.id, output.symbol, output.magnitude);
        (name, tidied(set.column(subject.design(), analysis, output), false))
    });
    each.collect()
}

fn by_angle(subject: &Subject, set: &ApplicationDesign, analysis: &Analysis) -> Vec<Row> {
    let of = |measure: Measure| {
        let values = measure.values(subject, analysis)?;
        Some((measure.head(subject), tidied(values, false)))
    };
    let mut table: Vec<(String, Vec<f64>)> = [Measure::Theta, Measure::Time].into_iter().filter_map(of).collect();
    table.extend(columns(subject, set, analysis));
    let rows = table.first().map_or(0, |(_, values)| values.len());
    let head = Row::head(table.iter().map(|(name, _)| name.clone()));
    let row = |k: usize| Row::of(table.iter().map(|(_, values)| values[k].into()));
    [head].into_iter().chain((0..rows).map(row)).collect()
}

fn head(subject: &Subject, id: &'static str, symbol: &str, magnitude: Magnitude) -> String {
    let name = levalab_words::part_head(subject.language, id);
    format!("{name} {symbol} ({})", subject.design().length_unit.unit_of(magnitude))
}
