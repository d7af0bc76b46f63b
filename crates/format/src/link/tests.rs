//! Claims about links.

use super::{LinkError, decode, encode, within};
use crate::limits::{MAX_LINK_MADE, MAX_LINK_OPENED};
use crate::testing::{self, Random};
use crate::{Design, Notation, Problem, ProgramRefusal, SegmentDesign, example};
use levalab_catalogue::{Version, law_label};
use levalab_core::Law;
use proptest::prelude::*;

fn segment(id: &str, beta: f64, rise: f64) -> SegmentDesign {
    let law = Law::by_id(id).expect(id);
    let parameters = law.default_parameters();
    SegmentDesign { law, beta, rise, parameters, data: law.first_data(beta, 0.0, rise) }
}

/// Twelve segments as a student would draw them up, with everything else unlike the defaults.
fn twelve_segments() -> Design {
    let mut design = example("2RO").expect("2RO");
    design.title = "Leva de doce tramos, grupo nº 3".to_owned();
    design.speed = crate::Speed { value: 1450.0, unit: crate::SpeedUnit::RevolutionsPerMinute };
    design.base_radius = 42.5;
    design.values = [12.5, 87.25, 95.5, 12.5];
    design.rotation = levalab_core::Rotation::Clockwise;
    design.segments = [
        ("half-cycloidal-start", 22.5, 3.25),
        ("constant-velocity", 22.5, 6.5),
        ("half-cycloidal-end", 22.5, 3.25),
        ("dwell", 37.5, 0.0),
        ("modified-trapezoidal", 42.5, -7.75),
        ("polynomial-4-5-6-7", 27.5, 12.35),
        ("polynomial-7", 33.25, -4.35),
        ("double-harmonic", 31.75, -5.25),
        ("half-harmonic-start", 28.5, -2.125),
        ("half-harmonic-end", 28.5, -2.125),
        ("scca", 33.5, -3.75),
        ("dwell", 29.5, 0.0),
    ]
    .map(|(id, beta, rise)| segment(id, beta, rise))
    .into();
    design
}

/// A link with any fields, whole as far as its checksum tells.
fn sealed(covered: &str) -> String {
    format!("{covered}.{}", super::checksum(covered))
}

#[test]
fn a_link_reads_like_the_design() {
    let link = encode(&example("9RT").expect("9RT")).expect("short");
    assert!(link.starts_with("1.Example_9RT.R35_7M50_10D40C50-10D40Q50_10D40S50-10D40."), "{link}");
    let link = encode(&example("R5").expect("R5")).expect("short");
    assert!(link.starts_with("1.Example_R5.R40_10w390mD70P100_22D30P160-22."), "{link}");
}

#[test]
fn twelve_segments_fit_a_qr_code_seen_from_the_back_row() {
    let design = twelve_segments();
    let link = encode(&design).expect("short");
    assert!(link.len() <= 230, "{} characters: {link}", link.len());
    assert!(link.len() <= 200, "{} characters, and it was less: {link}", link.len());
    assert_eq!(decode(&link), Ok(design));
    assert!(encode(&example("12PO").expect("12PO")).expect("short").len() < 75);
}

#[test]
fn published_links_keep_opening() {
    let published = include_str!("../../tests/published-links.txt");
    for line in published.lines() {
        let (name, link) = line.split_once(' ').expect("a name and a link");
        assert_eq!(decode(link), Ok(published_design(name)), "{name}");
    }
    let in_version_one = |law: &&&Law| law_label(law).is_some_and(|label| label.since == Version::One);
    for law in levalab_core::LAWS.iter().filter(in_version_one) {
        let named = |line: &str| line.split_once(' ').is_some_and(|(name, _)| uses(&published_design(name), law));
        assert!(published.lines().any(named), "no published link has the law {}", law.id);
    }
}

/// An example, or a line of the designs that were published to hold what no example has; after a `+`, told in another notation.
fn published_design(name: &str) -> Design {
    if let Some((name, notation)) = name.split_once('+') {
        let notation = Notation::of_word(notation).expect(notation);
        return Design { notation, ..published_design(name) };
    }
    let designs: serde_json::Value =
        serde_json::from_str(include_str!("../../tests/published-designs.json")).expect("JSON");
    let own = designs.get(name).map(|design| Design::from_value(design).expect(name));
    own.unwrap_or_else(|| example(name).expect(name))
}

fn uses(design: &Design, law: &Law) -> bool {
    design.segments.iter().any(|segment| segment.law == law)
}

