//! Joinings of known demands, and of random ones.

use super::*;
use proptest::prelude::*;

const LOW: Taste = Taste { high_speed: false, least: 2 };
const HIGH: Taste = Taste { high_speed: true, least: 2 };

fn dwell(from: f64, to: f64, height: f64) -> Demand {
    Demand::Dwell { from: from.to_radians(), to: to.to_radians(), height }
}

fn straight(from: f64, to: f64, start: f64, end: f64) -> Demand {
    Demand::Straight { from: from.to_radians(), to: to.to_radians(), start, end }
}

fn pass(at: f64, height: f64) -> Demand {
    Demand::Pass { at: at.to_radians(), height, velocity: None }
}

fn laws(joining: &Joining) -> Vec<&'static str> {
    joining.segments.iter().map(|segment| segment.law.id).collect()
}

#[test]
fn between_rests_it_takes_the_standard_law_with_the_lowest_peak() {
    let demands = [dwell(0.0, 60.0, 0.0), dwell(180.0, 220.0, 10.0)];
    for (taste, law) in [
        (LOW, "modified-trapezoidal"),
        (Taste { least: 1, ..LOW }, "modified-sine"),
        (Taste { least: 3, ..LOW }, "cycloidal"),
        (HIGH, "polynomial-4-5-6-7"),
    ] {
        let joining = join(&demands, taste).expect("joined");
        assert_eq!(laws(&joining), ["dwell", law, "dwell", law], "{taste:?}");
        assert_eq!(joining.choices[0].tried[0].way, Way::Law(Law::by_id(law).expect(law)));
    }
    // Peaks are those of the handbooks: 4.8881·L/β² for the modified trapezoidal.
    let joining = join(&demands, LOW).expect("joined");
    let expected = 4.8881 * 10.0 / 120_f64.to_radians().powi(2);
    assert!((joining.choices[0].tried[0].peaks[1] / expected - 1.0).abs() < 1e-4);
    assert_eq!(join(&demands, HIGH).expect("joined").choices[0].reason, Reason::Only);
}

#[test]
fn beside_a_straight_stretch_an_exact_half_or_a_polynomial_stands() {
    // 2·L/β of the half cycloidal is the slope of the line: 3/40·2 = 6/40.
    let demands = [dwell(0.0, 40.0, 0.0), straight(80.0, 120.0, 3.0, 9.0), dwell(160.0, 240.0, 12.0)];
    let joining = join(&demands, Taste { least: 3, ..LOW }).expect("joined");
    let tried = &joining.choices[0].tried;
    let half = Law::by_id("half-cycloidal-start").expect("half");
    assert!(tried.iter().any(|tried| tried.way == Way::Law(half)), "{tried:?}");
    assert_eq!(laws(&join(&demands, HIGH).expect("joined"))[1], "polynomial-7");
    // Too steep a line for so small a rise: the follower sets out later.
    let steep = [dwell(0.0, 40.0, 0.0), straight(120.0, 160.0, 1.0, 21.0), dwell(240.0, 260.0, 30.0)];
    let joining = join(&steep, LOW).expect("joined");
    assert!(matches!(joining.choices[0].tried[0].way, Way::Waiting(_)), "{:?}", joining.choices[0]);
    assert!(joining.choices[0].tried.iter().any(|tried| !tried.above), "what dips is told");
}

#[test]
fn what_needs_no_joining_is_held_or_goes_straight_on() {
    let demands = [
        dwell(0.0, 30.0, 0.0),
        dwell(60.0, 90.0, 0.0),
        straight(120.0, 150.0, 3.0, 6.0),
        straight(180.0, 210.0, 9.0, 12.0),
    ];
    let joining = join(&demands, LOW).expect("joined");
    let reasons: Vec<Reason> = joining.choices.iter().map(|choice| choice.reason).collect();
    assert_eq!((reasons[0], reasons[2]), (Reason::Stays, Reason::InLine));
}

