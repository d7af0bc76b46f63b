//! Random segments that come back to where they begin: any law, with parameters and data that fit it more often than not.

use super::random::{Decimals, Random, tidy};
use crate::SegmentDesign;
use crate::data;
use crate::limits::{MAX_SEGMENTS, MAX_TABLE_POINTS_OF_VERSION_1};
use crate::measure::default_of;
use levalab_core::law::{Condition, Data, DataKind, MAX_LAW_PARAMETERS, usual_knots};
use levalab_core::{LAWS, Law, Quantity};
use std::f64::consts::TAU;

pub(super) fn segments(random: &mut Random, decimals: Decimals, travel: f64, cycle: f64) -> Vec<SegmentDesign> {
    let count = if random.once_in(20) { 1 + random.below(MAX_SEGMENTS) } else { 2 + random.below(11) };
    let weights: Vec<f64> = (0..count).map(|_| random.between(0.2, 1.0)).collect();
    let whole: f64 = weights.iter().sum();
    let mut left = cycle;
    let mut height = 0.0;
    let mut segments: Vec<SegmentDesign> = Vec::with_capacity(count);
    for (k, weight) in weights.iter().enumerate() {
        let last = k + 1 == count;
        let beta = if last { left } else { decimals.round(cycle * weight / whole) };
        left = tidy(left - beta);
        let target = if last || random.once_in(4) { 0.0 } else { decimals.round(travel * random.unit()) };
        let law = law(random, target == height, segments.last().map(|segment| segment.law));
        let rise = if law.is_dwell() { 0.0 } else { tidy(target - height) };
        height = tidy(height + rise);
        let parameters = parameters(random, decimals, law, beta);
        let span = (beta, tidy(height - rise), height);
        let made = law.free().map_or(Data::None, |free| data_of(random, decimals, free.data, span));
        let made = if random.once_in(3) { knotted(random, decimals, law, parameters, beta, made) } else { made };
        let rise = if law.is_dwell() || data::asks_for_rise(law, &made) { rise } else { 0.0 };
        segments.push(SegmentDesign { law, beta, rise, parameters, data: made });
    }
    segments
}

fn law(random: &mut Random, level: bool, before: Option<&Law>) -> &'static Law {
    loop {
        let law = *random.pick(LAWS);
        let fits = law.is_dwell() == level || level && random.once_in(4);
        if fits && !(law.is_matched() && before.is_none_or(Law::is_matched)) {
            return law;
        }
    }
}

/// Fractions, and parts of β; what does not fit is tried by the caller.
fn parameters(random: &mut Random, decimals: Decimals, law: &Law, beta: f64) -> [f64; MAX_LAW_PARAMETERS] {
    let mut values = [0.0; MAX_LAW_PARAMETERS];
    for (value, parameter) in values.iter_mut().zip(law.parameters) {
        let default = default_of(parameter, beta).filter(|_| random.once_in(2));
        let whole = if parameter.quantity == Quantity::Span { beta } else { 1.0 };
        let default = default.or_else(|| (parameter.key == "degree").then(|| random.below(5) as f64 + 4.0));
        *value = default.unwrap_or_else(|| decimals.round(whole * random.between(0.0, 0.5)));
    }
    values
}

/// Data that lead from one height to another over β: round numbers or long ones, few or many.
fn data_of(random: &mut Random, decimals: Decimals, kind: DataKind, (beta, start, end): (f64, f64, f64)) -> Data {
    let lift = start.abs().max(end.abs()).max(1.0);
    match kind {
        DataKind::Conditions | DataKind::Spline => {
            let at = |at: f64, order: u8, value: f64| Condition { at, order, value };
            let mut conditions = vec![at(0.0, 0, start), at(beta, 0, end)];
            for order in 1..4 {
                for place in [0.0, beta] {
                    if !random.once_in(3) {
                        let value =
                            if random.once_in(2) { 0.0 } else { decimals.round(lift * random.between(-1.0, 1.0)) };
                        conditions.push(at(place, order, value));
                    }
                }
            }
            for _ in 0..random.below(3) * random.below(3) {
                let height = decimals.round(lift * random.unit());
                conditions.push(at(decimals.round(beta * random.between(0.05, 0.95)), 0, height));
            }
            Data::Conditions(conditions)
        }
        DataKind::Points => {
            let count = 2 + random.below(12);
            let at = |k: usize| if k + 1 == count { beta } else { tidy(beta * k as f64 / (count - 1) as f64) };
            let height = |random: &mut Random| decimals.round(lift * random.unit());
            let mut points: Vec<[f64; 2]> = (0..count).map(|k| [at(k), height(random)]).collect();
            (points[0][1], points[count - 1][1]) = (start, end);
            Data::Points(points)
        }
        DataKind::Ordinates => {
            let inner = (0..random.below(9)).map(|_| decimals.round(lift * random.unit()));
            let inner: Vec<f64> = inner.collect();
            Data::Ordinates([vec![start], inner, vec![end]].concat())
        }
        DataKind::Expression => {
            let rise = tidy(end - start);
            let texts = [
                "s₀ + L (10x³ − 15x⁴ + 6x⁵)".to_owned(),
                "s0 + L·sin(πx/2)^2".to_owned(),
                format!("{start} + {rise}(1 - cos(πθ/β))/2"),
                format!("{start}+{rise}x^3,5"),
            ];
            Data::Expression(random.pick(&texts).clone())
        }
    }
}

/// A table with more points between the same ends: a cosine with as much noise as its last decimal, or none.
pub(super) fn measured(random: &mut Random, decimals: i32, beta: f64, ends: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let (Some(first), Some(last)) = (ends.first(), ends.last()) else { return Vec::new() };
    let (start, end) = (first[1], last[1]);
    let count = MAX_TABLE_POINTS_OF_VERSION_1 + 1 + random.below(300);
    let lift = random.between(0.0, 20.0);
    let unit = 10_f64.powi(decimals);
    let noise = if random.once_in(2) { 2.0 / unit } else { 0.0 };
    let point = |k: usize| {
        let x = k as f64 / (count - 1) as f64;
        let height = start + (end - start) * x + lift * (1.0 - (TAU * x).cos()) + random.between(0.0, noise);
        [tidy(beta * x), ((height * unit).round() / unit).max(0.0)]
    };
    let mut points: Vec<[f64; 2]> = (0..count).map(point).collect();
    (points[0], points[count - 1]) = ([0.0, start], [beta, end]);
    points
}

/// A spline with knots of its own, near those that it would take unless told.
fn knotted(
    random: &mut Random,
    decimals: Decimals,
    law: &Law,
    parameters: [f64; MAX_LAW_PARAMETERS],
    beta: f64,
    data: Data,
) -> Data {
    match data {
        Data::Conditions(conditions) if law.free().is_some_and(|free| free.data == DataKind::Spline) => {
            let usual = usual_knots(&conditions, parameters[0] as usize, beta);
            let knots: Vec<f64> =
                usual.iter().map(|knot| decimals.round(knot + beta * random.between(-0.02, 0.02))).collect();
            if knots.is_empty() { Data::Conditions(conditions) } else { Data::Spline { conditions, knots } }
        }
        data => data,
    }
}
