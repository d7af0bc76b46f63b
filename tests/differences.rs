//! What the core derives by formulas is found again by finite differences.
//!
//! Stencils of seven points never reach across a joint, where derivatives have two values.

mod support;

use levalab_core::{Analysis, Body, Cam, Column, Contact, Point};
use std::f64::consts::TAU;
use support::gallery::{gallery, gallery_of};
use support::{column, profile};

/// Steps of the tables that are differentiated: a seven-point stencil of 1/10° is exact to 1e-12 on every law, and its
/// rounding (ε/h for slopes, ε/h² for curvatures) stays below the two tolerances that follow.
const STEPS: usize = 3600;

/// Slopes: ε/h ≈ 1e-13 of the values differentiated, with room for laws of high frequency.
const SLOPE: f64 = 1e-9;

/// Curvatures: ε/h² ≈ 1e-10 of the values differentiated twice.
const CURVATURE: f64 = 1e-7;

/// Rotation of columns into the fixed frame and back.
const ROUNDING: f64 = 1e-12;

/// How far a stencil reaches on either side.
const REACH: usize = 3;

/// Rows whose whole stencil lies within one smooth stretch.
fn rows_within_stretches(cam: &Cam) -> Vec<usize> {
    let stretch = |row: usize| cam.program.stretch_index(TAU * row as f64 / STEPS as f64);
    let rows: Vec<usize> = (REACH..STEPS - REACH).filter(|&row| stretch(row - REACH) == stretch(row + REACH)).collect();
    assert!(rows.len() > STEPS * 9 / 10, "nearly every row is looked at");
    rows
}

/// First derivative at a row by central differences.
fn slope<T>(at: impl Fn(usize) -> T, row: usize) -> T
where
    T: std::ops::Sub<Output = T> + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    let h = TAU / STEPS as f64;
    let pair = |k: usize| at(row + k) - at(row - k);
    pair(1) * (0.75 / h) + pair(2) * (-0.15 / h) + pair(3) * (1.0 / 60.0 / h)
}

/// Second derivative at a row by central differences.
fn bend(at: impl Fn(usize) -> Point, row: usize) -> Point {
    let h2 = (TAU / STEPS as f64).powi(2);
    let pair = |k: usize| at(row + k) + at(row - k);
    (pair(1) * 1.5 - pair(2) * 0.15 + pair(3) / 90.0 - at(row) * (49.0 / 18.0)) / h2
}

fn theta(row: usize) -> f64 {
    TAU * row as f64 / STEPS as f64
}

/// i^σ as a number: a quarter turn in the cam's sense.
fn quarter(cam: &Cam) -> Point {
    Point::new(0.0, cam.follower.rotation().sigma())
}

/// e^(iσθ), from the cam's frame to the fixed one.
fn to_fixed(cam: &Cam, row: usize) -> Point {
    Point::from_polar(1.0, cam.follower.rotation().sigma() * theta(row))
}

fn dot(a: Point, b: Point) -> f64 {
    a.re * b.re + a.im * b.im
}

fn cross(a: Point, b: Point) -> f64 {
    a.re * b.im - a.im * b.re
}

/// Outward normal in the cam's frame from the profile alone: against the turning cam, the contact runs along the profile, and
/// outward is a quarter turn from there in the cam's sense.
fn normal_of_profile(cam: &Cam, points: &[Point], row: usize) -> Point {
    let along = slope(|k| points[k], row);
    quarter(cam) * along / along.norm()
}

#[test]
fn velocity_acceleration_and_jerk_are_slopes_of_what_comes_before() {
    for (name, cam) in gallery() {
        let analysis = Analysis::of(&cam, STEPS);
        for [of, its_slope] in [[Column::S, Column::V], [Column::V, Column::A], [Column::A, Column::J]] {
            let (values, slopes) = (column(&analysis, of), column(&analysis, its_slope));
            let scale = slopes.iter().fold(0.0_f64, |scale, slope| scale.max(slope.abs()));
            for row in rows_within_stretches(&cam) {
                let miss = (slope(|k| values[k], row) - slopes[row]).abs();
                assert!(
                    miss <= SLOPE * scale.max(values[row].abs()),
                    "{name}: {} at row {row}: {miss:e}",
                    its_slope.name()
                );
            }
        }
    }
}

