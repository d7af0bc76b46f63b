//! What an analysis tells the page, shaped for JavaScript.

use crate::mechanism::Mechanism;
use levalab_core::{Cam, Column, Segment, angle_between, profiles_coincide};
use levalab_format::report::{Place, Range, degrees, scale_of};
use levalab_format::{CamStudy, DesignCure, Notation, Study, ToldCure, ToldFinding, ToldVerdict, link};
use levalab_words::{Language, Signs};
use serde::{Serialize, Serializer};

type Verdict = ToldVerdict<ToldFinding>;

/// The answer to a good design.
#[derive(Serialize)]
pub struct PageReport {
    link: String,
    kind: &'static str,
    /// What the cursor runs through: 360°, or the length of a cam that travels.
    span: f64,
    travels: bool,
    verdict: Verdict,
    #[serde(serialize_with = "as_map")]
    summary: Vec<(&'static str, Range)>,
    least_convex: Option<Place>,
    tightest_hollow: Option<Place>,
    inflections: Vec<f64>,
    joints: Vec<PageJoint>,
    borders: Vec<f64>,
    /// The segments of a motion that is ready-made.
    program: Option<Vec<PageSegment>>,
    heights: Vec<f64>,
    omega: f64,
    period: f64,
    pressure_angle_limit: f64,
    mechanism: Mechanism,
    units: Units,
    /// Symbols other than ours.
    #[serde(skip_serializing_if = "Option::is_none")]
    notation: Option<PageNotation>,
    /// The second cam of a pair.
    conjugate: Option<Box<PageReport>>,
    /// Angle between the arms of a pair that swings, degrees.
    pair_angle: Option<f64>,
    /// The two profiles of a pair are one, in a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pair_note: Option<&'static str>,
}

/// The symbols of a notation by ours, and the sign with which it tells an eccentricity.
#[derive(Serialize)]
struct PageNotation {
    #[serde(serialize_with = "as_map")]
    symbols: Vec<(&'static str, &'static str)>,
    eccentricity: f64,
}

#[derive(Serialize)]
struct PageSegment {
    law: &'static str,
    beta: f64,
    rise: f64,
}

#[derive(Serialize)]
struct PageJoint {
    theta: f64,
    segment: usize,
    jump: Option<&'static str>,
}

#[derive(Serialize)]
struct Units {
    s: String,
    v: String,
    a: String,
    j: String,
    #[serde(rename = "V")]
    velocity: String,
    #[serde(rename = "A")]
    acceleration: String,
    #[serde(rename = "J")]
    jerk: String,
    /// Of the sliding of the contact, with respect to θ and to time.
    u: String,
    #[serde(rename = "U")]
    timed_sliding: String,
    length: &'static str,
}

impl PageReport {
    /// Everything the page shows of a cam, or of both cams of a pair, but for columns and cures. The verdict is on both: its headline is that of
    /// the worse cam, which `cam` names, and its findings are those of both in one order.
    pub fn of(study: &Study, language: Language) -> Self {
        Self::of_cams(study.first(), study.second(), language)
    }

    fn of_cams(first: &CamStudy, second: Option<&CamStudy>, language: Language) -> Self {
        let link = link::encode(first.design()).unwrap_or_default();
        let Some(second) = second else { return Self::of_one(first, link, verdict_of(first, None, language)) };
        let verdict = |cam: &CamStudy, number: u8| verdict_of(cam, Some(number), language);
        let (ours, theirs) = (verdict(first, 1), verdict(second, 2));
        let (cam, headline) = if second.report().level > first.report().level {
            (theirs.cam, theirs.headline.clone())
        } else {
            (ours.cam.filter(|_| ours.headline != theirs.headline), ours.headline)
        };
        let findings = of_both(&[first, second], vec![ours.findings, theirs.findings.clone()]);
        let both =
            Verdict { cam, ..ToldVerdict::new(first.report().level.max(second.report().level), headline, findings) };
        Self {
            conjugate: Some(Box::new(Self::of_one(second, String::new(), theirs))),
            pair_angle: angle_between(first.cam(), second.cam()).map(f64::to_degrees),
            pair_note: profiles_coincide(first.cam(), second.cam()).then(|| levalab_words::profiles_coincide(language)),
            ..Self::of_one(first, link, both)
        }
    }

