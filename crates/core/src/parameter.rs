//! A number that a law or a follower takes, described well enough to build a form from it.

/// What a parameter measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// In the design's length unit.
    Length,
    /// Radians inside, degrees at the edges.
    Angle,
    /// A pure number.
    Ratio,
    /// A part of β: a pure number inside, in the unit of β at the edges.
    Span,
    /// In the unit of *s*: a length, or radians (degrees at the edges) when the follower swings.
    Height,
}

/// A number that a law or a follower takes besides those that all of them share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its name in design files, such as `roller_radius`.
    pub key: &'static str,
    /// Its symbol in books, such as `Rf`.
    pub symbol: &'static str,
    /// What it measures.
    pub quantity: Quantity,
    /// The value when a design leaves it out; lengths without a natural value have none.
    pub default: Option<f64>,
    /// True when a design file may leave it out.
    pub optional: bool,
}
