//! Every offered cure, applied to random designs: it keeps what the design is for, cures what it says, and is of a believable size.
//!
//! `LEVALAB_SOAK` says how many designs are tried; the seed is fixed, so that a failure can be repeated.

use levalab_core::law::Data;
use levalab_core::{Analysis, Body, Cam, Extremes, FindingKind};
use levalab_format::testing::{self, Random};
use levalab_format::{CamKind, CureJob, Design, DesignCure, Remedy, SegmentDesign, apply, cures};

/// How many designs, unless the environment says otherwise.
const COUNT: usize = 500;

/// The lift and the heights may differ by this part of the lift, which is the rounding of radians and degrees.
const HEIGHT_TOLERANCE: f64 = 1e-9;

/// Where a curve rises above the heights at its borders, by this part of the lift more or less.
const OVERSHOOT: f64 = 0.05;

/// A size may exceed its limit by this part, since it is rounded to four digits.
const ROUNDED: f64 = 1e-3;

/// A size is believable up to this many times the base radius and the lift.
const BELIEVABLE: f64 = 5.0;

fn count() -> usize {
    std::env::var("LEVALAB_SOAK").map_or(COUNT, |text| text.parse().expect("LEVALAB_SOAK is a number"))
}

/// The base radius (or the travel) and the lift as a length.
fn reach(design: &Design, cam: &Cam, s: &Extremes) -> f64 {
    let lever = match cam.follower.body() {
        Body::Slide => 1.0,
        Body::Swing { pivot } => cam.follower.value("arm").unwrap_or(pivot.norm()),
    };
    design.kind.travel().unwrap_or(design.base_radius) + (s.max - s.min) * lever
}

/// A segment that a cure must leave alone: at rest, of constant velocity, or drawn from the user's data.
fn is_datum(segment: &SegmentDesign) -> bool {
    segment.law.is_dwell() || segment.law.id == "constant-velocity" || segment.data != Data::None
}

/// What each size in a remedy may be at most, with what it is.
fn sizes(design: &Design, remedy: &Remedy) -> Vec<f64> {
    match remedy {
        Remedy::BaseRadius { value, .. } => {
            assert!(design.kind.travel().is_none());
            vec![*value]
        }
        Remedy::Travel { value } | Remedy::Length { value, .. } => vec![*value],
        Remedy::Tie { tie, .. } => match tie {
            levalab_core::Tie::Angle(_) => Vec::new(),
            other => vec![other.value()],
        },
        _ => Vec::new(),
    }
}

struct Patient<'a> {
    design: &'a Design,
    first: &'a Cam,
    first_analysis: &'a Analysis,
    of_second: bool,
}

