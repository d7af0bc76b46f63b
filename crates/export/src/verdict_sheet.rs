//! The verdict as a table: the headline, every finding with its cures, and the extremes.

use crate::Subject;
use crate::sheets::{Cell, Row};
use crate::table::Measure;
use crate::words::Word;
use levalab_core::{Column, profiles_coincide};
use levalab_format::CamStudy;
use levalab_format::report::Report;
use levalab_words::Signs;

/// Its rows. The verdict does not hang on the step, so none is asked for.
pub(crate) fn verdict(subject: &Subject) -> Vec<Row> {
    let mut rows = Vec::new();
    for (k, cam) in subject.cams().enumerate() {
        if k > 0 {
            rows.extend([Row::gap(), Row::head([levalab_words::second_cam(subject.language).to_owned()])]);
            if profiles_coincide(subject.cam(), cam.cam()) {
                rows.push(Row::of([levalab_words::profiles_coincide(subject.language).into()]));
            }
        }
        rows.extend(of_cam(subject, cam));
    }
    rows
}

fn of_cam(subject: &Subject, cam: &CamStudy) -> Vec<Row> {
    let (design, language) = (subject.design(), subject.language);
    let place = if subject.travels() { design.length_unit.symbol() } else { "θ, °" };
    let said = |word: Word| match word {
        Word::At => format!("{} ({place})", word.said(language)),
        _ => word.said(language).to_owned(),
    };
    let (report, cures) = (cam.report(), cam.cures());
    let mut rows = vec![
        Row::head([said(Word::Verdict)]),
        Row::of([levalab_words::level(language, report.level).into()]),
        Row::of([Cell::Text(levalab_words::headline(language, report))]),
        Row::gap(),
    ];
    if !report.findings.is_empty() {
        let heads = [Word::Verdict, Word::Finding, Word::At, Word::Value, Word::Limit, Word::Cure];
        rows.push(Row::head(heads.map(said)));
    }
    for (finding, cures) in report.findings.iter().zip(&cures) {
        let cures: Vec<String> =
            cures.iter().map(|cure| levalab_words::cure(language, design, finding, &cure.remedy)).collect();
        rows.push(Row::of([
            levalab_words::level(language, finding.level).into(),
            Cell::Text(levalab_words::finding(language, design, finding)),
            finding.theta.into(),
            Cell::maybe(finding.value),
            Cell::maybe(finding.limit),
            Cell::Text(cures.join(" ")),
        ]));
    }
    if !report.findings.is_empty() {
        rows.push(Row::gap());
    }
    rows.push(Row::head([Word::Quantity, Word::Least, Word::At, Word::Greatest, Word::At].map(said)));
    rows.extend(report.summary.iter().filter_map(|(name, range)| {
        // A ρ without bounds has no extremes; the rows of the curvature follow.
        if range.min.is_infinite() && range.max.is_infinite() {
            return None;
        }
        let head = measure(name)?.head(subject);
        Some(Row::of([Cell::Text(head), range.min.into(), range.min_at.into(), range.max.into(), range.max_at.into()]))
    }));
    rows.extend(curvature(subject, report));
    rows
}

/// Where the profile is hollow in part: the sharpest convex place, the tightest hollow, and where one passes into the other.
fn curvature(subject: &Subject, report: &Report) -> Vec<Row> {
    let (design, language) = (subject.design(), subject.language);
    let mut rows = Vec::new();
    if report.tightest_hollow.is_none() {
        return rows;
    }
    let rho = Signs::of(design.notation).plain("ρ");
    let unit = design.length_unit.symbol();
    for (word, found) in [(Word::LeastConvex, report.least_convex), (Word::TightestHollow, report.tightest_hollow)] {
        let head = format!("{} {rho} ({unit})", word.said(language));
        rows.extend(found.map(|found| Row::of([Cell::Text(head), found.value.into(), found.at.into()])));
    }
    if !report.inflections.is_empty() {
        let place = if subject.travels() { format!("x, {unit}") } else { "θ, °".to_owned() };
        let head = Cell::Text(format!("{} ({place})", Word::Inflections.said(language)));
        rows.push(Row::of([head].into_iter().chain(report.inflections.iter().map(|&theta| theta.into()))));
    }
    rows
}

/// The quantity of a column of the summary.
fn measure(name: &str) -> Option<Measure> {
    let column = Column::ALL.into_iter().find(|column| column.name() == name)?;
    Some(match column {
        Column::Theta => Measure::Theta,
        Column::S => Measure::S,
        Column::V => Measure::V,
        Column::A => Measure::A,
        Column::J => Measure::J,
        Column::PressureAngle => Measure::PressureAngle,
        Column::Rho => Measure::Rho,
        Column::RhoPitch => Measure::RhoPitch,
        Column::X => Measure::X,
        Column::Y => Measure::Y,
        Column::PitchX => Measure::PitchX,
        Column::PitchY => Measure::PitchY,
        Column::Contact => Measure::Contact,
        Column::OuterX => Measure::OuterX,
        Column::OuterY => Measure::OuterY,
    })
}
