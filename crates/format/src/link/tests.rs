//! Claims about links.

use super::{LinkError, decode, encode, open};
use crate::limits::{MAX_LINK_MADE, MAX_LINK_OPENED};
use crate::testing::{self, Random};
use crate::{DataRefusal, Design, Notation, Problem, ProgramRefusal, SegmentDesign, Version, example};
use levalab_catalogue::law_label;
use levalab_core::Law;
use levalab_core::law::Data;
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
    assert_eq!(decode(&super::write(&design, design.version(), None)), Ok(design), "it opens all the same");
}

#[test]
fn each_refusal_has_its_own_reason() {
    let good = encode(&example("9RT").expect("9RT")).expect("short");
    assert_eq!(decode(""), Err(LinkError::Empty));
    assert!(matches!(decode(&"1".repeat(MAX_LINK_OPENED + 1)), Err(LinkError::TooLong(_))));
    assert_eq!(decode("1.á"), Err(LinkError::Character { found: 'á', position: 3 }));
    assert_eq!(decode(&good[..good.len() - 1]), Err(LinkError::Damaged));
    assert_eq!(decode(&good.replace("R35", "R36")), Err(LinkError::Damaged));
    assert_eq!(decode(&sealed("3.anything")), Err(LinkError::Version { found: "3".to_owned() }));
    assert_eq!(decode(&sealed("3.~other characters")), Err(LinkError::Version { found: "3".to_owned() }));
    assert_eq!(decode(&sealed("1.~a")), Err(LinkError::Character { found: '~', position: 3 }));
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

/// The example 9RT with one table for all of its segments.
fn tabled(points: Vec<[f64; 2]>) -> Design {
    let mut design = example("9RT").expect("9RT");
    design.title = "Measured cam".to_owned();
    let table = SegmentDesign { data: Data::Points(points), ..segment("table", 360.0, 0.0) };
    design.segments = vec![table];
    design
}

/// A cosine in steps of a degree, with some noise, at four decimals.
fn degree_by_degree(noise: f64) -> Vec<[f64; 2]> {
    let mut random = Random::new(1);
    let point = |k: u32| {
        let s = 12.5 * (1.0 - f64::from(k).to_radians().cos()) + random.between(0.0, noise);
        [f64::from(k), if k.is_multiple_of(360) { 0.0 } else { (s * 1e4).round() / 1e4 }]
    };
    (0..=360).map(point).collect()
}

#[test]
fn a_table_of_361_points_is_shared_by_a_link_that_a_qr_code_carries() {
    // A QR code of version 40 carries 2,953 bytes at level L.
    const QR_CODE: usize = 2953;
    for noise in [0.0, 0.001, 0.02] {
        let design = tabled(degree_by_degree(noise));
        let link = encode(&design).expect("short");
        assert!(link.starts_with("2.Measured-scam.R35-p7L360.t"), "{link}");
        assert!(link.len() <= 1800, "{} characters with noise of {noise}", link.len());
        let address = format!("https://levalab.example.org/cams/#{link}");
        assert!(address.len() <= QR_CODE);
        assert_eq!(open(&address).map(|opened| opened.design), Ok(design), "{link}");
    }
}

#[test]
fn the_links_of_the_documentation_are_published_ones() {
    let published = include_str!("../../tests/published-links.txt");
    let text = include_str!("../../../../docs/design-format.md");
    let links: Vec<&str> = text.lines().filter(|line| line.starts_with("1.") || line.starts_with("2.")).collect();
    assert_eq!(links.iter().map(|link| &link[..2]).collect::<Vec<_>>(), ["1.", "2."]);
    for link in links {
        assert!(published.lines().any(|line| line.ends_with(&format!(" {link}"))), "{link}");
    }
}

#[test]
fn version_1_is_written_whenever_it_can_say_the_design() {
    let design = tabled(degree_by_degree(0.0).into_iter().step_by(10).collect());
    let link = encode(&design).expect("short");
    assert!(link.starts_with("1.Measured_cam.R35_7L360p0p10_.1899p20"), "{link}");
    let second = super::write(&design, Version::Two, None);
    assert!(second.starts_with("2.Measured-scam.R35-p7L360.t"), "{second}");
    assert_eq!(decode(&second), Err(LinkError::Unreadable), "one design, one link");
}

#[test]
fn a_design_that_is_too_long_for_version_1_has_a_link_of_version_2() {
    let mut points = degree_by_degree(0.0);
    points.truncate(121);
    for (k, point) in points.iter_mut().enumerate() {
        *point = [3.0 * k as f64, if k == 0 || k == 120 { 0.0 } else { point[1] + 1e-11 * k as f64 + 0.123_456_789 }];
        point[1] = (point[1] * 1e11).round() / 1e11;
    }
    let design = tabled(points);
    assert_eq!(design.version(), Version::One, "its file is of version 1");
    let first = super::write(&design, Version::One, None);
    assert!(first.len() > MAX_LINK_MADE, "{}", first.len());
    let link = encode(&design).expect("short");
    assert!(link.starts_with("2.") && link.len() < 1000, "{link}");
    assert_eq!(decode(&link).as_ref(), Ok(&design));
    assert_eq!(decode(&first), Ok(design), "links of version 1 open as they did");
}

#[test]
fn a_table_too_long_for_version_1_is_refused_there_as_it_was() {
    let text = super::write(&tabled(degree_by_degree(0.0)), Version::One, None);
    let refused = decode(&text).expect_err("361 points");
    let expected = Problem::Data(DataRefusal::WrongCount { found: 361, min: 2, max: 128 });
    assert!(matches!(&refused, LinkError::Design(error) if error.problem == expected), "{refused:?}");
}

#[test]
fn the_packing_of_a_table_may_change_but_nothing_else() {
    let design = tabled(degree_by_degree(0.001));
    let link = encode(&design).expect("short");
    let (fields, _) = link.rsplit_once('.').expect("a checksum");
    let (fields, body) = fields.rsplit_once(".t").expect("a section");
    let bytes = super::tables::unpack(body).expect("packed");
    let stored =
        [[1, bytes.len() as u8, (bytes.len() >> 8) as u8].as_slice(), &(!bytes.len() as u16).to_le_bytes(), &bytes]
            .concat();
    let other = super::base_62::to_base_62(&stored);
    assert_eq!(decode(&sealed(&format!("{fields}.t{other}"))), Ok(design), "the same bytes, not packed at all");

    for broken in [
        format!("{fields}.t{body}0"),
        format!("{fields}.t"),
        format!("{fields}.t{body}.t{body}"),
        format!("{fields}L90.t{body}"),
        fields.to_owned(),
        format!("{fields}.t{}", super::tables::pack(&[bytes.as_slice(), &bytes].concat())),
        format!("{fields}.t{}", super::tables::pack(&bytes[..bytes.len() - 1])),
        format!("{}.t{body}", fields.replace("-s", "_")),
        format!("{}.t{body}", fields.replace("-s", "-0W")),
        format!("{}.t{body}", fields.replace("-p7", "_7")),
    ] {
        let refused = decode(&sealed(&broken)).expect_err(&broken);
        assert!(matches!(refused, LinkError::Unreadable | LinkError::Design(_)), "{refused:?}: {broken}");
    }
}

#[test]
fn what_only_a_newer_program_knows_is_said_to_be_newer() {
    let link = encode(&tabled(degree_by_degree(0.0))).expect("short");
    let (covered, _) = link.rsplit_once('.').expect("a checksum");
    let (fields, tables) = covered.split_once(".t").expect("a section");
    for (text, part) in [
        (format!("{fields}.d.5x-p3.t{tables}"), "d"),
        (format!("{covered}.z"), "z"),
        (covered.replace("L360", "Zz360"), "Zz"),
        (covered.replace(".R35", ".Y35"), "Y"),
    ] {
        assert_eq!(decode(&sealed(&text)), Err(LinkError::Newer { found: part.to_owned() }), "{text}");
    }
    assert_eq!(decode(&sealed("1.a.Y35_7D360")), Err(LinkError::Unreadable), "version 1 has no newer parts");
    assert_eq!(decode(&sealed("1.a.R35_7D360.z")), Err(LinkError::Unreadable));
    assert_eq!(decode(&sealed("2.a.R35-p7D360.")), Err(LinkError::Unreadable));
    assert_eq!(decode(&sealed("2.a.R35-p7D360.T1")), Err(LinkError::Unreadable));
}

#[test]
fn a_pair_whose_arms_stand_at_a_negative_angle_comes_back() {
    let mut design = example("4PO").expect("4PO");
    design.conjugate = Some(crate::Conjugate { tie: levalab_core::Tie::Angle(-5.6), radius: None });
    let link = super::write(&design, Version::One, None);
    assert!(link.contains("ka-5.6C"), "{link}");
    let fields = link.strip_prefix("1.").and_then(|rest| rest.rsplit_once('.')).expect("sealed fields").0;
    let back = super::reader::read(fields, Version::One).map(|contents| contents.design.conjugate);
    assert_eq!(back, Ok(design.conjugate), "{link}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn every_design_with_a_long_table_comes_back_from_its_link_and_its_file(seed in any::<u64>()) {
        let design = testing::long_design(&mut Random::new(seed));
        let link = super::write(&design, Version::Two, None);
        prop_assert!(link.starts_with("2.") && !link.contains('_'));
        if link.len() <= MAX_LINK_OPENED {
            prop_assert_eq!(decode(&link), Ok(design.clone()), "{}", link);
        }
        prop_assert_eq!(Design::from_json(&design.to_json()), Ok(design));
    }

}

proptest! {
    #[test]
    fn any_sealed_text_of_version_2_is_refused_and_not_a_panic(
        text in "2\\.[a-z-]{0,3}\\.(R35-p7|A1e3|O2-3)[a-z0-9.-]{0,9}(L360|F9fx\\.|D360|C1-p2)?(\\.t[A-Za-z0-9]{0,30}){0,2}",
    ) {
        let link = sealed(&text);
        if let Ok(design) = decode(&link) {
            prop_assert_eq!(encode(&design), Ok(link));
        }
    }

    #[test]
    fn every_design_comes_back_from_its_link_and_its_file(seed in any::<u64>()) {
        let design = testing::design(&mut Random::new(seed));
        let link = super::write(&design, design.version(), None);
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
