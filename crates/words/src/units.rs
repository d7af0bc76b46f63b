//! The units that a sentence needs.

use crate::Language;
use levalab_format::{Design, LengthUnit, MotionUnits};
use levalab_numbers::write;

/// The units of a design, and with respect to what its derivatives are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Units {
    /// The unit of length.
    pub length: LengthUnit,
    /// True when the displacement is an angle.
    pub oscillating: bool,
    /// True when the cam travels, so that its places are lengths and derivatives are per length.
    pub travels: bool,
    /// ω, for derivatives with respect to time; none for those with respect to θ.
    omega: Option<f64>,
}

/// Between a number and its unit: the two stay on one line.
const SPACE: char = '\u{a0}';

impl Units {
    /// Those of a design, with derivatives with respect to θ.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let MotionUnits { length, oscillating, travels } = MotionUnits::of(design);
        Self { length, oscillating, travels, omega: None }
    }

    /// Those of a design, with derivatives with respect to time.
    #[must_use]
    pub fn by_time(design: &Design) -> Self {
        Self { omega: Some(design.omega()), ..Self::of(design) }
    }

    /// A length with its unit.
    pub(crate) fn length(self, value: f64, language: Language) -> String {
        format!("{}{SPACE}{}", language.number(value), self.length.symbol())
    }

    /// A displacement or one of its derivatives with respect to θ, given in the unit of the design, with its unit; with respect to time when
    /// these units are.
    pub(crate) fn travel(self, value: f64, order: u8, language: Language) -> String {
        let Self { length, oscillating, travels, omega } = self;
        let number = language.number(value * omega.map_or(1.0, |omega| omega.powi(i32::from(order))));
        let unit = MotionUnits { length, oscillating, travels }.unit(order, omega.is_some());
        match unit.as_str() {
            "" => number,
            degrees if degrees.starts_with('°') => number + degrees,
            unit => format!("{number}{SPACE}{unit}"),
        }
    }

    /// An angle told beside its limit.
    pub(crate) fn angle_beside(value: f64, limit: f64, language: Language) -> String {
        write::compared(value, limit, language.decimal_sign()) + "°"
    }
}
