//! Another kind of cam from the same design.

use super::data::{backwards, flipped};
use super::follower::exchange;
use super::program::{bridge, has_room, plain, spread};
use super::{Left, dwell};
use crate::decimal::Decimal;
use crate::digits::{DIGITS, clean, half_figures, round};
use crate::report::degrees;
use crate::{BreadthGenerator, CamKind, Design, DesignError, EditRefusal, SegmentDesign, Speed, SpeedUnit, unsuited};
use levalab_core::{FOLLOWERS, FollowerKind, Generator, Law, Rotation, sharpest_base_radius};
use std::f64::consts::TAU;

/// Length of a cam that travels, for each length that its follower rises in it: φ then stays moderate with the usual laws.
const GENTLE: f64 = 4.0;

/// Length of a cam that travels under a follower that stays, as multiples of the base radius that it had.
const IDLE_LENGTH: f64 = 3.0;

/// Base radius of a cam that turns, as multiples of the travel of its follower.
const STOUT: f64 = 4.0;

/// Travel of a cam of constant breadth whose program does not rise, as a share of the base radius.
const IDLE_TRAVEL: f64 = 0.5;

/// How far a polygon of arcs is from sharp corners to a circle, to begin with.
const ROUND_CORNERS: f64 = 0.25;

/// Digits of a speed that follows from another.
const SPEED_DIGITS: i32 = 2;

/// Sides of a polygon of arcs, to begin with.
const FEWEST_SIDES: u32 = 3;

/// Another kind of cam. By way of a cam that turns: what comes from another kind becomes a program over the turn, what goes to
/// another is made from that.
pub(super) fn change(design: &mut Design, kind: &'static str) -> Result<(), DesignError> {
    if design.kind.word() == kind {
        return Ok(());
    }
    design.conjugate = None;
    let [_, grooved, breadth, travels] = CamKind::WORDS.map(|word| word == kind);
    if travels || design.kind.travel().is_some() {
        // Points to hit have their places on the other cam.
        if let Some(application) = &mut design.application {
            application.targets.clear();
        }
    }
    match design.kind {
        CamKind::ConstantBreadth { generator, .. } => unfold(design, generator)?,
        CamKind::Translating { length } => bend(design, length)?,
        CamKind::Rotating | CamKind::Grooved => {}
    }
    design.kind = CamKind::Rotating;
    if let Some(follower) = nearest_follower(kind, design.follower) {
        exchange(design, follower);
    }
    if grooved {
        design.kind = CamKind::Grooved;
    } else if breadth {
        fold(design);
    } else if travels {
        straighten(design)?;
    }
    Ok(())
}

/// Back to a kind that was left: what was not changed since is as it was before, and what was changed goes the way of any change.
pub(super) fn change_back(design: &mut Design, kind: &'static str, left: &Left) -> Result<(), DesignError> {
    let Left { before, after } = left;
    let now = design.clone();
    change(design, kind)?;
    let same_measures = now.length_unit == after.length_unit && now.follower.motion == after.follower.motion;
    if !same_measures || before.kind.word() != kind {
        return Ok(());
    }
    if now.segments == after.segments && now.kind == after.kind {
        design.segments.clone_from(&before.segments);
        (design.kind, design.rotation, design.base_radius) = (before.kind, before.rotation, before.base_radius);
    }
    if now.speed == after.speed {
        design.speed = before.speed;
    }
    if (now.follower, now.values) == (after.follower, after.values) {
        (design.follower, design.values) = (before.follower, before.values);
    }
    if now.application == after.application {
        design.application.clone_from(&before.application);
    }
    if now.conjugate == after.conjugate {
        design.conjugate = before.conjugate;
    }
    // What turns the same way and is as large as it became is as large as it was.
    if now.rotation != after.rotation {
        design.rotation = now.rotation;
    }
    if now.base_radius != after.base_radius {
        design.base_radius = now.base_radius;
    }
    Ok(())
}

/// The follower that the kind has a place for and that is most like another: itself, a roller that moves alike, a radial roller.
fn nearest_follower(kind: &str, follower: &FollowerKind) -> Option<&'static FollowerKind> {
    let roller =
        |kind: &&&FollowerKind| kind.motion == follower.motion && kind.contact == levalab_core::ContactKind::Roller;
    let own = FOLLOWERS.iter().find(|kind| kind.id == follower.id);
    let alike = FOLLOWERS.iter().find(roller);
    let fits = |follower: &&'static FollowerKind| unsuited(kind, follower).is_none();
    [own, alike, FOLLOWERS.first()].into_iter().flatten().copied().find(fits)
}

/// Half a turn between two faces, its travel that of the program, from the classic motion.
fn fold(design: &mut Design) {
    let (base, lift) = (design.base_radius, design.draft_lift());
    let travel = (if lift > 0.0 { lift } else { IDLE_TRAVEL * base }).min(base);
    centre(design);
    let breadth = (Decimal::of(base) + Decimal::of(base) + Decimal::of(clean(travel))).to_f64();
    design.kind = CamKind::ConstantBreadth { breadth, generator: BreadthGenerator::Ready(Generator::Harmonic) };
    design.segments.clear();
}

