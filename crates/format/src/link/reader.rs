//! Reads the fields of a link whose checksum has matched.

use super::{LinkError, application, codes, data, defaults_of, title, usual_speed_unit};
use crate::limits::MAX_SEGMENTS;
use crate::{
    BreadthGenerator, CamKind, Conjugate, Design, DesignError, LengthUnit, Notation, Problem, ProgramRefusal,
    SegmentDesign, Speed, SpeedUnit,
};
use levalab_core::{Generator, Rotation};

/// Reads title, follower, options and segments.
///
/// It need not refuse other spellings of the same design: the caller compares with the one that would be written.
pub(super) fn read(fields: &str) -> Result<Design, LinkError> {
    let mut fields = Fields(fields);
    let design = fields.design().ok_or(LinkError::Unreadable)?;
    if design.segments.len() > MAX_SEGMENTS {
        let problem =
            Problem::Program(ProgramRefusal::TooManySegments { found: design.segments.len(), limit: MAX_SEGMENTS });
        return Err(LinkError::Design(DesignError::at("segments", problem)));
    }
    if fields.0.is_empty() { Ok(design) } else { Err(LinkError::Unreadable) }
}

/// What is left to read.
pub(super) struct Fields<'a>(pub(super) &'a str);

impl<'a> Fields<'a> {
    fn design(&mut self) -> Option<Design> {
        let (title, rest) = self.0.split_once('.')?;
        let title = title::read(title)?;
        self.0 = rest;
        let follower = codes::follower(self.code()?)?;
        let base_radius = self.number()?;
        let values = self.values(defaults_of(follower.parameters, 1.0))?;
        let length_unit = self.length_unit()?;
        let speed = self.speed()?;
        let rotation = if self.take('c') { Rotation::Clockwise } else { Rotation::CounterClockwise };
        let kind = self.kind()?;
        let travels = kind.travel().is_some();
        let usual = usual_speed_unit(kind);
        let speed = Speed { unit: speed.1.unwrap_or(usual), value: speed.0 };
        let conjugate = self.conjugate()?;
        let application = application::read(self)?;
        let notation = if self.take('n') { codes::notation(self.next()?)? } else { Notation::default() };
        let mut segments = Vec::new();
        while !self.0.is_empty() && segments.len() <= MAX_SEGMENTS {
            segments.push(self.segment()?);
        }
        let base_radius = if travels { 0.0 } else { base_radius };
        Some(Design {
            title,
            length_unit,
            speed,
            kind,
            rotation,
            base_radius,
            follower,
            values,
            segments,
            conjugate,
            application,
            notation,
        })
    }

    fn length_unit(&mut self) -> Option<LengthUnit> {
        if !self.take('u') {
            return Some(LengthUnit::default());
        }
        codes::length_unit(self.next()?)
    }

    fn kind(&mut self) -> Option<CamKind> {
        if self.take('g') {
            return Some(CamKind::Grooved);
        }
        if self.take('t') {
            return Some(CamKind::Translating { length: self.number()? });
        }
        if !self.take('b') {
            return Some(CamKind::Rotating);
        }
        let breadth = self.number()?;
        let generator = match self.next()? {
            'h' => BreadthGenerator::Ready(Generator::Harmonic),
            'a' => BreadthGenerator::Ready(Generator::CircularArc { sides: self.number()? as u32 }),
            'm' => BreadthGenerator::Mirror,
            _ => return None,
        };
        Some(CamKind::ConstantBreadth { breadth, generator })
    }

    fn conjugate(&mut self) -> Option<Option<Conjugate>> {
        if !self.take('k') {
            return Some(None);
        }
        let tie = codes::tie(self.next()?)?(self.number()?);
        let radius = if self.take('_') { Some(self.number()?) } else { None };
        Some(Some(Conjugate { tie, radius }))
    }

    /// How fast, and the unit when one is told.
    fn speed(&mut self) -> Option<(f64, Option<SpeedUnit>)> {
        if !self.take('w') {
            return Some((Speed::default().value, None));
        }
        let value = self.number()?;
        let unit = self.0.chars().next().and_then(codes::speed_unit);
        if unit.is_some() {
            self.next();
        }
        Some((value, unit))
    }

    fn segment(&mut self) -> Option<SegmentDesign> {
        let law = codes::law(self.code()?)?;
        let beta = self.number()?;
        let [rise] = self.values([Some(0.0)].into_iter())?;
        let parameters = self.values(defaults_of(law.parameters, beta))?;
        Some(SegmentDesign { law, beta, rise, parameters, data: data::read(self, law)? })
    }

    /// Signed values, as many as there are defaults; those not told are at their defaults.
    pub fn values<const N: usize>(&mut self, defaults: impl Iterator<Item = Option<f64>>) -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for (value, default) in values.iter_mut().zip(defaults) {
            *value = if self.take('_') {
                self.number()?
            } else if self.take('-') {
                -self.number()?
            } else {
                default?
            };
        }
        Some(values)
    }

    /// A capital and the small letters after it.
    fn code(&mut self) -> Option<&'a str> {
        self.0.starts_with(|c: char| c.is_ascii_uppercase()).then_some(())?;
        let end = self.0[1..].find(|c: char| !c.is_ascii_lowercase()).map_or(self.0.len(), |end| end + 1);
        Some(self.split(end))
    }

    /// Digits, a point among them perhaps, and a power of ten perhaps.
    pub fn number(&mut self) -> Option<f64> {
        let text = self.0;
        let digits =
            |from: usize| text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |length| from + length);
        let mut end = digits(0);
        if text[end..].starts_with('.') {
            end = digits(end + 1);
        }
        if text[end..].starts_with('e') {
            let sign = usize::from(text[end + 1..].starts_with('-'));
            end = digits(end + 1 + sign);
        }
        self.split(end).parse().ok()
    }

    pub fn take(&mut self, c: char) -> bool {
        let rest = self.0.strip_prefix(c);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    pub fn next(&mut self) -> Option<char> {
        let c = self.0.chars().next()?;
        self.0 = &self.0[c.len_utf8()..];
        Some(c)
    }

    fn split(&mut self, at: usize) -> &'a str {
        let (taken, rest) = self.0.split_at(at);
        self.0 = rest;
        taken
    }
}
