//! The smallest cam that passes, and the eccentricity that balances the pressure angle: solved, not stepped.

use crate::extreme::extremes;
use crate::samples::{LEAST_STEPS, Quantity, Samples};
use crate::search::{self, root};
use crate::{Analysis, Body, Cam, Closure, Cycle, Drive, Program, Replay, Segment};

/// Steps of the first, coarse look at a candidate cam.
const COARSE_STEPS: usize = 120;

/// Base radii tried between the least and the greatest that the geometry allows, before the boundary is solved for.
const CANDIDATES: usize = 64;

/// How many times smaller and larger than the cam itself a base circle is looked for.
const SPAN: f64 = 1000.0;

/// Ratio of one base radius to the next in the search for one that passes.
const STRIDE: f64 = 1.5;

/// The least ρ that is no cusp, as a part of the base radius: twice what an analysis takes for one.
const CLEAR_OF_CUSP: f64 = 2e-9;

/// A base circle this small beside another is none: what passes down to here is not limited by its size.
const VANISHED: f64 = 1e-6;

/// Parts of a radius by which a solved cam is set inside its limit, so that rounding does not put it outside.
const INSIDE: f64 = 1e-12;

/// The smallest base radius with which every geometric limit is kept: |φ|, no cusp, no undercut, contact where it should be.
///
/// The program, the roller, the eccentricity and the pivot stay as they are. Candidates are looked at in order of size; the
/// boundary between the last that fails and the first that passes is then solved for with exact extremes, and the cam found is
/// analysed in full. None when no base circle passes, or when the smallest that keeps those limits fails another (an arm that cuts).
///
/// A jump of the motion is not cured by any base circle and is not looked at.
#[must_use]
pub fn smallest_base_radius(cam: &Cam) -> Option<f64> {
    let sized = cam.follower.drive == Drive::Turns && cam.follower.reversed.is_none();
    sized.then(|| Replay::whole(|replay| smallest_size(cam, replay))).flatten()
}

/// The shortest travel with which every geometric limit is kept, all β's in proportion, as [`smallest_base_radius`] is found.
/// None for a cam that turns.
#[must_use]
pub fn shortest_travel(cam: &Cam) -> Option<f64> {
    (cam.follower.drive == Drive::Travels).then(|| Replay::whole(|replay| smallest_size(cam, replay))).flatten()
}

/// The same cam with another base radius, or with another travel and all β's in proportion. None when the follower cannot rest on that
/// base circle, and for a travel with laws that are made from data, which were measured on the travel as it is.
#[must_use]
pub fn resized(cam: &Cam, size: f64) -> Option<Cam> {
    if cam.follower.drive == Drive::Turns {
        return cam.with_base_radius(size).ok();
    }
    let factor = size / cam.program.span();
    // What a free law goes through was measured on the travel as it is.
    if cam.program.given().iter().any(|segment| segment.law.free().is_some()) {
        return None;
    }
    let longer = |segment: &Segment| Segment { beta: segment.beta * factor, ..segment.clone() };
    let segments: Vec<Segment> = cam.program.given().iter().map(longer).collect();
    Some(cam.with_program(Program::on(Cycle::Travel(size), &segments).ok()?))
}

/// A limit that asks for a base circle of a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SizeLimit {
    /// |φ| stays within its limit.
    PressureAngle,
    /// The profile has no cusp and is not undercut; a flat face meets no hollow.
    Curvature,
}

/// The smallest base radius (or the shortest travel) with which one limit is kept, whatever becomes of the others. None when none does,
/// or when every one does, however small.
#[must_use]
pub fn smallest_for(cam: &Cam, limit: SizeLimit) -> Option<f64> {
    if cam.follower.reversed.is_some() {
        return None;
    }
    let shortfall = |size: f64, steps: usize| {
        let Some(sized) = resized(cam, size) else { return f64::INFINITY };
        let samples = Samples::on_grid(&sized, steps);
        match limit {
            SizeLimit::PressureAngle => steepness(&sized, &samples),
            SizeLimit::Curvature => -roundness(&sized, &samples),
        }
    };
    boundary(cam, shortfall).filter(|&size| size > VANISHED * cam.size())
}

/// The smallest base radius, or the shortest travel, with which every geometric limit is kept.
pub(crate) fn smallest_size(cam: &Cam, replay: &Replay) -> Option<f64> {
    let solved = boundary(cam, |size, steps| replay.value(|| shortfall(cam, size, steps)))?;
    let sized = resized(cam, solved)?;
    replay.holds(|| geometry_passes(&sized)).then_some(solved)
}

