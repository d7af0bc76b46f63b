//! Claims about designs in other units.

use super::rounded;
use crate::testing::{self, Random};
use crate::{
    CamKind, DataRefusal, Design, EXAMPLES, LengthUnit, Problem, ProgramRefusal, SegmentDesign, SpeedUnit, example,
};
use levalab_core::application::Magnitude;
use levalab_core::law::Data;
use levalab_core::{Analysis, Column, Law};
use serde_json::Value;

const FORTY_DESIGNS_EACH: usize = 40;

fn size(unit: LengthUnit) -> f64 {
    super::tenths_of_millimetres(unit)
}

/// Lengths from which the tolerance for sums, the same number in any unit, is a matter of the thirteenth digit, which splines may lose.
const HUGE: f64 = 1e3;

/// Refused for what is too large, too small or too long in the other unit, and for nothing else.
fn is_out_of_range(problem: &Problem, design: &Design, unit: LengthUnit) -> bool {
    let largest = design.segments.iter().map(|segment| segment.rise.abs()).fold(design.base_radius, f64::max);
    match problem {
        Problem::OutOfRange { .. } | Problem::Data(DataRefusal::Expression(_)) => true,
        Problem::Program(ProgramRefusal::Closing { .. } | ProgramRefusal::BelowBase { .. }) => {
            largest * size(design.length_unit) / size(unit) > HUGE
        }
        _ => false,
    }
}

/// Equal but for the last bits of numbers that have more than fourteen digits.
fn check_same(one: &Value, other: &Value, place: &str) {
    match (one, other) {
        (Value::Number(one), Value::Number(other)) => {
            let (one, other) = (one.as_f64().expect("f64"), other.as_f64().expect("f64"));
            if rounded(one, 14) == one {
                assert_eq!(one, other, "{place}");
            } else {
                assert!((one - other).abs() <= 4.0 * f64::EPSILON * one.abs(), "{place}: {one} {other}");
            }
        }
        (Value::Array(one), Value::Array(other)) => {
            assert_eq!(one.len(), other.len(), "{place}");
            one.iter().zip(other).enumerate().for_each(|(k, (a, b))| check_same(a, b, &format!("{place}[{k}]")));
        }
        (Value::Object(one), Value::Object(other)) => {
            assert_eq!(one.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>(), "{place}");
            one.iter().for_each(|(key, value)| check_same(value, &other[key], &format!("{place}.{key}")));
        }
        _ => assert_eq!(one, other, "{place}"),
    }
}

#[test]
fn a_design_comes_back_from_any_unit_as_it_was() {
    let mut random = Random::new(12);
    let mut converted = 0;
    for _ in 0..FORTY_DESIGNS_EACH * 16 {
        let design = testing::design(&mut random);
        let unit = *random.pick(&LengthUnit::ALL);
        match design.in_unit(unit) {
            Ok(other) => {
                converted += 1;
                assert_eq!(other.length_unit, unit);
                let back = match other.in_unit(design.length_unit) {
                    Err(error) if is_out_of_range(&error.problem, &other, design.length_unit) => continue,
                    back => back.expect("it was in range"),
                };
                check_same(&design.to_value(), &back.to_value(), &design.to_json());
            }
            Err(error) => assert!(is_out_of_range(&error.problem, &design, unit), "{error}\n{}", design.to_json()),
        }
    }
    assert!(converted > FORTY_DESIGNS_EACH * 14, "{converted}");
}

#[test]
fn examples_come_back_to_the_letter() {
    for (name, json) in EXAMPLES {
        for unit in LengthUnit::ALL {
            let design = Design::from_json(json).expect(name);
            let there = design.in_unit(unit).expect(name);
            assert_eq!(there.in_unit(design.length_unit).expect(name).to_json(), *json, "{name} by {}", unit.symbol());
        }
    }
}

/// What a column is multiplied by when its lengths are: angles by nothing, ρ as lengths, derivatives as their order says.
fn power(design: &Design, column: Column) -> i32 {
    let (oscillating, travels) = (design.is_oscillating(), design.kind.travel().is_some());
    match column {
        Column::PressureAngle => 0,
        Column::Theta => i32::from(travels),
        Column::S | Column::V | Column::A | Column::J if oscillating => 0,
        Column::V if travels => 0,
        Column::A if travels => -1,
        Column::J if travels => -2,
        _ => 1,
    }
}

