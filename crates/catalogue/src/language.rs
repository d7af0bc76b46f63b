//! The languages, and how each writes a number.

use levalab_numbers::write::{self, DecimalSign};

/// A language that LevaLab speaks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    En,
    /// Spanish.
    Es,
}

impl Language {
    /// Every language.
    pub const ALL: [Self; 2] = [Self::En, Self::Es];

    /// Its tag, such as `en`.
    #[must_use]
    pub fn tag(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Es => "es",
        }
    }

    /// The language of a tag.
    #[must_use]
    pub fn from_tag(tag: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.tag() == tag)
    }

    /// A measured quantity with four significant digits, whole digits kept: `−1.25`, `12 345`, `4.3·10⁻⁶`.
    #[must_use]
    pub fn number(self, value: f64) -> String {
        write::measured(value, self.decimal_sign())
    }

    /// A number with all the digits that it was typed with.
    #[must_use]
    pub fn exact(self, value: f64) -> String {
        write::exact(value, self.decimal_sign())
    }

    /// An angle in degrees with one decimal at most: `33.2°`.
    #[must_use]
    pub fn angle(self, degrees: f64) -> String {
        write::rounded(degrees, 1, self.decimal_sign()) + "°"
    }

    /// A ratio with two decimals at most: `1.19`.
    #[must_use]
    pub fn ratio(self, value: f64) -> String {
        write::rounded(value, 2, self.decimal_sign())
    }

    /// An angle in degrees with four significant digits at most: `86.25°`.
    #[must_use]
    pub fn angle_exact(self, degrees: f64) -> String {
        self.number(degrees) + "°"
    }

    /// The decimal sign: a point in English, a comma in Spanish.
    #[must_use]
    pub fn decimal_sign(self) -> DecimalSign {
        match self {
            Self::En => DecimalSign::Point,
            Self::Es => DecimalSign::Comma,
        }
    }
}