#[test]
fn the_normal_stands_on_the_profile_and_looks_outward() {
    for (name, cam) in gallery() {
        let points = profile(&Analysis::of(&cam, STEPS));
        for row in rows_within_stretches(&cam) {
            let normal = cam.in_cam_frame(cam.at(theta(row)).1.normal, theta(row));
            let miss = (normal - normal_of_profile(&cam, &points, row)).norm();
            assert!(miss < SLOPE, "{name} at row {row}: {miss:e}");
        }
    }
}

#[test]
fn the_radius_of_curvature_is_that_of_the_profile_drawn() {
    for (name, cam) in gallery() {
        let analysis = Analysis::of(&cam, STEPS);
        let (points, rho) = (profile(&analysis), column(&analysis, Column::Rho));
        for row in rows_within_stretches(&cam) {
            let (first, second) = (slope(|k| points[k], row), bend(|k| points[k], row));
            let curvature = -cam.follower.rotation().sigma() * cross(first, second) / first.norm().powi(3);
            // Curvature and not radius is compared, since the radius runs to infinity where the profile straightens; where
            // the contact dwells on a tight profile, first is short and the scale is its own curvature.
            let scale = (1.0 / rho[row]).abs().max(1.0 / first.norm());
            let miss = (curvature - 1.0 / rho[row]).abs();
            assert!(miss < CURVATURE * scale, "{name} at row {row}: {miss:e}");
        }
    }
}

#[test]
fn the_pitch_curve_is_one_radius_out_from_the_profile() {
    for (name, cam) in gallery().into_iter().filter(|(_, cam)| !cam.follower.is_flat()) {
        let analysis = Analysis::of(&cam, STEPS);
        let points = profile(&analysis);
        let (x, y) = (column(&analysis, Column::PitchX), column(&analysis, Column::PitchY));
        let (rho, rho_pitch) = (column(&analysis, Column::Rho), column(&analysis, Column::RhoPitch));
        let radius = ["roller_radius", "face_radius"].iter().find_map(|key| cam.follower.value(key)).unwrap_or(0.0);
        for row in rows_within_stretches(&cam) {
            let pitch = points[row] + normal_of_profile(&cam, &points, row) * radius;
            let miss = (Point::new(x[row], y[row]) - pitch).norm();
            assert!(miss <= SLOPE * radius, "{name} at row {row}: {miss:e}");
            assert!(
                (rho_pitch[row] - rho[row] - radius).abs() <= ROUNDING * rho_pitch[row].abs(),
                "{name} at row {row}"
            );
        }
    }
}

/// The point of the follower that is at `point` (fixed frame) at row `from`, carried along by the motion column to row `to`.
fn carried(cam: &Cam, s: &[f64], point: Point, from: usize, to: usize) -> Point {
    let travel = s[to] - s[from];
    match cam.follower.body() {
        Body::Slide => point + Point::new(0.0, travel),
        Body::Swing { pivot } => pivot + (point - pivot) * Point::from_polar(1.0, -travel),
    }
}

