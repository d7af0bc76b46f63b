//! Several designs side by side, and one with every law that fits.

use crate::run::{check_refusal, file_of, levalab, said};

#[test]
fn designs_are_compared_line_by_line() {
    let table = said(&["compare", &file_of("9RT"), &file_of("10EX")]);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 3, "{table}");
    assert!(
        lines[1].starts_with("Example 9RT") && lines[1].contains("35 mm") && lines[1].contains("−28.2°"),
        "{table}"
    );
    assert!(lines[2].starts_with("Example 10EX") && lines[2].ends_with("● acceptable"), "{table}");
    check_refusal(&levalab(&["compare", &file_of("9RT"), "none.lev.json"]), 66, "levalab: none.lev.json: ");
}

#[test]
fn a_tournament_ranks_the_laws() {
    let ranked = |by: &str| said(&["tournament", &file_of("9RT"), "--by", by]);
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
    said(&["--lang", "es", "tournament", &file_of("2RO")]);
}
