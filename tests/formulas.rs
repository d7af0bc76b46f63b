//! Formulas: nothing smooth is called broken, nothing narrow is missed, and the verdict does not depend on the number of rows.
//!
//! `LEVALAB_SOAK` says how many random formulas are tried, and a tenth as many narrow features; `cargo xtask soak` runs them optimised.

#[path = "support/mod.rs"]
mod support;

use levalab_core::application::Application;
use levalab_core::law::Data;
use levalab_core::{Analysis, Cam, Finding, FindingKind, Law, Level, Program, Rotation, Segment};
use std::f64::consts::{PI, TAU};
use support::follower;

/// A formula over one turn, with the given follower on the given base circle.
fn cam(expression: &str, contact: &str, base_radius: f64, parameters: &[(&str, f64)]) -> Cam {
    let law = Law::by_id("formula").expect("it is one of the laws");
    let segment = Segment { data: Data::Expression(expression.to_owned()), ..Segment::new(law, TAU, 0.0) };
    let program = Program::new(&[segment]).unwrap_or_else(|error| panic!("{expression}: {error:?}"));
    Cam::new(program, follower(contact, base_radius, parameters, Rotation::CounterClockwise))
}

fn roller(expression: &str, base_radius: f64) -> Cam {
    cam(expression, "translating-roller", base_radius, &[("roller_radius", 10.0)])
}

fn is_close(found: f64, expected: f64, part: f64) -> bool {
    (found - expected).abs() <= part * expected.abs()
}

#[test]
fn any_number_of_lobes_is_smooth() {
    for lobes in 1..=48 {
        let analysis = Analysis::of(&roller(&format!("1-cos({lobes}θ)"), 4000.0), 720);
        assert_eq!(analysis.level, Level::Acceptable, "{lobes} lobes: {:?}", analysis.findings);
        let n = f64::from(lobes);
        for (found, order) in [(analysis.summary.v, 1), (analysis.summary.a, 2), (analysis.summary.j, 3)] {
            assert!(is_close(found.max, n.powi(order), 1e-12) && is_close(found.min, -n.powi(order), 1e-12));
        }
    }
}

#[test]
fn what_cancels_is_no_jump() {
    for text in ["5*(1-cos(θ))*(sin(40θ)^2+cos(40θ)^2)", "3*(1-cos(2θ))+7*(sin(9x)^2+cos(9x)^2-1)"] {
        let analysis = Analysis::of(&roller(text, 400.0), 720);
        assert!(analysis.joints.iter().all(|joint| joint.jump.is_none()), "{text}: {:?}", analysis.findings);
    }
}

#[test]
fn a_narrow_bump_is_found() {
    let analysis = Analysis::of(&roller("5*(1-cos(theta))+1*exp(-((theta-2.2034781806)/0.001)^2)", 40.0), 720);
    assert!(is_close(analysis.summary.a.min, -2.000_003e6, 1e-6), "{:?}", analysis.summary.a);
    assert!(is_close(analysis.summary.a.max, 892_517.7, 1e-6), "{:?}", analysis.summary.a);
    let angle = analysis.summary.pressure_angle.greatest_size().0.to_degrees();
    assert!((angle - 86.1128).abs() < 1e-3, "{angle}");
    let has = |kind: FindingKind| analysis.findings.iter().any(|finding| finding.kind == kind);
    assert!(has(FindingKind::Undercut) && has(FindingKind::PressureAngle), "{:?}", analysis.findings);
}

#[test]
fn a_steep_step_is_found() {
    let text = "5*(1-cos(theta))+2*(1+tanh(1000*(x-0.5007)))*(1+tanh(1000*(0.7-x)))";
    let coarse = Analysis::of(&roller(text, 60.0), 720);
    let fine = Analysis::of(&roller(text, 60.0), 720_000);
    assert!(coarse.summary.a.min <= fine.summary.a.min && is_close(coarse.summary.a.min, fine.summary.a.min, 1e-6));
    assert!(is_close(coarse.summary.j.max, fine.summary.j.max, 1e-6));
    assert_eq!(coarse.level, fine.level);
}

