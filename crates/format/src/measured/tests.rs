//! Claims about measured data: what is read, what is refused with its line, and how close a reduced table stays.

use super::{Curve, Ends, Measured, MeasuredProblem, measured_ends, reduce};
use crate::limits::MAX_MEASURED_POINTS;
use crate::testing::Random;
use crate::{Design, example};
use std::f64::consts::TAU;

const SIX: [[f64; 2]; 6] = [[0.0, 0.0], [60.0, 5.0], [120.0, 12.0], [180.0, 16.0], [240.0, 9.0], [360.0, 0.0]];

fn measured(text: &str) -> Measured {
    Measured::read(text).unwrap_or_else(|problem| panic!("{problem:?}: {text}"))
}

/// The curve of the columns that are guessed.
fn curve(text: &str) -> Curve {
    let measured = measured(text);
    let [angle, lift] = measured.guess();
    measured.curve(angle, lift).unwrap_or_else(|problem| panic!("{problem:?}: {text}"))
}

fn refusal(text: &str) -> MeasuredProblem {
    let read = Measured::read(text).and_then(|measured| {
        let [angle, lift] = measured.guess();
        measured.curve(angle, lift)
    });
    read.expect_err(text)
}

#[test]
fn a_table_of_a_cam_editor_is_read_past_its_words_and_one_of_a_text_past_its_comments() {
    let editor = include_str!("../../tests/measured/cam-editor.csv");
    assert_eq!(curve(editor).points, SIX);
    assert!(measured(editor).is_plain(), "words in the third column are no choice");
    let commented = include_str!("../../tests/measured/commented.txt");
    assert_eq!(curve(commented).points, SIX);
    assert_eq!(
        curve("theta;s\n0;0\n60;5\n120;12,5\n360;0").points,
        [[0.0, 0.0], [60.0, 5.0], [120.0, 12.5], [360.0, 0.0]]
    );
}

#[test]
fn a_table_in_steps_of_a_degree_is_read_with_its_headings() {
    let text = include_str!("../../tests/measured/degree-by-degree.csv");
    let measured = measured(text);
    let headings: Vec<&str> = measured.columns.iter().map(|column| column.heading.as_str()).collect();
    assert_eq!(headings, ["theta", "s"]);
    let curve = curve(text);
    assert_eq!((curve.points.len(), curve.is_completed), (361, false));
    assert_eq!((curve.points[0], curve.points[90], curve.points[360]), ([0.0, 0.0], [90.0, 8.0], [360.0, 0.0]));
}

#[test]
fn separators_and_decimal_signs_are_those_of_the_text() {
    for text in [
        "0 0\n60 5.5\n360 0",
        "0\t0\n60\t5,5\n360\t0",
        "0;0\n60;5,5\n360;0;",
        "0,0\n60,5.5\n360,0",
        "0, 0\n60, 5.5\n360, 0",
        "0,0 0,0\n60,0 5,5\n360,0 0,0",
        "0 ; 0\r\n60 ; 5.50\r\n360 ; 0\r\n",
        "\"0\";\"0\"\n\"60\";\"5,5\"\n\"360\";\"0\"",
        "0° 0\n60° 5.5\n360° 0",
        "# degrees and millimetres\n0 0 // start\n\n60 5.5\n% a note\n360 0\nEND",
        "0e0 0\n6e1 55e-1\n360 0",
    ] {
        assert_eq!(curve(text).points, [[0.0, 0.0], [60.0, 5.5], [360.0, 0.0]], "{text}");
    }
    assert_eq!(curve("10;\u{2212}1,5\n1 010;2 000,25").points, [[0.0, -1.5], [1000.0, 2000.25]]);
}

#[test]
fn columns_are_chosen_by_their_headings_and_by_what_they_hold() {
    let text = "Test stand 7, 12 March\nSample\tTime [s]\tCrank angle [deg]\tTorque [Nm]\tLift [mm]\n\
                1\t0.00\t0\t1.5\t0\n2\t0.01\t90\t1.7\t5\n3\t0.02\t180\t1.1\t10\n4\t0.03\t360\t1.5\t0\n";
    let stand = measured(text);
    assert_eq!(stand.guess(), [2, 4]);
    let column = &stand.columns[2];
    assert_eq!((column.heading.as_str(), column.unit.as_str()), ("Crank angle", "deg"));
    assert!(!stand.is_plain());
    assert_eq!(stand.curve(2, 4).expect("a curve").points, [[0.0, 0.0], [90.0, 5.0], [180.0, 10.0], [360.0, 0.0]]);
    assert_eq!(stand.curve(2, 3).expect("another").points[1], [90.0, 1.7]);
    assert_eq!(stand.curve(2, 2), Err(MeasuredProblem::Columns));
    assert_eq!(stand.curve(2, 5), Err(MeasuredProblem::Columns));

    let nameless = measured("1 0 7 0\n2 120 7 5\n3 240 7 4\n4 360 7 0");
    assert_eq!(nameless.guess(), [1, 3], "neither what is counted nor what is constant");
    let units = measured("# theta;s\n# deg;mm\n0;0\n90;1\n360;0");
    assert_eq!((units.columns[1].heading.as_str(), units.columns[1].unit.as_str()), ("s", "mm"));
}

