//! A cure cures: whatever is prescribed is applied and judged afresh, and the smallest cams are those of the closed forms.

mod support;

use levalab_core::{
    Analysis, Cam, Cure, Finding, FindingKind, Follower, Law, Program, Rotation, Segment, balanced_eccentricity,
    believable_sizes, prescribe, smallest_base_radius,
};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use support::random::{cam, cases, program};
use support::{blames_geometry, follower, lengths};

/// A solved radius against its closed form: the solver stops at 1e-12 of it, the limits themselves are kept to 1e-9.
const SOLVED: f64 = 1e-8;

/// A base circle this small beside the one it was sought from is none.
const VANISHED: f64 = 1e-5;

/// How far |φ| of rise and return may differ after balancing, radians.
const BALANCED: f64 = 1e-8;

fn analysis(cam: &Cam) -> Analysis {
    Analysis::of(cam, 720)
}

fn has(analysis: &Analysis, kind: FindingKind) -> bool {
    analysis.findings.iter().any(|finding| finding.kind == kind)
}

fn lowest_jump(analysis: &Analysis) -> Option<u8> {
    let jumps = analysis.findings.iter().filter_map(|finding| match finding.kind {
        FindingKind::Jump(order) => Some(order),
        _ => None,
    });
    jumps.min()
}