#[test]
fn a_ripple_has_its_true_peak() {
    let text = "5*(1-cos(theta))+2*sin(97*theta)^2*sin(theta)^2";
    let analysis = Analysis::of(&cam(text, "translating-flat", 600.0, &[]), 720);
    assert!(is_close(analysis.summary.a.max, 37_626.217, 1e-8), "{:?}", analysis.summary.a);
    assert!(analysis.findings.iter().all(|finding| !matches!(finding.kind, FindingKind::NotProved(_))));
}

#[test]
fn every_stroke_of_a_pump_counts() {
    let pump = Application::by_id("pump").expect("it is an application");
    for strokes in [1, 16, 32, 64, 96] {
        let cam = cam(&format!("5*(1-cos({strokes}*theta))"), "translating-flat", 60_000.0, &[]);
        let volume = pump.outputs[0].per_cycle(&[1.0, 0.0], &cam).expect("it works by strokes");
        assert!(is_close(volume, 10.0 * PI * f64::from(strokes), 1e-9), "{strokes} strokes: {volume}");
        assert_eq!(cam.program.stretches()[0].zeros(1).len(), 2 * strokes as usize - 1);
        let findings = Analysis::of(&cam, 720).findings;
        assert!(findings.iter().all(|finding| finding.kind == FindingKind::ConcaveFlat), "{findings:?}");
    }
}

/// Random numbers that can be repeated.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1 << 24) as f64 / f64::from(1 << 24)
    }
}

/// A random expression of x without poles, between −3 and 3 or so.
fn term(random: &mut Random, depth: usize) -> String {
    let number = |random: &mut Random| format!("{:.3}", random.between(0.2, 3.0));
    if depth == 0 {
        return match random.below(3) {
            0 => number(random),
            1 => "x".to_owned(),
            _ => format!("sin({}θ+{})", 1 + random.below(9), number(random)),
        };
    }
    let a = term(random, depth - 1);
    match random.below(8) {
        0 => format!("({a}+{})", term(random, depth - 1)),
        1 => format!("({a}-{})", term(random, depth - 1)),
        2 => format!("{a}*{}", term(random, depth - 1)),
        3 => format!("{a}/(1.5+({})^2)", term(random, depth - 1)),
        4 => format!("sin({}*{a})", number(random)),
        5 => format!("tanh({}*({a}))", number(random)),
        6 => format!("exp(-({a})^2)"),
        _ => format!("sqrt(1+({a})^2)"),
    }
}

/// How many to try: one in `part` of what `LEVALAB_SOAK` says, when it does.
fn count(usual: usize, part: usize) -> usize {
    std::env::var("LEVALAB_SOAK").map_or(usual, |text| text.parse::<usize>().expect("LEVALAB_SOAK is a number") / part)
}

fn is_unproved(finding: &Finding) -> bool {
    matches!(finding.kind, FindingKind::NotProved(_))
}

#[test]
fn the_verdict_on_random_formulas_does_not_depend_on_the_rows() {
    let (mut random, count) = (Random(3), count(500, 1));
    let mut unproved = Vec::new();
    for index in 0..count {
        let text = format!("4*(1-cos(θ))*(1+0.2*{})", term(&mut random, 3));
        let cam = roller(&text, random.between(30.0, 150.0));
        let coarse = Analysis::of(&cam, 720);
        if coarse.findings.iter().any(is_unproved) {
            unproved.push(text);
            continue;
        }
        // Where nothing is optimised, one in ten is looked at as closely as all of them are in the soak.
        let close = !cfg!(debug_assertions) || index % 10 == 0;
        let fine = Analysis::of(&cam, if close { 72_000 } else { 7_200 });
        assert_eq!(coarse.level, fine.level, "{text}: {:?} and {:?}", coarse.findings, fine.findings);
        let kinds = |analysis: &Analysis| analysis.findings.iter().map(|found| found.kind).collect::<Vec<_>>();
        assert_eq!(kinds(&coarse), kinds(&fine), "{text}");
        let pairs = [(coarse.summary.s, fine.summary.s), (coarse.summary.v, fine.summary.v)];
        for (few, many) in
            pairs.into_iter().chain([(coarse.summary.a, fine.summary.a), (coarse.summary.j, fine.summary.j)])
        {
            let error = 1e-6 * (many.max - many.min).abs();
            assert!(
                (few.max - many.max).abs() <= error && (few.min - many.min).abs() <= error,
                "{text}: {few:?} {many:?}"
            );
        }
    }
    assert!(unproved.len() * 1000 <= count, "{} of {count} are not proved: {unproved:#?}", unproved.len());
}

