//! The same design in other units, every length of it.

mod formula;

use crate::application::TargetsBy;
use crate::decimal::Decimal;
use crate::{
    ApplicationDesign, CamKind, CamRefusal, Conjugate, Design, DesignError, LengthUnit, Problem, ProgramRefusal,
    SegmentDesign, Speed, SpeedUnit,
};
use levalab_core::application::Magnitude;
use levalab_core::law::{Condition, Data};
use levalab_core::{Parameter, Quantity, Tie};
use std::f64::consts::TAU;

impl Design {
    /// The same cam with its lengths in another unit: other numbers, the same piece of steel.
    ///
    /// Numbers of up to fourteen digits come back as they were when the design is converted back.
    ///
    /// # Errors
    /// When a length is beyond what a design may hold in that unit, or a formula becomes too long.
    pub fn in_unit(&self, unit: LengthUnit) -> Result<Self, DesignError> {
        let change = Change { from: self.length_unit, to: unit, travels: self.kind.travel().is_some() };
        let mut design = change.design(self);
        if let Err(DesignError { problem, .. }) = design.cam() {
            design.close(&problem);
            design.cam()?;
        }
        Ok(design)
    }

    /// Another cam with the same numbers, now in another unit.
    #[must_use]
    pub fn relabelled(&self, unit: LengthUnit) -> Self {
        Self { length_unit: unit, ..self.clone() }
    }

    /// The same cam with its speed in another unit.
    ///
    /// # Errors
    /// When the cam travels, whose speed is in its unit of length, or does not.
    pub fn in_speed_unit(&self, unit: SpeedUnit) -> Result<Self, DesignError> {
        let travels = SpeedUnit::LengthPerSecond;
        if (unit == travels) != (self.speed.unit == travels) {
            return Err(DesignError::at(["speed", "unit"], CamRefusal::Unsuited { kind: self.kind.word() }));
        }
        let (from, to) = sizes(self.speed.unit, unit);
        let design = Self { speed: Speed { value: between(self.speed.value, from, to), unit }, ..self.clone() };
        design.cam()?;
        Ok(design)
    }

    /// Puts a sum in order that only just passed and would miss in a smaller unit: the last segment that has a say takes what is left.
    fn close(&mut self, missed: &Problem) {
        let less = |value: &mut f64, more: f64| *value = (Decimal::of(*value) - Decimal::of(more)).to_f64();
        match *missed {
            Problem::Program(ProgramRefusal::Turn { found, whole, .. }) => {
                if let Some(last) = self.segments.last_mut() {
                    less(&mut last.beta, found - whole);
                }
            }
            Problem::Program(ProgramRefusal::Closing { found, .. })
            | Problem::Cam(CamRefusal::BreadthTravel { found, .. }) => {
                let above = found - self.breadth_travel().unwrap_or(0.0);
                let last =
                    self.segments.iter_mut().rfind(|segment| segment.rise != 0.0 || segment.law.free().is_some());
                if let Some(last) = last.filter(|segment| segment.law.free().is_none()) {
                    less(&mut last.rise, above);
                }
            }
            _ => {}
        }
    }
}

/// A change of the unit of length.
struct Change {
    from: LengthUnit,
    to: LengthUnit,
    /// True when places along the cam are lengths too.
    travels: bool,
}

impl Change {
    fn design(&self, design: &Design) -> Design {
        let length = |value: f64| self.power(value, 1);
        let mut values = design.values;
        for (value, parameter) in values.iter_mut().zip(design.follower.parameters) {
            *value = self.parameter(parameter, *value);
        }
        Design {
            length_unit: self.to,
            speed: match design.speed.unit {
                SpeedUnit::LengthPerSecond => Speed { value: length(design.speed.value), ..design.speed },
                _ => design.speed,
            },
            kind: match design.kind {
                CamKind::ConstantBreadth { breadth, generator } => {
                    CamKind::ConstantBreadth { breadth: length(breadth), generator }
                }
                CamKind::Translating { length: travel } => CamKind::Translating { length: length(travel) },
                other => other,
            },
            base_radius: length(design.base_radius),
            values,
            segments: design.segments.iter().map(|segment| self.segment(segment, design.is_oscillating())).collect(),
            conjugate: design.conjugate.map(|Conjugate { tie, radius }| Conjugate {
                tie: match tie {
                    Tie::Angle(_) => tie,
                    Tie::Distance(value) | Tie::BaseRadius(value) => tie.with(length(value)),
                },
                radius: radius.map(length),
            }),
            application: design.application.as_ref().map(|application| self.application(application)),
            ..design.clone()
        }
    }

    fn application(&self, design: &ApplicationDesign) -> ApplicationDesign {
        let mut after = design.clone();
        for (value, setting) in after.values.iter_mut().zip(design.application.parameters) {
            *value = self.magnitude(setting.magnitude, *value);
        }
        for [at, value] in &mut after.targets {
            *at = if design.by == TargetsBy::Theta { self.place(*at) } else { *at };
            *value = self.magnitude(design.main().magnitude, *value);
        }
        after
    }

