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
//! Elsewhere the arm is compared with the whole profile, whatever its shape and wherever the pivot is. Own derivation.

use crate::analysis::finding;
use crate::samples::Samples;
use crate::{Body, Cam, Closure, Finding, FindingKind, Point};
use std::f64::consts::TAU;

/// Minimum number of places of the turn at which the arm is compared with as many points of the profile.
const MIN_PLACES: usize = 720;

/// Sides of the profile that share one bounding circle: about the square root of their number, which needs the fewest comparisons.
const BLOCK: usize = 24;

/// A cut shallower than this part of the base radius is rounding.
const SHALLOWEST_CUT: f64 = 1e-6;

/// A cut deeper than this part of the base radius is seen on the polygon, whose sides leave the profile by less; a shallower one is
/// decided on the curve.
const POLYGON_TOLERANCE: f64 = 1e-3;

/// Near misses that are refined, the nearest first.
const MAX_TOUCHES: usize = 8;

/// Steps of the profile to both sides of a near miss among which the place of contact moves while the arm moves by one step.
const TOUCH_STEPS: f64 = 4.0;

/// Points looked at on each part of an arm that is inside the cam.
const INNER_POINTS: usize = 8;

/// Steps of a golden section: they shorten an interval by 10⁻⁷, which makes the value at a smooth peak exact to its square.
const GOLDEN_STEPS: usize = 34;

/// The arm or stem of the follower inside the cam: where it is deepest, and how far that is from the profile.
pub(crate) fn arm_cut(cam: &Cam, samples: &Samples) -> Option<Finding> {
    if cam.closure == Closure::Groove || !may_cut(cam, samples) {
        return None;
    }
    let outline = Outline::of(cam, samples);
    let size = cam.size();
    let cut = outline.deepest_cut().filter(|cut| cut.depth > POLYGON_TOLERANCE * size);
    let cut = cut.or_else(|| outline.deepest_touch()).filter(|cut| cut.depth > SHALLOWEST_CUT * size)?;
    Some(finding(FindingKind::ArmCutsCam, cut.theta.rem_euclid(TAU), cut.depth, 0.0, None))
}

/// False for a follower that needs no search.
fn may_cut(cam: &Cam, samples: &Samples) -> bool {
    if cam.follower.is_flat() {
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

    fn distance(self, point: Point) -> f64 {
        (self.at(self.foot(point).clamp(0.0, 1.0)) - point).norm()
    }
}

/// A circle around some sides of the profile that follow each other.
struct Ball {
    centre: Point,
    radius: f64,
    first: usize,
}

/// The arm beside a point of the profile that it nearly touches.
#[derive(Clone, Copy)]
struct Touch {
    place: usize,
    vertex: usize,
    distance: f64,
}

/// The profile as a closed polygon, with the curve behind it.
struct Outline<'a> {
    cam: &'a Cam,
    /// Angle between neighbouring points, radians.
    step: f64,
    points: Vec<Point>,
    balls: Vec<Ball>,
    arms: Vec<Arm>,
    /// Maximum distance of the profile from the centre.
    reach: f64,
}

impl<'a> Outline<'a> {
    fn of(cam: &'a Cam, samples: &Samples) -> Self {
        let stride = (samples.stations() / MIN_PLACES).max(1);
        let stations = (0..samples.stations()).step_by(stride);
        let points: Vec<Point> = stations.clone().map(|k| samples.profile[k]).collect();
        let reach = points.iter().map(Point::norm_sqr).fold(0.0, f64::max).sqrt();
        let step = samples.station(stride);
        let balls = (0..points.len()).step_by(BLOCK).map(|first| ball(&points, first)).collect();
        let mut outline = Self { cam, step, points, balls, arms: Vec::new(), reach };
        let turned = |k: usize| (samples.pitch[k], samples.turns[k]);
        outline.arms = stations.map(turned).map(|(trace, turn)| outline.arm(trace, turn)).collect();
        outline
    }

