//! Files for other programs.

use crate::run::{check_refusal, file_of, levalab, text, with_input, written};
use levalab_format::example;

#[test]
fn export_writes_each_kind_of_file() {
    let file = file_of("9RT");
    let exported = |more: &[&str]| written(&[&["export", &file, "-o", "-"], more].concat());
    let csv = text(&exported(&["--to", "csv", "--step", "30", "--lang", "es"]));
    assert!(csv.starts_with("\u{feff}\"Ángulo de la leva θ (°)\";") && csv.lines().count() == 14, "{csv}");
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
    refused(&["--to", "stl", "--thickness", "-1", "--lang", "es"], 64, "levalab: --thickness: Esta medida");
    refused(
        &["--to", "stl", "--thickness", "nan"],
        64,
        "levalab: --thickness: This measure has to be a positive number",
    );
    refused(&["--to", "stl", "--bore", "-2"], 64, "levalab: --bore: This measure has to be a positive number");
    refused(&["--to", "csv", "--step", "-1"], 64, "levalab: --step: ");
    refused(&["--to", "png", "--width", "-1", "--lang", "es"], 64, "levalab: --width: Tiene que ser un número entero");
    refused(&["--to", "stl", "--bore", "20", "--keyway", "-3x2"], 64, "levalab: --keyway: ");
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
    check_refusal(&output, 65, "levalab: -: The profile is undercut");
}

#[test]
fn the_design_file_is_never_written_over() {
    let folder = std::env::temp_dir().join(format!("levalab-same-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("inner")).expect("a folder");
    let design = folder.join("cam.lev.json");
    std::fs::copy(file_of("9RT"), &design).expect("a copy");
    let before = std::fs::read(&design).expect("the design");
    let mut names = vec![design.clone(), folder.join("inner/../cam.lev.json")];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&design, folder.join("link")).expect("a link");
        std::fs::hard_link(&design, folder.join("hard")).expect("a link");
        names.extend([folder.join("link"), folder.join("hard")]);
    }
    for name in names {
        let [design, name] = [&design, &name].map(|path| path.to_str().expect("a plain path"));
        let output = levalab(&["export", design, "--to", "csv", "-o", name]);
        check_refusal(&output, 64, &format!("levalab: --output: {name}: It is the design file itself"));
    }
    assert_eq!(std::fs::read(&design).expect("the design"), before);
    std::fs::remove_dir_all(&folder).expect("tidied");
}
