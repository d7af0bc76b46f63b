//! What the core refuses, told in the terms of the design: its place there, degrees for radians, and the digits that were typed.

use super::out_of_range;
use crate::data::{KNOTS, data_key};
use crate::limits::{BETA, MAX_SEGMENTS, RISE};
use crate::report::tidy;
use crate::{CamRefusal, DataRefusal, Design, DesignError, Measure, Path, Problem, ProgramRefusal, SegmentDesign};
use levalab_core::law::DataProblem;
use levalab_core::{GeometryError, GeometryProblem, Misfit, ProgramError, ProgramProblem, Quantity, Roughness};

impl Design {
    pub(super) fn program_error(&self, ProgramError { segment, problem }: ProgramError) -> DesignError {
        let all = || Path::from("segments");
        let here = all().join(segment);
        let (stride, lift) = (self.stride(), self.lift());
        let (path, refusal) = match problem {
            ProgramProblem::Count { found: 0 } => (all(), ProgramRefusal::NoSegments),
            ProgramProblem::Count { found } => (all(), ProgramRefusal::TooManySegments { found, limit: MAX_SEGMENTS }),
            ProgramProblem::DwellRises { found } => {
                (here.join("rise"), ProgramRefusal::DwellRises { found: lift.told(found), measure: lift })
            }
            ProgramProblem::AdjacentPolynomials { next } => {
                (here.join("law"), ProgramRefusal::AdjacentPolynomials { next })
            }
            ProgramProblem::Turn { found } => {
                (all(), ProgramRefusal::Turn { found: stride.told(found), whole: self.kind.whole(), measure: stride })
            }
            ProgramProblem::Closing { found } => {
                (all(), ProgramRefusal::Closing { found: lift.told(found), measure: lift })
            }
            ProgramProblem::Beginning { found } => {
                (self.place_of_rise(segment), ProgramRefusal::Beginning { found: lift.told(found), measure: lift })
            }
            ProgramProblem::BelowBase { found } => {
                (self.place_of_rise(segment), ProgramRefusal::BelowBase { found: lift.told(found), measure: lift })
            }
            ProgramProblem::Beta { found } => {
                return DesignError::at(here.join("beta"), out_of_range(stride.told(found), &BETA, stride));
            }
            ProgramProblem::Rise { found } => {
                return DesignError::at(here.join("rise"), out_of_range(lift.told(found), &RISE, lift));
            }
            ProgramProblem::Data(problem) => return self.data_error(segment, problem),
            ProgramProblem::Parameter { key, found, min, max } => {
                return self.parameter_error(segment, key, [found, min, max]);
            }
        };
        DesignError::at(path, Problem::Program(refusal))
    }

    /// A parameter of a law out of its range.
    fn parameter_error(&self, segment: usize, key: &'static str, [found, min, max]: [f64; 3]) -> DesignError {
        let path = Path::from("segments").join(segment).join(key);
        let Some(SegmentDesign { law, beta, .. }) = self.segments.get(segment) else {
            return DesignError::at(path, Problem::Missing);
        };
        let Some(parameter) = law.parameters.iter().find(|parameter| parameter.key == key) else {
            return DesignError::at(path, Problem::Missing);
        };
        let span = parameter.quantity == Quantity::Span;
        let measure = if span { self.stride() } else { Measure::of(parameter) };
        // A part of β comes back without the digits that the division and the product made up.
        let told = |value: f64| if span { tidy(value * beta) } else { measure.told(value) };
        DesignError::at(path, Problem::OutOfRange { found: told(found), min: told(min), max: told(max), measure })
    }

