//! Figures printed in textbooks, handouts and the classic teaching program, held to half a unit of the last printed digit.
//!
//! Where a printed figure is wrong, the right one is asserted and the slip is told.

mod support;

use levalab_core::law::{Condition, Data, Law};
use levalab_core::{
    Analysis, Cam, Column, FindingKind, Follower, Level, Program, Rotation, Segment, smallest_base_radius,
};
use std::f64::consts::{PI, TAU};
use support::classics::nine_rt;
use support::{column, degrees, follower, lengths};

/// Rounding of a printed figure that lies on the very edge of its last digit, as a part of the figure.
const EDGE: f64 = 1e-12;

/// Figures that are exact on paper, such as a motion sum: rounding of a few operations.
const EXACT: f64 = 1e-12;

/// 20 revolutions a minute, in radians a second.
const TWENTY_RPM: f64 = 20.0 * TAU / 60.0;

/// Asserts that a value rounds to the figure as printed.
fn assert_prints(what: &str, found: f64, printed: &str) {
    let figure: f64 = printed.parse().expect(printed);
    let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let half_a_unit = 0.5 * 10_f64.powi(-(decimals as i32));
    assert!((found - figure).abs() <= half_a_unit + EDGE * figure.abs(), "{what}: {found}, printed {printed}");
}

fn assert_coefficients_print(program: &Program, segment: usize, unit: f64, printed: &[&str]) {
    let stretch = program.stretches().iter().find(|stretch| stretch.segment == segment).expect("the segment");
    let (curve, ..) = stretch.formula();
    let coefficients = curve.coefficients().expect("a polynomial");
    assert_eq!(coefficients.len(), printed.len());
    for (k, (found, printed)) in coefficients.iter().zip(printed).enumerate() {
        assert_prints(&format!("c{k}"), found * unit, printed);
    }
}

fn radial_roller(base_radius: f64, roller_radius: f64) -> Follower {
    follower("translating-roller", base_radius, &[("roller_radius", roller_radius)], Rotation::CounterClockwise)
}

fn kinds(analysis: &Analysis) -> Vec<FindingKind> {
    analysis.findings.iter().map(|finding| finding.kind).collect()
}

#[test]
fn r1_constant_velocity_machine() {
    let omega = TAU;
    let program = lengths(&[
        ("polynomial-5", 90.0, 0.1),
        ("constant-velocity", 90.0, 0.1),
        ("polynomial-5", 135.0, -0.2),
        ("dwell", 45.0, 0.0),
    ]);
    assert_coefficients_print(&program, 0, 1.0, &["0", "0", "0", "0.6", "-0.8", "0.3"]);
    assert_coefficients_print(&program, 2, 1.0, &["0.2", "0.15", "0", "-2.9", "4.2", "-1.65"]);
    let cam = Cam::new(program, radial_roller(0.2, 0.01));
    let (straight, _) = cam.at(135_f64.to_radians());
    assert_prints("v of the constant stretch", straight.v, "0.06366");
    assert_prints("V of the constant stretch", straight.v * omega, "0.4");

    let analysis = Analysis::of(&cam, 720);
    let fastest = analysis.summary.v;
    assert_prints("θ of the fastest return", fastest.min_at.to_degrees(), "251.18");
    assert_prints("x of the fastest return", (fastest.min_at.to_degrees() - 180.0) / 135.0, "0.5273");
    assert_prints("v of the fastest return", fastest.min, "-0.18831");
    assert_prints("V of the fastest return", fastest.min * omega, "-1.1832");
    let (motion, contact) = cam.at(fastest.min_at);
    assert_prints("s there", motion.s, "0.11136");
    // Printed −29.6°, a slip in the arithmetic, which makes the cam look acceptable.
    assert_prints("φ there", contact.pressure_angle.to_degrees(), "-30.37");
    // Printed 0.29, cut and not rounded.
    assert_prints("ρp there", 1.0 / contact.bend, "0.29665");
    assert!(kinds(&analysis).contains(&FindingKind::PressureAngle));
    assert_eq!(analysis.level, Level::Unacceptable);
}

