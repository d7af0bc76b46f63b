//! What puts a finding right, in the units of the design and in numbers that a person would write.

mod changes;

pub(crate) use changes::by_law;

use crate::digits::{DIGITS, round, short_within, shortest};
use crate::pair::measure_of;
use crate::report::scale_of;
use crate::{Design, Edit, apply};
use changes::edits;
use levalab_core::{
    Analysis, Cam, Column, Cure, Finding, FindingKind, Instead, Law, Replay, Tie, believable_sizes, geometry_passes,
    prescribe_in_parts, resized, working_ties_in_parts,
};

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
        /// What rises with them.
        price: Price,
    },
    /// Another length of an oscillating follower.
    Length {
        /// The name of the parameter: `arm` or `pivot_distance`.
        key: &'static str,
        /// Its value.
        value: f64,
    },
    /// No remedy, but an advice: size alone does not put the finding right.
    NoSize {
        /// The base radius (or the travel) with which it would be right, when there is one: out of all proportion.
        needed: Option<f64>,
        /// What would put it right instead.
        instead: Instead,
    },
}

/// What a change of laws costs beyond the finding that it cures, in the units of the design; what does not rise is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Price {
    /// The greatest |φ| after the change and before it, degrees.
    pub pressure_angle: Option<(f64, f64)>,
    /// The peak of the acceleration after the change, as a multiple of that before it.
    pub acceleration: Option<f64>,
    /// The lift after the change and before it, where a polynomial rises above the heights at its borders.
    pub lift: Option<(f64, f64)>,
}

impl DesignCure {
    /// True of a change of laws that leaves no jump and costs no more than another, which leaves one.
    fn is_no_dearer_and_smoother(&self, other: &Self) -> bool {
        let (
            Remedy::Laws { remaining_jump: None, price, .. },
            Remedy::Laws { remaining_jump: Some(_), price: dearer, .. },
        ) = (&self.remedy, &other.remedy)
        else {
            return false;
        };
        let angle = |price: &Price| price.pressure_angle.map_or(0.0, |(after, _)| after);
        // Below the present peak no price is told, so nothing is known of which is lower.
        let peak = |price: &Price| price.acceleration;
        angle(price) <= angle(dearer) + ANGLE_PRICE
            && peak(price).zip(peak(dearer)).is_some_and(|(one, other)| one <= other + ACCELERATION_PRICE)
            && (price.lift.is_none() || price.lift == dearer.lift)
    }
}

/// A rise of |φ| by less than this many degrees is no price worth a word.
const ANGLE_PRICE: f64 = 0.1;

/// A peak of the acceleration that rises by less than this part is no price worth a word.
const ACCELERATION_PRICE: f64 = 0.02;

/// The lift may change by this part of itself, which is rounding.
const LIFT_TOLERANCE: f64 = 1e-9;

/// The search for the cures of one cam, which runs in parts: an edit of the design drops it.
#[derive(Clone, Debug, Default)]
pub struct CureJob {
    replay: Replay,
}

impl CureJob {
    /// Goes on with the search for the cures of an analysis. The budget is the number of looks at a cam that this part may take.
    /// Returns `None` while the search is not done. Every part must be given the same design, cam and analysis.
    pub fn step(
        &mut self,
        design: &Design,
        cam: &Cam,
        analysis: &Analysis,
        budget: usize,
    ) -> Option<Vec<Vec<DesignCure>>> {
        self.replay.run(budget, |replay| cures_in_parts(design, cam, analysis, replay))
    }
}

/// The cures of each finding of an analysis, in the order of the findings, the best cure first: the numbers rounded to few
/// digits, and tried again with them. An advice that size does not put the finding right comes last and has no edits.
#[must_use]
pub fn cures(design: &Design, cam: &Cam, analysis: &Analysis) -> Vec<Vec<DesignCure>> {
    Replay::whole(|replay| cures_in_parts(design, cam, analysis, replay))
}

fn cures_in_parts(design: &Design, cam: &Cam, analysis: &Analysis, replay: &Replay) -> Vec<Vec<DesignCure>> {
    let remedies = if cam.follower.reversed().is_some() {
        remedies_of_second(design, analysis, replay)
    } else {
        let exact = prescribe_in_parts(cam, analysis, replay);
        let mut known: Vec<(Cure, Remedy)> = Vec::new();
        exact
            .into_iter()
            .map(|cures| cures.into_iter().map(|cure| told(design, cam, cure, &mut known, replay)).collect())
            .collect()
    };
    let mut tried: Vec<(Remedy, Option<Tried>)> = Vec::new();
    let each = analysis.findings.iter().zip(remedies);
    let of = |(finding, remedies): (&Finding, Vec<Remedy>)| {
        let offer = |remedy: Remedy| offered(design, cam, analysis, finding, remedy, &mut tried, replay);
        let mut cures: Vec<DesignCure> = Vec::new();
        for cure in remedies.into_iter().filter_map(offer) {
            if !cures.iter().any(|better| better.is_no_dearer_and_smoother(&cure)) {
                cures.push(cure);
            }
        }
        cures
    };
    each.map(of).collect()
}

