//! What numbers measure, and how they go between the units of a design and those of the core.

use crate::{Design, SegmentDesign};
use levalab_core::law::{Data, MAX_LAW_PARAMETERS};
use levalab_core::{Parameter, Quantity};

/// What a number measures, in the units of a design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// In the design's unit of length.
    Length,
    /// In degrees.
    Degrees,
    /// A pure number.
    Ratio,
    /// In the unit of the speed beside it.
    Speed,
}

impl Measure {
    /// What a parameter measures; a part of β as those of a cam that turns.
    pub(crate) fn of(parameter: &Parameter) -> Self {
        match parameter.quantity {
            Quantity::Length | Quantity::Height => Self::Length,
            Quantity::Angle | Quantity::Span => Self::Degrees,
            Quantity::Ratio => Self::Ratio,
        }
    }

    /// A number of the core as a design tells it.
    pub(crate) fn told(self, value: f64) -> f64 {
        if self == Self::Degrees { value.to_degrees() } else { value }
    }

    /// A number of a design as the core has it.
    pub(crate) fn to_core(self, value: f64) -> f64 {
        if self == Self::Degrees { value.to_radians() } else { value }
    }
}

impl Design {
    /// What β's are measured in.
    pub(crate) fn stride(&self) -> Measure {
        if self.kind.travel().is_some() { Measure::Length } else { Measure::Degrees }
    }

    /// What displacement is measured in.
    pub(crate) fn lift(&self) -> Measure {
        if self.is_oscillating() { Measure::Degrees } else { Measure::Length }
    }
}

impl SegmentDesign {
    /// Parameters and data in the units of the core, over the β that the segment has there; `up` is what a unit of *s* is there.
    pub(crate) fn to_core(&self, beta: f64, up: f64) -> ([f64; MAX_LAW_PARAMETERS], Data) {
        (to_core(self.law.parameters, self.parameters, self.beta, up), self.data.scaled(beta / self.beta, up))
    }
}

/// The values of parameters in the units of the core; `beta` is that of their segment, and `up` what a unit of *s* is there.
pub(crate) fn to_core<const N: usize>(parameters: &[Parameter], mut values: [f64; N], beta: f64, up: f64) -> [f64; N] {
    for (value, parameter) in values.iter_mut().zip(parameters) {
        *value = match parameter.quantity {
            Quantity::Angle => value.to_radians(),
            Quantity::Span => *value / beta,
            Quantity::Height => *value * up,
            Quantity::Length | Quantity::Ratio => *value,
        };
    }
    values
}

/// The value that a design gives when it leaves a parameter out; `beta` is that of its segment.
pub(crate) fn default_of(parameter: &Parameter, beta: f64) -> Option<f64> {
    parameter.default.map(|value| match parameter.quantity {
        Quantity::Angle => value.to_degrees(),
        Quantity::Span => value * beta,
        Quantity::Length | Quantity::Ratio | Quantity::Height => value,
    })
}