    /// The arm whose trace point is `from`, both ends in the frame of the cam; `turn` is e^(−iσθ).
    fn arm(&self, from: Point, turn: Point) -> Arm {
        let to = match self.cam.follower.body {
            Body::Slide => from + Point::new(0.0, (self.reach + from.norm()) * self.cam.follower.advance()) * turn,
            Body::Swing { pivot } => pivot * turn,
        };
        Arm { from, to }
    }

    fn arm_at(&self, theta: f64) -> Arm {
        let turn = self.cam.in_cam_frame(Point::new(1.0, 0.0), theta);
        self.arm(self.cam.at(theta).1.trace * turn, turn)
    }

    fn side(&self, k: usize) -> Arm {
        Arm { from: self.points[k], to: self.points[(k + 1) % self.points.len()] }
    }

    /// The sides in balls that are no farther from the arm than `distance`.
    fn sides_near(&self, arm: Arm, distance: f64) -> impl Iterator<Item = usize> {
        let near = move |ball: &&Ball| arm.distance(ball.centre) <= ball.radius + distance;
        let end = self.points.len();
        self.balls.iter().filter(near).flat_map(move |ball| ball.first..(ball.first + BLOCK).min(end))
    }

    /// The deepest cut that the polygon shows.
    fn deepest_cut(&self) -> Option<Cut> {
        let depths = self.arms.iter().enumerate().map(|(place, &arm)| (place, self.depth(arm)));
        let (place, depth) = depths.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, depth)| *depth > 0.0)?;
        let theta = self.step * place as f64;
        let (refined, deeper) = peak(theta - self.step, theta + self.step, |theta| self.depth(self.arm_at(theta)));
        Some(if deeper > depth { Cut { theta: refined, depth: deeper } } else { Cut { theta, depth } })
    }

    /// Maximum distance from the profile of the points of an arm that are inside the cam; 0 when none is.
    fn depth(&self, arm: Arm) -> f64 {
        let mut crossings: Vec<(f64, bool)> =
            self.sides_near(arm, 0.0).filter_map(|k| self.crossing(arm, self.side(k))).collect();
        crossings.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let mut deepest = 0.0_f64;
        for (k, &(enters, _)) in crossings.iter().enumerate().filter(|(_, (_, inwards))| *inwards) {
            let leaves = crossings.get(k + 1).map_or(1.0, |next| next.0);
            let part = (leaves - enters) / INNER_POINTS as f64;
            let inner = |u: f64| self.distance(arm.at(u), deepest);
            let at = |i: usize| enters + part * i as f64;
            let best = (1..=INNER_POINTS).map(|i| (i, inner(at(i)))).max_by(|a, b| a.1.total_cmp(&b.1));
            if let Some((i, depth)) = best {
                let refined = peak(at(i - 1), at(i + 1).min(leaves), inner).1;
                deepest = deepest.max(depth).max(refined);
            }
        }
        deepest
    }

    /// Where an arm crosses a side of the polygon, as a part of the arm, and whether it enters the cam there.
    fn crossing(&self, arm: Arm, side: Arm) -> Option<(f64, bool)> {
        let (along, edge) = (arm.along(), side.along());
        let (before, after) = (cross(along, side.from - arm.from), cross(along, side.to - arm.from));
        if (before < 0.0) == (after < 0.0) {
            return None;
        }
        let turning = cross(along, edge);
        let u = cross(side.from - arm.from, edge) / turning;
        // The profile runs clockwise in the frame of a cam that turns counter-clockwise: the outside is on its left.
        (0.0..=1.0).contains(&u).then_some((u, turning * self.cam.follower.rotation.sigma() > 0.0))
    }

    /// Distance of a point from the polygon. One that cannot exceed `enough` is not computed to the end.
    fn distance(&self, point: Point, enough: f64) -> f64 {
        let mut least = f64::INFINITY;
        for ball in &self.balls {
            if (ball.centre - point).norm() - ball.radius >= least {
                continue;
            }
            let sides = ball.first..(ball.first + BLOCK).min(self.points.len());
            least = sides.map(|k| self.side(k).distance(point)).fold(least, f64::min);
            if least <= enough {
                break;
            }
        }
        least
    }

    /// The deepest cut that is so shallow, or so short, that only the curve shows it: near misses of the polygon are refined.
    fn deepest_touch(&self) -> Option<Cut> {
        let near: Vec<Option<Touch>> = (0..self.arms.len()).map(|place| self.near_miss(place)).collect();
        let distance = |place: usize| near[place % near.len()].map_or(f64::INFINITY, |touch| touch.distance);
        let nearest = |touch: &&Touch| {
            let before = distance(touch.place + near.len() - 1);
            touch.distance <= before && touch.distance <= distance(touch.place + 1)
        };
        let mut touches: Vec<&Touch> = near.iter().flatten().filter(nearest).collect();
        touches.sort_unstable_by(|a, b| a.distance.total_cmp(&b.distance));
        touches.truncate(MAX_TOUCHES);
        touches.into_iter().map(|touch| self.refined(*touch)).max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// The point of the profile nearest to the arm at a place, when the arm may reach it before the next place.
    fn near_miss(&self, place: usize) -> Option<Touch> {
        let (arm, n) = (self.arms[place], self.arms.len());
        let moved = |other: usize| {
            let other = self.arms[other % n];
            (other.from - arm.from).norm().max((other.to - arm.to).norm())
        };
        let within = moved(place + 1).max(moved(place + n - 1));
        let beside = |k: &usize| {
            let foot = arm.foot(self.points[*k]);
            0.0 < foot && foot <= 1.0
        };
        let vertices = self.sides_near(arm, within).filter(beside);
        let touches = vertices.map(|vertex| Touch { place, vertex, distance: arm.distance(self.points[vertex]) });
        touches.filter(|touch| touch.distance <= within).min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    /// How far the profile rises beyond the arm at a near miss, at most: both the place of the arm and that on the profile vary.
    fn refined(&self, touch: Touch) -> Cut {
        let (place, vertex) = (self.step * touch.place as f64, self.step * touch.vertex as f64);
        let outwards = self.cam.in_cam_frame(self.cam.at(vertex).1.normal, vertex);
        let height = |theta: f64| {
            let arm = self.arm_at(theta);
            let across = arm.along() * Point::i() / arm.along().norm().max(f64::MIN_POSITIVE);
            let across = across * dot(across, outwards).signum();
            let beyond = |t: f64| {
                let point = self.cam.in_cam_frame(self.cam.at(t).1.point, t);
                let beside = (0.0..=1.0).contains(&arm.foot(point));
                if beside { dot(across, point - arm.from) } else { f64::NEG_INFINITY }
            };
            peak(vertex - TOUCH_STEPS * self.step, vertex + TOUCH_STEPS * self.step, beyond).1
        };
        let (theta, depth) = peak(place - self.step, place + self.step, height);
        Cut { theta, depth }
    }
}

fn ball(points: &[Point], first: usize) -> Ball {
    let around = || (first..=(first + BLOCK).min(points.len())).map(|k| points[k % points.len()]);
    let centre = around().sum::<Point>() / around().count() as f64;
    let radius = around().map(|point| (point - centre).norm()).fold(0.0, f64::max);
    Ball { centre, radius, first }
}

/// Where a function with one summit between two places is highest, and its value there, by golden section.
fn peak(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut left, mut right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..GOLDEN_STEPS {
        if at_left >= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = f(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = f(right);
        }
    }
    if at_left >= at_right { (left, at_left) } else { (right, at_right) }
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
        Cam::new(program(&turned), Follower::new(kind, base, values, rotation).expect("a follower"))
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
    fn no_stem_is_cut_and_no_groove_holds_one() {
        let kind = FollowerKind::by_id("translating-roller").expect("a kind");
        for (eccentricity, lift) in [(25.0, 90.0), (-25.0, 90.0), (29.0, 10.0), (0.0, 120.0)] {
            let follower = Follower::new(kind, 30.0, [1.0, eccentricity, 0.0, 0.0], Rotation::default());
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
