//! What a design file may not say, and where each refusal points.

use levalab_core::{ExpressionFault, Misfit};
use levalab_format::limits::{MAX_FILE_BYTES, MAX_SEGMENTS};
use levalab_format::{CamRefusal, DataRefusal, Design, DesignError, Kind, Measure, Problem, ProgramRefusal, example};
use serde_json::{Value, json};

/// Example 9RT with one place changed; `null` as a value takes the field out.
fn refusal(place: &str, value: Value) -> DesignError {
    refusal_of("9RT", place, value)
}

fn refusal_of(name: &str, place: &str, value: Value) -> DesignError {
    let mut design = example(name).expect(name).to_value();
    let (parent, last) = place.rsplit_once('/').expect("a pointer");
    let parent = design.pointer_mut(parent).expect(place);
    match (parent, value) {
        (Value::Object(fields), Value::Null) => drop(fields.remove(last)),
        (Value::Object(fields), value) => drop(fields.insert(last.to_owned(), value)),
        (Value::Array(items), value) => items[last.parse::<usize>().expect("an index")] = value,
        _ => panic!("{place}"),
    }
    Design::from_value(&design).expect_err(place)
}

fn check(place: &str, value: Value, path: &str, expected: impl Fn(&Problem) -> bool) {
    let error = refusal(place, value);
    assert_eq!(error.path.to_string(), path, "{error}");
    assert!(expected(&error.problem), "{error}");
}

#[test]
fn a_missing_field_is_named() {
    for (place, path) in [
        ("/format", "format"),
        ("/cam", "cam"),
        ("/cam/kind", "cam.kind"),
        ("/cam/base_radius", "cam.base_radius"),
        ("/speed/value", "speed.value"),
        ("/speed/unit", "speed.unit"),
        ("/follower", "follower"),
        ("/follower/motion", "follower.motion"),
        ("/follower/contact", "follower.contact"),
        ("/follower/roller_radius", "follower.roller_radius"),
        ("/segments", "segments"),
        ("/segments/2/law", "segments[2].law"),
        ("/segments/2/beta", "segments[2].beta"),
        ("/segments/2/rise", "segments[2].rise"),
    ] {
        check(place, Value::Null, path, |problem| *problem == Problem::Missing);
    }
}

#[test]
fn what_has_a_usual_value_may_be_left_out() {
    let mut value = example("9RT").expect("9RT").to_value();
    for field in ["title", "length_unit", "speed"] {
        value.as_object_mut().expect("object").remove(field);
    }
    value["cam"].as_object_mut().expect("cam").remove("rotation");
    value["follower"].as_object_mut().expect("follower").remove("eccentricity");
    let expected = Design { title: String::new(), ..example("9RT").expect("9RT") };
    assert_eq!(Design::from_value(&value), Ok(expected));
}

#[test]
fn a_field_without_meaning_is_named_with_those_that_have_one() {
    for (place, path) in [
        ("/colour", "colour"),
        ("/cam/breadth", "cam.breadth"),
        ("/speed/units", "speed.units"),
        ("/follower/arm", "follower.arm"),
        ("/segments/1/b", "segments[1].b"),
    ] {
        check(place, json!(1), path, |problem| matches!(problem, Problem::UnknownField { .. }));
    }
    let Problem::UnknownField { expected } = refusal("/follower/arm", json!(1)).problem else { panic!("unknown") };
    assert_eq!(expected, ["motion", "contact", "roller_radius", "eccentricity"]);
}

#[test]
fn a_value_of_another_kind_is_told_with_the_kind_needed() {
    let wrong = |found, expected| move |problem: &Problem| *problem == Problem::WrongKind { found, expected };
    check("/title", json!(3), "title", wrong(Kind::Number, Kind::Text));
    check("/cam", json!([]), "cam", wrong(Kind::List, Kind::Object));
    check("/cam/base_radius", json!("35"), "cam.base_radius", wrong(Kind::Text, Kind::Number));
    check("/segments", json!({}), "segments", wrong(Kind::Object, Kind::List));
    check("/segments/0", json!(true), "segments[0]", wrong(Kind::Boolean, Kind::Object));
    check("/segments/0/beta", json!({}), "segments[0].beta", wrong(Kind::Object, Kind::Number));
    let null = Design::from_value(&Value::Null).expect_err("null");
    assert_eq!(
        (null.path.to_string().as_str(), null.problem),
        ("", Problem::WrongKind { found: Kind::Null, expected: Kind::Object })
    );
}

