//! An analysis in the units of the design: degrees for angles, and for the displacement of a follower that swings.
//!
//! Both the page and the command line show what is here and nothing else.

use crate::Design;
use crate::decimal::Decimal;
use levalab_core::{Analysis, Cam, Column, Cycle, Extremes, Finding, FindingKind, Joint, Level};
use serde::{Serialize, Serializer};

/// What an analysis says, in the units of the design.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The verdict.
    pub level: Level,
    /// What is wrong, by severity, the gravest first, and then by θ.
    pub findings: Vec<DesignFinding>,
    /// Extremes by the name of their column; those that do not apply are absent.
    pub summary: Vec<(&'static str, Range)>,
    /// The minimum of ρ where the profile is convex; none when it is convex nowhere.
    pub least_convex: Option<Place>,
    /// The tightest hollow, as a negative ρ; none when nothing is hollow.
    pub tightest_hollow: Option<Place>,
    /// θ of every inflection of the profile, degrees, in order: there it passes from convex to hollow or back.
    pub inflections: Vec<f64>,
    /// Every joint between smooth pieces, those within laws as well.
    pub joints: Vec<DesignJoint>,
    /// θ of the borders of the segments, degrees, from 0 to 360: one more than there are segments.
    pub borders: Vec<f64>,
}

/// Where a quantity is least and greatest; θ in degrees.
///
/// ρ has no bounds where the profile is straight for an instant; such a bound is infinite, and is written as null, with the place where ρ is infinite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Range {
    /// Least value.
    #[serde(serialize_with = "finite")]
    pub min: f64,
    /// Where it is.
    pub min_at: f64,
    /// Greatest value.
    #[serde(serialize_with = "finite")]
    pub max: f64,
    /// Where it is.
    pub max_at: f64,
}

/// A finite value with its place.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Place {
    /// The value, in the unit of the design.
    pub value: f64,
    /// θ, degrees (or length of travel).
    pub at: f64,
}

impl Place {
    fn of(design: &Design, found: Option<(f64, f64)>) -> Option<Self> {
        found
            .filter(|(value, _)| value.is_finite())
            .map(|(value, at)| Self { value: value + 0.0, at: design.place(at) })
    }
}

/// Something wrong with a cam, in the units of the design.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignFinding {
    /// What is wrong.
    pub kind: FindingKind,
    /// How bad it is in this cam.
    pub level: Level,
    /// Where it is worst, degrees (or length of travel, as all places of a cam that travels).
    pub theta: f64,
    /// Where it begins and ends, degrees, when it is a stretch; the end is beyond 360 when it passes through 0.
    pub interval: Option<[f64; 2]>,
    /// All its places, degrees.
    pub places: Vec<f64>,
    /// How much, in the unit of what is measured; none when there is nothing to measure.
    pub value: Option<f64>,
    /// The limit that it passes.
    pub limit: Option<f64>,
}

/// A joint between smooth pieces of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DesignJoint {
    /// Where it is, degrees.
    pub theta: f64,
    /// The segment that begins there, or within which it lies.
    pub segment: usize,
    /// The lowest of *s*, *v*, *a*, *j* that jumps there.
    pub jump: Option<Column>,
}

impl Report {
    /// What an analysis of the design's cam says.
    #[must_use]
    pub fn of(design: &Design, cam: &Cam, analysis: &Analysis) -> Self {
        Self {
            level: analysis.level,
            findings: analysis.findings.iter().map(|finding| finding_of(design, finding)).collect(),
            summary: summary_of(design, analysis),
            least_convex: Place::of(design, analysis.summary.least_convex),
            tightest_hollow: Place::of(design, analysis.summary.tightest_hollow),
            inflections: analysis.inflections.iter().map(|&theta| design.place(theta)).collect(),
            joints: analysis.joints.iter().map(|joint| joint_of(design, joint)).collect(),
            borders: borders_of(design, cam),
        }
    }

