//! From a design to a cam: titles, ranges and geometry, every refusal with its place in the design.

mod program;
mod refused;

pub(crate) use program::misses;

use crate::limits::{ANGLE, MAX_TITLE, OFFSET, SIZE, SPEED, is_invisible, is_unfit_for_title};
use crate::measure::to_core;
use crate::{CamRefusal, Design, DesignError, Measure, Path, Problem, SpeedUnit};
use levalab_core::{Cam, Follower, Quantity};
use std::ops::RangeInclusive;

impl Design {
    /// Checks everything there is to check and gives the cam, in radians.
    ///
    /// # Errors
    /// Names the first place that is wrong: a title, a number out of range, β's that miss 360°, rises that miss the
    /// starting height, a law or a geometry that cannot be.
    pub fn cam(&self) -> Result<Cam, DesignError> {
        self.cams().map(|(first, _)| first)
    }

    /// Checks everything as [`Design::cam`] does and gives the cam with the second one of a conjugate pair.
    ///
    /// # Errors
    /// As [`Design::cam`].
    pub fn cams(&self) -> Result<(Cam, Option<Cam>), DesignError> {
        check_title(&self.title)?;
        check_range(["speed", "value"], self.speed.value, &SPEED, Measure::Speed)?;
        self.check_geometry()?;
        let program = self.program()?;
        let values = to_core(self.follower.parameters, self.values, 1.0, 1.0);
        let follower = match self.kind.travel() {
            Some(_) => Follower::on_travel(self.follower, &values),
            None => Follower::new(self.follower, self.base_radius, &values, self.rotation),
        };
        let follower = follower.map_err(|error| self.geometry_error(error))?;
        let cam = Cam::new(program, follower).closed_by(self.kind.closure());
        let second = self.second(&cam)?;
        self.check_application()?;
        Ok((cam, second))
    }

    fn check_geometry(&self) -> Result<(), DesignError> {
        if self.kind.travel().is_none() {
            check_range(["cam", "base_radius"], self.base_radius, &SIZE, Measure::Length)?;
        }
        self.check_kind()?;
        if (self.speed.unit == SpeedUnit::LengthPerSecond) != self.kind.travel().is_some() {
            return Err(DesignError::at(["speed", "unit"], CamRefusal::Unsuited { kind: self.kind.word() }));
        }
        for (parameter, &value) in self.follower.parameters.iter().zip(&self.values) {
            // A length without a natural value is a size; one that is zero unless told is an offset.
            let range = match parameter.quantity {
                Quantity::Length if parameter.default.is_none() => SIZE,
                Quantity::Length => OFFSET,
                Quantity::Angle => ANGLE,
                Quantity::Ratio | Quantity::Span | Quantity::Height => f64::MIN..=f64::MAX,
            };
            check_range(["follower", parameter.key], value, &range, Measure::of(parameter))?;
        }
        Ok(())
    }
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
        None if !title.is_empty() && title.chars().all(is_invisible) => {
            Err(DesignError::at("title", Problem::TitleInvisible))
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