/// Ratio of one value of a follower's length to the next in the search for one that passes.
const FINE_STRIDE: f64 = 1.05;

/// The value of one length of a follower (its arm, the distance of its pivot) nearest to the present one with which every geometric
/// limit is kept, within the given range. `None` when the present one passes or no value in the range does.
pub(crate) fn nearest_length(cam: &Cam, index: usize, (low, high): (f64, f64), replay: &Replay) -> Option<f64> {
    let now = cam.follower.values[index];
    let with = |value: f64| Some(cam.with_follower(cam.follower.with_value(index, value).ok()?));
    let shortfall =
        |value: f64, steps: usize| replay.value(|| with(value).map_or(f64::INFINITY, |cam| shortfall_of(&cam, steps)));
    let strides = (high / low).ln() / FINE_STRIDE.ln();
    let tried = (1..=strides.max(0.0) as i32).flat_map(|k| [now * FINE_STRIDE.powi(k), now * FINE_STRIDE.powi(-k)]);
    let inside = |value: &f64| (low..=high).contains(value);
    let first = tried.filter(inside).find(|&value| {
        !replay.is_short() && shortfall(value, COARSE_STEPS) <= 0.0 && shortfall(value, LEAST_STEPS) <= 0.0
    })?;
    let towards_now = if first > now { first / FINE_STRIDE } else { first * FINE_STRIDE };
    let exact = |value: f64| shortfall(value, LEAST_STEPS);
    let shortfall_there = exact(towards_now);
    let passes = if shortfall_there.is_finite() && shortfall_there > 0.0 {
        root(towards_now, first, exact) * if first > now { 1.0 + INSIDE } else { 1.0 - INSIDE }
    } else {
        let close = |passes: f64, fails: f64| (passes - fails).abs() <= LENGTH_TOLERANCE * now || replay.is_short();
        search::boundary((first, towards_now), close, |value| exact(value) <= 0.0)
    };
    let moved = with(passes)?;
    (inside(&passes) && replay.holds(|| geometry_passes(&moved))).then_some(passes)
}

/// A length of a follower is halved down to this part of it where its boundary is no root.
const LENGTH_TOLERANCE: f64 = 1e-6;

/// A size is halved down to this part of it where its boundary is no root.
const SIZE_TOLERANCE: f64 = 1e-12;

/// The least size for which a shortfall, looked at in so many steps, is none.
fn boundary(cam: &Cam, shortfall: impl Fn(f64, usize) -> f64) -> Option<f64> {
    let passes = |size: f64, steps: usize| shortfall(size, steps) <= 0.0;
    let (low, high) = match cam.follower.body {
        Body::Slide => bracket_of_a_slide(cam, passes)?,
        Body::Swing { pivot } => {
            let tried = candidates(cam, pivot.norm());
            let first = tried.iter().position(|&radius| passes(radius, COARSE_STEPS))?;
            // The coarse look may pass what the exact one fails: move up until it agrees.
            let first = first + tried[first..].iter().position(|&radius| passes(radius, LEAST_STEPS))?;
            (if first == 0 { 0.0 } else { tried[first - 1] }, tried[first])
        }
    };
    let exact = |radius: f64| shortfall(radius, LEAST_STEPS);
    let solved = if exact(low).is_finite() {
        root(low, high, exact)
    } else {
        // The shortfall is infinite where the geometry cannot be. A boundary at zero is left where the base circle has vanished.
        let vanished = VANISHED * high;
        let close = |passes: f64, fails: f64| passes - fails <= SIZE_TOLERANCE * passes || passes <= vanished;
        search::boundary((high, low), close, |size| exact(size) <= 0.0)
    };
    Some(solved * (1.0 + INSIDE))
}

/// The eccentricity for which the greatest φ of the rise equals that of the return, φmax + φmin = 0: a length, positive to the right of
/// the cam's centre. None for a follower without one, and when no eccentricity within nine tenths of Rp balances them.
#[must_use]
pub fn balanced_eccentricity(cam: &Cam) -> Option<f64> {
    let index = cam.follower.kind.index_of("eccentricity")?;
    let prime_radius = cam.follower.base_radius + cam.follower.disc_radius();
    let imbalance = |eccentricity: f64| {
        let Ok(follower) = cam.follower.with_value(index, eccentricity) else { return f64::NAN };
        let moved = cam.with_follower(follower);
        let angles = extremes(&moved, &Samples::on_grid(&moved, LEAST_STEPS), Quantity::PressureAngle);
        angles.max + angles.min
    };
    let edge = 0.9 * prime_radius;
    let (low, high) = (imbalance(-edge), imbalance(edge));
    (low * high < 0.0).then(|| root(-edge, edge, imbalance))
}

