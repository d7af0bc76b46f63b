//! Extremes and crossings of a piecewise smooth quantity, refined between samples.

use crate::samples::{Sample, Samples};
use crate::{Cam, Contact, Svaj};
use std::f64::consts::TAU;

/// Where a quantity is least and greatest over the turn; θ in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Least value.
    pub min: f64,
    /// Where it is.
    pub min_at: f64,
    /// Greatest value.
    pub max: f64,
    /// Where it is.
    pub max_at: f64,
}

impl Extremes {
    /// The greatest absolute value and where it is.
    #[must_use]
    pub fn greatest_size(&self) -> (f64, f64) {
        if self.max.abs() >= self.min.abs() { (self.max.abs(), self.max_at) } else { (self.min.abs(), self.min_at) }
    }
}

/// Something that can be read off motion and contact.
pub(crate) type Quantity = fn(&Svaj, &Contact) -> f64;

/// θ is refined to this (radians): the value of an extreme is then exact to its square.
const THETA_TOLERANCE: f64 = 1e-8;

/// Samples lower than the best by more than this part of the range cannot hide the true extreme between them.
const SLACK: f64 = 1e-2;

/// Estimates (by a parabola through three samples) that differ by less than this part of the range are all refined.
const TIE: f64 = 1e-4;

/// Most bumps refined for one extreme: a program of many equal segments needs only some of its equal bumps.
const MOST_BUMPS: usize = 4;

/// Extremes of a quantity over the turn.
pub(crate) fn extremes(cam: &Cam, samples: &Samples, quantity: Quantity) -> Extremes {
    let values: Vec<f64> = samples.all.iter().map(|sample| quantity(&sample.motion, &sample.contact)).collect();
    let (max, max_at) = greatest(cam, samples, &values, quantity, 1.0);
    let (min, min_at) = greatest(cam, samples, &values, quantity, -1.0);
    Extremes { min: -min, min_at, max, max_at }
}

/// The greatest value of `sign`·quantity, and where.
fn greatest(cam: &Cam, samples: &Samples, values: &[f64], quantity: Quantity, sign: f64) -> (f64, f64) {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values {
        low = low.min(sign * value);
        high = high.max(sign * value);
    }
    let range = high - low;
    let mut best = (high, f64::NAN);
    let mut bumps: Vec<(f64, usize, usize)> = Vec::new();
    let threshold = high - SLACK * range;
    for (stretch, span) in samples.ranges.iter().enumerate() {
        for i in span.clone() {
            let here = sign * values[i];
            if here < threshold {
                continue;
            }
            if here == high && best.1.is_nan() {
                best.1 = samples.all[i].theta;
            }
            let before = if i > span.start { sign * values[i - 1] } else { f64::NEG_INFINITY };
            let after = if i + 1 < span.end { sign * values[i + 1] } else { f64::NEG_INFINITY };
            if here >= before && here > after || here > before && here >= after {
                bumps.push((vertex(before, here, after), i, stretch));
            }
        }
    }
    if range <= f64::EPSILON * high.abs() {
        return best;
    }
    let top = bumps.iter().map(|bump| bump.0).fold(f64::NEG_INFINITY, f64::max);
    bumps.retain(|bump| bump.0 >= top - TIE * range);
    for &(_, i, stretch) in bumps.iter().take(MOST_BUMPS) {
        let span = &samples.ranges[stretch];
        let (low, high) = (i.saturating_sub(1).max(span.start), (i + 1).min(span.end - 1));
        let piece = &cam.program.stretches()[stretch];
        let height = |theta: f64| {
            let motion = piece.at(theta);
            sign * quantity(&motion, &cam.follower.contact(motion))
        };
        let theta = |k: usize| samples.all[k].theta;
        let (at, value) = summit(theta(low), theta(i), theta(high), sign * values[i], height);
        // A gain within rounding is no better place than the sample itself, which is often a round angle.
        if value > best.0 + 4.0 * f64::EPSILON * best.0.abs() {
            best = (value, at);
        }
    }
    (best.0, if best.1 >= TAU { best.1 - TAU } else { best.1 })
}

/// Height of the parabola through three samples, for ranking bumps; at a one-sided end, the sample itself.
fn vertex(before: f64, here: f64, after: f64) -> f64 {
    let bend = before - 2.0 * here + after;
    if !bend.is_finite() || bend >= 0.0 {
        return here;
    }
    let slope = 0.5 * (after - before);
    here - 0.5 * slope * slope / bend
}

