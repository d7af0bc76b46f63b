//! Cams side by side: the figures by which designs are compared, and one program moved by every law in turn.

use crate::cure::{by_law as segment_by_law, shortest_passing};
use crate::{CamStudy, Design, DesignError, Study};
use levalab_core::{Cam, Column, LAWS, Law, Level, smallest_base_radius};

/// What a cam is judged by beside others, in the units of its design. Peaks are the greatest sizes over the turn, whatever the sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// The verdict.
    pub level: Level,
    /// The greatest displacement.
    pub lift: f64,
    /// Peaks of v, a and j, per radian; infinite where the derivative before jumps.
    pub peaks: [f64; 3],
    /// Peaks of V, A and J, per second.
    pub timed_peaks: [f64; 3],
    /// The least and the greatest pressure angle, degrees.
    pub pressure_angle: [f64; 2],
    /// The greatest |φ|, degrees.
    pub steepest: f64,
    /// The least radius of curvature where the profile is convex; none when it is convex nowhere.
    pub least_radius: Option<f64>,
    /// The minimum length of a flat face, from the foot of the pivot when it swings; none without a flat face.
    pub face: Option<f64>,
}

impl Figures {
    /// The figures of a design; of a conjugate pair, the motion once and of each limit the worse.
    #[must_use]
    pub fn of(study: &Study) -> Self {
        let figures = Self::of_one(study.first());
        study.second().map_or(figures, |second| figures.worse(&Self::of_one(second)))
    }

    fn of_one(study: &CamStudy) -> Self {
        let (design, cam, analysis, report) = (study.design(), study.cam(), study.analysis(), study.report());
        let size = |column| report.range(column).map_or(0.0, |range| range.max.abs().max(range.min.abs()));
        let lowest_jump = analysis.joints.iter().filter_map(|joint| joint.jump).min().unwrap_or(u8::MAX);
        let peak = |(order, column)| if lowest_jump < order { f64::INFINITY } else { size(column) };
        let peaks = [(1, Column::V), (2, Column::A), (3, Column::J)].map(peak);
        let omega = design.omega();
        let angles = report.range(Column::PressureAngle).map_or([0.0; 2], |range| [range.min, range.max]);
        Self {
            level: report.level,
            lift: report.range(Column::S).map_or(0.0, |range| range.max),
            peaks,
            timed_peaks: [peaks[0] * omega, peaks[1] * omega.powi(2), peaks[2] * omega.powi(3)],
            pressure_angle: angles,
            steepest: size(Column::PressureAngle),
            least_radius: analysis.summary.least_convex.map(|(radius, _)| radius).filter(|radius| radius.is_finite()),
            face: analysis.summary.face(cam, 0.0).map(|face| face.length),
        }
    }
}

impl Figures {
    fn worse(self, other: &Self) -> Self {
        let either = |one: Option<f64>, other: Option<f64>, choose: fn(f64, f64) -> f64| match (one, other) {
            (Some(one), Some(other)) => Some(choose(one, other)),
            (one, other) => one.or(other),
        };
        let ([low, high], [other_low, other_high]) = (self.pressure_angle, other.pressure_angle);
        Self {
            level: self.level.max(other.level),
            pressure_angle: [low.min(other_low), high.max(other_high)],
            steepest: self.steepest.max(other.steepest),
            least_radius: either(self.least_radius, other.least_radius, f64::min),
            face: either(self.face, other.face, f64::max),
            ..self
        }
    }
}

/// A design in a tournament.
#[derive(Clone, Debug)]
pub struct Contender {
    /// The law that moves every segment; none for the design as it came.
    pub law: Option<&'static Law>,
    /// The design with that law.
    pub design: Design,
    /// Its figures.
    pub figures: Figures,
    /// The smallest base radius with which its geometry passes, when one does; 0 when every one does.
    pub smallest_base_radius: Option<f64>,
}

/// The design as it is, and then the same program with each law in place of the law of every segment that moves, in the order of
/// [`LAWS`]. β and L stay; a law takes its usual parameters. Laws that do not fit the program are left out, and so is the one that
/// gives the design as it came.
///
/// # Errors
/// When the design itself is no cam.
pub fn tournament(design: &Design) -> Result<Vec<Contender>, DesignError> {
    let cam = design.cam()?;
    let mut contenders = vec![contender(None, design.clone())?];
    for law in LAWS.iter().copied().filter(|law| !law.is_dwell() && law.free().is_none()) {
        let other = by_law(design, &cam, law);
        if other.segments != design.segments {
            contenders.extend(contender(Some(law), other));
        }
    }
    Ok(contenders)
}

/// The design with one law in place of the law of every segment that moves.
#[must_use]
pub fn by_law(design: &Design, cam: &Cam, law: &'static Law) -> Design {
    let mut other = design.clone();
    for (k, segment) in other.segments.iter_mut().enumerate().filter(|(_, segment)| !segment.law.is_dwell()) {
        *segment = segment_by_law(design, cam, k, law);
    }
    other
}

/// A base circle this small beside that of the design is no limit: the search ends where it vanishes.
const NOTHING: f64 = 1e-6;

