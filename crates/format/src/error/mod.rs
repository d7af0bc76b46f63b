//! What is wrong with a design, as facts; the words are made in `levalab-words`.

mod cam;
mod data;
mod edit;
mod program;

pub use cam::CamRefusal;
pub use data::DataRefusal;
pub use edit::EditRefusal;
pub use program::ProgramRefusal;

use crate::Measure;
use crate::path::{Path, quoted};
use levalab_core::{JoinProblem, Misfit};
use std::fmt;

/// Why a design cannot be opened: where, and what is wrong there.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignError {
    /// The place in the design file, such as `segments[2].beta`.
    pub path: Path,
    /// What is wrong there.
    pub problem: Problem,
}

/// The kinds of JSON value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `null`, or a number that is not finite where the design comes as an object.
    Null,
    /// `true` or `false`.
    Boolean,
    /// A number.
    Number,
    /// A text in quotes.
    Text,
    /// A list in brackets.
    List,
    /// An object in braces.
    Object,
}

/// In what way a text is not JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JsonFault {
    /// A sign that has no place there.
    Syntax,
    /// The text ends in the middle.
    End,
    /// A comma between the digits of a number.
    DecimalComma,
    /// One half of a surrogate pair, which is no character.
    Surrogate,
    /// Lists and objects in each other, deeper than those of any design.
    Depth,
}

/// What can be wrong with a design. Angles are in degrees and lengths in the unit of the design.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// The file is larger than any design.
    FileTooLarge {
        /// Its size, bytes; of a file that is not read to its end, what was read of it.
        bytes: usize,
        /// The most that is read.
        limit: usize,
    },
    /// The file is not UTF-8 text.
    NotText,
    /// The text is not JSON.
    NotJson {
        /// Line where it stops being so, from 1.
        line: usize,
        /// Column, from 1, in characters.
        column: usize,
        /// In what way.
        fault: JsonFault,
    },
    /// A number too large to be held.
    NotFinite,
    /// A value of another kind.
    WrongKind {
        /// What there is.
        found: Kind,
        /// What there should be.
        expected: Kind,
    },
    /// A text that would be a number but for its decimal comma.
    DecimalComma {
        /// The text.
        found: String,
    },
    /// A field that is needed is not there.
    Missing,
    /// A field that has no meaning there.
    UnknownField {
        /// The fields that have.
        expected: Vec<&'static str>,
    },
    /// Two fields of which there may be one.
    OneOf {
        /// The fields.
        expected: Vec<&'static str>,
    },
    /// A field that is there twice.
    DuplicateField,
    /// A word that is none of the choices.
    WrongWord {
        /// The word.
        found: String,
        /// The choices.
        expected: Vec<&'static str>,
    },
    /// A design file of a version that is newer than this program.
    NewerFormat {
        /// What its first field says.
        found: String,
    },
    /// A number out of its range.
    OutOfRange {
        /// The number.
        found: f64,
        /// Least that is accepted.
        min: f64,
        /// Most that is accepted.
        max: f64,
        /// What it measures.
        measure: Measure,
    },
    /// A number that must lie between two others and be neither.
    NotBetween {
        /// The number.
        found: f64,
        /// It must be more than this.
        min: f64,
        /// It must be less than this.
        max: f64,
        /// What it measures.
        measure: Measure,
    },
    /// A size that is zero or negative.
    NotPositive {
        /// The size.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
    /// A title with too many characters.
    TitleTooLong {
        /// How many it has.
        found: usize,
        /// The most it may have.
        limit: usize,
    },
    /// A title with a character that cannot be seen.
    TitleCharacter {
        /// The character.
        found: char,
        /// Which one it is, from 1.
        position: usize,
    },
    /// A title of blanks and invisible characters alone.
    TitleInvisible,
    /// Segments that make no program.
    Program(ProgramRefusal),
    /// Data of a free law that make no curve.
    Data(DataRefusal),
    /// Requirements that cannot be joined.
    Join(JoinProblem),
    /// A follower that does not come together with its base circle.
    Misfit(Misfit),
    /// What a kind of cam does not have.
    Cam(CamRefusal),
    /// A change that is not possible.
    Edit(EditRefusal),
    /// A text that should be a path, an equals sign and a value.
    NoAssignment {
        /// The text.
        found: String,
    },
    /// A number that is no place in a list.
    NoIndex {
        /// The number.
        found: f64,
    },
}

impl From<ProgramRefusal> for Problem {
    fn from(refusal: ProgramRefusal) -> Self {
        Self::Program(refusal)
    }
}

impl From<EditRefusal> for Problem {
    fn from(refusal: EditRefusal) -> Self {
        Self::Edit(refusal)
    }
}

impl From<DataRefusal> for Problem {
    fn from(refusal: DataRefusal) -> Self {
        Self::Data(refusal)
    }
}

impl From<CamRefusal> for Problem {
    fn from(refusal: CamRefusal) -> Self {
        Self::Cam(refusal)
    }
}

impl DesignError {
    /// An error at a place.
    #[must_use]
    pub fn at(path: impl Into<Path>, problem: impl Into<Problem>) -> Self {
        Self { path: path.into(), problem: problem.into() }
    }
}

/// For logs and tests; people read `levalab-words`.
impl fmt::Display for DesignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.problem {
            Problem::WrongWord { found, expected } => {
                write!(f, "{}: {} is none of {expected:?}", self.path, quoted(found))
            }
            problem => write!(f, "{}: {problem:?}", self.path),
        }
    }
}

impl std::error::Error for DesignError {}
