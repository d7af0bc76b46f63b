//! What a free law is made from besides numbers: conditions to meet, and what can be wrong with them.

use super::{MAX_LAW_PARAMETERS, Piece};
use crate::Svaj;
use crate::expression::{ExpressionProblem, Roughness};

/// A value that *s* or one of its derivatives takes somewhere in a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Where, from the segment's start; radians inside, as β is.
    pub at: f64,
    /// 0 for *s* to 3 for *j*.
    pub order: u8,
    /// *s* above the base circle, or its derivative with respect to θ.
    pub value: f64,
}

/// The data of a segment whose law is free.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Data {
    /// None, as most laws need none.
    #[default]
    None,
    /// Conditions to meet, in any order.
    Conditions(Vec<Condition>),
    /// Conditions that a spline meets, and its inner knots, from the segment's start and in order.
    Spline {
        /// Conditions to meet, in any order.
        conditions: Vec<Condition>,
        /// Where its pieces join.
        knots: Vec<f64>,
    },
    /// Points to go through: where, from the segment's start, and *s* there.
    Points(Vec<[f64; 2]>),
    /// Ordinates of *s* at even steps.
    Ordinates(Vec<f64>),
    /// An expression of *s*.
    Expression(String),
}

/// The kinds of data that a law may be made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DataKind {
    /// [`Data::Conditions`].
    Conditions,
    /// [`Data::Conditions`], or [`Data::Spline`] when the knots are told.
    Spline,
    /// [`Data::Points`].
    Points,
    /// [`Data::Ordinates`].
    Ordinates,
    /// [`Data::Expression`].
    Expression,
}

/// What a free law is solved for.
#[derive(Clone, Copy, Debug)]
pub struct Given<'a> {
    /// The data, of the law's kind.
    pub data: &'a Data,
    /// β, radians.
    pub beta: f64,
    /// The height at which the segment before it ends.
    pub start: f64,
    /// L as it is told, for a law that asks for it.
    pub rise: f64,
    /// The law's own parameters.
    pub parameters: [f64; MAX_LAW_PARAMETERS],
    /// *v*, *a* and *j* with which the segment before it ends, where that does not depend on this one.
    pub before: Option<Svaj>,
    /// Those with which the segment after it begins.
    pub after: Option<Svaj>,
    /// True when the segment is the whole cycle, so that it joins itself.
    pub alone: bool,
}

impl Default for Given<'_> {
    fn default() -> Self {
        let parameters = [0.0; MAX_LAW_PARAMETERS];
        Self {
            data: &Data::None,
            beta: 1.0,
            start: 0.0,
            rise: 0.0,
            parameters,
            before: None,
            after: None,
            alone: false,
        }
    }
}

/// The curve of a free law, in the units of the design and not between 0 and 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// Its smooth pieces.
    pub pieces: Vec<Piece>,
    /// How many times larger an error of the data may come out: the condition number of the system that was solved.
    pub condition: f64,
}

/// What is wrong with the data of a segment, and which of its items.
#[derive(Clone, Debug, PartialEq)]
pub enum DataProblem {
    /// It is not of the law's kind.
    Kind,
    /// Too few items, or too many.
    Count {
        /// How many there are.
        found: usize,
        /// The least there may be.
        min: usize,
        /// The most there may be.
        max: usize,
    },
    /// A number that is not finite.
    NotFinite {
        /// The item.
        item: usize,
    },
    /// A derivative of another order than 0 to 3.
    Order {
        /// The item.
        item: usize,
        /// The order given.
        found: u8,
    },
    /// A place outside the segment.
    Outside {
        /// The item.
        item: usize,
        /// The place given.
        found: f64,
        /// β.
        beta: f64,
    },
    /// The same derivative at the same place twice.
    Repeated {
        /// The item.
        item: usize,
        /// The item that came before.
        other: usize,
    },
    /// A parameter of the law out of its range.
    Parameter {
        /// Index into the law's parameters.
        parameter: usize,
        /// Least value that would do.
        min: f64,
        /// Greatest value that would do.
        max: f64,
    },
    /// Not as many knots as the conditions and the degree need.
    KnotCount {
        /// How many there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A knot outside the segment, at one of its ends, or not after the one before it.
    KnotOrder {
        /// The knot.
        knot: usize,
    },
    /// Too few conditions on one side of a knot for the pieces there: Schoenberg and Whitney's condition.
    KnotPlace {
        /// The condition that lies outside its B-spline.
        item: usize,
        /// Where that B-spline begins, as a place along the segment.
        from: f64,
        /// Where it ends.
        to: f64,
        /// β.
        beta: f64,
    },
    /// The first or the last point is not where the segment begins or ends.
    NotAtEnd {
        /// The item.
        item: usize,
        /// The place given.
        found: f64,
        /// Where it should be.
        expected: f64,
        /// β.
        beta: f64,
    },
    /// A point that does not come after the one before it.
    Unordered {
        /// The item.
        item: usize,
    },
    /// A text that is no expression.
    Expression(ExpressionProblem),
    /// An expression that is not smooth near some x.
    Rough(Roughness),
    /// Not one of them says a height, so that any would do.
    NoHeight,
    /// No single curve meets them: these depend on each other.
    Dependent {
        /// The items that do.
        items: Vec<usize>,
    },
}

impl Data {
    /// The kind of data, when there is any.
    #[must_use]
    pub fn kind(&self) -> Option<DataKind> {
        match self {
            Self::None => None,
            Self::Conditions(_) => Some(DataKind::Conditions),
            Self::Spline { .. } => Some(DataKind::Spline),
            Self::Points(_) => Some(DataKind::Points),
            Self::Ordinates(_) => Some(DataKind::Ordinates),
            Self::Expression(_) => Some(DataKind::Expression),
        }
    }

    /// Its conditions, when it is made of them.
    #[must_use]
    pub fn conditions(&self) -> Option<&[Condition]> {
        match self {
            Self::Conditions(conditions) | Self::Spline { conditions, .. } => Some(conditions),
            _ => None,
        }
    }

    /// The same data with places and heights in other units. Derivatives stay with respect to the same θ.
    #[must_use]
    pub fn scaled(&self, along: f64, up: f64) -> Self {
        let condition = |c: &Condition| Condition { at: c.at * along, order: c.order, value: c.value * up };
        match self {
            Self::None => Self::None,
            Self::Conditions(conditions) => Self::Conditions(conditions.iter().map(condition).collect()),
            Self::Spline { conditions, knots } => Self::Spline {
                conditions: conditions.iter().map(condition).collect(),
                knots: knots.iter().map(|knot| knot * along).collect(),
            },
            Self::Points(points) => Self::Points(points.iter().map(|[at, s]| [at * along, s * up]).collect()),
            Self::Ordinates(ordinates) => Self::Ordinates(ordinates.iter().map(|s| s * up).collect()),
            Self::Expression(text) => Self::Expression(text.clone()),
        }
    }
}
