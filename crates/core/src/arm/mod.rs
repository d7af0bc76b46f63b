//! The arm of a follower, a segment without thickness from the centre of its roller to its pivot, that cuts the cam.
//!
//! Two kinds of follower need no search:
//!
//! * **Grooved cams.** The groove is milled into the face of a disc; only the roller is in it, on a pin. The arm or stem runs above
//!   the face, so neither the walls of the groove nor the rim of the disc are in its way.
//! * **Stems.** In the frame of the cam the stems of all θ are half-tangents of the circle of radius |e| about the centre. They cover
//!   the plane outside of that circle once, so no stem meets the pitch curve a second time, and the cam lies within that curve. This
//!   holds as long as the trace point stays above the centre: s₀ + s > 0.
//!
//! Elsewhere the arm is compared with the whole profile, whatever its shape and wherever the pivot is: first groups of arms with
//! bounding circles of the profile, which dismisses most cams, then arms with sides where they come near. Only the deepest cuts, or
//! the nearest misses, are refined. Own derivation.

mod outline;
mod touch;

use crate::analysis::finding;
use crate::samples::Samples;
use crate::{Body, Cam, Closure, Finding, FindingKind, Point};
use outline::Outline;
use std::f64::consts::TAU;

/// A cut shallower than this part of the base radius is rounding.
const SHALLOWEST_CUT: f64 = 1e-6;

/// A cut deeper than this part of the base radius is seen on the polygon, whose sides leave the profile by less; a shallower one is
/// decided on the curve.
const POLYGON_TOLERANCE: f64 = 1e-3;

/// The arm or stem of the follower inside the cam: where it is deepest, and how far that is from the profile. `crosses` tells that
/// the profile crosses itself.
pub(crate) fn arm_cut(cam: &Cam, samples: &Samples, crosses: bool) -> Option<Finding> {
    if !may_cut(cam, samples) {
        return None;
    }
    let outline = Outline::of(cam, samples, crosses);
    let pairs = outline.pairs();
    let size = cam.size();
    let cut = outline.deepest_cut(&pairs).filter(|cut| cut.depth > POLYGON_TOLERANCE * size);
    let cut = cut.or_else(|| outline.deepest_touch(&pairs)).filter(|cut| cut.depth > SHALLOWEST_CUT * size)?;
    Some(finding(FindingKind::ArmCutsCam, cut.theta.rem_euclid(TAU), cut.depth, 0.0, None))
}

/// True when [`arm_cut`] finds something in a profile that does not cross itself; faster where the cut is deep.
pub(crate) fn arm_cuts(cam: &Cam, samples: &Samples) -> bool {
    if !may_cut(cam, samples) {
        return false;
    }
    let outline = Outline::of(cam, samples, false);
    let pairs = outline.pairs();
    let size = cam.size();
    outline.is_deeper_than(POLYGON_TOLERANCE * size, &pairs)
        || outline.deepest_cut(&pairs).is_some_and(|cut| cut.depth > POLYGON_TOLERANCE * size)
        || outline.deepest_touch(&pairs).is_some_and(|cut| cut.depth > SHALLOWEST_CUT * size)
}

/// False for a follower that needs no search.
fn may_cut(cam: &Cam, samples: &Samples) -> bool {
    if cam.closure == Closure::Groove || cam.follower.is_flat() {
        return false;
    }
    match cam.follower.body {
        Body::Swing { .. } => true,
        Body::Slide if samples.turns.is_empty() => false,
        Body::Slide => {
            let advance = cam.follower.advance();
            let height = |(trace, turn): (&Point, &Point)| (trace * turn.conj()).im * advance;
            samples.pitch.iter().zip(&samples.turns).map(height).fold(f64::INFINITY, f64::min) <= 0.0
        }
    }
}

/// The deepest point of an arm inside the cam.
#[derive(Clone, Copy)]
struct Cut {
    /// θ of the place from which it was refined.
    place: f64,
    theta: f64,
    depth: f64,
}

/// A segment in the frame of the cam.
#[derive(Clone, Copy)]
struct Arm {
    from: Point,
    to: Point,
}

impl Arm {
    fn along(self) -> Point {
        self.to - self.from
    }

    fn at(self, u: f64) -> Point {
        self.from + self.along() * u
    }

    /// Where the perpendicular from `point` meets the line of the arm, as a part of its length.
    fn foot(self, point: Point) -> f64 {
        dot(self.along(), point - self.from) / self.along().norm_sqr().max(f64::MIN_POSITIVE)
    }