#[test]
fn what_cannot_be_read_is_named_by_its_line() {
    assert_eq!(refusal("0 0\n60 five5\n360 0"), MeasuredProblem::NotNumbers { line: 2 });
    assert_eq!(refusal("\nnothing but words\nhere"), MeasuredProblem::NotNumbers { line: 2 }, "it is no empty table");
    assert_eq!(refusal("0;0;1\n60;x5;1\n\n120;3;1\n360;0;1"), MeasuredProblem::NoValue { line: 2, column: 2 });
    assert_eq!(
        refusal("a;b\n0;0\n60;5\n50;6\n360;0"),
        MeasuredProblem::Unordered { line: 4, found: 50.0, before: 60.0 }
    );
    assert_eq!(
        refusal("a;b\n0;0\n60;5\n60;5\n360;0"),
        MeasuredProblem::Unordered { line: 4, found: 60.0, before: 60.0 }
    );
    assert_eq!(refusal("0 0\n90 5 5\n180 10"), MeasuredProblem::NotNumbers { line: 2 }, "5.5 may be meant");
    assert_eq!(refusal("0 0"), MeasuredProblem::TooFewPoints { found: 1 });
    assert!(measured(" \n").is_empty());
    let many: String = (0..=MAX_MEASURED_POINTS).map(|k| format!("{k} 0\n")).collect();
    assert_eq!(
        refusal(&many),
        MeasuredProblem::TooManyPoints { found: MAX_MEASURED_POINTS + 1, limit: MAX_MEASURED_POINTS }
    );
    assert!(matches!(refusal(&"0 0\n".repeat(1 << 19)), MeasuredProblem::TooLarge { .. }));
}

#[test]
fn pairs_stand_in_any_order() {
    assert_eq!(measured("at\tforce\n50\t25\n20,5\t24,5").pairs(), Ok(vec![[50.0, 25.0], [20.5, 24.5]]));
    assert_eq!(measured("50 25").pairs(), Ok(vec![[50.0, 25.0]]));
    assert_eq!(measured("").pairs(), Ok(Vec::new()));
    assert_eq!(Measured::read("50\t25\n70,5\tx").err(), Some(MeasuredProblem::NotNumbers { line: 2 }));
}

#[test]
fn the_end_of_a_turn_is_its_beginning() {
    let without: String = (0..360).map(|k| format!("{k} {}\n", k % 7)).collect();
    let whole = curve(&without);
    assert_eq!((whole.points.len(), whole.is_completed), (360, false), "only when asked for");
    let completed = whole.completed();
    assert_eq!((completed.points.len(), completed.is_completed), (361, true));
    assert_eq!(completed.points[360], [360.0, 0.0]);
    let wrapped = curve(&format!("{without}0 0\n"));
    assert_eq!((wrapped.points, wrapped.is_completed), (completed.points, false));
    for part in ["0 0\n10 1\n20 2\n180 3", "0 0\n60 1\n120 2\n180 3\n240 2\n300 1"] {
        assert_eq!(curve(part).completed(), curve(part), "a part of a turn stays one");
    }
}

#[test]
fn angles_begin_at_zero_and_radians_become_degrees() {
    let text: String = (0..=8).map(|k| format!("{};{}\n", f64::from(k) * TAU / 8.0, k % 8)).collect();
    let curve = curve(&format!("angle [rad];lift\n{text}"));
    assert!(curve.is_in_radians);
    assert_eq!(curve.points[1], [45.0, 1.0]);
    assert_eq!(curve.points[8], [360.0, 0.0]);
    let shifted = super::tests::curve("100.5 0\n160.5 5\n220.5 0");
    assert_eq!((shifted.first, shifted.points.as_slice()), (100.5, [[0.0, 0.0], [60.0, 5.0], [120.0, 0.0]].as_slice()));
}

#[test]
fn bytes_are_read_in_the_encodings_of_test_stands() {
    let text = "\u{e1}ngulo;s\n0;0\n60;5,5\n360;0";
    let wide = |bytes: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(bytes).collect::<Vec<u8>>();
    let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
    for bytes in [
        text.as_bytes().to_vec(),
        [b"\xef\xbb\xbf".as_slice(), text.as_bytes()].concat(),
        latin,
        [b"\xff\xfe".as_slice(), &wide(u16::to_le_bytes)].concat(),
        [b"\xfe\xff".as_slice(), &wide(u16::to_be_bytes)].concat(),
    ] {
        let read = Measured::read_bytes(&bytes).expect("text");
        assert_eq!((read.len(), read.columns[0].heading.as_str()), (3, "\u{e1}ngulo"), "{bytes:?}");
    }
}

