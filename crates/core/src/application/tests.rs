//! Claims about applications.

use super::*;
use crate::{Analysis, Follower, Program, Segment};

fn cam(rows: &[(&str, f64, f64)]) -> Cam {
    let segments: Vec<Segment> =
        rows.iter().map(|&(law, beta, rise)| Segment::of(law, beta, rise).expect(law)).collect();
    Cam::new(Program::new(&segments).expect("a program"), Follower::translating_flat(40.0).expect("a follower"))
}

fn output(id: &str, output: &str) -> &'static Output {
    let application = Application::by_id(id).expect(id);
    application.outputs.iter().find(|entry| entry.id == output).expect(output)
}

fn at(s: f64, v: f64) -> Svaj {
    Svaj::new(s, v, 0.0, 0.0)
}

#[test]
fn closed_forms() {
    let close =
        |found: f64, expected: f64| assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{found} {expected}");
    close(output("force", "force").of(&[2.5, 0.0], at(4.0, 9.0), 3.0), 10.0);
    close(output("piston-force", "pressure").of(&[3.0, 2.0], at(5.0, 0.0), 1.0), 3.0 * 4.0 * PI * 5.0);
    close(output("piston-force", "force").of(&[3.0, 2.0], at(5.0, 0.0), 1.0), 3.0 * (4.0 * PI).powi(2) * 5.0);
    close(output("pump", "volume").of(&[2.0, 0.0], at(5.0, 7.0), 3.0), 20.0 * PI);
    close(output("pump", "flow").of(&[2.0, 0.0], at(5.0, 7.0), 3.0), 84.0 * PI);
    // Sources: a flat seat opens like a drum; at 45° π·s·(d + s/2)/√2.
    close(output("valve", "area").of(&[30.0, 0.0], at(8.0, 0.0), 1.0), PI * 30.0 * 8.0);
    close(output("valve", "area").of(&[30.0, PI / 4.0], at(8.0, 0.0), 1.0), PI * 8.0 * (30.0 + 4.0) / 2_f64.sqrt());
}

#[test]
fn the_published_stiffness_of_the_gait_simulator() {
    let figure = &Application::by_id("piston-force").expect("piston").figures[1];
    assert!(((figure.of)(&[30.0, 0.75]) - 93.684).abs() < 5e-4);
}

/// The invariant that extremes are taken from.
#[test]
fn no_output_falls_as_its_argument_rises() {
    for application in APPLICATIONS {
        for output in application.outputs {
            for values in [[1.0, 0.01], [0.5, 1.3], [40.0, PI / 4.0]] {
                let (OutputLaw::OfDisplacement(of) | OutputLaw::OfVelocity(of)) = output.law;
                let value = |k: i32| of(&values, f64::from(k) * 0.5);
                assert!((-100..100).all(|k| value(k) <= value(k + 1)), "{} {}", application.id, output.id);
                assert!(value(0) == 0.0 && value(2) > 0.0, "{} {}", application.id, output.id);
            }
        }
    }
}

#[test]
fn extremes_are_those_of_every_row() {
    let cam = cam(&[("cycloidal", 100.0, 20.0), ("simple-harmonic", 120.0, -8.0), ("polynomial-3-4-5", 140.0, -12.0)]);
    let analysis = Analysis::of(&cam, 36_000);
    for application in APPLICATIONS {
        for output in application.outputs {
            let values = [3.0, 0.5];
            let [(low, low_at), (high, high_at)] = output.extremes(&values, &analysis.summary, 7.0);
            let of = |theta: f64| output.of(&values, cam.program.at(theta), 7.0);
            let rows: Vec<f64> = (0..36_000).map(|k| of(f64::from(k) / 18_000.0 * PI)).collect();
            let (least, most) = rows.iter().fold((rows[0], rows[0]), |(low, high), &row| (low.min(row), high.max(row)));
            let room = 1e-6 * (high - low);
            assert!(low <= least + 1e-9 * room && least - low < room, "{} {low} {least}", output.id);
            assert!(high >= most - 1e-9 * room && high - most < room, "{} {high} {most}", output.id);
            assert!((of(low_at) - low).abs() < room && (of(high_at) - high).abs() < room, "{}", output.id);
        }
    }
}

#[test]
fn a_turn_delivers_every_rise() {
    let volume = output("pump", "volume");
    let two = cam(&[
        ("cycloidal", 90.0, 20.0),
        ("cycloidal", 90.0, -5.0),
        ("parabolic", 90.0, 5.0),
        ("cycloidal", 90.0, -20.0),
    ]);
    let delivered = volume.per_cycle(&[2.0, 0.0], &two).expect("strokes");
    assert!((delivered - 4.0 * PI * 25.0).abs() < 1e-9, "{delivered}");
    assert_eq!(output("pump", "flow").per_cycle(&[1.0, 0.0], &two), None);
}
