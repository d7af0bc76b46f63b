//! The profile as a polygon, and the arm at places around the turn: which sides an arm comes near, and how deep it is inside the cam.

use super::{Arm, Cut, cross};
use crate::samples::Samples;
use crate::search::golden_maximum;
use crate::{Body, Cam, Point};
use std::ops::Range;

/// Minimum number of places of the turn at which the arm is compared with as many points of the profile.
const MIN_PLACES: usize = 720;

/// Sides of the profile that share one bounding circle: about the square root of their number, which needs the fewest comparisons.
const BLOCK: usize = 24;

/// Number of parts into which a block of sides is divided; each part has a bounding circle, within the bounding circle of the block.
const PARTS: usize = 4;

/// Arms at neighbouring places that are compared with a bounding circle together.
const GROUP: usize = 8;

/// Part of the way to the next place within which an arm is nearest to its own place: a half, and a little for the sides, which leave
/// the profile.
const HALF_WAY: f64 = 0.6;

/// Points looked at on each part of an arm that is inside the cam.
const INNER_POINTS: usize = 8;

/// One place in so many is measured where the arm is cut at all of them.
const MEASURED_EVERY: usize = 4;

/// Part of the maximum depth measured from which a place is refined.
const NEARLY_DEEPEST: f64 = 0.9;

/// Places that are refined, the deepest first.
const MAX_REFINED: usize = 3;

/// Steps of a golden section on the polygon: they shorten an interval by 4·10⁻⁶.
const GOLDEN_STEPS: usize = 26;

/// A circle around some sides of the profile that follow each other.
struct Ball {
    centre: Point,
    radius: f64,
    sides: Range<usize>,
}

/// An arm and some sides that it comes near to.
pub(super) struct Pair {
    /// The place of the arm.
    pub place: usize,
    /// Which of the smaller balls.
    part: usize,
    /// How far a point of the arm moves half-way to the next place or the one before, at most.
    pub moved: f64,
}

/// The profile as a closed polygon, with the curve behind it.
pub(super) struct Outline<'a> {
    pub cam: &'a Cam,
    /// Angle between neighbouring points, radians.
    pub step: f64,
    /// Points of the profile, the first again at the end.
    pub points: Vec<Point>,
    balls: Vec<Ball>,
    /// The balls in [`PARTS`], in the same order.
    parts: Vec<Ball>,
    /// The arm at every place.
    pub arms: Vec<Arm>,
    /// Maximum distance of the profile from the centre, for the length of a stem.
    reach: f64,
    /// Distance from the trace point along the arm within which no profile is: the radius of the disc, which touches the profile.
    clear: f64,
}

