//! The verdict in words, and as the code that the command ends with.

use crate::run::{file_of, levalab, text};

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
    let told = |language| text(&levalab(&["check", &file_of("9RT"), "--lang", language]).stdout);
    assert!(told("en").starts_with("Not for high speeds: the jerk jumps at 6 joints.\n"), "{}", told("en"));
    assert!(
        told("es").starts_with("No apta para altas velocidades: la sobreaceleración salta en 6 uniones.\n"),
        "{}",
        told("es")
    );
}

#[test]
fn many_files_are_told_in_their_order() {
    let files: Vec<String> =
        ["R5", "2RO", "9RT", "absent", "10EX", "R1", "4PO"].iter().cycle().take(21).map(|name| file_of(name)).collect();
    let arguments: Vec<&str> = ["check"].into_iter().chain(files.iter().map(String::as_str)).collect();
    let several = levalab(&arguments);
    let told = text(&several.stdout);
    let names: Vec<&str> =
        told.lines().filter_map(|line| line.split_once(".lev.json: ")).map(|(name, _)| name).collect();
    let expected: Vec<&str> = files
        .iter()
        .filter(|file| !file.contains("absent"))
        .filter_map(|file| file.strip_suffix(".lev.json"))
        .collect();
    assert_eq!(names, expected);
    assert_eq!(text(&several.stderr).lines().count(), 3);
    assert_eq!(several.status.code(), Some(66));
}
