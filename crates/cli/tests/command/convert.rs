//! Other units and other symbols: the same cam.

use crate::run::{analysis, check_refusal, file_of, levalab, said, text, with_input, written};
use levalab_format::{Design, EXAMPLES};

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
        let there = said(&[vec!["convert", &file_of(name)], units("in", "rpm")].concat());
        assert_ne!(there, *json, "{name}");
        let back = with_input(&[vec!["convert", "-"], units(length, speed)].concat(), there.as_bytes());
        assert_eq!(text(&back.stdout), *json, "{name}");
    }
    let radius = |arguments: &[&str]| {
        let design = Design::from_json(&said(&[&["convert"], arguments].concat())).expect("a design");
        (design.base_radius, design.length_unit.symbol())
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
    let compared = said(&["compare", &file_of("9RT"), "--notation", "rothbart"]);
    assert!(["rb", "y max", "|y'|", "α min"].iter().all(|head| compared.contains(head)), "{compared}");
    let solved = said(&["solve", &file_of("9RT"), "--segment", "1", "--notation", "shigley"]);
    assert!(
        solved.contains("R_{0} = 35") && solved.contains(r"y' = \frac{y_") && !solved.contains("R_{b}"),
        "{solved}"
    );
    let table =
        said(&["export", &file_of("9RT"), "--to", "csv", "--table", "motion", "-o", "-", "--notation", "capitals"]);
    assert!(table.contains("Displacement S (mm)") && table.contains("Acceleration S̈ (mm/s²)"));
    let link = written(&["link", &file_of("9RT"), "--notation", "norton"]);
    assert!(text(&with_input(&["open", "-"], &link).stdout).contains("\"notation\": \"norton\""));
    check_refusal(&levalab(&["check", &file_of("9RT"), "--notation", "nobody"]), 64, "levalab: ");
}