    fn distance_squared(self, point: Point) -> f64 {
        (self.at(self.foot(point).clamp(0.0, 1.0)) - point).norm_sqr()
    }

    /// How far a point of the arm moves to its place on another, at most.
    fn moved_to(self, other: Self) -> f64 {
        (other.from - self.from).norm_sqr().max((other.to - self.to).norm_sqr()).sqrt()
    }
}

fn dot(a: Point, b: Point) -> f64 {
    a.re * b.re + a.im * b.im
}

fn cross(a: Point, b: Point) -> f64 {
    a.re * b.im - a.im * b.re
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Analysis, Follower, FollowerKind, Level, Program, Rotation, Segment};

    fn program(segments: &[(&str, f64, f64)]) -> Program {
        let segments: Vec<Segment> =
            segments.iter().map(|&(law, beta, rise)| Segment::of(law, beta, rise).expect(law)).collect();
        Program::new(&segments).expect("a program")
    }

    fn swinging(segments: &[(&str, f64, f64)], base: f64, values: [f64; 4], rotation: Rotation) -> Cam {
        let turned: Vec<(&str, f64, f64)> =
            segments.iter().map(|&(law, beta, rise)| (law, beta, rise.to_radians())).collect();
        let kind = FollowerKind::by_id("oscillating-roller").expect("a kind");
        Cam::new(program(&turned), Follower::new(kind, base, &values, rotation).expect("a follower"))
    }

    fn cut_of(cam: &Cam, rows: usize) -> Option<Finding> {
        let analysis = Analysis::of(cam, rows);
        analysis.findings.into_iter().find(|finding| finding.kind == FindingKind::ArmCutsCam)
    }

    /// A lift of 70° that bends the profile into a hook, which the arm crosses on its way to the pivot.
    fn hook() -> Cam {
        let segments =
            [("cycloidal", 160.0, 70.0), ("dwell", 28.0, 0.0), ("cycloidal", 155.0, -70.0), ("dwell", 17.0, 0.0)];
        swinging(&segments, 40.0, [20.3, 160.9, 218.2, 0.0], Rotation::Clockwise)
    }

    /// The depth of the arm at θ by counting: points of the arm inside a fine polygon, by the winding of the profile around them.
    fn depth_by_counting(cam: &Cam, theta: f64) -> f64 {
        let sides = 7200;
        let angle = |k: usize| TAU * k as f64 / sides as f64;
        let outline: Vec<Point> = (0..=sides).map(|k| cam.in_cam_frame(cam.at(angle(k)).1.point, angle(k))).collect();
        let Body::Swing { pivot } = cam.follower.body else { return 0.0 };
        let (from, to) = (cam.in_cam_frame(cam.at(theta).1.trace, theta), cam.in_cam_frame(pivot, theta));
        let depth = |u: f64| {
            let point = from + (to - from) * u;
            let winding: f64 = outline.windows(2).map(|side| ((side[1] - point) / (side[0] - point)).arg()).sum();
            let distance = outline.iter().map(|vertex| (vertex - point).norm()).fold(f64::INFINITY, f64::min);
            if winding.abs() > 1.0 { distance } else { 0.0 }
        };
        (0..=400).map(|k| depth(f64::from(k) / 400.0)).fold(0.0, f64::max)
    }

    #[test]
    fn an_arm_through_a_cam_that_is_not_star_shaped_is_found() {
        let cut = cut_of(&hook(), 720).expect("the arm is cut");
        assert!((cut.value - 14.923).abs() < 2e-3 && (cut.theta.to_degrees() - 247.6).abs() < 0.5, "{cut:?}");
        let counted = depth_by_counting(&hook(), cut.theta);
        assert!((cut.value - counted).abs() < 0.01 * counted, "{} and {counted}", cut.value);
        let at_240 = depth_by_counting(&hook(), 240_f64.to_radians());
        assert!((at_240 - 14.4).abs() < 0.1 && cut.value >= at_240 - 0.01, "{} and {at_240}", cut.value);
    }

    #[test]
    fn an_arm_whose_pivot_the_cam_sweeps_over_is_found() {
        let segments =
            [("cycloidal", 153.0, 42.0), ("dwell", 42.0, 0.0), ("cycloidal", 45.0, -42.0), ("dwell", 120.0, 0.0)];
        let cam = swinging(&segments, 40.0, [33.3, 242.3, 267.7, 0.0], Rotation::Clockwise);
        let cut = cut_of(&cam, 720).expect("the arm is cut");
        assert!((cut.value - 61.573).abs() < 2e-3 && (cut.theta.to_degrees() - 228.7).abs() < 0.2, "{cut:?}");
        let counted = depth_by_counting(&cam, cut.theta);
        assert!((cut.value - counted).abs() < 0.01 * counted, "{} and {counted}", cut.value);
    }

    #[test]
    fn the_cut_does_not_depend_on_the_rows_asked_for() {
        let [coarse, fine] = [1, 7200].map(|rows| cut_of(&hook(), rows).expect("the arm is cut"));
        assert!((coarse.value - fine.value).abs() < 1e-3, "{} and {}", coarse.value, fine.value);
    }

    #[test]
    fn the_arm_of_a_grooved_cam_runs_above_the_face() {
        let segments = [("cycloidal", 112.3, 2.945), ("polynomial-3-4-5", 164.5, 0.835), ("cycloidal", 83.2, -3.78)];
        let values = [6.45, 94.85, 85.15, 144.3_f64.to_radians()];
        let cam = swinging(&segments, 64.51, values, Rotation::CounterClockwise);
        assert!(cut_of(&cam, 720).is_some(), "as a cam that a force closes it is cut");
        let grooved = cam.closed_by(Closure::Groove);
        let analysis = Analysis::of(&grooved, 720);
        assert_eq!(analysis.level, Level::LowSpeed, "{:?}", analysis.findings);
    }

    #[test]
    fn the_pivot_of_a_grooved_cam_stands_outside_of_the_outer_wall() {
        let segments = [("cycloidal", 180.0, 3.78), ("cycloidal", 180.0, -3.78)];
        let has_pivot_inside = |pivot: f64, closure: Closure| {
            let cam =
                swinging(&segments, 64.51, [6.45, 94.85, pivot, 0.0], Rotation::CounterClockwise).closed_by(closure);
            Analysis::of(&cam, 720).findings.iter().any(|finding| finding.kind == FindingKind::PivotInsideCam)
        };
        // The walls reach 70.8 and 83.7 at the top of the motion.
        assert!(has_pivot_inside(80.0, Closure::Groove) && !has_pivot_inside(80.0, Closure::Force));
        assert!(!has_pivot_inside(85.15, Closure::Groove));
    }

    #[test]
    fn no_stem_is_cut_and_no_groove_holds_one() {
        for (eccentricity, lift) in [(25.0, 90.0), (-25.0, 90.0), (29.0, 10.0), (0.0, 120.0)] {
            let follower =
                Follower::translating_roller(30.0, 1.0).and_then(|roller| roller.with_eccentricity(eccentricity));
            let motion = program(&[("cycloidal", 90.0, lift), ("cycloidal", 270.0, -lift)]);
            let cam = Cam::new(motion, follower.expect("a follower"));
            assert!(cut_of(&cam, 720).is_none() && cut_of(&cam.closed_by(Closure::Groove), 720).is_none());
        }
    }

    #[test]
    fn a_cut_too_shallow_for_the_stations_is_found_on_the_curve() {
        // The lift grows until the arm touches the hook; a hair beyond that it cuts by a hair.
        let cam_at = |lift: f64| {
            let segments = [("cycloidal", 160.0, lift), ("cycloidal", 200.0, -lift)];
            swinging(&segments, 40.0, [20.3, 160.9, 218.2, 0.0], Rotation::Clockwise)
        };
        let is_cut = |lift: f64| cut_of(&cam_at(lift), 720).is_some();
        let (mut clear, mut cut) = (20.0, 70.0);
        assert!(!is_cut(clear) && is_cut(cut));
        for _ in 0..40 {
            let middle = 0.5 * (clear + cut);
            if is_cut(middle) {
                cut = middle;
            } else {
                clear = middle;
            }
        }
        let (touch, deeper) = (cut_of(&cam_at(cut), 720), cut_of(&cam_at(cut + 1e-4), 720));
        let [touch, deeper] = [touch, deeper].map(|cut| cut.expect("the arm is cut").value);
        assert!((touch - 40.0 * SHALLOWEST_CUT).abs() < 1e-7, "a touch of {touch}");
        assert!(deeper > touch && deeper < touch + 1e-3, "{deeper} after {touch}");
    }
}
