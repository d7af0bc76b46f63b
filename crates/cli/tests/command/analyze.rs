//! The analysis, whose JSON and CSV are a contract.

use crate::run::{analysis, file_of, levalab, said, text, with_input};
use levalab_format::testing::{self, Random};
use serde_json::Value;

#[test]
fn an_analysis_has_the_shape_of_the_contract() {
    let answer = analysis(&[&file_of("9RT"), "--samples", "360", "--json"]);
    assert_eq!(answer["verdict"]["level"], "low-speed");
    let finding = &answer["verdict"]["findings"][0];
    assert_eq!((&finding["code"], finding["value"].is_f64()), (&"jerk-jump".into(), true));
    assert_eq!(finding["cure"], finding["cures"][0]);
    assert!(finding["cure"]["edits"][0]["path"].is_array());
    for name in ["s", "v", "a", "j", "pressure_angle", "rho", "rho_pitch"] {
        assert!(answer["summary"][name]["max_at"].is_number(), "{name}");
    }
    let names = ["theta", "s", "v", "a", "j", "pressure_angle", "rho", "rho_pitch", "x", "y", "pitch_x", "pitch_y"];
    let columns = answer["columns"].as_object().expect("columns");
    assert_eq!(columns.len(), names.len());
    for name in names {
        let column = columns[name].as_array().expect(name);
        assert_eq!(column.len(), 361, "{name}");
        assert!(name == "theta" || column[0] == column[360], "{name} repeats its first row");
    }
    assert_eq!((columns["theta"][143].as_f64(), columns["theta"][360].as_f64()), (Some(143.0), Some(360.0)));
}

#[test]
fn an_application_has_its_columns_extremes_and_errors() {
    let answer = analysis(&[&file_of("R6"), "--samples", "360", "--json"]);
    let application = &answer["application"];
    assert_eq!((&application["kind"], &application["target_of"]), (&"piston-force".into(), &"force".into()));
    let force = &application["outputs"]["force"];
    assert_eq!(force["unit"], "lbf");
    let number = |value: &Value| value.as_f64().expect("a number");
    assert!((number(&force["max"]) - 126.1825).abs() < 5e-4 && (number(&force["max_at"]) - 74.39).abs() < 5e-3);
    assert!((number(&application["figures"]["stiffness"]) - 93.684).abs() < 5e-4);
    let columns = &application["columns"];
    for name in ["time", "force", "pressure"] {
        assert_eq!(columns[name].as_array().expect(name).len(), 361);
    }
    let (s, force) = (number(&answer["columns"]["s"][57]), number(&columns["force"][57]));
    assert!((force / s - 93.684).abs() < 5e-4);
    assert!((number(&columns["time"][180]) - std::f64::consts::PI / 12.566).abs() < 1e-12);
    let targets = application["targets"].as_array().expect("targets");
    assert_eq!((targets.len(), &targets[1]["value"]), (5, &110.282.into()));
    assert!((number(&targets[1]["found"]) - number(&targets[1]["value"]) - number(&targets[1]["error"])).abs() < 1e-12);
    assert!(analysis(&[&file_of("9RT"), "--samples", "4"]).get("application").is_none());

    let csv = said(&["analyze", &file_of("R6"), "--csv", "--samples", "4"]);
    assert!(csv.lines().next().is_some_and(|names| names.ends_with(",force,pressure")), "{csv}");
    let check = levalab(&["check", &file_of("R6"), "--lang", "es"]);
    let told = text(&check.stdout);
    assert!(told.contains("Fuerza de un pistón sobre fluido encerrado:\n  Fuerza de "), "{told}");
    assert_eq!(told.matches("; error ").count(), 5, "{told}");
    assert_eq!(check.status.code(), Some(1), "it is no part of the verdict");
}

#[test]
fn columns_that_do_not_apply_are_absent() {
    let flat = analysis(&[&file_of("10EX"), "--samples", "4"]);
    assert!(flat["columns"]["contact"].is_array() && flat["columns"].get("pitch_x").is_none());
    assert!(flat["summary"]["contact"].is_object() && flat["summary"].get("rho_pitch").is_none());
    assert!(analysis(&[&file_of("9RT"), "--samples", "4"])["columns"].get("contact").is_none());
}

#[test]
fn a_swinging_follower_is_told_in_degrees() {
    let answer = analysis(&[&file_of("2RO")]);
    assert_eq!(answer["columns"]["s"].as_array().expect("s").len(), 721, "720 steps unless told otherwise");
    assert!((answer["columns"]["s"][300].as_f64().expect("s") - 10.0).abs() < 1e-12);
    // 4-5-6-7: the greatest velocity is 2.1875·L/β.
    let fastest = answer["summary"]["v"]["max"].as_f64().expect("v");
    assert!((fastest - 2.1875 * 10.0 / 120_f64.to_radians()).abs() < 1e-9);
}

#[test]
fn a_profile_without_bounds_is_null_in_json_and_inf_in_csv() {
    assert!(analysis(&[&file_of("9RT")])["summary"]["rho"]["max"].is_null());
    let mut random = Random::new(3);
    for _ in 0..20 {
        let csv = with_input(
            &["analyze", "-", "--csv", "--samples", "16"],
            testing::design(&mut random).to_json().as_bytes(),
        );
        let csv = text(&csv.stdout);
        let mut lines = csv.lines();
        let names: Vec<&str> = lines.next().expect("names").split(',').collect();
        assert_eq!(names[..6], ["theta", "s", "v", "a", "j", "pressure_angle"]);
        let rows: Vec<&str> = lines.collect();
        assert_eq!(rows.len(), 17);
        for row in rows {
            assert_eq!(row.split(',').count(), names.len());
            assert!(row.split(',').all(|cell| cell.parse::<f64>().is_ok_and(|value| !value.is_nan())), "{row}");
        }
    }
}
