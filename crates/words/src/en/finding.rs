//! What is found in a cam, and what would put it right, in English.

use super::EN;
use crate::Units;
use crate::voice::{Figures, by_law, row};
use levalab_core::{Column, FindingKind, Instead, Level, Tie};
use levalab_format::report::DesignFinding;
use levalab_format::{Price, Remedy};

pub(super) fn finding(finding: &DesignFinding, units: Units) -> String {
    let Figures { at, span, other, count, value, limit } = Figures::of(finding, units, EN);
    let along = |(from, to): (String, String)| format!("From {from} to {to}");
    let around = span.map_or_else(|| format!("At {at}"), along);
    let where_and_how_much = if count > 1 {
        format!("jumps at {count} joints, by up to {value} at {at}")
    } else {
        format!("jumps by {value} at {at}")
    };
    match finding.kind {
        FindingKind::Jump(0) => {
            format!("The displacement {where_and_how_much}: the follower would be in two places at once.")
        }
        FindingKind::Jump(1) => format!("The velocity {where_and_how_much}: an infinite acceleration, a blow."),
        FindingKind::Jump(2) if finding.level == Level::Acceptable => {
            format!(
                "The acceleration {where_and_how_much}; tolerated here alone: the yoke touches both sides and cannot lift off."
            )
        }
        FindingKind::Jump(_) if finding.level == Level::Acceptable => {
            format!("The jerk {where_and_how_much}; tolerated in a cam that is held on both sides.")
        }
        FindingKind::Jump(2) => {
            format!("The acceleration {where_and_how_much}: the forces change at a stroke and the follower vibrates.")
        }
        FindingKind::Jump(_) => {
            let moves = if units.travels { "travels" } else { "turns" };
            format!(
                "The jerk {where_and_how_much}: harmless when the cam {moves} slowly, vibration when it {moves} fast."
            )
        }
        FindingKind::PressureAngle => {
            let motion = if units.oscillating { "an oscillating" } else { "a translating" };
            format!("The pressure angle reaches {value} at {at}, above the {limit} that {motion} follower tolerates.")
        }
        FindingKind::Cusp => {
            format!(
                "The profile comes to a point at {at}: its radius of curvature is zero, and it would soon wear away."
            )
        }
        FindingKind::Undercut => {
            format!(
                "{around} the profile is undercut: the radius of curvature would fall to {value} at {at}, and a roller of this size cannot follow."
            )
        }
        FindingKind::GrooveUndercut => {
            format!(
                "{around} the outer wall of the groove is undercut: the pitch curve is hollow with a radius of {value} at {at}, less than the roller's {limit}."
            )
        }
        FindingKind::ConcaveFlat => {
            format!(
                "{around} the profile would have to be hollow, which a flat face cannot touch: the radius of curvature falls to {value} at {at}."
            )
        }
        FindingKind::NotProved(order) => {
            let what = match order {
                0 => "the displacement and its derivatives",
                1 => "the velocity, the acceleration and the jerk",
                2 => "the acceleration and the jerk",
                _ => "the jerk",
            };
            format!(
                "{around} the formula varies so fast that the limit of the calculation was reached before the extremes of {what} were proved: they, and what follows from them, may be larger than shown."
            )
        }
        FindingKind::Doubtful => {
            format!(
                "{around} the conditions hardly determine the curve: the least rounding of one of them changes its shape, and its figures cannot be trusted."
            )
        }
        FindingKind::BelowBase => {
            let base = if units.travels { "line" } else { "circle" };
            format!("The follower goes below the base {base}, down to {value} at {at}.")
        }
        FindingKind::SelfCrossing => {
            format!("The profile crosses itself: it goes through the same point at {at} and at {other}.")
        }
        FindingKind::ArmCutsCam if units.oscillating => {
            format!("At {at} the arm of the follower would cut {value} deep into the cam.")
        }
        FindingKind::ArmCutsCam => format!("At {at} the stem of the follower would cut {value} deep into the cam."),
        FindingKind::PivotInsideCam => {
            format!(
                "The cam sweeps over the pivot: at {at} it reaches {value} from its centre, and the pivot is at {limit}."
            )
        }
        FindingKind::FaceOvertaken => {
            format!(
                "At {at} the face turns {value} times as fast as the cam and in its sense, so that the contact runs away along it."
            )
        }
        FindingKind::ContactPastPivot => {
            format!("{around} the contact would be on the other side of the pivot, {value} along the face at {at}.")
        }
    }
}

