//! Diagrams of known cams stay as they are.

#[path = "../../../tests/support/golden.rs"]
mod golden;

#[path = "../../../tests/support/mod.rs"]
mod support;

use levalab_chart::{Diagram, Quantity, Style, Timing, colour, svg};
use levalab_core::application::Application;
use levalab_core::{Analysis, Cam, Rotation};
use levalab_numbers::write::DecimalSign;
use std::f64::consts::{PI, TAU};
use support::classics::{nine_rt, two_ro};
use support::{follower, lengths};

/// Rows of an analysis, as the page asks for.
const STEPS: usize = 720;

/// Units of the drawing (an eighth of a pixel) by which a place may differ: sines are not the same on all machines.
const TOLERANCE: f64 = 2.01;

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

/// 390 rpm in rad/s.
const R5_SPEED: f64 = 13.0 * PI;

fn style(curve: &str, dash: &[f64]) -> Style {
    let curve = colour(curve).expect("a colour");
    Style { curve, dash: dash.to_vec(), height: 110.0, x_labels: false, ..Style::default() }
}

fn compare(name: &str, quantity: Quantity, cam: &Cam, timing: Timing, style: &Style) {
    check(name, &Diagram::of(quantity, cam, &Analysis::of(cam, STEPS), timing), style);
}

fn check(name: &str, diagram: &Diagram, style: &Style) {
    let (drawn, _) = svg(diagram, style);
    let kept = golden::kept(name, &drawn);
    let ((kept, kept_lines), (drawn, drawn_lines)) = (apart(&kept), apart(&drawn));
    golden::assert_same(name, &kept, &drawn, TOLERANCE);
    for (old, new) in kept_lines.iter().zip(&drawn_lines) {
        assert!(strays(old, new) <= TOLERANCE && strays(new, old) <= TOLERANCE, "{name}: {old:?} has become {new:?}");
    }
}

/// The numbers and the text between them, and the lines, which may be drawn through other points and still be the same.
fn apart(text: &str) -> (Vec<&str>, Vec<Vec<Place>>) {
    let (mut rest, mut lines) = (Vec::new(), Vec::new());
    for (k, part) in text.split("points=\"").enumerate() {
        let (line, after) = if k == 0 { ("", part) } else { part.split_once('"').expect("a quotation ends") };
        let number = |text: &str| text.parse::<f64>().expect("a number");
        let points = line.split_whitespace().filter_map(|point| point.split_once(','));
        lines.push(points.map(|(x, y)| (number(x), number(y))).collect());
        rest.extend(golden::pieces(after));
    }
    (rest, lines)
}

type Place = (f64, f64);

/// The greatest distance of a point of one line from the other line.
fn strays(line: &[Place], other: &[Place]) -> f64 {
    let nearest =
        |&at: &Place| other.windows(2).map(|ends| distance(at, ends[0], ends[1])).fold(f64::INFINITY, f64::min);
    line.iter().map(nearest).fold(0.0, f64::max)
}

/// Distance of a place from a straight piece.
fn distance((x, y): Place, from: Place, to: Place) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let along = ((x - from.0) * dx + (y - from.1) * dy) / (dx * dx + dy * dy).max(f64::MIN_POSITIVE);
    let along = along.clamp(0.0, 1.0);
    (x - from.0 - along * dx).hypot(y - from.1 - along * dy)
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
    let look = Style {
        decimal_sign: DecimalSign::Comma,
        x_labels: true,
        height: 220.0,
        width: 900.0,
        ..style("#00735a", &[9.0, 3.0])
    };
    compare("R1-by-time-v", Quantity::V, &r1(), Timing::PerSecond(TAU), &look);
}

#[test]
fn acceleration_of_r5_jumps() {
    let look = Style { x_labels: true, height: 220.0, width: 900.0, ..style("#b04300", &[4.0, 2.5]) };
    compare("R5-a", Quantity::A, &r5(), Timing::PerRadian, &look);
}

#[test]
fn acceleration_of_r5_by_time_takes_a_power_of_ten() {
    compare("R5-by-time-a", Quantity::A, &r5(), Timing::PerSecond(R5_SPEED), &style("#b04300", &[4.0, 2.5]));
}

#[test]
fn jerk_of_r5_is_nothing() {
    compare("R5-j", Quantity::J, &r5(), Timing::PerSecond(R5_SPEED), &style("#a03678", &[1.5, 2.5]));
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

#[test]
fn contact_on_a_face_with_its_ends() {
    let rows = [("cycloidal", 150.0, 20.0), ("dwell", 60.0, 0.0), ("polynomial-3-4-5", 150.0, -20.0)];
    let cam = Cam::new(lengths(&rows), follower("translating-flat", 40.0, &[], Rotation::CounterClockwise));
    let analysis = Analysis::of(&cam, STEPS);
    let diagram = Diagram::of(Quantity::Contact, &cam, &analysis, Timing::PerRadian).with_face(&analysis, 2.0);
    check("flat-contact", &diagram, &Style { x_labels: true, height: 220.0, ..style("#00735a", &[9.0, 3.0]) });
}

#[test]
fn an_output_with_the_points_that_it_hits_and_misses() {
    let cam = nine_rt();
    let analysis = Analysis::of(&cam, STEPS);
    let pump = Application::by_id("pump").expect("a pump");
    let targets = [(50.0, 2827.43), (140.0, 900.0), (250.0, 0.0)];
    let diagram = Diagram::of_output(&pump.outputs[0], &[9.487, 0.0], &cam, &analysis, 1.0, &targets);
    check("9RT-pump", &diagram, &Style { x_labels: true, height: 220.0, ..style("#006d77", &[]) });
}

#[test]
fn radii_of_two_cams_share_one_plot() {
    let (cam, other) = (nine_rt(), r5());
    let analyses = [Analysis::of(&cam, STEPS), Analysis::of(&other, STEPS)];
    let both = [(&other, &analyses[1], Timing::PerRadian), (&cam, &analyses[0], Timing::PerRadian)];
    let diagram = Diagram::among(Quantity::Rho, &both).expect("two cams");
    let look = style("#5a4bb8", &[6.0, 2.5, 1.5, 2.5, 1.5, 2.5]);
    let others = vec![(colour("#b04300").expect("a colour"), vec![4.0, 2.5])];
    check("9RT-and-R5-rho", &diagram, &Style { x_labels: true, height: 220.0, others, ..look });
}
