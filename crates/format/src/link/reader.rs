//! Reads the fields of a link whose checksum has matched.

use super::{LinkError, TABLES, application, codes, data, defaults_of, tables, title, usual_speed_unit};
use crate::limits::MAX_SEGMENTS;
use crate::version;
use crate::{
    BreadthGenerator, CamKind, Conjugate, Design, DesignError, LengthUnit, Notation, Problem, ProgramRefusal,
    SegmentDesign, Speed, SpeedUnit, Version,
};
use levalab_core::law::Data;
use levalab_core::{FollowerKind, Generator, Law, Rotation};

/// What a link says.
pub(super) struct Contents<'a> {
    pub design: Design,
    /// The body of the section of long tables, as it is packed.
    pub packed: Option<&'a str>,
}

/// Reads title, follower, options and segments, and the sections behind them.
///
/// It need not refuse other spellings of the same design: the caller compares with the one that would be written.
pub(super) fn read(fields: &str, version: Version) -> Result<Contents<'_>, LinkError> {
    let mut fields = Fields { rest: fields, version, unknown: None };
    let Some(mut design) = fields.design() else {
        return Err(match fields.unknown {
            Some(code) if version > Version::One => LinkError::Newer { found: code.to_owned() },
            _ => LinkError::Unreadable,
        });
    };
    if design.segments.len() > MAX_SEGMENTS {
        let problem =
            Problem::Program(ProgramRefusal::TooManySegments { found: design.segments.len(), limit: MAX_SEGMENTS });
        return Err(LinkError::Design(DesignError::at("segments", problem)));
    }
    let mut packed = None;
    while !fields.rest.is_empty() {
        match fields.section().filter(|_| version > Version::One).ok_or(LinkError::Unreadable)? {
            (TABLES, body) => packed = Some(body),
            (letter, _) => return Err(LinkError::Newer { found: letter.to_owned() }),
        }
    }
    if let Some(body) = packed {
        fill_tables(&mut design, body).ok_or(LinkError::Unreadable)?;
    }
    Ok(Contents { design, packed })
}

/// Gives the tables of a section to the segments that have none of their own.
fn fill_tables(design: &mut Design, body: &str) -> Option<()> {
    let mut tables = tables::tables_of(&tables::unpack(body)?)?.into_iter();
    for segment in &mut design.segments {
        if let Data::Points(points) = &mut segment.data
            && points.is_empty()
        {
            *points = tables.next()?;
        }
    }
    tables.next().is_none().then_some(())
}

/// What is left to read.
pub(super) struct Fields<'a> {
    pub rest: &'a str,
    pub version: Version,
    /// The code of a law or a follower that is not known here.
    unknown: Option<&'a str>,
}

impl<'a> Fields<'a> {
    fn design(&mut self) -> Option<Design> {
        let (title, rest) = self.rest.split_once('.')?;
        let title = title::read(title, self.version)?;
        self.rest = rest;
        let follower = self.known(codes::follower)?;
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
        while !self.rest.is_empty() && !self.rest.starts_with('.') && segments.len() <= MAX_SEGMENTS {
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
        let tie = codes::tie(self.next()?)?;
        let sign = if self.take('-') { -1.0 } else { 1.0 };
        let tie = tie(sign * self.number()?);
        let radius = if self.takes_plus() { Some(self.number()?) } else { None };
        Some(Some(Conjugate { tie, radius }))
    }

    /// How fast, and the unit when one is told.
    fn speed(&mut self) -> Option<(f64, Option<SpeedUnit>)> {
        if !self.take('w') {
            return Some((Speed::default().value, None));
        }
        let value = self.number()?;
        let unit = self.rest.chars().next().and_then(codes::speed_unit);
        if unit.is_some() {
            self.next();
        }
        Some((value, unit))
    }

    fn segment(&mut self) -> Option<SegmentDesign> {
        let law = self.known(codes::law)?;
        let beta = self.number()?;
        let [rise] = self.values([Some(0.0)].into_iter())?;
        let parameters = self.values(defaults_of(law.parameters, beta))?;
        Some(SegmentDesign { law, beta, rise, parameters, data: data::read(self, law)? })
    }

    /// Signed values, as many as there are defaults; those not told are at their defaults.
    pub fn values<const N: usize>(&mut self, defaults: impl Iterator<Item = Option<f64>>) -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for (value, default) in values.iter_mut().zip(defaults) {
            *value = if self.takes_plus() {
                self.number()?
            } else if self.take('-') {
                -self.number()?
            } else {
                default?
            };
        }
        Some(values)
    }

    /// What a code stands for in the version of the link.
    fn known<T: Known>(&mut self, of_code: fn(&str) -> Option<&'static T>) -> Option<&'static T> {
        let code = self.code()?;
        let found = of_code(code).filter(|found| found.is_known(self.version));
        if found.is_none() {
            self.unknown = Some(code);
        }
        found
    }

    /// A full stop, a small letter and all up to the next of such: no number goes on with a letter behind its point.
    fn section(&mut self) -> Option<(&'a str, &'a str)> {
        let is_start = |text: &str| text.starts_with('.') && text[1..].starts_with(|c: char| c.is_ascii_lowercase());
        if !is_start(self.rest) {
            return None;
        }
        let after = self.rest[2..].char_indices().map(|(at, _)| at + 2);
        let end = after.into_iter().find(|&at| is_start(&self.rest[at..])).unwrap_or(self.rest.len());
        let section = self.split(end);
        Some((&section[1..2], &section[2..]))
    }

    fn takes_plus(&mut self) -> bool {
        match self.version {
            Version::One => self.take('_'),
            Version::Two => {
                let after = self.rest.strip_prefix("-p");
                self.rest = after.unwrap_or(self.rest);
                after.is_some()
            }
        }
    }

    /// A capital and the small letters after it.
    fn code(&mut self) -> Option<&'a str> {
        self.rest.starts_with(|c: char| c.is_ascii_uppercase()).then_some(())?;
        let end = self.rest[1..].find(|c: char| !c.is_ascii_lowercase()).map_or(self.rest.len(), |end| end + 1);
        Some(self.split(end))
    }

    /// Digits, a point among them perhaps, and a power of ten perhaps.
    pub fn number(&mut self) -> Option<f64> {
        let text = self.rest;
        let digits =
            |from: usize| text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |length| from + length);
        let mut end = digits(0);
        if text[end..].starts_with('.') && text[end + 1..].starts_with(|c: char| c.is_ascii_digit()) {
            end = digits(end + 1);
        }
        if text[end..].starts_with('e') {
            let sign = usize::from(text[end + 1..].starts_with('-'));
            end = digits(end + 1 + sign);
        }
        self.split(end).parse().ok()
    }

    pub fn take(&mut self, c: char) -> bool {
        let rest = self.rest.strip_prefix(c);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    pub fn next(&mut self) -> Option<char> {
        let c = self.rest.chars().next()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    fn split(&mut self, at: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at(at);
        self.rest = rest;
        taken
    }
}

/// Something that a code stands for.
trait Known {
    fn is_known(&self, version: Version) -> bool;
}

impl Known for Law {
    fn is_known(&self, version: Version) -> bool {
        version::of_law(self) <= version
    }
}

impl Known for FollowerKind {
    fn is_known(&self, version: Version) -> bool {
        version::of_follower(self) <= version
    }
}
