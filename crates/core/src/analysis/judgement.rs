//! What is wrong with a cam, and where.

use super::Summary;
use crate::arm::{arm_cut, arm_cuts};
use crate::extreme::{EQUAL, extremes, greatest_within, intervals};
use crate::interference::crossing;
use crate::samples::{Quantity, Samples};
use crate::{Body, Cam, Closure, Extremes, Finding, FindingKind, Joint, Level, Program};
use std::f64::consts::TAU;

/// |φ| may pass its limit by this much (radians), which is rounding: a cure that is solved for lands on the limit.
const ANGLE_TOLERANCE: f64 = 1e-9;

/// ρ this small beside the base radius is a cusp; so is a cam that a cure has brought to the edge.
const CUSP_TOLERANCE: f64 = 1e-9;

/// How far below the base circle rounding may take the follower, as a part of its whole travel.
const BELOW_TOLERANCE: f64 = 1e-9;

/// Every finding, in the order of [`Finding::gravest_first`].
pub(super) fn judge(cam: &Cam, samples: &Samples, summary: &Summary, joints: &[Joint]) -> Vec<Finding> {
    let mut findings = jumps(cam, joints);
    findings.extend(doubtful(&cam.program));
    findings.extend(steep(cam, samples, summary));
    findings.extend(below_base(cam, samples, summary));
    let mut cuts = irregular(cam, samples, summary);
    cuts.extend(groove_cuts(cam, samples));
    let regular = cuts.is_empty();
    findings.extend(cuts);
    findings.extend(misplaced(cam, samples, summary));
    if regular {
        let crossing = crossing(samples);
        let crosses = crossing.is_some();
        findings.extend(crossing);
        findings.extend(arm_cut(cam, samples, crosses));
    }
    findings.extend(not_proved(cam));
    findings.sort_by(Finding::gravest_first);
    findings
}

/// True when nothing is found but what is of the motion, see [`FindingKind::is_of_the_motion`]: what costs most is looked at last.
pub(super) fn geometry_passes(cam: &Cam, samples: &Samples, summary: &Summary) -> bool {
    steep(cam, samples, summary).is_none()
        && irregular(cam, samples, summary).is_empty()
        && groove_cuts(cam, samples).is_none()
        && misplaced(cam, samples, summary).is_empty()
        && crossing(samples).is_none()
        && !arm_cuts(cam, samples)
}

/// One finding for each order that jumps, with all its places.
fn jumps(cam: &Cam, joints: &[Joint]) -> Vec<Finding> {
    let size = |joint: &Joint, order: u8| {
        (joint.after.order(usize::from(order)) - joint.before.order(usize::from(order))).abs()
    };
    let of_order = |order: u8| {
        let here: Vec<&Joint> = joints.iter().filter(|joint| joint.jump == Some(order)).collect();
        let largest = here.iter().map(|joint| size(joint, order)).max_by(f64::total_cmp)?;
        let worst = here.iter().find(|joint| size(joint, order) >= largest * (1.0 - EQUAL))?;
        Some(Finding {
            kind: FindingKind::Jump(order),
            level: FindingKind::Jump(order).severity(cam.closure),
            theta: worst.theta,
            interval: None,
            places: here.iter().map(|joint| joint.theta).collect(),
            value: largest,
            limit: 0.0,
        })
    };
    (0..4).filter_map(of_order).collect()
}

/// Free laws whose curve is not to be trusted.
fn doubtful(program: &Program) -> impl Iterator<Item = Finding> {
    program.doubts().iter().map(|doubt| {
        let stretch = (program.borders()[doubt.segment], program.borders()[doubt.segment + 1]);
        finding(FindingKind::Doubtful, stretch.0, doubt.condition, doubt.limit, Some(stretch))
    })
}

/// Formulas of which not every extreme is proved.
fn not_proved(cam: &Cam) -> impl Iterator<Item = Finding> {
    cam.program.stretches().iter().filter_map(|stretch| {
        let (order, from, to) = stretch.unproved()?;
        let kind = FindingKind::NotProved(order);
        Some(Finding { level: kind.severity(cam.closure), ..finding(kind, from, 0.0, 0.0, Some((from, to))) })
    })
}

fn steep(cam: &Cam, samples: &Samples, summary: &Summary) -> Option<Finding> {
    let limit = cam.follower.pressure_angle_limit();
    let (value, theta) = summary.pressure_angle.greatest_size();
    (value > limit + ANGLE_TOLERANCE).then(|| {
        let stretches = intervals(cam, samples, Quantity::PressureAngle, theta, |angle| angle.abs() - limit);
        finding(FindingKind::PressureAngle, theta, value, limit, around(cam, &stretches, theta))
    })
}