impl Patient<'_> {
    fn check(&self, kind: FindingKind, value: f64, cure: &DesignCure) {
        let told = || format!("{kind:?} cured by {:?}\n{}", cure.remedy, self.design.to_json());
        if let Remedy::NoSize { .. } = cure.remedy {
            assert!(cure.edits.is_empty(), "{}", told());
            return;
        }
        let after = apply(self.design, &cure.edits).unwrap_or_else(|error| panic!("{error} {}", told()));
        let cam = after.cam().unwrap_or_else(|error| panic!("{error} {}", told()));
        let analysis = Analysis::of(&cam, 1);
        self.keeps(&after, &cam, &analysis, &told());
        let judged = if self.of_second {
            let second = after.second(&cam).unwrap_or_else(|error| panic!("{error} {}", told()));
            Analysis::of(&second.expect("the second cam stays"), 1)
        } else {
            analysis
        };
        let left = judged.findings.iter().find(|finding| finding.kind == kind);
        let eased = matches!(cure.remedy, Remedy::Eccentricity { .. }) && left.is_some_and(|left| left.value < value);
        assert!(left.is_none() || eased, "leaves {left:?}: {}", told());
        let reach = reach(self.design, self.first, &self.first_analysis.summary.s);
        for size in sizes(self.design, &cure.remedy) {
            assert!(size > 0.0 && size <= BELIEVABLE * reach * (1.0 + ROUNDED), "{size} beside {reach}: {}", told());
            if let Remedy::BaseRadius { .. } = cure.remedy {
                let roller = self.first.follower.value("roller_radius").unwrap_or(0.0);
                assert!(size >= roller, "{size} under a roller of {roller}: {}", told());
            }
        }
    }

    /// Lift, heights at the borders, dwells, constant velocities and data are those of the design.
    fn keeps(&self, after: &Design, cam: &Cam, analysis: &Analysis, told: &str) {
        let lift = self.first_analysis.summary.s.max;
        let near = |a: f64, b: f64| (a - b).abs() <= HEIGHT_TOLERANCE * lift.abs();
        let highest = self.first.program.heights().iter().copied().fold(0.0, f64::max);
        // Only where a curve already rises above the heights at its borders may another rise above them differently.
        let overshoot =
            lift > highest && !near(lift, highest) && (analysis.summary.s.max / lift - 1.0).abs() < OVERSHOOT;
        assert!(
            near(analysis.summary.s.max, lift) || overshoot,
            "the lift {lift} becomes {}: {told}",
            analysis.summary.s.max
        );
        let (before, now) = (self.first.program.heights(), cam.program.heights());
        assert_eq!(before.len(), now.len(), "{told}");
        assert!(before.iter().zip(now).all(|(a, b)| near(*a, *b)), "heights {before:?} become {now:?}: {told}");
        for (old, new) in self.design.segments.iter().zip(&after.segments) {
            let stretched = matches!(self.design.kind, CamKind::Translating { .. });
            assert!(old.beta == new.beta || stretched, "{told}");
            if is_datum(old) {
                assert!(old.law == new.law && (old.data == new.data || stretched), "{} changes: {told}", old.law.id);
            }
        }
    }
}

#[test]
fn every_cure_of_a_random_design_keeps_its_job_and_cures_what_it_says() {
    let mut random = Random::new(13);
    let (mut tried, mut offered) = (0, [0_usize; 7]);
    while tried < count() {
        let design = testing::design(&mut random);
        let Ok(first) = design.cam() else { continue };
        let Ok(second) = design.second(&first) else { continue };
        tried += 1;
        let first_analysis = Analysis::of(&first, 1);
        let patient =
            |of_second| Patient { design: &design, first: &first, first_analysis: &first_analysis, of_second };
        let mut all = |cam: &Cam, analysis: &Analysis, of_second: bool| {
            for (finding, cures) in analysis.findings.iter().zip(cures(&design, cam, analysis)) {
                for cure in &cures {
                    patient(of_second).check(finding.kind, finding.value, cure);
                    offered[kind_of(&cure.remedy)] += 1;
                }
            }
        };
        all(&first, &first_analysis, false);
        if let Some(second) = second {
            all(&second, &Analysis::of(&second, 1), true);
        }
    }
    println!("size, travel, tie, eccentricity, laws, length, advice: {offered:?}");
    assert!(offered.iter().all(|&count| count > 0), "every kind of cure is tried: {offered:?}");
}

fn kind_of(remedy: &Remedy) -> usize {
    match remedy {
        Remedy::BaseRadius { .. } => 0,
        Remedy::Travel { .. } => 1,
        Remedy::Tie { .. } => 2,
        Remedy::Eccentricity { .. } => 3,
        Remedy::Laws { .. } => 4,
        Remedy::Length { .. } => 5,
        Remedy::NoSize { .. } => 6,
    }
}

/// A design file of a translating roller with the given segments.
fn with_segments(segments: &str) -> Design {
    let text = format!(
        r#"{{"format":"levalab/1","cam":{{"kind":"rotating","base_radius":40}},
            "follower":{{"motion":"translating","contact":"roller","roller_radius":10}},"segments":[{segments}]}}"#
    );
    Design::from_json(&text).expect("a design")
}

