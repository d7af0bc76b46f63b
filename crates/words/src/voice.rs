//! What a language has to be able to say.

use crate::{Language, Units};
use levalab_core::{Column, FindingKind, Law, Level};
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Measure, Problem, Remedy};

/// Why a file cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileProblem {
    /// There is none of that name.
    Absent,
    /// It is a folder.
    Folder,
    /// It may not be read.
    Forbidden,
    /// Reading it failed.
    Unreadable,
    /// What was to be written could not be.
    Unwritable,
}

/// A language. Sentences begin with a capital and end with a full stop; names are as within a sentence.
pub(crate) trait Voice {
    fn second_cam(&self) -> &'static str;
    fn level(&self, level: Level) -> &'static str;
    fn headline(&self, report: &Report) -> String;
    fn finding(&self, finding: &DesignFinding, units: Units) -> String;
    fn cure(&self, finding: &DesignFinding, remedy: &Remedy, units: Units) -> String;
    fn problem(&self, problem: &Problem) -> String;
    fn link(&self, error: &LinkError) -> String;
    fn link_from_query(&self) -> &'static str;
    fn too_long(&self, refusal: TooLong) -> String;
    fn file(&self, problem: FileProblem) -> &'static str;
}

/// A finding with its figures written out.
pub(crate) struct Figures {
    /// Where it is worst.
    pub at: String,
    /// Where it begins and ends.
    pub span: Option<(String, String)>,
    /// Where it is besides, for something between two places.
    pub other: String,
    /// How many places it has.
    pub count: usize,
    /// How much, with its unit.
    pub value: String,
    /// The limit, with its unit.
    pub limit: String,
}

impl Figures {
    pub fn of(finding: &DesignFinding, units: Units, language: Language) -> Self {
        let at = |theta: f64| match units.travels {
            true => units.length(theta, language),
            false => language.angle(theta.rem_euclid(360.0)),
        };
        let (value, limit) = (finding.value.unwrap_or(f64::NAN), finding.limit.unwrap_or(f64::NAN));
        let written = |number: f64| match finding.kind {
            FindingKind::Jump(order) => units.travel(number, order, language),
            FindingKind::BelowBase => units.travel(number, 0, language),
            FindingKind::PressureAngle => language.angle(number),
            FindingKind::FaceOvertaken | FindingKind::Doubtful | FindingKind::NotProved(_) => language.number(number),
            FindingKind::Cusp
            | FindingKind::Undercut
            | FindingKind::GrooveUndercut
            | FindingKind::ConcaveFlat
            | FindingKind::SelfCrossing
            | FindingKind::ArmCutsCam
            | FindingKind::PivotInsideCam
            | FindingKind::ContactPastPivot => units.length(number, language),
        };
        let reached = finding.kind == FindingKind::PressureAngle;
        Self {
            at: at(finding.theta),
            span: finding.interval.map(|[from, to]| (at(from), at(to))),
            other: at(finding.places.last().copied().unwrap_or(finding.theta)),
            count: finding.places.len(),
            value: if reached { Units::angle_beside(value, limit, language) } else { written(value) },
            limit: written(limit),
        }
    }
}

/// A number of a design with the unit that it is known to have.
pub(crate) fn measured(value: f64, measure: Measure, language: Language) -> String {
    let number = language.exact(value);
    match measure {
        Measure::Degrees => number + "°",
        Measure::Length | Measure::Ratio | Measure::Speed => number,
    }
}

/// True when the follower rests in the whole cycle.
pub(crate) fn rests(report: &Report) -> bool {
    report.range(Column::S).is_some_and(|range| range.min == 0.0 && range.max == 0.0)
}

/// The kinds of finding that a headline names, each once, without the jerk's when there is worse: the gravest first wherever they are, so that
/// the headline does not change with their places.
pub(crate) fn worst_kinds(report: &Report) -> Vec<FindingKind> {
    let mut kinds: Vec<FindingKind> = Vec::new();
    let worst = report.findings.iter().filter(|finding| finding.level == report.level);
    for finding in worst {
        if !kinds.contains(&finding.kind) {
            kinds.push(finding.kind);
        }
    }
    kinds.sort_by_key(|&kind| rank(kind));
    kinds
}

/// The place of a kind in a headline: first what no motion can be, then what no profile can be, then what gets in the way.
fn rank(kind: FindingKind) -> u8 {
    match kind {
        FindingKind::Jump(order) => order,
        FindingKind::Doubtful | FindingKind::NotProved(_) => 4,
        FindingKind::PressureAngle => 5,
        FindingKind::BelowBase => 6,
        FindingKind::Cusp | FindingKind::Undercut | FindingKind::GrooveUndercut | FindingKind::ConcaveFlat => 7,
        FindingKind::PivotInsideCam | FindingKind::FaceOvertaken | FindingKind::ContactPastPivot => 8,
        FindingKind::SelfCrossing => 9,
        FindingKind::ArmCutsCam => 10,
    }
}

/// At how many joints a jump of the jerk forbids high speeds.
pub(crate) fn joints_of_the_jerk(report: &Report) -> usize {
    let jumps = |finding: &&DesignFinding| finding.kind == FindingKind::Jump(3) && finding.level == Level::LowSpeed;
    report.findings.iter().find(jumps).map_or(0, |finding| finding.places.len())
}

/// The segments that take each law, as people count them: from 1.
pub(crate) fn by_law(changes: &[(usize, &'static Law)]) -> Vec<(&'static Law, Vec<usize>)> {
    let mut groups: Vec<(&'static Law, Vec<usize>)> = Vec::new();
    for &(segment, law) in changes {
        match groups.iter_mut().find(|group| group.0 == law) {
            Some(group) => group.1.push(segment + 1),
            None => groups.push((law, vec![segment + 1])),
        }
    }
    groups
}

/// Things in a row: `a, b and c`.
pub(crate) fn row(items: &[String], and: &str) -> String {
    match items {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} {and} {last}", first.join(", ")),
    }
}

/// Words in a row.
pub(crate) fn row_of(words: &[&str], and: &str) -> String {
    row(&words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>(), and)
}
