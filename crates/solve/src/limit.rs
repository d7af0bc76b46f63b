//! One-sided limits: which smooth stretch a place is looked at from.

use levalab_core::{Cam, Program, Svaj};

/// Two places closer than this part of the cycle are the same joint.
const SAME_PLACE: f64 = 1e-11;

/// Every stretch that holds a place, its ends included: the one from which the limit from the right comes first, then the one that ends there. At θ = 0
/// of a cam that turns, the stretch that ends the turn is among them.
pub fn stretches_at(program: &Program, theta: f64) -> Vec<usize> {
    let (stretches, span) = (program.stretches(), program.span());
    let near = SAME_PLACE * span;
    let right = program.stretch_index(theta);
    let ends_here = |to: f64| (to - theta).abs() <= near || program.is_cyclic() && (to - theta - span).abs() <= near;
    let left = (0..stretches.len()).find(|&k| k != right && ends_here(stretches[k].to));
    std::iter::once(right).chain(left).collect()
}

/// θ of a place as a stretch has it: the end of the turn where the stretch ends it and the place is given as 0.
pub fn place_on(program: &Program, stretch: usize, theta: f64) -> f64 {
    let stretch = &program.stretches()[stretch];
    if theta < stretch.from - SAME_PLACE * program.span() { stretch.to } else { theta }
}

/// Of the limits at a place, the one where a quantity comes nearest to a value that is known of it; the limit from the right when both are as near.
pub fn nearest(cam: &Cam, theta: f64, value: f64, of: impl Fn(Svaj) -> f64) -> (usize, Svaj) {
    let program = &cam.program;
    let limit = |k: usize| (k, program.stretches()[k].at(place_on(program, k, theta)));
    let off = |motion: Svaj| (of(motion) - value).abs();
    let sides: Vec<(usize, Svaj)> = stretches_at(program, theta).into_iter().map(limit).collect();
    match sides[..] {
        [right, left] if off(right.1) > off(left.1) + ROUNDING * value.abs() => left,
        _ => sides[0],
    }
}

/// Two values of a quantity closer than this part of it are one value.
const ROUNDING: f64 = 1e-9;
