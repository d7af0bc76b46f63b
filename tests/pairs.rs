//! Conjugate pairs and cams of constant breadth: the rigid follower laid against the finished profiles, and nothing else.

mod support;

use levalab_core::{
    Analysis, Body, Cam, Closure, Column, Cycle, Element, Generator, Level, Point, Program, Rotation, Segment, Tie,
    angle_between, balanced_tie, conjugate, profiles_coincide, working_ties,
};
use std::f64::consts::{PI, TAU};
use support::{degrees, follower, lengths};

/// Stations of the profiles: enough for a parabola through three of them to give a distance to 1e-9 of the cam.
const STATIONS: usize = 28_800;

/// The follower fits both profiles to this part of the cam's size.
const FIT: f64 = 1e-9;

fn profile(cam: &Cam) -> Vec<Point> {
    let analysis = Analysis::of(cam, STATIONS);
    let (x, y) = (analysis.column(Column::X).expect("x"), analysis.column(Column::Y).expect("y"));
    x.iter().zip(y).take(STATIONS).map(|(&x, &y)| Point::new(x, y)).collect()
}

/// The least of values on a closed curve, by the parabola through the lowest and its neighbours.
fn least(values: &[f64]) -> f64 {
    let n = values.len();
    let i = (0..n).min_by(|&a, &b| values[a].total_cmp(&values[b])).expect("values");
    let (before, here, after) = (values[(i + n - 1) % n], values[i], values[(i + 1) % n]);
    let (slope, bend) = (0.5 * (after - before), before - 2.0 * here + after);
    if bend > 0.0 { here - 0.5 * slope * slope / bend } else { here }
}

/// The gap between an element carried by the body to displacement `s` at cam angle θ and a profile: 0 when it just touches.
fn gap(cam: &Cam, element: Element, s: f64, theta: f64, profile: &[Point]) -> f64 {
    let turn = Point::from_polar(1.0, cam.follower.rotation().sigma() * theta);
    let fixed: Vec<Point> = profile.iter().map(|point| point * turn).collect();
    let carry = |point: Point| match cam.follower.body() {
        Body::Slide => point + Point::new(0.0, s),
        Body::Swing { pivot } => pivot + (point - pivot) * Point::from_polar(1.0, -s),
    };
    match element {
        Element::Disc { centre, radius } => {
            let centre = carry(centre);
            least(&fixed.iter().map(|point| (point - centre).norm()).collect::<Vec<_>>()) - radius
        }
        Element::Face { normal, point } => {
            let (on, tip) = (carry(point), carry(point + normal));
            let normal = tip - on;
            least(&fixed.iter().map(|p| (on - p).re * normal.re + (on - p).im * normal.im).collect::<Vec<_>>())
        }
    }
}

fn assert_pair_fits(name: &str, first: &Cam, second: &Cam) {
    let (one, two) = (profile(first), profile(second));
    let size = first.follower.base_radius();
    for k in 0..72 {
        let theta = TAU * f64::from(k) / 72.0 + 0.01;
        let s = first.program.at(theta).s;
        let gaps = (
            gap(first, first.follower.element(), s, theta, &one),
            gap(second, second.follower.element(), s, theta, &two),
        );
        assert!(gaps.0.abs() < FIT * size && gaps.1.abs() < FIT * size, "{name} at {theta}: {gaps:?}");
    }
}

fn cam(id: &str, base_radius: f64, given: &[(&str, f64)], program: Program, rotation: Rotation) -> Cam {
    Cam::new(program, follower(id, base_radius, given, rotation))
}