/// Greatest value of `f` on [low, high] by Brent's method, started from a known inner point.
fn summit(low: f64, start: f64, high: f64, at_start: f64, f: impl Fn(f64) -> f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.381_966_011_250_105;
    let (mut a, mut b) = (low, high);
    let (mut x, mut w, mut v) = (start, start, start);
    let (mut fx, mut fw, mut fv) = (at_start, at_start, at_start);
    let (mut step, mut last): (f64, f64) = (0.0, 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (a + b);
        if (x - middle).abs() <= 2.0 * THETA_TOLERANCE - 0.5 * (b - a) {
            break;
        }
        let mut golden = true;
        if last.abs() > THETA_TOLERANCE {
            let r = (x - w) * (fx - fv);
            let mut q = (x - v) * (fx - fw);
            let mut p = (x - v) * q - (x - w) * r;
            q = 2.0 * (q - r);
            if q > 0.0 {
                p = -p;
            }
            q = q.abs();
            if p.abs() < (0.5 * q * last).abs() && p > q * (a - x) && p < q * (b - x) {
                (last, step, golden) = (step, p / q, false);
            }
        }
        if golden {
            last = if x < middle { b - x } else { a - x };
            step = GOLDEN * last;
        }
        let u = x + if step.abs() >= THETA_TOLERANCE { step } else { THETA_TOLERANCE.copysign(step) };
        let u = u.clamp(low, high);
        let fu = f(u);
        if fu >= fx {
            if u >= x { a = x } else { b = x }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x { a = u } else { b = u }
            if fu >= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu >= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    (x, fx)
}

/// The intervals of θ (radians) in which `excess` is positive; one that passes 2π ends beyond it.
///
/// `peak` is a place already known to be positive, for an interval so short that no sample falls in it.
pub(crate) fn intervals(
    cam: &Cam,
    samples: &Samples,
    peak: f64,
    excess: &dyn Fn(&Svaj, &Contact) -> f64,
) -> Vec<(f64, f64)> {
    let value = |sample: &Sample| excess(&sample.motion, &sample.contact);
    let mut found: Vec<(f64, f64)> = Vec::new();
    let mut open: Option<f64> = None;
    for (stretch, span) in cam.program.stretches().iter().zip(&samples.ranges) {
        let at = |theta: f64| {
            let motion = stretch.at(theta);
            excess(&motion, &cam.follower.contact(motion))
        };
        let mut cross = |low: f64, high: f64, open: &mut Option<f64>| match (at(low) > 0.0, at(high) > 0.0) {
            (false, true) => *open = Some(open.unwrap_or_else(|| root(low, high, at))),
            (true, false) => found.push((open.take().unwrap_or(low), root(low, high, at))),
            (true, true) if open.is_none() => *open = Some(low),
            _ => {}
        };
        for pair in samples.all[span.clone()].windows(2) {
            if open.is_none() && value(&pair[0]) <= 0.0 && value(&pair[1]) <= 0.0 {
                if pair[0].theta < peak && peak < pair[1].theta && at(peak) > 0.0 {
                    cross(pair[0].theta, peak, &mut open);
                    cross(peak, pair[1].theta, &mut open);
                }
                continue;
            }
            cross(pair[0].theta, pair[1].theta, &mut open);
        }
    }
    if let Some(from) = open {
        match found.first_mut() {
            Some(first) if first.0 <= 0.0 => *first = (from, first.1 + TAU),
            _ => found.push((from, TAU)),
        }
    }
    found
}

/// Where `f` changes sign between `low` and `high`, by the Illinois variant of false position.
pub(crate) fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut at_low, mut at_high) = (f(low), f(high));
    for _ in 0..100 {
        let mut middle = (low * at_high - high * at_low) / (at_high - at_low);
        if !(middle > low.min(high) && middle < low.max(high)) {
            middle = 0.5 * (low + high);
        }
        let value = f(middle);
        if value == 0.0 || (high - low).abs() <= 1e-14 * (low.abs() + high.abs()) {
            return middle;
        }
        if (value > 0.0) == (at_high > 0.0) {
            (low, at_low, high, at_high) = (low, 0.5 * at_low, middle, value);
        } else {
            (low, at_low) = (high, at_high);
            (high, at_high) = (middle, value);
        }
    }
    high
}
