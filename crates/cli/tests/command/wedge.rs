//! The units and the missing base radius of a cam that travels, in every output; and that rounding noise is printed as 0.

use crate::run::{file_of, said, with_input};

/// A wedge whose *v*, *a* and *j* all jump somewhere.
const STEEP: &str = r#"{
    "format": "levalab/1", "title": "Steep",
    "cam": { "kind": "translating", "length": 200 }, "speed": { "value": 30, "unit": "mm/s" },
    "follower": { "motion": "translating", "contact": "roller", "roller_radius": 8 },
    "segments": [{ "law": "simple-harmonic", "beta": 70, "rise": 20 }, { "law": "dwell", "beta": 30 },
                 { "law": "cycloidal", "beta": 60, "rise": -12 }, { "law": "constant-velocity", "beta": 40, "rise": -8 }]
}"#;

fn of(arguments: &[&str]) -> String {
    let output = with_input(arguments, STEEP.as_bytes());
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn the_units_of_a_wedge_are_the_same_in_every_output() {
    let table = of(&["export", "-", "--to", "csv", "-o", "-"]);
    let heads = table.lines().next().unwrap_or_default();
    for unit in ["a (1/mm)", "j (1/mm²)", "V (mm/s)", "A (mm/s²)", "J (mm/s³)"] {
        assert!(heads.contains(unit), "{unit} in {heads}");
    }
    assert!(of(&["export", "-", "--to", "svg", "--diagram", "a", "-o", "-"]).contains("1/mm"));
    assert!(of(&["export", "-", "--to", "svg", "--diagram", "a", "--per-second", "-o", "-"]).contains("mm/s²"));
    assert!(of(&["check", "-"]).contains("\u{a0}1/mm at"), "{}", of(&["check", "-"]));
    let solution = of(&["solve", "-"]);
    assert!(solution.contains("mathrm{1/mm^2}") && solution.contains("mathrm{mm/s^2}"), "{solution}");
    for text in [table, of(&["check", "-"]), solution] {
        assert!(!text.contains("/rad") && !text.contains("radians") && !text.contains("mm/mm"), "{text}");
    }
}

#[test]
fn a_comparison_of_wedges_has_no_base_radius() {
    let table = said(&["compare", &file_of("WEDGE"), &file_of("WEDGE")]);
    assert!(!table.contains("Rb") && !table.contains(" 0 mm"), "{table}");
    assert!(said(&["compare", &file_of("9RT"), &file_of("WEDGE")]).contains("Rb"));
}

#[test]
fn what_is_rounding_in_a_column_is_printed_as_zero() {
    for name in ["4PO", "9RT", "12PO", "WEDGE"] {
        let table = said(&["analyze", &file_of(name), "--samples", "360", "--csv"]);
        let mut lines = table.lines();
        let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        let rows: Vec<Vec<f64>> =
            lines.map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect();
        for (k, column) in names.iter().enumerate().filter(|(_, name)| !name.contains("rho")) {
            let largest = rows.iter().fold(0.0_f64, |most, row| most.max(row[k].abs()));
            let largest = if *column == "pressure_angle" { 90.0 } else { largest };
            for row in &rows {
                assert!(row[k] == 0.0 || row[k].abs() > 1e-13 * largest, "{name} {column}: {:e}", row[k]);
            }
        }
    }
}
