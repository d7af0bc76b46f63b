//! A design from JSON: every field known, every kind right, nothing left to guess.

use crate::application;
use crate::data;
use crate::design::motion_and_contact;
use crate::fields::{Field, Object};
use crate::limits::MAX_SEGMENTS;
use crate::write::{FORMAT, ROTATIONS};
use crate::{
    BreadthGenerator, CamKind, CamRefusal, Conjugate, Design, DesignError, Kind, LengthUnit, Notation, Path, Problem,
    ProgramRefusal, SegmentDesign, Speed, SpeedUnit, json,
};
use levalab_core::law::MAX_LAW_PARAMETERS;
use levalab_core::{Cam, FOLLOWERS, FollowerKind, Generator, LAWS, Law, MAX_FOLLOWER_PARAMETERS, MAX_SIDES, Tie};
use serde_json::Value;

impl Design {
    /// Reads a design file.
    ///
    /// # Errors
    /// Says where the text is not a design, and why.
    pub fn from_json(text: &str) -> Result<Self, DesignError> {
        Self::from_value(&json::parse(text)?)
    }

    /// Reads the bytes of a design file.
    ///
    /// # Errors
    /// As [`Design::from_json`], and when the bytes are not UTF-8 text.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, DesignError> {
        Self::from_value(&json::parse_bytes(bytes)?)
    }

    /// Reads a design from the object that a design file holds.
    ///
    /// # Errors
    /// As [`Design::from_json`].
    pub fn from_value(value: &Value) -> Result<Self, DesignError> {
        Self::open(value).map(|(design, _)| design)
    }

    /// A design that is being worked on: a design file as it stands, which need not make a cam.
    ///
    /// # Errors
    /// Where a field is missing, unknown or of another kind, or a list too long.
    pub fn draft(value: &Value) -> Result<Self, DesignError> {
        read(value)
    }

    /// Reads a design and gives its cam along with it, since checking the one makes the other.
    ///
    /// # Errors
    /// As [`Design::from_json`].
    pub fn open(value: &Value) -> Result<(Self, Cam), DesignError> {
        read(value)?.checked()
    }

    /// A design with its cam.
    ///
    /// # Errors
    /// As [`Design::cam`].
    pub fn checked(mut self) -> Result<(Self, Cam), DesignError> {
        let cam = self.cam()?;
        self.settle_rises();
        Ok((self, cam))
    }
}

/// The fields of a design; the last of them has no place beside a ready-made motion.
const FIELDS: [&str; 10] =
    ["format", "title", "length_unit", "speed", "cam", "follower", "conjugate", "application", "notation", "segments"];

fn read(value: &Value) -> Result<Design, DesignError> {
    let file = Object::any(value, Path::default())?;
    file.word("format", &[FORMAT])?;
    file.only(&FIELDS)?;
    let units = LengthUnit::ALL.map(LengthUnit::symbol);
    let length_unit = match file.has("length_unit") {
        true => LengthUnit::ALL[file.word("length_unit", &units)?],
        false => LengthUnit::default(),
    };
    let cam = file.object("cam")?;
    let kind = read_kind(&cam)?;
    let ready = kind.generator().is_some();
    // No segments at all may be told by an empty list.
    let none = file.optional("segments").is_some_and(|list| list.value.as_array().is_some_and(Vec::is_empty));
    if ready && !none {
        file.only(&FIELDS[..FIELDS.len() - 1])?;
    }
    let rotation = match cam.has("rotation") {
        true => ROTATIONS[cam.word("rotation", &ROTATIONS.map(|(word, _)| word))?].1,
        false => ROTATIONS[0].1,
    };
    let (follower, values) = read_follower(&file.object("follower")?)?;
    let mut design = Design {
        title: file.optional("title").map_or(Ok(String::new()), |title| title.text())?,
        length_unit,
        speed: read_speed(&file, kind, length_unit)?,
        kind,
        rotation,
        base_radius: if kind.travel().is_some() { 0.0 } else { cam.required("base_radius")?.number()? },
        follower,
        values,
        segments: if ready { Vec::new() } else { read_segments(&file)? },
        conjugate: None,
        application: None,
        notation: match file.has("notation") {
            true => Notation::ALL[file.word("notation", &Notation::WORDS)?],
            false => Notation::default(),
        },
    };
    if file.has("conjugate") {
        design.conjugate = Some(read_conjugate(&file.object("conjugate")?, &design)?);
    }
    if file.has("application") {
        design.application = Some(application::read(&file.object("application")?)?);
    }
    Ok(design)
}

fn read_kind(cam: &Object) -> Result<CamKind, DesignError> {
    Ok(match cam.word("kind", &CamKind::WORDS)? {
        0 | 1 => {
            cam.only(&["kind", "rotation", "base_radius"])?;
            if cam.word("kind", &CamKind::WORDS)? == 0 { CamKind::Rotating } else { CamKind::Grooved }
        }
        2 => {
            let generator = cam.word("generator", &BreadthGenerator::WORDS)?;
            let known = ["kind", "rotation", "base_radius", "breadth", "generator", "sides"];
            cam.only(&known[..known.len() - usize::from(generator != 1)])?;
            let generator = match generator {
                0 => BreadthGenerator::Ready(Generator::Harmonic),
                1 => BreadthGenerator::Ready(Generator::CircularArc { sides: read_sides(&cam.required("sides")?)? }),
                _ => BreadthGenerator::Mirror,
            };
            CamKind::ConstantBreadth { breadth: cam.required("breadth")?.number()?, generator }
        }
        _ => {
            cam.only(&["kind", "length"])?;
            CamKind::Translating { length: cam.required("length")?.number()? }
        }
    })
}

