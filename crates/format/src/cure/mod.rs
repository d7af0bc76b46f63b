//! What puts a finding right, in the units of the design and in numbers that a person would write.

mod edit;

pub(crate) use edit::with_law;
pub use edit::{Edit, apply};

use crate::Design;
use crate::digits::{DIGITS, round, short_within, shortest};
use crate::pair::measure_of;
use edit::edits;
use levalab_core::{Analysis, Cam, Column, Cure, Finding, Law, Tie, geometry_passes, prescribe, resized, working_ties};

/// A cure, told and ready to be applied.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignCure {
    /// What it does, in the units of the design.
    pub remedy: Remedy,
    /// How to do it.
    pub edits: Vec<Edit>,
}

/// What a cure does, in the units of the design.
#[derive(Clone, Debug, PartialEq)]
pub enum Remedy {
    /// Another base circle.
    BaseRadius {
        /// Its radius.
        value: f64,
        /// True when the cam has to grow, so that any larger circle is good as well; false when it has to shrink.
        grows: bool,
    },
    /// A longer travel of a cam that travels, all β's in proportion.
    Travel {
        /// Its length.
        value: f64,
    },
    /// Another distance or angle (degrees) between the elements of a conjugate pair.
    Tie {
        /// What is to change, with the value that it takes.
        tie: Tie,
        /// True when it has to grow.
        grows: bool,
    },
    /// Another eccentricity.
    Eccentricity {
        /// e.
        value: f64,
        /// The greatest |φ| that remains, degrees.
        pressure_angle: f64,
    },
    /// Other laws for some segments.
    Laws {
        /// Each segment and the law it takes.
        changes: Vec<(usize, &'static Law)>,
        /// The lowest of *s*, *v*, *a*, *j* that still jumps somewhere.
        remaining_jump: Option<Column>,
    },
}

/// The cures of each finding of an analysis, in the order of the findings, the best cure first: the numbers rounded to few
/// digits, and tried again with them.
#[must_use]
pub fn cures(design: &Design, cam: &Cam, analysis: &Analysis) -> Vec<Vec<DesignCure>> {
    if cam.follower.reversed.is_some() {
        return cures_of_second(design, cam, analysis);
    }
    let told = |cure: Cure| {
        let remedy = in_units(design, cam, cure);
        DesignCure { edits: edits(design, cam, &remedy), remedy }
    };
    prescribe(cam, analysis).into_iter().map(|cures| cures.into_iter().map(told).collect()).collect()
}

/// A second cam is cured by what ties it to the first: the nearest value with which its geometry passes. Its motion is cured
/// where it is made.
fn cures_of_second(design: &Design, cam: &Cam, analysis: &Analysis) -> Vec<Vec<DesignCure>> {
    let to_blame = !analysis.findings.iter().all(|finding| finding.kind.is_of_the_motion());
    let cure = to_blame.then(|| nearest_tie(design)).flatten().map(|remedy| {
        let edits = edits(design, cam, &remedy);
        DesignCure { remedy, edits }
    });
    let of = |finding: &Finding| cure.clone().filter(|_| !finding.kind.is_of_the_motion()).into_iter().collect();
    analysis.findings.iter().map(of).collect()
}

fn nearest_tie(design: &Design) -> Option<Remedy> {
    let (pair, first) = (design.conjugate?, design.cam().ok()?);
    let (least, most) = working_ties(&first, pair.core_tie(), pair.radius)?;
    let measure = measure_of(pair.tie);
    let (least, most, now) = (measure.told(least), measure.told(most), pair.tie.value());
    let grows = now < least;
    let value = short_within(if grows { least } else { most }, least, most)?;
    Some(Remedy::Tie { tie: pair.tie.with(value), grows })
}

fn in_units(design: &Design, cam: &Cam, cure: Cure) -> Remedy {
    match cure {
        Cure::BaseRadius(exact) => {
            let value = shortest_passing(cam, exact);
            Remedy::BaseRadius { value, grows: value > design.base_radius }
        }
        Cure::Travel(exact) => Remedy::Travel { value: shortest_passing(cam, exact) },
        Cure::Eccentricity { value, pressure_angle } => {
            let rounded = round(value, DIGITS, f64::round);
            let moved =
                cam.follower.kind.index_of("eccentricity").and_then(|i| cam.follower.with_value(i, rounded).ok());
            let remaining = moved.map_or(pressure_angle, |follower| {
                let analysis = Analysis::of(&cam.with_follower(follower), LOOK);
                analysis.summary.pressure_angle.greatest_size().0
            });
            Remedy::Eccentricity { value: rounded, pressure_angle: remaining.to_degrees() }
        }
        Cure::Laws { changes, remaining_jump } => {
            const ORDERS: [Column; 4] = [Column::S, Column::V, Column::A, Column::J];
            let remaining_jump = remaining_jump.and_then(|order| ORDERS.get(usize::from(order)).copied());
            Remedy::Laws { changes, remaining_jump }
        }
    }
}

/// Steps in which a rounded cure is looked at; the verdict is exact whatever they are.
const LOOK: usize = 1;

/// The base radius (or the travel) rounded up to the fewest digits, four or more, with which the geometry still passes.
pub(crate) fn shortest_passing(cam: &Cam, exact: f64) -> f64 {
    let passes = |&size: &f64| resized(cam, size).is_some_and(|sized| geometry_passes(&sized));
    shortest(exact, f64::ceil, passes).unwrap_or(exact)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{EXAMPLES, example};

    #[test]
    fn an_applied_cure_removes_its_finding() {
        let mut cured = 0;
        for (name, _) in EXAMPLES {
            let mut design = example(name).expect(name);
            for shrink in [1.0, 0.5] {
                design.base_radius *= shrink;
                let Ok(cam) = design.cam() else { continue };
                let analysis = Analysis::of(&cam, 1);
                for (finding, cures) in analysis.findings.iter().zip(cures(&design, &cam, &analysis)) {
                    for cure in cures {
                        let after = apply(&design, &cure.edits).expect("a cure gives a design");
                        let found = Analysis::of(&after.cam().expect("cam"), 1).findings;
                        let gone = found.iter().all(|other| other.kind != finding.kind);
                        let eased = matches!(cure.remedy, Remedy::Eccentricity { .. });
                        assert!(gone || eased, "{name} {:?} {:?}: {found:?}", finding.kind, cure.remedy);
                        cured += 1;
                    }
                }
            }
        }
        assert!(cured > 10, "{cured}");
    }
}