fn contender(law: Option<&'static Law>, design: Design) -> Result<Contender, DesignError> {
    let study = Study::without_columns(design)?;
    let (design, cam) = (study.design(), study.first().cam());
    let told = |exact: f64| if exact < NOTHING * design.base_radius { 0.0 } else { shortest_passing(cam, exact) };
    let sized = if design.kind.travel().is_some() { None } else { smallest_base_radius(cam) };
    let smallest_base_radius = sized.map(told);
    Ok(Contender { law, design: design.clone(), figures: study.figures(), smallest_base_radius })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{EXAMPLES, example};
    use levalab_core::Analysis;

    /// The same design by hand: every segment that is no dwell takes the law, and the cam is analysed on its own.
    fn by_hand(design: &Design, law: &'static Law) -> Option<(Cam, Analysis)> {
        let mut other = design.clone();
        let whole = design.cam().ok()?;
        for (k, segment) in other.segments.iter_mut().enumerate().filter(|(_, segment)| segment.law.id != "dwell") {
            *segment = segment_by_law(design, &whole, k, law);
        }
        let cam = other.cam().ok()?;
        let analysis = Analysis::of(&cam, 360);
        Some((cam, analysis))
    }

    #[test]
    fn a_tournament_tells_what_separate_analyses_tell() {
        for (name, _) in EXAMPLES {
            let design = example(name).expect(name);
            let contenders = tournament(&design).expect(name);
            assert!(contenders[0].law.is_none() && contenders[0].design == design, "{name}");
            if design.segments.is_empty() || design.conjugate.is_some() || design.kind.travel().is_some() {
                continue;
            }
            let mut fitting = 0;
            for law in LAWS.iter().copied().filter(|law| !law.is_dwell() && law.free().is_none()) {
                let entered = contenders.iter().find(|contender| contender.law == Some(law));
                let Some((cam, analysis)) = by_hand(&design, law) else {
                    assert!(entered.is_none(), "{name} {} does not fit", law.id);
                    continue;
                };
                fitting += 1;
                let Some(entered) = entered else {
                    assert!(design.segments.iter().all(|segment| segment.law == law || segment.law.is_dwell()));
                    continue;
                };
                let omega = design.omega();
                let travel = if design.is_oscillating() { 1_f64.to_degrees() } else { 1.0 };
                let figures = entered.figures;
                let near = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-9 * b.abs().max(1e-9);
                let summary = &analysis.summary;
                for (order, found) in [summary.v, summary.a, summary.j].into_iter().enumerate() {
                    let jumps =
                        analysis.joints.iter().any(|joint| joint.jump.is_some_and(|jump| usize::from(jump) <= order));
                    let peak = if jumps { f64::INFINITY } else { found.min.abs().max(found.max.abs()) * travel };
                    assert!(near(figures.peaks[order], peak), "{name} {} {order}", law.id);
                    assert!(near(figures.timed_peaks[order], peak * omega.powi(order as i32 + 1)), "{name} {}", law.id);
                }
                let steepest = summary.pressure_angle.greatest_size().0.to_degrees();
                assert!(near(figures.steepest, steepest), "{name} {}: {} {steepest}", law.id, figures.steepest);
                assert_eq!(figures.level, analysis.level, "{name} {}", law.id);
                assert_eq!(figures.least_radius.is_some(), summary.least_convex.is_some(), "{name} {}", law.id);
                if let Some(radius) = entered.smallest_base_radius.filter(|&radius| radius > 0.0) {
                    let sized = cam.with_base_radius(radius).expect("a cam of that size");
                    let angle = Analysis::of(&sized, 360).summary.pressure_angle.greatest_size().0;
                    assert!(angle <= sized.follower.pressure_angle_limit() + 1e-9, "{name} {}: {angle}", law.id);
                }
            }
            assert!(fitting > 5, "{name}: {fitting}");
        }
    }

    #[test]
    fn the_face_is_as_long_as_the_contact_walks() {
        let figures = Study::without_columns(example("10EX").expect("10EX")).expect("a cam").figures();
        // An eccentric circle: q = v = ±L/2 · sin θ.
        assert!((figures.face.expect("a face") - 20.0).abs() < 1e-9, "{figures:?}");
        assert!((figures.least_radius.expect("ρ") - 40.0).abs() < 1e-9, "{figures:?}");
    }

    #[test]
    fn a_face_that_swings_is_as_long_as_from_the_foot_of_its_pivot() {
        let study = Study::without_columns(example("4PO").expect("4PO")).expect("a cam");
        let cam = study.first().cam();
        let face = study.first().analysis().summary.face(cam, 0.0).expect("a face");
        let near = |found: f64, expected: f64| assert!((found - expected).abs() < 0.01, "{found}, not {expected}");
        near(face.from, 53.75);
        near(face.to, 83.49);
        near(face.length, 83.49);
        assert_eq!(study.figures().face, Some(face.length));
        // Its contact lies where the contact of the motion says at each angle.
        let greatest = (0..3600).map(|k| cam.at(f64::from(k).to_radians() / 10.0).1.reach).fold(0.0, f64::max);
        near(greatest, face.length);
    }
}
