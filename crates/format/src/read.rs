//! A design from JSON: every field known, every kind right, nothing left to guess.

use crate::application;
use crate::data;
use crate::design::motion_and_contact;
use crate::fields::{Field, Object};
use crate::limits::MAX_SEGMENTS;
use crate::version::{is_newer, of_follower, of_law};
use crate::write::ROTATIONS;
use crate::{
    BreadthGenerator, CamKind, CamRefusal, Conjugate, Design, DesignError, Kind, LengthUnit, Notation, Path, Problem,
    ProgramRefusal, SegmentDesign, Speed, SpeedUnit, json,
};
use levalab_catalogue::Version;
use levalab_core::law::MAX_LAW_PARAMETERS;
use levalab_core::{Cam, FOLLOWERS, FollowerKind, Generator, LAWS, Law, MAX_FOLLOWER_PARAMETERS, MAX_SIDES, Tie};
use serde_json::Value;

impl Design {
    /// Reads a design file.
    ///
    /// # Errors
    /// Says where the text is not a design, and why.
    pub fn from_json(text: &str) -> Result<Self, DesignError> {
        of_file(&json::parse(text)?).map(|(design, _, _)| design)
    }

    /// Reads the bytes of a design file.
    ///
    /// # Errors
    /// As [`Design::from_json`], and when the bytes are not UTF-8 text.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, DesignError> {
        Self::open_bytes(bytes).map(|(design, _, _)| design)
    }

    /// Reads a design from an object such as a design file holds. The object may have been edited since its version was written, so
    /// the version counts for nothing, other than in a file.
    ///
    /// # Errors
    /// As [`Design::from_json`].
    pub fn from_value(value: &Value) -> Result<Self, DesignError> {
        Self::open(value).map(|(design, _, _)| design)
    }

    /// A design that is being worked on: a design file as it stands, which need not make a cam.
    ///
    /// # Errors
    /// Where a field is missing, unknown or of another kind, or a list too long.
    pub fn draft(value: &Value) -> Result<Self, DesignError> {
        read(value, Version::LATEST)
    }

    /// Reads a design with its cam and the second cam of a conjugate pair, since checking the design makes them.
    pub(crate) fn open(value: &Value) -> Result<WithCams, DesignError> {
        read(value, Version::LATEST)?.with_cams()
    }

    /// Reads the bytes of a design file likewise.
    pub(crate) fn open_bytes(bytes: &[u8]) -> Result<WithCams, DesignError> {
        of_file(&json::parse_bytes(bytes)?)
    }

    /// The design in its canonical form, with its cams.
    pub(crate) fn with_cams(mut self) -> Result<WithCams, DesignError> {
        let (first, second) = self.cams()?;
        self.settle_rises();
        Ok((self, first, second))
    }

    /// The design in its canonical form.
    ///
    /// # Errors
    /// As [`Design::cam`].
    pub fn checked(self) -> Result<Self, DesignError> {
        self.with_cams().map(|(design, _, _)| design)
    }
}

/// A design with its cam and the second cam of a conjugate pair.
type WithCams = (Design, Cam, Option<Cam>);

/// A design from the object that a file holds, which has nothing that the version of the file does not know.
fn of_file(value: &Value) -> Result<WithCams, DesignError> {
    let version = version(&Object::any(value, Path::default())?)?;
    read(value, version)?.with_cams()
}

fn version(file: &Object) -> Result<Version, DesignError> {
    match file.word("format", &Version::ALL.map(Version::format)) {
        Ok(version) => Ok(Version::ALL[version]),
        Err(DesignError { path, problem: Problem::WrongWord { found, .. } }) if is_newer(&found) => {
            Err(DesignError::at(path, Problem::NewerFormat { found }))
        }
        Err(error) => Err(error),
    }
}

/// The fields of a design; the last of them has no place beside a ready-made motion.
const FIELDS: [&str; 10] =
    ["format", "title", "length_unit", "speed", "cam", "follower", "conjugate", "application", "notation", "segments"];

/// A design with what is known in a version.
fn read(value: &Value, known: Version) -> Result<Design, DesignError> {
    let file = Object::any(value, Path::default())?;
    version(&file)?;
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
    let (follower, values) = read_follower(&file.object("follower")?, known)?;
    let mut design = Design {
        title: file.optional("title").map_or(Ok(String::new()), |title| title.text())?,
        length_unit,
        speed: read_speed(&file, kind, length_unit)?,
        kind,
        rotation,
        base_radius: if kind.travel().is_some() { 0.0 } else { cam.required("base_radius")?.number()? },
        follower,
        values,
        segments: if ready { Vec::new() } else { read_segments(&file, known)? },
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

fn read_follower(
    follower: &Object,
    known: Version,
) -> Result<(&'static FollowerKind, [f64; MAX_FOLLOWER_PARAMETERS]), DesignError> {
    let followers = || FOLLOWERS.iter().copied().filter(|kind| of_follower(kind) <= known);
    let mut motions: Vec<&'static str> = followers().map(|kind| motion_and_contact(kind).0).collect();
    motions.dedup();
    let motion = motions[follower.word("motion", &motions)?];
    let kinds: Vec<_> = followers().filter(|kind| motion_and_contact(kind).0 == motion).collect();
    let contacts: Vec<&'static str> = kinds.iter().map(|kind| motion_and_contact(kind).1).collect();
    let kind = kinds[follower.word("contact", &contacts)?];
    let values = follower.parameters(&["motion", "contact"], kind.parameters)?;
    Ok((kind, values))
}

fn read_segments(file: &Object, known: Version) -> Result<Vec<SegmentDesign>, DesignError> {
    let list = file.required("segments")?;
    let Value::Array(items) = list.value else { return Err(list.wrong_kind(Kind::List)) };
    if items.len() > MAX_SEGMENTS {
        let problem = Problem::Program(ProgramRefusal::TooManySegments { found: items.len(), limit: MAX_SEGMENTS });
        return Err(DesignError::at(list.path, problem));
    }
    let each = items.iter().enumerate().map(|(k, item)| read_segment(&Object::any(item, list.path.join(k))?, known));
    each.collect()
}

fn read_segment(segment: &Object, known: Version) -> Result<SegmentDesign, DesignError> {
    let laws: Vec<&'static Law> = LAWS.iter().copied().filter(|law| of_law(law) <= known).collect();
    let ids: Vec<&'static str> = laws.iter().map(|law| law.id).collect();
    let law = laws[segment.word("law", &ids)?];
    let shared: Vec<&'static str> = ["law", "beta", "rise"].into_iter().chain(data::keys(law)).collect();
    let parameters: [f64; MAX_LAW_PARAMETERS] = segment.parameters(&shared, law.parameters)?;
    let beta = segment.required("beta")?.number()?;
    let data = data::read(segment, law, known)?;
    let rise = match segment.optional("rise") {
        None if !data::asks_for_rise(law, &data) => 0.0,
        _ => segment.required("rise")?.number()?,
    };
    Ok(SegmentDesign { law, beta, rise, parameters, data })
}