/// A count of sides; what is not one is refused where the sides of all polygons are.
pub(crate) fn read_sides(field: &Field) -> Result<u32, DesignError> {
    let found = field.number()?;
    let whole = found.fract() == 0.0 && (0.0..=f64::from(u16::MAX)).contains(&found);
    let problem = Problem::Cam(CamRefusal::Sides { found, most: f64::from(MAX_SIDES) });
    if whole { Ok(found as u32) } else { Err(DesignError::at(field.path.clone(), problem)) }
}

/// What ties the second element to the first: one of the fields that the follower allows.
fn read_conjugate(pair: &Object, design: &Design) -> Result<Conjugate, DesignError> {
    let ties = Conjugate::tie_keys(design);
    let radius_key = Conjugate::radius_key(design);
    let known: Vec<&'static str> = ties.iter().copied().chain(radius_key).collect();
    pair.only(&known)?;
    let given: Vec<&'static str> = ties.iter().copied().filter(|key| pair.has(key)).collect();
    let key = given.first().copied().unwrap_or(ties[0]);
    if let [_, second, ..] = given[..] {
        let problem = Problem::OneOf { expected: ties.to_vec() };
        return Err(DesignError::at(pair.path.join(second), problem));
    }
    let value = pair.required(key)?.number()?;
    let tie = match key {
        "distance" => Tie::Distance(value),
        "angle" => Tie::Angle(value),
        _ => Tie::BaseRadius(value),
    };
    let radius = radius_key.and_then(|key| pair.optional(key)).map(|field| field.number()).transpose()?;
    Ok(Conjugate { tie, radius })
}

fn read_speed(file: &Object, kind: CamKind, length_unit: LengthUnit) -> Result<Speed, DesignError> {
    let travels = kind.travel().is_some();
    if !file.has("speed") {
        let unit = if travels { SpeedUnit::LengthPerSecond } else { SpeedUnit::default() };
        return Ok(Speed { unit, ..Speed::default() });
    }
    let speed = file.object("speed")?;
    speed.only(&["value", "unit"])?;
    if travels {
        speed.word("unit", &[length_unit.per_second()])?;
        return Ok(Speed { value: speed.required("value")?.number()?, unit: SpeedUnit::LengthPerSecond });
    }
    let unit = SpeedUnit::ALL[speed.word("unit", &SpeedUnit::ALL.map(|unit| unit.symbol(length_unit)))?];
    Ok(Speed { value: speed.required("value")?.number()?, unit })
}

fn read_follower(follower: &Object) -> Result<(&'static FollowerKind, [f64; MAX_FOLLOWER_PARAMETERS]), DesignError> {
    let mut motions: Vec<&'static str> = FOLLOWERS.iter().map(|kind| motion_and_contact(kind).0).collect();
    motions.dedup();
    let motion = motions[follower.word("motion", &motions)?];
    let kinds: Vec<_> = FOLLOWERS.iter().copied().filter(|kind| motion_and_contact(kind).0 == motion).collect();
    let contacts: Vec<&'static str> = kinds.iter().map(|kind| motion_and_contact(kind).1).collect();
    let kind = kinds[follower.word("contact", &contacts)?];
    let values = follower.parameters(&["motion", "contact"], kind.parameters)?;
    Ok((kind, values))
}

fn read_segments(file: &Object) -> Result<Vec<SegmentDesign>, DesignError> {
    let list = file.required("segments")?;
    let Value::Array(items) = list.value else { return Err(list.wrong_kind(Kind::List)) };
    if items.len() > MAX_SEGMENTS {
        let problem = Problem::Program(ProgramRefusal::TooManySegments { found: items.len(), limit: MAX_SEGMENTS });
        return Err(DesignError::at(list.path, problem));
    }
    let each = items.iter().enumerate().map(|(k, item)| read_segment(&Object::any(item, list.path.join(k))?));
    each.collect()
}

fn read_segment(segment: &Object) -> Result<SegmentDesign, DesignError> {
    let ids: Vec<&'static str> = LAWS.iter().map(|law| law.id).collect();
    let law: &'static Law = LAWS[segment.word("law", &ids)?];
    let shared: Vec<&'static str> = ["law", "beta", "rise"].into_iter().chain(data::keys(law)).collect();
    let parameters: [f64; MAX_LAW_PARAMETERS] = segment.parameters(&shared, law.parameters)?;
    let beta = segment.required("beta")?.number()?;
    let data = data::read(segment, law)?;
    let rise = match segment.optional("rise") {
        None if !data::asks_for_rise(law, &data) => 0.0,
        _ => segment.required("rise")?.number()?,
    };
    Ok(SegmentDesign { law, beta, rise, parameters, data })
}