/// A cure in the units of the design; many findings share one.
fn told(design: &Design, cam: &Cam, cure: Cure, known: &mut Vec<(Cure, Remedy)>, replay: &Replay) -> Remedy {
    if let Some((_, remedy)) = known.iter().find(|(other, _)| *other == cure) {
        return remedy.clone();
    }
    let remedy = in_units(design, cam, cure.clone(), replay);
    known.push((cure, remedy.clone()));
    remedy
}

/// The design with a cure applied, as it is judged.
#[derive(Clone, Debug)]
struct Tried {
    /// The codes of the findings that it has, each as a bit by its place in [`CURED_KINDS`].
    left: u32,
    /// Its lift, in the units of the core.
    lift: f64,
    /// Its greatest |φ|, radians.
    pressure_angle: f64,
    /// The peak of its acceleration.
    acceleration: f64,
}

/// The kinds of findings that a cure can be for.
const CURED_KINDS: [FindingKind; 16] = [
    FindingKind::Jump(0),
    FindingKind::Jump(1),
    FindingKind::Jump(2),
    FindingKind::Jump(3),
    FindingKind::PressureAngle,
    FindingKind::Cusp,
    FindingKind::Undercut,
    FindingKind::GrooveUndercut,
    FindingKind::ConcaveFlat,
    FindingKind::Doubtful,
    FindingKind::BelowBase,
    FindingKind::SelfCrossing,
    FindingKind::ArmCutsCam,
    FindingKind::PivotInsideCam,
    FindingKind::FaceOvertaken,
    FindingKind::ContactPastPivot,
];

fn bit(kind: FindingKind) -> u32 {
    CURED_KINDS.iter().position(|&other| other == kind).map_or(0, |place| 1 << place)
}

/// A remedy as a cure, when the design with its edits is a cam of the same lift that does not have the finding any more (or, for an
/// eccentricity, has it less); with its price.
fn offered(
    design: &Design,
    cam: &Cam,
    analysis: &Analysis,
    finding: &Finding,
    remedy: Remedy,
    tried: &mut Vec<(Remedy, Option<Tried>)>,
    replay: &Replay,
) -> Option<DesignCure> {
    if matches!(remedy, Remedy::NoSize { .. }) {
        return (!design.segments.is_empty()).then_some(DesignCure { remedy, edits: Vec::new() });
    }
    let edits = edits(design, cam, &remedy);
    let found = match tried.iter().find(|(other, _)| *other == remedy) {
        Some((_, found)) => found.clone(),
        None => {
            let found = trial(design, &edits, cam.follower.reversed().is_some(), replay);
            tried.push((remedy.clone(), found.clone()));
            found
        }
    }?;
    let lift = analysis.summary.s.max;
    let same_lift = (found.lift - lift).abs() <= LIFT_TOLERANCE * lift.abs();
    // A change of laws has been held to the lift already. A second cam has a displacement of its own, which follows from its tie.
    let may_differ = cam.follower.reversed().is_some() || matches!(remedy, Remedy::Laws { .. });
    let gone = found.left & bit(finding.kind) == 0;
    let eased = matches!(remedy, Remedy::Eccentricity { .. });
    let remedy = match remedy {
        Remedy::Laws { changes, remaining_jump, .. } => {
            let scale = scale_of(design, Column::S);
            let lift = (!same_lift).then_some((found.lift * scale, lift * scale));
            Remedy::Laws { changes, remaining_jump, price: Price { lift, ..price(analysis, &found) } }
        }
        other => other,
    };
    ((same_lift || may_differ) && (gone || eased)).then_some(DesignCure { remedy, edits })
}

/// The design with some edits, judged as it opens; `None` when it does not.
fn trial(design: &Design, edits: &[Edit], second: bool, replay: &Replay) -> Option<Tried> {
    let [opens, left, lift, pressure_angle, acceleration] = replay.values(|| {
        let judged = || {
            let after = apply(design, edits).ok()?;
            let first = after.cam().ok()?;
            let other = after.second(&first).ok()?;
            let analysis = Analysis::of(if second { other.as_ref()? } else { &first }, LOOK);
            let left = analysis.findings.iter().fold(0, |left, finding| left | bit(finding.kind));
            let summary = &analysis.summary;
            let sizes = [summary.pressure_angle, summary.a].map(|extremes| extremes.greatest_size().0);
            Some([1.0, f64::from(left), summary.s.max, sizes[0], sizes[1]])
        };
        judged().unwrap_or([0.0; 5])
    });
    (opens == 1.0).then_some(Tried { left: left as u32, lift, pressure_angle, acceleration })
}

