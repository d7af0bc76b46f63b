//! The units that a design may be in.

use crate::Design;
use levalab_core::application::Magnitude;
use std::f64::consts::TAU;

/// The unit of length of a design: a label, since the formulas are the same in any.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthUnit {
    /// Millimetres.
    #[default]
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Metres.
    Metre,
    /// Inches.
    Inch,
}

/// The unit of the cam's speed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpeedUnit {
    /// Revolutions per minute.
    RevolutionsPerMinute,
    /// Radians per second.
    #[default]
    RadiansPerSecond,
    /// Revolutions per second.
    RevolutionsPerSecond,
    /// Lengths per second, in the unit of the design: for a cam that travels, and for no other.
    LengthPerSecond,
}

impl LengthUnit {
    /// Every unit of length, in the order of a menu.
    pub const ALL: [Self; 4] = [Self::Millimetre, Self::Centimetre, Self::Metre, Self::Inch];

    /// Its symbol, which is also its word in design files.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "in",
        }
    }
}

impl LengthUnit {
    /// The unit of speed of a cam that travels, which is also its word in design files.
    #[must_use]
    pub fn per_second(self) -> &'static str {
        match self {
            Self::Millimetre => "mm/s",
            Self::Centimetre => "cm/s",
            Self::Metre => "m/s",
            Self::Inch => "in/s",
        }
    }
}

/// What the units of a displacement and of its derivatives depend on: the one place where they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MotionUnits {
    /// The unit of length.
    pub length: LengthUnit,
    /// True if the displacement is an angle.
    pub oscillating: bool,
    /// True if the cam travels, so that derivatives are per length.
    pub travels: bool,
}

impl MotionUnits {
    /// Those of a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        Self {
            length: design.length_unit,
            oscillating: design.is_oscillating(),
            travels: design.kind.travel().is_some(),
        }
    }

    /// Those of a length along the follower, such as the sliding of the contact.
    #[must_use]
    pub fn sliding(self) -> Self {
        Self { oscillating: false, ..self }
    }

    /// The unit of the derivative of that order (0 for the displacement itself), with respect to θ (or to the travel) or to time. Empty for a
    /// length per length.
    #[must_use]
    pub fn unit(self, order: u8, by_time: bool) -> String {
        let power = ["", "", "²", "³"][usize::from(order.min(3))];
        let s = if self.oscillating { "°" } else { self.length.symbol() };
        match order {
            0 => s.to_owned(),
            _ if by_time => format!("{s}/s{power}"),
            1 if self.travels => String::new(),
            _ if self.travels => format!("1/{}{}", self.length.symbol(), if order == 2 { "" } else { "²" }),
            _ => format!("{s}/rad{power}"),
        }
    }
}

impl SpeedUnit {
    /// Every unit in which a cam turns, in the order of a menu.
    pub const ALL: [Self; 3] = [Self::RevolutionsPerMinute, Self::RadiansPerSecond, Self::RevolutionsPerSecond];

    /// Its symbol beside lengths in that unit, which is also its word in design files.
    #[must_use]
    pub fn symbol(self, length: LengthUnit) -> &'static str {
        match self {
            Self::RevolutionsPerMinute => "rpm",
            Self::RadiansPerSecond => "rad/s",
            Self::RevolutionsPerSecond => "rev/s",
            Self::LengthPerSecond => length.per_second(),
        }
    }

    /// A speed in this unit as ω, rad/s (or length per second).
    #[must_use]
    pub fn omega(self, value: f64) -> f64 {
        match self {
            Self::RevolutionsPerMinute => value * (TAU / 60.0),
            Self::RadiansPerSecond | Self::LengthPerSecond => value,
            Self::RevolutionsPerSecond => value * TAU,
        }
    }
}

impl LengthUnit {
    /// The unit of a magnitude beside lengths in this unit: newtons, or pounds-force beside inches.
    #[must_use]
    pub fn unit_of(self, magnitude: Magnitude) -> &'static str {
        let of_each: [&'static str; 4] = match magnitude {
            Magnitude::Length => return self.symbol(),
            Magnitude::Angle => return "°",
            Magnitude::Area => ["mm²", "cm²", "m²", "in²"],
            Magnitude::Volume => ["mm³", "cm³", "m³", "in³"],
            Magnitude::Flow => ["mm³/s", "cm³/s", "m³/s", "in³/s"],
            Magnitude::Force => ["N", "N", "N", "lbf"],
            Magnitude::Stiffness => ["N/mm", "N/cm", "N/m", "lbf/in"],
            Magnitude::Pressure => ["MPa", "N/cm²", "Pa", "psi"],
            Magnitude::PressurePerVolume => ["MPa/mm³", "N/cm⁵", "Pa/m³", "psi/in³"],
        };
        of_each[self as usize]
    }
}