#[test]
fn every_figure_scales_with_the_unit_and_angles_stay() {
    let mut random = Random::new(5);
    let mut compared = 0;
    for _ in 0..FORTY_DESIGNS_EACH {
        let design = testing::design(&mut random);
        let unit = *random.pick(&LengthUnit::ALL);
        let Ok(other) = design.in_unit(unit) else { continue };
        let factor = size(design.length_unit) / size(unit);
        let (one, two) = (design.cam().expect("a cam"), other.cam().expect("a cam"));
        let (one, two) = (Analysis::of(&one, 120), Analysis::of(&two, 120));
        // A finding at the very edge of its limit may fall to either side; there are none among these.
        assert_eq!(one.level, two.level, "{}", design.to_json());
        for column in Column::ALL {
            let (Some(before), Some(after)) = (one.column(column), two.column(column)) else {
                assert_eq!(one.column(column).is_some(), two.column(column).is_some());
                continue;
            };
            let scale = factor.powi(power(&design, column));
            let largest =
                before.iter().filter(|value| value.is_finite()).fold(0.0_f64, |most, value| most.max(value.abs()));
            for (&before, &after) in before.iter().zip(after) {
                // ρ near where it is endless, and what polynomials of high degree lose, have fewer digits.
                let near =
                    1e-6 * (before.abs() + largest * 1e-3) + if column == Column::PressureAngle { 1e-12 } else { 0.0 };
                // An angle of 180° has either sign.
                let apart = (before * scale - after).abs();
                let turned = column == Column::PressureAngle && (apart - std::f64::consts::TAU).abs() <= near;
                let same = before == after || apart <= near * scale || turned;
                assert!(same || before.abs() > 1e9, "{column:?} {before} {after}\n{}", design.to_json());
                compared += 1;
            }
        }
    }
    assert!(compared > 10_000);
}

fn with_formula(design: &Design, text: &str) -> Design {
    let rise = if text.contains('L') { 12.5 } else { 0.0 };
    let law = Law::by_id("formula").expect("formula");
    let parameters = law.default_parameters();
    let beta = design.kind.whole();
    let data = Data::Expression(text.to_owned());
    Design { segments: vec![SegmentDesign { law, beta, rise, parameters, data }], ..design.clone() }
}

fn formula_of(design: &Design) -> &str {
    match &design.segments[0].data {
        Data::Expression(text) => text,
        _ => "",
    }
}

#[test]
fn a_formula_stays_the_same_motion() {
    let plate = example("9RT").expect("9RT");
    let wedge = EXAMPLES.iter().map(|(_, json)| Design::from_json(json).expect("an example"));
    let wedge = wedge.into_iter().find(|design| design.kind.travel().is_some()).expect("a wedge");
    let wedge = Design { kind: CamKind::Translating { length: 50.0 }, ..wedge };
    for (design, text, inches) in [
        (&plate, "s₀ + L (sin(2πx))²", "s₀ + L (sin(2πx))²"),
        (&plate, "5 sin(θ)^2", "(5 sin(θ)^2)/25.4"),
        (&plate, "(1 − cos(2πx)) (L+2)", "((1 − cos(2πx)) ((25.4L)+2))/25.4"),
        (&wedge, "θ/4", "θ/4"),
        (&wedge, "2 sin(θ/50) + 0.1theta", "(2 sin((25.4θ)/50) + 0.1(25.4theta))/25.4"),
    ] {
        let design = with_formula(design, text);
        let Ok(cam) = design.cam() else { panic!("{text}: {:?}", design.cam().err()) };
        let other = design.in_unit(LengthUnit::Inch).expect(text);
        assert_eq!(formula_of(&other), inches);
        let (there, span) = (other.cam().expect(text), cam.program.span());
        let place = if design.kind.travel().is_some() { 25.4 } else { 1.0 };
        for k in 0..20 {
            let theta = span * f64::from(k) / 20.0;
            let (before, after) = (cam.program.at(theta), there.program.at(theta / place));
            assert!((before.s - 25.4 * after.s).abs() < 1e-12, "{text} at {theta}");
            assert!((before.v * place - 25.4 * after.v).abs() < 1e-11, "{text} at {theta}");
        }
        for unit in LengthUnit::ALL {
            let on = other.in_unit(unit).expect(text);
            assert!(formula_of(&on).len() <= inches.len() + 4, "written around once: {}", formula_of(&on));
            assert_eq!(on.in_unit(LengthUnit::Millimetre).expect(text), design);
        }
    }
}

