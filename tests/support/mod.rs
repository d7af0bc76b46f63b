//! What the tests of the core share: cams by their figures, as a book gives them.

// Each test target compiles this module for itself and uses its own part of it.
#![allow(dead_code)]

pub mod classics;
pub mod gallery;
pub mod random;

use levalab_core::{
    Analysis, Cam, Column, Finding, FindingKind, Follower, FollowerKind, Point, Program, Rotation, Segment,
};

/// Both senses of rotation.
pub const ROTATIONS: [Rotation; 2] = [Rotation::CounterClockwise, Rotation::Clockwise];

/// A law, the degrees that it spans and its rise.
pub type Row<'a> = (&'a str, f64, f64);

/// A program whose rises are lengths.
pub fn lengths(rows: &[Row]) -> Program {
    program(rows, 1.0)
}

/// A program whose rises are degrees, for an oscillating follower.
pub fn degrees(rows: &[Row]) -> Program {
    program(rows, 1_f64.to_radians())
}

fn program(rows: &[Row], unit: f64) -> Program {
    let segments: Vec<Segment> =
        rows.iter().map(|&(law, beta, rise)| Segment::of(law, beta, rise * unit).expect(law)).collect();
    Program::new(&segments).expect("a program that closes")
}

/// A follower by its name, with some of its parameters by theirs (angles in radians) and the others at their defaults.
pub fn follower(id: &str, base_radius: f64, given: &[(&str, f64)], rotation: Rotation) -> Follower {
    let kind = FollowerKind::by_id(id).expect(id);
    let mut values = [0.0; 4];
    for (value, parameter) in values.iter_mut().zip(kind.parameters) {
        *value = parameter.default.unwrap_or(0.0);
    }
    for &(key, value) in given {
        values[kind.index_of(key).expect(key)] = value;
    }
    Follower::new(kind, base_radius, &values, rotation).expect("a follower that rests on its base circle")
}

/// A column that must be there.
pub fn column(analysis: &Analysis, column: Column) -> &[f64] {
    analysis.column(column).unwrap_or_else(|| panic!("no column {}", column.name()))
}

/// The profile in the cam's frame, row by row.
pub fn profile(analysis: &Analysis) -> Vec<Point> {
    let (x, y) = (column(analysis, Column::X), column(analysis, Column::Y));
    x.iter().zip(y).map(|(&x, &y)| Point::new(x, y)).collect()
}

/// True for a finding that blames the shape of the cam, not its motion.
pub fn blames_geometry(finding: &Finding) -> bool {
    !matches!(finding.kind, FindingKind::Jump(_) | FindingKind::BelowBase)
}

/// Asserts that the profile can be made and followed, whatever the motion and the pressure angle.
pub fn assert_profile_is_sound(cam: &Cam, name: &str) {
    let findings = Analysis::of(cam, 720).findings;
    let at_fault = findings.iter().find(|f| blames_geometry(f) && f.kind != FindingKind::PressureAngle);
    assert!(at_fault.is_none(), "{name} is not a cam to test with: {at_fault:?}");
}
