//! Edits: every change that the page, a cure, a conversion or the command makes to a design, as data and as a pure function.

mod application;
mod data;
mod follower;
mod json;
mod kind;
mod law;
mod pair;
mod program;
mod unit;

pub(crate) use law::with_law;
use program::dwell;

use crate::application::TargetsBy;
use crate::data::asks_for_rise;
use crate::{
    Design, DesignError, EditRefusal, Kind, LengthUnit, Path, PathPart, Problem, ProgramRefusal, SpeedUnit, data_key,
};
use levalab_core::application::Application;
use levalab_core::{FollowerKind, Law};
use serde_json::Value;

/// A change of a design.
///
/// In JSON an edit is `{ "path": […], "value": … }`, or `{ "op": "…", … }` where the change is one of structure; `docs/edits.md`
/// lists them. Segments are counted from 0, as in the paths of a design file.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Gives the field at a path another value; a field that the design leaves out is added.
    Set {
        /// Where it is in the design file.
        path: Path,
        /// What it becomes.
        value: Value,
    },
    /// Takes away the field at a path.
    Clear {
        /// Where it is in the design file.
        path: Path,
    },
    /// A dwell before segment `at`; it takes what is left of the cycle, or else half of segment `from`.
    Insert {
        /// The place that the dwell takes.
        at: usize,
        /// The segment that gives half of its β when nothing is left.
        from: usize,
    },
    /// The same segment once more, after itself.
    Duplicate {
        /// Which.
        segment: usize,
    },
    /// Takes segments away.
    Delete {
        /// Which.
        segments: Vec<usize>,
    },
    /// Takes a segment from one place to another.
    Move {
        /// Its place.
        from: usize,
        /// The place that it takes.
        to: usize,
    },
    /// Another law for a segment, which keeps its β and its rise; one that had no rise gets the rise that closes the program.
    Law {
        /// Which segment.
        segment: usize,
        /// Its new law.
        law: &'static Law,
    },
    /// Another β for a segment; what lies within it keeps its place in proportion.
    Beta {
        /// Which segment.
        segment: usize,
        /// Its new β.
        value: f64,
    },
    /// Makes the β's add up to the cycle, or the heights come back.
    Complete(Completion),
    /// Multiplies every height of the program.
    Scale {
        /// By how much.
        factor: f64,
    },
    /// A condition of a segment: its value where there is one already, and else a new one.
    Condition {
        /// Which segment.
        segment: usize,
        /// The place, from the start of the segment.
        at: f64,
        /// 0 for *s* to 3 for *j*.
        order: u8,
        /// The value there.
        value: f64,
    },
    /// A condition of *s* in the middle of the widest gap between two places, at the height that the curve has there.
    AddCondition {
        /// Which segment.
        segment: usize,
    },
    /// Takes all conditions at a place to another.
    MoveConditions {
        /// Which segment.
        segment: usize,
        /// Their place.
        from: f64,
        /// The place that they take.
        to: f64,
    },
    /// Takes away the conditions at a place, or the one of one order.
    DropConditions {
        /// Which segment.
        segment: usize,
        /// Their place.
        at: f64,
        /// Which of them; all when not given.
        order: Option<u8>,
    },
    /// Another formula for a segment; one that begins to name `L` gets the rise that the segment has.
    Formula {
        /// Which segment.
        segment: usize,
        /// The formula.
        text: String,
    },
    /// Another follower: what can be kept is kept, the rest gets proportions that work.
    Follower {
        /// Which.
        kind: &'static FollowerKind,
    },
    /// Another kind of cam: what can be kept is kept, the rest gets magnitudes that work.
    Kind {
        /// The word for the kind.
        kind: &'static str,
        /// The design when it was of that kind the last time, for the way back.
        back: Option<Box<Left>>,
    },
    /// The motion of a cam of constant breadth made another way.
    Generator {
        /// The word for the generator.
        generator: &'static str,
        /// Sides of a polygon of arcs; those that it has, or three, when not given.
        sides: Option<u32>,
    },
    /// A second cam; without a value, the same one where there is one already, and else one that works.
    Pair {
        /// What ties it: `distance`, `angle` or `base_radius`.
        tie: &'static str,
        /// The value of the tie.
        value: Option<f64>,
    },
    /// What the follower drives: its parameters keep their values or get usual ones. Nothing when not given.
    Application {
        /// Which.
        kind: Option<&'static Application>,
    },
    /// The places of the targets by the other measure; they stay the same points.
    TargetsBy {
        /// By which.
        by: TargetsBy,
    },
    /// The same cam in another unit.
    Convert {
        /// Which.
        unit: Unit,
    },
    /// The same numbers in another unit: another cam.
    Relabel {
        /// Which.
        unit: Unit,
    },
    /// A new design in the units of the present one: a radial roller on a dwell.
    New,
}

