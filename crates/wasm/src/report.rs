//! What an analysis tells the page, shaped for JavaScript.

use crate::lab::Current;
use levalab_core::{Body, Column, Element};
use levalab_format::report::{Range, degrees, level_name};
use levalab_format::{Design, DesignCure, Edit, link};
use levalab_words::Language;
use serde::{Serialize, Serializer};
use std::f64::consts::TAU;

/// The answer to a good design.
#[derive(Serialize)]
pub struct PageReport {
    link: String,
    verdict: Verdict,
    #[serde(serialize_with = "as_map")]
    summary: Vec<(&'static str, Range)>,
    least_convex: Option<Place>,
    tightest_hollow: Option<Place>,
    joints: Vec<PageJoint>,
    borders: Vec<f64>,
    omega: f64,
    period: f64,
    pressure_angle_limit: f64,
    mechanism: Mechanism,
    units: Units,
}

#[derive(Serialize)]
struct Verdict {
    level: &'static str,
    headline: String,
    findings: Vec<PageFinding>,
}

#[derive(Serialize)]
struct PageFinding {
    code: &'static str,
    severity: &'static str,
    theta: f64,
    interval: Option<[f64; 2]>,
    places: Vec<f64>,
    value: Option<f64>,
    limit: Option<f64>,
    message: String,
}

/// A cure: a sentence and what it changes.
#[derive(Serialize)]
pub struct PageCure {
    message: String,
    edits: Vec<Edit>,
}

/// A value and where it is.
#[derive(Serialize)]
struct Place {
    value: f64,
    at: f64,
}

#[derive(Serialize)]
struct PageJoint {
    theta: f64,
    segment: usize,
    jump: Option<&'static str>,
}

/// What the drawing of the mechanism needs besides the instants. Lengths in the unit of the design, angles in degrees.
#[derive(Serialize)]
struct Mechanism {
    sense: f64,
    base_radius: f64,
    prime_radius: Option<f64>,
    motion: &'static str,
    contact: &'static str,
    roller_radius: f64,
    eccentricity: f64,
    pivot: Option<[f64; 2]>,
    arm: Option<f64>,
    opening: Option<f64>,
    face_offset: f64,
    face_angle: f64,
    face: Option<[f64; 2]>,
    reach: f64,
    top: f64,
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
    length: &'static str,
}

impl PageReport {
    /// Everything the page shows of a cam, but for its columns and its cures.
    pub fn of(current: &Current, language: Language) -> Self {
        let Current { design, cam, analysis, report } = current;
        let omega = design.omega();
        Self {
            link: link::encode(design).unwrap_or_default(),
            verdict: Verdict::of(current, language),
            summary: summary(current),
            least_convex: Place::of(analysis.summary.least_convex, design),
            tightest_hollow: Place::of(analysis.summary.tightest_hollow, design),
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
            omega,
            period: TAU / omega,
            pressure_angle_limit: degrees(cam.follower.pressure_angle_limit()),
            mechanism: Mechanism::of(current),
            units: Units::of(current),
        }
    }
}

impl Place {
    fn of(found: Option<(f64, f64)>, design: &Design) -> Option<Self> {
        found.filter(|(value, _)| value.is_finite()).map(|(value, at)| Self { value, at: design.place(at) })
    }
}

/// Extremes by the name of their column, and of V, A and J, the derivatives by time.
fn summary(current: &Current) -> Vec<(&'static str, Range)> {
    let mut ranges = current.report.summary.clone();
    let mut rate = 1.0;
    for (column, name) in [(Column::V, "V"), (Column::A, "A"), (Column::J, "J")] {
        rate *= current.design.omega();
        let timed = |range: Range| Range { min: range.min * rate, max: range.max * rate, ..range };
        ranges.extend(current.report.range(column).map(|range| (name, timed(range))));
    }
    ranges
}

/// The cures of every finding, in the order of the findings.
pub fn cures(current: &Current, language: Language) -> Vec<Vec<PageCure>> {
    let Current { design, cam, analysis, report } = current;
    let of_finding = |(finding, cures): (_, Vec<DesignCure>)| {
        let told = |cure: DesignCure| PageCure {
            message: levalab_words::cure(language, design, finding, &cure.remedy),
            edits: cure.edits,
        };
        cures.into_iter().map(told).collect()
    };
    report.findings.iter().zip(levalab_format::cures(design, cam, analysis)).map(of_finding).collect()
}

impl Verdict {
    fn of(current: &Current, language: Language) -> Self {
        let Current { design, report, .. } = current;
        let findings = report.findings.iter().map(|finding| PageFinding {
            code: finding.kind.code(),
            severity: level_name(finding.level),
            theta: finding.theta,
            interval: finding.interval,
            places: finding.places.clone(),
            value: finding.value,
            limit: finding.limit,
            message: levalab_words::finding(language, design, finding),
        });
        Self {
            level: level_name(report.level),
            headline: levalab_words::headline(language, report),
            findings: findings.collect(),
        }
    }
}

fn as_map<S: Serializer>(ranges: &[(&'static str, Range)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(ranges.iter().copied())
}

impl Mechanism {
    fn of(current: &Current) -> Self {
        let Current { design, cam, analysis, .. } = current;
        let follower = &cam.follower;
        let (motion, contact) = levalab_format::motion_and_contact(follower.kind);
        let value = |key: &str| follower.value(key);
        let radius = follower.disc_radius();
        // Whole degrees are enough for where to put the guide.
        let around = || (0..360).map(|degree| cam.at(f64::from(degree).to_radians()).1);
        Self {
            sense: follower.rotation.sigma(),
            base_radius: design.base_radius,
            prime_radius: (!follower.is_flat()).then_some(design.base_radius + radius),
            motion,
            contact,
            roller_radius: radius,
            eccentricity: value("eccentricity").unwrap_or(0.0),
            pivot: match follower.body {
                Body::Swing { pivot } => Some([pivot.re, pivot.im]),
                Body::Slide => None,
            },
            arm: value("arm"),
            opening: follower.opening().map(f64::to_degrees),
            face_offset: value("face_offset").unwrap_or(0.0),
            face_angle: value("face_angle").unwrap_or(0.0).to_degrees(),
            face: analysis.summary.reach.map(|reach| [reach.min, reach.max]),
            reach: around().map(|contact| contact.point.norm()).fold(0.0, f64::max),
            top: match follower.element {
                Element::Disc { .. } => around().map(|contact| contact.trace.im).fold(f64::NEG_INFINITY, f64::max),
                Element::Face { point, .. } => point.im + analysis.summary.s.max,
            },
        }
    }
}

impl Units {
    fn of(current: &Current) -> Self {
        let length = current.design.length_unit.symbol();
        let s = if current.design.is_oscillating() { "°" } else { length };
        Self {
            s: s.into(),
            v: format!("{s}/rad"),
            a: format!("{s}/rad²"),
            j: format!("{s}/rad³"),
            velocity: format!("{s}/s"),
            acceleration: format!("{s}/s²"),
            jerk: format!("{s}/s³"),
            length,
        }
    }
}
