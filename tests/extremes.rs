//! The summary's extremes are those that brute force sees, wherever they fall between the rows.

mod support;

use levalab_core::{Analysis, Cam, Column, Element, Extremes, Follower, Rotation, Stretch};
use std::f64::consts::TAU;
use support::gallery::gallery;
use support::{column, degrees, follower, lengths};

/// Stations of the brute force, which then looks as finely again around the best.
const BRUTE: usize = 200_000;

/// Rounding of sums and turns, for values that are nothing but rounding.
const ROUNDING: f64 = 1e-12;

/// Extremes against the brute force: its last step is 3e-8, whose square is nothing.
const EXTREME: f64 = 1e-9;

/// What has extremes: *s*, *v*, *a*, *j*, φ, the bend of the profile, and the reach along a face.
fn readings(cam: &Cam, stretch: &Stretch, theta: f64) -> [f64; 7] {
    let motion = stretch.at(theta);
    let contact = cam.follower.contact(motion);
    [motion.s, motion.v, motion.a, motion.j, contact.pressure_angle, contact.bend, contact.reach]
}

/// Least and greatest of each reading over the turn by trying, one-sided limits at joints included.
fn seen(cam: &Cam) -> [(f64, f64); 7] {
    let mut seen = [(f64::INFINITY, f64::NEG_INFINITY); 7];
    for stretch in cam.program.stretches() {
        let count = ((stretch.to - stretch.from) / TAU * BRUTE as f64).ceil() as usize + 1;
        let theta = |part: f64| stretch.from + (stretch.to - stretch.from) * part / count as f64;
        let mut best = [[(0, f64::NEG_INFINITY); 2]; 7];
        for i in 0..=count {
            for (best, value) in best.iter_mut().zip(readings(cam, stretch, theta(i as f64))) {
                for (best, value) in best.iter_mut().zip([-value, value]) {
                    if value > best.1 {
                        *best = (i, value);
                    }
                }
            }
        }
        for (k, [(low, _), (high, _)]) in best.into_iter().enumerate() {
            for (middle, fine) in
                [low, high].into_iter().flat_map(|middle| (-500..=500).map(move |fine| (middle, fine)))
            {
                let part = (middle as f64 + f64::from(fine) / 500.0).clamp(0.0, count as f64);
                let value = readings(cam, stretch, theta(part))[k];
                seen[k] = (seen[k].0.min(value), seen[k].1.max(value));
            }
        }
    }
    seen
}

fn assert_extremes(name: &str, found: &Extremes, (min, max): (f64, f64)) {
    let tolerance = EXTREME * max.abs().max(min.abs()) + ROUNDING;
    assert!((found.max - max).abs() <= tolerance, "{name}: max {} but {max} was seen", found.max);
    assert!((found.min - min).abs() <= tolerance, "{name}: min {} but {min} was seen", found.min);
}

/// The summary never says less than a row, and names places where its extremes are.
fn assert_places(name: &str, analysis: &Analysis, found: &Extremes, what: Column, at: impl Fn(f64) -> f64) {
    let scale = found.max.abs().max(found.min.abs());
    let rounding = ROUNDING * (1.0 + scale);
    for value in column(analysis, what) {
        assert!(
            (found.min - rounding..=found.max + rounding).contains(value),
            "{name}: {} has a row of {value}",
            what.name()
        );
    }
    for (value, place) in [(found.max, found.max_at), (found.min, found.min_at)] {
        assert!((0.0..TAU).contains(&place), "{name}: {} at {place}", what.name());
        // At a jump the extreme may be the limit from the left.
        let near = |theta: f64| (at(theta) - value).abs() <= 1e-5 * scale + ROUNDING;
        assert!(near(place) || near(place - 1e-9), "{name}: {} is not {value} at {place}", what.name());
    }
}

