//! How it ends when something is wrong: one line that names the place, and the code of what it was.

use crate::run::{check_refusal, file_of, levalab, said, text, with_input};
use levalab_format::example;

#[test]
fn an_error_names_its_place_on_one_line() {
    let mut design = example("9RT").expect("9RT");
    design.segments[2].beta = -1.0;
    for order in ["analyze", "check", "link"] {
        check_refusal(&with_input(&[order, "-"], design.to_json().as_bytes()), 65, "levalab: -: segments[2].beta: ");
    }
    check_refusal(
        &with_input(&["check", "-"], b"{"),
        65,
        "levalab: -: The text ends in the middle of the design, in line 1, column 2.",
    );
    check_refusal(&with_input(&["check", "-"], &[0xff]), 65, "levalab: ");
    check_refusal(
        &with_input(&["check", "-"], br#"{"format": "levalab/1", "a\nb": 1}"#),
        65,
        r#"levalab: -: ["a\u{a}b"]: "#,
    );
    check_refusal(
        &with_input(&["check", "-"], &vec![b' '; 2 << 20]),
        65,
        "levalab: -: The file has more than 1\u{202f}048\u{202f}576 bytes",
    );
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
    assert!(!said(&["--help"]).is_empty() && !said(&["--version"]).is_empty());
}

#[test]
fn wrong_use_is_told_in_the_language_asked_for() {
    let file = file_of("9RT");
    let wrong: [(&[&str], &str, &str); 7] = [
        (&[], "no command; try", "falta la orden; pruebe"),
        (&["frobnicate"], "There is no command 'frobnicate'", "No existe la orden 'frobnicate'"),
        (&["check"], "Missing: <FILES>...", "Falta: <FILES>..."),
        (&["check", &file, "--hurry"], "'--hurry' has no meaning here", "'--hurry' no tiene sentido aquí"),
        (&["analyze", &file, "--json", "--csv"], "--json and --csv cannot", "--json y --csv no se pueden"),
        (
            &["analyze", &file, "--samples", "many"],
            "--samples: It must be a whole",
            "--samples: Tiene que ser un número",
        ),
        (
            &["export", &file, "--to", "pdf"],
            "--to: It must be one of csv, xlsx",
            "--to: Tiene que ser uno de csv, xlsx",
        ),
    ];
    for (arguments, en, es) in wrong {
        check_refusal(&levalab(arguments), 64, &format!("levalab: {en}"));
        for spanish in [&["--lang", "es"][..], &["--lang=es"]] {
            check_refusal(&levalab(&[arguments, spanish].concat()), 64, &format!("levalab: {es}"));
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_written_ends_with_74_and_a_closed_pipe_is_no_error() {
    use crate::run::command;
    use std::process::Stdio;
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("/dev/full");
    let output = command(&["analyze", &file_of("9RT")]).stdout(full).output().expect("levalab runs");
    assert_eq!(output.status.code(), Some(74));
    let mut command = command(&["analyze", &file_of("9RT"), "--samples", "20000"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("levalab runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("levalab ends");
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
}
