//! From a design to a cam: ranges, sums and geometry, every refusal with its place in the design.

use crate::data;
use crate::decimal::Decimal;
use crate::design::to_core;
use crate::limits::{
    ANGLE, BETA, MAX_SEGMENTS, MAX_TITLE, OFFSET, RISE, SIZE, SPEED, SUM_ROUNDING, SUM_TOLERANCE, SWING,
    is_unfit_for_title,
};
use crate::report::tidy;
use crate::{
    CamKind, CamRefusal, DataRefusal, Design, DesignError, Measure, Path, Problem, ProgramRefusal, SegmentDesign,
    SpeedUnit,
};
use levalab_core::law::Given;
use levalab_core::{
    Cam, Cycle, Follower, GeometryError, GeometryProblem, MIN_BETA, Misfit, Parameter, Program, ProgramError,
    ProgramProblem, Quantity, Segment,
};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

impl Design {
    /// Checks everything there is to check and gives the cam, in radians.
    ///
    /// # Errors
    /// Names the first place that is wrong: a title, a number out of range, β's that miss 360°, rises that miss the
    /// starting height, a law or a geometry that cannot be.
    pub fn cam(&self) -> Result<Cam, DesignError> {
        check_title(&self.title)?;
        check_range(["speed", "value"], self.speed.value, &SPEED, Measure::Speed)?;
        self.check_geometry()?;
        let program = self.program()?;
        let mut values = self.values;
        for (value, parameter) in values.iter_mut().zip(self.follower.parameters) {
            *value = to_core(parameter, *value, 1.0, 1.0);
        }
        let follower = match self.kind.travel() {
            Some(_) => Follower::on_travel(self.follower, values),
            None => Follower::new(self.follower, self.base_radius, values, self.rotation),
        };
        let follower = follower.map_err(|error| self.shown(geometry_error(self.follower.parameters, error)))?;
        let cam = Cam::new(program, follower).closed_by(self.kind.closure());
        self.second(&cam)?;
        self.check_application()?;
        Ok(cam)
    }

    /// A refusal with its eccentricity in the sign of the notation.
    fn shown(&self, mut error: DesignError) -> DesignError {
        if let Problem::Misfit(Misfit::Eccentricity { eccentricity, .. }) = &mut error.problem {
            *eccentricity = *eccentricity * self.eccentricity_sign() + 0.0;
        }
        error
    }

    /// The motion program: ready-made, or joined from the segments.
    fn program(&self) -> Result<Program, DesignError> {
        if let (Some(generator), Some(travel)) = (self.kind.generator(), self.breadth_travel()) {
            if !self.segments.is_empty() {
                return Err(DesignError::at("segments", Problem::Cam(CamRefusal::Unsuited { kind: self.kind.word() })));
            }
            return generator.program(travel).map_err(|error| self.program_error(error));
        }
        let heights = self.check_program()?;
        Program::on(self.kind.cycle(), &self.core_segments(&heights)).map_err(|error| self.program_error(error))
    }

    /// What β's are measured in.
    pub(crate) fn stride(&self) -> Measure {
        if self.kind.travel().is_some() { Measure::Length } else { Measure::Degrees }
    }

    /// A place of the cycle in the units of the core.
    fn core_place(&self, place: f64) -> f64 {
        if self.kind.travel().is_some() { place } else { place.to_radians() }
    }

    /// What displacement is measured in.
    pub(crate) fn travel(&self) -> Measure {
        if self.is_oscillating() { Measure::Degrees } else { Measure::Length }
    }

    fn check_geometry(&self) -> Result<(), DesignError> {
        if self.kind.travel().is_none() {
            check_range(["cam", "base_radius"], self.base_radius, &SIZE, Measure::Length)?;
        }
        self.check_kind()?;
        if (self.speed.unit == SpeedUnit::LengthPerSecond) != self.kind.travel().is_some() {
            return Err(DesignError::at(
                ["speed", "unit"],
                Problem::Cam(CamRefusal::Unsuited { kind: self.kind.word() }),
            ));
        }
        for (parameter, &value) in self.follower.parameters.iter().zip(&self.values) {
            // A length without a natural value is a size; one that is zero unless told is an offset.
            let range = match parameter.quantity {
                Quantity::Length if parameter.default.is_none() => SIZE,
                Quantity::Length => OFFSET,
                Quantity::Angle => ANGLE,
                Quantity::Ratio | Quantity::Span | Quantity::Height => f64::MIN..=f64::MAX,
            };
            check_range(["follower", parameter.key], value, &range, measure_of(parameter))?;
        }
        Ok(())
    }

