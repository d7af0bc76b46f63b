//! Fields: missing, strange, of another kind, out of range; and text that is none.

use crate::{check, refusal, refusal_of};
use levalab_format::limits::MAX_FILE_BYTES;
use levalab_format::{Design, Kind, Measure, Problem, example};
use serde_json::{Value, json};

#[test]
fn a_missing_field_is_named() {
    for (place, path) in [
        ("/format", "format"),
        ("/cam", "cam"),
        ("/cam/kind", "cam.kind"),
        ("/cam/base_radius", "cam.base_radius"),
        ("/speed/value", "speed.value"),
        ("/speed/unit", "speed.unit"),
        ("/follower", "follower"),
        ("/follower/motion", "follower.motion"),
        ("/follower/contact", "follower.contact"),
        ("/follower/roller_radius", "follower.roller_radius"),
        ("/segments", "segments"),
        ("/segments/2/law", "segments[2].law"),
        ("/segments/2/beta", "segments[2].beta"),
        ("/segments/2/rise", "segments[2].rise"),
    ] {
        check(place, Value::Null, path, |problem| *problem == Problem::Missing);
    }
}

#[test]
fn what_has_a_usual_value_may_be_left_out() {
    let mut value = example("9RT").expect("9RT").to_value();
    for field in ["title", "length_unit", "speed"] {
        value.as_object_mut().expect("object").remove(field);
    }
    value["cam"].as_object_mut().expect("cam").remove("rotation");
    value["follower"].as_object_mut().expect("follower").remove("eccentricity");
    let expected = Design { title: String::new(), ..example("9RT").expect("9RT") };
    assert_eq!(Design::from_value(&value), Ok(expected));
}

#[test]
fn a_field_without_meaning_is_named_with_those_that_have_one() {
    for (place, path) in [
        ("/colour", "colour"),
        ("/cam/breadth", "cam.breadth"),
        ("/speed/units", "speed.units"),
        ("/follower/arm", "follower.arm"),
        ("/segments/1/b", "segments[1].b"),
    ] {
        check(place, json!(1), path, |problem| matches!(problem, Problem::UnknownField { .. }));
    }
    let Problem::UnknownField { expected } = refusal("/follower/arm", json!(1)).problem else { panic!("unknown") };
    assert_eq!(expected, ["motion", "contact", "roller_radius", "eccentricity"]);
}

#[test]
fn a_value_of_another_kind_is_told_with_the_kind_needed() {
    let wrong = |found, expected| move |problem: &Problem| *problem == Problem::WrongKind { found, expected };
    check("/title", json!(3), "title", wrong(Kind::Number, Kind::Text));
    check("/cam", json!([]), "cam", wrong(Kind::List, Kind::Object));
    check("/cam/base_radius", json!("35"), "cam.base_radius", wrong(Kind::Text, Kind::Number));
    check("/segments", json!({}), "segments", wrong(Kind::Object, Kind::List));
    check("/segments/0", json!(true), "segments[0]", wrong(Kind::Boolean, Kind::Object));
    check("/segments/0/beta", json!({}), "segments[0].beta", wrong(Kind::Object, Kind::Number));
    let null = Design::from_value(&Value::Null).expect_err("null");
    assert_eq!(
        (null.path.to_string().as_str(), null.problem),
        ("", Problem::WrongKind { found: Kind::Null, expected: Kind::Object })
    );
}

#[test]
fn a_word_that_is_no_choice_is_told_with_the_choices() {
    for (place, value, path) in [
        ("/format", "levalab", "format"),
        ("/length_unit", "ft", "length_unit"),
        ("/speed/unit", "Hz", "speed.unit"),
        ("/cam/kind", "conical", "cam.kind"),
        ("/cam/rotation", "left", "cam.rotation"),
        ("/follower/motion", "rotating", "follower.motion"),
        ("/follower/contact", "Roller", "follower.contact"),
        ("/segments/0/law", "cicloidal", "segments[0].law"),
    ] {
        let told = |problem: &Problem| matches!(problem, Problem::WrongWord { found, expected } if found == value && !expected.is_empty());
        check(place, json!(value), path, told);
    }
    let knife = refusal_of("2RO", "/follower/contact", json!("knife")).problem;
    assert_eq!(knife, Problem::WrongWord { found: "knife".to_owned(), expected: vec!["roller", "flat"] });
}