#[test]
fn the_pressure_angle_lies_between_the_normal_and_the_velocity_of_the_follower() {
    for (name, cam) in gallery() {
        let analysis = Analysis::of(&cam, STEPS);
        let (points, s) = (profile(&analysis), column(&analysis, Column::S));
        let (angles, v) = (column(&analysis, Column::PressureAngle), column(&analysis, Column::V));
        let pitch = analysis.column(Column::PitchX).zip(analysis.column(Column::PitchY));
        let trace = |row: usize| pitch.map_or(points[row], |(x, y)| Point::new(x[row], y[row])) * to_fixed(&cam, row);
        // Where the follower hardly moves, differences do not tell the direction in which it would.
        let fastest = analysis.summary.v.greatest_size().0;
        for row in rows_within_stretches(&cam).into_iter().filter(|&row| v[row].abs() > 1e-2 * fastest) {
            // For a disc the trace point is a point of the follower; on a face the contact wanders, so its carrier is followed.
            let velocity = if cam.follower.is_flat() {
                slope(|k| carried(&cam, s, trace(row), row, k), row)
            } else {
                slope(trace, row)
            };
            let (forward, normal) =
                (velocity * v[row].signum(), normal_of_profile(&cam, &points, row) * to_fixed(&cam, row));
            let angle = cam.follower.rotation().sigma() * cross(forward, normal).atan2(dot(forward, normal));
            assert!((angle - angles[row]).abs() < 100.0 * SLOPE, "{name} at row {row}: {angle}, not {}", angles[row]);
        }
    }
}

#[test]
fn the_contact_of_a_translating_face_walks_by_the_velocity() {
    for (name, cam) in gallery_of("translating-flat") {
        let analysis = Analysis::of(&cam, STEPS);
        let (contact, v) = (column(&analysis, Column::Contact), column(&analysis, Column::V));
        let points = profile(&analysis);
        let lean = cam.follower.value("face_angle").unwrap_or(0.0);
        for row in 0..=STEPS {
            let found = (points[row] * to_fixed(&cam, row)).re;
            assert!(
                (contact[row] - found).abs() < ROUNDING * 200.0,
                "{name} at row {row}: the offset is where the contact is"
            );
            if lean == 0.0 {
                let walked = cam.follower.rotation().sigma() * v[row];
                assert!((contact[row] - walked).abs() < ROUNDING * 200.0, "{name} at row {row}: σ·v");
            }
        }
    }
}

#[test]
fn the_contact_of_an_oscillating_face_is_measured_from_the_foot_of_its_pivot() {
    for (name, cam) in gallery_of("oscillating-flat") {
        let analysis = Analysis::of(&cam, STEPS);
        let contact = column(&analysis, Column::Contact);
        let points = profile(&analysis);
        let Body::Swing { pivot } = cam.follower.body() else { panic!("{name} swings") };
        let offset = cam.follower.value("face_offset").unwrap_or(0.0);
        for row in rows_within_stretches(&cam) {
            let (turn, normal) = (to_fixed(&cam, row), normal_of_profile(&cam, &points, row));
            let (touch, normal) = (points[row] * turn, normal * turn);
            let foot = pivot + normal * offset;
            let miss = ((touch - foot).norm() - contact[row].abs()).abs();
            assert!(miss < SLOPE * contact[row].abs(), "{name} at row {row}: {miss:e}");
            assert!(dot(touch - foot, normal).abs() < SLOPE * contact[row].abs(), "{name} at row {row}: on the face");
        }
    }
}

#[test]
fn sliding_is_what_the_contact_gains_on_the_cam_over_the_follower() {
    for (name, cam) in gallery() {
        let analysis = Analysis::of(&cam, STEPS);
        let (points, s) = (profile(&analysis), column(&analysis, Column::S));
        let touches: Vec<Contact> = (0..=STEPS).map(|row| cam.at(theta(row)).1).collect();
        for row in rows_within_stretches(&cam) {
            let here = &touches[row];
            let tangent = here.normal * Point::new(0.0, 1.0);
            let on_the_cam = dot(slope(|k| points[k], row) * to_fixed(&cam, row), tangent);
            // The contacts of the neighbouring rows, brought back to where the follower is now.
            let on_the_follower = dot(slope(|k| carried(&cam, s, touches[k].point, k, row), row), tangent);
            let miss = (here.sliding - (on_the_cam - on_the_follower)).abs();
            assert!(miss < SLOPE * here.point.norm() * 100.0, "{name} at row {row}: {miss:e}");
        }
    }
}
