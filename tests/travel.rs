//! Cams that travel and cams with a groove: the roller laid against the finished profile, closed forms, and what is refused.

mod support;

use levalab_core::{
    Analysis, Cam, Closure, Column, Cure, Cycle, FindingKind, Follower, FollowerKind, GeometryProblem, Level, Point,
    Program, Rotation, Segment, Svaj, prescribe, resized,
};
use support::{follower, lengths};

const LENGTH: f64 = 100.0;

fn on_travel(rows: &[(&str, f64, f64)]) -> Program {
    let by_length = |&(law, beta, rise): &(&str, f64, f64)| Segment { beta, ..Segment::of(law, 1.0, rise).expect(law) };
    Program::on(Cycle::Travel(LENGTH), &rows.iter().map(by_length).collect::<Vec<_>>()).expect("a travel")
}

fn wedge(rows: &[(&str, f64, f64)], radius: f64) -> Cam {
    let kind = FollowerKind::by_id("translating-roller").expect("roller");
    Cam::new(on_travel(rows), Follower::on_travel(kind, &[radius, 0.0, 0.0, 0.0]).expect("it rests"))
}

const ROWS: [(&str, f64, f64); 4] =
    [("dwell", 20.0, 0.0), ("polynomial-4-5-6-7", 45.0, 15.0), ("dwell", 15.0, 0.0), ("cycloidal", 20.0, -2.0)];

fn points(analysis: &Analysis, x: Column, y: Column) -> Vec<Point> {
    let (x, y) = (analysis.column(x).expect("x"), analysis.column(y).expect("y"));
    x.iter().zip(y).map(|(&x, &y)| Point::new(x, y)).collect()
}

/// The least distance from a point to a curve, by the parabola through the nearest station and its neighbours.
fn distance(from: Point, curve: &[Point]) -> f64 {
    let far: Vec<f64> = curve.iter().map(|point| (point - from).norm()).collect();
    let i = (1..far.len() - 1).min_by(|&a, &b| far[a].total_cmp(&far[b])).expect("stations");
    let (slope, bend) = (0.5 * (far[i + 1] - far[i - 1]), far[i - 1] - 2.0 * far[i] + far[i + 1]);
    if bend > 0.0 { far[i] - 0.5 * slope * slope / bend } else { far[i] }
}

#[test]
fn the_roller_of_a_wedge_touches_its_profile_all_along() {
    let cam = wedge(&ROWS, 6.0);
    let analysis = Analysis::of(&cam, 20_000);
    let profile = points(&analysis, Column::X, Column::Y);
    for k in 1..100 {
        let x = LENGTH * f64::from(k) / 100.0 + 0.003;
        let centre = Point::new(x, 6.0 + cam.program.at(x).s);
        assert!((distance(centre, &profile) - 6.0).abs() < 1e-9, "at {x}");
    }
}

#[test]
fn the_pressure_angle_of_a_wedge_is_its_slope_and_rho_that_of_a_graph() {
    let cam = wedge(&ROWS, 6.0);
    let analysis = Analysis::of(&cam, 500);
    let column = |column| analysis.column(column).expect("a column");
    for row in 0..=500 {
        let (v, a) = (column(Column::V)[row], column(Column::A)[row]);
        assert!((column(Column::PressureAngle)[row] - v.atan()).abs() < 1e-14);
        let rho = column(Column::Rho)[row];
        let expect = -(1.0 + v * v).powf(1.5) / a - 6.0;
        assert!(a.abs() < 1e-9 || (rho - expect).abs() < 1e-9 * expect.abs(), "row {row}: {rho} and {expect}");
    }
    let ends = (column(Column::Theta)[500], column(Column::S)[500], column(Column::X)[500], column(Column::Y)[500]);
    assert!((ends.0 - 100.0).abs() + (ends.1 - 13.0).abs() + (ends.2 - 100.0).abs() + (ends.3 - 13.0).abs() < 1e-12);
}

#[test]
fn a_profile_is_straight_where_its_curvature_is_nothing_but_rounding() {
    let wedge = wedge(&ROWS, 6.0);
    let bend = wedge.at(42.5).1.bend;
    assert_eq!((bend, 1.0 / bend), (0.0, f64::INFINITY), "halfway up a rise that is its own reverse");
    let rho = Analysis::of(&wedge, 40).column(Column::Rho).expect("rho")[17];
    assert_eq!(rho, f64::INFINITY, "and so in the table");
    let beside = 1.0 / wedge.at(42.5 + 1e-6).1.bend;
    assert!(beside.abs() > 1e6 && beside.is_finite(), "just beside it is not: {beside}");
    // A turning cam with a straight side: r = d/cos θ.
    let turning = Cam::new(lengths(&[("cycloidal", 180.0, 9.0), ("cycloidal", 180.0, -9.0)]), knife(30.0));
    for k in -50..=50 {
        let (sin, cos) = (0.01 * f64::from(k)).sin_cos();
        let d = 33.3;
        let motion = Svaj::new(d / cos - 30.0, d * sin / (cos * cos), d * (1.0 + sin * sin) / cos.powi(3), 0.0);
        assert_eq!(turning.contact(motion).bend, 0.0, "{k}: the side is straight");
    }
}

