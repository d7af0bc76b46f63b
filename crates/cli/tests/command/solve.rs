//! The worked solution.

use crate::run::{check_refusal, file_of, levalab, said};

#[test]
fn a_solution_is_written_in_every_form() {
    let file = file_of("R1");
    let solved = |more: &[&str]| said(&[&["solve", &file], more].concat());
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
    for theta in ["1e300", "-1e300", "nan", "1000001"] {
        check_refusal(
            &levalab(&["solve", &file, "--theta", theta, "--lang", "es"]),
            64,
            "levalab: --theta: Tiene que ser un número de ",
        );
    }
    check_refusal(&levalab(&["solve", &file, "--to", "pdf"]), 64, "levalab: ");
}
