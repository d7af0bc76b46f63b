//! The joints of a program: the limits on both sides, and what jumps there.

use super::{CLOSING_TOLERANCE, Program};
use crate::{Stretch, Svaj};

/// A jump smaller than this part of the greatest value of its derivative is rounding, not a jump.
const JUMP_TOLERANCE: f64 = 1e-9;

/// A joint between smooth stretches of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Where it is, radians.
    pub theta: f64,
    /// The segment that begins there, or within which it lies.
    pub segment: usize,
    /// Limit from the left.
    pub before: Svaj,
    /// Limit from the right.
    pub after: Svaj,
    /// The lowest order that jumps there: 0 for *s* to 3 for *j*.
    pub jump: Option<u8>,
}

impl Program {
    /// Every joint between smooth stretches, the one at θ = 0 first: θ, the stretch that begins there and the limits on both
    /// sides. At the ends of a travel, where the cam turns back, the limits are those of the same end, run forth and back.
    pub fn joints(&self) -> impl Iterator<Item = (f64, &Stretch, Svaj, Svaj)> {
        let n = self.stretches.len();
        let last = &self.stretches[n - 1];
        let end = last.at(last.to);
        let start = if self.is_cyclic() { end } else { run_back(self.stretches[0].at(0.0)) };
        let turning = (!self.is_cyclic()).then(|| (last.to, last, end, run_back(end)));
        let inner = (0..n).map(move |i| {
            let after = &self.stretches[i];
            let before = if i == 0 { start } else { self.stretches[i - 1].at(self.stretches[i - 1].to) };
            (after.from, after, before, after.at(after.from))
        });
        inner.chain(turning)
    }

    /// Every joint, the one at θ = 0 first, with the lowest order that jumps there.
    ///
    /// A difference is a jump when it is more than rounding beside the greatest value of its derivative in the program.
    #[must_use]
    pub fn classified_joints(&self) -> Vec<Joint> {
        let scales = self.sizes();
        let n = self.stretches.len();
        let classify = |(i, (theta, stretch, before, after)): (usize, (f64, &Stretch, Svaj, Svaj))| {
            let sides = [&self.stretches[(i + n - 1) % n], stretch];
            // What a program may leave open at its end is no jump of s.
            let left_open = [CLOSING_TOLERANCE, 0.0, 0.0, 0.0];
            let jumps = |&order: &usize| {
                (before.order(order) - after.order(order)).abs()
                    > JUMP_TOLERANCE * scales[order]
                        + left_open[order]
                        + sides.map(|side| side.rounding(scales[0], order)).iter().sum::<f64>()
            };
            let jump = (0..4).find(jumps).map(|order| order as u8);
            Joint { theta, segment: stretch.segment, before, after, jump }
        };
        self.joints().enumerate().map(classify).collect()
    }
}

/// The end of a travel as it is met on the way back.
fn run_back(limit: Svaj) -> Svaj {
    Svaj::new(limit.s, -limit.v, limit.a, -limit.j)
}