/// The whole turn of a cam of constant breadth, as segments.
fn unfold(design: &mut Design, generator: BreadthGenerator) -> Result<(), DesignError> {
    let travel = design.breadth_travel().unwrap_or(0.0);
    match generator {
        BreadthGenerator::Mirror => {
            has_room(2 * design.segments.len())?;
            let image: Vec<SegmentDesign> = design.segments.iter().map(|segment| flipped(segment, travel)).collect();
            design.segments.extend(image);
            design.kind = CamKind::Rotating;
        }
        BreadthGenerator::Ready(generator) => {
            let half = generator.half_turn(travel);
            has_room(2 * half.len())?;
            let told = |sign: f64| {
                half.iter().map(move |segment| {
                    let law = Law::by_id(segment.law.id).map_or("cycloidal", |law| law.id);
                    plain(law, clean(degrees(segment.beta)), clean(sign * segment.rise))
                })
            };
            design.segments = told(1.0).chain(told(-1.0)).collect();
            design.kind = CamKind::Rotating;
            spread(design)?;
        }
    }
    Ok(())
}

/// A turn laid out straight, long enough for its steepest segment.
fn straighten(design: &mut Design) -> Result<(), DesignError> {
    let heights = design.draft_heights();
    let whole = design.kind.whole();
    let steepness = |(k, segment): (usize, &SegmentDesign)| {
        let rise = (heights[k + 1] - heights[k]).to_f64().abs();
        GENTLE * rise * whole / segment.beta
    };
    let steepest = design.segments.iter().enumerate().map(steepness).fold(0.0, f64::max);
    let length = half_figures(if steepest > 0.0 { steepest } else { IDLE_LENGTH * design.base_radius }, f64::ceil);
    let pace = round(design.omega() / TAU * length, SPEED_DIGITS, f64::round);
    design.speed = Speed { value: pace, unit: SpeedUnit::LengthPerSecond };
    centre(design);
    design.rotation = Rotation::default();
    design.base_radius = 0.0;
    design.kind = CamKind::Translating { length };
    if design.segments.is_empty() {
        design.segments.push(dwell(length));
    }
    spread(design)
}

/// A cam that travels, bent round: there in half a turn and back in the other when it does not come back by itself.
fn bend(design: &mut Design, length: f64) -> Result<(), DesignError> {
    let heights = design.draft_heights();
    let lift = design.draft_lift();
    let turns = round(TAU * design.speed.value / length, SPEED_DIGITS, f64::round);
    design.speed = Speed { value: turns, unit: SpeedUnit::RadiansPerSecond };
    design.base_radius = half_figures((length / TAU).max(STOUT * lift), f64::ceil);
    design.kind = CamKind::Rotating;
    if design.open_height() != Decimal::default() {
        has_room(2 * design.segments.len())?;
        let there = design.segments.iter().enumerate().rev();
        let back = there.map(|(k, segment)| {
            backwards(segment).unwrap_or_else(|| bridge(segment.beta, (heights[k] - heights[k + 1]).to_f64()))
        });
        let back: Vec<SegmentDesign> = back.collect();
        design.segments.extend(back);
    }
    spread(design)
}

/// Nothing off the axis.
fn centre(design: &mut Design) {
    for key in ["eccentricity", "face_angle"] {
        if let Some(index) = design.follower.index_of(key) {
            design.values[index] = 0.0;
        }
    }
}

/// The motion of a cam of constant breadth made another way. A base circle too small for arcs grows, so that the corners are round.
pub(super) fn change_generator(
    design: &mut Design,
    generator: &'static str,
    sides: Option<u32>,
) -> Result<(), DesignError> {
    let CamKind::ConstantBreadth { breadth, generator: old } = design.kind else {
        return Err(DesignError::at(["cam", "generator"], EditRefusal::NoGenerator));
    };
    let travel = design.breadth_travel().unwrap_or(0.0);
    let words = BreadthGenerator::WORDS;
    design.segments.clear();
    let next = if generator == words[0] {
        BreadthGenerator::Ready(Generator::Harmonic)
    } else if generator == words[1] {
        let had = match old {
            BreadthGenerator::Ready(Generator::CircularArc { sides }) => Some(sides),
            _ => None,
        };
        let sides = sides.or(had).unwrap_or(FEWEST_SIDES);
        let least = sharpest_base_radius(sides.max(FEWEST_SIDES), breadth);
        let round_corners = least + ROUND_CORNERS * (0.5 * breadth - least);
        if design.base_radius < round_corners {
            design.base_radius = round(round_corners, DIGITS, f64::round);
        }
        BreadthGenerator::Ready(Generator::CircularArc { sides })
    } else {
        design.segments = vec![plain("cycloidal", 120.0, travel), dwell(60.0)];
        BreadthGenerator::Mirror
    };
    design.kind = CamKind::ConstantBreadth { breadth, generator: next };
    Ok(())
}