fn cures_of(design: &Design) -> (Analysis, Vec<Vec<DesignCure>>) {
    let cam = design.cam().expect("a cam");
    let analysis = Analysis::of(&cam, 1);
    let cures = cures(design, &cam, &analysis);
    (analysis, cures)
}

#[test]
fn no_cure_takes_away_the_lift_of_a_formula() {
    // v jumps at 0°; constant velocity with no rise would cure that, and move nothing.
    let design = with_segments(r#"{"law":"formula","beta":360,"expression":"40x(1-x)"}"#);
    let (analysis, cures) = cures_of(&design);
    assert_eq!(analysis.findings[0].kind, FindingKind::Jump(1));
    assert!(cures.iter().flatten().all(|cure| cure.edits.is_empty()), "{cures:?}");
}

#[test]
fn the_jerk_of_r1_is_cured_beside_its_constant_velocity_at_a_price() {
    let design = levalab_format::example("R1").expect("R1");
    let (analysis, cures) = cures_of(&design);
    let jerk = analysis.findings.iter().position(|finding| finding.kind == FindingKind::Jump(3)).expect("a jump");
    let Remedy::Laws { changes, remaining_jump: None, price } = &cures[jerk][0].remedy else { panic!("{cures:?}") };
    let told: Vec<(usize, &str)> = changes.iter().map(|(k, law)| (*k, law.id)).collect();
    assert_eq!(told, [(0, "polynomial-7"), (2, "polynomial-7")]);
    let (after, before) = price.pressure_angle.expect("φ rises");
    assert!((before - 31.8).abs() < 0.05 && (after - 36.0).abs() < 0.05, "{before} to {after}");
}

#[test]
fn neighbours_that_both_move_are_joined_by_a_polynomial_in_every_second_segment() {
    let pair = r#"{"law":"modified-trapezoidal","beta":45,"rise":5},{"law":"parabolic","beta":45,"rise":-5}"#;
    let design = with_segments(&[pair; 4].join(","));
    let (analysis, cures) = cures_of(&design);
    let jump = analysis.findings.iter().position(|finding| finding.kind == FindingKind::Jump(2)).expect("a jump");
    let Remedy::Laws { changes, .. } = &cures[jump][0].remedy else { panic!("{cures:?}") };
    assert!(changes.len() == 4 && changes.iter().all(|(k, law)| k % 2 == 1 && law.is_matched()), "{changes:?}");
}

#[test]
fn a_search_in_parts_offers_what_a_whole_one_does() {
    let mut most = 0;
    for name in ["R1", "9RT", "2RO", "4PO", "7CRT", "R4"] {
        let mut design = levalab_format::example(name).expect(name);
        if design.base_radius > 0.0 {
            design.base_radius = (design.base_radius * 0.6).ceil();
        }
        let Ok(cam) = design.cam() else { continue };
        let analysis = Analysis::of(&cam, 1);
        let mut job = CureJob::default();
        let mut parts = 1;
        let in_parts = loop {
            match job.step(&design, &cam, &analysis, 3) {
                Some(cures) => break cures,
                None => parts += 1,
            }
        };
        assert_eq!(in_parts, cures(&design, &cam, &analysis), "{name}");
        most = most.max(parts);
    }
    assert!(most > 10, "{most} parts are none");
}

#[test]
fn an_oscillating_follower_is_cured_by_its_arm_and_by_its_pivot_too() {
    let design = levalab_format::example("2RO").expect("2RO");
    let mut keys: Vec<&str> = Vec::new();
    for lift in [1.0, 1.5, 2.0, 2.5] {
        let mut steep = design.clone();
        steep.segments.iter_mut().for_each(|segment| segment.rise *= lift);
        let (_, cures) = cures_of(&steep);
        keys.extend(cures.iter().flatten().filter_map(|cure| match cure.remedy {
            Remedy::Length { key, .. } => Some(key),
            _ => None,
        }));
    }
    assert!(keys.contains(&"arm") && keys.contains(&"pivot_distance"), "{keys:?}");
}

#[test]
fn a_size_out_of_proportion_is_an_advice_and_no_cure() {
    let design = with_segments(
        r#"{"law":"cycloidal","beta":4,"rise":20},{"law":"dwell","beta":176},{"law":"cycloidal","beta":180,"rise":-20}"#,
    );
    let (analysis, cures) = cures_of(&design);
    let steep = analysis.findings.iter().position(|finding| finding.kind == FindingKind::PressureAngle).expect("steep");
    let sizes = cures[steep].iter().filter(|cure| matches!(cure.remedy, Remedy::BaseRadius { .. })).count();
    assert_eq!(sizes, 0, "{:?}", cures[steep]);
    assert!(matches!(cures[steep].last().map(|cure| &cure.remedy), Some(Remedy::NoSize { needed: Some(_), .. })));
}

/// The arm swings back in so few degrees that no length within reason helps.
#[test]
fn an_oscillating_follower_that_no_length_cures_is_advised() {
    let mut design = levalab_format::example("2RO").expect("2RO");
    design.segments.iter_mut().for_each(|segment| segment.rise *= 6.0);
    let (analysis, cures) = cures_of(&design);
    let steep = analysis.findings.iter().position(|finding| finding.kind == FindingKind::PressureAngle).expect("steep");
    assert!(matches!(cures[steep].last().map(|cure| &cure.remedy), Some(Remedy::NoSize { .. })), "{:?}", cures[steep]);
}

#[test]
fn a_change_that_leaves_a_jump_is_not_offered_at_the_price_of_one_that_leaves_none() {
    let link = "1.Example_7CRT.R85_10kd380P36_20P36-20P36_20P36-20P36_20P36-20P36_20P36-20P36_20P36-20.2sBf7P";
    let design = levalab_format::link::decode(link).expect("a link");
    let (_, cures) = cures_of(&design);
    assert!(cures.iter().flatten().count() > 0);
    for cures in cures {
        let told = cures.iter().filter_map(|cure| match &cure.remedy {
            Remedy::Laws { remaining_jump, price, .. } => Some((*remaining_jump, *price)),
            _ => None,
        });
        let told = told.collect::<Vec<_>>();
        for (_, price) in told.iter().filter(|(jump, _)| jump.is_some()) {
            let close = |one: f64| price.acceleration.is_some_and(|other| (one - other).abs() < 0.01);
            let smooth = told.iter().any(|(jump, other)| jump.is_none() && other.acceleration.is_some_and(close));
            assert!(!smooth, "{told:?}");
        }
    }
}

#[test]
fn the_number_of_looks_does_not_grow_with_the_number_of_segments() {
    // Every look at a cam is linear in its segments, so the whole search is.
    let looks = |count: usize| {
        let beta = 360.0 / count as f64;
        let part = |k: usize| {
            let rise = if k.is_multiple_of(2) { 5 } else { -5 };
            format!(r#"{{"law":"skewed-scca","beta":{beta},"rise":{rise},"b":0.25,"c":0.25,"crossover":0.4}}"#)
        };
        let design = with_segments(&(0..count).map(part).collect::<Vec<_>>().join(","));
        let cam = design.cam().expect("a cam");
        let analysis = Analysis::of(&cam, 1);
        // A sound cam needs no search for its size, so both must be steep.
        assert!(analysis.findings.iter().any(|finding| finding.kind == FindingKind::PressureAngle), "{count}");
        let mut job = CureJob::default();
        (1..).find(|_| job.step(&design, &cam, &analysis, 1).is_some()).expect("it ends")
    };
    let (few, many) = (looks(32), looks(64));
    assert!(many < 200 && 2 * many < 3 * few, "{few} looks for 32 segments, {many} for 64");
}