#[test]
fn points_are_passed() {
    let demands =
        [dwell(0.0, 30.0, 0.0), pass(70.0, 4.0), pass(110.0, 3.0), pass(150.0, 9.0), dwell(200.0, 220.0, 10.0)];
    for taste in [LOW, HIGH] {
        let joining = join(&demands, taste).expect("joined");
        let program = Program::new(&joining.segments).expect("a program");
        for (at, height) in [(70.0, 4.0), (110.0, 3.0), (150.0, 9.0)] {
            assert!((program.at(f64::to_radians(at)).s - height).abs() < 1e-9, "at {at}");
        }
    }
    // A dwell that ends with the turn is a rest at its beginning.
    let joining = join(&[dwell(50.0, 90.0, 10.0), dwell(320.0, 360.0, 0.0)], LOW).expect("joined");
    assert_eq!(laws(&joining)[0], "modified-trapezoidal");
    // Nothing but points: the turn begins on the base circle, and bends there.
    let joining = join(&[pass(90.0, 6.0), pass(180.0, 10.0), pass(270.0, 6.0)], LOW).expect("joined");
    let program = Program::new(&joining.segments).expect("a program");
    assert!(program.at(0.0).a > 0.0 && program.at(0.0).v.abs() < 1e-9);
    assert!(program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| order == 3)));
}

#[test]
fn a_valley_between_two_looks_is_seen() {
    // The polynomial through these points goes below the base circle for 3° of 290°.
    let demands = [
        pass(40.5, 7.98),
        pass(102.2, 5.29),
        pass(154.0, 9.71),
        pass(228.7, 0.8),
        dwell(290.1, 305.6, 17.28),
        dwell(324.2, 333.6, 0.0),
    ];
    let joining = join(&demands, Taste { high_speed: true, least: 1 }).expect("joined");
    let whole =
        joining.choices[0].tried.iter().find(|tried| matches!(tried.way, Way::Law(law) if law.id == "polynomial"));
    assert!(!whole.expect("tried").above);
    let program = Program::new(&joining.segments).expect("a program");
    assert!((0..=3600).all(|i| program.at(TAU * f64::from(i) / 3600.0).s > -1e-9));
}

#[test]
fn what_only_touches_the_base_circle_lends_no_jerk() {
    // At θ = 0 the follower rests for an instant, and the polynomial before it leaves with a jerk that nobody asked for.
    let demands = [
        straight(32.7, 46.1, 8.72, 16.69),
        dwell(64.4, 75.2, 0.5),
        dwell(110.1, 145.8, 0.5),
        dwell(197.1, 229.9, 0.5),
        pass(279.3, 20.2),
    ];
    let joining = join(&demands, Taste { least: 1, ..LOW }).expect("joined");
    assert_eq!(laws(&joining)[0], "polynomial-5");
    let program = Program::new(&joining.segments).expect("a program");
    assert!((0..=3600).all(|i| program.at(TAU * f64::from(i) / 3600.0).s > -1e-9));
}

#[test]
fn what_cannot_be_joined_is_blamed() {
    let problem = |demands: &[Demand]| join(demands, LOW).expect_err("refused");
    assert_eq!(problem(&[]).problem, JoinProblem::Nothing);
    assert_eq!(problem(&[dwell(0.0, 90.0, 0.0)]).problem, JoinProblem::Nothing);
    assert_eq!(problem(&[dwell(90.0, 60.0, 1.0)]), JoinError { demand: 0, problem: JoinProblem::Place });
    assert_eq!(problem(&[pass(370.0, 1.0)]).problem, JoinProblem::Place);
    let clash = [dwell(0.0, 60.0, 0.0), straight(60.0, 90.0, 0.0, 9.0)];
    assert!(matches!(problem(&clash).problem, JoinProblem::Low | JoinProblem::Clash { .. }));
    assert_eq!(
        problem(&[dwell(0.0, 60.0, 0.0), dwell(50.0, 90.0, 3.0)]),
        JoinError { demand: 1, problem: JoinProblem::Overlap { other: 0 } }
    );
    assert_eq!(problem(&[pass(90.0, 6.0), dwell(90.0, 120.0, 7.0)]).problem, JoinProblem::Clash { other: 0 });
    assert_eq!(problem(&[pass(90.0, -1.0)]).problem, JoinProblem::Low);
    assert_eq!(problem(&[dwell(0.0, 60.0, 3.0), pass(90.0, 6.0)]).problem, JoinProblem::StartsHigh);
    assert_eq!(problem(&[pass(90.0, f64::NAN)]).problem, JoinProblem::Place);
}

