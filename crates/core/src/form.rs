//! The formula of a smooth stretch, in the form that suits where it came from.

use crate::expression::Formula;
use crate::{Curve, Series, Svaj};
use std::sync::Arc;

/// A smooth curve: a short polynomial with waves, as most laws are, a polynomial of any degree, or an expression. Cheap to copy.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A polynomial of low degree and sine waves.
    Curve(Curve),
    /// A polynomial as a Chebyshev series.
    Series(Arc<Series>),
    /// The user's own expression.
    Formula(Arc<Formula>),
}

impl Form {
    /// y and its three derivatives with respect to x.
    #[must_use]
    #[inline]
    pub fn at(&self, x: f64) -> Svaj {
        match self {
            Self::Curve(curve) => curve.at(x),
            Self::Series(series) => series.at(x),
            Self::Formula(formula) => formula.at(x),
        }
    }

    /// k·y(x) + c.
    #[must_use]
    pub fn scaled(self, k: f64, c: f64) -> Self {
        match self {
            Self::Curve(curve) => curve.scaled(k, c).into(),
            Self::Series(series) => Arc::unwrap_or_clone(series).scaled(k, c).into(),
            Self::Formula(formula) => Arc::unwrap_or_clone(formula).scaled(k, c).into(),
        }
    }

    /// Every x between 0 and 1, in order, at which it must be sampled besides its ends so that nothing is missed: none for the curves of
    /// laws, which have no narrow features.
    pub(crate) fn places(&self) -> &[f64] {
        match self {
            Self::Formula(formula) => formula.places(),
            Self::Curve(_) | Self::Series(_) => &[],
        }
    }

    /// True when it is a constant.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        matches!(self, Self::Curve(curve) if curve.coefficients().len() <= 1 && curve.waves().is_empty())
    }

    /// The coefficients of the powers of x, constant term first; none when the curve is more than a polynomial.
    #[must_use]
    pub fn coefficients(&self) -> Option<Vec<f64>> {
        match self {
            Self::Curve(curve) => curve.waves().is_empty().then(|| curve.coefficients().to_vec()),
            Self::Series(series) => Some(series.coefficients()),
            Self::Formula(_) => None,
        }
    }
}

impl From<Curve> for Form {
    fn from(curve: Curve) -> Self {
        Self::Curve(curve)
    }
}

impl From<Series> for Form {
    fn from(series: Series) -> Self {
        Self::Series(Arc::new(series))
    }
}

impl From<Formula> for Form {
    fn from(formula: Formula) -> Self {
        Self::Formula(Arc::new(formula))
    }
}