/// A design of a kind of cam that was left for another.
#[derive(Clone, Debug, PartialEq)]
pub struct Left {
    /// The design as it was.
    pub before: Design,
    /// What the other kind made of it.
    pub after: Design,
}

/// A way to complete the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Completion {
    /// A dwell takes what is left.
    Dwell,
    /// A move back to the starting height takes what is left, by the law used last.
    Return,
    /// The last segment takes what is left, or gives back what is beyond the cycle.
    Stretch,
    /// Every β in proportion.
    Spread,
    /// The last move ends at the starting height.
    Close,
}

/// A unit of length or of the speed of a cam that turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Of every length.
    Length(LengthUnit),
    /// Of the speed.
    Speed(SpeedUnit),
}

/// The design with some edits made, one after the other.
///
/// An edit is refused when it is not possible: there is no such place, the value is of another kind, nothing is left to fill, or
/// what comes out would be no design file. Whether the design makes a cam is not asked here, because one that is being worked
/// on need not: [`Design::cam`] judges it afterwards, and [`Design::edited`] does both.
///
/// # Errors
/// When an edit is not possible, with its place and the reason; the design stays as it was.
pub fn apply(design: &Design, edits: &[Edit]) -> Result<Design, DesignError> {
    edits.iter().try_fold(Draft::Design(design.clone()), Draft::after)?.design()
}

/// [`apply`] for the object that a design file holds, whether or not the design makes a cam.
///
/// # Errors
/// As [`apply`], and when the object is no design file.
pub fn apply_to_value(value: Value, edits: &[Edit]) -> Result<Design, DesignError> {
    edits.iter().try_fold(Draft::File(value), Draft::after)?.design()
}

impl Design {
    /// The design with some edits made, when it makes a cam.
    ///
    /// # Errors
    /// As [`apply`], and when what comes out makes no cam.
    pub fn edited(&self, edits: &[Edit]) -> Result<Self, DesignError> {
        apply(self, edits)?.checked()
    }
}

impl Edit {
    /// Another value for the field at a path.
    #[must_use]
    pub fn set(path: impl Into<Path>, value: impl Into<Value>) -> Self {
        Self::Set { path: path.into(), value: value.into() }
    }

    /// The edits of a text in JSON: one edit, or a list of them.
    ///
    /// # Errors
    /// Says where the text is no edit, and why.
    pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Self>, DesignError> {
        Self::list(&crate::json::parse_bytes(bytes)?)
    }

