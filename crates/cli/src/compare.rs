//! `levalab compare` and `levalab tournament`: cams side by side, as tables.

use crate::failure::Failure;
use crate::input;
use levalab_core::Level;
use levalab_format::{Contender, Design, Figures, tournament};
use levalab_words::{Language, Signs};
use std::cmp::Ordering;

/// What a tournament is ranked by.
#[derive(Clone, Copy, clap::ValueEnum)]
pub enum Rank {
    /// Verdict, then peak acceleration.
    Verdict,
    /// Peak |v|.
    V,
    /// Peak |a|.
    A,
    /// Peak |j|.
    J,
    /// Greatest |φ|.
    Phi,
    /// Smallest base radius that passes.
    Rb,
}

/// Between columns.
const GAP: &str = "  ";

/// A line for each design.
pub fn designs(files: &[String], language: Language) -> Result<String, Failure> {
    let mut rows = Vec::new();
    for file in files {
        let study = input::study(file, 1, language)?;
        let (design, figures) = (study.design(), study.figures());
        if rows.is_empty() {
            rows.push(heads(["", "R_b"], design));
        }
        let name = if design.title.is_empty() { file.clone() } else { design.title.clone() };
        let radius = length(design, design.kind.travel().is_none().then_some(design.base_radius), language);
        rows.push(line([name, radius], design, &figures, language));
    }
    Ok(table(&rows))
}

/// A line for each law.
pub fn laws(file: &str, rank: Rank, language: Language) -> Result<String, Failure> {
    let design = input::design(file, language)?;
    let mut contenders = tournament(&design).map_err(|error| Failure::design(&error, file, language))?;
    contenders.sort_by(|one, other| order(rank, one, other));
    let mut rows = vec![heads(["", "R_b ≥"], &design)];
    rows.extend(contenders.iter().map(|contender| {
        let name = contender.law.map_or("·", |law| levalab_words::law(language, law)).to_owned();
        let radius = length(&design, contender.smallest_base_radius, language);
        line([name, radius], &design, &contender.figures, language)
    }));
    Ok(table(&rows))
}

fn order(rank: Rank, one: &Contender, other: &Contender) -> Ordering {
    let key = |contender: &Contender| {
        let Figures { level, peaks, steepest, .. } = contender.figures;
        match rank {
            Rank::Verdict => (level, peaks[1]),
            Rank::V => (Level::Acceptable, peaks[0]),
            Rank::A => (Level::Acceptable, peaks[1]),
            Rank::J => (Level::Acceptable, peaks[2]),
            Rank::Phi => (Level::Acceptable, steepest),
            Rank::Rb => (Level::Acceptable, contender.smallest_base_radius.unwrap_or(f64::INFINITY)),
        }
    };
    let (one, other) = (key(one), key(other));
    one.0.cmp(&other.0).then(one.1.total_cmp(&other.1))
}

/// In the symbols of the first design.
fn heads(first: [&str; 2], design: &Design) -> Vec<String> {
    let signs = Signs::of(design.notation);
    let rest = ["s max", "|v|", "|a|", "|j|", "|V|", "|A|", "|J|", "φ min", "φ max", "ρ min", "face", "verdict"];
    let head = |ours: &str| match ours.split_once(' ') {
        Some((symbol, more)) => format!("{} {more}", signs.plain(symbol)),
        None => match ours.strip_prefix('|').and_then(|ours| ours.strip_suffix('|')) {
            Some(symbol) => format!("|{}|", signs.plain(symbol)),
            None => signs.plain(ours),
        },
    };
    first.into_iter().chain(rest).map(head).collect()
}

fn line(first: [String; 2], design: &Design, figures: &Figures, language: Language) -> Vec<String> {
    let number = |value: f64| language.number(value);
    let travel = if design.is_oscillating() {
        number(figures.lift) + "°"
    } else {
        length(design, Some(figures.lift), language)
    };
    let verdict = match figures.level {
        Level::Acceptable => "●",
        Level::LowSpeed => "▲",
        Level::Unacceptable => "■",
    };
    let word = levalab_words::level(language, figures.level);
    let peaks = figures.peaks.into_iter().chain(figures.timed_peaks).map(number);
    let [low, high] = figures.pressure_angle.map(|angle| language.angle(angle));
    let ends = [low, high, length(design, figures.least_radius, language), length(design, figures.face, language)];
    first.into_iter().chain([travel]).chain(peaks).chain(ends).chain([format!("{verdict} {word}")]).collect()
}

fn length(design: &Design, value: Option<f64>, language: Language) -> String {
    value.map_or_else(|| "–".to_owned(), |value| format!("{} {}", language.number(value), design.length_unit.symbol()))
}

/// Columns as wide as what is in them, figures to the right, the name and the last column to the left. A column that is empty but
/// for its head is left out.
fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.first().map_or(0, Vec::len);
    let told = |&column: &usize| column == 0 || rows.iter().skip(1).any(|row| row[column] != "–");
    let shown: Vec<(usize, usize)> = (0..columns)
        .filter(told)
        .map(|column| (column, rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0)))
        .collect();
    let write = |row: &Vec<String>| {
        let cells = shown.iter().map(|&(column, width)| match column {
            0 => format!("{:<width$}", row[column]),
            _ if column + 1 == columns => row[column].clone(),
            _ => format!("{:>width$}", row[column]),
        });
        cells.collect::<Vec<_>>().join(GAP).trim_end().to_owned() + "\n"
    };
    rows.iter().map(write).collect()
}
