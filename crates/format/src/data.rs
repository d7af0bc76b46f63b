//! What a free law is made from, as design files hold it: degrees along the segment, heights in the unit of the design.

use crate::check::check_range;
use crate::decimal::Decimal;
use crate::fields::{Field, Object};
use crate::limits::DERIVATIVE;
use crate::report::tidy;
use crate::version::max_table_points;
use crate::write::number;
use crate::{DataRefusal, DesignError, Measure, Path, SegmentDesign};
use levalab_catalogue::Version;
use levalab_core::law::{Condition, Data, DataKind, Law, MAX_ORDINATES, MAX_SPLINE_CONDITIONS};
use levalab_core::{Expression, Quantity};
use serde_json::Value;
use std::ops::RangeInclusive;

/// The field of a segment that holds data of a kind.
pub(crate) fn key(kind: DataKind) -> &'static str {
    match kind {
        DataKind::Conditions | DataKind::Spline => "conditions",
        DataKind::Points => "points",
        DataKind::Ordinates => "ordinates",
        DataKind::Expression => "expression",
    }
}

/// The field of a segment that may hold the knots of a spline.
pub(crate) const KNOTS: &str = "knots";

/// The field that a law takes besides the numbers, when it takes one.
#[must_use]
pub fn data_key(law: &Law) -> Option<&'static str> {
    law.free().map(|free| key(free.data))
}

/// Every field that a law may take besides the numbers.
pub(crate) fn keys(law: &Law) -> impl Iterator<Item = &'static str> {
    let spline = law.free().is_some_and(|free| free.data == DataKind::Spline);
    data_key(law).into_iter().chain(spline.then_some(KNOTS))
}

/// Reads the data of a law from its segment.
pub(crate) fn read(segment: &Object, law: &Law, known: Version) -> Result<Data, DesignError> {
    let Some(free) = law.free() else { return Ok(Data::None) };
    let field = segment.required(key(free.data))?;
    match free.data {
        DataKind::Conditions | DataKind::Spline => {
            let each = field.items(MAX_SPLINE_CONDITIONS)?.map(|item| read_condition(&item));
            let conditions = each.collect::<Result<_, _>>()?;
            match segment.optional(KNOTS) {
                Some(field) => {
                    let each = field.items(MAX_SPLINE_CONDITIONS)?.map(|item| item.number());
                    Ok(Data::Spline { conditions, knots: each.collect::<Result<_, _>>()? })
                }
                None => Ok(Data::Conditions(conditions)),
            }
        }
        DataKind::Points => {
            let each = field.items(max_table_points(known))?.map(|item| item.pair());
            Ok(Data::Points(each.collect::<Result<_, _>>()?))
        }
        DataKind::Ordinates => {
            let each = field.items(MAX_ORDINATES)?.map(|item| item.number());
            Ok(Data::Ordinates(each.collect::<Result<_, _>>()?))
        }
        DataKind::Expression => Ok(Data::Expression(field.text()?)),
    }
}

fn read_condition(item: &Field) -> Result<Condition, DesignError> {
    let condition = Object::any(item.value, item.path.clone())?;
    condition.only(&["at", "order", "value"])?;
    let order = condition.required("order")?;
    let found = order.number()?;
    if ![0.0, 1.0, 2.0, 3.0].contains(&found) {
        return Err(DesignError::at(order.path, DataRefusal::WrongOrder { found }));
    }
    let (at, value) = (condition.required("at")?.number()?, condition.required("value")?.number()?);
    Ok(Condition { at, order: found as u8, value })
}

/// True when the curve of a segment depends on a rise that is told, as that of a formula that names L.
pub(crate) fn asks_for_rise(law: &Law, data: &Data) -> bool {
    match data {
        Data::Expression(text) => Expression::parse(text).is_ok_and(|expression| expression.names_rise()),
        _ => !law.is_dwell() && law.free().is_none(),
    }
}

/// The field of a segment that holds its data, but for the knots of a spline.
#[must_use]
pub fn entry(data: &Data) -> Option<(&'static str, Value)> {
    let value = match data {
        Data::None => return None,
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => {
            conditions.iter().map(condition_value).collect()
        }
        Data::Points(points) => points.iter().map(|&[at, s]| Value::from(vec![number(at), number(s)])).collect(),
        Data::Ordinates(ordinates) => ordinates.iter().map(|&s| number(s)).collect(),
        Data::Expression(text) => text.as_str().into(),
    };
    Some((key(data.kind()?), value))
}

/// The fields of a segment that hold its data.
pub(crate) fn entries(data: &Data) -> impl Iterator<Item = (&'static str, Value)> {
    let knots = match data {
        Data::Spline { knots, .. } => Some((KNOTS, knots.iter().map(|&knot| number(knot)).collect())),
        _ => None,
    };
    entry(data).into_iter().chain(knots)
}

fn condition_value(condition: &Condition) -> Value {
    let Condition { at, order, value } = *condition;
    let fields = [("at", number(at)), ("order", order.into()), ("value", number(value))];
    Value::Object(fields.map(|(key, value)| (key.to_owned(), value)).into_iter().collect())
}

/// Refuses numbers out of range, at their places.
pub(crate) fn check(
    here: &Path,
    segment: &SegmentDesign,
    lift: Measure,
    heights: &RangeInclusive<f64>,
) -> Result<(), DesignError> {
    let data = &segment.data;
    for (value, parameter) in segment.parameters.iter().zip(segment.law.parameters) {
        if parameter.quantity == Quantity::Height {
            check_range(here.join(parameter.key), *value, &(0.0..=*heights.end()), lift)?;
        }
    }
    let list = data.kind().map_or_else(Path::default, |kind| here.join(key(kind)));
    let height = |path: Path, value: f64| check_range(path, value, heights, lift);
    match data {
        Data::None | Data::Expression(_) => Ok(()),
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => {
            conditions.iter().enumerate().try_for_each(|(item, condition)| {
                let range = if condition.order == 0 { heights } else { &DERIVATIVE };
                check_range(list.join(item).join("value"), condition.value, range, lift)
            })
        }
        Data::Points(points) => {
            points.iter().enumerate().try_for_each(|(item, point)| height(list.join(item).join(1), point[1]))
        }
        Data::Ordinates(ordinates) => {
            ordinates.iter().enumerate().try_for_each(|(item, &value)| height(list.join(item), value))
        }
    }
}

/// The height at which a segment's data say that it ends, when they do.
pub(crate) fn stated_end(segment: &SegmentDesign) -> Option<Decimal> {
    let value = match &segment.data {
        Data::None | Data::Expression(_) => None,
        Data::Points(points) => points.last().filter(|point| point[0] == segment.beta).map(|point| point[1]),
        Data::Ordinates(ordinates) => ordinates.last().copied(),
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => {
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
        Data::None | Data::Ordinates(_) | Data::Expression(_) => {}
        Data::Conditions(conditions) => conditions.iter_mut().for_each(|condition| condition.at = along(condition.at)),
        Data::Spline { conditions, knots } => {
            conditions.iter_mut().for_each(|condition| condition.at = along(condition.at));
            knots.iter_mut().for_each(|knot| *knot = along(*knot));
        }
        Data::Points(points) => points.iter_mut().for_each(|point| point[0] = along(point[0])),
    }
    after
}
