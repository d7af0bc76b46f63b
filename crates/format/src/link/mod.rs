//! The share link: a whole design in one line of readable text.
//!
//! ```text
//! 1.Example_9RT.R35_7M50_10D40C50-10D40Q50_10D40S50-10D40.1qCCrs
//! │ │           │     │                                   └ checksum
//! │ │           │     └ segments: law, β, rise
//! │ │           └ follower: kind, Rb, its parameters
//! │ └ title
//! └ version
//! ```
//!
//! Version 2 says what version 1 cannot, and what would be too long in it: it goes on with sections, each a letter behind a full stop.
//! The grammar is in `docs/design-format.md`. A link is exact (every number reads back as the same `f64`), canonical (a
//! design has one link, and no other text opens as that design) and guarded by a CRC-32: a damaged link is told, never
//! opened as another design. [`open`] undoes what programs add to a link on its way.

mod application;
mod base_62;
mod codes;
mod data;
mod number;
mod reader;
mod repair;
mod tables;
mod title;

pub use repair::{Opened, open};

use crate::limits::{MAX_LINK_MADE, MAX_LINK_OPENED};
use crate::measure::default_of;
use crate::{
    BreadthGenerator, CamKind, Conjugate, Design, DesignError, LengthUnit, Notation, SegmentDesign, Speed, SpeedUnit,
    Version,
};
use crc::{CRC_32_ISO_HDLC, Crc, NoTable};
use levalab_core::{Generator, Parameter, Rotation};
use reader::Contents;

/// A design whose link would be longer than chat programs and QR codes carry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong {
    /// Characters that the link would have.
    pub found: usize,
    /// The most that a link may have.
    pub limit: usize,
}

/// Why a link does not open.
#[derive(Clone, Debug, PartialEq)]
pub enum LinkError {
    /// There is nothing in it.
    Empty,
    /// It is longer than any link.
    TooLong(TooLong),
    /// It has a character that no link has.
    Character {
        /// The character.
        found: char,
        /// Which one it is, from 1.
        position: usize,
    },
    /// Its checksum does not match: characters were lost or changed on the way.
    Damaged,
    /// It is whole, but of a version that is not known here.
    Version {
        /// The version it says it is.
        found: String,
    },
    /// It is whole, but has a part that only a newer program knows: a section, a law or a follower.
    Newer {
        /// The letters of the part.
        found: String,
    },
    /// It is whole, but what it says cannot be read, or is not how a link says it.
    Unreadable,
    /// It is whole and can be read, but the design is refused.
    Design(DesignError),
}

/// The link of a design, without a leading `#`: of version 1 when that can say the design and is short enough, else of version 2.
///
/// # Errors
/// When the link would be too long to be carried whole; the design file has no such limit.
pub fn encode(design: &Design) -> Result<String, TooLong> {
    if let Some(text) = of_version_1(design) {
        return Ok(text);
    }
    let text = write(design, Version::Two, None);
    if text.len() <= MAX_LINK_MADE { Ok(text) } else { Err(TooLong { found: text.len(), limit: MAX_LINK_MADE }) }
}

/// The design of a link, given without its leading `#` and exactly as it was made; [`open`] takes what people paste.
///
/// # Errors
/// Says why it is no link, or why its design is refused. Nothing is computed before the checksum matches.
pub fn decode(text: &str) -> Result<Design, LinkError> {
    if text.is_empty() {
        return Err(LinkError::Empty);
    }
    if text.len() > MAX_LINK_OPENED {
        return Err(LinkError::TooLong(TooLong { found: text.chars().count(), limit: MAX_LINK_OPENED }));
    }
    // Version and checksum come first: a later version may have other characters.
    let sealed = text.rsplit_once('.').filter(|(covered, sum)| *sum == checksum(covered));
    let fields = sealed.map(|(covered, _)| covered.split_once('.').unwrap_or((covered, "")));
    let known = |number: &str| Version::ALL.into_iter().find(|version| version.number() == number);
    if let Some((number, _)) = fields.filter(|(number, _)| known(number).is_none()) {
        return Err(LinkError::Version { found: number.to_owned() });
    }
    if let Some((i, found)) = text.chars().enumerate().find(|&(_, c)| !is_of_a_link(c)) {
        return Err(LinkError::Character { found, position: i + 1 });
    }
    let whole = fields.and_then(|(number, fields)| Some((known(number)?, fields)));
    let (version, fields) = whole.ok_or(LinkError::Damaged)?;
    let Contents { design, packed } = reader::read(fields, version)?;
    design.check_tables(version).map_err(LinkError::Design)?;
    design.cam().map_err(LinkError::Design)?;
    let is_the_one = match version {
        Version::One => true,
        Version::Two => of_version_1(&design).is_none(),
    };
    if is_the_one && write(&design, version, packed) == text { Ok(design) } else { Err(LinkError::Unreadable) }
}

/// The link of version 1, when it can say the design and is short enough to be made.
fn of_version_1(design: &Design) -> Option<String> {
    let text = (design.version() == Version::One).then(|| write(design, Version::One, None));
    text.filter(|text| text.len() <= MAX_LINK_MADE)
}

fn is_of_a_link(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.')
}

/// The checksum of Ethernet, zip and PNG, bit by bit: a link is short, and a table would be a kilobyte of the page's first load.
const CRC_32: Crc<u32, NoTable> = Crc::<u32, NoTable>::new(&CRC_32_ISO_HDLC);

