//! The units that a design may be in.

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

impl SpeedUnit {
    /// Every unit of speed, in the order of a menu.
    pub const ALL: [Self; 3] = [Self::RevolutionsPerMinute, Self::RadiansPerSecond, Self::RevolutionsPerSecond];

    /// Its symbol, which is also its word in design files.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::RevolutionsPerMinute => "rpm",
            Self::RadiansPerSecond => "rad/s",
            Self::RevolutionsPerSecond => "rev/s",
        }
    }

    /// A speed in this unit as ω, rad/s.
    #[must_use]
    pub fn omega(self, value: f64) -> f64 {
        match self {
            Self::RevolutionsPerMinute => value * (TAU / 60.0),
            Self::RadiansPerSecond => value,
            Self::RevolutionsPerSecond => value * TAU,
        }
    }
}