#[test]
fn a_word_that_is_no_choice_is_told_with_the_choices() {
    for (place, value, path) in [
        ("/format", "levalab/2", "format"),
        ("/length_unit", "ft", "length_unit"),
        ("/speed/unit", "Hz", "speed.unit"),
        ("/cam/kind", "conical", "cam.kind"),
        ("/cam/rotation", "left", "cam.rotation"),
        ("/follower/motion", "rotating", "follower.motion"),
        ("/follower/contact", "Roller", "follower.contact"),
        ("/segments/0/law", "cicloidal", "segments[0].law"),
    ] {
        let told = |problem: &Problem| matches!(problem, Problem::WrongWord { found, expected } if found == value && !expected.is_empty());
        check(place, json!(value), path, told);
    }
    let knife = refusal_of("2RO", "/follower/contact", json!("knife")).problem;
    assert_eq!(knife, Problem::WrongWord { found: "knife".to_owned(), expected: vec!["roller", "flat"] });
}

#[test]
fn numbers_out_of_range_are_told_with_the_range() {
    let out = |problem: &Problem| matches!(problem, Problem::OutOfRange { .. });
    let not_positive = |problem: &Problem| matches!(problem, Problem::NotPositive { .. });
    check("/cam/base_radius", json!(0), "cam.base_radius", not_positive);
    check("/cam/base_radius", json!(-35), "cam.base_radius", not_positive);
    check("/cam/base_radius", json!(1e7), "cam.base_radius", out);
    check("/cam/base_radius", json!(1e-7), "cam.base_radius", out);
    check("/follower/roller_radius", json!(0), "follower.roller_radius", not_positive);
    check("/speed/value", json!(0), "speed.value", not_positive);
    check("/speed/value", json!(1e10), "speed.value", out);
    check("/segments/0/beta", json!(0), "segments[0].beta", not_positive);
    check("/segments/0/beta", json!(361), "segments[0].beta", out);
    check("/segments/0/rise", json!(2e6), "segments[0].rise", out);
    let swing = refusal_of("2RO", "/segments/0/rise", json!(181)).problem;
    assert_eq!(swing, Problem::OutOfRange { found: 181.0, min: -180.0, max: 180.0, measure: Measure::Degrees });
}

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
    let scca = json!([{"law": "scca", "beta": 180, "rise": 9, "b": 0.5, "c": 0.7}, {"law": "scca", "beta": 180, "rise": -9, "b": 0.5, "c": 0.2}]);
    check("/segments", scca, "segments[0].c", |problem| {
        *problem == Problem::OutOfRange { found: 0.7, min: 0.0, max: 0.5, measure: Measure::Ratio }
    });
}

/// Example 9RT with its first segment, of 50° from 0 to 10 mm, made from data.
fn check_data(segment: Value, path: &str, expected: impl Fn(&DataRefusal) -> bool) {
    let error = refusal("/segments/0", segment);
    assert_eq!(error.path.to_string(), path, "{error}");
    assert!(matches!(&error.problem, Problem::Data(refusal) if expected(refusal)), "{error}");
}

/// A spline of the fifth degree at rest at both ends, through a point for each place given.
fn spline(places: &[f64]) -> Value {
    let end = |at: f64, s: f64| {
        (0..3).map(move |order| json!({"at": at, "order": order, "value": if order == 0 { s } else { 0.0 }}))
    };
    let inner = places.iter().map(|&at| json!({"at": at, "order": 0, "value": at / 5.0}));
    let conditions: Vec<Value> = end(0.0, 0.0).chain(inner).chain(end(50.0, 10.0)).collect();
    json!({"law": "bspline", "beta": 50, "degree": 5, "conditions": conditions})
}

