//! The program of a design that need not be a cam yet: what is left of the cycle, the height at each border.

use crate::check::misses;
use crate::data::{asks_for_rise, stated_end};
use crate::decimal::Decimal;
use crate::digits::clean;
use crate::{CamKind, Design};
use levalab_core::law::Data;
use serde::Serialize;

/// What a form shows of a program that is being worked on; heights are above the base circle, in the unit of *s*.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outline {
    /// What the β's must add up to: degrees, or length.
    pub whole: f64,
    /// What is left of it; negative where the β's add up to more.
    pub left: f64,
    /// How far the program ends above the height where it should.
    pub open: f64,
    /// The height at each border, one more than there are segments.
    pub heights: Vec<f64>,
    /// The rise of each segment.
    pub rises: Vec<f64>,
    /// The greatest of the heights.
    pub lift: f64,
    /// How far the follower of a cam of constant breadth travels.
    pub travel: Option<f64>,
    /// True if the last segment can take what is left, or give back what is beyond the cycle.
    pub stretches: bool,
    /// True if a segment can take the height that is left open.
    pub closes: bool,
}

impl Design {
    /// The outline of the program.
    #[must_use]
    pub fn outline(&self) -> Outline {
        let left = self.left();
        let heights = self.draft_heights();
        let last = self.segments.last().map(|segment| Decimal::of(segment.beta) + left);
        Outline {
            whole: self.kind.whole(),
            left: clean(left.to_f64()),
            open: clean(self.open_height().to_f64()),
            heights: heights.iter().map(|height| clean(height.to_f64())).collect(),
            rises: heights.windows(2).map(|ends| clean((ends[1] - ends[0]).to_f64())).collect(),
            lift: clean(self.draft_lift()),
            travel: self.breadth_travel(),
            stretches: last.is_some_and(|beta| beta > Decimal::default()),
            closes: self.last_move().is_some(),
        }
    }

    /// What is left of the cycle; nothing where the check of the program finds nothing missing.
    pub(crate) fn left(&self) -> Decimal {
        if self.kind.generator().is_some() {
            return Decimal::default();
        }
        let turn: Decimal = self.segments.iter().map(|segment| Decimal::of(segment.beta)).sum();
        noticed(Decimal::of(self.kind.whole()) - turn)
    }

    /// How far the program ends above where it should: the starting height, or the far side of half a turn. A cam that travels
    /// back the same way may end anywhere.
    pub(crate) fn open_height(&self) -> Decimal {
        let end = self.draft_heights().last().copied().unwrap_or_default();
        match self.kind {
            _ if self.kind.generator().is_some() => Decimal::default(),
            CamKind::Translating { .. } => Decimal::default(),
            _ => noticed(end - Decimal::of(self.breadth_travel().unwrap_or(0.0))),
        }
    }

    /// The height at each border as rises and data say it; where they say nothing yet, the height before.
    pub(crate) fn draft_heights(&self) -> Vec<Decimal> {
        let mut heights = vec![Decimal::default()];
        let mut start = Decimal::default();
        for k in 0..self.segments.len() {
            start = self.draft_end(k, start);
            heights.push(start);
        }
        heights
    }

    /// The greatest height at a border.
    pub(crate) fn draft_lift(&self) -> f64 {
        self.draft_heights().into_iter().max().unwrap_or_default().to_f64()
    }

    /// The last segment that can be made to end at another height.
    pub(crate) fn last_move(&self) -> Option<usize> {
        let segment = |k: &usize| &self.segments[*k];
        let moves = |k: &usize| segment(k).rise != 0.0 || segment(k).law.free().is_some();
        let last = (0..self.segments.len()).rev().find(moves)?;
        // A formula that does not name L ends where it ends.
        let fixed = matches!(segment(&last).data, Data::Expression(_)) && !self.asks_for_rise(last);
        (!fixed).then_some(last)
    }

    fn asks_for_rise(&self, k: usize) -> bool {
        asks_for_rise(self.segments[k].law, &self.segments[k].data)
    }

    fn draft_end(&self, k: usize, start: Decimal) -> Decimal {
        let segment = &self.segments[k];
        let Some(free) = segment.law.free() else { return start + Decimal::of(segment.rise) };
        let last_point = || match &segment.data {
            Data::Points(points) => points.last().map(|point| Decimal::of(point[1])),
            _ => None,
        };
        let solved = || {
            self.check_segment(k).ok()?;
            let solved = self.solve(free, k, start).ok()?;
            Some(Decimal::of(solved.pieces.last()?.at(1.0).s / self.lift().to_core(1.0)))
        };
        stated_end(segment).or_else(last_point).or_else(solved).unwrap_or(start + Decimal::of(segment.rise))
    }
}

/// A difference, or nothing where it passes for none.
fn noticed(difference: Decimal) -> Decimal {
    if misses(difference) { difference } else { Decimal::default() }
}
