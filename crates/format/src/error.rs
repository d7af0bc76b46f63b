//! What is wrong with a design, as facts; the words are made in `levalab-words`.

use crate::path::{Path, quoted};
use levalab_core::{ExpressionProblem, JoinProblem, Misfit};
use std::fmt;

/// Why a design cannot be opened: where, and what is wrong there.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignError {
    /// The place in the design file, such as `segments[2].beta`.
    pub path: Path,
    /// What is wrong there.
    pub problem: Problem,
}

/// What a number measures, in the units of a design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// In the design's unit of length.
    Length,
    /// In degrees.
    Degrees,
    /// A pure number.
    Ratio,
    /// In the unit of the speed beside it.
    Speed,
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

/// What can be wrong with a design. Angles are in degrees and lengths in the unit of the design.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// The file is larger than any design.
    FileTooLarge {
        /// Its size, bytes.
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
        /// Column, from 1.
        column: usize,
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
    /// No segments at all.
    NoSegments,
    /// More segments than a program may have.
    TooManySegments {
        /// How many there are.
        found: usize,
        /// The most there may be.
        limit: usize,
    },
    /// A dwell with a rise.
    DwellRises {
        /// The rise.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
    /// Data of a free law that make no curve.
    Data(DataRefusal),
    /// Requirements that cannot be joined.
    Join(JoinProblem),
    /// Two polynomials side by side that would take their end conditions from each other.
    AdjacentPolynomials {
        /// Index of the other segment.
        next: usize,
    },
    /// The β's do not add up to the cycle.
    Turn {
        /// Their sum.
        found: f64,
        /// What they should add up to: 360° (180° for half a turn that is mirrored), or the length of a travel.
        whole: f64,
        /// What they measure.
        measure: Measure,
    },
    /// The rises do not lead back to the starting height.
    Closing {
        /// The height they lead to.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
    /// A segment ends below the base circle.
    BelowBase {
        /// The height it ends at.
        found: f64,
        /// What it measures.
        measure: Measure,
    },
    /// A follower that does not come together with its base circle.
    Misfit(Misfit),
    /// A follower, or a second cam, that this kind of cam has no place for.
    Unsuited {
        /// The word for the kind.
        kind: &'static str,
    },
    /// A follower off the centre of a cam that needs it in line.
    OffCentre {
        /// Its eccentricity, or the angle of its face.
        found: f64,
        /// What it measures.
        measure: Measure,
        /// The word for the kind.
        kind: &'static str,
    },
    /// A breadth that leaves no travel: dc ≤ 2Rb.
    Breadth {
        /// The breadth.
        found: f64,
        /// Rb.
        base_radius: f64,
    },
    /// Segments that do not rise by dc − 2Rb over half a turn.
    BreadthTravel {
        /// What they rise by.
        found: f64,
        /// dc − 2Rb.
        travel: f64,
        /// dc.
        breadth: f64,
        /// Rb.
        base_radius: f64,
    },
    /// A polygon whose sides are not an odd number.
    Sides {
        /// How many it has.
        found: f64,
        /// The most it may have.
        most: f64,
    },
    /// A base radius so small that the arcs about the corners would turn inside out.
    SharpArcs {
        /// Rb.
        found: f64,
        /// The least there may be, with sharp corners.
        least: f64,
        /// Half the breadth, which it must stay below.
        half: f64,
    },
    /// An application on a follower that swings: its displacement is an angle.
    SwingingApplication,
    /// A second cam that has no room at that distance.
    TooClose {
        /// The distance.
        found: f64,
        /// It must be more than this.
        least: f64,
    },
}

/// What can be wrong with the data of a free law. Angles are in degrees and lengths in the unit of the design.
#[derive(Clone, Debug, PartialEq)]
pub enum DataRefusal {
    /// An order of a derivative that is none of 0, 1, 2 and 3.
    WrongOrder {
        /// The order.
        found: f64,
    },
    /// Too few items in a list, or too many.
    WrongCount {
        /// How many there are.
        found: usize,
        /// The least there may be.
        min: usize,
        /// The most there may be.
        max: usize,
    },
    /// A condition on the same derivative at the same place as one before it.
    Repeated {
        /// Index of that one.
        other: usize,
    },
    /// No condition says a height.
    NoHeight,
    /// No single curve meets the conditions, since some depend on each other.
    Dependent {
        /// Indices of those that do.
        items: Vec<usize>,
    },
    /// Another number of knots than the conditions and the degree of a spline need.
    KnotCount {
        /// How many there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A knot that does not lie within the segment, after the one before it.
    KnotOrder,
    /// Knots that leave a condition outside the part of the curve that it would hold.
    KnotPlace {
        /// Index of the condition.
        item: usize,
        /// It should lie after this place.
        from: f64,
        /// And before this one.
        to: f64,
        /// What places are measured in.
        measure: Measure,
    },
    /// The first or the last point of a table is not where the segment begins or ends.
    NotAtEnd {
        /// Where it is.
        found: f64,
        /// Where it should be.
        expected: f64,
        /// What places are measured in.
        measure: Measure,
    },
    /// A point of a table that does not come after the one before it.
    Unordered,
    /// A text that is no expression.
    Expression(ExpressionProblem),
    /// An expression that has no value, or no derivative, near an x.
    Undefined {
        /// The x.
        x: f64,
    },
    /// A rise that is not what the data of the segment come to.
    RiseDisagrees {
        /// The rise.
        found: f64,
        /// What the data come to.
        expected: f64,
        /// What it measures.
        measure: Measure,
    },
}

impl From<DataRefusal> for Problem {
    fn from(refusal: DataRefusal) -> Self {
        Self::Data(refusal)
    }
}

impl DesignError {
    /// An error at a place.
    #[must_use]
    pub fn at(path: impl Into<Path>, problem: Problem) -> Self {
        Self { path: path.into(), problem }
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