#[test]
fn conditions_that_make_no_curve_are_placed() {
    let with = |conditions: Value| json!({"law": "polynomial", "beta": 50, "conditions": conditions});
    let s = |at: f64, value: f64| json!({"at": at, "order": 0, "value": value});
    check_data(with(json!([])), "segments[0].conditions", |refusal| {
        *refusal == DataRefusal::WrongCount { found: 0, min: 1, max: 24 }
    });
    check_data(
        with(json!([s(0.0, 0.0), {"at": 50, "order": 1.5, "value": 0}])),
        "segments[0].conditions[1].order",
        |refusal| *refusal == DataRefusal::WrongOrder { found: 1.5 },
    );
    check_data(with(json!([s(0.0, 0.0), s(50.0, 10.0), s(0.0, 0.0)])), "segments[0].conditions[2]", |refusal| {
        *refusal == DataRefusal::Repeated { other: 0 }
    });
    check_data(with(json!([{"at": 0, "order": 1, "value": 0}])), "segments[0].conditions", |refusal| {
        *refusal == DataRefusal::NoHeight
    });
    let birkhoff = json!([s(0.0, 0.0), {"at": 25, "order": 1, "value": 9}, s(50.0, 10.0)]);
    check_data(with(birkhoff), "segments[0].conditions", |refusal| {
        *refusal == DataRefusal::Dependent { items: vec![0, 1, 2] }
    });
    check("/segments/0", with(json!([s(0.0, 0.0), s(51.0, 10.0)])), "segments[0].conditions[1].at", |problem| {
        *problem == Problem::OutOfRange { found: 51.0, min: 0.0, max: 50.0, measure: Measure::Degrees }
    });
    check("/segments/0", with(json!([{"at": 0, "value": 0}])), "segments[0].conditions[0].order", |problem| {
        *problem == Problem::Missing
    });
    let told = json!({"law": "polynomial", "beta": 50, "rise": 9, "conditions": [s(0.0, 0.0), s(50.0, 10.0)]});
    check_data(told, "segments[0].rise", |refusal| {
        matches!(refusal, DataRefusal::RiseDisagrees { found: 9.0, expected: 10.0, .. })
    });
}

#[test]
fn knots_that_make_no_spline_are_placed() {
    let with = |places: &[f64], knots: Value| {
        let mut segment = spline(places);
        segment["knots"] = knots;
        segment
    };
    check_data(with(&[20.0, 30.0], json!([25])), "segments[0].knots", |refusal| {
        *refusal == DataRefusal::KnotCount { found: 1, expected: 2 }
    });
    for (knots, path) in [([30, 30], "[1]"), ([0, 30], "[0]"), ([20, 50], "[1]"), ([30, 20], "[1]")] {
        check_data(with(&[20.0, 30.0], json!(knots)), &format!("segments[0].knots{path}"), |refusal| {
            *refusal == DataRefusal::KnotOrder
        });
    }
    let places: Vec<f64> = (1..10).map(|k| 5.0 * f64::from(k)).collect();
    let late: Vec<f64> = (0..9).map(|k| 48.0 + 0.1 * f64::from(k)).collect();
    check_data(with(&places, json!(late)), "segments[0].knots", |refusal| {
        matches!(refusal, DataRefusal::KnotPlace { item: 6, measure: Measure::Degrees, .. })
    });
    check("/segments/0", with(&[20.0, 30.0], json!("25")), "segments[0].knots", |problem| {
        *problem == Problem::WrongKind { found: Kind::Text, expected: Kind::List }
    });
    let polynomial =
        json!({"law": "polynomial", "beta": 50, "conditions": [{"at": 0, "order": 0, "value": 0}], "knots": [25]});
    check("/segments/0", polynomial, "segments[0].knots", |problem| matches!(problem, Problem::UnknownField { .. }));
    let mut degree = spline(&[20.0]);
    degree["degree"] = json!(9);
    check("/segments/0", degree, "segments[0].degree", |problem| {
        *problem == Problem::OutOfRange { found: 9.0, min: 4.0, max: 8.0, measure: Measure::Ratio }
    });
}

