//! The command as programs and people use it: what goes in, what comes out, and how it ends.

use levalab_format::testing::{self, Random};
use levalab_format::{Design, EXAMPLES, example};
use serde_json::Value;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_levalab"));
    command.args(arguments);
    command
}

fn levalab(arguments: &[&str]) -> Output {
    command(arguments).stdin(Stdio::null()).output().expect("levalab runs")
}

fn with_input(arguments: &[&str], input: &[u8]) -> Output {
    let mut command = command(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("levalab runs");
    // One that ends without reading closes the pipe.
    let _ = child.stdin.take().expect("a pipe").write_all(input);
    child.wait_with_output().expect("levalab ends")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("text")
}

fn file_of(name: &str) -> String {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(format!("{name}.lev.json"));
    file.to_str().expect("a plain path").to_owned()
}

/// An error is one line that begins so, with nothing on standard output.
fn check_refusal(output: &Output, code: i32, beginning: &str) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{said}");
    assert_eq!(text(&output.stdout), "", "{said}");
    assert!(said.starts_with(beginning) && said.ends_with('\n') && said.lines().count() == 1, "{said:?}");
}

fn analysis(arguments: &[&str]) -> Value {
    let output = levalab(&[&["analyze"], arguments].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

#[test]
fn link_and_open_give_the_file_back() {
    for (name, json) in EXAMPLES {
        let link = levalab(&["link", &file_of(name)]);
        assert!(link.status.success());
        assert_eq!(text(&with_input(&["open", "-"], &link.stdout).stdout), *json);
        let link = text(&link.stdout);
        for pasted in [link.trim().to_owned(), format!("#{}", link.trim()), format!("https://example.org/#{link}")] {
            assert_eq!(text(&levalab(&["open", &pasted]).stdout), *json);
        }
    }
}

#[test]
fn a_design_is_converted_and_comes_back_or_keeps_its_numbers() {
    for (name, json) in EXAMPLES {
        let design = Design::from_json(json).expect(name);
        let (length, speed) = (design.length_unit.symbol(), design.speed.unit.symbol(design.length_unit));
        let units = |length, speed| {
            if design.kind.travel().is_some() {
                vec!["--unit", length]
            } else {
                vec!["--unit", length, "--speed", speed]
            }
        };
        let there = levalab(&[vec!["convert", &file_of(name)], units("in", "rpm")].concat());
        assert!(there.status.success(), "{name}: {}", text(&there.stderr));
        assert_ne!(text(&there.stdout), *json, "{name}");
        let back = with_input(&[vec!["convert", "-"], units(length, speed)].concat(), &there.stdout);
        assert_eq!(text(&back.stdout), *json, "{name}");
    }
    let radius = |arguments: &[&str]| {
        let output = levalab(&[&["convert"], arguments].concat());
        Design::from_bytes(&output.stdout)
            .map(|design| (design.base_radius, design.length_unit.symbol()))
            .expect("a design")
    };
    assert_eq!(radius(&[&file_of("9RT"), "--unit", "in"]), (35.0 / 25.4, "in"));
    assert_eq!(radius(&[&file_of("9RT"), "--unit", "in", "--relabel"]), (35.0, "in"));
    check_refusal(&levalab(&["convert", &file_of("9RT")]), 64, "levalab: ");
    check_refusal(&levalab(&["convert", &file_of("9RT"), "--unit", "ft"]), 64, "levalab: ");
}

#[test]
fn a_notation_changes_what_is_written_and_nothing_that_is_computed() {
    let ours = analysis(&[&file_of("9RT"), "--samples", "36"]);
    assert_eq!(analysis(&[&file_of("9RT"), "--samples", "36", "--notation", "rothbart"])["columns"], ours["columns"]);
    let compared = text(&levalab(&["compare", &file_of("9RT"), "--notation", "rothbart"]).stdout);
    assert!(["rb", "y max", "|y'|", "α min"].iter().all(|head| compared.contains(head)), "{compared}");
    let solved = text(&levalab(&["solve", &file_of("9RT"), "--segment", "1", "--notation", "shigley"]).stdout);
    assert!(
        solved.contains("R_{0} = 35") && solved.contains(r"y' = \frac{y_") && !solved.contains("R_{b}"),
        "{solved}"
    );
    let table = text(
        &levalab(&["export", &file_of("9RT"), "--to", "csv", "--table", "motion", "-o", "-", "--notation", "capitals"])
            .stdout,
    );
    assert!(table.contains("Displacement S (mm)") && table.contains("Acceleration S̈ (mm/s²)"));
    let link = levalab(&["link", &file_of("9RT"), "--notation", "norton"]);
    assert!(text(&with_input(&["open", "-"], &link.stdout).stdout).contains("\"notation\": \"norton\""));
    check_refusal(&levalab(&["check", &file_of("9RT"), "--notation", "nobody"]), 64, "levalab: ");
}

#[test]
fn any_design_survives_the_pipeline() {
    let mut random = Random::new(7);
    for _ in 0..10 {
        let design = testing::design(&mut random);
        let link = with_input(&["link", "-"], design.to_json().as_bytes());
        if !link.status.success() {
            check_refusal(&link, 65, "levalab: link: The link would have");
            continue;
        }
        let opened = with_input(&["open", "-"], &link.stdout);
        assert_eq!(Design::from_bytes(&opened.stdout), Ok(design));
    }
}

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
    assert!((number(&force["max"]) - 126.16).abs() < 5e-3 && (number(&force["max_at"]) - 74.39).abs() < 5e-3);
    assert!((number(&application["figures"]["stiffness"]) - 93.684).abs() < 5e-4);
    let columns = &application["columns"];
    for name in ["time", "force", "pressure"] {
        assert_eq!(columns[name].as_array().expect(name).len(), 361);
    }
    let (s, force) = (number(&answer["columns"]["s"][57]), number(&columns["force"][57]));
    assert!((force / s - 93.684).abs() < 5e-4);
    assert!((number(&columns["time"][180]) - std::f64::consts::PI / 12.566).abs() < 1e-12);
    let targets = application["targets"].as_array().expect("targets");
    assert_eq!((targets.len(), &targets[1]["value"]), (5, &110.27.into()));
    assert!((number(&targets[1]["found"]) - number(&targets[1]["value"]) - number(&targets[1]["error"])).abs() < 1e-12);
    assert!(analysis(&[&file_of("9RT"), "--samples", "4"]).get("application").is_none());

    let csv = text(&levalab(&["analyze", &file_of("R6"), "--csv", "--samples", "4"]).stdout);
    assert!(csv.lines().next().is_some_and(|names| names.ends_with(",force,pressure")), "{csv}");
    let check = levalab(&["check", &file_of("R6"), "--lang", "es"]);
    let said = text(&check.stdout);
    assert!(said.contains("Fuerza de un pistón sobre fluido encerrado:\n  Fuerza de "), "{said}");
    assert_eq!(said.matches("; error ").count(), 5, "{said}");
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

#[test]
fn check_ends_with_the_verdict() {
    for (name, code) in [("2RO", 0), ("10EX", 0), ("9RT", 1), ("4PO", 1), ("12PO", 1), ("R1", 2), ("R5", 2)] {
        assert_eq!(levalab(&["check", &file_of(name)]).status.code(), Some(code), "{name}");
    }
    let several = levalab(&["check", &file_of("2RO"), &file_of("R5"), &file_of("9RT")]);
    assert_eq!(several.status.code(), Some(2));
    assert_eq!(text(&several.stdout).lines().filter(|line| line.contains(".lev.json: ")).count(), 3);
    let missing = levalab(&["check", &file_of("2RO"), "absent.lev.json"]);
    assert_eq!(missing.status.code(), Some(66));
    assert!(!missing.stdout.is_empty() && text(&missing.stderr).starts_with("levalab: absent.lev.json: "));
}

#[test]
fn check_speaks_both_languages() {
    let said = |language| text(&levalab(&["check", &file_of("9RT"), "--lang", language]).stdout);
    assert!(said("en").starts_with("Not for high speeds: the jerk jumps at 6 joints.\n"), "{}", said("en"));
    assert!(
        said("es").starts_with("No apta para altas velocidades: la sobreaceleración salta en 6 uniones.\n"),
        "{}",
        said("es")
    );
}

#[test]
fn an_error_names_its_place_on_one_line() {
    let mut design = example("9RT").expect("9RT");
    design.segments[2].beta = -1.0;
    for order in ["analyze", "check", "link"] {
        check_refusal(&with_input(&[order, "-"], design.to_json().as_bytes()), 65, "levalab: segments[2].beta: ");
    }
    check_refusal(&with_input(&["check", "-"], b"{"), 65, "levalab: -: The text is not JSON from line 1, column 1 on.");
    check_refusal(&with_input(&["check", "-"], &[0xff]), 65, "levalab: ");
    check_refusal(
        &with_input(&["check", "-"], br#"{"format": "levalab/1", "a\nb": 1}"#),
        65,
        r#"levalab: ["a\u{a}b"]: "#,
    );
    check_refusal(&with_input(&["check", "-"], &vec![b' '; 2 << 20]), 65, "levalab: -: The file has ");
    check_refusal(&levalab(&["open", "1.a.b"]), 65, "levalab: link: ");
    check_refusal(&levalab(&["check", "--lang", "es", "absent"]), 66, "levalab: absent: No existe ese archivo.");
    check_refusal(&levalab(&["check", env!("CARGO_MANIFEST_DIR")]), 66, "levalab: ");
}

#[test]
fn wrong_use_ends_with_64() {
    let file = file_of("9RT");
    let wrong: [&[&str]; 9] = [
        &[],
        &["frobnicate"],
        &["analyze"],
        &["check"],
        &["analyze", &file, "--samples", "0"],
        &["analyze", &file, "--samples", "100001"],
        &["analyze", &file, "--samples", "many"],
        &["analyze", &file, "--json", "--csv"],
        &["check", &file, "--lang", "fr"],
    ];
    for arguments in wrong {
        check_refusal(&levalab(arguments), 64, "levalab: ");
    }
    assert!(levalab(&["--help"]).status.success() && levalab(&["--version"]).status.success());
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_written_ends_with_74_and_a_closed_pipe_is_no_error() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("/dev/full");
    let output = command(&["analyze", &file_of("9RT")]).stdout(full).output().expect("levalab runs");
    assert_eq!(output.status.code(), Some(74));
    let mut command = command(&["analyze", &file_of("9RT"), "--samples", "20000"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("levalab runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("levalab ends");
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
}

#[test]
fn designs_are_compared_line_by_line() {
    let output = levalab(&["compare", &file_of("9RT"), &file_of("10EX")]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let said = text(&output.stdout);
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines.len(), 3, "{said}");
    assert!(lines[1].starts_with("Example 9RT") && lines[1].contains("35 mm") && lines[1].contains("−28.2°"), "{said}");
    assert!(lines[2].starts_with("Example 10EX") && lines[2].ends_with("● acceptable"), "{said}");
    check_refusal(&levalab(&["compare", &file_of("9RT"), "none.lev.json"]), 66, "levalab: none.lev.json: ");
}

#[test]
fn a_tournament_ranks_the_laws() {
    let ranked = |by: &str| {
        let output = levalab(&["tournament", &file_of("9RT"), "--by", by]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let by_velocity = ranked("v");
    assert!(by_velocity.lines().nth(1).is_some_and(|line| line.starts_with("constant velocity")), "{by_velocity}");
    // What jumps in v has no peak of a: it is not the gentlest.
    let by_acceleration = ranked("a");
    assert!(by_acceleration.lines().last().is_some_and(|line| line.contains('∞')), "{by_acceleration}");
    assert!(
        by_acceleration.lines().nth(1).is_some_and(|line| !line.contains("constant velocity")),
        "{by_acceleration}"
    );
    let verdict = ranked("verdict");
    assert!(verdict.lines().nth(1).is_some_and(|line| line.ends_with("● acceptable")), "{verdict}");
    assert!(levalab(&["--lang", "es", "tournament", &file_of("2RO")]).status.success());
}

#[test]
fn a_solution_is_written_in_every_form() {
    let file = file_of("R1");
    let solved = |more: &[&str]| {
        let output = levalab(&[&["solve", &file], more].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{more:?}: {}", text(&output.stderr));
        text(&output.stdout)
    };
    let markdown = solved(&[]);
    assert!(markdown.starts_with("# Worked solution: Example R1\n"), "{markdown}");
    assert!(markdown.contains("$$s = 0.2 + 0.15 x - 2.9 x^{3} + 4.2 x^{4} - 1.65 x^{5}$$"), "{markdown}");
    let one = solved(&["--segment", "3", "--theta", "200", "--lang", "es"]);
    assert!(
        one.contains("### Tramo 3") && !one.contains("### Tramo 1") && one.contains("\\theta = 200^\\circ"),
        "{one}"
    );
    assert!(solved(&["--theta", "-45"]).contains("\\theta = 315^\\circ"));
    let latex = solved(&["--to", "latex"]);
    assert!(latex.starts_with("\\documentclass") && latex.ends_with("\\end{document}\n"), "{latex}");
    let page = solved(&["--to", "html"]);
    assert!(page.starts_with("<!doctype html>") && page.contains("<math display=\"block\">"), "{page}");
    check_refusal(
        &levalab(&["solve", &file, "--segment", "5"]),
        64,
        "levalab: --segment: The design has segments 1 to 4",
    );
    check_refusal(&levalab(&["solve", &file, "--segment", "0", "--lang", "es"]), 64, "levalab: --segment: El diseño");
    check_refusal(&levalab(&["solve", &file, "--theta", "inf"]), 64, "levalab: --theta: ");
    check_refusal(&levalab(&["solve", &file, "--to", "pdf"]), 64, "levalab: ");
}

#[test]
fn export_writes_each_kind_of_file() {
    let file = file_of("9RT");
    let exported = |more: &[&str]| {
        let output = levalab(&[&["export", &file, "-o", "-"], more].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{more:?}: {}", text(&output.stderr));
        output.stdout
    };
    let csv = text(&exported(&["--to", "csv", "--step", "30", "--lang", "es"]));
    assert!(csv.starts_with("\u{feff}Ángulo de la leva θ (°);") && csv.lines().count() == 14, "{csv}");
    let comma = text(&exported(&["--to", "csv", "--table", "cartesian", "--separator", "comma", "--lang", "es"]));
    assert!(comma.lines().nth(1).is_some_and(|row| row == "0,0,35"), "{comma}");
    assert!(exported(&["--to", "xlsx"]).starts_with(b"PK"));
    let dxf = text(&exported(&["--to", "dxf", "--step", "90"]));
    assert!(dxf.contains("LWPOLYLINE") && dxf.contains("AC1015"));
    assert!(text(&exported(&["--to", "svg", "--bore", "10", "--keyway", "3x1.4"])).contains("class=\"bore\""));
    let timed = text(&exported(&["--to", "svg", "--diagram", "v", "--per-second", "--lang", "es"]));
    assert!(timed.contains("Velocidad (mm/s)"), "{timed}");
    assert!(exported(&["--to", "png", "--width", "200"]).starts_with(b"\x89PNG"));
    let (thin, thick) = (exported(&["--to", "stl"]), exported(&["--to", "stl", "--thickness", "30", "--bore", "12"]));
    assert!(thin.len() % 50 == 34 && thick.len() > thin.len());
}

#[test]
fn export_goes_to_a_file() {
    let place = std::env::temp_dir().join(format!("levalab-export-{}.svg", std::process::id()));
    let name = place.to_str().expect("a plain path");
    let output = levalab(&["export", &file_of("2RO"), "--to", "svg", "-o", name]);
    let written = std::fs::read_to_string(&place);
    let _ = std::fs::remove_file(&place);
    assert!(output.status.success() && output.stdout.is_empty());
    assert!(written.is_ok_and(|drawing| drawing.starts_with("<svg")));
    let nowhere = levalab(&["export", &file_of("2RO"), "--to", "svg", "-o", "/no/such/folder/a.svg"]);
    check_refusal(&nowhere, 74, "levalab: /no/such/folder/a.svg: ");
}

#[test]
fn an_export_that_makes_no_sense_is_refused_by_the_name_of_its_option() {
    let file = file_of("9RT");
    let refused = |more: &[&str], code, beginning: &str| {
        check_refusal(&levalab(&[&["export", &file, "-o", "-"], more].concat()), code, beginning);
    };
    refused(&["--to", "csv", "--step", "7"], 64, "levalab: --step: Steps of 7°");
    refused(&["--to", "stl", "--thickness", "-1"], 64, "levalab: ");
    refused(&["--to", "stl", "--thickness=-1", "--lang", "es"], 64, "levalab: --thickness: Esta medida");
    refused(&["--to", "dxf", "--bore", "80"], 64, "levalab: --bore: ");
    refused(&["--to", "dxf", "--bore", "20", "--keyway", "30x2"], 64, "levalab: --keyway: ");
    refused(&["--to", "dxf", "--keyway", "8x3"], 64, "levalab: ");
    refused(&["--to", "stl", "--bore", "20", "--keyway", "8"], 64, "levalab: ");
    refused(&["--to", "png", "--width", "0"], 64, "levalab: ");
    refused(&["--to", "png", "--width", "20000"], 64, "levalab: ");
    refused(&["--to", "pdf"], 64, "levalab: ");
    refused(&["--to", "csv", "--table", "all"], 64, "levalab: ");
    refused(&[], 64, "levalab: ");
    let mut design = example("9RT").expect("9RT");
    design.base_radius = 10.0;
    let output = with_input(&["export", "-", "--to", "stl", "-o", "-"], design.to_json().as_bytes());
    check_refusal(&output, 65, "levalab: The profile is undercut");
}

#[test]
fn auto_joins_what_the_machine_must_do_and_says_why() {
    let requirements = r#"{"format": "levalab/1", "cam": {"kind": "rotating", "base_radius": 60}, "follower": {"motion": "translating", "contact": "roller", "roller_radius": 10},
        "requirements": [{"dwell": [0, 60], "s": 0}, {"line": [100, 160], "s": [4, 16]}, {"at": 240, "s": 12.5}]}"#;
    let output = with_input(&["auto", "-"], requirements.as_bytes());
    let design = Design::from_json(&text(&output.stdout)).expect("a design");
    assert_eq!(design.segments.iter().map(|segment| segment.beta).sum::<f64>(), 360.0);
    let verdict = with_input(&["check", "-"], &output.stdout);
    assert_ne!(verdict.status.code(), Some(2), "{}", text(&verdict.stdout));
    let why = text(&with_input(&["auto", "-", "--why"], requirements.as_bytes()).stdout);
    assert!(why.starts_with("From 60° to 100°: ") && why.contains("lowest peak"), "{why}");
    let why = text(&with_input(&["auto", "-", "--why", "--lang", "es"], requirements.as_bytes()).stdout);
    assert!(why.starts_with("De 60° a 100°: ") && why.contains("menor máximo"), "{why}");
    let wrong = requirements.replace("[100, 160]", "[50, 160]");
    check_refusal(&with_input(&["auto", "-"], wrong.as_bytes()), 65, "levalab: requirements[1]: ");
}