pub(super) fn cure(finding: &DesignFinding, remedy: &Remedy, units: Units) -> String {
    match remedy {
        Remedy::BaseRadius { value, grows } => {
            let sign = if *grows { '≥' } else { '=' };
            format!("With Rb {sign} {} {}.", units.length(*value, EN), passing(finding.kind, units))
        }
        Remedy::Travel { value } => {
            format!("With a travel of {} {}.", units.length(*value, EN), passing(finding.kind, units))
        }
        Remedy::Tie { tie, grows } => {
            let sign = if *grows { '≥' } else { '≤' };
            let what = match tie {
                Tie::Distance(value) => format!("a distance {sign} {}", units.length(*value, EN)),
                Tie::Angle(value) => format!("an angle {sign} {} between the arms", EN.angle_exact(*value)),
                Tie::BaseRadius(value) => format!("a second base radius {sign} {}", units.length(*value, EN)),
            };
            format!("With {what} {}.", passing(finding.kind, units))
        }
        Remedy::Eccentricity { value, pressure_angle } => {
            let (e, angle) = (units.length(*value, EN), EN.angle(*pressure_angle));
            if finding.limit.is_some_and(|limit| *pressure_angle <= limit) {
                format!("With an eccentricity of {e} it stays within {angle}.")
            } else {
                format!("With an eccentricity of {e} it falls to {angle}.")
            }
        }
        Remedy::Length { key, value } => {
            let what = if *key == "arm" { "an arm" } else { "a pivot distance" };
            format!("With {what} of {} {}.", units.length(*value, EN), passing(finding.kind, units))
        }
        Remedy::NoSize { needed, instead } => no_size(finding, *needed, *instead, units),
        Remedy::Laws { changes, remaining_jump, price } => {
            let groups = by_law(changes)
                .into_iter()
                .map(|(law, segments)| format!("the {} law {}", crate::law(EN, law), in_segments(&segments)));
            let groups: Vec<String> = groups.collect();
            let result = match (finding.kind, remaining_jump) {
                (FindingKind::BelowBase, _) => "the follower stays above the base circle",
                (_, None) => "nothing jumps any more",
                (_, Some(Column::J)) => "only the jerk still jumps",
                (_, Some(_)) => "this jump is gone",
            };
            format!("With {} {result}{}.", row(&groups, "and"), price_of(price, units))
        }
    }
}

/// What a change of laws gives up, after what it brings: each figure as it is and as it becomes.
fn price_of(price: &Price, units: Units) -> String {
    let angle = price.pressure_angle.map(|(after, before)| format!("φ {} → {}", EN.angle(before), EN.angle(after)));
    let peak = price.acceleration.map(|ratio| format!("peak a × {}", EN.ratio(ratio)));
    let lift = price
        .lift
        .map(|(after, before)| format!("lift {} → {}", units.travel(before, 0, EN), units.travel(after, 0, EN)));
    let costs: Vec<String> = angle.into_iter().chain(peak).chain(lift).collect();
    if costs.is_empty() { String::new() } else { format!(" (price: {})", costs.join(", ")) }
}

/// That size is no cure, and what is.
fn no_size(finding: &DesignFinding, needed: Option<f64>, instead: Instead, units: Units) -> String {
    let Figures { at, .. } = Figures::of(finding, units, EN);
    let size = match needed.map(|size| units.length(size, EN)) {
        Some(size) if units.travels => format!("A longer travel does not cure this: it would have to be {size}."),
        Some(size) => format!("Size does not cure this: Rb would have to be {size}."),
        None if units.travels => "No travel cures this.".to_owned(),
        None if units.oscillating => "No length within reason cures this alone.".to_owned(),
        None => "No size cures this.".to_owned(),
    };
    let way = match instead {
        Instead::GentlerMotion => {
            let span = if units.travels { "travel" } else { "angle" };
            format!("A gentler motion at {at} would: less lift, or the same over more {span}.")
        }
        Instead::SmallerFaceAngle => "A smaller angle of the face would.".to_owned(),
        Instead::SmoothMotion => "First the motion has to be without jumps of displacement and velocity.".to_owned(),
    };
    format!("{size} {way}")
}

/// What another base circle brings, after it has been named.
fn passing(kind: FindingKind, units: Units) -> &'static str {
    match kind {
        FindingKind::PressureAngle => "it stays below",
        FindingKind::Cusp | FindingKind::Undercut => "the profile has neither cusps nor undercuts",
        FindingKind::GrooveUndercut => "neither wall of the groove is undercut",
        FindingKind::ConcaveFlat => "the flat face touches the whole profile",
        FindingKind::SelfCrossing => "the profile no longer crosses itself",
        FindingKind::ArmCutsCam if units.oscillating => "the arm clears the cam",
        FindingKind::ArmCutsCam => "the stem clears the cam",
        FindingKind::PivotInsideCam => "the cam clears the pivot",
        FindingKind::FaceOvertaken => "the face keeps its contact",
        FindingKind::ContactPastPivot => "the contact stays on its side of the pivot",
        FindingKind::Jump(_) | FindingKind::BelowBase | FindingKind::Doubtful | FindingKind::NotProved(_) => {
            "the cam is sound"
        }
    }
}

fn in_segments(segments: &[usize]) -> String {
    const NAMED: usize = 8;
    match segments {
        [one] => format!("in segment {one}"),
        many if many.len() > NAMED => format!("in {} segments", many.len()),
        many => format!("in segments {}", row(&many.iter().map(usize::to_string).collect::<Vec<_>>(), "and")),
    }
}
