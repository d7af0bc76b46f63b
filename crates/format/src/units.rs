//! The units that a design may be in.

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