    /// Checks segments and sums; gives the heights at the borders, the last of them exactly the first.
    fn check_program(&self) -> Result<Vec<Decimal>, DesignError> {
        let found = self.segments.len();
        if found == 0 {
            return Err(DesignError::at("segments", Problem::Program(ProgramRefusal::NoSegments)));
        }
        if found > MAX_SEGMENTS {
            return Err(DesignError::at(
                "segments",
                Problem::Program(ProgramRefusal::TooManySegments { found, limit: MAX_SEGMENTS }),
            ));
        }
        for k in 0..found {
            self.check_segment(k)?;
        }
        let turn: Decimal = self.segments.iter().map(|segment| Decimal::of(segment.beta)).sum();
        let (whole, measure) = (self.kind.whole(), self.stride());
        if misses(turn - Decimal::of(whole)) {
            return Err(DesignError::at(
                "segments",
                Problem::Program(ProgramRefusal::Turn { found: turn.to_f64(), whole, measure }),
            ));
        }
        self.check_heights()
    }

    fn check_segment(&self, k: usize) -> Result<(), DesignError> {
        let SegmentDesign { law, beta, rise, .. } = &self.segments[k];
        let (here, measure) = (Path::from("segments").join(k), self.travel());
        match self.kind.travel() {
            Some(length) => {
                let range = length * MIN_BETA / TAU..=length * (1.0 + SUM_TOLERANCE);
                check_range(here.join("beta"), *beta, &range, Measure::Length)?;
            }
            None => check_range(here.join("beta"), *beta, &BETA, Measure::Degrees)?,
        }
        check_range(here.join("rise"), *rise, if self.is_oscillating() { &SWING } else { &RISE }, measure)?;
        if law.is_dwell() && *rise != 0.0 {
            return Err(DesignError::at(
                here.join("rise"),
                Problem::Program(ProgramRefusal::DwellRises { found: *rise, measure }),
            ));
        }
        data::check(&here, &self.segments[k], self.is_oscillating())?;
        let next = (k + 1) % self.segments.len();
        let round = next == 0 && self.kind.travel().is_some();
        if law.is_matched() && self.segments[next].law.is_matched() && !round {
            return Err(DesignError::at(
                here.join("law"),
                Problem::Program(ProgramRefusal::AdjacentPolynomials { next }),
            ));
        }
        Ok(())
    }

    fn check_heights(&self) -> Result<Vec<Decimal>, DesignError> {
        let measure = self.travel();
        let mut heights = vec![Decimal::default()];
        for k in 0..self.segments.len() {
            let height = self.end_of(k, heights[k])?;
            let closes = self.kind.cycle() == Cycle::Turn && k + 1 == self.segments.len();
            if height < Decimal::default() && misses(height) && !closes {
                let here = self.place_of_rise(k);
                return Err(DesignError::at(
                    here,
                    Problem::Program(ProgramRefusal::BelowBase { found: height.to_f64(), measure }),
                ));
            }
            heights.push(height);
        }
        let last = heights[self.segments.len()];
        match (self.kind, self.breadth_travel()) {
            (CamKind::Translating { .. }, _) => return Ok(heights),
            (CamKind::ConstantBreadth { breadth, .. }, Some(travel)) => {
                if misses(last - Decimal::of(travel)) {
                    let (found, base_radius) = (last.to_f64(), self.base_radius);
                    let problem = Problem::Cam(CamRefusal::BreadthTravel { found, travel, breadth, base_radius });
                    return Err(DesignError::at("segments", problem));
                }
                return Ok(heights);
            }
            _ => {}
        }
        if misses(last) {
            return Err(DesignError::at(
                "segments",
                Problem::Program(ProgramRefusal::Closing { found: last.to_f64(), measure }),
            ));
        }
        if let Some(k) = self.segments.iter().rposition(|segment| !segment.law.is_dwell()) {
            heights[k + 1..].fill(Decimal::default());
        }
        Ok(heights)
    }