    /// The change of a design that need not make a cam.
    fn on(&self, design: &mut Design) -> Result<(), DesignError> {
        match *self {
            // Changes of the file.
            Self::Set { .. } | Self::Clear { .. } => Ok(()),
            Self::Insert { at, from } => program::insert(design, at, from),
            Self::Duplicate { segment } => program::duplicate(design, segment),
            Self::Delete { ref segments } => program::delete(design, segments),
            Self::Move { from, to } => program::shift(design, from, to),
            Self::Law { segment, law } => law::change(design, segment, law),
            Self::Beta { segment, value } => program::set_beta(design, segment, value),
            Self::Complete(completion) => program::complete(design, completion),
            Self::Scale { factor } => program::scale(design, factor),
            Self::Condition { segment, at, order, value } => data::put(design, segment, at, order, value),
            Self::AddCondition { segment } => data::add(design, segment),
            Self::MoveConditions { segment, from, to } => data::shift(design, segment, from, to),
            Self::DropConditions { segment, at, order } => data::remove(design, segment, at, order),
            Self::Formula { segment, ref text } => data::formula(design, segment, text),
            Self::Follower { kind } => follower::change(design, kind),
            Self::Kind { kind, back: None } => kind::change(design, kind),
            Self::Kind { kind, back: Some(ref left) } => kind::change_back(design, kind, left),
            Self::Generator { generator, sides } => kind::change_generator(design, generator, sides),
            Self::Pair { tie, value } => pair::change(design, tie, value),
            Self::Application { kind } => application::change(design, kind),
            Self::TargetsBy { by } => application::measure_by(design, by),
            Self::Convert { unit } => unit::convert(design, unit),
            Self::Relabel { unit } => unit::relabel(design, unit),
            Self::New => unit::begin(design),
        }
    }
}

/// A design between two edits, in the form that the last one left it in.
enum Draft {
    Design(Design),
    File(Value),
}

impl Draft {
    fn after(self, edit: &Edit) -> Result<Self, DesignError> {
        match edit {
            Edit::Set { path, value } => {
                let field = match path.0.as_slice() {
                    [PathPart::Key(segments), PathPart::Index(k), PathPart::Key(field)] if segments == "segments" => {
                        Some((*k, field.as_str()))
                    }
                    _ => None,
                };
                if let (Some((segment, "expression")), Value::String(text)) = (field, value) {
                    // The rise may come or go with it.
                    return self.after(&Edit::Formula { segment, text: text.clone() });
                }
                let mut file = self.file();
                set(&mut file, path, value.clone())?;
                if let Some((k, "rise" | "law")) = field
                    && value.as_f64() != Some(0.0)
                {
                    // A rise that the segment does not have would be lost in silence.
                    let design = Design::draft(&file)?;
                    has_rise(&design, k)?;
                    return Ok(Self::Design(design));
                }
                Ok(Self::File(file))
            }
            Edit::Clear { path } => {
                let mut file = self.file();
                clear(&mut file, path)?;
                Ok(Self::File(file))
            }
            edit => {
                let mut design = self.design()?;
                edit.on(&mut design)?;
                Ok(Self::Design(settled(&design)?))
            }
        }
    }

    fn file(self) -> Value {
        match self {
            Self::Design(design) => design.to_value(),
            Self::File(file) => file,
        }
    }

    fn design(self) -> Result<Design, DesignError> {
        match self {
            Self::Design(design) => Ok(design),
            Self::File(file) => Design::draft(&file),
        }
    }
}

/// The design as a file gives it back; an edit that leads beyond what numbers hold, or what lists hold, is refused.
fn settled(design: &Design) -> Result<Design, DesignError> {
    let file = design.to_value();
    if let Some(path) = place_of_null(&file, &Path::default()) {
        return Err(DesignError::at(path, Problem::NotFinite));
    }
    Design::draft(&file)
}

/// Where a file holds nothing: what a number that is not finite is written as.
fn place_of_null(value: &Value, here: &Path) -> Option<Path> {
    match value {
        Value::Null => Some(here.clone()),
        Value::Array(items) => items.iter().enumerate().find_map(|(k, item)| place_of_null(item, &here.join(k))),
        Value::Object(fields) => fields.iter().find_map(|(key, field)| place_of_null(field, &here.join(key.as_str()))),
        _ => None,
    }
}

