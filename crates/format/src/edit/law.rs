//! Another law for a segment.

use super::has_segment;
use crate::data::asks_for_rise;
use crate::decimal::Decimal;
use crate::digits::{clean, clean_sum};
use crate::measure::{default_of, to_core};
use crate::{Design, DesignError, SegmentDesign};
use levalab_core::Law;
use levalab_core::law::{Arguments, Data, DataKind, MAX_LAW_PARAMETERS};

/// A rise where nothing else says how high to go.
const USUAL_RISE: f64 = 10.0;

/// The segment by another law from a height on: the same β, the parameters and the data that the law begins with.
pub(crate) fn with_law(segment: &SegmentDesign, law: &'static Law, start: f64, rise: f64) -> SegmentDesign {
    let beta = segment.beta;
    let mut parameters = [0.0; MAX_LAW_PARAMETERS];
    for (value, parameter) in parameters.iter_mut().zip(law.parameters) {
        *value = default_of(parameter, beta).map(clean).unwrap_or_default();
    }
    let data = first_data(law, beta, start, rise);
    let rise = if asks_for_rise(law, &data) { rise } else { 0.0 };
    SegmentDesign { law, beta, rise, parameters, data }
}

/// Another law for a segment of a design. Parameters and data that both laws have are kept. A law that moves, in place of one
/// that did not, gets the rise that closes the program, or else goes up as high as the program does, or down from there.
pub(super) fn change(design: &mut Design, k: usize, law: &'static Law) -> Result<(), DesignError> {
    has_segment(design, k)?;
    let heights = design.draft_heights();
    let (start, end) = (heights[k], heights[k + 1]);
    let old = &design.segments[k];
    let kept = if law.is_dwell() { Decimal::default() } else { end - start };
    let rise =
        if law.is_dwell() || kept != Decimal::default() { kept.to_f64() } else { likely_rise(design, heights[k]) };
    let rise = clean_sum(rise);
    let mut next = with_law(old, law, start.to_f64(), rise);
    if law.free().is_some_and(|free| old.law.free().is_some_and(|before| takes(free.data, before.data))) {
        next.data = kept_data(law, &old.data);
        next.rise = if asks_for_rise(law, &next.data) { rise } else { 0.0 };
    }
    keep_parameters(&mut next, old);
    design.segments[k] = next;
    Ok(())
}

/// Parameters of the same name keep their values, unless the new law makes no curve with them.
fn keep_parameters(next: &mut SegmentDesign, old: &SegmentDesign) {
    let usual = next.parameters;
    for (value, parameter) in next.parameters.iter_mut().zip(next.law.parameters) {
        let same = old.law.parameters.iter().zip(old.parameters).find(|(other, _)| other.key == parameter.key);
        if let Some((_, kept)) = same {
            *value = kept;
        }
    }
    let parameters = to_core(next.law.parameters, next.parameters, next.beta, 1.0);
    let arguments = Arguments { parameters, falling: next.rise < 0.0, beta: 1.0 };
    if next.law.unit(arguments).is_err() {
        next.parameters = usual;
    }
}

/// True when data of one kind will do for another.
fn takes(wanted: DataKind, found: DataKind) -> bool {
    let conditions = [DataKind::Conditions, DataKind::Spline];
    wanted == found || conditions.contains(&wanted) && conditions.contains(&found)
}

/// The data of a law that takes the same; only a spline has knots.
fn kept_data(law: &Law, data: &Data) -> Data {
    match data {
        Data::Spline { conditions, .. } if law.free().is_none_or(|free| free.data != DataKind::Spline) => {
            Data::Conditions(conditions.clone())
        }
        other => other.clone(),
    }
}

/// The data that a law begins with, in the digits that a person would write.
fn first_data(law: &Law, beta: f64, start: f64, rise: f64) -> Data {
    let along = |at: f64| if at == beta { beta } else { clean(at) };
    let mut data = law.first_data(beta, start, rise);
    match &mut data {
        Data::None | Data::Expression(_) => {}
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => {
            for condition in conditions {
                (condition.at, condition.value) = (along(condition.at), clean(condition.value));
            }
        }
        Data::Points(points) => points.iter_mut().for_each(|[at, s]| (*at, *s) = (along(*at), clean(*s))),
        Data::Ordinates(ordinates) => ordinates.iter_mut().for_each(|s| *s = clean(*s)),
    }
    data
}

fn likely_rise(design: &Design, here: Decimal) -> f64 {
    let open = design.open_height();
    if open != Decimal::default() {
        return (-open).to_f64();
    }
    if here > Decimal::default() {
        return (-here).to_f64();
    }
    let lift = design.draft_lift();
    if lift > 0.0 { lift } else { USUAL_RISE }
}
