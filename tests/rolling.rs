//! The follower laid over the finished profile gives back the motion that the profile was made for.
//!
//! Nothing here knows how profiles are generated: a dense polygon of profile points is turned rigidly by σθ, and the follower
//! is lowered onto it until it touches. Where it comes to rest on a plain base circle is found by the same routine, and the
//! motion is counted from there.

mod support;

use levalab_core::{Analysis, Cam, FOLLOWERS, Follower, Point, Rotation};
use std::f64::consts::TAU;
use support::gallery::gallery_of;
use support::profile;

/// Steps of the profile polygon: an interpolated summit of 1/20° is then exact to well below [`RECOVERY`].
const STEPS: usize = 7200;

/// How closely the motion is recovered, as a part of the lift.
const RECOVERY: f64 = 1e-6;

/// Cam positions tried in a turn. A prime: it shares no factor with the steps, so the contact falls between polygon points.
const POSITIONS: usize = 31;

/// How high the follower rests on a closed polygon of profile points (fixed frame), counted along its path: a length from the
/// level of the cam's centre, or an angle from the line of centres. A follower rests as high as the highest point lifts it.
fn resting_height(follower: &Follower, points: &[Point]) -> f64 {
    let of = |key: &str| follower.value(key).unwrap_or_else(|| panic!("{} has no {key}", follower.kind().id));
    let pivot = || Point::from_polar(of("pivot_distance"), of("pivot_angle"));
    // Angle of a point about the pivot, clockwise from the line to the cam's centre, and its distance.
    let about = |pivot: Point, point: Point| {
        let seen = (point - pivot) / -pivot;
        (-seen.arg(), (point - pivot).norm())
    };
    match follower.kind().id {
        "translating-roller" => lowered_disc(points, of("eccentricity"), of("roller_radius")),
        "translating-curved" => lowered_disc(points, of("eccentricity"), of("face_radius")),
        "translating-knife" => lowered_edge(points, of("eccentricity")),
        // A face leaning by γ, lifted by h, clears a point when (h − y)·cos γ + x·sin γ is not negative.
        "translating-flat" => summit(points, |p| p.im - p.re * of("face_angle").tan()),
        // Arm, radius and distance make a triangle with the corner at the pivot when the disc touches the point.
        "oscillating-roller" => {
            let (arm, radius, pivot) = (of("arm"), of("roller_radius"), pivot());
            summit(points, |point| {
                let (angle, distance) = about(pivot, point);
                angle + ((arm * arm + distance * distance - radius * radius) / (2.0 * arm * distance)).acos()
            })
        }
        // A face at distance f from the pivot, seen from there, passes a point at distance d when sin of the angle is f/d.
        "oscillating-flat" => {
            let (offset, pivot) = (of("face_offset"), pivot());
            summit(points, |point| {
                let (angle, distance) = about(pivot, point);
                angle - (offset / distance).asin()
            })
        }
        other => panic!("no way to lower {other} onto a profile"),
    }
}

/// A disc on the vertical through x = e comes down until (e, y) is one radius from a point.
fn lowered_disc(points: &[Point], e: f64, radius: f64) -> f64 {
    summit(points, |p| p.im + (radius * radius - (p.re - e) * (p.re - e)).sqrt())
}

/// An edge on the vertical through x = e comes down on the highest place where the profile crosses it.
fn lowered_edge(points: &[Point], e: f64) -> f64 {
    let n = points.len();
    let crossings = (0..n).filter(|&i| (points[i].re - e) * (points[(i + 1) % n].re - e) <= 0.0);
    let heights = crossings.map(|i| {
        let around: [Point; 4] = std::array::from_fn(|k| points[(i + n + k - 1) % n]);
        let (mut low, mut high) = (0.0, 1.0);
        let left = cubic(around.map(|p| p.re - e), 0.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if cubic(around.map(|p| p.re - e), middle) * left > 0.0 { low = middle } else { high = middle }
        }
        cubic(around.map(|p| p.im), high)
    });
    heights.fold(f64::NEG_INFINITY, f64::max)
}