#[test]
fn a_design_too_long_for_a_link_says_so() {
    let mut design = example("9RT").expect("9RT");
    design.segments =
        (0..64).map(|k| segment("scca", 360.0 / 64.0, if k % 2 == 0 { 1.0 / 3.0 } else { -1.0 / 3.0 })).collect();
    for segment in &mut design.segments {
        segment.parameters = [1.0 / 7.0, 1.0 / 3.0, 0.0];
    }
    let refusal = encode(&design).expect_err("too long");
    assert!(refusal.found > MAX_LINK_MADE && refusal.limit == MAX_LINK_MADE);
    assert_eq!(decode(&super::write(&design)), Ok(design), "it opens all the same");
}

#[test]
fn each_refusal_has_its_own_reason() {
    let good = encode(&example("9RT").expect("9RT")).expect("short");
    assert_eq!(decode(""), Err(LinkError::Empty));
    assert!(matches!(decode(&"1".repeat(MAX_LINK_OPENED + 1)), Err(LinkError::TooLong(_))));
    assert_eq!(decode("1.á"), Err(LinkError::Character { found: 'á', position: 3 }));
    assert_eq!(decode(&good[..good.len() - 1]), Err(LinkError::Damaged));
    assert_eq!(decode(&good.replace("R35", "R36")), Err(LinkError::Damaged));
    assert_eq!(decode(&sealed("2.anything")), Err(LinkError::Version { found: "2".to_owned() }));
    assert_eq!(decode(&sealed("1.a.Z35D360")), Err(LinkError::Unreadable));
    assert_eq!(decode(&sealed("1.a")), Err(LinkError::Unreadable));
    let refused = decode(&sealed("1.a.R35_7D350")).expect_err("ten degrees short");
    assert!(
        matches!(refused, LinkError::Design(error) if error.problem == Problem::Program(ProgramRefusal::Turn { found: 350.0, whole: 360.0, measure: crate::Measure::Degrees }))
    );
    let many = "D5.625".repeat(65);
    let refused = decode(&sealed(&format!("1.a.R35_7{many}"))).expect_err("too many");
    assert!(
        matches!(refused, LinkError::Design(error) if matches!(error.problem, Problem::Program(ProgramRefusal::TooManySegments { .. })))
    );
}

#[test]
fn another_spelling_of_a_design_is_refused() {
    assert!(decode(&sealed("1.a.R35_7D360")).is_ok());
    for fields in [
        "a.R35.0_7D360",
        "a.R035_7D360",
        "a.R35_7_0D360",
        "a.R35_7w1D360",
        "a.R35_7D360_0",
        "a.R35e0_7D360",
        "-1b.R35_7D360",
    ] {
        assert_eq!(decode(&sealed(&format!("1.{fields}"))), Err(LinkError::Unreadable), "{fields}");
    }
}

#[test]
fn numbers_out_of_range_are_refused() {
    for fields in ["a.R1e999_7D360", "a.R0_7D360", "a.R35_7w1e99D360", "a.R35_7C360_1e9"] {
        assert!(matches!(decode(&sealed(&format!("1.{fields}"))), Err(LinkError::Design(_))), "{fields}");
    }
}

#[test]
fn a_link_is_found_within_what_people_paste() {
    for text in ["1.a.b", "#1.a.b", " 1.a.b\n", "https://example.org/cams/#1.a.b", "file:///C:/cams/index.html?x#1.a.b"]
    {
        assert_eq!(within(text), "1.a.b");
    }
}

proptest! {
    #[test]
    fn every_design_comes_back_from_its_link_and_its_file(seed in any::<u64>()) {
        let design = testing::design(&mut Random::new(seed));
        let link = super::write(&design);
        prop_assert!(link.chars().all(super::is_of_a_link) && link.ends_with(|c: char| c.is_ascii_alphanumeric()));
        prop_assert_eq!(decode(&link), Ok(design.clone()), "{}", link);
        prop_assert_eq!(Design::from_json(&design.to_json()), Ok(design.clone()));
        prop_assert_eq!(Design::from_value(&design.to_value()), Ok(design));
    }

    #[test]
    fn any_text_is_refused_and_not_a_panic(text in "(1\\.)?[A-Za-z0-9._-]{0,80}", seal in any::<bool>()) {
        let link = if seal { sealed(&text) } else { text };
        if let Ok(design) = decode(&link) {
            prop_assert_eq!(encode(&design), Ok(link));
        }
    }
}
