//! The examples library: every design is a cam, has its words in both languages, and shows the figures that they tell.

use levalab_core::{Analysis, Cam, Column, Level, Tie, profiles_coincide, working_ties};
use levalab_format::report::{Report, column};
use levalab_format::{Design, EXAMPLES, example};
use serde_json::Value;

const NOTES: &str = include_str!("../../../crates/words/examples.json");

fn cam(name: &str) -> (Design, Cam) {
    let design = example(name).expect(name);
    let cam = design.cam().expect(name);
    (design, cam)
}

fn report(name: &str) -> (Design, Analysis, Report) {
    let (design, cam) = cam(name);
    let analysis = Analysis::of(&cam, 360);
    let report = Report::of(&design, &cam, &analysis);
    (design, analysis, report)
}

#[test]
fn every_example_has_a_title_and_a_note_in_both_languages() {
    let notes: Value = serde_json::from_str(NOTES).expect("JSON");
    let notes = notes.as_array().expect("a list");
    assert_eq!(notes.len(), EXAMPLES.len());
    for ((name, _), notes) in EXAMPLES.iter().zip(notes) {
        assert_eq!(notes["id"], *name, "in the same order");
        for language in ["en", "es"] {
            let words = |field: &str| notes[language][field].as_str().expect(name).to_owned();
            assert!((10..80).contains(&words("title").chars().count()), "{name} {language}");
            let note = words("note");
            let sentences = note.matches(". ").count() + 1;
            assert!((2..=5).contains(&sentences) && note.ends_with('.'), "{name} {language}: {sentences} sentences");
        }
    }
}

#[test]
fn verdicts_are_those_of_the_notes() {
    let expected = [
        ("1RT", Level::Acceptable),
        ("2RO", Level::Acceptable),
        ("3PT", Level::Acceptable),
        ("4PO", Level::LowSpeed),
        ("5ACRT", Level::Acceptable),
        ("6ACPT", Level::Acceptable),
        ("7CRT", Level::Acceptable),
        ("8DA", Level::Acceptable),
        ("9RT", Level::LowSpeed),
        ("10EX", Level::Acceptable),
        ("11RO", Level::Acceptable),
        ("12PO", Level::LowSpeed),
        ("R1", Level::Unacceptable),
        ("R2", Level::LowSpeed),
        ("R3", Level::Unacceptable),
        ("R4", Level::Unacceptable),
        ("R5", Level::Unacceptable),
        ("R6", Level::LowSpeed),
        ("WEDGE", Level::Acceptable),
        ("GROOVE", Level::Acceptable),
        ("ARCS", Level::Acceptable),
    ];
    assert_eq!(expected.len(), EXAMPLES.len());
    for (name, level) in expected {
        assert_eq!(report(name).2.level, level, "{name}");
    }
}

#[test]
fn the_first_example_is_no_circle_but_tends_to_one() {
    let spread = |grown: f64| {
        let mut design = example("1RT").expect("1RT");
        design.values[0] *= grown;
        let cam = design.cam().expect("a cam");
        let summary = Analysis::of(&cam, 720).summary;
        (summary.rho.max / summary.rho.min, summary.pressure_angle.max)
    };
    let (as_it_is, larger) = (spread(1.0), spread(10.0));
    assert!(as_it_is.0 > 1.05, "ρ is not constant: {}", as_it_is.0);
    let centre = |(ratio, _): (f64, f64)| ratio - 1.0;
    assert!(larger.1 < as_it_is.1 / 2.0, "φ falls");
    assert!(centre(larger) < centre(as_it_is) * 1.5, "{larger:?} after {as_it_is:?}");
}

#[test]
fn pairs_stand_at_the_distances_of_the_book() {
    for (name, distance, starts_with, second_radius) in [("7CRT", 380.0, -20.0, 190.0), ("8DA", 225.0, -25.0, 100.0)] {
        let (design, first) = cam(name);
        assert_eq!(design.conjugate.expect(name).tie, Tie::Distance(distance));
        let second = design.second(&first).expect(name).expect("a pair");
        assert_eq!(second.program.segments()[0].rise, starts_with, "{name}: the conjugate starts with a return");
        assert_eq!(Analysis::of(&second, 360).level, Level::Acceptable, "{name}");
        let radius = second.follower.base_radius();
        assert!((radius - second_radius).abs() < 1e-12, "{name}: {radius}");
        assert!(!profiles_coincide(&first, &second), "{name} shows two cams");
    }
}

#[test]
fn the_oscillating_roller_has_no_conjugate_at_any_angle() {
    let (_, first) = cam("11RO");
    assert_eq!(working_ties(&first, Tie::Angle(0.0), None), None);
    assert_eq!(working_ties(&first, Tie::BaseRadius(0.0), None), None);
}

