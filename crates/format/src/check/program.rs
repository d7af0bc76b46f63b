//! The motion program of a design: ranges of each segment, then sums in the decimals that were typed, then the segments of the core.

use super::check_range;
use crate::data;
use crate::decimal::Decimal;
use crate::limits::{BETA, MAX_SEGMENTS, RISE, SUM_ROUNDING, SUM_TOLERANCE, SWING};
use crate::report::tidy;
use crate::{CamKind, CamRefusal, DataRefusal, Design, DesignError, Measure, Path, ProgramRefusal, SegmentDesign};
use levalab_core::law::{DataProblem, Free, Given, Solved};
use levalab_core::{Cycle, MIN_BETA, Program, Segment};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

impl Design {
    /// The motion program: ready-made, or joined from the segments.
    pub(super) fn program(&self) -> Result<Program, DesignError> {
        if let (Some(generator), Some(travel)) = (self.kind.generator(), self.breadth_travel()) {
            if !self.segments.is_empty() {
                return Err(DesignError::at("segments", CamRefusal::Unsuited { kind: self.kind.word() }));
            }
            return generator.program(travel).map_err(|error| self.program_error(error));
        }
        let heights = self.check_program()?;
        Program::on(self.kind.cycle(), &self.core_segments(&heights)).map_err(|error| self.program_error(error))
    }

