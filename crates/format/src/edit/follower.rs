//! Another follower for the same cam.

use super::data::is_a_length;
use super::program::scale_to;
use crate::decimal::Decimal;
use crate::digits::{clean, half_figures, magnitude, rounded_at};
use crate::measure::default_of;
use crate::{CamKind, CamRefusal, Conjugate, Design, DesignError, unsuited};
use levalab_core::law::Data;
use levalab_core::{FollowerKind, Motion, Parameter, Quantity, Tie};

/// An oscillating follower that swings more than this is out of the ordinary, degrees.
const LARGEST_SWING: f64 = 30.0;

/// Arm and pivot distance as shares of the prime circle, as in the classic programs (80 to 50).
const ARM: f64 = 1.6;

/// The radius of a new roller, as a share of the base circle.
const ROLLER: f64 = 0.2;

/// The radius of a new curved face, likewise.
const CURVED_FACE: f64 = 0.5;

/// How far from the shaft the pivot of a face is, likewise.
const FACE_PIVOT: f64 = 2.0;

/// What stands for the base radius of a cam that travels, as a share of its length.
const OF_LENGTH: f64 = 0.2;

/// Another follower: parameters that both have are kept, the rest gets proportions that work. Between sliding and swinging the
/// rises become angles at the end of the arm, or lengths there. A second cam gets a tie that works, or goes.
///
/// # Errors
/// Returns an error if the kind of cam has no such follower.
pub(super) fn change(design: &mut Design, kind: &'static FollowerKind) -> Result<(), DesignError> {
    if let Some(key) = unsuited(design.kind.word(), kind) {
        return Err(DesignError::at(["follower", key], CamRefusal::Unsuited { kind: design.kind.word() }));
    }
    let pair = design.conjugate.take();
    exchange(design, kind);
    if pair.is_some() {
        let tie = if kind.motion == Motion::Translating { Tie::Distance(0.0) } else { Tie::Angle(0.0) };
        let room = design.room_for_second(tie, None).ok().flatten();
        design.conjugate = room.map(|room| Conjugate { tie: room.tie, radius: None });
    }
    Ok(())
}

/// The same without a second cam.
pub(super) fn exchange(design: &mut Design, kind: &'static FollowerKind) {
    let (old, old_lever, heights) = (design.follower, lever(design), design.draft_heights());
    if old.id == kind.id {
        return;
    }
    let base = match design.kind {
        CamKind::Translating { length } => OF_LENGTH * length,
        _ => design.base_radius,
    };
    let mut values = [0.0; levalab_core::MAX_FOLLOWER_PARAMETERS];
    for (i, parameter) in kind.parameters.iter().enumerate() {
        values[i] = kept(design, parameter.key).unwrap_or_else(|| proportion(kind, &values, parameter, base));
    }
    (design.follower, design.values) = (kind, values);
    if kind.motion == Motion::Oscillating {
        // An application is driven by a length.
        design.application = None;
    }
    if old.motion != kind.motion {
        let per_unit = if kind.motion == Motion::Oscillating { lever(design) } else { 1.0 / old_lever };
        convert_rises(design, &heights, per_unit);
    }
}

/// A parameter of the present follower; the radius of a roller and that of a curved face stand for each other.
fn kept(design: &Design, key: &str) -> Option<f64> {
    let twin = match key {
        "roller_radius" => "face_radius",
        "face_radius" => "roller_radius",
        _ => key,
    };
    let index = design.follower.index_of(key).or_else(|| design.follower.index_of(twin))?;
    Some(design.values[index])
}

fn proportion(kind: &FollowerKind, found: &[f64], parameter: &Parameter, base: f64) -> f64 {
    if let Some(usual) = default_of(parameter, 1.0) {
        return usual;
    }
    if parameter.quantity != Quantity::Length {
        return 0.0;
    }
    let prime = base + kind.index_of("roller_radius").map_or(0.0, |index| found[index]);
    let exact = match parameter.key {
        "roller_radius" => ROLLER * base,
        "face_radius" => CURVED_FACE * base,
        "pivot_distance" if kind.id == "oscillating-flat" => FACE_PIVOT * base,
        _ => ARM * prime,
    };
    if exact > 0.0 { half_figures(exact, f64::round) } else { 1.0 }
}

/// How far a point of the follower moves for a degree of its swing.
fn lever(design: &Design) -> f64 {
    let index = design.follower.index_of("arm").or_else(|| design.follower.index_of("pivot_distance"));
    index.map_or(1.0, |index| design.values[index].to_radians())
}

/// Heights divided by `per_unit`, in two figures of the greatest; with all their digits where a formula leads to one of them.
fn convert_rises(design: &mut Design, heights: &[Decimal], per_unit: f64) {
    let heights: Vec<f64> = heights.iter().map(|height| height.to_f64() / per_unit).collect();
    let top = heights.iter().fold(0.0_f64, |top, height| top.max(height.abs()));
    let swings = design.is_oscillating();
    let shrink = if swings && top > LARGEST_SWING { LARGEST_SWING / top } else { 1.0 };
    let place = if top > 0.0 { magnitude(top * shrink) - 1 } else { -1 };
    let led =
        design.segments.iter().any(|segment| matches!(&segment.data, Data::Expression(text) if !is_a_length(text)));
    let figure = |height: f64| if led { clean(height) } else { rounded_at(height, place, f64::round) };
    let converted: Vec<Decimal> = heights.iter().map(|height| Decimal::of(figure(height * shrink))).collect();
    let factor = shrink / per_unit;
    let in_formulas = if swings { factor.to_radians() } else { factor.to_degrees() };
    scale_to(design, &converted, factor, in_formulas);
}