    /// The height at which a segment ends: by its rise, or by its data, which a rise that is told must agree with.
    fn end_of(&self, k: usize, start: Decimal) -> Result<Decimal, DesignError> {
        let segment = &self.segments[k];
        let (here, measure) = (Path::from("segments").join(k), self.travel());
        let Some(free) = segment.law.free() else { return Ok(start + Decimal::of(segment.rise)) };
        let end = match data::stated_end(segment) {
            Some(end) => end,
            None => {
                let up = if self.is_oscillating() { 1_f64.to_radians() } else { 1.0 };
                let beta = self.core_place(segment.beta);
                let data = segment.data.scaled(beta / segment.beta, up);
                let (rise, start) = (segment.rise * up, start.to_f64() * up);
                let mut parameters = segment.parameters;
                for (value, parameter) in parameters.iter_mut().zip(segment.law.parameters) {
                    *value = to_core(parameter, *value, segment.beta, up);
                }
                let given = Given { data: &data, beta, start, rise, parameters, ..Given::default() };
                let solved =
                    (free.solve)(&given).map_err(|problem| data::refusal(&here, segment, problem, self.stride()))?;
                let end = solved.pieces.last().map_or(0.0, |piece| piece.at(1.0).s) / up;
                check_range(here.clone(), end, if self.is_oscillating() { &SWING } else { &RISE }, measure)?;
                Decimal::of(end)
            }
        };
        let told = segment.rise != 0.0 && !data::asks_for_rise(segment.law, &segment.data);
        if told && misses(end - start - Decimal::of(segment.rise)) {
            let expected = (end - start).to_f64();
            let problem = DataRefusal::RiseDisagrees { found: segment.rise, expected, measure };
            return Err(DesignError::at(here.join("rise"), problem.into()));
        }
        Ok(end)
    }

    /// A file may say the rise of a free law; a design leaves it to its data.
    pub(crate) fn settle_rises(&mut self) {
        for segment in self.segments.iter_mut().filter(|s| !data::asks_for_rise(s.law, &s.data)) {
            segment.rise = 0.0;
        }
    }

    /// Where to look when a segment ends too low: its rise, or the whole segment when it has none.
    fn place_of_rise(&self, k: usize) -> Path {
        let here = Path::from("segments").join(k);
        if self.segments.get(k).is_some_and(|segment| segment.law.free().is_some()) { here } else { here.join("rise") }
    }

    /// The segments for the core. β and rise are taken from border to border, so that rounding does not add up and the
    /// program ends exactly where it starts.
    fn core_segments(&self, heights: &[Decimal]) -> Vec<Segment> {
        let to_core_rise = |height: f64| if self.is_oscillating() { height.to_radians() } else { height };
        let last = self.segments.len() - 1;
        let least = self.kind.travel().map_or(1.0, |length| length / TAU);
        let (mut border, mut theta, mut height) = (Decimal::default(), 0.0, 0.0);
        let each = self.segments.iter().enumerate().map(|(k, segment)| {
            border = border + Decimal::of(segment.beta);
            let end = self.core_place(if k == last { self.kind.whole() } else { border.to_f64() });
            let beta = (end - theta).max(MIN_BETA * least);
            let target = to_core_rise(heights[k + 1].to_f64());
            let rise = if segment.law.is_dwell() { 0.0 } else { target - height };
            (theta, height) = (theta + beta, height + rise);
            let rise = if segment.law.free().is_some() { to_core_rise(segment.rise) } else { rise };
            let up = to_core_rise(1.0);
            let data = segment.data.scaled(beta / segment.beta, up);
            let mut parameters = segment.parameters;
            for (value, parameter) in parameters.iter_mut().zip(segment.law.parameters) {
                *value = to_core(parameter, *value, segment.beta, up);
            }
            Segment { law: segment.law, beta, rise, parameters, data }
        });
        each.collect()
    }

