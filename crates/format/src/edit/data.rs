//! The data of a free law: conditions that come and go, where they end, and the same motion upside down or backwards.

use super::has_segment;
use crate::data::asks_for_rise;
use crate::decimal::Decimal;
use crate::digits::{DIGITS, clean, clean_sum, round};
use crate::report::scale_of;
use crate::{Design, DesignError, EditRefusal, Path, SegmentDesign, data_key};
use levalab_core::law::{Condition, Data};
use levalab_core::{Column, Expression, Quantity};

pub(super) fn put(design: &mut Design, k: usize, at: f64, order: u8, value: f64) -> Result<(), DesignError> {
    let conditions = conditions_of(design, k)?;
    match conditions.iter_mut().find(|condition| condition.at == at && condition.order == order) {
        Some(known) => known.value = value,
        None => conditions.push(Condition { at, order, value }),
    }
    sort(conditions);
    Ok(())
}

pub(super) fn shift(design: &mut Design, k: usize, from: f64, to: f64) -> Result<(), DesignError> {
    let conditions = conditions_of(design, k)?;
    for condition in conditions.iter_mut().filter(|condition| condition.at == from) {
        condition.at = to;
    }
    Ok(())
}

pub(super) fn remove(design: &mut Design, k: usize, at: f64, order: Option<u8>) -> Result<(), DesignError> {
    let conditions = conditions_of(design, k)?;
    conditions.retain(|c| c.at != at || order.is_some_and(|order| c.order != order));
    Ok(())
}

/// A condition of *s* in the middle of the widest gap, at the height of the curve where there is one, in a few digits.
pub(super) fn add(design: &mut Design, k: usize) -> Result<(), DesignError> {
    let beta = design.segments.get(k).map_or(0.0, |segment| segment.beta);
    let mut places: Vec<f64> = conditions_of(design, k)?.iter().map(|condition| condition.at).collect();
    places.extend([0.0, beta]);
    places.sort_by(f64::total_cmp);
    let gaps = places.windows(2).map(|pair| (pair[1] - pair[0], 0.5 * (pair[0] + pair[1])));
    // Of equal gaps the first.
    let widest = gaps.fold((f64::NEG_INFINITY, 0.0), |best, gap| if gap.0 > best.0 { gap } else { best });
    let at = clean(widest.1);
    let height = round(height_within(design, k, at), DIGITS, f64::round);
    put(design, k, at, 0, height)
}

/// The height of the curve at a place in a segment; where the design makes no cam, of the line between its borders.
fn height_within(design: &Design, k: usize, at: f64) -> f64 {
    if let Ok(cam) = design.cam() {
        let before: f64 = design.segments[..k].iter().map(|segment| segment.beta).sum();
        let s = cam.program.at(design.stride().to_core(before + at)).s;
        return s * scale_of(design, Column::S);
    }
    let heights = design.draft_heights();
    let [start, end] = [heights[k], heights[k + 1]].map(Decimal::to_f64);
    let part = at / design.segments[k].beta;
    if part.is_finite() { start + (end - start) * part } else { start }
}

pub(super) fn formula(design: &mut Design, k: usize, text: &str) -> Result<(), DesignError> {
    has_segment(design, k)?;
    let heights = design.draft_heights();
    let segment = &mut design.segments[k];
    let Data::Expression(old) = &mut segment.data else {
        return Err(DesignError::at(Path::from("segments").join(k), EditRefusal::NoFormula));
    };
    let had = Expression::parse(old).is_ok_and(|expression| expression.names_rise());
    text.clone_into(old);
    if !asks_for_rise(segment.law, &segment.data) {
        segment.rise = 0.0;
    } else if !had {
        segment.rise = clean_sum((heights[k + 1] - heights[k]).to_f64());
    }
    Ok(())
}

/// Makes the data of a segment end at a height; false when it has none that can.
pub(super) fn set_end(segment: &mut SegmentDesign, height: f64) -> bool {
    let beta = segment.beta;
    match &mut segment.data {
        Data::None | Data::Expression(_) => return false,
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => {
            match conditions.iter_mut().find(|condition| condition.order == 0 && condition.at == beta) {
                Some(end) => end.value = height,
                None => {
                    conditions.push(Condition { at: beta, order: 0, value: height });
                    sort(conditions);
                }
            }
        }
        Data::Points(points) => match points.last_mut() {
            Some(last) => last[1] = height,
            None => return false,
        },
        Data::Ordinates(ordinates) => match ordinates.last_mut() {
            Some(last) => *last = height,
            None => return false,
        },
    }
    true
}