#[test]
fn tables_ordinates_and_formulas_that_make_no_curve_are_placed() {
    let table = |points: Value| json!({"law": "table", "beta": 50, "points": points});
    check_data(table(json!([[0, 0], [49, 10]])), "segments[0].points[1][0]", |refusal| {
        *refusal == DataRefusal::NotAtEnd { found: 49.0, expected: 50.0, measure: Measure::Degrees }
    });
    check_data(table(json!([[0, 0], [30, 4], [20, 5], [50, 10]])), "segments[0].points[2][0]", |refusal| {
        *refusal == DataRefusal::Unordered
    });
    check_data(table(json!([[0, 0], [50]])), "segments[0].points[1]", |refusal| {
        *refusal == DataRefusal::WrongCount { found: 1, min: 2, max: 2 }
    });
    let mut rough = table(json!([[0, 0], [25, 5], [50, 10]]));
    rough["smoothing"] = json!(-0.1);
    check("/segments/0", rough, "segments[0].smoothing", |problem| {
        *problem == Problem::OutOfRange { found: -0.1, min: 0.0, max: 1e6, measure: Measure::Length }
    });
    check_data(json!({"law": "bezier", "beta": 50, "ordinates": [10]}), "segments[0].ordinates", |refusal| {
        *refusal == DataRefusal::WrongCount { found: 1, min: 2, max: 25 }
    });
    let formula = |text: &str| json!({"law": "formula", "beta": 50, "expression": text});
    check_data(
        formula("10 x^2 +"),
        "segments[0].expression",
        |refusal| matches!(refusal, DataRefusal::Expression(problem) if problem.at == 8 && problem.kind == ExpressionFault::Ends),
    );
    check_data(formula("10 sqrt(x)"), "segments[0].expression", |refusal| {
        matches!(refusal, DataRefusal::Undefined { .. })
    });
    check("/segments/0", formula("L x"), "segments[0].rise", |problem| *problem == Problem::Missing);
}

#[test]
fn a_crossover_at_an_end_is_placed() {
    let skewed = json!({"law": "skewed-scca", "beta": 50, "rise": 10, "b": 0.25, "c": 0.5, "crossover": 0.99});
    check("/segments/0", skewed, "segments[0].crossover", |problem| {
        *problem == Problem::OutOfRange { found: 0.99, min: 0.05, max: 0.95, measure: Measure::Ratio }
    });
}

#[test]
fn geometry_that_cannot_be_is_placed() {
    check("/follower/eccentricity", json!(42), "follower.eccentricity", |problem| {
        *problem == Problem::Misfit(Misfit::Eccentricity { eccentricity: 42.0, prime_radius: 42.0 })
    });
    let place = |name: &str, place: &str, value: f64| {
        let error = refusal_of(name, place, json!(value));
        (error.path.to_string(), error.problem)
    };
    let (path, problem) = place("2RO", "/follower/pivot_distance", 200.0);
    assert_eq!(path, "follower.pivot_distance");
    assert_eq!(problem, Problem::Misfit(Misfit::Triangle { pivot_distance: 200.0, arm: 80.0, prime_radius: 50.0 }));
    let (path, problem) = place("4PO", "/follower/pivot_distance", 30.0);
    assert_eq!(
        (path.as_str(), problem),
        ("follower.pivot_distance", Problem::Misfit(Misfit::FaceOutOfReach { pivot_distance: 30.0, needed: 40.0 }))
    );
    let (path, problem) = place("10EX", "/follower/face_angle", 90.0);
    assert_eq!(path, "follower.face_angle");
    assert_eq!(problem, Problem::NotBetween { found: 90.0, min: -90.0, max: 90.0, measure: Measure::Degrees });
}