#[test]
fn numbers_out_of_range_are_told_with_the_range() {
    let out = |problem: &Problem| matches!(problem, Problem::OutOfRange { .. });
    let not_positive = |problem: &Problem| matches!(problem, Problem::NotPositive { .. });
    check("/cam/base_radius", json!(0), "cam.base_radius", not_positive);
    check("/cam/base_radius", json!(-35), "cam.base_radius", not_positive);
    check("/cam/base_radius", json!(1e7), "cam.base_radius", out);
    check("/cam/base_radius", json!(1e-7), "cam.base_radius", out);
    check("/follower/roller_radius", json!(0), "follower.roller_radius", not_positive);
    check("/speed/value", json!(0), "speed.value", not_positive);
    check("/speed/value", json!(1e10), "speed.value", out);
    check("/segments/0/beta", json!(0), "segments[0].beta", not_positive);
    check("/segments/0/beta", json!(361), "segments[0].beta", out);
    check("/segments/0/rise", json!(2e6), "segments[0].rise", out);
    let swing = refusal_of("2RO", "/segments/0/rise", json!(181)).problem;
    assert_eq!(swing, Problem::OutOfRange { found: 181.0, min: -180.0, max: 180.0, measure: Measure::Degrees });
}

#[test]
fn titles_hold_what_can_be_seen() {
    check("/title", json!("x".repeat(65)), "title", |problem| {
        *problem == Problem::TitleTooLong { found: 65, limit: 64 }
    });
    for hidden in ['\n', '\u{7f}', '\u{85}', '\u{202e}', '\u{2066}', '\u{200f}', '\u{2028}'] {
        check("/title", json!(format!("ab{hidden}c")), "title", |problem| {
            *problem == Problem::TitleCharacter { found: hidden, position: 3 }
        });
    }
    for blank in [" ", "\u{a0}\u{3000}", "\u{200b}", "\u{2060} \u{feff}", "\u{ad}", "\u{3164}", "\u{2800}", "\u{e0041}"]
    {
        check("/title", json!(blank), "title", |problem| *problem == Problem::TitleInvisible);
    }
    let mut design = example("9RT").expect("9RT");
    for visible in ["", " x ", "a\u{200d}b", "👩\u{200d}🔧"] {
        design.title = visible.to_owned();
        assert!(design.cam().is_ok(), "{visible:?}");
    }
    design.title = "ñ".repeat(64);
    assert!(design.cam().is_ok(), "characters are counted, not bytes");
}

#[test]
fn what_is_no_json_text_is_refused_before_anything_else() {
    let problem = |bytes: &[u8]| Design::from_bytes(bytes).expect_err("refused").problem;
    assert_eq!(problem(&[0xff, 0xfe]), Problem::NotText);
    let json = example("9RT").expect("9RT").to_json();
    let title = json.find("Example").expect("a title");
    // In Latin-1 an ñ is this one byte.
    let latin1: Vec<u8> = json.bytes().enumerate().map(|(k, byte)| if k == title { 0xf1 } else { byte }).collect();
    assert_eq!(problem(&latin1), Problem::NotText);
    assert_eq!(Design::from_bytes(&[b"\xef\xbb\xbf", json.as_bytes()].concat()), Ok(example("9RT").expect("9RT")));
    let comma = Design::from_json(&json.replace("35", "\"35,5\"")).expect_err("a decimal comma");
    assert_eq!(comma.path.to_string(), "cam.base_radius");
    assert_eq!(comma.problem, Problem::DecimalComma { found: "35,5".to_owned() });
    assert!(matches!(problem(b"{"), Problem::NotJson { line: 1, .. }));
    assert!(matches!(problem(&vec![b' '; MAX_FILE_BYTES + 1]), Problem::FileTooLarge { .. }));
    let twice = example("9RT").expect("9RT").to_json().replace("\"beta\": 50,", "\"beta\": 50, \"beta\": 50,");
    let error = Design::from_json(&twice).expect_err("twice");
    assert_eq!((error.path.to_string().as_str(), error.problem), ("segments[0].beta", Problem::DuplicateField));
}
