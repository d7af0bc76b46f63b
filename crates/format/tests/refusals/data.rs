//! The data of free laws.

use crate::{check, refusal};
use levalab_core::{ExpressionFault, RoughnessCause};
use levalab_format::{DataRefusal, Kind, Measure, Problem};
use serde_json::{Value, json};

/// Example 9RT with its first segment, of 50° from 0 to 10 mm, made from data.
fn check_data(segment: Value, path: &str, expected: impl Fn(&DataRefusal) -> bool) {
    let error = refusal("/segments/0", segment);
    assert_eq!(error.path.to_string(), path, "{error}");
    assert!(matches!(&error.problem, Problem::Data(refusal) if expected(refusal)), "{error}");
}

/// A spline of the fifth degree at rest at both ends, through a point for each place given.
fn spline(places: &[f64]) -> Value {
    let end = |at: f64, s: f64| {
        (0..3).map(move |order| json!({"at": at, "order": order, "value": if order == 0 { s } else { 0.0 }}))
    };
    let inner = places.iter().map(|&at| json!({"at": at, "order": 0, "value": at / 5.0}));
    let conditions: Vec<Value> = end(0.0, 0.0).chain(inner).chain(end(50.0, 10.0)).collect();
    json!({"law": "bspline", "beta": 50, "degree": 5, "conditions": conditions})
}

#[test]
fn conditions_that_make_no_curve_are_placed() {
    let with = |conditions: Value| json!({"law": "polynomial", "beta": 50, "conditions": conditions});
    let s = |at: f64, value: f64| json!({"at": at, "order": 0, "value": value});
    check_data(with(json!([])), "segments[0].conditions", |refusal| {
        *refusal == DataRefusal::WrongCount { found: 0, min: 1, max: 24 }
    });
    check_data(
        with(json!([s(0.0, 0.0), {"at": 50, "order": 1.5, "value": 0}])),
        "segments[0].conditions[1].order",
        |refusal| *refusal == DataRefusal::WrongOrder { found: 1.5 },
    );
    check_data(with(json!([s(0.0, 0.0), s(50.0, 10.0), s(0.0, 0.0)])), "segments[0].conditions[2]", |refusal| {
        *refusal == DataRefusal::Repeated { other: 0 }
    });
    check_data(with(json!([{"at": 0, "order": 1, "value": 0}])), "segments[0].conditions", |refusal| {
        *refusal == DataRefusal::NoHeight
    });
    let birkhoff = json!([s(0.0, 0.0), {"at": 25, "order": 1, "value": 9}, s(50.0, 10.0)]);
    check_data(with(birkhoff), "segments[0].conditions", |refusal| {
        *refusal == DataRefusal::Dependent { items: vec![0, 1, 2] }
    });
    check("/segments/0", with(json!([s(0.0, 0.0), s(51.0, 10.0)])), "segments[0].conditions[1].at", |problem| {
        *problem == Problem::OutOfRange { found: 51.0, min: 0.0, max: 50.0, measure: Measure::Degrees }
    });
    check("/segments/0", with(json!([{"at": 0, "value": 0}])), "segments[0].conditions[0].order", |problem| {
        *problem == Problem::Missing
    });
    let told = json!({"law": "polynomial", "beta": 50, "rise": 9, "conditions": [s(0.0, 0.0), s(50.0, 10.0)]});
    check_data(told, "segments[0].rise", |refusal| {
        matches!(refusal, DataRefusal::RiseDisagrees { found: 9.0, expected: 10.0, .. })
    });
}

#[test]
fn knots_that_make_no_spline_are_placed() {
    let with = |places: &[f64], knots: Value| {
        let mut segment = spline(places);
        segment["knots"] = knots;
        segment
    };
    check_data(with(&[20.0, 30.0], json!([25])), "segments[0].knots", |refusal| {
        *refusal == DataRefusal::KnotCount { found: 1, expected: 2 }
    });
    for (knots, path) in [([30, 30], "[1]"), ([0, 30], "[0]"), ([20, 50], "[1]"), ([30, 20], "[1]")] {
        check_data(with(&[20.0, 30.0], json!(knots)), &format!("segments[0].knots{path}"), |refusal| {
            *refusal == DataRefusal::KnotOrder
        });
    }
    let places: Vec<f64> = (1..10).map(|k| 5.0 * f64::from(k)).collect();
    let late: Vec<f64> = (0..9).map(|k| 48.0 + 0.1 * f64::from(k)).collect();
    check_data(with(&places, json!(late)), "segments[0].knots", |refusal| {
        matches!(refusal, DataRefusal::KnotPlace { item: 6, measure: Measure::Degrees, .. })
    });
    check("/segments/0", with(&[20.0, 30.0], json!("25")), "segments[0].knots", |problem| {
        *problem == Problem::WrongKind { found: Kind::Text, expected: Kind::List }
    });
    let polynomial =
        json!({"law": "polynomial", "beta": 50, "conditions": [{"at": 0, "order": 0, "value": 0}], "knots": [25]});
    check("/segments/0", polynomial, "segments[0].knots", |problem| matches!(problem, Problem::UnknownField { .. }));
    let mut degree = spline(&[20.0]);
    degree["degree"] = json!(9);
    check("/segments/0", degree, "segments[0].degree", |problem| {
        *problem == Problem::OutOfRange { found: 9.0, min: 4.0, max: 8.0, measure: Measure::Ratio }
    });
}

#[test]
fn tables_ordinates_and_formulas_that_make_no_curve_are_placed() {
    let table = |points: Value| json!({"law": "table", "beta": 50, "points": points});
    check_data(table(json!([[0, 0], [49, 10]])), "segments[0].points[1][0]", |refusal| {
        *refusal == DataRefusal::NotAtEnd { found: 49.0, expected: 50.0, measure: Measure::Degrees }
    });
    check_data(table(json!([[0, 0], [30, 4], [20, 5], [50, 10]])), "segments[0].points[2][0]", |refusal| {
        *refusal == DataRefusal::Unordered
    });
    check_data(table(json!([[0, 0], [50]])), "segments[0].points[1]", |refusal| {
        *refusal == DataRefusal::WrongCount { found: 1, min: 2, max: 2 }
    });
    let mut rough = table(json!([[0, 0], [25, 5], [50, 10]]));
    rough["smoothing"] = json!(-0.1);
    check("/segments/0", rough, "segments[0].smoothing", |problem| {
        *problem == Problem::OutOfRange { found: -0.1, min: 0.0, max: 1e6, measure: Measure::Length }
    });
    check_data(json!({"law": "bezier", "beta": 50, "ordinates": [10]}), "segments[0].ordinates", |refusal| {
        *refusal == DataRefusal::WrongCount { found: 1, min: 2, max: 25 }
    });
    let formula = |text: &str| json!({"law": "formula", "beta": 50, "expression": text});
    check_data(
        formula("10 x^2 +"),
        "segments[0].expression",
        |refusal| matches!(refusal, DataRefusal::Expression(problem) if problem.at == 8 && problem.kind == ExpressionFault::Ends),
    );
    check_data(formula("10 sqrt(x)"), "segments[0].expression", |refusal| {
        matches!(refusal, DataRefusal::Undefined { cause: RoughnessCause::Power, .. })
    });
    check("/segments/0", formula("L x"), "segments[0].rise", |problem| *problem == Problem::Missing);
}