    /// The data of a segment.
    pub(super) fn data_error(&self, segment: usize, problem: DataProblem) -> DesignError {
        let here = Path::from("segments").join(segment);
        let Some((segment, key)) = self.segments.get(segment).and_then(|s| Some((s, data_key(s.law)?))) else {
            return DesignError::at(here, Problem::Missing);
        };
        let (list, measure) = (here.join(key), self.stride());
        let along = |place: f64, beta: f64| tidy(place / beta * segment.beta);
        let knots = || here.join(KNOTS);
        let (path, refusal) = match problem {
            DataProblem::Count { found, min, max } => (list, DataRefusal::WrongCount { found, min, max }),
            DataProblem::Order { item, found } => {
                (list.join(item).join("order"), DataRefusal::WrongOrder { found: found.into() })
            }
            DataProblem::Repeated { item, other } => (list.join(item), DataRefusal::Repeated { other }),
            DataProblem::KnotCount { found, expected } => (knots(), DataRefusal::KnotCount { found, expected }),
            DataProblem::KnotOrder { knot } => (knots().join(knot), DataRefusal::KnotOrder),
            DataProblem::KnotPlace { item, from, to, beta } => {
                let (from, to) = (along(from, beta), along(to, beta));
                (knots(), DataRefusal::KnotPlace { item, from, to, measure })
            }
            DataProblem::NotAtEnd { item, found, expected, beta } => {
                let (found, expected) = (along(found, beta), along(expected, beta));
                (list.join(item).join(0), DataRefusal::NotAtEnd { found, expected, measure })
            }
            DataProblem::Unordered { item } => (list.join(item).join(0), DataRefusal::Unordered),
            DataProblem::Expression(problem) => (list, DataRefusal::Expression(problem)),
            DataProblem::Rough(Roughness { x, cause }) => (list, DataRefusal::Undefined { x: tidy(x), cause }),
            DataProblem::NoHeight => (list, DataRefusal::NoHeight),
            DataProblem::Dependent { items } => (list, DataRefusal::Dependent { items }),
            DataProblem::Kind => return DesignError::at(list, Problem::Missing),
            DataProblem::NotFinite { item } => return DesignError::at(list.join(item), Problem::NotFinite),
            DataProblem::Outside { item, found, beta } => {
                let found = along(found, beta);
                let problem = Problem::OutOfRange { found, min: 0.0, max: segment.beta, measure };
                return DesignError::at(list.join(item).join("at"), problem);
            }
            DataProblem::Parameter { parameter, min, max } => {
                let (found, parameter) = (segment.parameters[parameter], &segment.law.parameters[parameter]);
                let problem = Problem::OutOfRange { found, min, max, measure: Measure::of(parameter) };
                return DesignError::at(here.join(parameter.key), problem);
            }
        };
        DesignError::at(path, refusal)
    }

    /// The follower on its base circle.
    pub(super) fn geometry_error(&self, GeometryError { key, problem }: GeometryError) -> DesignError {
        let path = if key == "base_radius" { Path::from(["cam", key]) } else { Path::from(["follower", key]) };
        let parameter = self.follower.parameters.iter().find(|parameter| parameter.key == key);
        DesignError::at(path, self.geometry_problem(problem, parameter.map_or(Measure::Length, Measure::of)))
    }

    /// What is wrong with a magnitude; eccentricities have the sign of the notation.
    pub(crate) fn geometry_problem(&self, problem: GeometryProblem, measure: Measure) -> Problem {
        match problem {
            GeometryProblem::NotFinite => Problem::NotFinite,
            GeometryProblem::Unsuited => Problem::Cam(CamRefusal::Unsuited { kind: self.kind.word() }),
            GeometryProblem::NotPositive { found } => Problem::NotPositive { found: measure.told(found), measure },
            GeometryProblem::Outside { found, min, max } => {
                let (found, min, max) = (measure.told(found), measure.told(min), measure.told(max));
                Problem::NotBetween { found, min, max, measure }
            }
            GeometryProblem::Misfit(Misfit::Eccentricity { eccentricity, prime_radius }) => {
                let eccentricity = eccentricity * self.eccentricity_sign() + 0.0;
                Problem::Misfit(Misfit::Eccentricity { eccentricity, prime_radius })
            }
            GeometryProblem::Misfit(misfit) => Problem::Misfit(misfit),
        }
    }
}
