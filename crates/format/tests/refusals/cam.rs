//! Geometry and applications that cannot be.

use crate::{check, refusal_of};
use levalab_core::Misfit;
use levalab_format::{CamRefusal, Design, Measure, Problem, example};
use serde_json::{Value, json};

#[test]
fn geometry_that_cannot_be_is_placed() {
    check("/follower/eccentricity", json!(42), "follower.eccentricity", |problem| {
        *problem == Problem::Misfit(Misfit::Eccentricity { eccentricity: 42.0, prime_radius: 42.0 })
    });
    let place = |name: &str, place: &str, value: f64| {
        let error = refusal_of(name, place, json!(value));
        (error.path.to_string(), error.problem)
    };
    let (path, problem) = place("2RO", "/follower/pivot_distance", 200.0);
    assert_eq!(path, "follower.pivot_distance");
    assert_eq!(problem, Problem::Misfit(Misfit::Triangle { pivot_distance: 200.0, arm: 80.0, prime_radius: 50.0 }));
    let (path, problem) = place("4PO", "/follower/pivot_distance", 30.0);
    assert_eq!(
        (path.as_str(), problem),
        ("follower.pivot_distance", Problem::Misfit(Misfit::FaceOutOfReach { pivot_distance: 30.0, needed: 40.0 }))
    );
    let (path, problem) = place("10EX", "/follower/face_angle", 90.0);
    assert_eq!(path, "follower.face_angle");
    assert_eq!(problem, Problem::NotBetween { found: 90.0, min: -90.0, max: 90.0, measure: Measure::Degrees });
}

#[test]
fn applications_that_cannot_be_are_placed() {
    let at = |place: &str, value: Value| {
        let error = refusal_of("R6", &format!("/application{place}"), value);
        (error.path.to_string(), error.problem)
    };
    let path = |place: &str, value: Value| at(place, value).0;
    assert_eq!(at("/kind", Value::Null), ("application.kind".to_owned(), Problem::Missing));
    let (place, problem) = at("/kind", json!("brake"));
    assert_eq!(place, "application.kind");
    assert!(matches!(problem, Problem::WrongWord { expected, .. } if expected.contains(&"pump")));
    assert_eq!(at("/piston_radius", Value::Null), ("application.piston_radius".to_owned(), Problem::Missing));
    let (place, problem) = at("/piston_radius", json!(0));
    assert_eq!(place, "application.piston_radius");
    assert_eq!(problem, Problem::NotPositive { found: 0.0, measure: Measure::Length });
    assert_eq!(path("/pressure_per_volume", json!(1e13)), "application.pressure_per_volume");
    assert!(matches!(at("/seat_angle", json!(45)).1, Problem::UnknownField { .. }));
    assert!(matches!(at("/output", json!("volume")).1, Problem::WrongWord { .. }));
    assert!(matches!(at("/by", json!("days")).1, Problem::WrongWord { .. }));
    let (place, problem) = at("/targets", json!([[0, 0], [361, 1]]));
    assert_eq!(place, "application.targets[1][0]");
    assert_eq!(problem, Problem::OutOfRange { found: 361.0, min: 0.0, max: 360.0, measure: Measure::Degrees });
    assert_eq!(path("/targets", json!([[0, 1e13]])), "application.targets[0][1]");
    assert_eq!(path("/targets", json!([[0, "1"]])), "application.targets[0][1]");
    assert_eq!(path("/targets", json!([[0, 1, 2]])), "application.targets[0]");
    assert_eq!(path("/targets", json!(vec![json!([0, 1]); 65])), "application.targets");
    let valve = |angle: f64| json!({"kind": "valve", "seat_diameter": 1, "seat_angle": angle});
    let steep = refusal_of("R6", "/application", valve(80.0));
    assert_eq!(steep.path.to_string(), "application.seat_angle");
    assert!(matches!(steep.problem, Problem::OutOfRange { measure: Measure::Degrees, .. }));
    let swings = refusal_of("2RO", "/application", valve(45.0));
    assert_eq!(
        (swings.path.to_string().as_str(), swings.problem),
        ("application", Problem::Cam(CamRefusal::SwingingApplication))
    );
}

#[test]
fn what_is_usual_in_an_application_is_left_out() {
    let mut value = example("R6").expect("R6").to_value();
    value["application"] = json!({"kind": "valve", "seat_diameter": 1, "output": "area", "by": "theta", "targets": []});
    let design = Design::from_value(&value).expect("a valve");
    let written = design.to_value();
    assert_eq!(written["application"], json!({"kind": "valve", "seat_diameter": 1, "seat_angle": 45}));
    assert_eq!(Design::from_value(&written), Ok(design));
}
