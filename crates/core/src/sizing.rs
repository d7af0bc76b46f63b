//! The smallest cam that passes, and the eccentricity that balances the pressure angle: solved, not stepped.

use crate::extreme::{extremes, root};
use crate::samples::Samples;
use crate::{Analysis, Body, Cam, FindingKind, Follower};

/// Steps of the first, coarse look at a candidate cam.
const COARSE_STEPS: usize = 120;

/// Base radii tried between the least and the greatest that the geometry allows, before the boundary is solved for.
const CANDIDATES: usize = 64;

/// How many times smaller and larger than the cam itself a base circle is looked for.
const SPAN: f64 = 100.0;

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
    let tried = candidates(cam);
    let passes = |base_radius: f64, steps: usize| shortfall(cam, base_radius, steps) <= 0.0;
    let first = tried.iter().position(|&radius| passes(radius, COARSE_STEPS))?;
    if first == 0 {
        return Some(tried[0]);
    }
    // The coarse look may pass what the exact one fails: move up until it agrees.
    let high = tried[first..].iter().copied().find(|&radius| passes(radius, 720))?;
    let low = tried.iter().copied().filter(|&radius| radius < high).next_back()?;
    let exact = |radius: f64| shortfall(cam, radius, 720);
    let solved = if exact(low).is_finite() { root(low, high, exact) } else { bisect(low, high, exact) };
    let solved = solved * (1.0 + INSIDE);
    geometry_passes(&cam.with_base_radius(solved).ok()?).then_some(solved)
}

/// The eccentricity for which the greatest φ of the rise equals that of the return, when the follower has one.
#[must_use]
pub fn balanced_eccentricity(cam: &Cam) -> Option<f64> {
    let index = cam.follower.kind.index_of("eccentricity")?;
    let prime_radius = cam.follower.base_radius + cam.follower.disc_radius();
    let imbalance = |eccentricity: f64| {
        let Ok(follower) = cam.follower.with_value(index, eccentricity) else { return f64::NAN };
        let moved = Cam::new(cam.program.clone(), follower);
        let angles = extremes(&moved, &Samples::of(&moved, 720), |_, contact| contact.pressure_angle);
        angles.max + angles.min
    };
    let edge = 0.9 * prime_radius;
    let (low, high) = (imbalance(-edge), imbalance(edge));
    (low * high < 0.0).then(|| root(-edge, edge, imbalance))
}

/// True when nothing but the motion itself is to blame.
pub(crate) fn geometry_passes(cam: &Cam) -> bool {
    Analysis::of(cam, 720).findings.iter().all(|finding| matches!(finding.kind, FindingKind::Jump(_) | FindingKind::BelowBase))
}

/// How far a base radius is from passing: positive when it fails, infinite when the geometry cannot be.
fn shortfall(cam: &Cam, base_radius: f64, steps: usize) -> f64 {
    let Ok(follower) = cam.follower.with_base_radius(base_radius) else { return f64::INFINITY };
    let sized = Cam::new(cam.program.clone(), follower);
    let samples = if steps < 720 { Samples::coarse(&sized, steps) } else { Samples::of(&sized, steps) };
    let angle = extremes(&sized, &samples, |_, contact| contact.pressure_angle).greatest_size().0;
    let steepness = angle / follower.pressure_angle_limit() - 1.0;
    steepness.max(-least_regularity(&sized, &samples, &follower)).max(misplacement(&sized, &samples))
}

fn least_regularity(cam: &Cam, samples: &Samples, follower: &Follower) -> f64 {
    let bend = extremes(cam, samples, |_, contact| contact.bend);
    follower.regularity(if follower.is_flat() { bend.min } else { bend.max })
}

/// Positive when a swinging face lags behind the cam or loses its contact past the pivot, or when the cam reaches the pivot.
fn misplacement(cam: &Cam, samples: &Samples) -> f64 {
    let Body::Swing { pivot } = cam.follower.body else { return f64::NEG_INFINITY };
    let outermost = samples.all.iter().map(|sample| sample.contact.point.norm()).fold(0.0, f64::max);
    let past_pivot = outermost / pivot.norm() - 1.0;
    if !cam.follower.is_flat() {
        return past_pivot;
    }
    let reach = samples.all.iter().map(|sample| sample.contact.reach).fold(f64::INFINITY, f64::min);
    let lead = samples.all.iter().map(|sample| sample.contact.lead).fold(f64::INFINITY, f64::min);
    past_pivot.max(-reach / pivot.norm()).max(-lead)
}

/// Base radii to try, from small to large: evenly where a pivot bounds them, in proportion where nothing does.
fn candidates(cam: &Cam) -> Vec<f64> {
    let part = |i: usize| i as f64 / CANDIDATES as f64;
    let (low, high) = match cam.follower.body {
        Body::Slide => {
            let travel = cam.program.stretches().iter().map(|stretch| stretch.at(stretch.to).s.abs()).fold(0.0, f64::max);
            let size = cam.follower.base_radius.max(travel).max(cam.follower.disc_radius());
            return (0..=2 * CANDIDATES).map(|i| size / SPAN * (SPAN * SPAN).powf(part(i) / 2.0)).collect();
        }
        Body::Swing { pivot } => match (cam.follower.value("arm"), cam.follower.value("face_offset")) {
            (Some(arm), _) => {
                let radius = cam.follower.disc_radius();
                ((pivot.norm() - arm).abs() - radius, pivot.norm() + arm - radius)
            }
            (None, offset) => {
                let offset = offset.unwrap_or(0.0);
                (offset - pivot.norm(), offset + pivot.norm())
            }
        },
    };
    let low = low.max(0.0);
    (1..CANDIDATES).map(|i| low + (high - low) * part(i)).collect()
}

/// The boundary of a condition that is infinite on its failing side.
fn bisect(mut low: f64, mut high: f64, shortfall: impl Fn(f64) -> f64) -> f64 {
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if shortfall(middle) > 0.0 { low = middle } else { high = middle }
    }
    high
}