/// Refuses a rise for a segment that stays, or whose data say where it ends.
fn has_rise(design: &Design, k: usize) -> Result<(), DesignError> {
    let Some(segment) = design.segments.get(k) else { return Ok(()) };
    if segment.rise == 0.0 || asks_for_rise(segment.law, &segment.data) {
        return Ok(());
    }
    let here = Path::from("segments").join(k).join("rise");
    let problem = match data_key(segment.law) {
        None => ProgramRefusal::DwellRises { found: segment.rise, measure: design.lift() }.into(),
        Some(key) => Problem::UnknownField { expected: vec!["law", "beta", key] },
    };
    Err(DesignError::at(here, problem))
}

/// Puts a value at a path; what leads there must be there.
fn set(file: &mut Value, path: &Path, value: Value) -> Result<(), DesignError> {
    let Some((last, before)) = path.0.split_last() else {
        *file = value;
        return Ok(());
    };
    let parent = place(file, before)?;
    match (parent, last) {
        (Value::Object(fields), PathPart::Key(key)) => {
            fields.insert(key.clone(), value);
            Ok(())
        }
        (Value::Array(items), PathPart::Index(index)) => {
            let count = items.len();
            match items.get_mut(*index) {
                Some(item) => {
                    *item = value;
                    Ok(())
                }
                None => Err(no_item(path, *index, count)),
            }
        }
        (parent, last) => Err(wrong_kind(&Path(before.to_vec()), parent, last)),
    }
}

/// Takes away the field or the item at a path.
fn clear(file: &mut Value, path: &Path) -> Result<(), DesignError> {
    let missing = || DesignError::at(path.clone(), Problem::Missing);
    let Some((last, before)) = path.0.split_last() else { return Err(missing()) };
    let parent = place(file, before)?;
    match (parent, last) {
        (Value::Object(fields), PathPart::Key(key)) => fields.remove(key).map(drop).ok_or_else(missing),
        (Value::Array(items), PathPart::Index(index)) if *index < items.len() => {
            items.remove(*index);
            Ok(())
        }
        (Value::Array(items), PathPart::Index(index)) => Err(no_item(path, *index, items.len())),
        (parent, last) => Err(wrong_kind(&Path(before.to_vec()), parent, last)),
    }
}

/// The value that a path leads to.
fn place<'a>(file: &'a mut Value, path: &[PathPart]) -> Result<&'a mut Value, DesignError> {
    let mut here = file;
    for (k, part) in path.iter().enumerate() {
        let so_far = || Path(path[..=k].to_vec());
        here = match (here, part) {
            (Value::Object(fields), PathPart::Key(key)) => {
                fields.get_mut(key).ok_or_else(|| DesignError::at(so_far(), Problem::Missing))?
            }
            (Value::Array(items), PathPart::Index(index)) => {
                let count = items.len();
                items.get_mut(*index).ok_or_else(|| no_item(&so_far(), *index, count))?
            }
            (other, part) => return Err(wrong_kind(&Path(path[..k].to_vec()), other, part)),
        };
    }
    Ok(here)
}

fn no_item(path: &Path, found: usize, count: usize) -> DesignError {
    DesignError::at(path.clone(), EditRefusal::NoItem { found, count })
}

/// A path that goes on in something that has no such part.
fn wrong_kind(here: &Path, found: &Value, part: &PathPart) -> DesignError {
    let expected = if matches!(part, PathPart::Key(_)) { Kind::Object } else { Kind::List };
    DesignError::at(here.clone(), Problem::WrongKind { found: crate::fields::kind_of(found), expected })
}

/// Refuses an index of a segment that is not there.
fn has_segment(design: &Design, k: usize) -> Result<(), DesignError> {
    let count = design.segments.len();
    if k < count { Ok(()) } else { Err(no_item(&Path::from("segments").join(k), k, count)) }
}

/// An edit of the program that is refused.
fn refused<T>(refusal: EditRefusal) -> Result<T, DesignError> {
    Err(DesignError::at("segments", refusal))
}

#[cfg(test)]
mod tests;
