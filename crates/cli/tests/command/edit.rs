//! Changes of a design from the command line: good or refused with a reason, and nothing written when refused.

use crate::run::{analysis, check_refusal, file_of, levalab, said, text, with_input};
use levalab_format::{Design, Edit, example};

fn edited(arguments: &[&str]) -> Design {
    Design::from_json(&said(&[&["edit", &file_of("9RT")], arguments].concat())).expect("a design")
}

#[test]
fn values_and_structure_are_changed_in_order() {
    assert_eq!(edited(&["cam.base_radius=36"]).base_radius, 36.0);
    let design = edited(&["title=Mine = yours", "notation=norton", "follower.eccentricity=1.5", "speed.unit=rpm"]);
    assert_eq!((design.title.as_str(), design.notation.word(), design.values[1]), ("Mine = yours", "norton", 1.5));
    let design = edited(&[r#"{"op":"delete","segments":[1,3]}"#, r#"[{"op":"spread"}, {"op":"scale","factor":0.5}]"#]);
    assert_eq!((design.segments.len(), design.segments[0].rise), (6, 5.0));
    assert_eq!(edited(&["title="]).title, "");
}

#[test]
fn the_edits_of_a_cure_are_made_from_a_file() {
    let found = analysis(&[&file_of("9RT"), "--samples", "36"]);
    let cures =
        found["verdict"]["findings"].as_array().expect("findings").iter().filter_map(|found| found["cures"].as_array());
    let edits = cures.flatten().map(|cure| cure["edits"].clone()).find(|edits| edits != &serde_json::json!([]));
    let edits = edits.expect("a cure");
    let after = with_input(&["edit", &file_of("9RT"), "--edits", "-"], edits.to_string().as_bytes());
    let design = example("9RT").expect("9RT");
    let expected = design.edited(&Edit::list(&edits).expect("edits")).expect("a cam");
    assert_eq!(text(&after.stdout), expected.to_json());
    assert_ne!(expected, design);
}

#[test]
fn what_is_not_possible_is_refused_and_nothing_is_written() {
    let nine = file_of("9RT");
    for (change, place, code) in [
        ("cam.base_radius=-5", "cam.base_radius: ", 65),
        ("cam.radius=5", "cam.radius: ", 65),
        ("segments[8].beta=5", "segments[8]: ", 65),
        ("segments[0].beta=51", "segments: ", 65),
        (r#"{"op":"fill-with-dwell"}"#, "segments: ", 65),
        ("base_radius", "", 64),
        (r#"{"op":"fly"}"#, "", 64),
    ] {
        let file = if code == 65 { format!("{nine}: ") } else { String::new() };
        check_refusal(&levalab(&["edit", &nine, change]), code, &format!("levalab: {file}{place}"));
        check_refusal(&levalab(&["edit", &nine, change, "--lang", "es"]), code, &format!("levalab: {file}{place}"));
    }
    check_refusal(&levalab(&["edit", &nine]), 64, "levalab: ");
    check_refusal(&levalab(&["edit", &nine, "--edits", "nowhere.json"]), 66, "levalab: nowhere.json: ");
}