fn rise_and_return(scale: f64) -> [(&'static str, f64, f64); 4] {
    [("polynomial-4-5-6-7", 110.0, scale), ("dwell", 40.0, 0.0), ("cycloidal", 140.0, -scale), ("dwell", 70.0, 0.0)]
}

#[test]
fn both_elements_of_a_pair_touch_both_cams_all_the_way_round() {
    for rotation in support::ROTATIONS {
        let sliding = |id: &str, base: f64, given: &[(&str, f64)]| {
            cam(id, base, given, lengths(&rise_and_return(14.0)), rotation)
        };
        let swinging =
            |id: &str, base: f64, given: &[(&str, f64)]| cam(id, base, given, degrees(&rise_and_return(9.0)), rotation);
        let cases = [
            ("flat", sliding("translating-flat", 90.0, &[]), Tie::Distance(200.0), None),
            ("inclined flat", sliding("translating-flat", 90.0, &[("face_angle", 0.2)]), Tie::Distance(200.0), None),
            (
                "roller",
                sliding("translating-roller", 50.0, &[("roller_radius", 10.0)]),
                Tie::Distance(140.0),
                Some(6.0),
            ),
            (
                "eccentric roller",
                sliding("translating-roller", 50.0, &[("roller_radius", 10.0), ("eccentricity", 7.0)]),
                Tie::Distance(140.0),
                None,
            ),
            (
                "swinging roller by its angle",
                swinging(
                    "oscillating-roller",
                    50.0,
                    &[("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 100.0)],
                ),
                Tie::Angle(86_f64.to_radians()),
                Some(8.0),
            ),
            (
                "swinging roller by its second base radius",
                swinging(
                    "oscillating-roller",
                    50.0,
                    &[("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 100.0), ("pivot_angle", 0.4)],
                ),
                Tie::BaseRadius(45.0),
                None,
            ),
            (
                "swinging face",
                swinging("oscillating-flat", 80.0, &[("pivot_distance", 150.0), ("face_offset", 8.0)]),
                Tie::Angle(85_f64.to_radians()),
                None,
            ),
        ];
        for (name, first, tie, radius) in cases {
            let second = conjugate(&first, tie, radius).unwrap_or_else(|error| panic!("{name}: {error:?}"));
            assert_pair_fits(name, &first, &second);
            let (one, two) = (Analysis::of(&first, 720), Analysis::of(&second, 720));
            assert!((one.summary.s.max - two.summary.s.max).abs() < 1e-12, "{name}: the same travel");
            assert!(two.summary.s.min.abs() < 1e-12, "{name}: the second rests on its base circle");
            assert_eq!(two.level, one.level, "{name}: {:?}", two.findings);
            if let Tie::BaseRadius(radius) = tie {
                assert!((second.follower.base_radius() - radius).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn the_least_profile_radius_of_a_second_cam_is_its_base_radius() {
    let first = cam(
        "oscillating-flat",
        80.0,
        &[("pivot_distance", 150.0)],
        degrees(&rise_and_return(9.0)),
        Rotation::Clockwise,
    );
    let second = conjugate(&first, Tie::BaseRadius(70.0), None).expect("a pair");
    // The support of the second face is least, and equal to Rb₂, where the first is at the top.
    let rest = second.program.at(2.2).s;
    assert!(rest.abs() < 1e-12, "the first dwells on top there: {rest}");
    assert!((second.at(2.2).1.point.norm() - 70.0).abs() < 1e-9);
}

#[test]
fn example_7crt_has_its_conjugate_at_380() {
    let rows: Vec<(&str, f64, f64)> =
        (0..10).map(|k| ("polynomial-4-5-6-7", 36.0, if k % 2 == 0 { 20.0 } else { -20.0 })).collect();
    let first =
        cam("translating-roller", 170.0, &[("roller_radius", 10.0)], lengths(&rows), Rotation::CounterClockwise);
    let second = conjugate(&first, Tie::Distance(380.0), None).expect("a pair");
    assert!(second.program.segments()[0].rise < 0.0, "the conjugate starts with a return");
    // On the axis the second roller's centre is 380 − (Rp + s) away from the shaft.
    assert!((second.follower.base_radius() - (380.0 - 180.0 - 20.0 - 10.0)).abs() < 1e-12);
    assert_pair_fits("7CRT", &first, &second);
    // Half a turn later every rise is a return, and both base radii are 170: one cam would do.
    assert!(profiles_coincide(&first, &second));
    let wider =
        cam("translating-roller", 150.0, &[("roller_radius", 10.0)], first.program.clone(), Rotation::CounterClockwise);
    assert!(!profiles_coincide(&wider, &conjugate(&wider, Tie::Distance(380.0), None).expect("a pair")));
    // A part of a millimetre is seen.
    let almost = conjugate(&first, Tie::Distance(380.02), None).expect("a pair");
    assert!(!profiles_coincide(&first, &almost));
}

#[test]
fn what_leaves_no_room_says_what_would() {
    let first = cam("translating-flat", 60.0, &[], lengths(&rise_and_return(14.0)), Rotation::CounterClockwise);
    let error = conjugate(&first, Tie::Distance(70.0), None).expect_err("less than Rb + smax");
    assert_eq!(error.key, "distance");
    let (least, most) = working_ties(&first, Tie::Distance(0.0), None).expect("far enough is always possible");
    assert!(most.is_infinite());
    let level = |distance: f64| {
        let second = conjugate(&first, Tie::Distance(distance), None).expect("there is room");
        Analysis::of(&second, 720).findings.iter().all(|finding| finding.level < Level::Unacceptable)
    };
    assert!(level(least * (1.0 + 1e-7)) && !level(least * (1.0 - 1e-4)), "{least} is the least");
    assert!(conjugate(&first, Tie::Angle(1.0), None).is_err(), "a sliding follower has no angle");
    let swinging = cam(
        "oscillating-roller",
        50.0,
        &[("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 100.0)],
        degrees(&rise_and_return(9.0)),
        Rotation::CounterClockwise,
    );
    let (least, most) = working_ties(&swinging, Tie::Angle(0.0), None).expect("some angle works");
    for angle in [least, 0.5 * (least + most), most] {
        let second = conjugate(&swinging, Tie::Angle(angle), None).expect("within");
        assert!(Analysis::of(&second, 720).findings.iter().all(|finding| finding.level < Level::Unacceptable));
    }
}

#[test]
fn a_cam_of_constant_breadth_is_as_wide_in_every_direction() {
    let mirrored: Vec<Segment> = [("cycloidal", 100.0, 12.0), ("dwell", 80.0, 0.0)]
        .iter()
        .filter_map(|&(law, beta, rise)| Segment::of(law, beta, rise))
        .collect();
    let programs = [
        ("harmonic", Generator::Harmonic.program(12.0).expect("program")),
        ("seven arcs", Generator::CircularArc { sides: 7 }.program(1.5).expect("program")),
        ("mirrored", Program::on(Cycle::Mirrored, &mirrored).expect("program")),
    ];
    for (name, program) in programs {
        let top = program.at(0.0).s + program.at(PI).s;
        let yoked = cam("translating-flat", 40.0, &[], program, Rotation::CounterClockwise).closed_by(Closure::Yoke);
        let points = profile(&yoked);
        for k in 0..360 {
            // Away from the joints of the arcs, where a parabola through three stations would span two of them.
            let direction = Point::from_polar(1.0, TAU * (f64::from(k) + 0.5) / 720.0);
            let along: Vec<f64> = points.iter().map(|p| p.re * direction.re + p.im * direction.im).collect();
            let breadth = -least(&along) - least(&along.iter().map(|value| -value).collect::<Vec<_>>());
            assert!((breadth - (80.0 + top)).abs() < FIT * 80.0, "{name}, direction {k}: {breadth}");
        }
    }
}

#[test]
fn a_cam_of_constant_diameter_keeps_two_rollers_apart() {
    let program = Generator::Harmonic.program(20.0).expect("program");
    let yoked = cam("translating-roller", 40.0, &[("roller_radius", 8.0)], program, Rotation::Clockwise)
        .closed_by(Closure::Yoke);
    let analysis = Analysis::of(&yoked, 720);
    assert_eq!(analysis.level, Level::Acceptable, "{:?}", analysis.findings);
    let points = profile(&yoked);
    let Element::Disc { centre, radius } = yoked.follower.element() else { panic!("a roller") };
    // The far roller hangs on the same yoke, 2Rp + smax below.
    let far = Element::Disc { centre: centre - Point::new(0.0, 2.0 * 48.0 + 20.0), radius };
    for k in 0..72 {
        let theta = TAU * f64::from(k) / 72.0 + 0.02;
        let s = yoked.program.at(theta).s;
        assert!(gap(&yoked, far, s, theta, &points).abs() < FIT * 40.0, "at {theta}");
        let touch = yoked.far_contact(theta).expect("a yoke has a far side");
        let far_centre = centre - Point::new(0.0, 116.0 - s);
        assert!(((touch - far_centre).norm() - radius).abs() < 1e-9);
    }
}

#[test]
fn a_balanced_tie_makes_both_base_circles_alike_and_the_angle_of_a_pair_is_measured() {
    let sliding =
        [("translating-flat", vec![]), ("translating-roller", vec![("roller_radius", 10.0), ("eccentricity", 7.0)])];
    for (id, given) in sliding {
        let first = cam(id, 90.0, &given, lengths(&rise_and_return(14.0)), Rotation::CounterClockwise);
        let tie = balanced_tie(&first, Tie::Distance(0.0)).expect(id);
        let second = conjugate(&first, tie, None).expect(id);
        assert!((second.follower.base_radius() - 90.0).abs() < 1e-9, "{id}: {}", second.follower.base_radius());
        assert_eq!(angle_between(&first, &second), None, "{id}");
    }
    let swinging = [
        ("oscillating-roller", vec![("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 110.0)]),
        ("oscillating-flat", vec![("pivot_distance", 150.0), ("face_offset", 8.0)]),
    ];
    for (id, given) in swinging {
        let first = cam(id, 60.0, &given, degrees(&rise_and_return(9.0)), Rotation::Clockwise);
        let by_angle = balanced_tie(&first, Tie::Angle(0.0)).expect(id);
        let second = conjugate(&first, by_angle, None).expect(id);
        assert!((second.follower.base_radius() - 60.0).abs() < 1e-9, "{id}: {}", second.follower.base_radius());
        assert!((angle_between(&first, &second).expect(id) - by_angle.value()).abs() < 1e-12, "{id}");
        assert_eq!(balanced_tie(&first, Tie::BaseRadius(0.0)), Some(Tie::BaseRadius(60.0)), "{id}");
    }
}

#[test]
fn a_swing_of_half_a_turn_leaves_no_room_for_a_second_arm() {
    let wide = [("cycloidal", 90.0, 170.0), ("cycloidal", 90.0, 30.0), ("cycloidal", 180.0, -200.0)];
    let roller = [("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 80.0)];
    let cam = Cam::new(degrees(&wide), follower("oscillating-roller", 40.0, &roller, Rotation::CounterClockwise));
    assert!(conjugate(&cam, Tie::BaseRadius(40.0), None).is_err());
    assert_eq!(balanced_tie(&cam, Tie::BaseRadius(40.0)), None);
}