    /// The extremes of a column.
    #[must_use]
    pub fn range(&self, column: Column) -> Option<Range> {
        self.summary.iter().find(|(name, _)| *name == column.name()).map(|(_, range)| *range)
    }
}

/// A column in the units of the design, or nothing when it does not apply to the follower.
#[must_use]
pub fn column(design: &Design, analysis: &Analysis, column: Column) -> Option<Vec<f64>> {
    let values = analysis.column(column)?;
    if column == Column::Theta {
        // From the count and not from the radians, so that 143° is 143.
        let steps = (values.len() - 1).max(1) as f64;
        let whole = design.kind.travel().unwrap_or(360.0);
        return Some((0..values.len()).map(|i| whole * i as f64 / steps).collect());
    }
    let scale = scale_of(design, column);
    // Adding 0 makes 0 of −0.
    Some(values.iter().map(|value| value * scale + 0.0).collect())
}

/// Every column that applies, with its name, in the order of reports.
#[must_use]
pub fn columns(design: &Design, analysis: &Analysis) -> Vec<(&'static str, Vec<f64>)> {
    let each = Column::ALL.into_iter().map(|name| column(design, analysis, name).map(|values| (name.name(), values)));
    each.flatten().collect()
}

/// The word for a verdict in reports.
#[must_use]
pub fn level_name(level: Level) -> &'static str {
    match level {
        Level::Acceptable => "acceptable",
        Level::LowSpeed => "low-speed",
        Level::Unacceptable => "unacceptable",
    }
}

/// Degrees from radians, without the last digits that the conversion makes up: θ is never known better than this.
#[must_use]
pub fn degrees(theta: f64) -> f64 {
    tidy(theta.to_degrees())
}

/// Ten decimals.
pub(crate) fn tidy(value: f64) -> f64 {
    const PARTS: f64 = 1e10;
    if value.abs() < PARTS / 1e4 { (value * PARTS).round() / PARTS + 0.0 } else { value }
}

/// What a value of a column is multiplied by.
#[must_use]
pub fn scale_of(design: &Design, column: Column) -> f64 {
    let degree = 1_f64.to_degrees();
    match column {
        Column::Theta if design.kind.travel().is_some() => 1.0,
        Column::Theta | Column::PressureAngle => degree,
        Column::S | Column::V | Column::A | Column::J if design.is_oscillating() => degree,
        _ => 1.0,
    }
}

