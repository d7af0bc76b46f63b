//! A design from what its machine must do: requirements in place of segments.

use crate::design::Design;
use crate::fields::{Field, Object};
use crate::limits::MAX_SEGMENTS;
use crate::report::tidy;
use crate::write::segment_value;
use crate::{CamKind, CamRefusal, DesignError, Edit, Path, Problem, SegmentDesign, json};
use levalab_core::law::{Condition, Data};
use levalab_core::{Choice, Demand, JoinError, Segment, Taste, join};
use serde_json::{Map, Value};
use std::f64::consts::TAU;

/// The field that takes the place of `segments`.
const REQUIREMENTS: &str = "requirements";

/// The fields that say how to join, besides.
const TASTE: [&str; 2] = ["high_speed", "least"];

/// What is to be low, by its order from 1.
const LEAST: [&str; 3] = ["velocity", "acceleration", "jerk"];

/// A design that was joined, and what was chosen in each gap: angles in radians, heights in the unit of *s* (degrees when the follower swings).
#[derive(Clone, Debug)]
pub struct Joined {
    /// The design, as good as one that was read from a file.
    pub design: Design,
    /// What was chosen, with its figures in the units of the design.
    pub choices: Vec<Choice>,
    /// How it was to be joined.
    pub taste: Taste,
}

/// Joins the requirements of a file: a design file with `requirements` in place of `segments`.
///
/// # Errors
/// As for a design file, and where requirements cannot be met.
pub fn joined_from_bytes(bytes: &[u8]) -> Result<Joined, DesignError> {
    joined(&json::parse_bytes(bytes)?)
}

/// Joins the requirements of an object such as a file holds.
///
/// # Errors
/// As [`joined_from_bytes`].
pub fn joined(value: &Value) -> Result<Joined, DesignError> {
    let file = Object::any(value, Path::default())?;
    let list = file.required(REQUIREMENTS)?;
    let demands: Vec<Demand> = list.items(MAX_SEGMENTS)?.map(|item| read_demand(&item)).collect::<Result<_, _>>()?;
    let high_speed = file.optional(TASTE[0]).is_some_and(|field| *field.value == true);
    let least = if file.optional(TASTE[1]).is_some() { file.word(TASTE[1], &LEAST)? + 1 } else { 2 };
    let taste = Taste { high_speed, least };

    // The design around them, checked with a program that any cam may have.
    let mut fields: Map<String, Value> = value.as_object().cloned().unwrap_or_default();
    for key in [REQUIREMENTS].iter().chain(&TASTE) {
        fields.remove(*key);
    }
    fields.insert("segments".to_owned(), serde_json::json!([{"law": "dwell", "beta": 360}]));
    let around = Design::draft(&Value::Object(fields))?;
    if !matches!(around.kind, CamKind::Rotating | CamKind::Grooved) {
        return Err(DesignError::at(REQUIREMENTS, CamRefusal::Unsuited { kind: around.kind.word() }));
    }
    check_demands(&demands, *around.heights().end())?;

    let joining = join(&demands, taste).map_err(|JoinError { demand, problem }| {
        let place = if demands.is_empty() { Path::from(REQUIREMENTS) } else { Path::from(REQUIREMENTS).join(demand) };
        DesignError::at(place, Problem::Join(problem))
    })?;
    let segments: Vec<Value> = in_degrees(&joining.segments).iter().map(segment_value).collect();
    let design = around.edited(&[Edit::set("segments", segments)])?;
    Ok(Joined { design, choices: joining.choices, taste })
}

/// A dwell, a line, or a point to pass. Heights and velocities stay in the unit of *s*: joining is the same in any.
fn read_demand(item: &Field) -> Result<Demand, DesignError> {
    let demand = Object::any(item.value, item.path.clone())?;
    if demand.optional("dwell").is_some() {
        demand.only(&["dwell", "s"])?;
        let [from, to] = demand.required("dwell")?.pair()?.map(f64::to_radians);
        return Ok(Demand::Dwell { from, to, height: demand.required("s")?.number()? });
    }
    if demand.optional("line").is_some() {
        demand.only(&["line", "s"])?;
        let [from, to] = demand.required("line")?.pair()?.map(f64::to_radians);
        let [start, end] = demand.required("s")?.pair()?;
        return Ok(Demand::Straight { from, to, start, end });
    }
    demand.only(&["dwell", "line", "at", "s", "v"])?;
    let at = demand.required("at")?.number()?.to_radians();
    let velocity = demand.optional("v").map(|field| field.number()).transpose()?;
    Ok(Demand::Pass { at, height: demand.required("s")?.number()?, velocity })
}

/// Refuses heights beyond those of any design before anything is computed from them.
fn check_demands(demands: &[Demand], most: f64) -> Result<(), DesignError> {
    let heights = |demand: &Demand| match *demand {
        Demand::Dwell { height, .. } => [height, height],
        Demand::Straight { start, end, .. } => [start, end],
        Demand::Pass { height, velocity, .. } => [height, velocity.unwrap_or(0.0) / 1e3],
    };
    let wide = |demand: &Demand| heights(demand).iter().any(|height| height.abs() > most);
    match demands.iter().position(wide) {
        Some(k) => {
            let place = Path::from(REQUIREMENTS).join(k).join("s");
            let measure = crate::Measure::Length;
            let found = heights(&demands[k])[0];
            Err(DesignError::at(place, Problem::OutOfRange { found, min: 0.0, max: most, measure }))
        }
        None => Ok(()),
    }
}

