//! Many random designs, broken designs and damaged links of both versions, in search of one that panics, gives a NaN or opens as another design.
//!
//! `LEVALAB_SOAK` says how many of each; `cargo xtask soak` runs it optimised. The seed is fixed, so a failure can be repeated.

use levalab_core::{Analysis, Cam, Finding};
use levalab_format::link::{self, LinkError};
use levalab_format::report::{Report, columns};
use levalab_format::testing::{self, Random};
use levalab_format::{Design, cures};
use serde_json::{Value, json};

/// How many, unless told otherwise; fewer where nothing is optimised, so that it stays a matter of seconds.
const COUNT: usize = if cfg!(debug_assertions) { 20_000 } else { 100_000 };

/// One accepted design in so many is analysed: an analysis costs more than everything else together.
const ANALYSED: usize = 4;

/// One analysed design in so many is cured as well, which is hundreds of analyses.
const CURED: usize = 500;

/// Rows of the analyses: the verdict looks closely whatever they are.
const STEPS: usize = 24;

fn count() -> usize {
    std::env::var("LEVALAB_SOAK").map_or(COUNT, |text| text.parse().expect("LEVALAB_SOAK is a number"))
}

/// Everything that an accepted design goes through.
fn live(design: &Design, random: &mut Random) {
    assert_eq!(Design::from_json(&design.to_json()).as_ref(), Ok(design), "the file gives it back");
    if let Ok(text) = link::encode(design) {
        assert_eq!(link::decode(&text).as_ref(), Ok(design), "{text} gives it back");
    }
    if random.once_in(ANALYSED) {
        analyse(design, random.once_in(CURED));
    }
}

fn analyse(design: &Design, and_cure: bool) {
    let cam = design.cam().unwrap_or_else(|error| panic!("{error}\n{}", design.to_json()));
    let second = design.second(&cam).unwrap_or_else(|error| panic!("{error}\n{}", design.to_json()));
    for cam in std::iter::once(cam).chain(second) {
        analyse_cam(design, &cam, and_cure);
    }
}

fn analyse_cam(design: &Design, cam: &Cam, and_cure: bool) {
    let analysis = Analysis::of(cam, STEPS);
    let told = || format!("\n{}", design.to_json());
    for (name, values) in columns(design, &analysis) {
        assert_eq!(values.len(), STEPS + 1);
        assert!(values.iter().all(|value| !value.is_nan()), "{name} has no NaN{}", told());
    }
    let report = Report::of(design, cam, &analysis);
    for (name, range) in &report.summary {
        let figures = [range.min, range.min_at, range.max, range.max_at];
        assert!(figures.iter().all(|figure| !figure.is_nan()), "{name} {range:?}{}", told());
        assert!(range.min <= range.max, "{name} {range:?}{}", told());
    }
    let figures = |finding: &Finding| [finding.theta, finding.value, finding.limit];
    assert!(analysis.findings.iter().flat_map(figures).all(f64::is_finite), "{:?}{}", analysis.findings, told());
    if and_cure {
        assert_eq!(cures(design, cam, &analysis).len(), analysis.findings.len());
    }
}

/// A design file with something wrong in it, most of the time.
fn broken_file(design: &Design, random: &mut Random) -> Vec<u8> {
    if random.once_in(3) {
        let mut bytes = design.to_json().into_bytes();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            match random.below(4) {
                0 => bytes[at] = random.bits() as u8,
                1 => bytes.insert(at, *random.pick(b"\"{}[],:-+.eE019 \\u\n\xff")),
                2 if bytes.len() > 1 => drop(bytes.remove(at)),
                _ => bytes.truncate(at.max(1)),
            }
        }
        return bytes;
    }
    let mut value = design.to_value();
    for _ in 0..=random.below(3) {
        break_somewhere(&mut value, random);
    }
    value.to_string().into_bytes()
}

/// Replaces, removes, repeats or adds something at a random depth.
fn break_somewhere(value: &mut Value, random: &mut Random) {
    if random.once_in(6) {
        *value = anything(random);
        return;
    }
    match value {
        Value::Object(fields) if !fields.is_empty() => {
            let key = fields.keys().nth(random.below(fields.len())).cloned().unwrap_or_default();
            match random.below(12) {
                0 => drop(fields.remove(&key)),
                1 => drop(fields.insert("something".to_owned(), anything(random))),
                _ => fields.get_mut(&key).into_iter().for_each(|field| break_somewhere(field, random)),
            }
        }
        Value::Array(items) if !items.is_empty() => {
            let at = random.below(items.len());
            match random.below(12) {
                0 => drop(items.remove(at)),
                1 => {
                    let copy = items[random.below(items.len())].clone();
                    items.insert(at, copy);
                }
                2 => items.swap(at, 0),
                _ => break_somewhere(&mut items[at], random),
            }
        }
        leaf => *leaf = anything(random),
    }
}

