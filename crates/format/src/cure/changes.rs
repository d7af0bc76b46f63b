//! Cures as changes to the design file.

use super::Remedy;
use crate::data;
use crate::decimal::Decimal;
use crate::digits::{DIGITS, round};
use crate::edit::with_law;
use crate::report::{scale_of, tidy};
use crate::write::{number, segment_value};
use crate::{CamKind, Conjugate, Design, Edit, Path, SegmentDesign};
use levalab_core::law::Data;
use levalab_core::{Cam, Column, Law, Tie};

/// What a cure changes.
pub(super) fn edits(design: &Design, cam: &Cam, remedy: &Remedy) -> Vec<Edit> {
    match remedy {
        Remedy::BaseRadius { value, .. } => {
            let mut edits = vec![Edit::set(["cam", "base_radius"], number(*value))];
            let more = Decimal::of(*value) - Decimal::of(design.base_radius);
            // The travel stays: the breadth follows the base circle, and so does the far side of a pair.
            if let CamKind::ConstantBreadth { breadth, .. } = design.kind {
                edits.push(Edit::set(["cam", "breadth"], number((Decimal::of(breadth) + more + more).to_f64())));
            }
            if let Some(Conjugate { tie: Tie::Distance(distance), .. }) = design.conjugate {
                let distance = (Decimal::of(distance) + more).to_f64();
                edits.push(Edit::set(["conjugate", "distance"], number(distance)));
            }
            edits
        }
        Remedy::Travel { value } => {
            let mut edits = vec![Edit::set(["cam", "length"], number(*value))];
            let each = design.segments.iter().zip(stretched(design, *value)).enumerate();
            edits.extend(each.map(|(k, (segment, beta))| {
                let (here, after) = (Path::from("segments").join(k), data::stretched(segment, beta));
                let within = after.data != Data::None || after.parameters != segment.parameters;
                if within { Edit::set(here, segment_value(&after)) } else { Edit::set(here.join("beta"), number(beta)) }
            }));
            edits
        }
        Remedy::Tie { tie, .. } => vec![Edit::set(["conjugate", tie.key()], number(tie.value()))],
        Remedy::Eccentricity { value, .. } => vec![Edit::set(["follower", "eccentricity"], number(*value))],
        Remedy::Length { key, value } => vec![Edit::set(["follower", key], number(*value))],
        Remedy::NoSize { .. } => Vec::new(),
        Remedy::Laws { changes, .. } => {
            // The whole segment, since the parameters of the old law go and those of the new one come.
            let change = |&(k, law): &(usize, &'static Law)| {
                design.segments.get(k)?;
                Some(Edit::set(Path::from("segments").join(k), segment_value(&by_law(design, cam, k, law))))
            };
            changes.iter().filter_map(change).collect()
        }
    }
}

/// A segment of the design by another law without data, which takes its usual parameters.
pub(crate) fn by_law(design: &Design, cam: &Cam, k: usize, law: &'static Law) -> SegmentDesign {
    with_law(&design.segments[k], law, 0.0, rise_of(design, cam, k))
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
