//! Every law goes from (0, 0) to (1, 1) with exact derivatives, and known ones have the peaks of the handbooks.

use super::*;
use std::f64::consts::{FRAC_PI_2, TAU};

fn rising(law: &Law) -> Vec<Piece> {
    law.unit(Arguments { parameters: law.default_parameters(), falling: false, beta: 1.0 }).expect(law.id)
}

/// Value with one-sided limits: the piece is given, so both sides of a joint can be asked for.
fn spans(pieces: &[Piece]) -> Vec<(f64, f64, Piece)> {
    let mut from = 0.0;
    pieces.iter().map(|p| (std::mem::replace(&mut from, p.until), p.until, p.clone())).collect()
}

fn peak(pieces: &[Piece], order: usize) -> f64 {
    let mut peak = 0.0_f64;
    for (from, to, curve) in spans(pieces) {
        for i in 0..=20_000 {
            let x = from + (to - from) * f64::from(i) / 20_000.0;
            peak = peak.max(curve.at(x).order(order).abs());
        }
    }
    peak
}

#[test]
fn every_law_goes_from_zero_to_one_without_a_step() {
    for law in LAWS.iter().filter(|law| !law.is_dwell()) {
        for falling in [false, true] {
            let pieces =
                law.unit(Arguments { parameters: law.default_parameters(), falling, beta: 1.0 }).expect(law.id);
            let spans = spans(&pieces);
            assert!(spans[0].2.at(0.0).s.abs() < 1e-14, "{} starts at 0", law.id);
            let (_, end, last) = spans[spans.len() - 1].clone();
            assert!((end - 1.0).abs() < 1e-15 && (last.at(1.0).s - 1.0).abs() < 1e-13, "{} ends at 1", law.id);
            for pair in spans.windows(2) {
                let (left, right) = (pair[0].2.at(pair[0].1), pair[1].2.at(pair[0].1));
                assert!((left.s - right.s).abs() < 1e-14 && (left.v - right.v).abs() < 1e-13, "{}", law.id);
            }
        }
    }
}

#[test]
fn derivatives_agree_with_central_differences() {
    let h = 1e-5;
    for law in LAWS {
        for (from, to, curve) in spans(&rising(law)) {
            for i in 1..20 {
                let x = from + (to - from) * f64::from(i) / 20.0;
                let (before, here, after) = (curve.at(x - h), curve.at(x), curve.at(x + h));
                for order in 0..3 {
                    let slope = (after.order(order) - before.order(order)) / (2.0 * h);
                    let exact = here.order(order + 1);
                    assert!((slope - exact).abs() < 1e-6 * (1.0 + exact.abs()), "{} order {order}", law.id);
                }
            }
        }
    }
}

#[test]
fn peak_factors_are_those_of_the_handbooks() {
    let expected: &[(&str, &[f64])] = &[
        ("dwell", &[0.0, 0.0, 0.0]),
        ("constant-velocity", &[1.0, 0.0, 0.0]),
        ("parabolic", &[2.0, 4.0, 0.0]),
        ("parabolic-blend", &[4.0 / 3.0, 16.0 / 3.0, 0.0]),
        ("cubic-1", &[3.0, 12.0, 24.0]),
        ("cubic-2", &[1.5, 6.0, 12.0]),
        ("simple-harmonic", &[FRAC_PI_2, 4.9348, 15.503]),
        ("double-harmonic", &[2.0405, 9.8696, 42.41]),
        ("cycloidal", &[2.0, TAU, 39.478]),
        ("freudenstein-1-3-5", &[2.0, 5.0603, 59.615]),
        ("polynomial-3-4-5", &[1.875, 5.7735, 60.0]),
        ("polynomial-4-5-6-7", &[2.1875, 7.5132, 52.5]),
        ("modified-trapezoidal", &[2.0, 4.8881, 61.43]),
        ("modified-sine", &[1.7596, 5.5280, 69.47]),
    ];
    for (id, peaks) in expected {
        let pieces = rising(Law::by_id(id).expect(id));
        for (order, value) in (1..).zip(*peaks) {
            let found = peak(&pieces, order);
            assert!((found - value).abs() <= 1e-4 * value, "{id} order {order}: {found}");
        }
    }
}

#[test]
fn scca_contains_the_five_classic_laws() {
    let scca = Law::by_id("scca").expect("scca");
    for (id, b, c) in [
        ("parabolic", 0.0, 1.0),
        ("simple-harmonic", 0.0, 0.0),
        ("modified-sine", 0.25, 0.0),
        ("modified-trapezoidal", 0.25, 0.5),
        ("cycloidal", 0.5, 0.0),
    ] {
        let member = scca.unit(Arguments { parameters: [b, c, 0.0], falling: false, beta: 1.0 }).expect(id);
        assert_eq!(member, rising(Law::by_id(id).expect(id)), "{id}");
    }
    let pieces = rising(Law::by_id("cycloidal").expect("cycloidal"));
    assert_eq!(pieces.len(), 1, "a cycloidal is one formula");
    for i in 0..=50 {
        let x = f64::from(i) / 50.0;
        let closed = x - (TAU * x).sin() / TAU;
        assert!((pieces[0].curve.at(x).s - closed).abs() < 1e-15);
    }
}

#[test]
fn scca_refuses_fractions_that_do_not_fit() {
    let scca = Law::by_id("scca").expect("scca");
    for [b, c] in [[-0.1, 0.5], [0.7, 0.5], [1.0, 0.0], [0.5, 0.6], [0.0, 1.2]] {
        let parameters = [b, c, 0.0];
        let answer = scca.unit(Arguments { parameters, falling: false, beta: 1.0 });
        if [b, c] == [1.0, 0.0] {
            assert!(answer.is_ok(), "b = 1 is two whole sine halves");
        } else {
            assert!(answer.is_err(), "{parameters:?}");
        }
    }
}

#[test]
fn double_harmonic_returns_as_its_rise_reversed() {
    let law = Law::by_id("double-harmonic").expect("double-harmonic");
    let (rise, fall) =
        (rising(law), law.unit(Arguments { parameters: [0.0; 3], falling: true, beta: 1.0 }).expect("fall"));
    for i in 0..=20 {
        let x = f64::from(i) / 20.0;
        let reversed = 1.0 - rise[0].at(1.0 - x).s;
        assert!((fall[0].curve.at(x).s - reversed).abs() < 1e-15);
    }
}

#[test]
fn half_laws_rest_at_one_end_and_run_on_at_the_other() {
    for (id, start, end) in [
        ("half-harmonic-start", 0.0, FRAC_PI_2),
        ("half-harmonic-end", FRAC_PI_2, 0.0),
        ("half-cycloidal-start", 0.0, 2.0),
        ("half-cycloidal-end", 2.0, 0.0),
    ] {
        let curve = &rising(Law::by_id(id).expect(id))[0].curve;
        assert!((curve.at(0.0).v - start).abs() < 1e-15 && (curve.at(1.0).v - end).abs() < 1e-15, "{id}");
        if id.starts_with("half-cycloidal") {
            assert!(curve.at(0.0).a.abs() < 1e-15 && curve.at(1.0).a.abs() < 1e-14, "{id}");
        }
    }
}

#[test]
fn names_are_unique() {
    for (i, law) in LAWS.iter().enumerate() {
        assert!(LAWS[..i].iter().all(|other| other.id != law.id), "{}", law.id);
    }
}