/// Segments with their angles in degrees, as whole as they were demanded.
fn in_degrees(segments: &[Segment]) -> Vec<SegmentDesign> {
    let (mut theta, mut border) = (0.0, 0.0);
    let last = segments.len().saturating_sub(1);
    let each = segments.iter().enumerate().map(|(k, segment)| {
        theta += segment.beta;
        let end = if k == last { TAU.to_degrees() } else { tidy(f64::to_degrees(theta)) };
        let beta = tidy(end - border);
        border = end;
        let along = |at: f64| if at >= segment.beta { beta } else { tidy(at.to_degrees()) };
        let data = match &segment.data {
            Data::Conditions(conditions) => {
                let told = |c: &Condition| Condition { at: along(c.at), order: c.order, value: shortest(c.value) };
                Data::Conditions(conditions.iter().map(told).collect())
            }
            other => other.clone(),
        };
        let rise = if segment.law.free().is_some() { 0.0 } else { shortest(segment.rise) };
        SegmentDesign { law: segment.law, beta, rise, parameters: segment.parameters, data }
    });
    each.collect()
}

/// Twelve significant digits: what sums and quotients of typed decimals leave beyond them is rounding.
fn shortest(value: f64) -> f64 {
    const DIGITS: i32 = 12;
    if value == 0.0 || !value.is_finite() {
        return 0.0;
    }
    let places = DIGITS - 1 - value.abs().log10().floor() as i32;
    let unit = 10_f64.powi(places.abs());
    let rounded = if places < 0 { (value / unit).round() * unit } else { (value * unit).round() / unit };
    if rounded.is_finite() { rounded } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;
    use levalab_core::JoinProblem;
    use serde_json::json;

    fn asked(requirements: Value) -> Value {
        let mut value = example("9RT").expect("9RT").to_value();
        value.as_object_mut().expect("fields").remove("segments");
        value[REQUIREMENTS] = requirements;
        value
    }

    #[test]
    fn requirements_become_a_design_in_round_numbers() {
        let requirements = json!([{"dwell": [0, 60], "s": 0}, {"line": [100, 160], "s": [4, 16]}, {"at": 240, "s": 12.5}, {"dwell": [300, 320], "s": 5}]);
        let joined = joined(&asked(requirements)).expect("joined");
        let betas: Vec<f64> = joined.design.segments.iter().map(|segment| segment.beta).collect();
        assert_eq!(&betas[..3], [60.0, 40.0, 60.0]);
        assert_eq!(betas.iter().sum::<f64>(), 360.0);
        assert_eq!(joined.design.segments[1].rise, 4.0);
        assert_eq!(joined.choices.len(), 3);
        let program = joined.design.cam().expect("a cam").program;
        assert!((program.at(240_f64.to_radians()).s - 12.5).abs() < 1e-9);
        assert_eq!(Design::from_json(&joined.design.to_json()), Ok(joined.design));
    }

    #[test]
    fn a_follower_that_swings_and_high_speeds_are_joined_too() {
        let mut value = example("2RO").expect("2RO").to_value();
        value.as_object_mut().expect("fields").remove("segments");
        value[REQUIREMENTS] = json!([{"dwell": [0, 90], "s": 0}, {"at": 180, "s": 12, "v": 0}]);
        value["high_speed"] = json!(true);
        let joined = joined(&value).expect("joined");
        let program = joined.design.cam().expect("a cam").program;
        assert!((program.at(180_f64.to_radians()).s.to_degrees() - 12.0).abs() < 1e-9);
        assert!(program.classified_joints().iter().all(|joint| joint.jump.is_none()));
    }

    #[test]
    fn what_cannot_be_met_is_placed() {
        let refused = |requirements: Value| joined(&asked(requirements)).expect_err("refused");
        let check = |requirements: Value, path: &str, problem: JoinProblem| {
            let error = refused(requirements);
            assert_eq!((error.path.to_string().as_str(), &error.problem), (path, &Problem::Join(problem)), "{error}");
        };
        check(json!([]), "requirements", JoinProblem::Nothing);
        check(
            json!([{"dwell": [0, 60], "s": 0}, {"dwell": [50, 90], "s": 5}]),
            "requirements[1]",
            JoinProblem::Overlap { other: 0 },
        );
        check(json!([{"dwell": [0, 60], "s": 3}]), "requirements[0]", JoinProblem::StartsHigh);
        assert_eq!(refused(json!([{"dwell": [0], "s": 0}])).path.to_string(), "requirements[0].dwell");
        assert_eq!(refused(json!([{"at": 50}])).path.to_string(), "requirements[0].s");
        assert_eq!(refused(json!([{"at": 50, "s": 1, "w": 2}])).path.to_string(), "requirements[0].w");
        assert_eq!(refused(json!([{"at": 50, "s": 1e9}])).path.to_string(), "requirements[0].s");
        let mut value = asked(json!([{"at": 50, "s": 1}]));
        value["least"] = json!("weight");
        assert!(matches!(joined(&value).expect_err("refused").problem, Problem::WrongWord { .. }));
    }
}
