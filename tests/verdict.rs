//! Jumps found are the jumps built in, findings are where they are said to be, and what cannot be is refused by name.

mod support;

use levalab_core::law::Law;
use levalab_core::{
    Analysis, Cam, FOLLOWERS, FindingKind, Follower, FollowerKind, GeometryProblem, Misfit, Program, ProgramProblem,
    Rotation, Segment,
};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use support::random::{cases, follower_of, program};
use support::{follower, lengths};

/// Derivatives y′, y″, y‴ at the start and at the end of a rise from 0 to 1, and the orders that jump within.
type Ends = ([f64; 3], [f64; 3], &'static [u8]);

/// The ends of a law, from the formulas of textbooks; none for a law that takes its ends from its neighbours.
fn ends(segment: &Segment) -> Option<Ends> {
    let pi2 = PI * PI;
    let plain = |start: [f64; 3], end: [f64; 3]| -> Option<Ends> { Some((start, end, &[])) };
    match segment.law.id {
        "dwell" | "polynomial-4-5-6-7" => plain([0.0; 3], [0.0; 3]),
        "constant-velocity" => plain([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        "parabolic" => Some(([0.0, 4.0, 0.0], [0.0, -4.0, 0.0], &[2])),
        "parabolic-blend" => {
            let [first, last, _] = segment.parameters;
            let v = 1.0 / (1.0 - 0.5 * (first + last));
            // Without its parabola an end has the velocity of the line.
            let side = |span: f64| if span > 0.0 { [0.0, v / span, 0.0] } else { [v, 0.0, 0.0] };
            let [end_v, end_a, _] = side(last);
            Some((side(first), [end_v, -end_a, 0.0], if first > 0.0 && last > 0.0 { &[2, 2] } else { &[2] }))
        }
        "cubic-1" => Some(([0.0, 0.0, 24.0], [0.0, 0.0, 24.0], &[2])),
        "cubic-2" => plain([0.0, 6.0, -12.0], [0.0, -6.0, -12.0]),
        "simple-harmonic" => plain([0.0, pi2 / 2.0, 0.0], [0.0, -pi2 / 2.0, 0.0]),
        // Its return is its rise reversed: soft where the rise is hard.
        "double-harmonic" if segment.rise < 0.0 => plain([0.0, pi2, 0.0], [0.0; 3]),
        "double-harmonic" => plain([0.0; 3], [0.0, -pi2, 0.0]),
        // 4π² · 1125/1192 · (1 + 1/2 + 1/10), three harmonics in step at both ends.
        "freudenstein-1-3-5" => plain([0.0, 0.0, 900.0 / 149.0 * pi2], [0.0, 0.0, 900.0 / 149.0 * pi2]),
        "cycloidal" => plain([0.0, 0.0, 4.0 * pi2], [0.0, 0.0, 4.0 * pi2]),
        "polynomial-3-4-5" | "polynomial" | "bspline" | "bezier" | "formula" => {
            plain([0.0, 0.0, 60.0], [0.0, 0.0, 60.0])
        }
        "modified-trapezoidal" => sine_constant_cosine(0.25, 0.5),
        "modified-sine" => sine_constant_cosine(0.25, 0.0),
        "scca" => sine_constant_cosine(segment.parameters[0], segment.parameters[1]),
        "skewed-scca" => {
            let [b, c, crossover] = segment.parameters;
            // The cosine that swings through the crossover does so at two rates.
            let within: &[u8] = if crossover == 0.5 { &[] } else { &[3] };
            sine_constant_cosine(b, c).map(|(start, end, _)| skewed(start, end, crossover, within))
        }
        "asymmetric-3-4-5" => Some(skewed([0.0, 0.0, 60.0], [0.0, 0.0, 60.0], segment.parameters[0], &[3])),
        "half-harmonic-start" => plain([0.0, pi2 / 4.0, 0.0], [FRAC_PI_2, 0.0, -PI * pi2 / 8.0]),
        "half-harmonic-end" => plain([FRAC_PI_2, 0.0, -PI * pi2 / 8.0], [0.0, -pi2 / 4.0, 0.0]),
        "half-cycloidal-start" => plain([0.0, 0.0, pi2], [2.0, 0.0, -pi2]),
        "half-cycloidal-end" => plain([2.0, 0.0, -pi2], [0.0, 0.0, pi2]),
        "polynomial-5" | "polynomial-7" => None,
        other => panic!("no end derivatives of {other} to compare with: give them here"),
    }
}

/// Halves stretched by twice what they span: y″ and y‴ go with the first and the second power of it.
fn skewed(start: [f64; 3], end: [f64; 3], crossover: f64, within: &'static [u8]) -> Ends {
    let stretched = |[v, a, j]: [f64; 3], by: f64| [v, a / by, j / (by * by)];
    (stretched(start, 2.0 * crossover), stretched(end, 2.0 - 2.0 * crossover), within)
}

/// Norton, *Cam Design and Manufacturing Handbook*, ch. 3: Cₐ = 4π²/((π² − 8)(b² − d²) − 2π(π − 2)b + π²).
fn sine_constant_cosine(b: f64, c: f64) -> Option<Ends> {
    let d = 1.0 - b - c;
    let peak = 4.0 * PI * PI / ((PI * PI - 8.0) * (b * b - d * d) - TAU * (PI - 2.0) * b + PI * PI);
    let (a, j) = if b > 0.0 { (0.0, peak * PI / b) } else { (peak, 0.0) };
    Some(([0.0, a, j], [0.0, -a, j], &[]))
}

/// The lowest order in which two sides differ, by a part of the greatest of its kind that random figures do not come near.
fn lowest_difference(before: [f64; 3], after: [f64; 3], greatest: [f64; 3]) -> Option<u8> {
    (0..3).find(|&k| (before[k] - after[k]).abs() > 1e-7 * greatest[k]).map(|k| k as u8 + 1)
}

fn scaled(ends: [f64; 3], segment: &Segment) -> [f64; 3] {
    [1, 2, 3].map(|order| ends[order - 1] * segment.rise / segment.beta.powi(order as i32))
}

#[test]
fn the_jumps_found_are_the_jumps_built_in() {
    let outcome = TestRunner::new(cases(256)).run(&program(10.0), |program| {
        let segments = program.segments();
        let n = segments.len();
        let joints = program.classified_joints();
        let sides: Vec<_> = joints.iter().flat_map(|joint| [joint.before, joint.after]).collect();
        let greatest = [1, 2, 3].map(|order| sides.iter().map(|side| side.order(order).abs()).fold(0.0, f64::max));
        for k in 0..n {
            let (left, right) = (&segments[(k + n - 1) % n], &segments[k]);
            let border = program.borders()[k];
            let found = joints
                .iter()
                .find(|joint| joint.theta == border && joint.segment == k)
                .expect("every border is a joint")
                .jump;
            let name = format!("{} to {} at {border}", left.law.id, right.law.id);
            // A table takes v and a from what it can, and its neighbours from it what they can.
            if left.law.id == "table" || right.law.id == "table" {
                continue;
            }
            match (ends(left), ends(right)) {
                (Some((_, before, _)), Some((after, _, _))) => {
                    let built_in = lowest_difference(scaled(before, left), scaled(after, right), greatest);
                    prop_assert_eq!(found, built_in, "{}", name);
                }
                // A generic polynomial takes over s, v, a, and with degree 7 j as well.
                _ if left.law.id == "polynomial-7" || right.law.id == "polynomial-7" => {
                    prop_assert_eq!(found, None, "{}", name);
                }
                _ => prop_assert!(found.is_none_or(|order| order == 3), "{name}: {found:?}"),
            }
            let inside =
                joints.iter().filter(|joint| joint.segment == k && joint.theta != border && joint.jump.is_some());
            let expected = ends(right).filter(|_| right.rise != 0.0).map_or(&[][..], |ends| ends.2);
            let inside: Vec<u8> = inside.filter_map(|joint| joint.jump).collect();
            prop_assert_eq!(inside, expected, "within {}", right.law.id);
        }
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn what_closes_within_the_tolerance_is_no_jump() {
    // Metres typed to ten digits: half a nanometre is left over, which a program is allowed.
    let program = lengths(&[
        ("cycloidal", 120.0, 0.05),
        ("dwell", 60.0, 0.0),
        ("cycloidal", 120.0, -0.049_999_999_5),
        ("dwell", 60.0, 0.0),
    ]);
    assert_eq!(program.classified_joints().iter().filter_map(|joint| joint.jump).min(), Some(3));
}

#[test]
fn each_undercut_is_worst_within_its_own_stretch() {
    // The second stretch, at the start of the return, is a tenth of a degree long: no station falls in it.
    let segments = [
        ("dwell", 5.590_852_098_096_93, 0.0),
        ("polynomial-4-5-6-7", 0.296_138_387_229_699, 17.56),
        ("cubic-2", 0.0, -17.56),
    ];
    let mut segments = segments.map(|(law, beta, rise)| Segment::new(Law::by_id(law).expect(law), beta, rise));
    segments[2].beta = TAU - segments[0].beta - segments[1].beta;
    let program = Program::new(&segments).expect("a program");
    let roller = follower("translating-roller", 37.38, &[("roller_radius", 4.953)], Rotation::CounterClockwise);
    let findings = Analysis::of(&Cam::new(program, roller), 720).findings;
    let undercut: Vec<_> = findings.iter().filter(|finding| finding.kind == FindingKind::Undercut).collect();
    assert_eq!(undercut.len(), 2);
    for finding in undercut {
        let (from, to) = finding.interval.expect("a stretch");
        assert!((from..=to).contains(&finding.theta), "{finding:?}");
    }
}

fn refusal(id: &str, base_radius: f64, values: [f64; 4]) -> (&'static str, GeometryProblem) {
    let kind = FollowerKind::by_id(id).expect(id);
    let error = Follower::new(kind, base_radius, &values, Rotation::CounterClockwise)
        .expect_err("this cannot rest on its base circle");
    (error.key, error.problem)
}

#[test]
fn a_follower_that_cannot_be_is_refused_by_the_magnitude_to_blame() {
    for id in FOLLOWERS.iter().map(|kind| kind.id) {
        assert_eq!(refusal(id, 0.0, [1.0; 4]), ("base_radius", GeometryProblem::NotPositive { found: 0.0 }), "{id}");
        assert_eq!(refusal(id, -3.0, [1.0; 4]), ("base_radius", GeometryProblem::NotPositive { found: -3.0 }), "{id}");
        assert_eq!(refusal(id, f64::INFINITY, [1.0; 4]), ("base_radius", GeometryProblem::NotFinite), "{id}");
    }
    for (id, key, values) in [
        ("translating-roller", "roller_radius", [0.0, 0.0, 0.0, 0.0]),
        ("translating-curved", "face_radius", [0.0, 0.0, 0.0, 0.0]),
        ("oscillating-roller", "roller_radius", [0.0, 80.0, 80.0, 0.0]),
        ("oscillating-roller", "arm", [10.0, 0.0, 80.0, 0.0]),
        ("oscillating-flat", "pivot_distance", [0.0, 0.0, 0.0, 0.0]),
    ] {
        assert_eq!(refusal(id, 40.0, values), (key, GeometryProblem::NotPositive { found: 0.0 }), "{id}");
    }
    assert_eq!(
        refusal("translating-roller", 40.0, [10.0, -50.0, 0.0, 0.0]),
        ("eccentricity", GeometryProblem::Misfit(Misfit::Eccentricity { eccentricity: -50.0, prime_radius: 50.0 })),
    );
    assert_eq!(
        refusal("translating-knife", 40.0, [40.0, 0.0, 0.0, 0.0]),
        ("eccentricity", GeometryProblem::Misfit(Misfit::Eccentricity { eccentricity: 40.0, prime_radius: 40.0 })),
    );
    assert!(matches!(
        refusal("translating-flat", 40.0, [FRAC_PI_2, 0.0, 0.0, 0.0]),
        ("face_angle", GeometryProblem::Outside { .. })
    ));
    for (arm, pivot_distance) in [(20.0, 100.0), (100.0, 20.0), (20.0, 30.0)] {
        let (key, problem) = refusal("oscillating-roller", 40.0, [10.0, arm, pivot_distance, 0.0]);
        assert_eq!(
            (key, problem),
            ("pivot_distance", GeometryProblem::Misfit(Misfit::Triangle { pivot_distance, arm, prime_radius: 50.0 }))
        );
    }
    let (key, problem) = refusal("oscillating-flat", 40.0, [-10.0, 50.0, 0.0, 0.0]);
    assert_eq!(
        (key, problem),
        ("pivot_distance", GeometryProblem::Misfit(Misfit::FaceOutOfReach { pivot_distance: 50.0, needed: 50.0 }))
    );
}

#[test]
fn a_parameter_that_is_not_a_number_is_refused_by_its_own_name() {
    for kind in FOLLOWERS {
        let outcome = TestRunner::new(cases(4)).run(&follower_of(kind), |good| {
            for (index, parameter) in kind.parameters.iter().enumerate() {
                for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    let error = good.with_value(index, bad).expect_err("not a number");
                    prop_assert_eq!((error.key, error.problem), (parameter.key, GeometryProblem::NotFinite));
                }
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{}: {error}", kind.id));
    }
}

#[test]
fn a_segment_that_cannot_be_is_refused_at_its_place() {
    let good = || {
        lengths(&[("cycloidal", 120.0, 10.0), ("dwell", 60.0, 0.0), ("scca", 120.0, -10.0), ("dwell", 60.0, 0.0)])
            .segments()
            .to_vec()
    };
    let refused = |k: usize, spoil: &dyn Fn(&mut Segment)| {
        let mut segments = good();
        spoil(&mut segments[k]);
        let error = Program::new(&segments).expect_err("spoilt");
        assert_eq!(error.segment, k, "{error:?}");
        error.problem
    };
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e-6, 7.0] {
        assert!(matches!(refused(2, &|segment| segment.beta = bad), ProgramProblem::Beta { .. }), "β = {bad}");
    }
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(0, &|segment| segment.rise = bad), ProgramProblem::Rise { .. }), "L = {bad}");
    }
    assert_eq!(refused(1, &|segment| segment.rise = 1.0), ProgramProblem::DwellRises { found: 1.0 });
    for (parameters, key) in
        [([f64::NAN, 0.5], "b"), ([-0.1, 0.5], "b"), ([1.1, 0.0], "b"), ([0.5, 0.6], "c"), ([0.5, f64::NAN], "c")]
    {
        let problem = refused(2, &|segment| segment.parameters[..2].copy_from_slice(&parameters));
        assert!(matches!(problem, ProgramProblem::Parameter { key: named, .. } if named == key), "{problem:?}");
    }
    let many = vec![Segment::of("dwell", 360.0 / 65.0, 0.0).expect("dwell"); 65];
    assert_eq!(Program::new(&many).expect_err("too many").problem, ProgramProblem::Count { found: 65 });
    assert!(
        Program::new(&many[..64].iter().map(|s| Segment { beta: TAU / 64.0, ..s.clone() }).collect::<Vec<_>>()).is_ok()
    );
}