/// What the spline of a table misses the points by, found by the program of a design.
fn worst_of(design: &Design, segment: usize, points: &[[f64; 2]]) -> f64 {
    let cam = design.cam().expect("a cam");
    let start = cam.program.borders()[segment];
    let miss = |&[at, s]: &[f64; 2]| (cam.program.at(start + at.to_radians()).s - s).abs();
    // The end of the last segment is the beginning of the turn.
    points[..points.len() - 1].iter().map(miss).fold(0.0, f64::max)
}

fn with_table(points: &[[f64; 2]]) -> Design {
    let mut value = example("9RT").expect("9RT").to_value();
    value["segments"] = serde_json::json!([{ "law": "table", "beta": 360, "points": points }]);
    Design::from_value(&value).expect("a design")
}

#[test]
fn the_residual_that_is_said_is_that_of_the_cam() {
    let points = curve(include_str!("../../tests/measured/degree-by-degree.csv")).points;
    for count in [6, 13, 24, 60] {
        let reduced = reduce(&points, Ends::Joined, count, 0.0);
        assert_eq!(reduced.points.len(), count);
        let design = with_table(&reduced.points);
        assert_eq!(measured_ends(&design, 0), Ends::Joined);
        let worst = worst_of(&design, 0, &points);
        assert!((worst - reduced.residual.abs()).abs() < 1e-9, "{count}: {worst} and {}", reduced.residual);
        assert!(points.iter().any(|point| point[0] == reduced.at));
    }
}

#[test]
fn more_points_come_closer_and_all_of_them_go_through() {
    let points = curve(include_str!("../../tests/measured/degree-by-degree.csv")).points;
    let mut before = f64::INFINITY;
    for (count, limit) in [(6, 0.5), (13, 0.002), (24, 2e-4)] {
        let residual = reduce(&points, Ends::Joined, count, 0.0).residual.abs();
        assert!(residual < limit && residual < before, "{count} points leave {residual}");
        before = residual;
    }
    for count in [361, 9999] {
        let all = reduce(&points, Ends::Joined, count, 0.0);
        assert!(all.points == points && all.residual.abs() < 1e-12);
    }
}

#[test]
fn a_residual_is_reached_with_few_points() {
    let mut random = Random::new(8);
    let noise = 0.002;
    let point = |k: u32| {
        let at = 360.0 * f64::from(k) / 8191.0;
        let s = 12.5 * (1.0 - at.to_radians().cos()) + random.between(-noise, noise);
        [at, if k.is_multiple_of(8191) { 0.0 } else { s }]
    };
    let points: Vec<[f64; 2]> = (0..8192).map(point).collect();
    let reduced = reduce(&points, Ends::Joined, 1024, 3.0 * noise);
    assert!(reduced.residual.abs() <= 3.0 * noise, "{}", reduced.residual);
    assert!(reduced.points.len() <= 40, "{} points", reduced.points.len());
}

#[test]
fn a_table_between_dwells_is_reduced_as_it_is_joined() {
    let rise = |at: f64| 10.0 * (at / 120.0 - (TAU * at / 120.0).sin() / TAU);
    let points: Vec<[f64; 2]> =
        (0..=240).map(|k| 0.5 * f64::from(k)).map(|at| [at, (rise(at) * 1e4).round() / 1e4]).collect();
    let design = |points: &[[f64; 2]]| {
        let mut value = example("9RT").expect("9RT").to_value();
        value["segments"] = serde_json::json!([
            { "law": "dwell", "beta": 60 },
            { "law": "table", "beta": 120, "points": points },
            { "law": "dwell", "beta": 60 },
            { "law": "cycloidal", "beta": 120, "rise": -10 },
        ]);
        Design::from_value(&value).expect("a design")
    };
    let before = design(&[[0.0, 0.0], [120.0, 10.0]]);
    let ends = measured_ends(&before, 1);
    assert!(matches!(ends, Ends::Held(Some(_), Some(_))), "{ends:?}");
    let reduced = reduce(&points, ends, 12, 0.0);
    let worst = worst_of(&design(&reduced.points), 1, &points[..240]);
    assert!((worst - reduced.residual.abs()).abs() < 1e-9 && worst < 0.01, "{worst} and {}", reduced.residual);
}

#[test]
fn any_text_is_read_or_refused_and_every_reduction_has_an_answer() {
    let mut random = Random::new(77);
    let parts = [
        "0", "1.5", "12,5", "-3", "1e3", ";", "\t", ",", " ", "\n", "\r\n", "#", "//", "x", "θ", "\"", "360", ".", "°",
        "1e999", "'",
    ];
    let mut curves = 0;
    for _ in 0..20_000 {
        let text: String = (0..random.below(40)).map(|_| *random.pick(&parts)).collect();
        let Ok(measured) = Measured::read(&text) else { continue };
        for (angle, lift) in [(0, 1), (1, 0), (0, 2)] {
            let Ok(curve) = measured.curve(angle, lift) else { continue };
            curves += 1;
            let count = 2 + random.below(5);
            let reduced = reduce(&curve.points, Ends::Free, count, 0.0);
            assert!(reduced.points.len() <= curve.points.len() && !reduced.residual.is_nan(), "{text}");
        }
    }
    assert!(curves > 30, "{curves}");
}