    /// What heights and rises may be.
    pub(crate) fn heights(&self) -> &'static RangeInclusive<f64> {
        if self.is_oscillating() { &SWING } else { &RISE }
    }

    /// Checks segments and sums; gives the heights at the borders, the last of them exactly the first.
    fn check_program(&self) -> Result<Vec<Decimal>, DesignError> {
        let found = self.segments.len();
        if found == 0 {
            return Err(DesignError::at("segments", ProgramRefusal::NoSegments));
        }
        if found > MAX_SEGMENTS {
            return Err(DesignError::at("segments", ProgramRefusal::TooManySegments { found, limit: MAX_SEGMENTS }));
        }
        self.check_points()?;
        for k in 0..found {
            self.check_segment(k)?;
        }
        let turn: Decimal = self.segments.iter().map(|segment| Decimal::of(segment.beta)).sum();
        let (whole, measure) = (self.kind.whole(), self.stride());
        if misses(turn - Decimal::of(whole)) {
            return Err(DesignError::at("segments", ProgramRefusal::Turn { found: turn.to_f64(), whole, measure }));
        }
        self.check_heights()
    }

    pub(crate) fn check_segment(&self, k: usize) -> Result<(), DesignError> {
        let SegmentDesign { law, beta, rise, .. } = &self.segments[k];
        let (here, measure) = (Path::from("segments").join(k), self.lift());
        match self.kind.travel() {
            Some(length) => {
                let range = length * MIN_BETA / TAU..=length * (1.0 + SUM_TOLERANCE);
                check_range(here.join("beta"), *beta, &range, Measure::Length)?;
            }
            None => check_range(here.join("beta"), *beta, &BETA, Measure::Degrees)?,
        }
        check_range(here.join("rise"), *rise, self.heights(), measure)?;
        if law.is_dwell() && *rise != 0.0 {
            return Err(DesignError::at(here.join("rise"), ProgramRefusal::DwellRises { found: *rise, measure }));
        }
        data::check(&here, &self.segments[k], measure, self.heights())?;
        let next = (k + 1) % self.segments.len();
        let round = next == 0 && self.kind.travel().is_some();
        if law.is_matched() && self.segments[next].law.is_matched() && !round {
            return Err(DesignError::at(here.join("law"), ProgramRefusal::AdjacentPolynomials { next }));
        }
        Ok(())
    }

    fn check_heights(&self) -> Result<Vec<Decimal>, DesignError> {
        let measure = self.lift();
        let mut heights = vec![Decimal::default()];
        for k in 0..self.segments.len() {
            let height = self.end_of(k, heights[k])?;
            let closes = self.kind.cycle() == Cycle::Turn && k + 1 == self.segments.len();
            if height < Decimal::default() && misses(height) && !closes {
                let here = self.place_of_rise(k);
                return Err(DesignError::at(here, ProgramRefusal::BelowBase { found: height.to_f64(), measure }));
            }
            heights.push(height);
        }
        let last = heights[self.segments.len()];
        match (self.kind, self.breadth_travel()) {
            (CamKind::Translating { .. }, _) => return Ok(heights),
            (CamKind::ConstantBreadth { breadth, .. }, Some(travel)) => {
                if misses(last - Decimal::of(travel)) {
                    let (found, base_radius) = (last.to_f64(), self.base_radius);
                    let problem = CamRefusal::BreadthTravel { found, travel, breadth, base_radius };
                    return Err(DesignError::at("segments", problem));
                }
                return Ok(heights);
            }
            _ => {}
        }
        if misses(last) {
            if let Some(found) = self.beginning().filter(|&height| misses(Decimal::of(height))) {
                return Err(DesignError::at(self.place_of_rise(0), ProgramRefusal::Beginning { found, measure }));
            }
            return Err(DesignError::at("segments", ProgramRefusal::Closing { found: last.to_f64(), measure }));
        }
        if let Some(k) = self.segments.iter().rposition(|segment| !segment.law.is_dwell()) {
            heights[k + 1..].fill(Decimal::default());
        }
        Ok(heights)
    }

    /// The height at which a segment ends: by its rise, or by its data, which a rise that is told must agree with.
    fn end_of(&self, k: usize, start: Decimal) -> Result<Decimal, DesignError> {
        let segment = &self.segments[k];
        let (here, measure) = (Path::from("segments").join(k), self.lift());
        let Some(free) = segment.law.free() else { return Ok(start + Decimal::of(segment.rise)) };
        let end = match data::stated_end(segment) {
            Some(end) => end,
            None => {
                let solved = self.solve(free, k, start).map_err(|problem| self.data_error(k, problem))?;
                let end = solved.pieces.last().map_or(0.0, |piece| piece.at(1.0).s) / measure.to_core(1.0);
                check_range(here.clone(), end, self.heights(), measure)?;
                Decimal::of(end)
            }
        };
        let told = segment.rise != 0.0 && !data::asks_for_rise(segment.law, &segment.data);
        if told && misses(end - start - Decimal::of(segment.rise)) {
            let expected = (end - start).to_f64();
            let problem = DataRefusal::RiseDisagrees { found: segment.rise, expected, measure };
            return Err(DesignError::at(here.join("rise"), problem));
        }
        Ok(end)
    }

    /// The curve of a segment whose law is free, from the height at which the one before it ends.
    pub(crate) fn solve(&self, free: &Free, k: usize, start: Decimal) -> Result<Solved, DataProblem> {
        let segment = &self.segments[k];
        let (up, beta) = (self.lift().to_core(1.0), self.stride().to_core(segment.beta));
        let (rise, start) = (segment.rise * up, start.to_f64() * up);
        let (parameters, data) = segment.to_core(beta, up);
        (free.solve)(&Given { data: &data, beta, start, rise, parameters, ..Given::default() })
    }

    /// The height at which the first segment begins, when its law is free to begin anywhere.
    fn beginning(&self) -> Option<f64> {
        let free = self.segments.first()?.law.free()?;
        let solved = self.solve(free, 0, Decimal::default()).ok()?;
        Some(tidy(solved.pieces.first()?.at(0.0).s / self.lift().to_core(1.0)))
    }

    /// Where to look when a segment ends too low: its rise, or the whole segment when it has none.
    pub(super) fn place_of_rise(&self, k: usize) -> Path {
        let here = Path::from("segments").join(k);
        if self.segments.get(k).is_some_and(|segment| segment.law.free().is_some()) { here } else { here.join("rise") }
    }

    /// The segments for the core. β and rise are taken from border to border, so that rounding does not add up and the
    /// program ends exactly where it starts.
    fn core_segments(&self, heights: &[Decimal]) -> Vec<Segment> {
        let (stride, lift) = (self.stride(), self.lift());
        let last = self.segments.len() - 1;
        let least = self.kind.travel().map_or(1.0, |length| length / TAU);
        let (mut border, mut theta, mut height) = (Decimal::default(), 0.0, 0.0);
        let each = self.segments.iter().enumerate().map(|(k, segment)| {
            border = border + Decimal::of(segment.beta);
            let end = stride.to_core(if k == last { self.kind.whole() } else { border.to_f64() });
            let beta = (end - theta).max(MIN_BETA * least);
            let target = lift.to_core(heights[k + 1].to_f64());
            let rise = if segment.law.is_dwell() { 0.0 } else { target - height };
            (theta, height) = (theta + beta, height + rise);
            let rise = if segment.law.free().is_some() { lift.to_core(segment.rise) } else { rise };
            let (parameters, data) = segment.to_core(beta, lift.to_core(1.0));
            Segment { law: segment.law, beta, rise, parameters, data }
        });
        each.collect()
    }

    /// A file may say the rise of a free law; a design leaves it to its data.
    pub(crate) fn settle_rises(&mut self) {
        for segment in self.segments.iter_mut().filter(|s| !data::asks_for_rise(s.law, &s.data)) {
            segment.rise = 0.0;
        }
    }
}

/// True for a difference that a sum may not miss by.
pub(crate) fn misses(difference: Decimal) -> bool {
    difference.to_f64().abs() > SUM_TOLERANCE + SUM_ROUNDING
}