#[test]
fn r2_cycloidal_stretch() {
    // The problem prints the stretches at 90° and before the end; dwells and a mirrored return complete the turn.
    let program = lengths(&[
        ("dwell", 30.0, 0.0),
        ("cycloidal", 30.0, 0.01),
        ("dwell", 30.0, 0.0),
        ("cycloidal", 60.0, 0.04),
        ("dwell", 60.0, 0.0),
        ("cycloidal", 60.0, -0.04),
        ("dwell", 30.0, 0.0),
        ("polynomial-5", 30.0, -0.01),
        ("dwell", 30.0, 0.0),
    ]);
    assert_coefficients_print(&program, 7, 1.0, &["0.01", "0", "0", "-0.1", "0.15", "-0.06"]);
    let cam = Cam::new(program, radial_roller(0.1, 0.025));
    let fastest = Analysis::of(&cam, 720).summary.v;
    assert_prints("θ of v max", fastest.max_at.to_degrees(), "120");
    assert_prints("v max", fastest.max, "0.076394");
    assert_prints("V max", fastest.max * TWENTY_RPM, "0.1600");
    let (motion, contact) = cam.at(fastest.max_at);
    assert_prints("s there", motion.s, "0.03");
    // Printed 26.12°, worked from a rounded v.
    assert_prints("φ there", contact.pressure_angle.to_degrees(), "26.24");
    assert_prints("ρp of the dwell", 1.0 / cam.at(0.1).1.bend, "0.125");
}

#[test]
fn r3_harmonic_beside_a_dwell() {
    let program = lengths(&[
        ("dwell", 30.0, 0.0),
        ("simple-harmonic", 90.0, 0.001),
        ("dwell", 60.0, 0.0),
        ("polynomial-5", 60.0, -0.0004),
        ("dwell", 60.0, 0.0),
        ("cycloidal", 60.0, -0.0006),
    ]);
    let centimetres = 100.0;
    assert_coefficients_print(&program, 3, centimetres, &["0.1", "0", "0", "-0.4", "0.6", "-0.24"]);
    let cam = Cam::new(program, radial_roller(0.1, 0.02));
    let analysis = Analysis::of(&cam, 720);
    let end = analysis.joints.iter().find(|joint| joint.segment == 2).expect("the dwell at 120°");
    assert_prints("end of the harmonic", end.theta.to_degrees(), "120");
    assert_prints("s there", end.before.s, "0.001");
    assert_prints("v there", end.before.v, "0");
    assert_prints("a there", end.before.a, "-0.002");
    assert_eq!((end.after.a, end.jump), (0.0, Some(2)));
    assert_eq!(analysis.level, Level::Unacceptable);

    let (motion, _) = cam.at(330_f64.to_radians());
    assert_prints("v at 330°", motion.v, "-0.0011459");
    // Printed 0.24 m/s; it is cm/s.
    assert_prints("V at 330°", motion.v * TWENTY_RPM, "-0.0024");
    // Printed 0.22 in the table, 0.121 in the working.
    assert_prints("ρp of the dwell", 1.0 / cam.at(150_f64.to_radians()).1.bend, "0.121");
}

/// A polynomial through conditions: (degrees from its start, order, value).
fn through(degrees: f64, conditions: &[(f64, u8, f64)]) -> Segment {
    let conditions = conditions.iter().map(|&(at, order, value)| Condition { at: at.to_radians(), order, value });
    let law = Law::by_id("polynomial").expect("polynomial");
    Segment { data: Data::Conditions(conditions.collect()), ..Segment::new(law, degrees.to_radians(), 0.0) }
}

#[test]
fn r4_cubic_stretch_joined_by_a_quintic() {
    let of = |law: &str, beta, rise| Segment::of(law, beta, rise).expect(law);
    let program = Program::new(&[
        through(150.0, &[(0.0, 0, 0.0), (0.0, 1, 0.0), (0.0, 2, 0.0), (150.0, 0, 0.05)]),
        of("polynomial-5", 60.0, 0.05),
        of("dwell", 60.0, 0.0),
        of("cycloidal", 90.0, -0.1),
    ]);
    let program = program.expect("a program");
    assert_coefficients_print(&program, 0, 1.0, &["0.0000", "0.0000", "0.0000", "0.0500"]);
    assert_coefficients_print(&program, 1, 1.0, &["0.05", "0.06", "0.024", "0.068", "-0.198", "0.096"]);
    let cam = Cam::new(program, radial_roller(0.125, 0.025));
    let analysis = Analysis::of(&cam, 720);
    let end = analysis.joints.iter().find(|joint| joint.segment == 1).expect("the quintic at 150°");
    assert_prints("s at the end of the cubic", end.before.s, "0.05");
    assert_prints("v at the end of the cubic", end.before.v, "0.057296");
    assert_prints("a at the end of the cubic", end.before.a, "0.043771");
    assert_eq!(end.jump, Some(3), "the quintic takes over s, v and a");

    let (motion, contact) = cam.at(315_f64.to_radians());
    assert_prints("v at 315°", motion.v, "-0.127324");
    assert_prints("V at 315°", motion.v * TWENTY_RPM, "-0.26667");
    assert_prints("ρp at 315°", 1.0 / contact.bend, "0.18402");
}