    fn segment(&self, segment: &SegmentDesign, oscillating: bool) -> SegmentDesign {
        let height = |value: f64| if oscillating { value } else { self.power(value, 1) };
        let mut after = SegmentDesign { beta: self.place(segment.beta), rise: height(segment.rise), ..segment.clone() };
        for (value, parameter) in after.parameters.iter_mut().zip(segment.law.parameters) {
            *value =
                if parameter.quantity == Quantity::Height { height(*value) } else { self.parameter(parameter, *value) };
        }
        let converted = |condition: &mut Condition| {
            condition.at = self.place(condition.at);
            let per_place = if self.travels { i32::from(condition.order) } else { 0 };
            condition.value = if oscillating { condition.value } else { self.power(condition.value, 1 - per_place) };
        };
        match &mut after.data {
            Data::None => {}
            Data::Conditions(conditions) => conditions.iter_mut().for_each(converted),
            Data::Spline { conditions, knots } => {
                conditions.iter_mut().for_each(converted);
                knots.iter_mut().for_each(|knot| *knot = self.place(*knot));
            }
            Data::Points(points) => {
                for [at, s] in points {
                    (*at, *s) = (self.place(*at), height(*s));
                }
            }
            Data::Ordinates(ordinates) => ordinates.iter_mut().for_each(|s| *s = height(*s)),
            Data::Expression(text) => {
                if !oscillating {
                    *text = self.formula(text);
                }
            }
        }
        after
    }

    /// A place along the cam.
    fn place(&self, value: f64) -> f64 {
        if self.travels { self.power(value, 1) } else { value }
    }

    fn parameter(&self, parameter: &Parameter, value: f64) -> f64 {
        match parameter.quantity {
            Quantity::Length | Quantity::Height => self.power(value, 1),
            Quantity::Span => self.place(value),
            Quantity::Angle | Quantity::Ratio => value,
        }
    }

    /// A value in the unit that a magnitude has beside lengths in a unit.
    fn magnitude(&self, magnitude: Magnitude, value: f64) -> f64 {
        let (lengths, forces) = match magnitude {
            Magnitude::Angle => return value,
            Magnitude::Length => (1, 0),
            Magnitude::Area => (2, 0),
            Magnitude::Volume | Magnitude::Flow => (3, 0),
            Magnitude::Force => (0, 1),
            Magnitude::Stiffness => (-1, 1),
            Magnitude::Pressure => (-2, 1),
            Magnitude::PressurePerVolume => (-5, 1),
        };
        let size = |unit: LengthUnit, other: LengthUnit| {
            // Lengths that divide are the other unit's multiplied, so that powers stay whole numbers.
            let of = if lengths < 0 { other } else { unit };
            tenths_of_millimetres(of).powi(i32::abs(lengths)) * newtons(unit).powi(forces)
        };
        between(value, size(self.from, self.to), size(self.to, self.from))
    }

    /// A value measured in some power of the unit of length.
    fn power(&self, value: f64, power: i32) -> f64 {
        let size = |unit: LengthUnit| tenths_of_millimetres(unit).powi(power.abs());
        let (from, to) = (size(self.from), size(self.to));
        if power < 0 { between(value, to, from) } else { between(value, from, to) }
    }
}

/// A whole number, so that a conversion rounds no more than twice.
fn tenths_of_millimetres(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::Millimetre => 10.0,
        LengthUnit::Centimetre => 100.0,
        LengthUnit::Metre => 10_000.0,
        LengthUnit::Inch => 254.0,
    }
}

/// The unit of force beside a unit of length: pounds-force beside inches.
fn newtons(unit: LengthUnit) -> f64 {
    if unit == LengthUnit::Inch { 4.448_221_615_260_5 } else { 1.0 }
}

/// How the sizes of two units of speed are to each other, each as a number that is not rounded more than once.
fn sizes(from: SpeedUnit, to: SpeedUnit) -> (f64, f64) {
    use SpeedUnit::{RadiansPerSecond, RevolutionsPerMinute, RevolutionsPerSecond};
    match (from, to) {
        (RevolutionsPerMinute, RevolutionsPerSecond) => (1.0, 60.0),
        (RevolutionsPerMinute, RadiansPerSecond) => (TAU, 60.0),
        (RevolutionsPerSecond, RadiansPerSecond) => (TAU, 1.0),
        (RevolutionsPerSecond, RevolutionsPerMinute) => (60.0, 1.0),
        (RadiansPerSecond, RevolutionsPerMinute) => (60.0, TAU),
        (RadiansPerSecond, RevolutionsPerSecond) => (1.0, TAU),
        _ => (1.0, 1.0),
    }
}

/// What is `value` units of size `from`, in units of size `to`.
///
/// Where a number of few digits is what a conversion the other way would have made `value` of, it is that number: so a
/// design comes back as it was typed.
fn between(value: f64, from: f64, to: f64) -> f64 {
    if from == to {
        return value;
    }
    let plain = value * from / to;
    let short = DIGITS.map(|digits| rounded(plain, digits));
    short.into_iter().find(|short| short * to / from == value).unwrap_or(plain)
}

/// Digits that any decimal keeps in an `f64`, and one less, which makes up for the rounding of units that are products.
const DIGITS: [usize; 2] = [14, 15];

/// The nearest number of so many digits.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().map_or(value, |rounded: f64| rounded + 0.0)
}

#[cfg(test)]
mod tests;