fn summary_of(design: &Design, analysis: &Analysis) -> Vec<(&'static str, Range)> {
    let summary = &analysis.summary;
    let all = [
        (Column::S, Some(summary.s)),
        (Column::V, Some(summary.v)),
        (Column::A, Some(summary.a)),
        (Column::J, Some(summary.j)),
        (Column::PressureAngle, Some(summary.pressure_angle)),
        (Column::Rho, Some(summary.rho)),
        (Column::RhoPitch, summary.rho_pitch),
        (Column::Contact, summary.reach),
    ];
    let range = |column: Column, Extremes { min, min_at, max, max_at }| {
        let scale = scale_of(design, column);
        Range {
            min: min * scale + 0.0,
            min_at: design.place(min_at),
            max: max * scale + 0.0,
            max_at: design.place(max_at),
        }
    };
    let mut ranges: Vec<(&'static str, Range)> =
        all.into_iter().filter_map(|(column, extremes)| Some((column.name(), range(column, extremes?)))).collect();
    // A breadth is a length, like x.
    ranges.extend(summary.breadth.map(|extremes| ("breadth", range(Column::X, extremes))));
    ranges
}

fn finding_of(design: &Design, finding: &Finding) -> DesignFinding {
    let scale = match finding.kind {
        FindingKind::Jump(_) | FindingKind::BelowBase => Some(scale_of(design, Column::S)),
        FindingKind::PressureAngle => Some(scale_of(design, Column::PressureAngle)),
        FindingKind::Cusp
        | FindingKind::Undercut
        | FindingKind::GrooveUndercut
        | FindingKind::ConcaveFlat
        | FindingKind::ArmCutsCam
        | FindingKind::PivotInsideCam
        | FindingKind::FaceOvertaken
        | FindingKind::ContactPastPivot => Some(1.0),
        FindingKind::SelfCrossing | FindingKind::Doubtful | FindingKind::NotProved(_) => None,
    };
    let measured = |value: f64| scale.map(|scale| value * scale + 0.0).filter(|value| value.is_finite());
    DesignFinding {
        kind: finding.kind,
        level: finding.level,
        theta: design.place(finding.theta),
        interval: finding.interval.map(|(from, to)| [design.place(from), design.place(to)]),
        places: finding.places.iter().map(|&theta| design.place(theta)).collect(),
        value: measured(finding.value),
        // A limit of 30° is 30, and not what its radians come to.
        limit: measured(finding.limit).map(tidy),
    }
}

fn joint_of(design: &Design, joint: &Joint) -> DesignJoint {
    const ORDERS: [Column; 4] = [Column::S, Column::V, Column::A, Column::J];
    let jump = joint.jump.and_then(|order| ORDERS.get(usize::from(order)).copied());
    DesignJoint { theta: design.place(joint.theta), segment: joint.segment, jump }
}

impl Design {
    /// A place of the cycle: degrees, or a length for a cam that travels.
    #[must_use]
    pub fn place(&self, theta: f64) -> f64 {
        if self.kind.travel().is_some() { tidy(theta) } else { degrees(theta) }
    }
}

fn borders_of(design: &Design, cam: &Cam) -> Vec<f64> {
    if cam.program.cycle() == Cycle::Mirrored {
        return cam.program.borders().iter().copied().map(degrees).collect();
    }
    let mut theta = Decimal::default();
    let mut borders = vec![0.0];
    for segment in &design.segments {
        theta = theta + Decimal::of(segment.beta);
        borders.push(theta.to_f64());
    }
    if let Some(last) = borders.last_mut() {
        *last = design.kind.whole();
    }
    borders
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn finite<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    value.is_finite().then_some(value).serialize(serializer)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;

    fn report(name: &str) -> (Design, Analysis, Report) {
        let design = example(name).expect(name);
        let cam = design.cam().expect(name);
        let analysis = Analysis::of(&cam, 360);
        let report = Report::of(&design, &cam, &analysis);
        (design, analysis, report)
    }

    #[test]
    fn angles_are_degrees_and_swings_too() {
        let (design, analysis, report) = report("2RO");
        let range = report.range(Column::S).expect("s");
        assert!((range.max - 10.0).abs() < 1e-12 && range.max_at == 120.0, "{range:?}");
        let angle = report.range(Column::PressureAngle).expect("φ");
        assert!((angle.max.max(-angle.min) - 33.20).abs() < 0.01, "{angle:?}");
        let theta = column(&design, &analysis, Column::Theta).expect("θ");
        assert_eq!((theta.len(), theta[143], theta[360]), (361, 143.0, 360.0));
        assert_eq!(report.borders, [0.0, 120.0, 240.0, 360.0]);
    }

    #[test]
    fn a_column_that_does_not_apply_is_absent() {
        let names = |name: &str| {
            let (design, analysis, _) = report(name);
            columns(&design, &analysis).into_iter().map(|(name, _)| name).collect::<Vec<_>>()
        };
        assert!(names("10EX").contains(&"contact") && !names("10EX").contains(&"pitch_x"));
        assert!(names("9RT").contains(&"rho_pitch") && !names("9RT").contains(&"contact"));
    }

    #[test]
    fn an_endless_radius_is_written_as_null() {
        let range = Range { min: f64::NEG_INFINITY, min_at: 1.0, max: 2.0, max_at: 3.0 };
        let json = serde_json::to_string(&range).expect("json");
        assert_eq!(json, r#"{"min":null,"min_at":1.0,"max":2.0,"max_at":3.0}"#);
    }
}
