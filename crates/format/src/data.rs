//! What a free law is made from, as design files hold it: degrees along the segment, heights in the unit of the design.

use crate::decimal::Decimal;
use crate::limits::{DERIVATIVE, RISE, SWING};
use crate::read::{Field, Object};
use crate::report::tidy;
use crate::write::number;
use crate::{DataRefusal, DesignError, Kind, Measure, Path, Problem, SegmentDesign};
use levalab_core::Quantity;
use levalab_core::law::{Condition, Data, DataKind, DataProblem, Law, MAX_CONDITIONS};
use serde_json::Value;

/// The field of a segment that holds data of a kind.
pub(crate) fn key(kind: DataKind) -> &'static str {
    match kind {
        DataKind::Conditions => "conditions",
    }
}

/// The field that a law takes besides the numbers, when it takes one.
#[must_use]
pub fn data_key(law: &Law) -> Option<&'static str> {
    law.free().map(|free| key(free.data))
}

/// Reads the data of a law from its segment.
pub(crate) fn read(segment: &Object, law: &Law) -> Result<Data, DesignError> {
    let Some(free) = law.free() else { return Ok(Data::None) };
    let field = segment.required(key(free.data))?;
    match free.data {
        DataKind::Conditions => {
            let each = field.items(MAX_CONDITIONS)?.map(|item| read_condition(&item));
            Ok(Data::Conditions(each.collect::<Result<_, _>>()?))
        }
    }
}

fn read_condition(item: &Field) -> Result<Condition, DesignError> {
    let condition = Object::any(item.value, item.path.clone())?;
    condition.only(&["at", "order", "value"])?;
    let order = condition.required("order")?;
    let found = order.number()?;
    if ![0.0, 1.0, 2.0, 3.0].contains(&found) {
        return Err(DesignError { path: order.path, problem: DataRefusal::WrongOrder { found }.into() });
    }
    let (at, value) = (condition.required("at")?.number()?, condition.required("value")?.number()?);
    Ok(Condition { at, order: found as u8, value })
}

/// The field of a segment that holds its data.
#[must_use]
pub fn entry(data: &Data) -> Option<(&'static str, Value)> {
    let value = match data {
        Data::None => return None,
        Data::Conditions(conditions) => conditions.iter().map(condition_value).collect(),
    };
    Some((key(data.kind()?), value))
}

fn condition_value(condition: &Condition) -> Value {
    let Condition { at, order, value } = *condition;
    let fields = [("at", number(at)), ("order", order.into()), ("value", number(value))];
    Value::Object(fields.map(|(key, value)| (key.to_owned(), value)).into_iter().collect())
}

/// Refuses numbers out of range, at their places.
pub(crate) fn check(here: &Path, data: &Data, oscillating: bool) -> Result<(), DesignError> {
    let (travel, heights) = if oscillating { (Measure::Degrees, &SWING) } else { (Measure::Length, &RISE) };
    match data {
        Data::None => Ok(()),
        Data::Conditions(conditions) => {
            for (item, condition) in conditions.iter().enumerate() {
                let range = if condition.order == 0 { heights } else { &DERIVATIVE };
                let path = here.join(key(DataKind::Conditions)).join(item).join("value");
                crate::check::check_range(path, condition.value, range, travel)?;
            }
            Ok(())
        }
    }
}

/// The height at which a segment's data say that it ends, when they do.
pub(crate) fn stated_end(segment: &SegmentDesign) -> Option<Decimal> {
    let value = match &segment.data {
        Data::None => None,
        Data::Conditions(conditions) => {
            conditions.iter().find(|c| c.order == 0 && c.at == segment.beta).map(|c| c.value)
        }
    };
    value.map(Decimal::of)
}

/// The segment over another β: what lies within it keeps its place in proportion.
pub(crate) fn stretched(segment: &SegmentDesign, beta: f64) -> SegmentDesign {
    let along = |at: f64| if at == segment.beta { beta } else { tidy(at * beta / segment.beta) };
    let mut after = SegmentDesign { beta, ..segment.clone() };
    for (value, parameter) in after.parameters.iter_mut().zip(segment.law.parameters) {
        if parameter.quantity == Quantity::Span {
            *value = along(*value);
        }
    }
    match &mut after.data {
        Data::None => {}
        Data::Conditions(conditions) => conditions.iter_mut().for_each(|condition| condition.at = along(condition.at)),
    }
    after
}

/// What the core refuses in the data of a segment, in the terms of the design; `stride` is what β is measured in.
pub(crate) fn refusal(here: &Path, segment: &SegmentDesign, problem: DataProblem, stride: Measure) -> DesignError {
    let Some(key) = data_key(segment.law) else { return DesignError::at(here.clone(), Problem::Missing) };
    let list = here.join(key);
    let (path, problem) = match problem {
        DataProblem::Kind => (list, Problem::Missing),
        DataProblem::Count { found, min, max } => (list, DataRefusal::WrongCount { found, min, max }.into()),
        DataProblem::NotFinite { item } => (list.join(item), Problem::NotFinite),
        DataProblem::Order { item, found } => {
            (list.join(item).join("order"), DataRefusal::WrongOrder { found: found.into() }.into())
        }
        DataProblem::Outside { item, found, beta } => {
            let problem = Problem::OutOfRange {
                found: tidy(found / beta * segment.beta),
                min: 0.0,
                max: segment.beta,
                measure: stride,
            };
            (list.join(item).join("at"), problem)
        }
        DataProblem::Repeated { item, other } => (list.join(item), DataRefusal::Repeated { other }.into()),
        DataProblem::NoHeight => (list, DataRefusal::NoHeight.into()),
        DataProblem::Dependent { items } => (list, DataRefusal::Dependent { items }.into()),
    };
    DesignError { path, problem }
}

impl Field<'_> {
    /// The items of a list, no more than may be.
    fn items(&self, limit: usize) -> Result<impl Iterator<Item = Field<'_>>, DesignError> {
        let Value::Array(items) = self.value else { return Err(self.wrong_kind(Kind::List)) };
        if items.len() > limit {
            let problem = DataRefusal::WrongCount { found: items.len(), min: 1, max: limit }.into();
            return Err(DesignError { path: self.path.clone(), problem });
        }
        Ok(items.iter().enumerate().map(|(k, value)| Field { path: self.path.join(k), value }))
    }
}