impl<'a> Outline<'a> {
    /// `crosses` tells that the profile crosses itself: then the disc may overlap the cam.
    pub fn of(cam: &'a Cam, samples: &Samples, crosses: bool) -> Self {
        let stride = (samples.stations() / MIN_PLACES).max(1);
        let mut points: Vec<Point> = samples.profile.iter().copied().step_by(stride).collect();
        points.extend(points.first().copied());
        let reach = match cam.follower.body {
            Body::Slide => points.iter().map(Point::norm_sqr).fold(0.0, f64::max).sqrt(),
            Body::Swing { .. } => 0.0,
        };
        let sides = points.len() - 1;
        let balls_of = |count: usize| -> Vec<Ball> {
            (0..sides).step_by(count).map(|first| Ball::of(&points, first..(first + count).min(sides))).collect()
        };
        let (balls, parts) = (balls_of(BLOCK), balls_of(BLOCK / PARTS));
        let clear = if crosses { 0.0 } else { cam.follower.disc_radius() };
        let step = samples.station(stride);
        let mut outline = Self { cam, step, points, balls, parts, arms: Vec::new(), reach, clear };
        let places = samples.pitch.iter().zip(&samples.turns).step_by(stride);
        outline.arms = places.map(|(&trace, &turn)| outline.arm(trace, turn)).collect();
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

    pub fn arm_at(&self, theta: f64) -> Arm {
        let turn = self.cam.in_cam_frame(Point::new(1.0, 0.0), theta);
        self.arm(self.cam.at(theta).1.trace * turn, turn)
    }

    /// The pairs of an arm and a ball that may touch before the arm is nearer to another place, in the order of places; none when the arm is
    /// clear of the cam all along.
    ///
    /// The arms of a group are within the distance that their points move from the arm in its middle. A ball farther from that
    /// arm than this distance and its own radius is clear of all of them.
    pub fn pairs(&self) -> Vec<Pair> {
        let (mut pairs, mut near) = (Vec::new(), Vec::new());
        let n = self.arms.len();
        for first in (0..n).step_by(GROUP) {
            let places = first..(first + GROUP).min(n);
            let middle = self.arms[places.start + places.len() / 2];
            let spread = places.clone().map(|place| middle.moved_to(self.arms[place])).fold(0.0, f64::max);
            let before = std::iter::once((first + n - 1) % n).chain(places.clone());
            let moves = before.map(|place| self.arms[place].moved_to(self.arms[(place + 1) % n]));
            let moved = HALF_WAY * moves.fold(0.0, f64::max);
            near.clear();
            near.extend(self.balls_near(middle, spread + moved));
            if !near.is_empty() {
                for place in places {
                    let beside = Beside::of(self.arms[place], self.clear);
                    let balls = near.iter().filter(|&&ball| beside.is_near(&self.balls[ball], moved));
                    let parts = balls.flat_map(|ball| ball * PARTS..((ball + 1) * PARTS).min(self.parts.len()));
                    let touched = parts.filter(|&part| beside.is_near(&self.parts[part], moved));
                    pairs.extend(touched.map(|part| Pair { place, part, moved }));
                }
            }
        }
        pairs
    }

    /// The balls with a point no farther from the arm than `distance`, and some that are a little farther.
    fn balls_near(&self, arm: Arm, distance: f64) -> impl Iterator<Item = usize> {
        let beside = Beside::of(arm, self.clear);
        let near = move |(_, ball): &(usize, &Ball)| beside.is_near(ball, distance);
        self.balls.iter().enumerate().filter(near).map(|(k, _)| k)
    }

    /// The sides of some pairs.
    pub fn sides_of(&self, pairs: &[Pair]) -> impl Iterator<Item = usize> {
        pairs.iter().flat_map(|pair| self.parts[pair.part].sides.clone())
    }

    /// True for a vertex of the polygon that the arm may touch: its foot lies on the arm, and it lies outside the disc around the trace point.
    pub fn is_beside(&self, arm: Arm, point: Point) -> bool {
        let foot = arm.foot(point);
        0.0 < foot && foot <= 1.0 && (point - arm.from).norm_sqr() >= 0.9 * self.clear * self.clear
    }

    /// True when a point of an arm is farther inside the cam than `depth`, as far as the places measured tell.
    pub fn is_deeper_than(&self, depth: f64, pairs: &[Pair]) -> bool {
        self.cut_places(pairs).into_iter().any(|(place, parts)| self.deepest_of(place, &parts, depth) > depth)
    }

    /// The deepest cut that the polygon shows: measured at some places, refined beside the deepest of them.
    pub fn deepest_cut(&self, pairs: &[Pair]) -> Option<Cut> {
        let mut deepest = 0.0_f64;
        let mut measured: Vec<(usize, f64)> = Vec::new();
        for (place, parts) in self.cut_places(pairs) {
            let depth = self.deepest_of(place, &parts, NEARLY_DEEPEST * deepest);
            deepest = deepest.max(depth);
            measured.push((place, depth));
        }
        measured.retain(|&(_, depth)| depth > NEARLY_DEEPEST * deepest);
        measured.sort_by(|a, b| b.1.total_cmp(&a.1));
        let mut refined: Vec<Cut> = Vec::new();
        let width = MEASURED_EVERY as f64 * self.step;
        for (place, depth) in measured {
            let theta = self.step * place as f64;
            if refined.len() < MAX_REFINED && refined.iter().all(|cut| (cut.place - theta).abs() > 2.0 * width) {
                let on_polygon = |theta: f64| self.depth(self.arm_at(theta));
                let found = golden_maximum(theta - width, theta + width, GOLDEN_STEPS, on_polygon);
                let (at, depth) = if found.1 > depth { found } else { (theta, depth) };
                refined.push(Cut { place: theta, theta: at, depth });
            }
        }
        refined.into_iter().max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// The places at which the arm is cut and measured, with the parts of it inside the cam: the ends of every row of such places, and
    /// some between them.
    fn cut_places(&self, pairs: &[Pair]) -> Vec<(usize, Vec<(f64, f64)>)> {
        let cut = |pairs: &[Pair]| (pairs[0].place, self.parts_inside(self.arms[pairs[0].place], self.sides_of(pairs)));
        let all = pairs.chunk_by(|a, b| a.place == b.place).map(cut).filter(|(_, parts)| !parts.is_empty());
        let mut places: Vec<(usize, Vec<(f64, f64)>)> = all.collect();
        let row: Vec<usize> = places.iter().map(|(place, _)| *place).collect();
        let mut k = 0;
        places.retain(|&(place, _)| {
            let within_row = k > 0 && row[k - 1] + 1 == place && row.get(k + 1) == Some(&(place + 1));
            k += 1;
            !within_row || place.is_multiple_of(MEASURED_EVERY)
        });
        places
    }

    /// Depth of the arm at a place, measured at points of the parts of it inside the cam. One that cannot exceed `enough` is not
    /// computed to the end.
    fn deepest_of(&self, place: usize, parts: &[(f64, f64)], enough: f64) -> f64 {
        let arm = self.arms[place];
        parts.iter().map(|&part| self.deepest_within(arm, part, enough).1).fold(0.0, f64::max)
    }

    /// The deepest of the points of a part, and its depth.
    fn deepest_within(&self, arm: Arm, (enters, leaves): (f64, f64), enough: f64) -> (usize, f64) {
        let part = (leaves - enters) / INNER_POINTS as f64;
        let mut best = (1, 0.0_f64);
        for i in 1..=INNER_POINTS {
            let depth = self.distance(arm.at(enters + part * i as f64), enough.max(best.1));
            if depth > best.1 {
                best = (i, depth);
            }
        }
        best
    }

    /// Maximum distance from the profile of the points of an arm that are inside the cam; 0 when none is.
    fn depth(&self, arm: Arm) -> f64 {
        let sides = self.balls_near(arm, 0.0).flat_map(|ball| self.balls[ball].sides.clone());
        let mut deepest = 0.0_f64;
        for (enters, leaves) in self.parts_inside(arm, sides) {
            let (i, depth) = self.deepest_within(arm, (enters, leaves), 0.0);
            let at = |i: usize| enters + (leaves - enters) / INNER_POINTS as f64 * i as f64;
            let refined =
                golden_maximum(at(i - 1), at(i + 1).min(leaves), GOLDEN_STEPS, |u| self.distance(arm.at(u), 0.0)).1;
            deepest = deepest.max(depth).max(refined);
        }
        deepest
    }

    /// The parts of an arm inside the cam, each from where it enters to where it leaves, as parts of its length.
    fn parts_inside(&self, arm: Arm, sides: impl Iterator<Item = usize>) -> Vec<(f64, f64)> {
        let mut crossings: Vec<(f64, bool)> = sides.filter_map(|k| self.crossing(arm, k)).collect();
        crossings.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let leaves = |k: usize| crossings.get(k + 1).map_or(1.0, |next| next.0);
        let parts = crossings.iter().enumerate().filter(|(_, (_, inwards))| *inwards);
        parts.map(|(k, &(enters, _))| (enters, leaves(k))).collect()
    }

    /// Where an arm crosses a side of the polygon, as a part of the arm, and whether it enters the cam there.
    fn crossing(&self, arm: Arm, side: usize) -> Option<(f64, bool)> {
        let (from, to) = (self.points[side], self.points[side + 1]);
        let along = arm.along();
        let (before, after) = (cross(along, from - arm.from), cross(along, to - arm.from));
        if (before < 0.0) == (after < 0.0) {
            return None;
        }
        let edge = to - from;
        let turning = cross(along, edge);
        let u = cross(from - arm.from, edge) / turning;
        // The profile runs clockwise in the frame of a cam that turns counter-clockwise: the outside is on its left.
        (0.0..=1.0).contains(&u).then_some((u, turning * self.cam.follower.rotation.sigma() > 0.0))
    }

    /// Distance of a point from the polygon. One that cannot exceed `enough` is not computed to the end.
    fn distance(&self, point: Point, enough: f64) -> f64 {
        let mut least = f64::INFINITY;
        for ball in &self.balls {
            let room = ball.radius + least;
            if (ball.centre - point).norm_sqr() >= room * room {
                continue;
            }
            let to_side = |k: usize| Arm { from: self.points[k], to: self.points[k + 1] }.distance_squared(point);
            least = ball.sides.clone().map(to_side).fold(least * least, f64::min).sqrt();
            if least <= enough {
                break;
            }
        }
        least
    }
}

impl Ball {
    fn of(points: &[Point], sides: Range<usize>) -> Self {
        let around = &points[sides.start..=sides.end];
        let centre = around.iter().sum::<Point>() / around.len() as f64;
        let radius = around.iter().map(|point| (point - centre).norm_sqr()).fold(0.0, f64::max).sqrt();
        Self { centre, radius, sides }
    }
}

/// An arm with its direction, for many comparisons.
struct Beside {
    from: Point,
    direction: Point,
    clear: f64,
    length: f64,
}

impl Beside {
    fn of(arm: Arm, clear: f64) -> Self {
        let length = arm.along().norm_sqr().sqrt();
        Self { from: arm.from, direction: arm.along() / length.max(f64::MIN_POSITIVE), clear, length }
    }

    /// False when every point of a ball is farther from the arm than `distance`: compared along the arm and across it.
    fn is_near(&self, ball: &Ball, distance: f64) -> bool {
        let (room, away) = (ball.radius + distance, ball.centre - self.from);
        let along = self.direction.re * away.re + self.direction.im * away.im;
        let across = cross(self.direction, away);
        across.abs() <= room && along >= self.clear - room && along <= self.length + room
    }
}
