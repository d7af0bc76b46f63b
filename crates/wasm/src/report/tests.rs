use super::*;
use crate::instant;
use crate::lab::analyse;
use levalab_core::{FindingKind, Level};
use levalab_format::{Design, EXAMPLES};
use serde_json::{Value, json};

fn opened(design: &Value) -> (Current, Option<Current>) {
    let draft = Design::draft(design).unwrap_or_else(|error| panic!("{error:?} {design}"));
    analyse(draft, 720).unwrap_or_else(|error| panic!("{error:?} {design}"))
}

fn told(first: &Current, second: Option<&Current>, language: Language) -> Value {
    serde_json::to_value(PageReport::of(first, second, language)).expect("JSON")
}

/// A pair with jumps of *v* and of *j*, one of whose cams has a pressure angle of its own that is too large.
fn pair() -> Value {
    json!({
        "format": "levalab/1", "title": "",
        "cam": { "kind": "rotating", "base_radius": 60 },
        "speed": { "value": 60, "unit": "rpm" },
        "follower": { "motion": "oscillating", "contact": "roller", "roller_radius": 8, "arm": 100, "pivot_distance": 120 },
        "conjugate": { "angle": 85 },
        "segments": [
            { "law": "cycloidal", "beta": 60, "rise": 18 }, { "law": "dwell", "beta": 120 },
            { "law": "constant-velocity", "beta": 80, "rise": -12 }, { "law": "cycloidal", "beta": 100, "rise": -6 },
        ],
    })
}

fn wedge() -> Value {
    json!({
        "format": "levalab/1", "title": "",
        "cam": { "kind": "translating", "length": 200 }, "speed": { "value": 30, "unit": "mm/s" },
        "follower": { "motion": "translating", "contact": "roller", "roller_radius": 8 },
        "segments": [{ "law": "constant-velocity", "beta": 120, "rise": 20 }, { "law": "dwell", "beta": 80 }],
    })
}

fn translating() -> Value {
    json!({
        "format": "levalab/1", "title": "",
        "cam": { "kind": "rotating", "base_radius": 60 }, "speed": { "value": 100, "unit": "rad/s" },
        "follower": { "motion": "translating", "contact": "roller", "roller_radius": 8 },
        "segments": [
            { "law": "constant-velocity", "beta": 45, "rise": 10 }, { "law": "dwell", "beta": 135 },
            { "law": "cycloidal", "beta": 180, "rise": -10 },
        ],
    })
}

#[test]
fn findings_of_both_cams_are_told_by_severity_and_place_with_their_own_cures() {
    let (first, second) = opened(&pair());
    let second = second.expect("a pair");
    let cams = [&first, &second];
    let report = told(&first, Some(&second), Language::En);
    let findings = report["verdict"]["findings"].as_array().expect("findings");
    let of_each = cams.map(|current| current.report.findings.len());
    assert_eq!(findings.len(), of_each[0] + of_each[1]);
    let key = |finding: &Value| {
        let rank = ["unacceptable", "low-speed", "acceptable"].iter().position(|level| *level == finding["severity"]);
        (rank, finding["theta"].as_f64().expect("θ"))
    };
    for pair in findings.windows(2) {
        let ((one, here), (other, there)) = (key(&pair[0]), key(&pair[1]));
        assert!(one < other || one == other && here <= there + 1e-4, "{pair:?}");
    }
    let both = findings.iter().map(|finding| finding["cam"].as_u64().expect("a cam")).collect::<Vec<_>>();
    assert!(both.windows(2).filter(|pair| pair[0] != pair[1]).count() > 1, "the cams alternate: {both:?}");
    // What is given with the findings of each cam comes in the same order.
    let tagged = |k: usize| (0..of_each[k]).map(|i| cams[k].report.findings[i].theta).collect::<Vec<f64>>();
    let places = of_both(&cams, vec![tagged(0), tagged(1)]);
    assert_eq!(places, findings.iter().map(|finding| key(finding).1).collect::<Vec<f64>>());
}

#[test]
fn the_headline_of_a_pair_names_the_cam_that_it_is_about() {
    let (first, second) = opened(&pair());
    let second = second.expect("a pair");
    for language in [Language::En, Language::Es] {
        for (one, other) in [(&first, &second), (&second, &first)] {
            let report = told(one, Some(other), language);
            let headlines = [one, other].map(|current| levalab_words::headline(language, &current.report));
            let verdict = &report["verdict"];
            let expected = if other.report.level > one.report.level { 1 } else { 0 };
            assert_eq!(verdict["headline"], headlines[expected]);
            let cam = if headlines[0] == headlines[1] { Value::Null } else { json!(expected + 1) };
            assert_eq!(verdict["cam"], cam);
            assert_eq!(report["conjugate"]["verdict"]["cam"], 2);
        }
    }
    assert_eq!(first.report.level.max(second.report.level), Level::Unacceptable);
}

