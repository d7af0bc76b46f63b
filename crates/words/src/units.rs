//! The units that a sentence needs.

use crate::{Language, numbers};
use levalab_format::{Design, LengthUnit};

/// The units of a design: what its lengths and its displacement are measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Units {
    /// The unit of length.
    pub length: LengthUnit,
    /// True when the displacement is an angle.
    pub oscillating: bool,
    /// True when the cam travels, so that its places are lengths and derivatives are per length.
    pub travels: bool,
}

/// Between a number and its unit: the two stay on one line.
const SPACE: char = '\u{a0}';

impl Units {
    /// Those of a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        Self {
            length: design.length_unit,
            oscillating: design.is_oscillating(),
            travels: design.kind.travel().is_some(),
        }
    }

    /// A length with its unit.
    pub(crate) fn length(self, value: f64, language: Language) -> String {
        format!("{}{SPACE}{}", language.number(value), self.length.symbol())
    }

    /// A displacement or one of its derivatives with respect to θ, with its unit.
    pub(crate) fn travel(self, value: f64, order: u8, language: Language) -> String {
        if self.travels && order > 0 {
            // A length by a length is a number.
            let unit = self.length.symbol();
            let unit = [String::new(), format!("{SPACE}1/{unit}"), format!("{SPACE}1/{unit}²")];
            return format!("{}{}", language.number(value), unit[usize::from(order - 1).min(2)]);
        }
        let per = "rad";
        let per = match order {
            0 => String::new(),
            1 => format!("/{per}"),
            2 => format!("/{per}²"),
            _ => format!("/{per}³"),
        };
        match self.oscillating {
            true => format!("{}°{per}", language.number(value)),
            false => format!("{}{per}", self.length(value, language)),
        }
    }

    /// An angle told beside its limit.
    pub(crate) fn angle_beside(value: f64, limit: f64, language: Language) -> String {
        numbers::beside(value, limit, language.decimal_sign()) + "°"
    }
}