/// The cubic through four values at −1, 0, 1, 2.
fn cubic([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    -a * t * (t - 1.0) * (t - 2.0) / 6.0 + b * (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0
        - c * (t + 1.0) * t * (t - 2.0) / 2.0
        + d * (t + 1.0) * t * (t - 1.0) / 6.0
}

/// The greatest height that any point gives, between points by the parabola through three neighbours. Points that the
/// follower cannot touch at all give no number and do not count.
fn summit(points: &[Point], height: impl Fn(Point) -> f64) -> f64 {
    let n = points.len();
    let heights: Vec<f64> = points.iter().map(|&point| height(point)).collect();
    let top =
        (0..n).filter(|&i| !heights[i].is_nan()).max_by(|&i, &k| heights[i].total_cmp(&heights[k])).expect("a contact");
    let (before, here, after) = (heights[(top + n - 1) % n], heights[top], heights[(top + 1) % n]);
    let (slope, bend) = (0.5 * (after - before), before - 2.0 * here + after);
    if bend < 0.0 { here - 0.5 * slope * slope / bend } else { here }
}

/// The profile, as rows of the analysis, closed without repeating its first point.
fn polygon(cam: &Cam) -> Vec<Point> {
    let mut points = profile(&Analysis::of(cam, STEPS));
    points.pop();
    points
}

fn turned(points: &[Point], rotation: Rotation, theta: f64) -> Vec<Point> {
    let turn = Point::from_polar(1.0, rotation.sigma() * theta);
    points.iter().map(|point| point * turn).collect()
}

fn base_circle(radius: f64) -> Vec<Point> {
    (0..STEPS).map(|k| Point::from_polar(radius, TAU * k as f64 / STEPS as f64)).collect()
}

/// The greatest difference between the motion wanted and the motion recovered, as a part of the lift, and where.
fn worst_recovery(cam: &Cam) -> (f64, f64) {
    let rest = resting_height(&cam.follower, &base_circle(cam.follower.base_radius()));
    let points = polygon(cam);
    let lift = Analysis::of(cam, 720).summary.s.max;
    let mut worst = (0.0, 0.0);
    for k in 0..POSITIONS {
        let theta = TAU * k as f64 / POSITIONS as f64;
        let found = resting_height(&cam.follower, &turned(&points, cam.follower.rotation(), theta)) - rest;
        let miss = (found - cam.program.at(theta).s).abs() / lift;
        if miss > worst.0 || miss.is_nan() {
            worst = (miss, theta);
        }
    }
    worst
}

fn assert_motion_is_recovered(id: &str) {
    for (name, cam) in gallery_of(id) {
        let (miss, theta) = worst_recovery(&cam);
        assert!(miss < RECOVERY, "{name}: off by {miss:e} of the lift at θ = {:.3}°", theta.to_degrees());
    }
}

#[test]
fn a_translating_roller_recovers_its_motion() {
    assert_motion_is_recovered("translating-roller");
}

#[test]
fn a_knife_edge_recovers_its_motion() {
    assert_motion_is_recovered("translating-knife");
}

#[test]
fn a_curved_face_recovers_its_motion() {
    assert_motion_is_recovered("translating-curved");
}

#[test]
fn a_translating_flat_face_recovers_its_motion() {
    assert_motion_is_recovered("translating-flat");
}

#[test]
fn an_oscillating_roller_recovers_its_motion() {
    assert_motion_is_recovered("oscillating-roller");
}

#[test]
fn an_oscillating_flat_face_recovers_its_motion() {
    assert_motion_is_recovered("oscillating-flat");
}

#[test]
fn every_follower_can_be_laid_over_its_profile() {
    for kind in FOLLOWERS {
        let (name, cam) = gallery_of(kind.id).swap_remove(0);
        assert!(worst_recovery(&cam).0 < RECOVERY, "{name}");
    }
}

#[test]
fn a_profile_that_is_a_little_wrong_is_noticed() {
    let (_, cam) = gallery_of("translating-roller").swap_remove(0);
    let swollen: Vec<Point> = polygon(&cam).iter().map(|point| point * (1.0 + 1e-5)).collect();
    let rest = resting_height(&cam.follower, &base_circle(cam.follower.base_radius()));
    let found = resting_height(&cam.follower, &turned(&swollen, cam.follower.rotation(), 2.0)) - rest;
    assert!(
        (found - cam.program.at(2.0).s).abs() > RECOVERY * 12.0,
        "the test would see an error of a hundred-thousandth"
    );
}