fn with_laws(cam: &Cam, changes: &[(usize, &'static Law)]) -> Cam {
    let mut segments = cam.program.segments().to_vec();
    for &(k, law) in changes {
        segments[k] = Segment { law, parameters: law.default_parameters(), ..segments[k].clone() };
    }
    Cam::new(Program::new(&segments).expect("a cure is a program"), cam.follower)
}

fn with_eccentricity(cam: &Cam, value: f64) -> Cam {
    let index = cam.follower.kind().index_of("eccentricity").expect("only what has an eccentricity is cured by one");
    Cam::new(cam.program.clone(), cam.follower.with_value(index, value).expect("a cure is a follower"))
}

/// Applies one cure of one finding and says what is not as promised.
fn judge(cam: &Cam, before: &Analysis, finding: &Finding, cure: &Cure) -> Result<(), TestCaseError> {
    let told = format!("{:?} cured by {cure:?}", finding.kind);
    match cure {
        Cure::NoSize { .. } => {}
        Cure::Length { key, value } => {
            let index = cam.follower.kind().index_of(key).expect("a parameter of the follower");
            let moved = cam.with_follower(cam.follower.with_value(index, *value).expect("a cure is a follower"));
            let left = analysis(&moved).findings.into_iter().find(blames_geometry);
            prop_assert!(left.is_none(), "{told} leaves {left:?}");
        }
        Cure::BaseRadius(radius) => {
            let after = analysis(&cam.with_base_radius(*radius).expect("a cure is a cam"));
            let left = after.findings.iter().find(|finding| blames_geometry(finding));
            prop_assert!(left.is_none(), "{told} leaves {left:?}");
            // A dwelling cam is limited by nothing, and its smallest is next to nothing.
            prop_assume!(*radius > VANISHED * cam.follower.base_radius());
            let (smallest, largest) = believable_sizes(cam);
            prop_assert!((smallest..=largest).contains(radius), "{told}, which is not believable");
            // The smallest size that is believable may not be the smallest that passes.
            prop_assume!(*radius > smallest);
            let smaller = cam.with_base_radius(0.99 * radius);
            let passes = smaller.is_ok_and(|cam| !analysis(&cam).findings.iter().any(blames_geometry));
            prop_assert!(!passes, "{told}, but a hundredth less would do");
        }
        Cure::Travel(length) => {
            let resize = |length: f64| levalab_core::resized(cam, length).expect("a cure is a cam");
            let left = analysis(&resize(*length)).findings.into_iter().find(blames_geometry);
            prop_assert!(left.is_none(), "{told} leaves {left:?}");
            prop_assert!(
                analysis(&resize(0.99 * length)).findings.iter().any(blames_geometry),
                "{told}, but less would do"
            );
        }
        Cure::Eccentricity { value, pressure_angle } => {
            let after = analysis(&with_eccentricity(cam, *value));
            let angles = after.summary.pressure_angle;
            prop_assert!((angles.greatest_size().0 - pressure_angle).abs() < BALANCED, "{told} leaves {angles:?}");
            prop_assert!((angles.max + angles.min).abs() < BALANCED, "{told} is not balanced: {angles:?}");
            prop_assert!(*pressure_angle < finding.value, "{told} is no better");
            let new = after.findings.iter().find(|f| blames_geometry(f) && f.kind != FindingKind::PressureAngle);
            prop_assert!(new.is_none(), "{told} brings {new:?}");
        }
        Cure::Laws { changes, remaining_jump } => {
            let after = analysis(&with_laws(cam, changes));
            prop_assert_eq!(lowest_jump(&after), *remaining_jump, "{}", told);
            prop_assert!(!has(&after, finding.kind), "{told} leaves it");
            if let FindingKind::Jump(order) = finding.kind {
                prop_assert!(remaining_jump.is_none_or(|jump| jump > order), "{told} leaves a worse jump");
            }
            if !before.findings.iter().any(blames_geometry) {
                let new = after.findings.iter().find(|finding| blames_geometry(finding));
                prop_assert!(new.is_none(), "{told} brings {new:?}");
            }
            let sinks = has(&after, FindingKind::BelowBase) && !has(before, FindingKind::BelowBase);
            prop_assert!(!sinks, "{told} takes the follower below the base circle");
        }
    }
    Ok(())
}

#[test]
fn every_cure_removes_what_it_is_prescribed_for() {
    let outcome = TestRunner::new(cases(64)).run(&cam(), |cam| {
        let before = analysis(&cam);
        let all = prescribe(&cam, &before);
        prop_assert_eq!(all.len(), before.findings.len(), "one list a finding");
        for (finding, cures) in before.findings.iter().zip(&all) {
            for cure in cures {
                judge(&cam, &before, finding, cure)?;
            }
        }
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

fn sliding(program: Program, id: &str, base_radius: f64, given: &[(&str, f64)]) -> Cam {
    Cam::new(program, follower(id, base_radius, given, Rotation::CounterClockwise))
}

/// Greatest `reading` of the motion over every stretch: both ends, and a fine grid refined around its best.
fn greatest(program: &Program, reading: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let mut best = f64::NEG_INFINITY;
    for stretch in program.stretches() {
        let at = |part: f64| {
            let motion = stretch.at(stretch.from + (stretch.to - stretch.from) * part.clamp(0.0, 1.0));
            reading(motion.s, motion.v, motion.a)
        };
        let (mut middle, mut step) = (0.5, 0.5 / 1000.0);
        for _ in 0..4 {
            let around = (-1000..=1000).map(|i| middle + step * f64::from(i));
            middle = around.max_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap_or(middle);
            step /= 500.0;
        }
        best = best.max(at(middle));
    }
    best
}

#[test]
fn the_smallest_cam_under_a_flat_face_is_as_large_as_the_deepest_s_plus_a() {
    let outcome = TestRunner::new(cases(48)).run(&program(20.0), |program| {
        let needed = greatest(&program, |s, _, a| -(s + a));
        // A follower that is never thrown upwards can rest on any base circle.
        prop_assume!(needed > 0.1);
        let found = smallest_base_radius(&sliding(program, "translating-flat", 50.0, &[]));
        let found = found.ok_or_else(|| TestCaseError::fail(format!("none found, though {needed} would do")))?;
        prop_assert!((found / needed - 1.0).abs() < SOLVED, "{found}, not −min(s + a) = {needed}");
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn the_smallest_cam_under_a_knife_edge_is_that_of_its_pressure_angle() {
    // tan φ = |v|/(Rb + s) for an edge on the axis, whose profile cannot be undercut.
    let outcome = TestRunner::new(cases(48)).run(&program(20.0), |program| {
        let steepest = 30_f64.to_radians().tan();
        let needed = greatest(&program, |s, v, _| v.abs() / steepest - s);
        prop_assume!(needed > 0.1);
        let cam = sliding(program, "translating-knife", 50.0, &[]);
        // Where displacement or velocity jumps the pitch curve tears or breaks, which no size mends.
        prop_assume!(lowest_jump(&analysis(&cam)).is_none_or(|jump| jump > 1));
        let found = smallest_base_radius(&cam);
        let found = found.ok_or_else(|| TestCaseError::fail(format!("none found, though {needed} would do")))?;
        prop_assert!((found / needed - 1.0).abs() < SOLVED, "{found}, not max(|v|/tan 30° − s) = {needed}");
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn the_smallest_cam_under_a_radial_roller_is_that_of_its_pressure_angle() {
    // Where curvature does not bind: a small roller and gentle laws.
    let steepest = 30_f64.to_radians().tan();
    for rotation in support::ROTATIONS {
        for laws in
            [["cycloidal", "modified-sine"], ["polynomial-3-4-5", "simple-harmonic"], ["polynomial-4-5-6-7", "cubic-2"]]
        {
            let program =
                lengths(&[(laws[0], 80.0, 20.0), ("dwell", 100.0, 0.0), (laws[1], 100.0, -20.0), ("dwell", 80.0, 0.0)]);
            let needed = greatest(&program, |s, v, _| v.abs() / steepest - s) - 1.0;
            let cam = Cam::new(program, follower("translating-roller", 15.0, &[("roller_radius", 1.0)], rotation));
            let found = smallest_base_radius(&cam).expect("a size that passes");
            assert!((found / needed - 1.0).abs() < SOLVED, "{laws:?}: {found}, not {needed}");
        }
    }
}

#[test]
fn the_smallest_cam_is_the_same_from_wherever_it_is_sought() {
    let outcome = TestRunner::new(cases(24)).run(&(program(20.0), -9.0..9.0), |(program, eccentricity)| {
        let given = [("roller_radius", 8.0), ("eccentricity", eccentricity)];
        let sought = |base_radius: f64| {
            smallest_base_radius(&sliding(program.clone(), "translating-roller", base_radius, &given))
        };
        let (from_below, from_above) = (sought(10.0), sought(300.0));
        let agree = match (from_below, from_above) {
            // Where the roller alone is large enough, nothing limits the cam from below and both come near to nothing.
            (Some(a), Some(b)) => (a / b - 1.0).abs() < SOLVED || a.max(b) < VANISHED * 300.0,
            (None, None) => true,
            _ => false,
        };
        prop_assert!(agree, "{from_below:?} from 10, {from_above:?} from 300");
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn a_cam_that_only_dwells_has_no_smallest_size_to_wait_for() {
    let still = lengths(&[("dwell", 360.0, 0.0)]);
    for (id, given) in
        [("translating-roller", &[("roller_radius", 5.0)][..]), ("translating-knife", &[]), ("translating-flat", &[])]
    {
        let cam = sliding(still.clone(), id, 40.0, given);
        assert!(smallest_base_radius(&cam).is_none_or(|radius| radius > 0.0 && radius <= 40.0), "{id}");
    }
}

#[test]
fn a_balanced_eccentricity_balances() {
    let program = lengths(&[
        ("cycloidal", 90.0, 20.0),
        ("dwell", 60.0, 0.0),
        ("polynomial-3-4-5", 150.0, -20.0),
        ("dwell", 60.0, 0.0),
    ]);
    for rotation in support::ROTATIONS {
        let roller = follower("translating-roller", 30.0, &[("roller_radius", 6.0)], rotation);
        let cam = Cam::new(program.clone(), roller);
        let value = balanced_eccentricity(&cam).expect("a steep rise and a gentle return balance");
        assert_eq!(value.signum(), rotation.sigma(), "the axis moves to the side where it eases the rise");
        let (plain, balanced) =
            (analysis(&cam).summary.pressure_angle, analysis(&with_eccentricity(&cam, value)).summary.pressure_angle);
        assert!((balanced.max + balanced.min).abs() < BALANCED);
        assert!(balanced.max < plain.max);
    }
}

#[test]
fn a_follower_without_eccentricity_is_not_offered_one() {
    let program = lengths(&[("cycloidal", 90.0, 20.0), ("cycloidal", 270.0, -20.0)]);
    let flat: Follower = follower("translating-flat", 30.0, &[], Rotation::CounterClockwise);
    assert_eq!(balanced_eccentricity(&Cam::new(program, flat)), None);
}
