//! What a design file may not say, and where each refusal points.

mod cam;
mod data;
mod fields;
mod program;

use levalab_format::{Design, DesignError, Problem, example};
use serde_json::Value;

/// Example 9RT with one place changed; `null` as a value takes the field out.
fn refusal(place: &str, value: Value) -> DesignError {
    refusal_of("9RT", place, value)
}

fn refusal_of(name: &str, place: &str, value: Value) -> DesignError {
    let mut design = example(name).expect(name).to_value();
    let (parent, last) = place.rsplit_once('/').expect("a pointer");
    let parent = design.pointer_mut(parent).expect(place);
    match (parent, value) {
        (Value::Object(fields), Value::Null) => drop(fields.remove(last)),
        (Value::Object(fields), value) => drop(fields.insert(last.to_owned(), value)),
        (Value::Array(items), value) => items[last.parse::<usize>().expect("an index")] = value,
        _ => panic!("{place}"),
    }
    Design::from_value(&design).expect_err(place)
}

fn check(place: &str, value: Value, path: &str, expected: impl Fn(&Problem) -> bool) {
    let error = refusal(place, value);
    assert_eq!(error.path.to_string(), path, "{error}");
    assert!(expected(&error.problem), "{error}");
}
