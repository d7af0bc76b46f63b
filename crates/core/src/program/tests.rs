//! Programs that join, and what cannot be one.

use super::*;
use crate::ProgramProblem;

fn program(rows: &[(&str, f64, f64)]) -> Result<Program, ProgramError> {
    let segments: Vec<Segment> = rows.iter().filter_map(|&(id, beta, rise)| Segment::of(id, beta, rise)).collect();
    assert_eq!(segments.len(), rows.len(), "a law's name is misspelt");
    Program::new(&segments)
}

fn refusal(rows: &[(&str, f64, f64)]) -> (usize, ProgramProblem) {
    let error = program(rows).expect_err("this cannot be a program");
    (error.segment, error.problem)
}

#[test]
fn a_joint_belongs_to_the_segment_on_its_right() {
    let program =
        program(&[("constant-velocity", 90.0, 1.0), ("dwell", 90.0, 0.0), ("cycloidal", 180.0, -1.0)]).expect("joined");
    let slope = 1.0 / 90_f64.to_radians();
    assert!((program.at(0.0).v - slope).abs() < 1e-15);
    assert!((program.at(TAU).v - slope).abs() < 1e-15 && (program.at(-1e-13).v - slope).abs() < 1e-15);
    assert!(program.at(90_f64.to_radians()).v.abs() < 1e-15);
    assert!((program.at(90_f64.to_radians() - 1e-9).v - slope).abs() < 1e-15);
}

#[test]
fn what_cannot_be_a_program_is_refused_at_its_segment() {
    assert_eq!(refusal(&[]), (0, ProgramProblem::Count { found: 0 }));
    let (segment, problem) = refusal(&[("cycloidal", 180.0, 10.0), ("cycloidal", 170.0, -10.0)]);
    assert!(segment == 1 && matches!(problem, ProgramProblem::Turn { .. }));
    let (segment, problem) = refusal(&[("cycloidal", 180.0, 10.0), ("cycloidal", 180.0, -9.0)]);
    assert!(segment == 1 && matches!(problem, ProgramProblem::Closing { .. }));
    let (segment, problem) = refusal(&[("cycloidal", 180.0, -10.0), ("cycloidal", 180.0, 10.0)]);
    assert!(segment == 0 && matches!(problem, ProgramProblem::BelowBase { .. }));
    let (segment, problem) = refusal(&[("dwell", 180.0, 1.0), ("cycloidal", 180.0, -1.0)]);
    assert!(segment == 0 && matches!(problem, ProgramProblem::DwellRises { .. }));
    let (segment, problem) =
        refusal(&[("polynomial-5", 180.0, 1.0), ("dwell", 90.0, 0.0), ("polynomial-7", 90.0, -1.0)]);
    assert_eq!((segment, problem), (2, ProgramProblem::AdjacentPolynomials { next: 0 }), "neighbours across 0°");
}

#[test]
fn a_generic_polynomial_takes_what_its_neighbours_have() {
    let rows = [("constant-velocity", 90.0, 1.0), ("polynomial-7", 90.0, 0.5), ("simple-harmonic", 180.0, -1.5)];
    let program = program(&rows).expect("joined");
    let joints = program.classified_joints();
    assert_eq!(joints[1].jump, None, "constant velocity to polynomial");
    assert_eq!(joints[2].jump, None, "polynomial to harmonic");
    assert_eq!(joints[0].jump, Some(1), "harmonic to constant velocity");
}

#[test]
fn jumps_are_named_by_their_lowest_order() {
    let between_dwells = |id: &str| {
        let rows = [("dwell", 90.0, 0.0), (id, 90.0, 1.0), ("dwell", 90.0, 0.0), (id, 90.0, -1.0)];
        program(&rows).expect("joined").classified_joints().iter().filter_map(|joint| joint.jump).min()
    };
    assert_eq!(between_dwells("constant-velocity"), Some(1));
    assert_eq!(between_dwells("simple-harmonic"), Some(2));
    assert_eq!(between_dwells("cycloidal"), Some(3));
    assert_eq!(between_dwells("polynomial-4-5-6-7"), None);
}
