//! What puts a finding right, as numbers that a person would write and as changes to the design file.

use crate::data;
use crate::decimal::Decimal;
use crate::report::{scale_of, tidy};
use crate::write::{number, segment_value};
use crate::{CamKind, Conjugate, Design, DesignError, Path, PathPart, SegmentDesign};
use levalab_core::law::Data;
use levalab_core::nearest::nearest;
use levalab_core::{Analysis, Cam, Column, Cure, Finding, Law, Tie, prescribe, resized, working_ties};
use serde::Serialize;
use serde_json::Value;

/// A change of one value in a design file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Edit {
    /// Where it is.
    pub path: Vec<PathPart>,
    /// What it becomes.
    pub value: Value,
}

/// A cure, told and ready to be applied.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignCure {
    /// What it does, in the units of the design.
    pub remedy: Remedy,
    /// How to do it.
    pub edits: Vec<Edit>,
}

/// What a cure does, in the units of the design.
#[derive(Clone, Debug, PartialEq)]
pub enum Remedy {
    /// Another base circle.
    BaseRadius {
        /// Its radius.
        value: f64,
        /// True when the cam has to grow, so that any larger circle is good as well; false when it has to shrink.
        grows: bool,
    },
    /// A longer travel of a cam that travels, all β's in proportion.
    Travel {
        /// Its length.
        value: f64,
    },
    /// Another distance or angle (degrees) between the elements of a conjugate pair.
    Tie {
        /// What is to change, with the value that it takes.
        tie: Tie,
        /// True when it has to grow.
        grows: bool,
    },
    /// Another eccentricity.
    Eccentricity {
        /// e.
        value: f64,
        /// The greatest |φ| that remains, degrees.
        pressure_angle: f64,
    },
    /// Other laws for some segments.
    Laws {
        /// Each segment and the law it takes.
        changes: Vec<(usize, &'static Law)>,
        /// The lowest of *s*, *v*, *a*, *j* that still jumps somewhere.
        remaining_jump: Option<Column>,
    },
}

/// The cures of each finding of an analysis, in the order of the findings, the best cure first: the numbers rounded to few
/// digits, and tried again with them.
#[must_use]
pub fn cures(design: &Design, cam: &Cam, analysis: &Analysis) -> Vec<Vec<DesignCure>> {
    if cam.follower.reversed.is_some() {
        return cures_of_second(design, cam, analysis);
    }
    let told = |cure: Cure| {
        let remedy = in_units(design, cam, cure);
        DesignCure { edits: edits(design, cam, &remedy), remedy }
    };
    prescribe(cam, analysis).into_iter().map(|cures| cures.into_iter().map(told).collect()).collect()
}

/// A second cam is cured by what ties it to the first: the nearest value with which its geometry passes. Its motion is cured
/// where it is made.
fn cures_of_second(design: &Design, cam: &Cam, analysis: &Analysis) -> Vec<Vec<DesignCure>> {
    let to_blame = !analysis.findings.iter().all(|finding| finding.kind.is_of_the_motion());
    let cure = to_blame.then(|| nearest_tie(design)).flatten().map(|remedy| {
        let edits = edits(design, cam, &remedy);
        DesignCure { remedy, edits }
    });
    let of = |finding: &Finding| cure.clone().filter(|_| !finding.kind.is_of_the_motion()).into_iter().collect();
    analysis.findings.iter().map(of).collect()
}

fn nearest_tie(design: &Design) -> Option<Remedy> {
    let (pair, first) = (design.conjugate?, design.cam().ok()?);
    let (least, most) = working_ties(&first, pair.core_tie(), pair.radius)?;
    let edge = |value: f64| if matches!(pair.tie, Tie::Angle(_)) { value.to_degrees() } else { value };
    let (least, most, now) = (edge(least), edge(most), pair.tie.value());
    let grows = now < least;
    let value = short_within(if grows { least } else { most }, least, most)?;
    Some(Remedy::Tie { tie: pair.tie.with(value), grows })
}

/// The number nearest to `wanted` with few digits that lies between two others.
pub(crate) fn short_within(wanted: f64, least: f64, most: f64) -> Option<f64> {
    let how = if wanted <= least {
        f64::ceil
    } else if wanted >= most {
        f64::floor
    } else {
        f64::round
    };
    let inside = |value: &f64| (least..=most).contains(value);
    (DIGITS..ALL_DIGITS).map(|digits| round(wanted, digits, how)).find(inside)
}

/// The design with some changes made.
///
/// # Errors
/// When what comes out is no design, or a change is for a place that the design does not have.
pub fn apply(design: &Design, edits: &[Edit]) -> Result<Design, DesignError> {
    let mut value = design.to_value();
    for edit in edits {
        let mut place = Some(&mut value);
        for part in &edit.path {
            place = place.and_then(|place| match part {
                PathPart::Key(key) => place.get_mut(key),
                PathPart::Index(index) => place.get_mut(index),
            });
        }
        match place {
            Some(place) => *place = edit.value.clone(),
            None => return Err(DesignError { path: Path(edit.path.clone()), problem: crate::Problem::Missing }),
        }
    }
    Design::from_value(&value)
}

fn edits(design: &Design, cam: &Cam, remedy: &Remedy) -> Vec<Edit> {
    let edit = |path: Path, value: Value| Edit { path: path.0, value };
    match remedy {
        Remedy::BaseRadius { value, .. } => {
            let mut edits = vec![edit(["cam", "base_radius"].into(), number(*value))];
            let more = Decimal::of(*value) - Decimal::of(design.base_radius);
            // The travel stays: the breadth follows the base circle, and so does the far side of a pair.
            if let CamKind::ConstantBreadth { breadth, .. } = design.kind {
                edits.push(edit(["cam", "breadth"].into(), number((Decimal::of(breadth) + more + more).to_f64())));
            }
            if let Some(Conjugate { tie: Tie::Distance(distance), .. }) = design.conjugate {
                let distance = (Decimal::of(distance) + more).to_f64();
                edits.push(edit(["conjugate", "distance"].into(), number(distance)));
            }
            edits
        }
        Remedy::Travel { value } => {
            let mut edits = vec![edit(["cam", "length"].into(), number(*value))];
            let each = design.segments.iter().zip(stretched(design, *value)).enumerate();
            edits.extend(each.map(|(k, (segment, beta))| {
                let (here, after) = (Path::from("segments").join(k), data::stretched(segment, beta));
                let within = after.data != Data::None || after.parameters != segment.parameters;
                if within { edit(here, segment_value(&after)) } else { edit(here.join("beta"), number(beta)) }
            }));
            edits
        }
        Remedy::Tie { tie, .. } => vec![edit(["conjugate", tie.key()].into(), number(tie.value()))],
        Remedy::Eccentricity { value, .. } => vec![edit(["follower", "eccentricity"].into(), number(*value))],
        Remedy::Laws { changes, .. } => {
            // The whole segment, since the parameters of the old law go and those of the new one come.
            let change = |&(k, law): &(usize, &'static Law)| {
                design.segments.get(k)?;
                Some(edit(Path::from("segments").join(k), segment_value(&with_law(design, cam, k, law))))
            };
            changes.iter().filter_map(change).collect()
        }
    }
}

/// A segment of the design by another law, which takes its usual parameters.
pub(crate) fn with_law(design: &Design, cam: &Cam, k: usize, law: &'static Law) -> SegmentDesign {
    SegmentDesign {
        law,
        beta: design.segments[k].beta,
        rise: rise_of(design, cam, k),
        parameters: default_parameters(law, design.segments[k].beta),
        data: Data::None,
    }
}

/// The rise of a segment; that of a free law is what its data come to, with the digits that they are worth.
fn rise_of(design: &Design, cam: &Cam, k: usize) -> f64 {
    match &design.segments[k] {
        segment if segment.law.free().is_none() => segment.rise,
        _ => {
            let heights = cam.program.heights();
            tidy((heights[k + 1] - heights[k]) * scale_of(design, Column::S))
        }
    }
}

/// The β's of a cam that travels, in proportion to another length and adding up to it.
fn stretched(design: &Design, length: f64) -> Vec<f64> {
    let factor = length / design.kind.whole();
    let mut left = Decimal::of(length);
    let last = design.segments.len().saturating_sub(1);
    let beta = |(k, segment): (usize, &SegmentDesign)| {
        let beta = if k == last { left } else { Decimal::of(round(segment.beta * factor, DIGITS + 2, f64::round)) };
        left = left - beta;
        beta.to_f64()
    };
    design.segments.iter().enumerate().map(beta).collect()
}

fn default_parameters(law: &Law, beta: f64) -> [f64; levalab_core::law::MAX_LAW_PARAMETERS] {
    let mut values = [0.0; levalab_core::law::MAX_LAW_PARAMETERS];
    for (value, parameter) in values.iter_mut().zip(law.parameters) {
        *value = crate::design::default_of(parameter, beta).unwrap_or_default();
    }
    values
}

fn in_units(design: &Design, cam: &Cam, cure: Cure) -> Remedy {
    match cure {
        Cure::BaseRadius(exact) => {
            let value = shortest_passing(cam, exact);
            Remedy::BaseRadius { value, grows: value > design.base_radius }
        }
        Cure::Travel(exact) => Remedy::Travel { value: shortest_passing(cam, exact) },
        Cure::Eccentricity { value, pressure_angle } => {
            let rounded = round(value, DIGITS, f64::round);
            let moved =
                cam.follower.kind.index_of("eccentricity").and_then(|i| cam.follower.with_value(i, rounded).ok());
            let remaining = moved.map_or(pressure_angle, |follower| {
                let analysis = Analysis::of(&cam.with_follower(follower), LOOK);
                analysis.summary.pressure_angle.greatest_size().0
            });
            Remedy::Eccentricity { value: rounded, pressure_angle: remaining.to_degrees() }
        }
        Cure::Laws { changes, remaining_jump } => {
            const ORDERS: [Column; 4] = [Column::S, Column::V, Column::A, Column::J];
            let remaining_jump = remaining_jump.and_then(|order| ORDERS.get(usize::from(order)).copied());
            Remedy::Laws { changes, remaining_jump }
        }
    }
}

/// Significant digits that a cure is told with, when they are enough for it to be one.
const DIGITS: i32 = 4;

/// More digits than an `f64` has.
const ALL_DIGITS: i32 = 17;

/// Steps in which a rounded cure is looked at; the verdict is exact whatever they are.
const LOOK: usize = 1;

/// The base radius (or the travel) rounded up to the fewest digits, four or more, with which the geometry still passes.
pub(crate) fn shortest_passing(cam: &Cam, exact: f64) -> f64 {
    let passes = |&radius: &f64| {
        let Some(sized) = resized(cam, radius) else { return false };
        Analysis::of(&sized, LOOK).findings.iter().all(|finding| finding.kind.is_of_the_motion())
    };
    (DIGITS..ALL_DIGITS).map(|digits| round(exact, digits, f64::ceil)).find(passes).unwrap_or(exact)
}

/// A number rounded to so many significant digits, by way of its decimal form so that it stays short.
fn round(value: f64, digits: i32, how: fn(f64) -> f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let place = value.abs().log10().floor() as i32 + 1 - digits;
    let units = how(value / 10_f64.powi(place));
    nearest(&(units.abs() as u64).to_string(), place).copysign(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{EXAMPLES, example};

    #[test]
    fn numbers_are_rounded_in_decimal() {
        assert_eq!(round(43.281_234, 4, f64::ceil), 43.29);
        assert_eq!(round(0.201_230_1, 4, f64::ceil), 0.2013);
        assert_eq!(round(123_456.0, 4, f64::ceil), 123_500.0);
        assert_eq!(round(-2.345_67, 4, f64::round), -2.346);
        assert_eq!(round(0.0, 4, f64::round), 0.0);
    }

    #[test]
    fn an_applied_cure_removes_its_finding() {
        let mut cured = 0;
        for (name, _) in EXAMPLES {
            let mut design = example(name).expect(name);
            for shrink in [1.0, 0.5] {
                design.base_radius *= shrink;
                let Ok(cam) = design.cam() else { continue };
                let analysis = Analysis::of(&cam, 1);
                for (finding, cures) in analysis.findings.iter().zip(cures(&design, &cam, &analysis)) {
                    for cure in cures {
                        let after = apply(&design, &cure.edits).expect("a cure gives a design");
                        let found = Analysis::of(&after.cam().expect("cam"), 1).findings;
                        let gone = found.iter().all(|other| other.kind != finding.kind);
                        let eased = matches!(cure.remedy, Remedy::Eccentricity { .. });
                        assert!(gone || eased, "{name} {:?} {:?}: {found:?}", finding.kind, cure.remedy);
                        cured += 1;
                    }
                }
            }
        }
        assert!(cured > 10, "{cured}");
    }
}
