//! Searches along one variable: where a function passes zero, where it is greatest, and where a condition begins to hold.
//!
//! Every search of the core is made of these: extremes refine summits, sizes and ties look for the boundary of a condition, joints and
//! outputs for roots. All of them end after a bounded number of evaluations, whatever the function is.

/// The share of an interval that a golden section cuts off: (3 − √5)/2.
const GOLDEN: f64 = 0.381_966_011_250_105;

/// Maximum number of evaluations of Brent's method and of false position: far more than either takes on a smooth function.
const MAX_BRENT_STEPS: usize = 60;
const MAX_ROOT_STEPS: usize = 100;

/// A root is bracketed to this part of its size, which is a few units in the last place.
const ROOT_TOLERANCE: f64 = 1e-14;

/// The place and the value of the maximum of `f` between two places, by Brent's method from a third place, given with its value. A start at
/// one of the two places that is higher than its neighbourhood is the maximum. Source: Brent, *Algorithms for Minimization without
/// Derivatives*, ch. 5.
pub(crate) fn summit(
    (low, high): (f64, f64),
    (start, at_start): (f64, f64),
    tolerance: f64,
    f: impl Fn(f64) -> f64,
) -> (f64, f64) {
    if start == low && f(low + tolerance) < at_start || start == high && f(high - tolerance) < at_start {
        return (start, at_start);
    }
    let (mut a, mut b) = (low, high);
    let (mut x, mut w, mut v) = (start, start, start);
    let (mut fx, mut fw, mut fv) = (at_start, at_start, at_start);
    let (mut step, mut last): (f64, f64) = (0.0, 0.0);
    for _ in 0..MAX_BRENT_STEPS {
        let middle = 0.5 * (a + b);
        if (x - middle).abs() <= 2.0 * tolerance - 0.5 * (b - a) {
            break;
        }
        let mut golden = true;
        if last.abs() > tolerance {
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
        let u = x + if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        let u = u.clamp(low, high);
        let fu = f(u);
        if fu >= fx {
            if u >= x {
                a = x;
            } else {
                b = x;
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                a = u;
            } else {
                b = u;
            }
            if fu >= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu >= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    (x, fx)
}

/// The height of the parabola through three samples; the middle sample itself where the parabola has no summit.
pub(crate) fn vertex([before, here, after]: [f64; 3], [low, middle, high]: [f64; 3]) -> f64 {
    let (left, right) = ((middle - low) / (here - before), (high - middle) / (after - here));
    let bend = (right - left) / (after - before);
    if !bend.is_finite() || bend >= 0.0 {
        return middle;
    }
    let slope = left + bend * (here - before);
    middle - 0.25 * slope * slope / bend
}

/// The place next to the middle one of three points, given as (place, slope), where the slope passes zero; `None` if it does not, as at the
/// end of a stretch.
pub(crate) fn crest([low, here, high]: [(f64, f64); 3], slope: impl Fn(f64) -> f64) -> Option<f64> {
    let far = if here.1 > 0.0 { high } else { low };
    let passes = here.1 != 0.0 && far.0 != here.0 && (far.1 > 0.0) != (here.1 > 0.0);
    passes.then(|| root_between(here, far, slope))
}

/// The place where `f` changes sign between `low` and `high`.
pub(crate) fn root(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    root_between((low, f(low)), (high, f(high)), f)
}

/// The place where `f` changes sign between two places, given with its values there, by the Illinois variant of false position. Source:
/// Dowell and Jarratt, *A modified regula falsi method*, BIT 11 (1971).
pub(crate) fn root_between(
    (mut low, mut at_low): (f64, f64),
    (mut high, mut at_high): (f64, f64),
    f: impl Fn(f64) -> f64,
) -> f64 {
    for _ in 0..MAX_ROOT_STEPS {
        let mut middle = (low * at_high - high * at_low) / (at_high - at_low);
        if !(middle > low.min(high) && middle < low.max(high)) {
            middle = 0.5 * (low + high);
        }
        let value = f(middle);
        if value == 0.0 || (high - low).abs() <= ROOT_TOLERANCE * (low.abs() + high.abs()) {
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

/// The place and the value of the maximum of a function with one summit between two places, by a golden section of that many steps, each
/// of which shortens the interval by the factor 0.618.
pub(crate) fn golden_maximum(mut low: f64, mut high: f64, steps: usize, f: impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut left, mut right) = (low + GOLDEN * (high - low), high - GOLDEN * (high - low));
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..steps {
        if at_left >= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = low + GOLDEN * (high - low);
            at_left = f(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = high - GOLDEN * (high - low);
            at_right = f(right);
        }
    }
    if at_left >= at_right { (left, at_left) } else { (right, at_right) }
}

/// The last place found to pass on the way from one that passes to one that fails: the gap between the two is halved until `close`, given
/// the passing and the failing place, says that it is small enough.
pub(crate) fn boundary(
    (mut passing, mut failing): (f64, f64),
    close: impl Fn(f64, f64) -> bool,
    passes: impl Fn(f64) -> bool,
) -> f64 {
    for _ in 0..MAX_HALVINGS {
        if close(passing, failing) {
            break;
        }
        let middle = 0.5 * (passing + failing);
        if passes(middle) { passing = middle } else { failing = middle }
    }
    passing
}

/// Maximum number of halvings: beyond it no two numbers of one sign and of comparable size differ any more.
const MAX_HALVINGS: usize = 200;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_found_to_the_last_digits() {
        for (low, high) in [(0.0, 2.0), (2.0, 0.0), (1.4, 1.5)] {
            assert!((root(low, high, |x| x * x - 2.0) - 2_f64.sqrt()).abs() < 1e-14);
        }
        // A root of the fifth order, on which false position alone would creep.
        assert!((root(-1.0, 3.0, |x| (x - 1.0).powi(5)) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn brent_and_the_golden_section_agree_on_a_summit() {
        let f = |x: f64| (3.0 * x).sin() - 0.1 * x;
        let expected = (0.1_f64 / 3.0).acos() / 3.0;
        let (at, value) = summit((0.0, 1.0), (0.6, f(0.6)), 1e-8, f);
        assert!((at - expected).abs() < 1e-7 && (value - f(expected)).abs() < 1e-15, "{at} {value}");
        let (at, _) = golden_maximum(0.0, 1.0, 40, f);
        assert!((at - expected).abs() < 1e-7, "{at}");
    }

    #[test]
    fn a_summit_at_an_end_is_that_end() {
        assert_eq!(summit((0.0, 1.0), (1.0, 1.0), 1e-8, |x| x), (1.0, 1.0));
    }

    #[test]
    fn the_parabola_through_three_samples_has_the_height_of_its_vertex() {
        let f = |x: f64| 3.0 - 2.0 * (x - 0.3).powi(2);
        assert!((vertex([0.0, 0.2, 1.0], [0.0, 0.2, 1.0].map(f)) - 3.0).abs() < 1e-14);
        assert_eq!(vertex([0.0, 1.0, 2.0], [0.0, 1.0, 4.0]), 1.0);
    }

    #[test]
    fn the_boundary_is_on_the_side_that_passes() {
        let found = boundary((4.0, 0.0), |a, b| (a - b).abs() < 1e-12, |x| x >= 1.25);
        assert!((1.25..1.25 + 1e-12).contains(&found), "{found}");
    }

    #[test]
    fn a_search_that_never_comes_close_ends() {
        assert_eq!(boundary((1.0, 0.0), |_, _| false, |_| false), 1.0);
    }
}
