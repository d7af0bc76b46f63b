//! A program from what the machine must do.

use crate::run::{check_refusal, text, with_input};
use levalab_format::Design;

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
    check_refusal(&with_input(&["auto", "-"], wrong.as_bytes()), 65, "levalab: -: requirements[1]: ");
}
