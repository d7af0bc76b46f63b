//! What is exported.

use levalab_core::Cam;
use levalab_format::{CamStudy, Design, LengthUnit, MotionUnits, Study};
use levalab_words::Language;

/// A design with its cams, and the language in which heads, names and sentences are written.
#[derive(Clone, Debug)]
pub struct Subject<'a> {
    /// The study of the design. Its number of rows does not matter: each table and drawing has its own.
    pub study: &'a Study,
    /// The language.
    pub language: Language,
}

impl<'a> Subject<'a> {
    /// The design.
    #[must_use]
    pub fn design(&self) -> &'a Design {
        self.study.design()
    }

    /// The first cam.
    #[must_use]
    pub fn cam(&self) -> &'a Cam {
        self.study.first().cam()
    }

    /// The first cam, and the second one of a conjugate pair.
    pub fn cams(&self) -> impl Iterator<Item = &'a CamStudy> + use<'a> {
        self.study.cams()
    }

    /// True for a cam that travels instead of turning.
    #[must_use]
    pub fn travels(&self) -> bool {
        self.design().kind.travel().is_some()
    }

    /// A length to which measures that nobody gave are set: the base radius, or half of what a cam that travels is long.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.design().kind.travel().map_or(self.design().base_radius, |length| length / 2.0)
    }

    /// The unit of *s*, or of its derivative of that order by θ, or by time.
    pub(crate) fn unit(&self, order: u8, by_time: bool) -> String {
        MotionUnits::of(self.design()).unit(order, by_time)
    }

    /// Millimetres in the unit of the design.
    #[must_use]
    pub fn millimetres(&self) -> f64 {
        match self.design().length_unit {
            LengthUnit::Millimetre => 1.0,
            LengthUnit::Centimetre => 10.0,
            LengthUnit::Metre => 1000.0,
            LengthUnit::Inch => 25.4,
        }
    }
}