    fn of_one(study: &CamStudy, link: String, verdict: Verdict) -> Self {
        let (design, cam, report) = (study.design(), study.cam(), study.report());
        let omega = design.omega();
        Self {
            link,
            kind: design.kind.word(),
            span: design.kind.travel().unwrap_or(360.0),
            travels: design.kind.travel().is_some(),
            verdict,
            summary: summary(study),
            least_convex: report.least_convex,
            tightest_hollow: report.tightest_hollow,
            inflections: report.inflections.clone(),
            joints: report
                .joints
                .iter()
                .map(|joint| PageJoint {
                    theta: joint.theta,
                    segment: joint.segment,
                    jump: joint.jump.map(Column::name),
                })
                .collect(),
            borders: report.borders.clone(),
            program: design.kind.generator().map(|_| segments(cam)),
            heights: cam.program.heights().iter().map(|height| height * scale_of(design, Column::S)).collect(),
            omega,
            period: cam.program.span() / omega,
            pressure_angle_limit: degrees(cam.follower.pressure_angle_limit()),
            mechanism: Mechanism::of(cam, study.analysis()),
            units: Units::of(study),
            notation: (design.notation != Notation::default()).then(|| PageNotation {
                symbols: Signs::of(design.notation).symbols.to_vec(),
                eccentricity: design.eccentricity_sign(),
            }),
            conjugate: None,
            pair_angle: None,
            pair_note: None,
        }
    }
}

fn segments(cam: &Cam) -> Vec<PageSegment> {
    let told = |segment: &Segment| PageSegment { law: segment.law.id, beta: degrees(segment.beta), rise: segment.rise };
    cam.program.segments().iter().map(told).collect()
}

/// Extremes by the name of their column, and of V, A and J, the derivatives by time.
fn summary(study: &CamStudy) -> Vec<(&'static str, Range)> {
    let mut ranges = study.report().summary.clone();
    let mut rate = 1.0;
    for (column, name) in [(Column::V, "V"), (Column::A, "A"), (Column::J, "J")] {
        rate *= study.design().omega();
        let timed = |range: Range| Range { min: range.min * rate, max: range.max * rate, ..range };
        ranges.extend(study.report().range(column).map(|range| (name, timed(range))));
    }
    ranges
}

/// Cures of every finding with their sentences.
pub fn told_cures(study: &CamStudy, cures: Vec<Vec<DesignCure>>, language: Language) -> Vec<Vec<ToldCure>> {
    let design = study.design();
    let of_finding = |(finding, cures): (_, Vec<DesignCure>)| {
        let told = |cure: DesignCure| {
            let message = levalab_words::cure(language, design, finding, &cure.remedy);
            ToldCure::new(cure, message)
        };
        cures.into_iter().map(told).collect()
    };
    study.report().findings.iter().zip(cures).map(of_finding).collect()
}

fn verdict_of(study: &CamStudy, cam: Option<u8>, language: Language) -> Verdict {
    let (design, report) = (study.design(), study.report());
    let findings = report.findings.iter().map(|finding| {
        let message = levalab_words::finding(language, design, finding);
        let mut told = ToldFinding::new(finding, message);
        told.cam = cam;
        told.message_by_time = levalab_words::finding_by_time(language, design, finding);
        told
    });
    let headline = levalab_words::headline(language, report);
    Verdict { cam, ..ToldVerdict::new(report.level, headline, findings.collect()) }
}

fn as_map<T: Copy + Serialize, S: Serializer>(ranges: &[(&'static str, T)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(ranges.iter().copied())
}

impl Units {
    fn of(study: &CamStudy) -> Self {
        let motion = study.units();
        let sliding = motion.sliding();
        Self {
            s: motion.unit(0, false),
            v: motion.unit(1, false),
            a: motion.unit(2, false),
            j: motion.unit(3, false),
            u: sliding.unit(1, false),
            velocity: motion.unit(1, true),
            acceleration: motion.unit(2, true),
            jerk: motion.unit(3, true),
            timed_sliding: sliding.unit(1, true),
            length: motion.length.symbol(),
        }
    }
}

/// The findings of both cams in one list, in the order of [`Finding::gravest_first`]: the cam (0 or 1) of each and its place among the findings
/// of that cam.
fn in_order(cams: &[&CamStudy]) -> Vec<(usize, usize)> {
    let of_cam =
        |(cam, study): (usize, &&CamStudy)| (0..study.analysis().findings.len()).map(move |index| (cam, index));
    let mut places: Vec<(usize, usize)> = cams.iter().enumerate().flat_map(of_cam).collect();
    let finding = |&(cam, index): &(usize, usize)| &cams[cam].analysis().findings[index];
    // Of two at one place the first cam's comes first.
    places.sort_by(|one, other| finding(one).gravest_first(finding(other)));
    places
}

/// Things given for each finding of each cam, in the order in which the findings of both are told.
pub fn of_both<T>(cams: &[&CamStudy], of_each: Vec<Vec<T>>) -> Vec<T> {
    let mut of_each: Vec<Vec<Option<T>>> =
        of_each.into_iter().map(|things| things.into_iter().map(Some).collect()).collect();
    in_order(cams).into_iter().filter_map(|(cam, index)| of_each.get_mut(cam)?.get_mut(index)?.take()).collect()
}

#[cfg(test)]
mod tests;