/// Dwells and points in order over the turn, with room between them, and sometimes a straight stretch.
fn demands() -> impl Strategy<Value = Vec<Demand>> {
    let one = (0..6_u8, 0.3..1.0_f64, 0.0..20.0_f64, -8.0..8.0_f64);
    prop::collection::vec(one, 1..9).prop_map(|parts| {
        let whole: f64 = parts.iter().map(|part| part.1).sum::<f64>() + 0.5;
        let mut theta = 0.25 / whole * TAU;
        let mut demands = Vec::new();
        for (kind, share, height, rise) in parts {
            let width = share / whole * TAU;
            let (from, to) = (theta + 0.3 * width, theta + 0.7 * width);
            theta += width;
            let height = height + 0.5;
            demands.push(match kind {
                0 | 1 => Demand::Dwell { from, to, height },
                2 => Demand::Dwell { from, to, height: 0.0 },
                3 => Demand::Straight { from, to, start: height + 8.0, end: height + 8.0 + rise },
                _ => Demand::Pass { at: from, height, velocity: None },
            });
        }
        demands
    })
}

#[test]
fn what_comes_to_rest_on_the_base_circle_does_not_dip_below_it_just_before() {
    let pass = |at: f64, height: f64| Demand::Pass { at, height, velocity: None };
    let demands = [
        Demand::Dwell { from: 0.910_976, to: 1.533_935, height: 3.241_599 },
        pass(2.400_118, 9.009_884),
        pass(3.653_503, 5.501_535),
        Demand::Dwell { from: 4.835_977, to: 5.409_378, height: 0.0 },
    ];
    let program = Program::new(&join(&demands, LOW).expect("joined").segments).expect("a program");
    let lowest = (0..200_000).map(|i| program.at(TAU * f64::from(i) / 200_000.0).s).fold(f64::INFINITY, f64::min);
    assert!(lowest > -1e-9, "down to {lowest}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn whatever_is_demanded_is_met_and_smooth(demands in demands(), high_speed: bool, least in 1..4_usize) {
        let straight = demands.iter().any(|demand| matches!(demand, Demand::Straight { .. }));
        let moves = demands.iter().any(|demand| !matches!(demand, Demand::Dwell { height: 0.0, .. }));
        let joining = match join(&demands, Taste { high_speed, least }) {
            Ok(joining) => joining,
            Err(error) => {
                // A line may come down so steeply that nothing catches it above the base circle.
                let excused = if moves { straight && error.problem == JoinProblem::NoWay } else { error.problem == JoinProblem::Nothing };
                prop_assert!(excused, "{error:?}");
                return Ok(());
            }
        };
        let program = Program::new(&joining.segments).expect("a program");
        let first = if high_speed { 4 } else { 3 };
        prop_assert!(program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| order >= first)));
        let close = |one: f64, other: f64| (one - other).abs() < 1e-7;
        for demand in &demands {
            match *demand {
                Demand::Dwell { from, to, height } => {
                    let middle = program.at((from + to) / 2.0);
                    prop_assert!(close(middle.s, height) && close(middle.v, 0.0), "{demand:?}: {middle:?}");
                }
                Demand::Straight { from, to, start, end } => {
                    let middle = program.at((from + to) / 2.0);
                    let slope = (end - start) / (to - from);
                    prop_assert!(close(middle.s, (start + end) / 2.0) && close(middle.v, slope), "{demand:?}: {middle:?}");
                }
                Demand::Pass { at, height, .. } => prop_assert!(close(program.at(at).s, height), "{demand:?}"),
            }
        }
        let lowest = (0..=2000).map(|i| program.at(TAU * f64::from(i) / 2000.0).s).fold(f64::INFINITY, f64::min);
        prop_assert!(lowest > -1e-6, "down to {lowest}");
    }
}