#[test]
fn r6_gait_simulator() {
    const OMEGA: f64 = 12.566;
    let mut conditions =
        vec![(0.0, 0, 0.0), (56.88, 0, 1.177), (123.84, 0, 0.847), (198.72, 0, 1.139), (256.32, 0, 0.0)];
    conditions.extend([(0.0, 1, 0.0), (0.0, 2, 0.0), (256.32, 1, 0.0), (256.32, 2, 0.0)]);
    let dwell = Segment::of("dwell", 103.68, 0.0).expect("dwell");
    let program = Program::new(&[through(256.32, &conditions), dwell]).expect("a program");
    // Printed 612.721, −4057.255, 10696.565, −13873.375, 8822.470, −2201.126, from less rounded data.
    let printed = ["0.00", "0.00", "0.00", "612.67", "-4057.05", "10696.41", "-13873.63", "8822.87", "-2201.28"];
    assert_coefficients_print(&program, 0, 1.0, &printed);
    assert!(program.doubts().is_empty());

    let cam = Cam::new(program, radial_roller(2.0, 1.0));
    let analysis = Analysis::of(&cam, 720);
    let summary = &analysis.summary;
    assert_prints("s max", summary.s.max, "1.34668");
    assert_prints("where s is greatest", summary.s.max_at.to_degrees(), "74.39");
    assert_prints("V max", summary.v.max * OMEGA, "22.547");
    assert_prints("where V is greatest", summary.v.max_at.to_degrees(), "37.2");
    assert_prints("V min", summary.v.min * OMEGA, "-21.578");
    assert_prints("A max", summary.a.max * OMEGA * OMEGA, "685.45");
    assert_prints("A min", summary.a.min * OMEGA * OMEGA, "-594.11");
    assert_prints("φ max", summary.pressure_angle.max.to_degrees(), "26.57");
    assert_prints("φ min", summary.pressure_angle.min.to_degrees(), "-25.75");
    let stiffness = 30.0 * (PI * 0.75 * 0.75).powi(2);
    assert_prints("K", stiffness, "93.684");
    assert_prints("F max", stiffness * summary.s.max, "126.16");
    assert!(kinds(&analysis).iter().all(|kind| *kind == FindingKind::Jump(3)), "smooth but for its jerk");
}

#[test]
fn r5_parabolic_cam() {
    let omega: f64 = 390.0 * TAU / 60.0;
    assert_prints("ω", omega, "40.8407");
    let program =
        lengths(&[("dwell", 70.0, 0.0), ("parabolic", 100.0, 22.0), ("dwell", 30.0, 0.0), ("parabolic", 160.0, -22.0)]);
    let cam = Cam::new(program, radial_roller(80.0, 10.0));
    let analysis = Analysis::of(&cam, 720);
    let summary = analysis.summary;
    assert_prints("V max", summary.v.max * omega, "1029.6");
    assert_prints("θ of V max", summary.v.max_at.to_degrees(), "120");
    assert_prints("V min", summary.v.min * omega, "-643.5");
    assert_prints("θ of V min", summary.v.min_at.to_degrees(), "280");
    let acceleration = |theta: f64| cam.at(theta.to_radians()).0.a * omega * omega;
    for (theta, printed) in [(90.0, "48185.28"), (150.0, "-48185.28"), (230.0, "-18822.375"), (330.0, "18822.375")] {
        assert_prints("A", acceleration(theta), printed);
    }
    assert_eq!((summary.j.min, summary.j.max), (0.0, 0.0));
    // Four jumps of a beside the dwells, and one in the middle of each stretch.
    let places: Vec<f64> = analysis
        .joints
        .iter()
        .filter(|joint| joint.jump == Some(2))
        .map(|joint| joint.theta.to_degrees().round())
        .collect();
    assert_eq!(places, [0.0, 70.0, 120.0, 170.0, 200.0, 280.0]);
    // Handouts print y = h + 2h(1 − x)² for the second half; the sign is −.
    let x: f64 = 0.8;
    let (late, _) = cam.at((70.0 + 100.0 * x).to_radians());
    assert!((late.s - (22.0 - 2.0 * 22.0 * (1.0 - x).powi(2))).abs() < EXACT * 22.0);
}

