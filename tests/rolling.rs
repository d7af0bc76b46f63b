//! The follower laid over the finished profile gives back the motion that the profile was made for.
//!
//! Nothing here knows how profiles are generated: a dense polygon of profile points is turned rigidly by σθ, and the follower
//! is lowered onto it until it touches. Where it comes to rest on a plain base circle is found by the same routine, and the
//! motion is counted from there.

mod support;

use levalab_core::{Analysis, Cam, FOLLOWERS, Follower, Point, Program, Rotation};
use std::f64::consts::TAU;
use support::{ROTATIONS, assert_profile_is_sound, degrees, follower, lengths, profile};

/// Steps of the profile polygon: an interpolated summit of 1/20° is then exact to well below [`RECOVERY`].
const STEPS: usize = 7200;

/// How closely the motion is recovered, as a part of the lift.
const RECOVERY: f64 = 1e-6;

/// Cam positions tried in a turn. A prime: it shares no factor with the steps, so the contact falls between polygon points.
const POSITIONS: usize = 61;

type Parameters = &'static [(&'static str, f64)];

/// Base radius and parameters to try for each follower.
fn geometries(id: &str) -> &'static [(f64, Parameters)] {
    match id {
        "translating-roller" => &[
            (40.0, &[("roller_radius", 10.0)]),
            (45.0, &[("roller_radius", 8.0), ("eccentricity", 9.0)]),
            (45.0, &[("roller_radius", 30.0), ("eccentricity", -12.0)]),
        ],
        "translating-knife" => &[(60.0, &[]), (60.0, &[("eccentricity", 8.0)]), (60.0, &[("eccentricity", -8.0)])],
        "translating-curved" => &[
            (50.0, &[("face_radius", 60.0)]),
            (60.0, &[("face_radius", 90.0), ("eccentricity", 15.0)]),
            (60.0, &[("face_radius", 90.0), ("eccentricity", -15.0)]),
        ],
        "translating-flat" => &[(120.0, &[]), (120.0, &[("face_angle", 0.3)]), (120.0, &[("face_angle", -0.25)])],
        "oscillating-roller" => &[
            (50.0, &[("roller_radius", 10.0), ("arm", 70.0), ("pivot_distance", 90.0)]),
            (50.0, &[("roller_radius", 15.0), ("arm", 80.0), ("pivot_distance", 80.0), ("pivot_angle", 0.5)]),
            (50.0, &[("roller_radius", 10.0), ("arm", 90.0), ("pivot_distance", 100.0), ("pivot_angle", -0.7)]),
        ],
        "oscillating-flat" => &[
            (100.0, &[("pivot_distance", 130.0)]),
            (110.0, &[("pivot_distance", 150.0), ("face_offset", 8.0)]),
            (100.0, &[("pivot_distance", 140.0), ("face_offset", -12.0), ("pivot_angle", 0.6)]),
            (100.0, &[("pivot_distance", 130.0), ("pivot_angle", -0.8)]),
        ],
        other => panic!("no geometry to lay {other} with: give it one here, and a way to be lowered in `resting_height`"),
    }
}

/// Programs of different laws, gentle enough for every geometry above. Unit: a millimetre, or half a degree.
fn programs(id: &str) -> [Program; 4] {
    let rows: [&[(&str, f64, f64)]; 4] = [
        &[("cycloidal", 110.0, 12.0), ("dwell", 50.0, 0.0), ("polynomial-3-4-5", 130.0, -12.0), ("dwell", 70.0, 0.0)],
        &[("simple-harmonic", 170.0, 14.0), ("simple-harmonic", 190.0, -14.0)],
        &[("modified-sine", 100.0, 6.0), ("double-harmonic", 100.0, 6.0), ("dwell", 20.0, 0.0), ("modified-trapezoidal", 140.0, -12.0)],
        &[("dwell", 60.0, 0.0), ("parabolic", 120.0, 10.0), ("polynomial-5", 40.0, 1.0), ("cubic-2", 140.0, -11.0)],
    ];
    rows.map(|rows| {
        let half_degrees: Vec<_> = rows.iter().map(|&(law, beta, rise)| (law, beta, rise / 2.0)).collect();
        if id.starts_with("oscillating") { degrees(&half_degrees) } else { lengths(rows) }
    })
}

/// How high the follower rests on a closed polygon of profile points (fixed frame), counted along its path: a length from the
/// level of the cam's centre, or an angle from the line of centres. A follower rests as high as the highest point lifts it.
fn resting_height(follower: &Follower, points: &[Point]) -> f64 {
    let of = |key: &str| follower.value(key).unwrap_or_else(|| panic!("{} has no {key}", follower.kind.id));
    let pivot = || Point::from_polar(of("pivot_distance"), of("pivot_angle"));
    // Angle of a point about the pivot, clockwise from the line to the cam's centre, and its distance.
    let about = |pivot: Point, point: Point| {
        let seen = (point - pivot) / -pivot;
        (-seen.arg(), (point - pivot).norm())
    };
    match follower.kind.id {
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
    let top = (0..n).filter(|&i| !heights[i].is_nan()).max_by(|&i, &k| heights[i].total_cmp(&heights[k])).expect("a contact");
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
    let rest = resting_height(&cam.follower, &base_circle(cam.follower.base_radius));
    let points = polygon(cam);
    let lift = Analysis::of(cam, 720).summary.s.max;
    let mut worst = (0.0, 0.0);
    for k in 0..POSITIONS {
        let theta = TAU * k as f64 / POSITIONS as f64;
        let found = resting_height(&cam.follower, &turned(&points, cam.follower.rotation, theta)) - rest;
        let miss = (found - cam.program.at(theta).s).abs() / lift;
        if miss > worst.0 || miss.is_nan() {
            worst = (miss, theta);
        }
    }
    worst
}

fn assert_motion_is_recovered(id: &str) {
    for (which, program) in programs(id).iter().enumerate() {
        for &(base_radius, parameters) in geometries(id) {
            for rotation in ROTATIONS {
                let cam = Cam::new(program.clone(), follower(id, base_radius, parameters, rotation));
                let name = format!("{id} {parameters:?}, program {which}, {rotation:?}");
                assert_profile_is_sound(&cam, &name);
                let (miss, theta) = worst_recovery(&cam);
                assert!(miss < RECOVERY, "{name}: off by {miss:e} of the lift at θ = {:.3}°", theta.to_degrees());
            }
        }
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
        let (base_radius, parameters) = geometries(kind.id)[0];
        let cam = Cam::new(programs(kind.id)[0].clone(), follower(kind.id, base_radius, parameters, Rotation::default()));
        assert!(worst_recovery(&cam).0 < RECOVERY, "{}", kind.id);
    }
}

#[test]
fn a_profile_that_is_a_little_wrong_is_noticed() {
    let (base_radius, parameters) = geometries("translating-roller")[0];
    let cam = Cam::new(programs("translating-roller")[0].clone(), follower("translating-roller", base_radius, parameters, Rotation::default()));
    let swollen: Vec<Point> = polygon(&cam).iter().map(|point| point * (1.0 + 1e-5)).collect();
    let rest = resting_height(&cam.follower, &base_circle(base_radius));
    let found = resting_height(&cam.follower, &turned(&swollen, cam.follower.rotation, 2.0)) - rest;
    assert!((found - cam.program.at(2.0).s).abs() > RECOVERY * 12.0, "the test would see an error of a hundred-thousandth");
}
