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
//! The grammar is in `docs/design-format.md`. A link is exact (every number reads back as the same `f64`), canonical (a
//! design has one link, and no other text opens as that design) and guarded by a CRC-32: a damaged link is told, never
//! opened as another design.

mod application;
mod codes;
mod data;
mod number;
mod reader;
mod title;

use crate::limits::{MAX_LINK_MADE, MAX_LINK_OPENED};
use crate::measure::default_of;
use crate::{BreadthGenerator, CamKind, Conjugate, Design, DesignError, LengthUnit, Notation, Speed, SpeedUnit};
use crc::{CRC_32_ISO_HDLC, Crc, NoTable};
use levalab_core::{Generator, Parameter, Rotation};

/// The version of the link, its first field.
pub const VERSION: &str = "1";

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
    /// It is whole, but what it says cannot be read, or is not how a link says it.
    Unreadable,
    /// It is whole and can be read, but the design is refused.
    Design(DesignError),
}

/// The link of a design, without a leading `#`.
///
/// # Errors
/// When the link would be too long to be carried whole; the design file has no such limit.
pub fn encode(design: &Design) -> Result<String, TooLong> {
    let text = write(design);
    if text.len() <= MAX_LINK_MADE { Ok(text) } else { Err(TooLong { found: text.len(), limit: MAX_LINK_MADE }) }
}

/// The design of a link, given without its leading `#`.
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
    if let Some((i, found)) = text.chars().enumerate().find(|&(_, c)| !is_of_a_link(c)) {
        return Err(LinkError::Character { found, position: i + 1 });
    }
    let (covered, sum) = text.rsplit_once('.').ok_or(LinkError::Damaged)?;
    if sum != checksum(covered) {
        return Err(LinkError::Damaged);
    }
    let (version, fields) = covered.split_once('.').unwrap_or((covered, ""));
    if version != VERSION {
        return Err(LinkError::Version { found: version.to_owned() });
    }
    let design = reader::read(fields)?;
    design.cam().map_err(LinkError::Design)?;
    if write(&design) == text { Ok(design) } else { Err(LinkError::Unreadable) }
}

/// The link within what a user pastes: a whole address, or a link with or without its `#`, with spaces around it.
#[must_use]
pub fn within(text: &str) -> &str {
    let text = text.trim();
    text.rsplit_once('#').map_or(text, |(_, fragment)| fragment)
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

fn write(design: &Design) -> String {
    let mut text = format!("{VERSION}.");
    title::write(&mut text, &design.title);
    text.push('.');
    write_follower(&mut text, design);
    write_options(&mut text, design);
    for segment in &design.segments {
        text.push_str(codes::of_law(segment.law));
        number::write(&mut text, segment.beta);
        let values: Vec<f64> = std::iter::once(segment.rise).chain(segment.parameters).collect();
        let defaults = std::iter::once(Some(0.0)).chain(defaults_of(segment.law.parameters, segment.beta));
        write_values(&mut text, &values, defaults);
        data::write(&mut text, &segment.data);
    }
    let sum = checksum(&text);
    text.push('.');
    text + &sum
}

fn write_follower(text: &mut String, design: &Design) {
    text.push_str(codes::of_follower(design.follower));
    number::write(text, design.base_radius);
    write_values(text, &design.values, defaults_of(design.follower.parameters, 1.0));
}

/// Values with their signs, those at the end left out that are what they are when not told.
fn write_values(text: &mut String, values: &[f64], defaults: impl Iterator<Item = Option<f64>>) {
    let pairs: Vec<(f64, Option<f64>)> = values.iter().copied().zip(defaults).collect();
    let told = pairs.iter().rposition(|&(value, default)| Some(value) != default).map_or(0, |last| last + 1);
    for &(value, _) in &pairs[..told] {
        write_value(text, value);
    }
}

fn write_value(text: &mut String, value: f64) {
    text.push(if value < 0.0 { '-' } else { '_' });
    number::write(text, value.abs());
}

/// Unit, speed, rotation, kind of cam, second cam, application and notation, each only when it is not the usual one.
fn write_options(text: &mut String, design: &Design) {
    if design.length_unit != LengthUnit::default() {
        text.push('u');
        text.push_str(codes::of_length_unit(design.length_unit));
    }
    let usual = Speed { unit: usual_speed_unit(design.kind), ..Speed::default() };
    if design.speed != usual {
        text.push('w');
        number::write(text, design.speed.value);
        text.push_str(codes::of_speed_unit(design.speed.unit));
    }
    if design.rotation == Rotation::Clockwise {
        text.push('c');
    }
    match design.kind {
        CamKind::Rotating => {}
        CamKind::Grooved => text.push('g'),
        CamKind::Translating { length } => {
            text.push('t');
            number::write(text, length);
        }
        CamKind::ConstantBreadth { breadth, generator } => {
            text.push('b');
            number::write(text, breadth);
            match generator {
                BreadthGenerator::Ready(Generator::Harmonic) => text.push('h'),
                BreadthGenerator::Ready(Generator::CircularArc { sides }) => {
                    text.push('a');
                    number::write(text, f64::from(sides));
                }
                BreadthGenerator::Mirror => text.push('m'),
            }
        }
    }
    if let Some(Conjugate { tie, radius }) = design.conjugate {
        text.push_str(codes::of_tie(tie));
        number::write(text, tie.value());
        if let Some(radius) = radius {
            text.push('_');
            number::write(text, radius);
        }
    }
    if let Some(application) = &design.application {
        application::write(text, application);
    }
    if design.notation != Notation::default() {
        text.push('n');
        text.push(codes::of_notation(design.notation));
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