#[test]
fn an_undercut_between_two_samples_is_found_beside_others() {
    let text = "4*(1-cos(θ))*(1+0.2*tanh(1.055*(tanh(2.922*(sin(2.128*sin(5θ+2.037)))))))";
    let undercuts = |base_radius: f64, rows: usize| {
        let findings = Analysis::of(&roller(text, base_radius), rows).findings;
        findings.iter().filter(|found| found.kind == FindingKind::Undercut).count()
    };
    let mut compared = 0;
    for (low, high) in (30..100).map(|radius| (f64::from(radius), f64::from(radius) + 1.0)) {
        let (mut small, mut large) = (low, high);
        if undercuts(small, 720) == undercuts(large, 720) {
            continue;
        }
        // Where a stretch of undercut shrinks to nothing it is shorter than any step.
        for _ in 0..20 {
            let middle = 0.5 * (small + large);
            if undercuts(middle, 7_200) == undercuts(low, 7_200) { small = middle } else { large = middle }
        }
        for radius in [small - 1e-2, small - 1e-3, small - 1e-4, large + 1e-4] {
            assert_eq!(undercuts(radius, 720), undercuts(radius, 72_000), "base radius {radius}");
            compared += 1;
        }
    }
    assert!(compared > 0, "no stretch disappears");
}

#[test]
fn narrow_bumps_steps_and_ripples_are_found() {
    let (mut random, count) = (Random(5), count(150, 10));
    let mut found = 0;
    for _ in 0..count {
        let (at, width) = (random.between(0.05, 0.95), 10_f64.powf(random.between(-5.0, -2.5)));
        let height = random.between(0.2, 2.0);
        // The peak of |a| that the feature has alone, in units of length per radian squared.
        let per_radian = height / (width * TAU).powi(2);
        let (feature, peak) = match random.below(3) {
            0 => (format!("{height}*exp(-((x-{at})/{width})^2)"), 2.0 * per_radian),
            1 => (format!("{height}*(1+tanh((x-{at})/{width}))*(1-tanh((x-0.99)/{width}))/2"), 0.7698 * per_radian),
            _ => {
                let envelope = 8.0 * width;
                let wave = format!("sin((x-{at})/{width})*exp(-((x-{at})/{envelope})^2)");
                (format!("{height}*{wave}"), 0.9 * per_radian)
            }
        };
        let text = format!("5*(1-cos(θ))+{feature}*(1-cos(θ))");
        let analysis = Analysis::of(&roller(&text, 60.0), 720);
        let lift = 1.0 - (TAU * at).cos();
        let (size, _) = analysis.summary.a.greatest_size();
        let seen = size >= 0.95 * peak * lift;
        found += usize::from(seen);
        assert!(seen || analysis.findings.iter().any(is_unproved), "{text}: {size}, not {}", peak * lift);
        // A feature may be so weak where the lift is small that the cam bears it.
        if analysis.level == Level::Acceptable {
            assert_eq!(Analysis::of(&roller(&text, 60.0), 72_000).level, Level::Acceptable, "{text}");
        }
    }
    assert!(found * 20 >= count * 19, "{found} of {count} are found");
}