fn anything(random: &mut Random) -> Value {
    let numbers =
        [0.0, -0.0, 1.0, -1.0, 5e-324, 1e-9, 1e-6, 1e6, 1e9, 1e308, -1e308, 360.0, 180.0, 90.0, 0.001, 1e-300];
    match random.below(10) {
        0 => Value::Null,
        1 => json!(true),
        2 => json!("cycloidal"),
        3 => json!("\u{202e}\n\0"),
        4 => json!([]),
        5 => json!({}),
        6 => json!(u64::MAX),
        7 => json!(random.between(-500.0, 500.0)),
        _ => json!(*random.pick(&numbers)),
    }
}

/// A design with some of its numbers at the ends of their ranges; still closed, so that many are accepted.
fn extreme(random: &mut Random) -> Design {
    let mut design = testing::design(random);
    let sizes = [1e-6, 1e-3, 1.0, 1e3, 1e6];
    if random.once_in(2) {
        design.base_radius = *random.pick(&sizes);
    }
    let used = design.follower.parameters.len();
    for value in &mut design.values[..used] {
        if random.once_in(3) {
            *value = *random.pick(&sizes) * *random.pick(&[1.0, -1.0]);
        }
    }
    let scale = *random.pick(&[1e-300, 1e-12, 1e-6, 1.0, 1.0, 1e4]);
    for segment in &mut design.segments {
        segment.rise *= scale;
    }
    if let [first, .., last] = design.segments.as_mut_slice() {
        let sliver = *random.pick(&[0.001, 0.001, 0.0011, 0.1]);
        if random.once_in(2) && first.beta > sliver {
            (first.beta, last.beta) = (sliver, last.beta + (first.beta - sliver));
        }
    }
    design
}

/// A link damaged as links are: characters changed, lost, doubled, swapped, cut off, or in the other case.
fn damaged(good: &str, random: &mut Random) -> String {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";
    let mut link = good.as_bytes().to_vec();
    for _ in 0..=random.below(3) / 2 {
        let at = random.below(link.len());
        match random.below(7) {
            0 | 1 => link[at] = *random.pick(LETTERS),
            2 => link.insert(at, *random.pick(LETTERS)),
            3 if link.len() > 1 => drop(link.remove(at)),
            4 => {
                let next = (at + 1).min(link.len() - 1);
                link.swap(at, next);
            }
            5 => link.truncate(at.max(1)),
            _ if link[at].is_ascii_lowercase() => link[at].make_ascii_uppercase(),
            _ => link[at].make_ascii_lowercase(),
        }
    }
    String::from_utf8(link).expect("ASCII")
}

#[test]
fn good_designs_live() {
    let mut random = Random::new(2);
    for _ in 0..count() {
        let design = testing::design(&mut random);
        live(&design, &mut random);
    }
}

#[test]
fn broken_designs_are_refused_or_live() {
    let mut random = Random::new(3);
    let mut accepted = 0;
    for _ in 0..count() {
        let design = testing::design(&mut random);
        if let Ok(design) = Design::from_bytes(&broken_file(&design, &mut random)) {
            live(&design, &mut random);
            accepted += 1;
        }
    }
    assert!(accepted > count() / 1000, "some are only changed: {accepted}");
}

#[test]
fn designs_at_the_ends_of_their_ranges_are_refused_or_live() {
    let mut random = Random::new(4);
    let mut accepted = 0;
    for _ in 0..count() {
        let design = extreme(&mut random);
        if design.cam().is_ok() {
            live(&design, &mut random);
            accepted += 1;
        }
    }
    assert!(accepted > count() / 10, "many can be: {accepted}");
}

#[test]
fn no_damaged_link_opens_as_another_design() {
    damage(5, "1.", testing::design, 100);
}

#[test]
fn no_damaged_link_of_version_2_opens_as_another_design() {
    damage(6, "2.", testing::long_design, 1000);
}

/// Damages links that begin so, of designs made at random, each so many times. A damaged link is refused, or repaired as the link that
/// it was.
fn damage(seed: u64, beginning: &str, make: fn(&mut Random) -> Design, times: usize) {
    let mut random = Random::new(seed);
    let (mut refused, mut repaired, mut done) = (0, 0, 0);
    while done < count() {
        let design = make(&mut random);
        let Ok(good) = link::encode(&design) else { continue };
        if !good.starts_with(beginning) {
            continue;
        }
        for _ in 0..times.min(count() - done) {
            let bad = damaged(&good, &mut random);
            match link::open(&bad) {
                Ok(opened) => {
                    assert_eq!((&opened.link, &opened.design), (&good, &design), "{bad} opens as another link");
                    repaired += usize::from(bad != good);
                }
                Err(LinkError::Empty | LinkError::TooLong(_) | LinkError::Character { .. } | LinkError::Damaged) => {
                    refused += 1;
                }
                Err(error) => panic!("{bad} passes for whole, and was {good}: {error:?}"),
            }
            done += 1;
        }
    }
    assert!(refused > count() * 9 / 10, "most damage is damage: {refused}");
    println!("{done} damaged links of version {beginning} {refused} refused, {repaired} opened as what they were");
}