#[test]
fn the_gait_simulator_hits_the_forces_that_it_was_measured_with() {
    let (design, cam) = cam("R6");
    let analysis = Analysis::of(&cam, 360);
    let application = design.application.as_ref().expect("a piston");
    let outcome = application.outcome(&design, &cam, &analysis);
    let (figure, stiffness) = outcome.figures[1];
    assert_eq!((figure.id, design.length_unit.unit_of(figure.magnitude)), ("stiffness", "lbf/in"));
    assert!((stiffness - 93.684).abs() < 5e-4, "{stiffness}");
    let force = outcome.outputs[0];
    assert_eq!((force.output.id, design.length_unit.unit_of(force.output.magnitude)), ("force", "lbf"));
    assert!((force.range.max - 126.1825).abs() < 5e-4 && (force.range.max_at - 74.39).abs() < 5e-3, "{force:?}");
    let places: Vec<f64> = outcome.targets.iter().map(|target| target.theta).collect();
    assert_eq!(places, [0.0, 56.88, 123.84, 198.72, 256.32]);
    for (target, lift) in outcome.targets.iter().zip([0.0, 1.177_168_358, 0.846_866_970, 1.138_581_249, 0.0]) {
        assert!((target.found - stiffness * lift).abs() < 1e-9, "{target:?}");
        assert!(target.error.abs() <= 1e-6, "s = F/K to nine decimals: {target:?}");
        assert!((target.time * 12.566 - target.theta.to_radians()).abs() < 1e-9);
    }
    let column = application.column(&design, &analysis, force.output);
    assert!(column.len() == 361 && column[300].abs() < 1e-9 && column[57] > 100.0);
    // A pump on the same cam delivers both of its rises, which turn within one segment.
    let mut pump = design.clone();
    let lifts = cam.program.at(198.72_f64.to_radians()).s;
    assert!((lifts - 1.138_581_249).abs() < 1e-9);
    let kind = levalab_core::application::Application::by_id("pump").expect("pump");
    let set = levalab_format::ApplicationDesign {
        application: kind,
        values: [1.0, 0.0],
        targets: vec![],
        ..application.clone()
    };
    pump.application = Some(set.clone());
    assert!(pump.cam().is_ok());
    let volume = set.outcome(&pump, &cam, &analysis).outputs[0];
    // Tops and hollow of s by search among a million rows.
    let rows: Vec<f64> = (0..1_000_000).map(|k| cam.program.at(f64::from(k) / 1e6 * std::f64::consts::TAU).s).collect();
    let risen: f64 = rows.windows(2).map(|pair| (pair[1] - pair[0]).max(0.0)).sum();
    let delivered = volume.per_cycle.expect("strokes") / std::f64::consts::PI;
    assert!((delivered - risen).abs() < 1e-9 && delivered > 1.5, "{delivered} {risen}");
}

#[test]
fn targets_by_time_go_on_from_turn_to_turn_and_come_back_on_a_wedge() {
    let (mut design, cam) = cam("R6");
    let mut application = design.application.clone().expect("a piston");
    let turn = std::f64::consts::TAU / design.omega();
    application.by = levalab_format::TargetsBy::Time;
    application.targets = vec![[0.05, 0.0], [0.05 + turn, 0.0]];
    design.application = Some(application.clone());
    let analysis = Analysis::of(&cam, 360);
    let found = application.outcome(&design, &cam, &analysis).targets;
    assert!((found[0].found - found[1].found).abs() < 1e-9 && found[0].found > 1.0, "{found:?}");
    assert_eq!(found[1].time, 0.05 + turn);

    let (mut wedge, cam) = self::cam("WEDGE");
    let whole = wedge.kind.travel().expect("a travel");
    application.targets = vec![[0.25 * whole / wedge.omega(), 0.0], [1.75 * whole / wedge.omega(), 0.0]];
    wedge.application = Some(application.clone());
    let found = application.outcome(&wedge, &cam, &Analysis::of(&cam, 360)).targets;
    assert!((found[0].theta - found[1].theta).abs() < 1e-9 * whole && found[0].found == found[1].found, "{found:?}");
}

#[test]
fn figures_of_solved_problems_are_those_of_the_notes() {
    let near = |found: f64, told: f64, last_digit: f64| {
        assert!((found - told).abs() <= 0.5 * last_digit * (1.0 + 1e-9), "{found}, told as {told}");
    };
    let value = |name: &str, which: Column, degree: usize| {
        let (design, analysis, _) = report(name);
        column(&design, &analysis, which).expect(name)[degree]
    };
    let speed = |name: &str| example(name).expect(name).omega();
    near(value("R2", Column::V, 120), 0.076394, 1e-6);
    near(value("R2", Column::PressureAngle, 120), 26.24, 0.01);
    near(value("R2", Column::V, 120) * speed("R2"), 0.16, 0.001);
    near(value("R2", Column::RhoPitch, 10), 0.125, 1e-12);
    near(value("R3", Column::V, 330) * speed("R3"), -0.24, 0.001);
    near(value("R3", Column::RhoPitch, 150), 12.1, 1e-9);
    near(value("R4", Column::V, 315), -0.127324, 1e-6);
    near(value("R4", Column::V, 315) * speed("R4"), -0.26667, 1e-5);
    near(value("R4", Column::RhoPitch, 315), 0.18402, 1e-5);
    let (_, _, six) = report("R6");
    let s = six.range(Column::S).expect("s");
    near(s.max, 1.346_893, 1e-6);
    near(s.max_at, 74.39, 0.01);
    let angle = six.range(Column::PressureAngle).expect("φ");
    near(angle.max, 26.57, 0.01);
    near(angle.min, -25.74, 0.01);
    let (_, _, nine) = report("9RT");
    let angle = nine.range(Column::PressureAngle).expect("φ");
    near(angle.min, -28.18, 0.01);
    near(angle.max, 24.68, 0.01);
}

#[test]
fn the_curvature_of_a_cam_with_hollows_has_its_two_sharpest_places_and_its_inflections() {
    let (_, _, nine) = report("9RT");
    let (convex, hollow) = (nine.least_convex.expect("convex"), nine.tightest_hollow.expect("hollow"));
    assert!((convex.value - 11.26).abs() < 0.005 && (hollow.value + 47.53).abs() < 0.005, "{convex:?} {hollow:?}");
    // Two for each of the four hollows, and ρ has no bounds at the first of them.
    assert_eq!(nine.inflections.len(), 8, "{:?}", nine.inflections);
    let rho = nine.range(Column::Rho).expect("ρ");
    assert!(rho.min.is_infinite() && rho.max.is_infinite());
    assert!(nine.inflections.contains(&rho.min_at) && nine.inflections.contains(&rho.max_at), "{rho:?}");
}
