//! Extremes inside a segment: at zeros of the next derivative within its smooth pieces, and on the borders between them.

use levalab_core::Stretch;

/// A derivative smaller than this part of its maximum in the segment is rounding, and has no sign.
const ROUNDING: f64 = 1e-9;

/// Places between two zeros at which the sign of a derivative is taken, from the largest of its values there.
const LOOKS: usize = 8;

/// Why a derivative has an extreme at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// The next derivative is zero there.
    Zero,
    /// The next derivative jumps past zero.
    Crossing,
    /// The derivative itself jumps there, and its limit from the left is the extreme.
    Left,
    /// The derivative itself jumps there, and its limit from the right is the extreme.
    Right,
}

/// An extreme of a derivative inside a segment.
#[derive(Clone, Copy, Debug)]
pub struct Inner {
    /// 0 for *s*, 1 for *v*, 2 for *a*.
    pub order: usize,
    /// θ where it begins.
    pub from: f64,
    /// θ where it ends: beyond `from` when the derivative keeps its extreme for a while.
    pub to: f64,
    pub value: f64,
    pub why: Why,
}

/// A part of a stretch in which the next derivative keeps its sign: −1, 0 (the derivative is level) or 1.
struct Run<'a> {
    stretch: &'a Stretch,
    from: f64,
    to: f64,
    sign: i8,
}

/// Every extreme of the derivative of `order` inside the segment that consists of these stretches, in the order of θ.
pub fn extremes(stretches: &[&Stretch], order: usize) -> Vec<Inner> {
    let runs = runs(stretches, order + 1);
    let (scale, next_scale) = (largest(&runs, order), largest(&runs, order + 1));
    let mut found = Vec::new();
    // The last run that has a sign, while only level runs have followed it without a jump.
    let mut before: Option<usize> = None;
    for k in 0..runs.len() {
        let (Some(last), here) = (k.checked_sub(1), &runs[k]) else {
            before = (runs[k].sign != 0).then_some(k);
            continue;
        };
        let theta = here.from;
        let (left, right) = (runs[last].stretch.at(theta).order(order), here.stretch.at(theta).order(order));
        if (left - right).abs() > ROUNDING * scale {
            found.extend(beside_jump(&runs, before, (last, k), (left, right), order));
            before = (here.sign != 0).then_some(k);
            continue;
        }
        if here.sign == 0 {
            continue;
        }
        if let Some(start) = before.filter(|&start| runs[start].sign == -here.sign) {
            let crossing = start == last && jumps_past_zero([&runs[last], here], order + 1, next_scale);
            let why = if crossing { Why::Crossing } else { Why::Zero };
            found.push(Inner { order, from: runs[start].to, to: theta, value: right, why });
        }
        before = Some(k);
    }
    found
}

/// The extremes at a jump of the derivative itself: a limit towards which it climbs and from which it falls, or the reverse.
fn beside_jump(
    runs: &[Run],
    before: Option<usize>,
    (last, here): (usize, usize),
    (left, right): (f64, f64),
    order: usize,
) -> Vec<Inner> {
    let falls = left > right;
    let mut found = Vec::new();
    if let Some(start) = before.filter(|&start| (runs[start].sign > 0) == falls) {
        found.push(Inner { order, from: runs[start].to, to: runs[last].to, value: left, why: Why::Left });
    }
    // After the jump down the limit from the right is a minimum when the derivative climbs from there.
    let mut end = here;
    while end + 1 < runs.len() && runs[end].sign == 0 && runs[end].stretch.segment == runs[here].stretch.segment {
        end += 1;
    }
    if runs[end].sign != 0 && (runs[end].sign > 0) == falls {
        found.push(Inner { order, from: runs[here].from, to: runs[end].from, value: right, why: Why::Right });
    }
    found
}

/// The size of a derivative over some runs.
fn largest(runs: &[Run], order: usize) -> f64 {
    let size = |run: &Run| run.stretch.at(run.from).order(order).abs().max(run.stretch.at(run.to).order(order).abs());
    runs.iter().map(size).fold(0.0, f64::max)
}

/// True when a derivative passes from one sign to the other at the border of two runs without being zero on either side.
fn jumps_past_zero([left, right]: [&Run; 2], order: usize, scale: f64) -> bool {
    let of = |run: &Run| run.stretch.at(right.from).order(order);
    !std::ptr::eq(left.stretch, right.stretch) && of(left).abs().min(of(right).abs()) > ROUNDING * scale
}

/// The stretches cut at the zeros of the derivative of `order`.
fn runs<'a>(stretches: &[&'a Stretch], order: usize) -> Vec<Run<'a>> {
    let mut parts: Vec<(&Stretch, f64, f64, f64)> = Vec::new();
    for &stretch in stretches {
        let cuts: Vec<f64> =
            std::iter::once(stretch.from).chain(stretch.zeros(order)).chain(std::iter::once(stretch.to)).collect();
        for pair in cuts.windows(2) {
            let place = |i: usize| pair[0] + (pair[1] - pair[0]) * (i as f64 + 0.5) / LOOKS as f64;
            let values = (0..LOOKS).map(|i| stretch.at(place(i)).order(order));
            let largest = values.fold(0.0_f64, |most, value| if value.abs() > most.abs() { value } else { most });
            parts.push((stretch, pair[0], pair[1], largest));
        }
    }
    let scale = parts.iter().map(|part| part.3.abs()).fold(0.0, f64::max);
    let sign = |value: f64| {
        if value.abs() <= ROUNDING * scale {
            0
        } else if value > 0.0 {
            1
        } else {
            -1
        }
    };
    parts.into_iter().map(|(stretch, from, to, value)| Run { stretch, from, to, sign: sign(value) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_format::testing::{Random, design};

    /// Every turning point that dense samples of a segment show, away from its ends and from jumps, is found, and every extreme that is found is one.
    #[test]
    fn extremes_of_random_segments_are_those_of_dense_samples() {
        const SAMPLES: usize = 400;
        let mut random = Random::new(8_128);
        let mut turning_points = 0;
        for _ in 0..150 {
            let Ok(cam) = design(&mut random).cam() else { continue };
            for k in 0..cam.program.segments().len() {
                let stretches: Vec<&Stretch> = cam.program.stretches().iter().filter(|s| s.segment == k).collect();
                for order in 0..3 {
                    let found = extremes(&stretches, order);
                    let mut low = f64::INFINITY;
                    let mut high = f64::NEG_INFINITY;
                    let ends = stretches.iter().flat_map(|s| [s.at(s.from).order(order), s.at(s.to).order(order)]);
                    let scale = ends.chain(found.iter().map(|found| found.value)).inspect(|&value| {
                        low = low.min(value);
                        high = high.max(value);
                    });
                    let scale = scale.map(f64::abs).fold(0.0, f64::max);
                    for stretch in &stretches {
                        for i in 0..=SAMPLES {
                            let theta = stretch.from + (stretch.to - stretch.from) * i as f64 / SAMPLES as f64;
                            let value = stretch.at(theta).order(order);
                            let slack = 1e-8 * scale;
                            assert!(
                                value >= low - slack && value <= high + slack,
                                "order {order}: {value} is beyond {low} to {high}"
                            );
                        }
                    }
                    turning_points += found.len();
                }
            }
        }
        assert!(turning_points > 500, "{turning_points}");
    }
}