/// Multiplies the heights that the data of a segment hold, and the parameters that are heights; a formula by a factor of its own,
/// since its angles are radians.
pub(super) fn scaled_heights(segment: &mut SegmentDesign, factor: f64, in_formula: f64) {
    for (value, parameter) in segment.parameters.iter_mut().zip(segment.law.parameters) {
        if parameter.quantity == Quantity::Height {
            *value = clean(*value * factor.abs());
        }
    }
    let scale = |value: &mut f64| *value = clean(*value * factor);
    match &mut segment.data {
        Data::None => {}
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => {
            conditions.iter_mut().for_each(|condition| scale(&mut condition.value));
        }
        Data::Points(points) => points.iter_mut().for_each(|point| scale(&mut point[1])),
        Data::Ordinates(ordinates) => ordinates.iter_mut().for_each(scale),
        Data::Expression(text) => {
            // A length whatever its unit goes with the rise and the starting height.
            if !is_a_length(text) {
                let inner = renamed(text, |name| format!("({name}/{in_formula})"));
                *text = format!("{in_formula}({inner})");
            }
        }
    }
}

/// True of a formula that is multiplied when its rise and its starting height are.
pub(super) fn is_a_length(text: &str) -> bool {
    Expression::parse(text).is_ok_and(|expression| expression.degree(false) == Some(1))
}

/// The segment upside down: at every place as far below `top` as it was above the base circle.
pub(super) fn flipped(segment: &SegmentDesign, top: f64) -> SegmentDesign {
    let below = |height: f64| (Decimal::of(top) - Decimal::of(height)).to_f64();
    let mut after = SegmentDesign { rise: 0.0 - segment.rise, ..segment.clone() };
    match &mut after.data {
        Data::None => {}
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => {
            for condition in conditions {
                condition.value = if condition.order == 0 { below(condition.value) } else { 0.0 - condition.value };
            }
        }
        Data::Points(points) => points.iter_mut().for_each(|point| point[1] = below(point[1])),
        Data::Ordinates(ordinates) => ordinates.iter_mut().for_each(|height| *height = below(*height)),
        Data::Expression(text) => {
            let inner = renamed(text, |name| if name == "L" { "(-L)".into() } else { format!("({top}-{name})") });
            *text = format!("{top}-({inner})");
        }
    }
    after
}

/// The segment run from its end to its start; `None` for a formula, which cannot be.
pub(super) fn backwards(segment: &SegmentDesign) -> Option<SegmentDesign> {
    let beta = segment.beta;
    let back = |at: f64| (Decimal::of(beta) - Decimal::of(at)).to_f64();
    let mut after = SegmentDesign { rise: 0.0 - segment.rise, ..segment.clone() };
    let (id, swap) =
        (segment.law.id, |from: &str, to: &str| Some(format!("{}{to}", segment.law.id.strip_suffix(from)?)));
    if let Some(law) = swap("-start", "-end").or_else(|| swap("-end", "-start")).filter(|other| other != id) {
        after.law = levalab_core::Law::by_id(&law).unwrap_or(segment.law);
    }
    match &mut after.data {
        Data::None => {}
        Data::Conditions(conditions) => reverse(conditions, back),
        Data::Spline { conditions, knots } => {
            reverse(conditions, back);
            knots.reverse();
            knots.iter_mut().for_each(|knot| *knot = back(*knot));
        }
        Data::Points(points) => {
            points.reverse();
            points.iter_mut().for_each(|point| point[0] = back(point[0]));
        }
        Data::Ordinates(ordinates) => ordinates.reverse(),
        Data::Expression(_) => return None,
    }
    Some(after)
}

fn reverse(conditions: &mut [Condition], back: impl Fn(f64) -> f64) {
    for condition in conditions.iter_mut() {
        condition.at = back(condition.at);
        if condition.order % 2 == 1 {
            condition.value = 0.0 - condition.value;
        }
    }
    sort(conditions);
}

/// A formula with other texts in place of the lengths that it names.
fn renamed(text: &str, other: impl Fn(&str) -> String) -> String {
    let Ok(named) = Expression::lengths(text, false) else { return text.to_owned() };
    let letters: Vec<char> = text.chars().collect();
    let (mut inner, mut from) = (String::new(), 0);
    for place in named {
        inner.extend(&letters[from..place.start]);
        let name: String = letters[place.clone()].iter().collect();
        inner += &other(&name);
        from = place.end;
    }
    inner.extend(&letters[from..]);
    inner
}

/// In the order of places and then of derivatives, so that the same conditions are always the same design.
fn sort(conditions: &mut [Condition]) {
    conditions.sort_by(|one, other| one.at.total_cmp(&other.at).then(one.order.cmp(&other.order)));
}

fn conditions_of(design: &mut Design, k: usize) -> Result<&mut Vec<Condition>, DesignError> {
    has_segment(design, k)?;
    let segment = &mut design.segments[k];
    let key = data_key(segment.law);
    match &mut segment.data {
        Data::Conditions(conditions) | Data::Spline { conditions, .. } => Ok(conditions),
        _ => {
            let here = Path::from("segments").join(k);
            Err(DesignError::at(key.map_or(here.clone(), |key| here.join(key)), EditRefusal::NoConditions))
        }
    }
}