#[test]
fn classic_1rt_tends_to_a_circle_as_its_roller_grows() {
    let program = lengths(&[("simple-harmonic", 180.0, 20.0), ("simple-harmonic", 180.0, -20.0)]);
    let summary =
        |roller_radius: f64| Analysis::of(&Cam::new(program.clone(), radial_roller(40.0, roller_radius)), 720).summary;
    let unevenness = |roller_radius: f64| {
        let rho = summary(roller_radius).rho;
        rho.max - rho.min
    };
    let steepness = |roller_radius: f64| summary(roller_radius).pressure_angle.max;
    assert!(unevenness(10.0) > 1.0, "ρ is not constant");
    for roller_radius in [10.0, 100.0, 1000.0] {
        assert!(unevenness(10.0 * roller_radius) < unevenness(roller_radius) / 2.0);
        assert!(steepness(10.0 * roller_radius) < steepness(roller_radius) / 2.0);
    }
}

#[test]
fn classic_2ro_is_acceptable() {
    let program =
        degrees(&[("polynomial-4-5-6-7", 120.0, 10.0), ("dwell", 120.0, 0.0), ("polynomial-4-5-6-7", 120.0, -10.0)]);
    let arm = [("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 80.0)];
    let cam = Cam::new(program, follower("oscillating-roller", 40.0, &arm, Rotation::CounterClockwise));
    let (_, rest) = cam.at(0.0);
    // The arm at rest is seen from the pivot at (80, 0); the line of centres is the x axis.
    assert_prints("ξ₀", rest.trace.im.atan2(80.0 - rest.trace.re).to_degrees(), "36.42");
    let analysis = Analysis::of(&cam, 720);
    assert_prints("extreme φ", analysis.summary.pressure_angle.greatest_size().0.to_degrees(), "33.20");
    assert_eq!((analysis.level, kinds(&analysis)), (Level::Acceptable, vec![]));
}

#[test]
fn classic_3pt_has_its_least_base_circle_where_a_cusp_appears() {
    let program = lengths(&[
        ("cycloidal", 100.0, 20.0),
        ("dwell", 80.0, 0.0),
        ("polynomial-3-4-5", 120.0, -20.0),
        ("dwell", 60.0, 0.0),
    ]);
    let at = |base_radius: f64| {
        Cam::new(program.clone(), follower("translating-flat", base_radius, &[], Rotation::CounterClockwise))
    };
    let least = smallest_base_radius(&at(100.0)).expect("a flat face always has one");
    let rho = Analysis::of(&at(least), 720).summary.rho.min;
    // A cure stays inside the limit by the part that counts as a cusp; both are thousands of times below a micron.
    assert!(rho.abs() <= 1e-8 * least, "min ρ = {rho} at Rb = {least}");
    assert!(kinds(&Analysis::of(&at(least * 0.999), 720)).contains(&FindingKind::ConcaveFlat));
}

#[test]
fn classic_4po_serves_but_at_high_speed() {
    // The half cycloidals end and begin at twice their mean slope, which is the slope of the straight stretch.
    let program = degrees(&[
        ("half-cycloidal-start", 60.0, 3.0),
        ("constant-velocity", 60.0, 6.0),
        ("half-cycloidal-end", 60.0, 3.0),
        ("dwell", 60.0, 0.0),
        ("polynomial-4-5-6-7", 120.0, -12.0),
    ]);
    let cam =
        Cam::new(program, follower("oscillating-flat", 60.0, &[("pivot_distance", 120.0)], Rotation::CounterClockwise));
    let analysis = Analysis::of(&cam, 720);
    assert_eq!((analysis.level, kinds(&analysis)), (Level::LowSpeed, vec![FindingKind::Jump(3)]));
    // The least face length is a result: m·cos ξ/(1 + v) at its greatest, over a grid of its own.
    let face = (0..72_000).map(|k| {
        let (motion, _) = cam.at(TAU * f64::from(k) / 72_000.0);
        120.0 * ((60.0_f64 / 120.0).asin() + motion.s).cos() / (1.0 + motion.v)
    });
    let face = face.fold(0.0, f64::max);
    let reach = analysis.summary.reach.expect("a face has a reach").max;
    assert!((reach / face - 1.0).abs() < 1e-7, "{reach} against {face}, found on a grid of 0.005°");
}

#[test]
fn classic_5acrt_and_6acpt_keep_their_breadth() {
    let program = lengths(&[
        ("simple-harmonic", 120.0, 20.0),
        ("dwell", 60.0, 0.0),
        ("simple-harmonic", 120.0, -20.0),
        ("dwell", 60.0, 0.0),
    ]);
    for k in 0..360 {
        let theta = f64::from(k).to_radians();
        let sum = program.at(theta).s + program.at(theta + PI).s;
        assert!((sum - 20.0).abs() < EXACT * 20.0, "s(θ) + s(θ + 180°) = {sum} at {k}°");
    }
}

#[test]
fn classic_6acpt_measures_the_same_across_every_diameter() {
    let program = lengths(&[
        ("simple-harmonic", 120.0, 20.0),
        ("dwell", 60.0, 0.0),
        ("simple-harmonic", 120.0, -20.0),
        ("dwell", 60.0, 0.0),
    ]);
    let cam = Cam::new(program, follower("translating-flat", 60.0, &[], Rotation::CounterClockwise));
    let profile = support::profile(&Analysis::of(&cam, 7200));
    let breadth = 2.0 * 60.0 + 20.0;
    for k in 0..180 {
        let (sin, cos) = f64::from(k).to_radians().sin_cos();
        let across = profile.iter().map(|p| p.re * cos + p.im * sin);
        let (low, high) = across.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), d| (low.min(d), high.max(d)));
        // Half a step of a 7200-sided polygon below the true width: Rp·(π/7200)²/2.
        assert!((high - low - breadth).abs() < 2e-5, "breadth {} at {k}°", high - low);
    }
}