/// What rises by a change of laws. Where the velocity jumped, the acceleration was infinite, and no peak is higher.
fn price(before: &Analysis, after: &Tried) -> Price {
    let now = before.summary.pressure_angle.greatest_size().0.to_degrees();
    let then = after.pressure_angle.to_degrees();
    let infinite = before.joints.iter().any(|joint| joint.jump.is_some_and(|jump| jump < 2));
    let ratio = after.acceleration / before.summary.a.greatest_size().0;
    Price {
        pressure_angle: (then > now + ANGLE_PRICE).then_some((then, now)),
        acceleration: (!infinite && ratio.is_finite() && ratio > 1.0 + ACCELERATION_PRICE).then_some(ratio),
        lift: None,
    }
}

/// A second cam is cured by what ties it to the first: the nearest value with which its geometry passes. Its motion is cured
/// where it is made.
fn remedies_of_second(design: &Design, analysis: &Analysis, replay: &Replay) -> Vec<Vec<Remedy>> {
    let to_blame = !analysis.findings.iter().all(|finding| finding.kind.is_of_the_motion());
    let remedy = to_blame.then(|| nearest_tie(design, replay)).flatten();
    let of = |finding: &Finding| remedy.clone().filter(|_| !finding.kind.is_of_the_motion()).into_iter().collect();
    analysis.findings.iter().map(of).collect()
}

fn nearest_tie(design: &Design, replay: &Replay) -> Option<Remedy> {
    let (pair, first) = (design.conjugate?, design.cam().ok()?);
    let (least, most) = working_ties_in_parts(&first, pair.core_tie(), pair.radius, replay)?;
    let measure = measure_of(pair.tie);
    let (least, most, now) = (measure.told(least), measure.told(most), pair.tie.value());
    let grows = now < least;
    let value = short_within(if grows { least } else { most }, least, most)?;
    // An angle is no size.
    let believable = matches!(pair.tie, Tie::Angle(_)) || value <= believable_sizes(&first).1;
    believable.then_some(Remedy::Tie { tie: pair.tie.with(value), grows })
}

fn in_units(design: &Design, cam: &Cam, cure: Cure, replay: &Replay) -> Remedy {
    match cure {
        Cure::BaseRadius(exact) => {
            let value = shortest_passing_in_parts(cam, exact, replay);
            Remedy::BaseRadius { value, grows: value > design.base_radius }
        }
        Cure::Travel(exact) => Remedy::Travel { value: shortest_passing_in_parts(cam, exact, replay) },
        Cure::Length { key, value: exact } => {
            let index = cam.follower.kind().index_of(key).unwrap_or_default();
            let grows = exact > cam.follower.values()[index];
            let passes = |&value: &f64| {
                let moved = |value| Some(cam.with_follower(cam.follower.with_value(index, value).ok()?));
                replay.holds(|| moved(value).is_some_and(|cam| geometry_passes(&cam)))
            };
            let value = shortest(exact, if grows { f64::ceil } else { f64::floor }, passes).unwrap_or(exact);
            Remedy::Length { key, value }
        }
        Cure::NoSize { needed, instead } => {
            Remedy::NoSize { needed: needed.map(|size| round(size, DIGITS, f64::ceil)), instead }
        }
        Cure::Eccentricity { value, pressure_angle } => {
            let rounded = round(value, DIGITS, f64::round);
            let moved =
                cam.follower.kind().index_of("eccentricity").and_then(|i| cam.follower.with_value(i, rounded).ok());
            let remaining = moved.map_or(pressure_angle, |follower| {
                replay.value(|| {
                    let analysis = Analysis::of(&cam.with_follower(follower), LOOK);
                    analysis.summary.pressure_angle.greatest_size().0
                })
            });
            Remedy::Eccentricity { value: rounded, pressure_angle: remaining.to_degrees() }
        }
        Cure::Laws { changes, remaining_jump } => {
            const ORDERS: [Column; 4] = [Column::S, Column::V, Column::A, Column::J];
            let remaining_jump = remaining_jump.and_then(|order| ORDERS.get(usize::from(order)).copied());
            Remedy::Laws { changes, remaining_jump, price: Price::default() }
        }
    }
}

/// Steps in which a rounded cure is looked at; the verdict is exact whatever they are.
const LOOK: usize = 1;

/// The base radius (or the travel) rounded up to the fewest digits, four or more, with which the geometry still passes.
pub(crate) fn shortest_passing(cam: &Cam, exact: f64) -> f64 {
    Replay::whole(|replay| shortest_passing_in_parts(cam, exact, replay))
}

fn shortest_passing_in_parts(cam: &Cam, exact: f64, replay: &Replay) -> f64 {
    let passes = |&size: &f64| replay.holds(|| resized(cam, size).is_some_and(|sized| geometry_passes(&sized)));
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
