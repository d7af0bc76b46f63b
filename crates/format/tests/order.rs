//! Findings come by severity and then by θ, and of equal jumps and extremes the first by θ is named, whatever the number of rows.

use levalab_core::{Analysis, Cam, Finding, FindingKind, Level};
use levalab_format::{Design, EXAMPLES, apply, cures, example};
use serde_json::{Value, json};

fn design(follower: &Value, base_radius: f64, segments: &Value) -> Design {
    let text = json!({
        "format": "levalab/1",
        "title": "",
        "cam": { "kind": "rotating", "base_radius": base_radius },
        "follower": follower,
        "segments": segments,
    });
    Design::from_json(&text.to_string()).expect("a design")
}

/// As many equal lobes as divide the turn.
fn lobes(count: u32, law: &str, base_radius: f64) -> Design {
    let beta = 180.0 / f64::from(count);
    let lobe = [json!({ "law": law, "beta": beta, "rise": 10 }), json!({ "law": law, "beta": beta, "rise": -10 })];
    let segments = (0..count).flat_map(|_| lobe.clone()).collect();
    design(&json!({ "motion": "translating", "contact": "roller", "roller_radius": 5 }), base_radius, &segments)
}

/// Jumps of *v* at 200° and 260°, after the pressure angle's maximum in the rise at the beginning.
fn steep_then_broken() -> Design {
    let segments = json!([
        { "law": "cycloidal", "beta": 40, "rise": 20 },
        { "law": "dwell", "beta": 160 },
        { "law": "constant-velocity", "beta": 60, "rise": -15 },
        { "law": "cycloidal", "beta": 100, "rise": -5 },
    ]);
    design(&json!({ "motion": "translating", "contact": "roller", "roller_radius": 5 }), 40.0, &segments)
}

fn cams(design: &Design) -> Vec<Cam> {
    let cam = design.cam().expect("a cam");
    let second = design.second(&cam).expect("a pair or none");
    [cam].into_iter().chain(second).collect()
}

fn found(cam: &Cam, rows: usize, kind: FindingKind) -> Finding {
    let findings = Analysis::of(cam, rows).findings;
    findings.into_iter().find(|finding| finding.kind == kind).expect("a finding of that kind")
}

#[test]
fn findings_come_by_severity_and_then_by_place() {
    let examples = EXAMPLES.iter().map(|(name, _)| example(name).expect(name));
    for design in examples.chain([steep_then_broken(), lobes(8, "parabolic", 30.0)]) {
        for cam in cams(&design) {
            let findings = Analysis::of(&cam, 1).findings;
            for pair in findings.windows(2) {
                let in_order = pair[0].level > pair[1].level
                    || pair[0].level == pair[1].level && pair[0].theta <= pair[1].theta + 1e-6;
                assert!(in_order, "{}: {:?}", design.title, findings);
            }
        }
    }
}

#[test]
fn a_pressure_angle_before_a_jump_of_the_velocity_comes_first_and_keeps_its_cures() {
    let design = steep_then_broken();
    let cam = design.cam().expect("a cam");
    let analysis = Analysis::of(&cam, 1);
    let kinds: Vec<FindingKind> = analysis.findings.iter().map(|finding| finding.kind).collect();
    assert_eq!(kinds[..2], [FindingKind::PressureAngle, FindingKind::Jump(1)]);
    assert_eq!(kinds.last(), Some(&FindingKind::Jump(3)));
    assert_eq!(analysis.findings.last().map(|finding| finding.level), Some(Level::LowSpeed));
    for (finding, cures) in analysis.findings.iter().zip(cures(&design, &cam, &analysis)) {
        for cure in cures.iter().filter(|cure| !cure.edits.is_empty()) {
            let after = apply(&design, &cure.edits).expect("a design");
            let left = Analysis::of(&after.cam().expect("a cam"), 1).findings;
            let same = left.iter().find(|other| other.kind == finding.kind);
            assert!(same.is_none_or(|other| other.value.abs() < finding.value.abs()), "{:?} {cure:?}", finding.kind);
        }
    }
}

#[test]
fn of_equal_jumps_the_first_is_named_at_720_and_at_7200_rows() {
    for (design, kind) in [
        (lobes(8, "parabolic", 60.0), FindingKind::Jump(2)),
        (lobes(9, "modified-trapezoidal", 60.0), FindingKind::Jump(3)),
        (lobes(7, "cycloidal", 60.0), FindingKind::Jump(3)),
    ] {
        let cam = design.cam().expect("a cam");
        let [few, many] = [720, 7200].map(|rows| found(&cam, rows, kind));
        assert_eq!(few, many);
        let size = |theta: f64| {
            let joints = cam.program.classified_joints();
            let joint = joints.into_iter().find(|joint| joint.theta == theta).expect("a joint");
            let FindingKind::Jump(order) = kind else { unreachable!() };
            (joint.after.order(usize::from(order)) - joint.before.order(usize::from(order))).abs()
        };
        let first = few.places.iter().copied().find(|&theta| size(theta) >= few.value * (1.0 - 1e-9));
        assert_eq!(first, Some(few.theta), "{kind:?} of {:?}", few.places);
    }
}

#[test]
fn of_equal_pressure_angles_the_first_is_named_at_720_and_at_7200_rows() {
    for count in [5, 7, 8, 32] {
        let cam = lobes(count, "modified-trapezoidal", 30.0).cam().expect("a cam");
        let reference = found(&cam, 1, FindingKind::PressureAngle);
        let lobe = std::f64::consts::TAU / f64::from(count);
        assert!(reference.theta < lobe, "{count}: {}°", reference.theta.to_degrees());
        for rows in [360, 720, 1000, 3600, 7200] {
            let other = found(&cam, rows, FindingKind::PressureAngle);
            assert!(
                (other.theta - reference.theta).abs() < 1e-6,
                "{count} lobes, {rows} rows: {}°",
                other.theta.to_degrees()
            );
        }
    }
}

#[test]
fn places_of_extremes_do_not_depend_on_the_rows() {
    for (name, _) in EXAMPLES {
        for cam in cams(&example(name).expect(name)) {
            let places = |rows: usize| {
                let summary = Analysis::of(&cam, rows).summary;
                let all = [summary.s, summary.v, summary.a, summary.j, summary.pressure_angle, summary.rho];
                all.map(|extremes| [extremes.min_at, extremes.max_at])
            };
            let reference = places(720);
            for rows in [1, 1000, 7200] {
                for (found, expected) in places(rows).as_flattened().iter().zip(reference.as_flattened()) {
                    assert!((found - expected).abs() < 1e-5, "{name}, {rows} rows: {found} and {expected}");
                }
            }
        }
    }
}
