//! Cures as changes to the design file.

use super::Remedy;
use crate::data;
use crate::decimal::Decimal;
use crate::digits::{DIGITS, round};
use crate::measure::default_of;
use crate::report::{scale_of, tidy};
use crate::write::{number, segment_value};
use crate::{CamKind, Conjugate, Design, DesignError, Path, PathPart, Problem, SegmentDesign};
use levalab_core::law::{Data, MAX_LAW_PARAMETERS};
use levalab_core::{Cam, Column, Law, Tie};
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
            None => return Err(DesignError::at(Path(edit.path.clone()), Problem::Missing)),
        }
    }
    Design::from_value(&value)
}

/// What a cure changes.
pub(super) fn edits(design: &Design, cam: &Cam, remedy: &Remedy) -> Vec<Edit> {
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
        Remedy::Length { key, value } => vec![edit(["follower", key].into(), number(*value))],
        Remedy::NoSize { .. } => Vec::new(),
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

fn default_parameters(law: &Law, beta: f64) -> [f64; MAX_LAW_PARAMETERS] {
    let mut values = [0.0; MAX_LAW_PARAMETERS];
    for (value, parameter) in values.iter_mut().zip(law.parameters) {
        *value = default_of(parameter, beta).unwrap_or_default();
    }
    values
}