fn assert_summary(name: &str, cam: &Cam) {
    let analysis = Analysis::of(cam, 720);
    let summary = &analysis.summary;
    let [s, v, a, j, angle, bend, reach] = seen(cam);
    for (what, found, seen) in [
        (Column::S, &summary.s, s),
        (Column::V, &summary.v, v),
        (Column::A, &summary.a, a),
        (Column::J, &summary.j, j),
        (Column::PressureAngle, &summary.pressure_angle, angle),
    ] {
        assert_extremes(&format!("{name}: {}", what.name()), found, seen);
        assert_places(name, &analysis, found, what, |theta| {
            let (motion, contact) = cam.at(theta);
            [motion.s, motion.v, motion.a, motion.j, contact.pressure_angle][what as usize - Column::S as usize]
        });
    }
    let rho = |theta: f64| cam.follower.profile_radius(cam.at(theta).1.bend);
    match (cam.follower.element(), &summary.rho_pitch, &summary.reach) {
        (Element::Face { .. }, None, Some(found)) => {
            assert_extremes(&format!("{name}: reach"), found, reach);
            assert_places(name, &analysis, found, Column::Contact, |theta| cam.at(theta).1.reach);
            assert_extremes(&format!("{name}: rho"), &summary.rho, bend);
            assert_places(name, &analysis, &summary.rho, Column::Rho, rho);
        }
        (Element::Disc { radius, .. }, Some(rho_pitch), None) => {
            let (least, _) = summary.least_convex.expect("a closed profile is convex somewhere");
            let tightest = 1.0 / bend.1 - radius;
            assert!((least - tightest).abs() <= EXTREME / bend.1, "{name}: least convex ρ {least}, not {tightest}");
            if bend.0 > 0.0 {
                assert_extremes(&format!("{name}: rho_pitch"), rho_pitch, (1.0 / bend.1, 1.0 / bend.0));
                assert_places(name, &analysis, &summary.rho, Column::Rho, rho);
            } else {
                let (hollow, _) = summary.tightest_hollow.expect("it is hollow somewhere");
                assert!(
                    (hollow - (1.0 / bend.0 - radius)).abs() <= EXTREME * hollow.abs(),
                    "{name}: tightest hollow {hollow}"
                );
                assert_eq!((summary.rho.min, summary.rho.max), (f64::NEG_INFINITY, f64::INFINITY), "{name}");
            }
        }
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn extremes_are_those_that_brute_force_sees() {
    // Seven is prime to the sizes of the gallery, so every follower, program, geometry and rotation has its turn.
    for (name, cam) in gallery().into_iter().step_by(7) {
        assert_summary(&name, &cam);
    }
}

fn roller() -> Follower {
    follower("translating-roller", 60.0, &[("roller_radius", 10.0)], Rotation::Clockwise)
}

#[test]
fn extremes_hold_among_many_bumps_that_are_almost_as_high() {
    // Each rise is a little higher than the one before, so the last is the steepest; none of its peaks falls on a station.
    let mut rows = Vec::new();
    for k in 0..8 {
        let rise = 4.0 + 1e-5 * f64::from(k);
        rows.extend([("polynomial-3-4-5", 22.3, rise), ("modified-sine", 22.7, -rise)]);
    }
    assert_summary("sixteen bumps, roller", &Cam::new(lengths(&rows), roller()));
    let flat = follower("translating-flat", 300.0, &[], Rotation::CounterClockwise);
    assert_summary("sixteen bumps, flat", &Cam::new(lengths(&rows), flat));
}

#[test]
fn extremes_hold_in_a_stretch_of_a_few_stations() {
    for width in [0.3, 1.1, 3.9, 4.1, 7.3] {
        let rows = [
            ("cycloidal", width, 0.02),
            ("cycloidal", 100.0, 0.9),
            ("polynomial-4-5-6-7", 150.0, -0.92),
            ("dwell", 110.0 - width, 0.0),
        ];
        assert_summary(&format!("a stretch of {width}°"), &Cam::new(lengths(&rows), roller()));
        let arm = [("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 100.0)];
        let swinging = follower("oscillating-roller", 50.0, &arm, Rotation::CounterClockwise);
        assert_summary(&format!("a swinging stretch of {width}°"), &Cam::new(degrees(&rows), swinging));
    }
}

#[test]
fn extremes_hold_among_short_stretches_that_are_almost_as_steep() {
    // Eight stations or so a stretch, each stretch cut at other phases than its neighbours.
    let mut rows = Vec::new();
    for k in 0..10 {
        let (up, down) = (4.1 + 0.013 * f64::from(k), 4.2 + 0.017 * f64::from(k));
        rows.extend([("cycloidal", up, 0.01 * up), ("dwell", 9.1, 0.0), ("polynomial-3-4-5", down, -0.01 * up)]);
    }
    let left = 360.0 - rows.iter().map(|row| row.1).sum::<f64>();
    rows.push(("dwell", left, 0.0));
    assert_summary("twenty short stretches", &Cam::new(lengths(&rows), roller()));
}

/// Every change of sign of the curvature that brute force sees, each between two neighbouring stations.
fn seen_inflections(cam: &Cam) -> Vec<(f64, f64)> {
    let stations = cam.program.stretches().iter().flat_map(|stretch| {
        let count = 5_000;
        (0..=count).map(move |i| {
            let theta = stretch.from + (stretch.to - stretch.from) * f64::from(i) / f64::from(count);
            (theta, cam.contact(stretch.at(theta)).bend)
        })
    });
    let stations: Vec<(f64, f64)> = stations.collect();
    let pairs = (0..stations.len()).map(|i| [stations[(i + stations.len() - 1) % stations.len()], stations[i]]);
    let changes = pairs.filter(|[before, after]| (before.1 > 0.0) != (after.1 > 0.0));
    changes.map(|[before, after]| (if before.0 > after.0 { 0.0 } else { before.0 }, after.0)).collect()
}

#[test]
fn every_inflection_is_named_and_rho_has_bounds_only_where_the_curvature_jumps() {
    let small = || follower("translating-roller", 25.0, &[("roller_radius", 4.0)], Rotation::CounterClockwise);
    // A short and steep parabola turns hollow and back by jumps of its acceleration; the others by a zero of the curvature.
    let mut jumping = 0;
    let programs = [
        ("parabolic", 30.0, 8.0),
        ("parabolic", 70.0, 20.0),
        ("cycloidal", 70.0, 20.0),
        ("modified-sine", 70.0, 20.0),
        ("simple-harmonic", 70.0, 20.0),
        ("polynomial-3-4-5", 70.0, 20.0),
    ];
    for (law, beta, rise) in programs {
        let rows = [(law, beta, rise), ("dwell", 50.0, 0.0), (law, beta, -rise), ("dwell", 310.0 - 2.0 * beta, 0.0)];
        let cam = Cam::new(lengths(&rows), small());
        let (analysis, seen) = (Analysis::of(&cam, 360), seen_inflections(&cam));
        assert_eq!(analysis.inflections.len(), seen.len(), "{law}: {:?}, seen {seen:?}", analysis.inflections);
        assert!(seen.len() >= 2, "{law} is hollow");
        for (found, (from, to)) in analysis.inflections.iter().zip(seen) {
            assert!((from - 1e-9..=to + 1e-9).contains(found), "{law}: {found} is not in {from} to {to}");
        }
        let summary = &analysis.summary;
        if summary.rho.max.is_finite() {
            jumping += 1;
            let rows = column(&analysis, Column::Rho);
            assert!(rows.iter().all(|rho| (summary.rho.min - 1e-9..=summary.rho.max + 1e-9).contains(rho)), "{law}");
            assert!(summary.rho.min <= summary.tightest_hollow.expect("a hollow").0, "{law}");
        } else {
            let bend = |theta: f64| cam.at(theta).1.bend;
            for at in [summary.rho.min_at, summary.rho.max_at] {
                assert!(bend(at).abs() < 1e-6, "{law}: the profile is not straight at {at}");
            }
        }
    }
    assert_eq!(jumping, 1);
}