#[test]
fn classic_9rt_swings_between_its_known_pressure_angles() {
    let analysis = Analysis::of(&nine_rt(), 720);
    assert_prints("φ min", analysis.summary.pressure_angle.min.to_degrees(), "-28.18");
    assert_prints("φ max", analysis.summary.pressure_angle.max.to_degrees(), "24.68");
    assert_eq!(analysis.level, Level::LowSpeed, "the jerk of three of its laws steps beside the dwells");
}

#[test]
fn classic_10ex_is_an_eccentric_circle() {
    let program = lengths(&[("simple-harmonic", 180.0, 20.0), ("simple-harmonic", 180.0, -20.0)]);
    let cam = Cam::new(program, follower("translating-flat", 40.0, &[], Rotation::CounterClockwise));
    let analysis = Analysis::of(&cam, 720);
    for rho in column(&analysis, Column::Rho) {
        assert!((rho - 50.0).abs() < EXACT * 50.0, "ρ = Rb + L/2");
    }
    for point in support::profile(&analysis) {
        let from_centre = (point.re.powi(2) + (point.im + 10.0).powi(2)).sqrt();
        assert!((from_centre - 50.0).abs() < EXACT * 50.0, "a circle about (0, −L/2)");
    }
    assert_eq!(analysis.level, Level::Acceptable);
}

#[test]
fn classic_11ro_is_acceptable() {
    let program = degrees(&[
        ("dwell", 90.0, 0.0),
        ("polynomial-4-5-6-7", 90.0, 25.0),
        ("polynomial-4-5-6-7", 45.0, -10.0),
        ("polynomial-4-5-6-7", 45.0, 10.0),
        ("polynomial-4-5-6-7", 90.0, -25.0),
    ]);
    let arm = [("roller_radius", 10.0), ("arm", 70.0), ("pivot_distance", 120.0)];
    let cam = Cam::new(program, follower("oscillating-roller", 80.0, &arm, Rotation::CounterClockwise));
    let analysis = Analysis::of(&cam, 720);
    assert_eq!((analysis.level, kinds(&analysis)), (Level::Acceptable, vec![]));
}

#[test]
fn classic_12po_serves_at_low_speeds_only() {
    let up_and_down = [("modified-trapezoidal", 60.0, 10.0), ("modified-trapezoidal", 60.0, -10.0)];
    let cam = Cam::new(
        degrees(&up_and_down.repeat(3)),
        follower("oscillating-flat", 125.0, &[("pivot_distance", 140.0)], Rotation::CounterClockwise),
    );
    let analysis = Analysis::of(&cam, 720);
    assert_eq!((analysis.level, kinds(&analysis)), (Level::LowSpeed, vec![FindingKind::Jump(3)]));
    assert_eq!(analysis.findings[0].places.len(), 6, "at every border");
}