#[test]
fn numbers_are_exact_and_short_where_they_can_be() {
    let design = example("9RT").expect("9RT");
    let inches = design.in_unit(LengthUnit::Inch).expect("in range");
    assert_eq!(inches.base_radius, 35.0 / 25.4);
    let whole = Design { base_radius: 1.5, length_unit: LengthUnit::Inch, ..design.clone() };
    assert_eq!(whole.in_unit(LengthUnit::Millimetre).expect("in range").base_radius, 38.1);
    assert_eq!(design.in_unit(LengthUnit::Metre).expect("in range").base_radius, 0.035);
    let relabelled = design.relabelled(LengthUnit::Inch);
    assert_eq!((relabelled.base_radius, relabelled.length_unit), (35.0, LengthUnit::Inch));
}

#[test]
fn a_sum_that_only_just_passes_still_does_in_a_smaller_unit() {
    let mut design = example("9RT").expect("9RT").in_unit(LengthUnit::Metre).expect("in range");
    design.segments[0].rise += 9e-10;
    design.cam().expect("within what may be missed");
    let smaller = design.in_unit(LengthUnit::Millimetre).expect("closed by its last move");
    assert_eq!(smaller.segments[0].rise, 10.0000009);
}

#[test]
fn what_does_not_fit_the_unit_is_refused_at_its_place() {
    let mut design = example("9RT").expect("9RT").relabelled(LengthUnit::Metre);
    design.base_radius = 5e5;
    let error = design.in_unit(LengthUnit::Millimetre).expect_err("too large");
    assert_eq!(error.path.to_string(), "cam.base_radius");
}

#[test]
fn speeds_come_back_as_they_were() {
    let mut random = Random::new(3);
    for _ in 0..2_000 {
        let digits = random.below(15) as i32;
        let value = rounded((random.unit() * 10_f64.powi(digits)).round() / 10_f64.powi(random.below(7) as i32), 15);
        let mut design = example("9RT").expect("9RT");
        let [from, to] = [*random.pick(&SpeedUnit::ALL), *random.pick(&SpeedUnit::ALL)];
        design.speed = crate::Speed { value, unit: from };
        let Ok(there) = design.in_speed_unit(to).and_then(|there| design.cam().map(|_| there)) else { continue };
        assert_eq!(there.in_speed_unit(from).expect("in range").speed, design.speed);
        assert!((there.omega() - design.omega()).abs() <= 1e-15 * design.omega());
    }
}

#[test]
fn what_a_follower_drives_goes_along_with_the_lengths() {
    let mut random = Random::new(21);
    let mut compared = 0;
    while compared < 60 {
        let design = testing::design(&mut random);
        let unit = *random.pick(&LengthUnit::ALL);
        let (Some(application), Ok(other)) = (&design.application, design.in_unit(unit)) else { continue };
        let outcome = |design: &Design| {
            let cam = design.cam().expect("a cam");
            let application = design.application.clone().expect("an application");
            application.outcome(design, &cam, &Analysis::of(&cam, 1))
        };
        let change = super::Change { from: design.length_unit, to: unit, travels: false };
        for (before, after) in outcome(&design).outputs.iter().zip(outcome(&other).outputs) {
            let [least, most, found] = [before.range.min, before.range.max, after.range.max]
                .map(|value| change.magnitude(before.output.magnitude, value));
            let found = found / change.magnitude(before.output.magnitude, 1.0);
            assert!(
                (most - found).abs() <= 1e-9 * most.abs().max(least.abs()),
                "{} {most} {found}",
                application.application.id
            );
        }
        compared += 1;
    }
    // 1 N/mm = 25.4 N/in = 25.4/4.448… lbf/in; 1 MPa = 145.04 psi.
    let inches = super::Change { from: LengthUnit::Millimetre, to: LengthUnit::Inch, travels: false };
    assert!((inches.magnitude(Magnitude::Stiffness, 1.0) - 5.710_147_162).abs() < 1e-8);
    assert!((inches.magnitude(Magnitude::Pressure, 1.0) - 145.037_737_7).abs() < 1e-6);
}
