//! What is held by which version of the design file.

use levalab_format::limits::MAX_DESIGN_POINTS;
use levalab_format::{DataRefusal, Design, DesignError, EXAMPLES, Problem, ProgramRefusal, Version, example};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A file with tables of so many points each, which share the turn.
fn tables(format: &str, points: &[usize]) -> String {
    let beta = 360.0 / points.len() as f64;
    let segments: Vec<Value> =
        points.iter().map(|&count| json!({ "law": "table", "beta": beta, "points": lobe(beta, count) })).collect();
    json!({
        "format": format,
        "cam": { "kind": "rotating", "base_radius": 40 },
        "follower": { "motion": "translating", "contact": "roller", "roller_radius": 10 },
        "segments": segments,
    })
    .to_string()
}

fn lobe(beta: f64, count: usize) -> Vec<[f64; 2]> {
    let part = |k: usize| k as f64 / (count - 1) as f64;
    (0..count).map(|k| [beta * part(k), (5e4 * (1.0 - (TAU * part(k)).cos())).round() / 1e4]).collect()
}

fn refusal(text: &str) -> (String, Problem) {
    let DesignError { path, problem } = Design::from_json(text).expect_err("refused");
    (path.to_string(), problem)
}

#[test]
fn version_2_is_written_only_for_what_version_1_does_not_hold() {
    for (points, version, format) in
        [(128, Version::One, "levalab/1"), (129, Version::Two, "levalab/2"), (1024, Version::Two, "levalab/2")]
    {
        let design = Design::from_json(&tables("levalab/2", &[points])).expect("a design");
        assert_eq!(design.version(), version, "{points} points");
        assert_eq!(design.to_value()["format"], format, "{points} points");
        assert_eq!(Design::from_json(&design.to_json()), Ok(design), "{points} points");
    }
    for (name, text) in EXAMPLES {
        assert_eq!(Design::from_json(text).expect(name).version(), Version::One, "{name}");
    }
}

#[test]
fn a_file_of_version_1_has_tables_of_128_points_at_most() {
    assert!(Design::from_json(&tables("levalab/1", &[128])).is_ok());
    let (path, problem) = refusal(&tables("levalab/1", &[129]));
    assert_eq!(
        (path.as_str(), problem),
        ("segments[0].points", Problem::Data(DataRefusal::WrongCount { found: 129, min: 1, max: 128 }))
    );
    let (_, problem) = refusal(&tables("levalab/2", &[1025]));
    assert_eq!(problem, Problem::Data(DataRefusal::WrongCount { found: 1025, min: 1, max: 1024 }));
}

#[test]
fn an_object_that_grew_since_its_version_was_written_is_read() {
    let grown: Value = serde_json::from_str(&tables("levalab/1", &[361])).expect("JSON");
    let design = Design::from_value(&grown).expect("a design");
    assert_eq!(design.to_value()["format"], "levalab/2");
}

#[test]
fn a_design_of_version_2_has_2048_points_at_most_and_one_of_version_1_as_many_as_its_tables() {
    let full = Design::from_json(&tables("levalab/2", &[1024, 1024])).expect("a design");
    assert!(full.cam().is_ok() && full.to_json().len() < 1 << 17);
    let (path, problem) = refusal(&tables("levalab/2", &[1024, 1000, 25]));
    let expected = ProgramRefusal::TooManyPoints { found: 2049, limit: MAX_DESIGN_POINTS };
    assert_eq!((path.as_str(), problem), ("segments", Problem::Program(expected)));
    let many = Design::from_json(&tables("levalab/1", &[128; 18])).expect("a design of version 1");
    assert_eq!(many.version(), Version::One);
}

#[test]
fn a_higher_version_is_said_to_be_newer() {
    for (format, newer) in
        [("levalab/3", true), ("levalab/12", true), ("levalab/0", false), ("levalab", false), ("lobes/3", false)]
    {
        let mut file = example("9RT").expect("9RT").to_value();
        file["format"] = json!(format);
        for error in
            [Design::from_json(&file.to_string()), Design::from_value(&file)].map(|read| read.expect_err(format))
        {
            assert_eq!(error.path.to_string(), "format");
            let expected = Problem::NewerFormat { found: format.to_owned() };
            assert_eq!(error.problem == expected, newer, "{error}");
            assert_eq!(matches!(error.problem, Problem::WrongWord { .. }), !newer, "{error}");
        }
    }
}
