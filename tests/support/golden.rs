//! Drawings beside those that are kept in `tests/golden`. `UPDATE_GOLDEN=1` draws them anew, to be looked at before they are kept.

use std::fs;
use std::path::Path;

/// The drawing of that name as it is kept: this one, when they are drawn anew.
pub fn kept(name: &str, drawn: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/golden").join(format!("{name}.svg"));
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, drawn).expect("the drawing is kept");
    }
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Asserts that the text is the same, and that numbers differ by no more than `tolerance`: sines are not the same on all machines.
pub fn assert_same(name: &str, kept: &[&str], drawn: &[&str], tolerance: f64) {
    for (k, (old, new)) in kept.iter().zip(drawn).enumerate() {
        let same = match (old.parse::<f64>(), new.parse::<f64>()) {
            (Ok(old), Ok(new)) => (old - new).abs() <= tolerance,
            _ => old == new,
        };
        let around = drawn[k.saturating_sub(20)..(k + 5).min(drawn.len())].concat();
        assert!(same, "{name}: {old} has become {new} near: {around}");
    }
    assert_eq!(kept.len(), drawn.len(), "{name}: something was added or is missing at the end");
}

/// Numbers, and the text between them.
pub fn pieces(text: &str) -> Vec<&str> {
    let numeric = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| numeric(c) != numeric(first)).unwrap_or(rest.len());
        pieces.push(&rest[..end]);
        rest = &rest[end..];
    }
    pieces
}