#[test]
fn jumps_are_told_by_angle_and_by_time_in_both_languages() {
    let (cam, _) = opened(&translating());
    let message = |language, key: &str| {
        let report = told(&cam, None, language);
        let findings = report["verdict"]["findings"].as_array().expect("findings").clone();
        let jump = findings.into_iter().find(|finding| finding["code"] == "velocity-jump").expect("a jump of v");
        jump[key].as_str().expect("a sentence").to_owned()
    };
    // 10 mm in π/4 at 100 rad/s.
    assert!(message(Language::En, "message").contains("by up to 12.73\u{a0}mm/rad at"));
    assert!(message(Language::En, "message_by_time").contains("by up to 1273\u{a0}mm/s at"));
    assert!(message(Language::Es, "message").contains("12,73\u{a0}mm/rad"));
    assert!(message(Language::Es, "message_by_time").contains("1273\u{a0}mm/s"));
    let report = told(&cam, None, Language::En);
    for finding in report["verdict"]["findings"].as_array().expect("findings") {
        let derivative =
            finding["code"].as_str().is_some_and(|code| code.ends_with("-jump") && code != "displacement-jump");
        assert_eq!(finding.get("message_by_time").is_some(), derivative, "{finding}");
    }
}

#[test]
fn no_sentence_by_time_and_no_cure_states_a_derivative_by_angle() {
    let examples = EXAMPLES.iter().map(|(_, json)| serde_json::from_str(json).expect("JSON"));
    for design in examples.chain([pair(), translating(), wedge()]) {
        let (first, second) = opened(&design);
        for (current, language) in
            [&first].into_iter().chain(&second).flat_map(|current| [(current, Language::En), (current, Language::Es)])
        {
            for finding in &current.report.findings {
                let by_time = levalab_words::finding_by_time(language, &current.design, finding);
                assert_eq!(by_time.is_some(), matches!(finding.kind, FindingKind::Jump(1..)), "{:?}", finding.kind);
                let said = by_time.unwrap_or_default();
                assert!(!said.contains("/rad") && !said.contains("1/mm"), "{said}");
            }
            if current.cam.follower.reversed.is_none() {
                let cures = cures(current, language);
                let said = serde_json::to_string(&cures).expect("JSON");
                assert!(!said.contains("/rad") && !said.contains("/s"), "{said}");
            }
        }
    }
}

#[test]
fn the_sliding_of_the_contact_is_given_by_angle_and_by_time_with_its_units() {
    for (design, by_angle) in [(translating(), "mm/rad"), (pair(), "mm/rad"), (wedge(), "")] {
        let (current, _) = opened(&design);
        let units = &told(&current, None, Language::En)["units"];
        assert_eq!((&units["u"], &units["U"]), (&json!(by_angle), &json!("mm/s")));
        let mut at = [0.0; instant::LENGTH];
        let omega = current.design.omega();
        instant::fill(&current.cam, omega, 20.0, &mut at);
        assert!(at[8] != 0.0 && (at[22] - at[8] * omega).abs() <= 1e-12 * at[22].abs(), "{} {}", at[8], at[22]);
    }
}

#[test]
fn the_units_of_a_wedge_are_the_same_on_the_page_and_in_its_sentences() {
    let (current, _) = opened(&wedge());
    let report = told(&current, None, Language::En);
    let units = |keys: [&str; 3]| keys.map(|key| report["units"][key].as_str().expect("a unit").to_owned());
    assert_eq!(units(["v", "a", "j"]), ["", "1/mm", "1/mm²"]);
    assert_eq!(units(["V", "A", "J"]), ["mm/s", "mm/s²", "mm/s³"]);
    let jump = current.report.findings.iter().find(|finding| finding.kind == FindingKind::Jump(1)).expect("a jump");
    let said = levalab_words::finding(Language::En, &current.design, jump);
    assert!(said.contains("by up to 0.3333 at"), "{said}");
    let by_time = levalab_words::finding_by_time(Language::En, &current.design, jump).expect("by time");
    assert!(by_time.contains("by up to 10\u{a0}mm/s at"), "{by_time}");
}
