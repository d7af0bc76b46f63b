//! Drawings of known cams stay as they are. `UPDATE_GOLDEN=1` draws them anew, to be looked at before they are kept.

#[path = "../../../tests/support/mod.rs"]
mod support;

use levalab_chart::{Diagram, Quantity, Style, Timing, colour, svg};
use levalab_core::{Analysis, Cam, Rotation};
use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};
use support::{Row, degrees, follower, lengths};

/// Rows of an analysis, as the page asks for.
const STEPS: usize = 720;

/// Units of the drawing (an eighth of a pixel) by which a place may differ: sines are not the same on all machines.
const TOLERANCE: f64 = 1.01;

const NINE_RT: [Row; 8] = [
    ("modified-sine", 50.0, 10.0),
    ("dwell", 40.0, 0.0),
    ("cycloidal", 50.0, -10.0),
    ("dwell", 40.0, 0.0),
    ("polynomial-3-4-5", 50.0, 10.0),
    ("dwell", 40.0, 0.0),
    ("polynomial-4-5-6-7", 50.0, -10.0),
    ("dwell", 40.0, 0.0),
];

fn nine_rt() -> Cam {
    Cam::new(
        lengths(&NINE_RT),
        follower("translating-roller", 35.0, &[("roller_radius", 7.0)], Rotation::CounterClockwise),
    )
}

fn r1() -> Cam {
    let rows = [
        ("polynomial-5", 90.0, 0.1),
        ("constant-velocity", 90.0, 0.1),
        ("polynomial-5", 135.0, -0.2),
        ("dwell", 45.0, 0.0),
    ];
    Cam::new(
        lengths(&rows),
        follower("translating-roller", 0.2, &[("roller_radius", 0.01)], Rotation::CounterClockwise),
    )
}

fn r5() -> Cam {
    let rows = [("dwell", 70.0, 0.0), ("parabolic", 100.0, 22.0), ("dwell", 30.0, 0.0), ("parabolic", 160.0, -22.0)];
    Cam::new(
        lengths(&rows),
        follower("translating-roller", 60.0, &[("roller_radius", 10.0)], Rotation::CounterClockwise),
    )
}

fn two_ro() -> Cam {
    let rows = [("polynomial-4-5-6-7", 120.0, 10.0), ("dwell", 120.0, 0.0), ("polynomial-4-5-6-7", 120.0, -10.0)];
    let given = [("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 80.0)];
    Cam::new(degrees(&rows), follower("oscillating-roller", 40.0, &given, Rotation::CounterClockwise))
}

fn style(curve: &str, dash: &[f64]) -> Style {
    let curve = colour(curve).expect("a colour");
    Style { curve, dash: dash.to_vec(), height: 110.0, x_labels: false, ..Style::default() }
}

fn compare(name: &str, quantity: Quantity, cam: &Cam, timing: Timing, style: &Style) {
    let diagram = Diagram::of(quantity, cam, &Analysis::of(cam, STEPS), timing);
    let (drawn, _) = svg(&diagram, style);
    let path = folder().join(format!("{name}.svg"));
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, &drawn).expect("the drawing is kept");
    }
    let kept = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let (kept, drawn) = (pieces(&kept), pieces(&drawn));
    for (k, (old, new)) in kept.iter().zip(&drawn).enumerate() {
        let same = match (old.parse::<f64>(), new.parse::<f64>()) {
            (Ok(old), Ok(new)) => (old - new).abs() <= TOLERANCE,
            _ => old == new,
        };
        let around = drawn[k.saturating_sub(20)..(k + 5).min(drawn.len())].concat();
        assert!(same, "{name}: {old} has become {new} near: {around}");
    }
    assert_eq!(kept.len(), drawn.len(), "{name}: something was added or is missing at the end");
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/golden")
}

/// Numbers, and the text between them.
fn pieces(text: &str) -> Vec<&str> {
    let numeric = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| numeric(c) != numeric(first)).unwrap_or(rest.len());
        pieces.push(&rest[..end]);
        rest = &rest[end..];
    }
    pieces
}

#[test]
fn four_diagrams_of_9rt_stacked() {
    let cam = nine_rt();
    let looks: [(Quantity, &str, &[f64]); 4] = [
        (Quantity::S, "#0068a4", &[]),
        (Quantity::V, "#00735a", &[9.0, 3.0]),
        (Quantity::A, "#b04300", &[4.0, 2.5]),
        (Quantity::J, "#a03678", &[1.5, 2.5]),
    ];
    for (quantity, colour, dash) in looks {
        let last = quantity == Quantity::J;
        let look = style(colour, dash);
        let look = Style { x_labels: last, height: if last { 131.0 } else { 110.0 }, ..look };
        compare(&format!("9RT-{}", quantity.name()), quantity, &cam, Timing::PerRadian, &look);
    }
}

#[test]
fn velocity_of_r1_by_time_with_a_decimal_comma() {
    let look =
        Style { decimal_comma: true, x_labels: true, height: 220.0, width: 900.0, ..style("#00735a", &[9.0, 3.0]) };
    compare("R1-V", Quantity::V, &r1(), Timing::PerSecond(TAU), &look);
}

#[test]
fn acceleration_of_r5_jumps() {
    let look = Style { x_labels: true, height: 220.0, width: 900.0, ..style("#b04300", &[4.0, 2.5]) };
    compare("R5-a", Quantity::A, &r5(), Timing::PerRadian, &look);
}

#[test]
fn jerk_of_r5_is_nothing() {
    compare("R5-j", Quantity::J, &r5(), Timing::PerSecond(40.8407), &style("#a03678", &[1.5, 2.5]));
}

#[test]
fn radius_of_9rt_runs_through_infinity() {
    let look = Style { x_labels: true, height: 220.0, ..style("#5a4bb8", &[6.0, 2.5, 1.5, 2.5, 1.5, 2.5]) };
    compare("9RT-rho", Quantity::Rho, &nine_rt(), Timing::PerRadian, &look);
}

#[test]
fn pressure_angle_of_2ro_stays_within_its_limits() {
    let look = Style { x_labels: true, height: 220.0, ..style("#7d5a00", &[10.0, 3.0, 2.0, 3.0]) };
    compare("2RO-pressure_angle", Quantity::PressureAngle, &two_ro(), Timing::PerRadian, &look);
}