/// CRC-32 of the text in six digits of base 62.
fn checksum(text: &str) -> String {
    number::base_62(CRC_32.checksum(text.as_bytes()), 6)
}

/// A link in a version. A packed section that unpacks to the tables of the design stays as it is: how it is packed is up to the
/// program that made it.
fn write(design: &Design, version: Version, packed: Option<&str>) -> String {
    let mut writer = Writer { text: format!("{}.", version.number()), version };
    writer.title(&design.title);
    writer.text.push('.');
    writer.follower(design);
    writer.options(design);
    for segment in &design.segments {
        writer.segment(segment);
    }
    let mut text = writer.text;
    if version > Version::One {
        let bytes = tables::bytes_of(design.segments.iter().map(|segment| &segment.data));
        if !bytes.is_empty() {
            let same = packed.filter(|packed| tables::unpack(packed).as_ref() == Some(&bytes));
            text.extend([".", TABLES, &same.map_or_else(|| tables::pack(&bytes), str::to_owned)]);
        }
    }
    let sum = checksum(&text);
    text.push('.');
    text + &sum
}

/// The letter of the section that holds long tables.
const TABLES: &str = "t";

/// A link on its way, in the spelling of its version.
struct Writer {
    text: String,
    version: Version,
}

impl Writer {
    fn title(&mut self, title: &str) {
        title::write(&mut self.text, title, self.version);
    }

    fn number(&mut self, value: f64) {
        number::write(&mut self.text, value);
    }

    fn plus(&mut self) {
        self.text.push_str(if self.version == Version::One { "_" } else { "-p" });
    }

    /// A number with its sign.
    fn value(&mut self, value: f64) {
        if value < 0.0 {
            self.text.push('-');
        } else {
            self.plus();
        }
        self.number(value.abs());
    }

    /// Values with their signs, those at the end left out that are what they are when not told.
    fn values(&mut self, values: &[f64], defaults: impl Iterator<Item = Option<f64>>) {
        let pairs: Vec<(f64, Option<f64>)> = values.iter().copied().zip(defaults).collect();
        let told = pairs.iter().rposition(|&(value, default)| Some(value) != default).map_or(0, |last| last + 1);
        for &(value, _) in &pairs[..told] {
            self.value(value);
        }
    }

    fn follower(&mut self, design: &Design) {
        self.text.push_str(codes::of_follower(design.follower));
        self.number(design.base_radius);
        self.values(&design.values, defaults_of(design.follower.parameters, 1.0));
    }

    /// Unit, speed, rotation, kind of cam, second cam, application and notation, each only when it is not the usual one.
    fn options(&mut self, design: &Design) {
        if design.length_unit != LengthUnit::default() {
            self.text.push('u');
            self.text.push_str(codes::of_length_unit(design.length_unit));
        }
        let usual = Speed { unit: usual_speed_unit(design.kind), ..Speed::default() };
        if design.speed != usual {
            self.text.push('w');
            self.number(design.speed.value);
            self.text.push_str(codes::of_speed_unit(design.speed.unit));
        }
        if design.rotation == Rotation::Clockwise {
            self.text.push('c');
        }
        self.kind(design.kind);
        if let Some(Conjugate { tie, radius }) = design.conjugate {
            self.text.push_str(codes::of_tie(tie));
            // A distance and a radius are positive, and an angle usually is.
            if tie.value() < 0.0 {
                self.text.push('-');
            }
            self.number(tie.value().abs());
            if let Some(radius) = radius {
                self.plus();
                self.number(radius);
            }
        }
        if let Some(application) = &design.application {
            application::write(self, application);
        }
        if design.notation != Notation::default() {
            self.text.push('n');
            self.text.push(codes::of_notation(design.notation));
        }
    }

    fn kind(&mut self, kind: CamKind) {
        match kind {
            CamKind::Rotating => {}
            CamKind::Grooved => self.text.push('g'),
            CamKind::Translating { length } => {
                self.text.push('t');
                self.number(length);
            }
            CamKind::ConstantBreadth { breadth, generator } => {
                self.text.push('b');
                self.number(breadth);
                match generator {
                    BreadthGenerator::Ready(Generator::Harmonic) => self.text.push('h'),
                    BreadthGenerator::Ready(Generator::CircularArc { sides }) => {
                        self.text.push('a');
                        self.number(f64::from(sides));
                    }
                    BreadthGenerator::Mirror => self.text.push('m'),
                }
            }
        }
    }

    fn segment(&mut self, segment: &SegmentDesign) {
        self.text.push_str(codes::of_law(segment.law));
        self.number(segment.beta);
        let values: Vec<f64> = std::iter::once(segment.rise).chain(segment.parameters).collect();
        let defaults = std::iter::once(Some(0.0)).chain(defaults_of(segment.law.parameters, segment.beta));
        self.values(&values, defaults);
        data::write(self, &segment.data);
    }
}

/// The unit of speed that a link leaves out.
fn usual_speed_unit(kind: CamKind) -> SpeedUnit {
    if kind.travel().is_some() { SpeedUnit::LengthPerSecond } else { SpeedUnit::default() }
}

/// What parameters are when they are not told.
fn defaults_of(parameters: &[Parameter], beta: f64) -> impl Iterator<Item = Option<f64>> {
    parameters.iter().map(move |parameter| default_of(parameter, beta))
}

#[cfg(test)]
mod tests;
