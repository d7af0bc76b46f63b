//! A design as JSON: one order of fields, one line a segment.

use crate::application;
use crate::data;
use crate::design::motion_and_contact;
use crate::{BreadthGenerator, CamKind, Conjugate, Design, Notation, SegmentDesign};
use levalab_core::{Generator, Parameter, Rotation};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use serde_json::Value;
use serde_json::ser::Formatter;
use std::io::{self, Write};

/// The words for the senses of rotation, the default first.
pub(crate) const ROTATIONS: [(&str, Rotation); 2] =
    [("counterclockwise", Rotation::CounterClockwise), ("clockwise", Rotation::Clockwise)];

impl Design {
    /// The text of the design file.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut text = Vec::new();
        let mut writer = serde_json::Serializer::with_formatter(&mut text, Lines::default());
        // Writing numbers and strings to memory cannot fail.
        let written = self.serialize(&mut writer).is_ok();
        debug_assert!(written);
        text.push(b'\n');
        String::from_utf8(text).unwrap_or_default()
    }

    /// The object that a design file holds.
    #[must_use]
    pub fn to_value(&self) -> Value {
        serde_json::to_value(self).unwrap_or_default()
    }
}

/// In the order of the design file, whatever the format.
impl Serialize for Design {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let segments: Vec<Entries> = self.segments.iter().map(segment_entries).collect();
        let mut file = serializer.serialize_map(None)?;
        file.serialize_entry("format", self.version().format())?;
        file.serialize_entry("title", &self.title)?;
        file.serialize_entry("length_unit", self.length_unit.symbol())?;
        file.serialize_entry("speed", &self.speed_entries())?;
        file.serialize_entry("cam", &self.cam_entries())?;
        file.serialize_entry("follower", &self.follower_entries())?;
        if let Some(pair) = &self.conjugate {
            let radius = Conjugate::radius_key(self).zip(pair.radius).map(|(key, radius)| (key, number(radius)));
            let tie = (pair.tie.key(), number(pair.tie.value()));
            file.serialize_entry("conjugate", &Entries(std::iter::once(tie).chain(radius).collect()))?;
        }
        if let Some(application) = &self.application {
            file.serialize_entry("application", &Entries(application::entries(application)))?;
        }
        if self.notation != Notation::default() {
            file.serialize_entry("notation", self.notation.word())?;
        }
        if self.kind.generator().is_none() {
            file.serialize_entry("segments", &segments)?;
        }
        file.end()
    }
}

impl Design {
    fn speed_entries(&self) -> Entries {
        Entries(vec![("value", number(self.speed.value)), ("unit", self.speed.unit.symbol(self.length_unit).into())])
    }

    fn cam_entries(&self) -> Entries {
        let rotation = ROTATIONS.iter().find(|entry| entry.1 == self.rotation).unwrap_or(&ROTATIONS[0]).0;
        let mut entries: Vec<(&'static str, Value)> = vec![("kind", self.kind.word().into())];
        if let CamKind::Translating { length } = self.kind {
            entries.push(("length", number(length)));
            return Entries(entries);
        }
        entries.extend([("rotation", rotation.into()), ("base_radius", number(self.base_radius))]);
        if let CamKind::ConstantBreadth { breadth, generator } = self.kind {
            entries.extend([("breadth", number(breadth)), ("generator", generator.word().into())]);
            if let BreadthGenerator::Ready(Generator::CircularArc { sides }) = generator {
                entries.push(("sides", sides.into()));
            }
        }
        Entries(entries)
    }

    fn follower_entries(&self) -> Entries {
        let (motion, contact) = motion_and_contact(self.follower);
        let shared = [("motion", motion.into()), ("contact", contact.into())];
        Entries(shared.into_iter().chain(parameter_entries(self.follower.parameters, &self.values)).collect())
    }
}

fn segment_entries(segment: &SegmentDesign) -> Entries {
    let mut entries = vec![("law", segment.law.id.into()), ("beta", number(segment.beta))];
    if data::asks_for_rise(segment.law, &segment.data) {
        entries.push(("rise", number(segment.rise)));
    }
    entries.extend(parameter_entries(segment.law.parameters, &segment.parameters));
    entries.extend(data::entries(&segment.data));
    Entries(entries)
}

/// The object that a segment is in a design file.
pub(crate) fn segment_value(segment: &SegmentDesign) -> Value {
    serde_json::to_value(segment_entries(segment)).unwrap_or_default()
}

fn parameter_entries<'a>(
    parameters: &'a [Parameter],
    values: &'a [f64],
) -> impl Iterator<Item = (&'static str, Value)> + 'a {
    parameters.iter().zip(values).map(|(parameter, &value)| (parameter.key, number(value)))
}

/// A whole number without a decimal point, as people write it.
pub(crate) fn number(value: f64) -> Value {
    const EXACT: f64 = (1_u64 << 53) as f64;
    if value.fract() == 0.0 && value.abs() < EXACT { Value::from(value as i64) } else { Value::from(value) }
}

/// Fields in their order.
struct Entries(Vec<(&'static str, Value)>);

impl Serialize for Entries {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

/// JSON with a line for each field of the file and for each segment, and the rest within the line.
#[derive(Default)]
struct Lines {
    depth: usize,
}

impl Lines {
    /// Objects and lists this deep spread over lines: the file and its segments.
    const SPREAD: usize = 2;

    fn open(&mut self, writer: &mut (impl ?Sized + Write), bracket: &str, spread: bool) -> io::Result<()> {
        self.depth += 1;
        writer.write_all(bracket.as_bytes())?;
        if spread { Ok(()) } else { writer.write_all(b" ") }
    }

    fn close(&mut self, writer: &mut (impl ?Sized + Write), bracket: &str, spread: bool) -> io::Result<()> {
        self.depth -= 1;
        if spread {
            self.new_line(writer)?;
        } else {
            writer.write_all(b" ")?;
        }
        writer.write_all(bracket.as_bytes())
    }

    fn part(&self, writer: &mut (impl ?Sized + Write), first: bool, spread: bool) -> io::Result<()> {
        writer.write_all(if first { b"" } else { b"," })?;
        match (spread, first) {
            (true, _) => self.new_line(writer),
            (false, true) => Ok(()),
            (false, false) => writer.write_all(b" "),
        }
    }

    fn new_line(&self, writer: &mut (impl ?Sized + Write)) -> io::Result<()> {
        writer.write_all(b"\n")?;
        writer.write_all("  ".repeat(self.depth).as_bytes())
    }
}

impl Formatter for Lines {
    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let spread = self.depth == 0;
        self.open(writer, "{", spread)
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let spread = self.depth == 1;
        self.close(writer, "}", spread)
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.part(writer, first, self.depth == 1)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }

    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let spread = self.depth < Self::SPREAD;
        self.open(writer, "[", spread)
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let spread = self.depth <= Self::SPREAD;
        self.close(writer, "]", spread)
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.part(writer, first, self.depth <= Self::SPREAD)
    }
}