fn below_base(cam: &Cam, samples: &Samples, summary: &Summary) -> Option<Finding> {
    let Extremes { min, min_at, .. } = summary.s;
    (min < -BELOW_TOLERANCE * summary.s.max.abs().max(f64::MIN_POSITIVE)).then(|| {
        let stretches = intervals(cam, samples, Quantity::S, min_at, |s| -s);
        finding(FindingKind::BelowBase, min_at, min, 0.0, around(cam, &stretches, min_at))
    })
}

/// Cusps and undercut stretches, each stretch with its own worst place.
fn irregular(cam: &Cam, samples: &Samples, summary: &Summary) -> Vec<Finding> {
    let Some((least, theta)) = summary.least_convex else { return Vec::new() };
    let edge = CUSP_TOLERANCE * cam.size();
    if least > edge {
        return Vec::new();
    }
    if least >= -edge {
        return vec![finding(FindingKind::Cusp, theta, 0.0, 0.0, None)];
    }
    let kind = if cam.follower.is_flat() { FindingKind::ConcaveFlat } else { FindingKind::Undercut };
    let follower = &cam.follower;
    let stretches = intervals(cam, samples, Quantity::Bend, theta, |bend| -follower.regularity(bend));
    let each = stretches.iter().map(|&(from, to)| {
        let (value, at) = if within(cam, (from, to), theta) {
            (least, theta)
        } else {
            let sign = if cam.follower.is_flat() { -1.0 } else { 1.0 };
            let (bend, at) = greatest_within(cam, samples, Quantity::Bend, sign, (from, to));
            (follower.profile_radius(bend), at)
        };
        finding(kind, at, value, 0.0, Some((from, to)))
    });
    each.collect()
}

/// Stretches of a groove whose outer wall, the pitch curve offset outwards, is cut away in a hollow: 1 + Rf·κp < 0.
fn groove_cuts(cam: &Cam, samples: &Samples) -> Option<Finding> {
    if cam.closure != Closure::Groove {
        return None;
    }
    let radius = cam.follower.disc_radius();
    let Extremes { min, min_at, .. } = extremes(cam, samples, Quantity::Bend);
    (1.0 + radius * min < -CUSP_TOLERANCE).then(|| {
        let stretches = intervals(cam, samples, Quantity::Bend, min_at, |bend| -1.0 - radius * bend);
        let place = around(cam, &stretches, min_at);
        finding(FindingKind::GrooveUndercut, min_at, -1.0 / min, radius, place)
    })
}

/// A pivot or a swinging face where it cannot be.
fn misplaced(cam: &Cam, samples: &Samples, summary: &Summary) -> Vec<Finding> {
    let mut findings = Vec::new();
    let Body::Swing { pivot } = cam.follower.body else { return findings };
    let radius = extremes(cam, samples, Quantity::outmost(cam));
    if radius.max >= pivot.norm() {
        findings.push(finding(FindingKind::PivotInsideCam, radius.max_at, radius.max, pivot.norm(), None));
    }
    if let Some(reach) = summary.reach {
        let lead = extremes(cam, samples, Quantity::Lead);
        if lead.min <= 0.0 {
            findings.push(finding(FindingKind::FaceOvertaken, lead.min_at, 1.0 - lead.min, 1.0, None));
        } else if reach.min <= 0.0 {
            let stretches = intervals(cam, samples, Quantity::Reach, reach.min_at, |reach| -reach);
            let interval = around(cam, &stretches, reach.min_at);
            findings.push(finding(FindingKind::ContactPastPivot, reach.min_at, reach.min, 0.0, interval));
        }
    }
    findings
}

pub(crate) fn finding(kind: FindingKind, theta: f64, value: f64, limit: f64, interval: Option<(f64, f64)>) -> Finding {
    // Only jumps and what is not proved are ever less than unacceptable.
    Finding { kind, level: Level::Unacceptable, theta, interval, places: vec![theta], value, limit }
}

fn within(cam: &Cam, (from, to): (f64, f64), theta: f64) -> bool {
    let again = theta + TAU;
    from <= theta && theta <= to || cam.program.is_cyclic() && from <= again && again <= to
}

fn around(cam: &Cam, stretches: &[(f64, f64)], theta: f64) -> Option<(f64, f64)> {
    stretches.iter().copied().find(|&stretch| within(cam, stretch, theta))
}
