//! What holds for every cam, tried on random ones: all laws, all followers, both rotations, good cams and bad.

mod support;

use levalab_core::law::{Condition, Data};
use levalab_core::{
    Analysis, Body, Cam, Column, Extremes, Finding, FindingKind, Follower, Law, Motion, Program, Quantity, Segment,
    prescribe,
};
use proptest::prelude::*;
use std::f64::consts::TAU;
use support::random::{cam, cases, opposite};

/// Rounding of a chain of operations on numbers of one scale.
const ROUNDING: f64 = 1e-11;

/// Two ways to the same motion, as a part of the greatest value in the turn: generic polynomials that swing wide between their
/// ends lose two digits more than [`ROUNDING`].
const SAME_MOTION: f64 = 1e-9;

/// Two ways to the same contact, which turns with the ratios of derivatives.
const SAME_CONTACT: f64 = 1e-8;

/// Places to look at in a turn; none is a round angle, so none is on a joint.
const PLACES: usize = 97;

fn places() -> impl Iterator<Item = f64> {
    (0..PLACES).map(|k| TAU * (k as f64 + 0.377) / PLACES as f64)
}

fn close(a: f64, b: f64, scale: f64) -> bool {
    (a - b).abs() <= ROUNDING * scale.abs().max(a.abs()).max(b.abs()) || a == b
}

/// The kinds found by formulas. An arm or a profile that cuts is sought on a polygon, and a bare touch may escape it.
fn exact_kinds(analysis: &Analysis) -> Vec<FindingKind> {
    let by_polygon = |kind: &FindingKind| matches!(kind, FindingKind::ArmCutsCam | FindingKind::SelfCrossing);
    kinds(analysis).into_iter().filter(|kind| !by_polygon(kind)).collect()
}

/// Modulo a turn: a face whose contact is past its pivot has φ = ±180°, which is one angle.
fn same_angle(a: f64, b: f64) -> bool {
    let difference = a - b;
    (difference - TAU * (difference / TAU).round()).abs() <= SAME_CONTACT
}

/// The greatest |s|, |v|, |a|, |j|.
fn peaks(cam: &Cam) -> [f64; 4] {
    let summary = Analysis::of(cam, 720).summary;
    [summary.s, summary.v, summary.a, summary.j].map(|extremes| extremes.greatest_size().0)
}