    /// A refusal of the core, told in the terms of the design.
    fn program_error(&self, ProgramError { segment, problem }: ProgramError) -> DesignError {
        let here = Path::from("segments").join(segment);
        let measure = self.travel();
        let edge = |value: f64| if self.is_oscillating() { value.to_degrees() } else { value };
        let (path, problem) = match problem {
            ProgramProblem::Count { found: 0 } => ("segments".into(), Problem::Program(ProgramRefusal::NoSegments)),
            ProgramProblem::Count { found } => {
                ("segments".into(), Problem::Program(ProgramRefusal::TooManySegments { found, limit: MAX_SEGMENTS }))
            }
            ProgramProblem::Beta { found } => {
                let found = if self.kind.travel().is_some() { found } else { found.to_degrees() };
                (here.join("beta"), out_of_range(found, &BETA, self.stride()))
            }
            ProgramProblem::Rise { found } => (here.join("rise"), out_of_range(edge(found), &RISE, measure)),
            ProgramProblem::DwellRises { found } => {
                (here.join("rise"), Problem::Program(ProgramRefusal::DwellRises { found: edge(found), measure }))
            }
            ProgramProblem::AdjacentPolynomials { next } => {
                (here.join("law"), Problem::Program(ProgramRefusal::AdjacentPolynomials { next }))
            }
            ProgramProblem::Turn { found } => {
                let found = if self.kind.travel().is_some() { found } else { found.to_degrees() };
                (
                    "segments".into(),
                    Problem::Program(ProgramRefusal::Turn { found, whole: self.kind.whole(), measure: self.stride() }),
                )
            }
            ProgramProblem::Data(problem) => match self.segments.get(segment) {
                Some(segment) => return data::refusal(&here, segment, problem, self.stride()),
                None => (here, Problem::Missing),
            },
            ProgramProblem::Closing { found } => {
                ("segments".into(), Problem::Program(ProgramRefusal::Closing { found: edge(found), measure }))
            }
            ProgramProblem::BelowBase { found } => (
                self.place_of_rise(segment),
                Problem::Program(ProgramRefusal::BelowBase { found: edge(found), measure }),
            ),
            ProgramProblem::Parameter { key, found, min, max } => {
                let parameters = self.segments.get(segment).map_or(&[][..], |segment| segment.law.parameters);
                let (measure, edge) = edge_of(parameters, key);
                let of_beta = |value: f64| tidy(value * self.segments[segment].beta);
                let span = parameters.iter().any(|p| p.key == key && p.quantity == Quantity::Span);
                let (measure, edge): (Measure, &dyn Fn(f64) -> f64) =
                    if span { (self.stride(), &of_beta) } else { (measure, &edge) };
                (here.join(key), Problem::OutOfRange { found: edge(found), min: edge(min), max: edge(max), measure })
            }
        };
        DesignError { path, problem }
    }
}

fn geometry_error(parameters: &[Parameter], GeometryError { key, problem }: GeometryError) -> DesignError {
    let path = if key == "base_radius" { Path::from(["cam", key]) } else { Path::from(["follower", key]) };
    let (measure, edge) = edge_of(parameters, key);
    let problem = match problem {
        GeometryProblem::NotFinite => Problem::NotFinite,
        GeometryProblem::Unsuited => Problem::Cam(CamRefusal::Unsuited { kind: CamKind::WORDS[3] }),
        GeometryProblem::NotPositive { found } => Problem::NotPositive { found: edge(found), measure },
        GeometryProblem::Outside { found, min, max } => {
            Problem::NotBetween { found: edge(found), min: edge(min), max: edge(max), measure }
        }
        GeometryProblem::Misfit(misfit) => Problem::Misfit(misfit),
    };
    DesignError { path, problem }
}

fn check_title(title: &str) -> Result<(), DesignError> {
    let found = title.chars().count();
    if found > MAX_TITLE {
        return Err(DesignError::at("title", Problem::TitleTooLong { found, limit: MAX_TITLE }));
    }
    match title.chars().position(is_unfit_for_title) {
        Some(i) => {
            let found = title.chars().nth(i).unwrap_or_default();
            Err(DesignError::at("title", Problem::TitleCharacter { found, position: i + 1 }))
        }
        None => Ok(()),
    }
}

pub(crate) fn check_range(
    path: impl Into<Path>,
    found: f64,
    range: &RangeInclusive<f64>,
    measure: Measure,
) -> Result<(), DesignError> {
    if !found.is_finite() {
        return Err(DesignError::at(path, Problem::NotFinite));
    }
    if found <= 0.0 && *range.start() > 0.0 {
        return Err(DesignError::at(path, Problem::NotPositive { found, measure }));
    }
    if range.contains(&found) { Ok(()) } else { Err(DesignError::at(path, out_of_range(found, range, measure))) }
}

fn out_of_range(found: f64, range: &RangeInclusive<f64>, measure: Measure) -> Problem {
    Problem::OutOfRange { found, min: *range.start(), max: *range.end(), measure }
}

fn misses(difference: Decimal) -> bool {
    difference.to_f64().abs() > SUM_TOLERANCE + SUM_ROUNDING
}

pub(crate) fn measure_of(parameter: &Parameter) -> Measure {
    match parameter.quantity {
        Quantity::Length | Quantity::Height => Measure::Length,
        Quantity::Angle | Quantity::Span => Measure::Degrees,
        Quantity::Ratio => Measure::Ratio,
    }
}

/// What a parameter measures, and how its values are told.
fn edge_of(parameters: &[Parameter], key: &str) -> (Measure, fn(f64) -> f64) {
    let measure = parameters.iter().find(|parameter| parameter.key == key).map_or(Measure::Length, measure_of);
    (measure, if measure == Measure::Degrees { f64::to_degrees } else { |value| value })
}