/// True when a cam keeps every geometric limit: whatever is found in it, the motion itself is to blame.
#[must_use]
pub fn geometry_passes(cam: &Cam) -> bool {
    Analysis::geometry_passes(cam)
}

/// How far a base radius (or a travel) is from passing: positive when it fails, infinite when the geometry cannot be.
fn shortfall(cam: &Cam, size: f64, steps: usize) -> f64 {
    resized(cam, size).map_or(f64::INFINITY, |sized| shortfall_of(&sized, steps))
}

/// How far a cam is from keeping its geometric limits, arms that cut apart: positive when one is passed.
pub(crate) fn shortfall_of(cam: &Cam, steps: usize) -> f64 {
    let samples = Samples::on_grid(cam, steps);
    steepness(cam, &samples).max(-roundness(cam, &samples)).max(misplacement(cam, &samples))
}

/// How far the greatest |φ| is beyond its limit, as a part of it.
fn steepness(cam: &Cam, samples: &Samples) -> f64 {
    let angle = extremes(cam, samples, Quantity::PressureAngle).greatest_size().0;
    angle / cam.follower.pressure_angle_limit() - 1.0
}

/// How far the least convex ρ is from a cusp, in base radii; much, when nothing is convex.
fn roundness(cam: &Cam, samples: &Samples) -> f64 {
    let bend = extremes(cam, samples, Quantity::Bend);
    let tightest = if cam.follower.is_flat() { bend.min } else { bend.max.max(f64::MIN_POSITIVE) };
    let inner = (cam.follower.profile_radius(tightest) / cam.size() - CLEAR_OF_CUSP).min(1.0);
    let grooved = cam.closure == Closure::Groove;
    if grooved { inner.min(1.0 + cam.follower.disc_radius() * bend.min - CLEAR_OF_CUSP) } else { inner }
}

/// Positive when a swinging face lags behind the cam or loses its contact past the pivot, or when the cam reaches the pivot.
fn misplacement(cam: &Cam, samples: &Samples) -> f64 {
    let Body::Swing { pivot } = cam.follower.body else { return f64::NEG_INFINITY };
    let past_pivot = extremes(cam, samples, Quantity::outmost(cam)).max / pivot.norm() - 1.0;
    if !cam.follower.is_flat() {
        return past_pivot;
    }
    let reach = extremes(cam, samples, Quantity::Reach).min;
    let lead = extremes(cam, samples, Quantity::Lead).min;
    past_pivot.max(-reach / pivot.norm()).max(-lead)
}

/// A failing and a passing base radius for a sliding follower, whose limits are all kept better by a larger base circle.
fn bracket_of_a_slide(cam: &Cam, passes: impl Fn(f64, usize) -> bool) -> Option<(f64, f64)> {
    let now = cam.size();
    let mut radius = now;
    if passes(radius, LEAST_STEPS) {
        while radius > now / SPAN {
            if !passes(radius / STRIDE, LEAST_STEPS) {
                return Some((radius / STRIDE, radius));
            }
            radius /= STRIDE;
        }
        return Some((0.0, radius));
    }
    while radius < now * SPAN {
        if passes(radius * STRIDE, LEAST_STEPS) {
            return Some((radius, radius * STRIDE));
        }
        radius *= STRIDE;
    }
    None
}

/// Base radii to try for a swinging follower, evenly between those that its pivot allows.
fn candidates(cam: &Cam, pivot_distance: f64) -> Vec<f64> {
    let follower = &cam.follower;
    let (low, high) = match follower.value("arm") {
        Some(arm) => {
            let radius = follower.disc_radius();
            ((pivot_distance - arm).abs() - radius, pivot_distance + arm - radius)
        }
        None => {
            let offset = follower.value("face_offset").unwrap_or(0.0);
            (offset - pivot_distance, offset + pivot_distance)
        }
    };
    let low = low.max(0.0);
    (1..CANDIDATES).map(|i| low + (high - low) * i as f64 / CANDIDATES as f64).collect()
}