fn knife(base_radius: f64) -> Follower {
    follower("translating-knife", base_radius, &[], Rotation::CounterClockwise)
}

#[test]
fn a_wedge_turns_back_at_its_ends() {
    let jumps = |rows: &[(&str, f64, f64)]| {
        let joints = on_travel(rows).classified_joints();
        (joints[0].jump, joints[joints.len() - 1].jump, joints[joints.len() - 1].theta)
    };
    let ramp = [("constant-velocity", 100.0, 5.0)];
    assert_eq!(jumps(&ramp), (Some(1), Some(1), LENGTH), "a ramp turns back with a blow at both ends");
    let eased = [("dwell", 10.0, 0.0), ("cycloidal", 80.0, 5.0), ("dwell", 10.0, 0.0)];
    assert_eq!(jumps(&eased), (None, None, LENGTH));
    assert_eq!(
        jumps(&[("cycloidal", 100.0, 5.0)]),
        (Some(3), Some(3), LENGTH),
        "the jerk changes sign on the way back"
    );
}

#[test]
fn a_wedge_too_steep_is_cured_by_its_length() {
    let rows = [("dwell", 30.0, 0.0), ("cycloidal", 40.0, 20.0), ("dwell", 30.0, 0.0)];
    let cam = wedge(&rows, 6.0);
    let analysis = Analysis::of(&cam, 360);
    let steep = analysis.findings.iter().position(|f| f.kind == FindingKind::PressureAngle).expect("45° at least");
    // tan φ = 2·20/40 there; 30° asks for a travel of 100·(2·20/40)/tan 30° at least.
    let [Cure::Travel(length)] = prescribe(&cam, &analysis)[steep][..] else { panic!("one cure") };
    let for_the_slope = 100.0 / 30_f64.to_radians().tan();
    assert!(length >= for_the_slope * (1.0 - 1e-9), "{length}");
    let longer = resized(&cam, length).expect("longer");
    assert!(Analysis::of(&longer, 360).level < Level::Unacceptable);
    assert!(Analysis::of(&resized(&cam, 0.99 * length).expect("shorter"), 360).level == Level::Unacceptable);
}

#[test]
fn what_cannot_ride_on_a_wedge_is_refused() {
    let refusal = |id: &str, values: [f64; 4]| {
        let error = Follower::on_travel(FollowerKind::by_id(id).expect(id), &values).expect_err(id);
        (error.key, error.problem)
    };
    assert_eq!(refusal("translating-flat", [0.0; 4]), ("contact", GeometryProblem::Unsuited));
    assert_eq!(refusal("translating-roller", [0.4, 0.2, 0.0, 0.0]), ("eccentricity", GeometryProblem::Unsuited));
    assert_eq!(refusal("oscillating-roller", [0.5, 1.0, 1.0, 0.0]), ("motion", GeometryProblem::Unsuited));
    assert!(cam_is_not_resized());
}

fn cam_is_not_resized() -> bool {
    wedge(&ROWS, 6.0).with_base_radius(10.0).is_err()
}

#[test]
fn a_roller_in_a_groove_touches_both_walls() {
    let rows = [("cycloidal", 120.0, 12.0), ("dwell", 60.0, 0.0), ("cycloidal", 120.0, -12.0), ("dwell", 60.0, 0.0)];
    for rotation in support::ROTATIONS {
        let given = [("roller_radius", 8.0), ("eccentricity", 4.0)];
        let cam =
            Cam::new(lengths(&rows), follower("translating-roller", 40.0, &given, rotation)).closed_by(Closure::Groove);
        let analysis = Analysis::of(&cam, 20_000);
        let inner = points(&analysis, Column::X, Column::Y);
        let outer = points(&analysis, Column::OuterX, Column::OuterY);
        let pitch = points(&analysis, Column::PitchX, Column::PitchY);
        for k in (100..19_900).step_by(617) {
            assert!((distance(pitch[k], &inner) - 8.0).abs() < 1e-9, "inner wall, station {k}");
            assert!((distance(pitch[k], &outer) - 8.0).abs() < 1e-9, "outer wall, station {k}");
        }
    }
}

#[test]
fn a_roller_too_large_for_a_hollow_undercuts_the_outer_wall() {
    let rows = [("simple-harmonic", 40.0, 30.0), ("simple-harmonic", 40.0, -30.0), ("dwell", 280.0, 0.0)];
    let cam = |radius: f64| {
        let roller =
            follower("translating-roller", 61.0 - radius, &[("roller_radius", radius)], Rotation::CounterClockwise);
        Cam::new(lengths(&rows), roller)
    };
    let has = |cam: &Cam| Analysis::of(cam, 720).findings.iter().any(|f| f.kind == FindingKind::GrooveUndercut);
    let hollow = Analysis::of(&cam(1.0), 720).summary.tightest_hollow.expect("hollow beside the dwell").0 + 1.0;
    let grooved = |radius: f64| cam(radius).closed_by(Closure::Groove);
    assert!(has(&grooved(-hollow * 1.2)) && !has(&grooved(1.0)), "the pitch curve bends with {hollow}");
    assert!(!has(&cam(-hollow * 1.2)), "without an outer wall there is nothing to cut");
}
