//! The smooth pieces that a law is made of.

use crate::{Curve, Form, Svaj};

/// One smooth stretch of a law, from the end of the piece before it up to x = `until`: y = curve((x − origin)/span).
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The x at which it ends.
    pub until: f64,
    /// Its curve.
    pub curve: Form,
    /// The x at which the variable of the curve is 0.
    pub origin: f64,
    /// How much of x a unit of the variable of the curve is.
    pub span: f64,
}

impl Piece {
    /// A piece from its end and its curve, in the x of the whole law.
    #[must_use]
    pub fn new(until: f64, curve: impl Into<Form>) -> Self {
        Self { until, curve: curve.into(), origin: 0.0, span: 1.0 }
    }

    /// A piece whose curve runs from 0 to 1 between its own ends, which keeps the digits of narrow ones.
    #[must_use]
    pub fn between(from: f64, until: f64, curve: impl Into<Form>) -> Self {
        Self { until, curve: curve.into(), origin: from, span: until - from }
    }

    /// y and its three derivatives with respect to the x of the whole law.
    #[must_use]
    pub fn at(&self, x: f64) -> Svaj {
        self.curve.at((x - self.origin) / self.span).stretched(self.span)
    }
}

/// A law with a single formula.
pub(super) fn single(curve: Curve) -> Vec<Piece> {
    vec![Piece::new(1.0, curve)]
}

/// A law in two halves: `first` up to x = ½, `second` after it.
pub(super) fn halves(first: Curve, second: Curve) -> Vec<Piece> {
    vec![Piece::new(0.5, first), Piece::new(1.0, second)]
}