/// What is wrong, however many times, in the order of their names: places where the geometry is singular are not exact.
fn kinds(analysis: &Analysis) -> Vec<FindingKind> {
    let mut kinds: Vec<FindingKind> = analysis.findings.iter().map(|finding| finding.kind).collect();
    kinds.sort_by_key(|kind| format!("{kind:?}"));
    kinds.dedup();
    kinds
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn the_last_row_repeats_the_first(cam in cam(), steps in 1_usize..800) {
        let analysis = Analysis::of(&cam, steps);
        for column in Column::ALL {
            let Some(values) = analysis.column(column) else { continue };
            prop_assert_eq!(values.len(), steps + 1, "{}", column.name());
            if column == Column::Theta {
                prop_assert_eq!((values[0], values[steps]), (0.0, TAU));
            } else {
                prop_assert_eq!(values[0].to_bits(), values[steps].to_bits(), "{}", column.name());
            }
        }
    }

    #[test]
    fn rows_are_the_cam_at_their_angle(cam in cam(), steps in 1_usize..800) {
        let analysis = Analysis::of(&cam, steps);
        let jerk = peaks(&cam)[3];
        for row in 0..=steps {
            let theta = TAU * row as f64 / steps as f64;
            let (motion, contact) = cam.at(theta);
            let profile = cam.in_cam_frame(contact.point, theta);
            for (column, value) in [
                (Column::Theta, theta),
                (Column::S, motion.s),
                (Column::J, motion.j),
                (Column::X, profile.re),
                (Column::Y, profile.im),
            ] {
                let found = analysis.column(column).expect("a column that all followers have")[row];
                prop_assert!(close(found, value, contact.point.norm() + jerk), "{} at row {row}: {found}, not {value}", column.name());
            }
            let angle = analysis.column(Column::PressureAngle).expect("φ")[row];
            prop_assert!(same_angle(angle, contact.pressure_angle), "φ at row {row}: {angle}");
        }
    }

    #[test]
    fn the_profile_closes_wherever_displacement_and_velocity_do(cam in cam()) {
        for (_, stretch, before, after) in cam.program.joints() {
            let scale = 1.0 + before.v.abs() + after.v.abs();
            if (before.s - after.s).abs() < 1e-12 && (before.v - after.v).abs() < 1e-12 * scale {
                let (left, right) = (cam.follower.contact(before).point, cam.follower.contact(after).point);
                // The normal turns by Δv/|P′|, which is rounding unless the pitch curve stands still.
                prop_assert!((left - right).norm() <= SAME_CONTACT * (1.0 + left.norm()), "{left} and {right} at {}", stretch.from);
            }
        }
    }

    #[test]
    fn no_number_is_missing(cam in cam()) {
        let analysis = Analysis::of(&cam, 360);
        for column in Column::ALL {
            let radius = matches!(column, Column::Rho | Column::RhoPitch);
            for value in analysis.column(column).unwrap_or_default() {
                prop_assert!(value.is_finite() || radius && !value.is_nan(), "{}: {value}", column.name());
            }
        }
        let s = analysis.summary;
        let all = [Some(s.s), Some(s.v), Some(s.a), Some(s.j), Some(s.pressure_angle), s.reach];
        for Extremes { min, min_at, max, max_at } in all.into_iter().flatten() {
            prop_assert!([min, min_at, max, max_at].iter().all(|value| value.is_finite()), "{s:?}");
        }
        for Extremes { min, min_at, max, max_at } in [Some(s.rho), s.rho_pitch].into_iter().flatten() {
            prop_assert!(!min.is_nan() && !max.is_nan() && min_at.is_finite() && max_at.is_finite(), "{s:?}");
        }
        for (place, value) in [s.least_convex, s.tightest_hollow].into_iter().flatten() {
            prop_assert!(place.is_finite() && value.is_finite(), "{s:?}");
        }
        for finding in &analysis.findings {
            let Finding { theta, interval, places, value, limit, .. } = finding;
            let (from, to) = interval.unwrap_or((*theta, *theta));
            prop_assert!([*theta, *value, *limit, from, to].iter().chain(places).all(|number| number.is_finite()), "{finding:?}");
            prop_assert!(from <= to && (0.0..TAU).contains(theta) && !places.is_empty(), "{finding:?}");
            prop_assert!(from <= *theta && *theta <= to || from <= theta + TAU && theta + TAU <= to, "{finding:?} is worst outside");
        }
    }

    #[test]
    fn the_verdict_does_not_hang_on_the_rows_asked_for(cam in cam()) {
        let analysis = Analysis::of(&cam, 720);
        for steps in [7, 100, 3601] {
            let other = Analysis::of(&cam, steps);
            prop_assert_eq!(other.level, analysis.level, "{} rows", steps);
            prop_assert_eq!(exact_kinds(&other), exact_kinds(&analysis), "{} rows", steps);
        }
    }

    #[test]
    fn a_cam_k_times_as_large_is_the_same_cam(cam in cam(), k in prop_oneof![Just(0.001), Just(25.4), 0.01..100.0]) {
        let large = scaled(&cam, k);
        let lift = if cam.follower.kind().motion == Motion::Oscillating { 1.0 } else { k };
        let peaks = peaks(&cam);
        for theta in places() {
            let ((motion, contact), (motion_k, contact_k)) = (cam.at(theta), large.at(theta));
            for (order, peak) in peaks.into_iter().enumerate() {
                let (found, expected) = (motion_k.order(order), motion.order(order) * lift);
                prop_assert!((found - expected).abs() <= SAME_MOTION * peak * lift, "order {order} at {theta}: {found}, not {expected}");
            }
            let size = contact.trace.norm() + contact.point.norm();
            prop_assert!((contact_k.point - contact.point * k).norm() <= SAME_CONTACT * k * size, "profile at {theta}");
            prop_assert!((contact_k.normal - contact.normal).norm() <= SAME_CONTACT, "normal at {theta}");
            prop_assert!(same_angle(contact_k.pressure_angle, contact.pressure_angle), "φ at {theta}");
            prop_assert!((contact_k.reach - contact.reach * k).abs() <= SAME_CONTACT * k * size, "reach at {theta}");
        }
        prop_assert_eq!(kinds(&Analysis::of(&large, 720)), kinds(&Analysis::of(&cam, 720)));
    }

    #[test]
    fn turned_the_other_way_the_reversed_program_needs_the_same_profile(cam in cam()) {
        let peaks = peaks(&cam);
        let backwards = Cam::new(reversed(&cam.program), turned_over(&cam.follower));
        for theta in places() {
            let ((motion, contact), (mirror, contact_m)) = (cam.at(theta), backwards.at(TAU - theta));
            for (order, (peak, sign)) in peaks.into_iter().zip([1.0, -1.0, 1.0, -1.0]).enumerate() {
                let (found, expected) = (mirror.order(order), sign * motion.order(order));
                prop_assert!((found - expected).abs() <= SAME_MOTION * peak, "order {order} at {theta}: {found}, not {expected}");
            }
            let size = contact.trace.norm() + contact.point.norm();
            let (here, there) = (cam.in_cam_frame(contact.point, theta), backwards.in_cam_frame(contact_m.point, TAU - theta));
            prop_assert!((here - there).norm() <= SAME_CONTACT * size, "profile at {theta}: {here} and {there}");
            prop_assert!(same_angle(contact.pressure_angle, -contact_m.pressure_angle), "φ at {theta}");
            prop_assert!((contact.reach - contact_m.reach).abs() <= SAME_CONTACT * size, "reach at {theta}");
        }
    }

    #[test]
    fn clockwise_is_the_mirror_image_for_a_follower_that_slides(cam in cam()) {
        prop_assume!(cam.follower.body() == Body::Slide);
        // What lies to one side of the axis lies to the other in the mirror.
        let mut follower = turned_over(&cam.follower);
        for key in ["eccentricity", "face_angle"] {
            if let Some(index) = follower.kind().index_of(key) {
                follower = follower.with_value(index, -follower.values()[index]).expect("as good as its mirror image");
            }
        }
        let mirror = Cam::new(cam.program.clone(), follower);
        for theta in places() {
            let ((motion, contact), (motion_m, contact_m)) = (cam.at(theta), mirror.at(theta));
            prop_assert_eq!(motion, motion_m);
            let size = contact.trace.norm() + contact.point.norm();
            prop_assert!((contact.point + contact_m.point.conj()).norm() <= ROUNDING * size, "x is opposite, y the same");
            prop_assert!(same_angle(contact.pressure_angle, contact_m.pressure_angle), "φ at {theta}");
            prop_assert!((contact.reach + contact_m.reach).abs() <= ROUNDING * size);
            prop_assert!(close(contact.bend, contact_m.bend, 0.0));
        }
    }
}

