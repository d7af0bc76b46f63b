//! The program: sums as they are on paper, and segments that cannot stand together.

use crate::check;
use levalab_format::limits::MAX_SEGMENTS;
use levalab_format::{Design, Measure, Problem, ProgramRefusal, example};
use serde_json::json;

#[test]
fn sums_are_those_of_the_decimals() {
    check("/segments/1/beta", json!(41), "segments", |problem| {
        *problem == Problem::Program(ProgramRefusal::Turn { found: 361.0, whole: 360.0, measure: Measure::Degrees })
    });
    check("/segments/1/beta", json!(40.000_000_002), "segments", |problem| {
        matches!(problem, Problem::Program(ProgramRefusal::Turn { .. }))
    });
    check("/segments/6/rise", json!(-9), "segments", |problem| {
        *problem == Problem::Program(ProgramRefusal::Closing { found: 1.0, measure: Measure::Length })
    });
    check("/segments/2/rise", json!(-11), "segments[2].rise", |problem| {
        *problem == Problem::Program(ProgramRefusal::BelowBase { found: -1.0, measure: Measure::Length })
    });
    let within = |place: &str, value: f64| {
        let mut design = example("9RT").expect("9RT").to_value();
        *design.pointer_mut(place).expect(place) = json!(value);
        Design::from_value(&design).expect(place)
    };
    within("/segments/1/beta", 40.000_000_001);
    // What is missing within the tolerance makes no jump: the last return takes it.
    let cam = within("/segments/6/rise", -9.999_999_999_1).cam().expect("cam");
    assert!(cam.program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| order == 3)));
}

#[test]
fn tenths_of_large_lifts_close_as_on_paper() {
    let mut design = example("9RT").expect("9RT");
    design.base_radius = 1e6;
    let first = design.segments[0].clone();
    let rises = (0..64).map(|k| if k < 48 { 333_333.3 } else { -999_999.9 });
    let segment = |rise| levalab_format::SegmentDesign { beta: 5.625, rise, ..first.clone() };
    design.segments = rises.map(segment).collect();
    assert_eq!(Design::from_json(&design.to_json()), Ok(design));
}

#[test]
fn programs_that_cannot_be_are_placed() {
    check("/segments", json!([]), "segments", |problem| *problem == Problem::Program(ProgramRefusal::NoSegments));
    let many = vec![json!({"law": "dwell", "beta": 5.625}); MAX_SEGMENTS + 1];
    check("/segments", json!(many), "segments", |problem| {
        matches!(problem, Problem::Program(ProgramRefusal::TooManySegments { found: 65, .. }))
    });
    check("/segments/1/rise", json!(1), "segments[1].rise", |problem| {
        matches!(problem, Problem::Program(ProgramRefusal::DwellRises { .. }))
    });
    let free = |beta: f64, rise: f64| json!({"law": "polynomial-5", "beta": beta, "rise": rise});
    check("/segments", json!([free(180.0, 1.0), free(180.0, -1.0)]), "segments[0].law", |problem| {
        *problem == Problem::Program(ProgramRefusal::AdjacentPolynomials { next: 1 })
    });
    let raised = json!([{"law": "formula", "beta": 360, "expression": "5+5sin(2πx)"}]);
    check("/segments", raised, "segments[0]", |problem| {
        *problem == Problem::Program(ProgramRefusal::Beginning { found: 5.0, measure: Measure::Length })
    });
    let scca = json!([{"law": "scca", "beta": 180, "rise": 9, "b": 0.5, "c": 0.7}, {"law": "scca", "beta": 180, "rise": -9, "b": 0.5, "c": 0.2}]);
    check("/segments", scca, "segments[0].c", |problem| {
        *problem == Problem::OutOfRange { found: 0.7, min: 0.0, max: 0.5, measure: Measure::Ratio }
    });
}

#[test]
fn a_crossover_at_an_end_is_placed() {
    let skewed = json!({"law": "skewed-scca", "beta": 50, "rise": 10, "b": 0.25, "c": 0.5, "crossover": 0.99});
    check("/segments/0", skewed, "segments[0].crossover", |problem| {
        *problem == Problem::OutOfRange { found: 0.99, min: 0.05, max: 0.95, measure: Measure::Ratio }
    });
}
