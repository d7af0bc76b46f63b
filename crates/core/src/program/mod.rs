//! The motion program: segments that cover one cycle of the cam, joined into a list of smooth pieces.

mod check;
mod curves;
mod joints;
mod segment;
#[cfg(test)]
mod tests;

use crate::law::Solved;
use crate::{Cycle, ProgramError, Stretch, Svaj};
use check::{check_cycle, check_each};
use curves::{climb, running_sum};
use std::f64::consts::TAU;

pub(crate) use curves::ends;
pub use joints::Joint;
pub use segment::Segment;

/// Most segments that a program may have: the cap that links and forms share.
pub const MAX_SEGMENTS: usize = 64;

/// How far β's may miss a whole turn, in radians: 10⁻⁹ degrees, what typed decimals add up to at worst. For a travel, the same
/// part of its length.
pub const TURN_TOLERANCE: f64 = 1e-9 * TAU / 360.0;

/// How far the end may miss the start, in units of the design.
pub const CLOSING_TOLERANCE: f64 = 1e-9;

/// The narrowest segment, radians (a thousandth of a degree): less is below what any cam grinder divides. For a travel, the same
/// part of its length.
pub const MIN_BETA: f64 = 1e-3 * TAU / 360.0;

/// A station this close to a joint (radians, or the same part of a travel) lies on it, and takes the limit from the right.
const SNAP: f64 = 1e-11;

/// A system worse conditioned than this leaves fewer than six of an `f64`'s sixteen digits: its curve is not to be trusted.
pub(crate) const LEAST_TRUSTED: f64 = 1e10;

/// A segment whose curve its data hardly determine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubt {
    /// Index of the segment.
    pub segment: usize,
    /// The condition number of its system.
    pub condition: f64,
    /// The most with which a curve is trusted.
    pub limit: f64,
}

/// A checked cyclic motion program.
#[derive(Clone, Debug)]
pub struct Program {
    cycle: Cycle,
    segments: Vec<Segment>,
    borders: Vec<f64>,
    heights: Vec<f64>,
    stretches: Vec<Stretch>,
    doubts: Vec<Doubt>,
}

impl Program {
    /// Joins segments that cover one turn into a program.
    ///
    /// # Errors
    /// Names the segment and says what is wrong: a β or L that cannot be, a dwell that rises, parameters of a law out of
    /// range, a turn that is not whole, an end that misses the start, a joint below the base circle, or two generic
    /// polynomials side by side (cyclically), which would have no end conditions to take.
    pub fn new(segments: &[Segment]) -> Result<Self, ProgramError> {
        Self::on(Cycle::Turn, segments)
    }

    /// Joins segments into a program on any cycle.
    ///
    /// # Errors
    /// As [`Program::new`]; half a turn that is mirrored, and a travel, may end at another height than they start.
    pub fn on(cycle: Cycle, segments: &[Segment]) -> Result<Self, ProgramError> {
        check_each(cycle, segments)?;
        let borders = running_sum(segments);
        let (heights, solved) = climb(cycle, segments)?;
        let first = solved[0].as_ref().and_then(|solved| solved.pieces.first());
        check_cycle(cycle, segments, &borders, &heights, first.map_or(0.0, |piece| piece.at(0.0).s))?;
        let doubt = |(segment, solved): (usize, &Option<Solved>)| {
            let condition = solved.as_ref()?.condition;
            (condition > LEAST_TRUSTED).then_some(Doubt { segment, condition, limit: LEAST_TRUSTED })
        };
        let doubts = solved.iter().enumerate().filter_map(doubt).collect();
        let mut program = Self { cycle, segments: segments.to_vec(), borders, heights, stretches: Vec::new(), doubts };
        let last = program.segments.len();
        program.borders[last] = cycle.given();
        if cycle == Cycle::Turn {
            program.heights[last] = 0.0;
        }
        program.stretches = program.join(solved)?;
        if cycle == Cycle::Mirrored {
            program.mirror();
        }
        Ok(program)
    }

    /// The motion of a second element fixed to the same follower, on the other side of the shaft: `top` − s(θ).
    #[must_use]
    pub fn reversed(&self, top: f64) -> Self {
        let mut program = self.clone();
        for segment in &mut program.segments {
            segment.rise = -segment.rise;
        }
        for height in &mut program.heights {
            *height = top - *height;
        }
        for stretch in &mut program.stretches {
            stretch.curve = stretch.curve.clone().scaled(-1.0, top);
        }
        program
    }

    /// How its segments make a whole cycle.
    #[must_use]
    pub fn cycle(&self) -> Cycle {
        self.cycle
    }

    /// What it covers: 2π, or the length of a travel.
    #[must_use]
    pub fn span(&self) -> f64 {
        self.cycle.span()
    }

    /// True when its end is its beginning, as for a cam that turns.
    #[must_use]
    pub fn is_cyclic(&self) -> bool {
        !matches!(self.cycle, Cycle::Travel(_))
    }

    /// A difference in θ too small to tell places apart.
    fn snap(&self) -> f64 {
        SNAP * (self.span() / TAU)
    }

    /// The segments over the whole cycle: those it was made from and, when they are mirrored, their images.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// The segments it was made from: half of them when the other half is their image.
    #[must_use]
    pub fn given(&self) -> &[Segment] {
        let images = if self.cycle == Cycle::Mirrored { self.segments.len() / 2 } else { 0 };
        &self.segments[..self.segments.len() - images]
    }

    /// θ of the borders of the segments, from 0 to the [`span`](Self::span): one more than there are segments.
    #[must_use]
    pub fn borders(&self) -> &[f64] {
        &self.borders
    }

    /// *s* at the borders of the segments: one more than there are segments.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The segments whose curve is not to be trusted.
    #[must_use]
    pub fn doubts(&self) -> &[Doubt] {
        &self.doubts
    }

    /// The smooth stretches, in order, from 0 to the [`span`](Self::span).
    #[must_use]
    pub fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// Displacement and derivatives at any θ; on a joint, the limit from the right. A travel is held at its ends.
    #[must_use]
    pub fn at(&self, theta: f64) -> Svaj {
        let span = self.span();
        if !self.is_cyclic() {
            let theta = theta.clamp(0.0, span);
            return self.stretches[self.stretch_index(theta)].at(theta);
        }
        let theta = theta.rem_euclid(span);
        // A hair before the end of the turn is its beginning.
        let theta = if theta >= span - SNAP { 0.0 } else { theta };
        self.stretches[self.stretch_index(theta)].at(theta)
    }

    /// Index of the stretch that holds for `theta` within the span; on a joint, the one to its right.
    #[must_use]
    pub fn stretch_index(&self, theta: f64) -> usize {
        let snap = self.snap();
        self.stretches.partition_point(|stretch| stretch.to <= theta + snap).min(self.stretches.len() - 1)
    }

    /// The lowest and the highest value of *s*, *v*, *a* and *j*, as [`Stretch::ranges`] has them.
    pub(crate) fn ranges(&self) -> [(f64, f64); 4] {
        let nothing = [(f64::INFINITY, f64::NEG_INFINITY); 4];
        self.stretches.iter().map(Stretch::ranges).fold(nothing, |all, own| {
            std::array::from_fn(|order| (all[order].0.min(own[order].0), all[order].1.max(own[order].1)))
        })
    }

    /// The largest absolute value of *s*, *v*, *a* and *j*.
    pub(crate) fn sizes(&self) -> [f64; 4] {
        self.ranges().map(|(low, high)| low.abs().max(high.abs()))
    }
}
