//! Contact where there should be none: a profile that crosses itself, an arm or stem that cuts the cam.

use crate::analysis::finding;
use crate::samples::Samples;
use crate::{Body, Cam, Element, Finding, FindingKind, Point};

/// In how many places of the turn an arm is tried against as many of the profile, however many stations are asked for.
const ARM_PLACES: usize = 180;

/// A cut shallower than this part of the base radius is rounding of a polygon, not a cut.
const SHALLOWEST_CUT: f64 = 1e-6;

/// The profile crossing itself, for a profile without cusps.
///
/// When the outward normal looks away from the centre all along (a star-shaped profile) there is nothing to look for. Otherwise
/// the polygon of samples is searched for two sides that cross, sorted by their left ends.
pub(crate) fn crossing(samples: &Samples) -> Option<Finding> {
    if samples.star_shaped {
        return None;
    }
    let profile = &samples.profile;
    let mut sides: Vec<(f64, f64, usize)> = profile
        .windows(2)
        .enumerate()
        .map(|(i, pair)| (pair[0].re.min(pair[1].re), pair[0].re.max(pair[1].re), i))
        .collect();
    sides.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let last = profile.len() - 2;
    for (k, &(_, right, i)) in sides.iter().enumerate() {
        for &(left, _, other) in &sides[k + 1..] {
            if left > right {
                break;
            }
            let apart = i.abs_diff(other);
            let neighbours = apart <= 2 || apart >= last - 1;
            if !neighbours && sides_cross(&profile[i..=i + 1], &profile[other..=other + 1]) {
                let (theta, second) = (samples.station(i.min(other)), samples.station(i.max(other)));
                return Some(Finding {
                    places: vec![theta, second],
                    ..finding(FindingKind::SelfCrossing, theta, 0.0, 0.0, None)
                });
            }
        }
    }
    None
}

fn sides_cross(a: &[Point], b: &[Point]) -> bool {
    let side = |p: Point, q: Point, r: Point| cross(q - p, r - p);
    side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < 0.0 && side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) < 0.0
}

/// The arm (from roller to pivot) or the stem (from roller straight up), taken as a line without thickness, cutting the cam.
///
/// Seen from the centre of a star-shaped profile, the arm is cut where the profile reaches beyond it. Only the part of the arm
/// within the cam's greatest radius matters, and only the profile in the sector that this part spans.
pub(crate) fn arm_cut(cam: &Cam, samples: &Samples) -> Option<Finding> {
    let Element::Disc { centre, .. } = cam.follower.element else { return None };
    let radial = cam.follower.body == Body::Slide && centre.re == 0.0;
    if !samples.star_shaped || radial {
        return None;
    }
    let stride = (samples.profile.len() / ARM_PLACES).max(1);
    let profile: Vec<Point> = samples.profile.iter().copied().step_by(stride).collect();
    let reach = profile.iter().map(Point::norm_sqr).fold(0.0, f64::max).sqrt();
    let sense = cam.follower.rotation.sigma();
    let mut worst = (SHALLOWEST_CUT * cam.size(), 0.0);
    for (k, i) in (0..samples.pitch.len()).step_by(stride).enumerate() {
        // The arm in the cam's frame, where the profile stands still.
        let (from, turned) = (samples.pitch[i], samples.turns[i]);
        let along = match cam.follower.body {
            Body::Slide => Point::new(0.0, (reach + from.norm()) * cam.follower.advance()) * turned,
            Body::Swing { pivot } => pivot * turned - from,
        };
        let Some(tip) = leaves_circle(from, along, reach) else { continue };
        let direction = (tip - from) / (tip - from).norm();
        let turn = cross(from, tip);
        let centre_side = cross(direction, -from);
        if turn == 0.0 || centre_side == 0.0 {
            continue;
        }
        // Profile points follow each other clockwise in the cam's frame when it turns counter-clockwise.
        let forward = (turn > 0.0) == (sense < 0.0);
        let n = profile.len();
        for step in 1..n {
            let point = profile[if forward { (k + step) % n } else { (k + n - step) % n }];
            if cross(point, tip) * turn.signum() < 0.0 {
                break;
            }
            let beyond = -cross(direction, point - from) * centre_side.signum();
            if cross(from, point) * turn.signum() > 0.0 && beyond > worst.0 {
                worst = (beyond, samples.station(i));
            }
        }
    }
    let (depth, theta) = worst;
    (depth > SHALLOWEST_CUT * cam.size()).then(|| finding(FindingKind::ArmCutsCam, theta, depth, 0.0, None))
}

/// Where the arm from `start` along `along` last leaves the circle of radius `reach`; its end when that lies inside.
fn leaves_circle(start: Point, along: Point, reach: f64) -> Option<Point> {
    let (a, b) = (along.norm_sqr(), start.re * along.re + start.im * along.im);
    let root = b * b - a * (start.norm_sqr() - reach * reach);
    let exit = (-b + root.max(0.0).sqrt()) / a;
    (root > 0.0 && exit > 0.0).then(|| start + along * exit.min(1.0))
}

fn cross(a: Point, b: Point) -> f64 {
    a.re * b.im - a.im * b.re
}
