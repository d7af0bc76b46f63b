//! The second cam of a conjugate pair: what a design says of it.

use crate::limits::{ANGLE, SIZE};
use crate::{Design, DesignError, Measure, Path, Problem};
use levalab_core::{Cam, GeometryError, GeometryProblem, Motion, Tie, conjugate};

/// A second element fixed to the follower, on a second cam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conjugate {
    /// What ties it to the first; an angle in degrees.
    pub tie: Tie,
    /// Radius of the second roller (or curved face); that of the first when none is given.
    pub radius: Option<f64>,
}

impl Conjugate {
    /// The field that gives the radius of a follower's disc, for those that may have a second one of another size.
    pub(crate) fn radius_key(design: &Design) -> Option<&'static str> {
        ["roller_radius", "face_radius"].into_iter().find(|key| design.follower.index_of(key).is_some())
    }

    /// The ties that a design's follower may have.
    pub(crate) fn tie_keys(design: &Design) -> &'static [&'static str] {
        match design.follower.motion {
            Motion::Translating => &["distance"],
            Motion::Oscillating => &["angle", "base_radius"],
        }
    }

    /// The tie in the units of the core.
    #[must_use]
    pub fn core_tie(&self) -> Tie {
        match self.tie {
            Tie::Angle(degrees) => Tie::Angle(degrees.to_radians()),
            other => other,
        }
    }
}

impl Design {
    /// The second cam, when the design has one; `first` is its own cam.
    ///
    /// # Errors
    /// Says where the pair cannot be, and why.
    pub fn second(&self, first: &Cam) -> Result<Option<Cam>, DesignError> {
        let Some(pair) = self.conjugate else { return Ok(None) };
        let at = |key: &'static str| Path::from(["conjugate", key]);
        if self.kind.travel().is_some() || first.closure == levalab_core::Closure::Groove {
            return Err(DesignError::at("conjugate", Problem::Unsuited { kind: self.kind.word() }));
        }
        if !Conjugate::tie_keys(self).contains(&pair.tie.key()) {
            return Err(DesignError::at(
                at(pair.tie.key()),
                Problem::UnknownField { expected: Conjugate::tie_keys(self).to_vec() },
            ));
        }
        let (range, measure) = match pair.tie {
            Tie::Angle(_) => (ANGLE, Measure::Degrees),
            Tie::Distance(_) | Tie::BaseRadius(_) => (SIZE, Measure::Length),
        };
        crate::check::check_range(at(pair.tie.key()), pair.tie.value(), &range, measure)?;
        if let Some(radius) = pair.radius {
            let Some(key) = Conjugate::radius_key(self) else {
                let expected = Conjugate::tie_keys(self).to_vec();
                return Err(DesignError::at(at("roller_radius"), Problem::UnknownField { expected }));
            };
            crate::check::check_range(at(key), radius, &SIZE, Measure::Length)?;
        }
        let refused = |GeometryError { key, problem }| {
            let edge = |value: f64| if measure == Measure::Degrees { value.to_degrees() } else { value };
            let problem = match problem {
                GeometryProblem::Outside { found, min, max } if max.is_infinite() => {
                    Problem::TooClose { found: edge(found), least: edge(min) }
                }
                GeometryProblem::Outside { found, min, max } => {
                    Problem::NotBetween { found: edge(found), min: edge(min), max: edge(max), measure }
                }
                GeometryProblem::NotPositive { found } => Problem::NotPositive { found, measure: Measure::Length },
                _ => Problem::Unsuited { kind: self.kind.word() },
            };
            DesignError::at(at(key), problem)
        };
        conjugate(first, pair.core_tie(), pair.radius).map(Some).map_err(refused)
    }
}