/// All lengths k times as large; angles as they are.
fn scaled(cam: &Cam, k: f64) -> Cam {
    let follower = &cam.follower;
    let rises = if follower.kind().motion == Motion::Oscillating { 1.0 } else { k };
    let larger = |segment: &Segment| {
        let mut larger =
            Segment { rise: segment.rise * rises, data: segment.data.scaled(1.0, rises), ..segment.clone() };
        for (value, parameter) in larger.parameters.iter_mut().zip(segment.law.parameters) {
            *value *= if parameter.quantity == Quantity::Height { rises } else { 1.0 };
        }
        larger
    };
    let segments = cam.program.segments().iter().map(larger);
    let mut values = follower.values().to_vec();
    for (value, parameter) in values.iter_mut().zip(follower.kind().parameters) {
        *value *= if parameter.quantity == Quantity::Length { k } else { 1.0 };
    }
    let follower = Follower::new(follower.kind(), follower.base_radius() * k, &values, follower.rotation())
        .expect("as good as before");
    Cam::new(Program::new(&segments.collect::<Vec<_>>()).expect("as good as before"), follower)
}

fn turned_over(follower: &Follower) -> Follower {
    Follower::new(follower.kind(), follower.base_radius(), follower.values(), opposite(follower.rotation()))
        .expect("as good as before")
}

/// The program that goes through the same heights backwards. Halves change places, parts of β and conditions turn round; all else is
/// its own reverse.
fn reversed(program: &Program) -> Program {
    let backwards = |segment: &Segment| {
        let id = segment.law.id;
        let id = match (id.strip_suffix("-start"), id.strip_suffix("-end")) {
            (Some(stem), _) => format!("{stem}-end"),
            (_, Some(stem)) => format!("{stem}-start"),
            _ => id.to_owned(),
        };
        let law = Law::by_id(&id).expect("halves come in pairs");
        let turned = |c: &Condition| {
            let sign = if c.order.is_multiple_of(2) { 1.0 } else { -1.0 };
            Condition { at: segment.beta - c.at, order: c.order, value: sign * c.value }
        };
        let data = match &segment.data {
            Data::None => Data::None,
            Data::Conditions(conditions) => Data::Conditions(conditions.iter().map(turned).collect()),
            Data::Spline { conditions, knots } => Data::Spline {
                conditions: conditions.iter().map(turned).collect(),
                knots: knots.iter().rev().map(|knot| segment.beta - knot).collect(),
            },
            Data::Points(points) => Data::Points(points.iter().rev().map(|&[at, s]| [segment.beta - at, s]).collect()),
            Data::Ordinates(ordinates) => Data::Ordinates(ordinates.iter().rev().copied().collect()),
            // The one of these tests is odd about its middle.
            Data::Expression(text) => Data::Expression(text.clone()),
        };
        let mut parameters = segment.parameters;
        if law.parameters.iter().all(|parameter| parameter.quantity == Quantity::Span) {
            parameters[..law.parameters.len()].reverse();
        }
        if let Some(crossover) = law.parameters.iter().position(|parameter| parameter.key == "crossover") {
            parameters[crossover] = 1.0 - parameters[crossover];
        }
        Segment { law, rise: -segment.rise, parameters, data, ..segment.clone() }
    };
    Program::new(&program.segments().iter().rev().map(backwards).collect::<Vec<_>>()).expect("as good as forwards")
}

#[test]
fn every_cure_is_free_of_missing_numbers() {
    // Prescribing is slow beside analysing, so fewer cams are tried here than above; see cures.rs for what cures do.
    let mut runner = proptest::test_runner::TestRunner::new(cases(24));
    let all_finite = |cam: Cam| {
        let analysis = Analysis::of(&cam, 720);
        for cure in prescribe(&cam, &analysis).into_iter().flatten() {
            prop_assert!(!format!("{cure:?}").contains("NaN") && !format!("{cure:?}").contains("inf"), "{cure:?}");
        }
        Ok(())
    };
    runner.run(&cam(), all_finite).unwrap_or_else(|error| panic!("{error}"));
}
