//! The second cam of a conjugate pair: what a design says of it.

use crate::digits::short_within;
use crate::limits::{ANGLE, SIZE};
use crate::report::Report;
use crate::{CamRefusal, Design, DesignError, Measure, Path, Problem};
use levalab_core::{
    Analysis, Cam, GeometryError, GeometryProblem, Motion, Tie, balanced_tie, conjugate, nearest_tie, working_ties,
};

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
    #[must_use]
    pub fn radius_key(design: &Design) -> Option<&'static str> {
        ["roller_radius", "face_radius"].into_iter().find(|key| design.follower.index_of(key).is_some())
    }

    /// The ties that a design's follower may have.
    #[must_use]
    pub fn tie_keys(design: &Design) -> &'static [&'static str] {
        match design.follower.motion {
            Motion::Translating => &["distance"],
            Motion::Oscillating => &["angle", "base_radius"],
        }
    }

    /// The tie in the units of the core.
    #[must_use]
    pub fn core_tie(&self) -> Tie {
        self.tie.with(measure_of(self.tie).to_core(self.tie.value()))
    }
}

/// What the value of a tie measures.
pub(crate) fn measure_of(tie: Tie) -> Measure {
    match tie {
        Tie::Angle(_) => Measure::Degrees,
        Tie::Distance(_) | Tie::BaseRadius(_) => Measure::Length,
    }
}

/// Where a second cam has its place: the ties of one kind with which its geometry passes, and a good one among them. Angles in
/// degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// The tie to start with: the one that makes both base circles alike when it passes, in few digits.
    pub tie: Tie,
    /// Least that passes.
    pub least: f64,
    /// Greatest that passes; infinite for a distance.
    pub most: f64,
}

impl Design {
    /// The room that there is for a second cam tied in that way, whatever pair the design has now; none when there is no room.
    /// `radius` is that of the second disc; that of the first when none is given.
    ///
    /// # Errors
    /// When the first cam cannot be.
    pub fn room_for_second(&self, kind: Tie, radius: Option<f64>) -> Result<Option<Room>, DesignError> {
        let alone = Self { conjugate: None, ..self.clone() };
        let cam = alone.cam()?;
        let measure = measure_of(kind);
        let room = working_ties(&cam, kind, radius).map(|(least, most)| (measure.told(least), measure.told(most)));
        Ok(room.and_then(|(least, most)| {
            let balanced = balanced_tie(&cam, kind).map_or(least, |tie| measure.told(tie.value()));
            let tie = kind.with(short_within(balanced.clamp(least, most), least, most)?);
            Some(Room { tie, least, most })
        }))
    }

    /// The nearest there is to a second cam tied in that way where none passes: the tie, in the unit of the design, and what is wrong
    /// with the cam. None when there is no room at all, or the first cam cannot be.
    #[must_use]
    pub fn nearest_second(&self, kind: Tie, radius: Option<f64>) -> Option<(Tie, Report)> {
        let alone = Self { conjugate: None, ..self.clone() };
        let first = alone.cam().ok()?;
        let tie = nearest_tie(&first, kind, radius)?;
        let second = conjugate(&first, tie, radius).ok()?;
        let report = Report::of(&alone, &second, &Analysis::of(&second, 1));
        Some((tie.with(measure_of(tie).told(tie.value())), report))
    }

    /// The second cam, when the design has one; `first` is its own cam.
    ///
    /// # Errors
    /// Says where the pair cannot be, and why.
    pub fn second(&self, first: &Cam) -> Result<Option<Cam>, DesignError> {
        let Some(pair) = self.conjugate else { return Ok(None) };
        let at = |key: &'static str| Path::from(["conjugate", key]);
        if self.kind.travel().is_some() || first.closure == levalab_core::Closure::Groove {
            return Err(DesignError::at("conjugate", CamRefusal::Unsuited { kind: self.kind.word() }));
        }
        if !Conjugate::tie_keys(self).contains(&pair.tie.key()) {
            return Err(DesignError::at(
                at(pair.tie.key()),
                Problem::UnknownField { expected: Conjugate::tie_keys(self).to_vec() },
            ));
        }
        let measure = measure_of(pair.tie);
        let range = if measure == Measure::Degrees { ANGLE } else { SIZE };
        crate::check::check_range(at(pair.tie.key()), pair.tie.value(), &range, measure)?;
        if let Some(radius) = pair.radius {
            let Some(key) = Conjugate::radius_key(self) else {
                let expected = Conjugate::tie_keys(self).to_vec();
                return Err(DesignError::at(at("roller_radius"), Problem::UnknownField { expected }));
            };
            crate::check::check_range(at(key), radius, &SIZE, Measure::Length)?;
        }
        let refused = |GeometryError { key, problem }| {
            let problem = match problem {
                GeometryProblem::Outside { found, min, max } if max.is_infinite() => {
                    Problem::Cam(CamRefusal::TooClose { found, least: min })
                }
                other => self.geometry_problem(other, if key == pair.tie.key() { measure } else { Measure::Length }),
            };
            DesignError::at(at(key), problem)
        };
        conjugate(first, pair.core_tie(), pair.radius).map(Some).map_err(refused)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_core::geometry_passes;
    use serde_json::json;

    fn roller(base_radius: f64, conjugate: &serde_json::Value) -> serde_json::Value {
        let segments: Vec<_> = (0..10)
            .map(|k| json!({ "law": "polynomial-4-5-6-7", "beta": 36, "rise": if k % 2 == 0 { 20 } else { -20 } }))
            .collect();
        json!({
            "format": "levalab/1", "cam": { "kind": "rotating", "base_radius": base_radius },
            "follower": { "motion": "translating", "contact": "roller", "roller_radius": 10 },
            "conjugate": conjugate, "segments": segments,
        })
    }

    #[test]
    fn the_classic_pair_is_what_the_room_proposes() {
        let design = Design::from_value(&roller(170.0, &json!({ "distance": 380 }))).expect("7CRT");
        let room = design.room_for_second(Tie::Distance(0.0), None).expect("a good cam").expect("room");
        assert_eq!((room.tie, room.most), (Tie::Distance(380.0), f64::INFINITY));
        let mut closer = design.clone();
        for (distance, passes) in [(room.least * 1.001, true), (room.least * 0.98, false)] {
            closer.conjugate = Some(Conjugate { tie: Tie::Distance(distance), radius: None });
            let first = closer.cam().expect("the first");
            let second = closer.second(&first).expect("a pair").expect("a second");
            assert_eq!(geometry_passes(&second), passes, "{distance}");
        }
    }

    #[test]
    fn a_tie_of_the_other_motion_has_no_room() {
        let design = Design::from_value(&roller(170.0, &json!({ "distance": 380 }))).expect("7CRT");
        assert_eq!(design.room_for_second(Tie::Angle(0.0), None).expect("a good cam"), None);
    }
}
