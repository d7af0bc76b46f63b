//! `levalab analyze`: everything there is to say about a cam, for other programs.

use crate::failure::Failure;
use levalab_core::Column;
use levalab_format::report::{self, DesignFinding, Report};
use levalab_format::{CamStudy, Design, DesignCure, Outcome, Study, Target, ToldCure, ToldFinding, ToldVerdict};
use levalab_words::Language;
use serde::{Serialize, Serializer};
use std::fmt::Write;

#[derive(Serialize)]
struct Answer {
    verdict: ToldVerdict<Found>,
    summary: InOrder<report::Range>,
    least_convex: Option<report::Place>,
    tightest_hollow: Option<report::Place>,
    inflections: Vec<f64>,
    columns: InOrder<Vec<f64>>,
    /// The second cam of a pair.
    #[serde(skip_serializing_if = "Option::is_none")]
    conjugate: Option<Box<Answer>>,
    /// What the follower drives.
    #[serde(skip_serializing_if = "Option::is_none")]
    application: Option<Applied>,
}

/// What comes of an application.
#[derive(Serialize)]
struct Applied {
    kind: &'static str,
    figures: InOrder<f64>,
    outputs: InOrder<OutputRange>,
    columns: InOrder<Vec<f64>>,
    target_of: &'static str,
    targets: Vec<Hit>,
}

#[derive(Serialize)]
struct OutputRange {
    unit: &'static str,
    #[serde(flatten)]
    range: report::Range,
    #[serde(skip_serializing_if = "Option::is_none")]
    per_cycle: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    per_second: Option<f64>,
}

#[derive(Serialize)]
struct Hit {
    theta: f64,
    time: f64,
    value: f64,
    found: f64,
    error: f64,
}

#[derive(Serialize)]
struct Found {
    #[serde(flatten)]
    told: ToldFinding,
    cure: Option<ToldCure>,
    cures: Vec<ToldCure>,
    /// That no size puts it right, and what does.
    #[serde(skip_serializing_if = "Option::is_none")]
    advice: Option<String>,
}

/// An object whose fields keep their order.
struct InOrder<T>(Vec<(&'static str, T)>);

impl<T: Serialize> Serialize for InOrder<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// Verdict, summary and columns; what is not finite is null.
pub fn json(study: &Study, language: Language) -> Result<String, Failure> {
    let second = study.second().map(|cam| Box::new(answer(cam, language)));
    let answer = Answer { conjugate: second, application: applied(study), ..answer(study.first(), language) };
    serde_json::to_string(&answer).map(|text| text + "\n").map_err(|_| Failure::no_output(language))
}

fn answer(cam: &CamStudy, language: Language) -> Answer {
    let (design, report) = (cam.design(), cam.report());
    let each = report.findings.iter().zip(cam.cures());
    let findings = each.map(|(finding, cures)| found(design, finding, cures, language));
    let verdict = ToldVerdict::new(report.level, levalab_words::headline(language, report), findings.collect());
    let columns = InOrder(cam.columns());
    let Report { summary, least_convex, tightest_hollow, inflections, .. } = report.clone();
    Answer {
        verdict,
        summary: InOrder(summary),
        least_convex,
        tightest_hollow,
        inflections,
        columns,
        conjugate: None,
        application: None,
    }
}

/// The columns, those of a second cam after those of the first, and those of an application last; what is not finite is `inf` or `-inf`.
pub fn csv(study: &Study) -> String {
    let (design, analysis) = (study.design(), study.first().analysis());
    let mut columns: Vec<(String, Vec<f64>)> = named(study.first().columns(), "");
    if let Some(second) = study.second() {
        // Both cams turn together: one θ serves.
        columns.extend(named(second.columns(), "conjugate_").into_iter().skip(1));
    }
    if let Some(set) = &design.application {
        let outputs = set.application.outputs.iter();
        columns.extend(outputs.map(|output| (output.id.to_owned(), set.column(design, analysis, output))));
    }
    for (name, values) in &mut columns {
        // A radius of curvature has no scale to compare with, since it may be infinite.
        if !name.contains("rho") {
            // Compared with one degree: the pressure angle of a flat face is 0 but for rounding, so its own maximum gives no scale.
            let size = if name.ends_with(Column::PressureAngle.name()) { 90.0 } else { 0.0 };
            without_rounding(values, size);
        }
    }
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    let mut text = names.join(",") + "\n";
    let rows = columns.first().map_or(0, |(_, values)| values.len());
    for row in 0..rows {
        for (k, (_, values)) in columns.iter().enumerate() {
            let comma = if k == 0 { "" } else { "," };
            // As in JSON: the fewest digits that read back. Writing to memory cannot fail.
            let _ = write!(text, "{comma}{:?}", values[row]);
        }
        text.push('\n');
    }
    text
}

/// Makes 0 of what is rounding compared with the maximum of its column, or with a size that its quantity has by its nature.
fn without_rounding(values: &mut [f64], size: f64) {
    /// Sums of a dozen terms leave some 10⁻¹⁵ of the largest one.
    const ROUNDING: f64 = 1e-13;
    let largest = values.iter().fold(size, |most, value| most.max(value.abs()));
    for value in values.iter_mut().filter(|value| value.abs() <= ROUNDING * largest) {
        *value = 0.0;
    }
}

fn applied(study: &Study) -> Option<Applied> {
    let (design, analysis) = (study.design(), study.first().analysis());
    let set = design.application.as_ref()?;
    let Outcome { outputs, figures, targets } = study.outcome()?;
    let omega = design.omega();
    let theta = analysis.column(Column::Theta).unwrap_or_default();
    let time = ("time", theta.iter().map(|theta| theta / omega).collect());
    let values = set.application.outputs.iter().map(|output| (output.id, set.column(design, analysis, output)));
    let range = |found: levalab_format::OutputRange| {
        let unit = design.length_unit.unit_of(found.output.magnitude);
        (
            found.output.id,
            OutputRange { unit, range: found.range, per_cycle: found.per_cycle, per_second: found.per_second },
        )
    };
    let hit = |Target { theta, time, value, found, error }| Hit { theta, time, value, found, error };
    Some(Applied {
        kind: set.application.id,
        figures: InOrder(figures.into_iter().map(|(figure, value)| (figure.id, value)).collect()),
        columns: InOrder([time].into_iter().chain(values).collect()),
        outputs: InOrder(outputs.into_iter().map(range).collect()),
        target_of: set.main().id,
        targets: targets.into_iter().map(hit).collect(),
    })
}

fn named(columns: Vec<(&str, Vec<f64>)>, prefix: &str) -> Vec<(String, Vec<f64>)> {
    columns.into_iter().map(|(name, values)| (format!("{prefix}{name}"), values)).collect()
}

fn found(design: &Design, finding: &DesignFinding, cures: Vec<DesignCure>, language: Language) -> Found {
    let told = |cure: DesignCure| {
        let message = levalab_words::cure(language, design, finding, &cure.remedy);
        ToldCure::new(cure, message)
    };
    let (cures, advice): (Vec<DesignCure>, Vec<DesignCure>) =
        cures.into_iter().partition(|cure| !cure.edits.is_empty());
    let advice = advice.first().map(|cure| levalab_words::cure(language, design, finding, &cure.remedy));
    let cures: Vec<ToldCure> = cures.into_iter().map(told).collect();
    let told = ToldFinding::new(finding, levalab_words::finding(language, design, finding));
    Found { told, cure: cures.first().cloned(), cures, advice }
}