#[test]
fn applications_that_cannot_be_are_placed() {
    let at = |place: &str, value: Value| {
        let error = refusal_of("R6", &format!("/application{place}"), value);
        (error.path.to_string(), error.problem)
    };
    let path = |place: &str, value: Value| at(place, value).0;
    assert_eq!(at("/kind", Value::Null), ("application.kind".to_owned(), Problem::Missing));
    let (place, problem) = at("/kind", json!("brake"));
    assert_eq!(place, "application.kind");
    assert!(matches!(problem, Problem::WrongWord { expected, .. } if expected.contains(&"pump")));
    assert_eq!(at("/piston_radius", Value::Null), ("application.piston_radius".to_owned(), Problem::Missing));
    let (place, problem) = at("/piston_radius", json!(0));
    assert_eq!(place, "application.piston_radius");
    assert_eq!(problem, Problem::NotPositive { found: 0.0, measure: Measure::Length });
    assert_eq!(path("/pressure_per_volume", json!(1e13)), "application.pressure_per_volume");
    assert!(matches!(at("/seat_angle", json!(45)).1, Problem::UnknownField { .. }));
    assert!(matches!(at("/output", json!("volume")).1, Problem::WrongWord { .. }));
    assert!(matches!(at("/by", json!("days")).1, Problem::WrongWord { .. }));
    let (place, problem) = at("/targets", json!([[0, 0], [361, 1]]));
    assert_eq!(place, "application.targets[1][0]");
    assert_eq!(problem, Problem::OutOfRange { found: 361.0, min: 0.0, max: 360.0, measure: Measure::Degrees });
    assert_eq!(path("/targets", json!([[0, 1e13]])), "application.targets[0][1]");
    assert_eq!(path("/targets", json!([[0, "1"]])), "application.targets[0][1]");
    assert_eq!(path("/targets", json!([[0, 1, 2]])), "application.targets[0]");
    assert_eq!(path("/targets", json!(vec![json!([0, 1]); 65])), "application.targets");
    let valve = |angle: f64| json!({"kind": "valve", "seat_diameter": 1, "seat_angle": angle});
    let steep = refusal_of("R6", "/application", valve(80.0));
    assert_eq!(steep.path.to_string(), "application.seat_angle");
    assert!(matches!(steep.problem, Problem::OutOfRange { measure: Measure::Degrees, .. }));
    let swings = refusal_of("2RO", "/application", valve(45.0));
    assert_eq!(
        (swings.path.to_string().as_str(), swings.problem),
        ("application", Problem::Cam(CamRefusal::SwingingApplication))
    );
}

#[test]
fn what_is_usual_in_an_application_is_left_out() {
    let mut value = example("R6").expect("R6").to_value();
    value["application"] = json!({"kind": "valve", "seat_diameter": 1, "output": "area", "by": "theta", "targets": []});
    let design = Design::from_value(&value).expect("a valve");
    let written = design.to_value();
    assert_eq!(written["application"], json!({"kind": "valve", "seat_diameter": 1, "seat_angle": 45}));
    assert_eq!(Design::from_value(&written), Ok(design));
}

#[test]
fn titles_hold_what_can_be_seen() {
    check("/title", json!("x".repeat(65)), "title", |problem| {
        *problem == Problem::TitleTooLong { found: 65, limit: 64 }
    });
    for hidden in ['\n', '\u{7f}', '\u{85}', '\u{202e}', '\u{2066}', '\u{200f}', '\u{2028}'] {
        check("/title", json!(format!("ab{hidden}c")), "title", |problem| {
            *problem == Problem::TitleCharacter { found: hidden, position: 3 }
        });
    }
    let mut design = example("9RT").expect("9RT");
    design.title = "ñ".repeat(64);
    assert!(design.cam().is_ok(), "characters are counted, not bytes");
}

#[test]
fn what_is_no_json_text_is_refused_before_anything_else() {
    let problem = |bytes: &[u8]| Design::from_bytes(bytes).expect_err("refused").problem;
    assert_eq!(problem(&[0xff, 0xfe]), Problem::NotText);
    assert!(matches!(problem(b"{"), Problem::NotJson { line: 1, .. }));
    assert!(matches!(problem(&vec![b' '; MAX_FILE_BYTES + 1]), Problem::FileTooLarge { .. }));
    let twice = example("9RT").expect("9RT").to_json().replace("\"beta\": 50,", "\"beta\": 50, \"beta\": 50,");
    let error = Design::from_json(&twice).expect_err("twice");
    assert_eq!((error.path.to_string().as_str(), error.problem), ("segments[0].beta", Problem::DuplicateField));
}
