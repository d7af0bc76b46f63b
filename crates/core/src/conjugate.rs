//! Conjugate cams: a second element, fixed to the same follower across the shaft, that rides a second cam.

use crate::extreme::extremes;
use crate::samples::{LEAST_STEPS, Quantity, Samples};
use crate::sizing::{geometry_passes, shortfall_of};
use crate::{Body, Cam, Closure, Drive, Element, Follower, GeometryError, GeometryProblem, Point};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// What ties the second element to the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tie {
    /// Distance between the parallel faces, or between the centres of the rollers, of a follower that translates.
    Distance(f64),
    /// Angle between the arms, or between the faces, of one that swings; radians.
    Angle(f64),
    /// Base radius of the second cam, of one that swings: the angle follows from it.
    BaseRadius(f64),
}

impl Tie {
    /// The field that gives it.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Distance(_) => "distance",
            Self::Angle(_) => "angle",
            Self::BaseRadius(_) => "base_radius",
        }
    }

    /// Its value.
    #[must_use]
    pub fn value(self) -> f64 {
        let (Self::Distance(value) | Self::Angle(value) | Self::BaseRadius(value)) = self;
        value
    }

    /// The same kind of tie with another value.
    #[must_use]
    pub fn with(self, value: f64) -> Self {
        match self {
            Self::Distance(_) => Self::Distance(value),
            Self::Angle(_) => Self::Angle(value),
            Self::BaseRadius(_) => Self::BaseRadius(value),
        }
    }
}

/// Samples in which the top of the motion is looked for; it is refined between them.
const LOOK_STEPS: usize = 120;

/// Ties tried over the range that the geometry allows.
const CANDIDATES: usize = 96;

/// Halvings of the gap between a tie that fails and one that passes.
const HALVINGS: usize = 40;

/// How many times the size of the first cam the distance of a second is looked for.
const FARTHEST: f64 = 1000.0;

/// Parts by which the ends of a range are set inside, so that rounding does not put them outside.
const INSIDE: f64 = 1e-9;

/// The second cam of a pair, analysed like any other. Its displacement is its own, from its own base circle: the greatest of
/// the first less that of the first. Its profile is where it is on the shaft, in the frame of the first.
///
/// `radius` is that of the second disc; that of the first when none is given.
///
/// * translating flat: Rb₂ = D − Rb − smax·cos γ;
/// * translating disc: its centre D below the first; Rp₂² = e² + (D − s₀ − smax)²;
/// * oscillating disc: its arm at the angle Γ from the first; Rp₂² = m² + A² − 2mA·cos(Γ − ξ₀ − smax);
/// * oscillating flat: Rb₂ = f + m·sin(Γ − ξ₀ − smax).
///
/// # Errors
/// Says between which values the tie must be, when it leaves no room for a second cam or is of the wrong kind for the follower.
pub fn conjugate(cam: &Cam, tie: Tie, radius: Option<f64>) -> Result<Cam, GeometryError> {
    let follower = &cam.follower;
    let unsuited = GeometryError { key: tie.key(), problem: GeometryProblem::Unsuited };
    if follower.drive == Drive::Travels || follower.reversed.is_some() || cam.closure == Closure::Groove {
        return Err(unsuited);
    }
    if !tie.value().is_finite() {
        return Err(GeometryError { key: tie.key(), problem: GeometryProblem::NotFinite });
    }
    let mut values = follower.values;
    if let (Some(radius), Some(index)) = (radius, radius_index(follower)) {
        if !(radius.is_finite() && radius > 0.0) {
            return Err(GeometryError {
                key: "roller_radius",
                problem: GeometryProblem::NotPositive { found: radius },
            });
        }
        values[index] = radius;
    }
    let across = Across { cam, top: top(cam), radius: radius_index(follower).map_or(0.0, |index| values[index]) };
    let (min, max) = across.bounds(tie).ok_or(unsuited)?;
    let found = tie.value();
    if !(found > min && found < max) {
        return Err(GeometryError { key: tie.key(), problem: GeometryProblem::Outside { found, min, max } });
    }
    let (base_radius, element) = across.place(tie).ok_or(unsuited)?;
    let second = Follower { base_radius, values, reversed: Some(across.top), element, ..*follower };
    Ok(Cam { program: cam.program.reversed(across.top), follower: second, closure: cam.closure })
}

/// The ties of that kind with which the second cam keeps every geometric limit, least and greatest; the greatest distance is
/// infinite. None when no tie does.
///
/// When the ties that pass are not all side by side, the longest run of them is given.
#[must_use]
pub fn working_ties(cam: &Cam, kind: Tie, radius: Option<f64>) -> Option<(f64, f64)> {
    let across = Across {
        cam,
        top: top(cam),
        radius: radius.unwrap_or_else(|| radius_index(&cam.follower).map_or(0.0, |i| cam.follower.values[i])),
    };
    let (low, high) = across.bounds(kind)?;
    let passes = |value: f64| conjugate(cam, kind.with(value), radius).is_ok_and(|second| geometry_passes(&second));
    let edge = |mut inside: f64, mut outside: f64| {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            if passes(middle) { inside = middle } else { outside = middle }
        }
        inside
    };
    if high.is_infinite() {
        let step = cam.size() / CANDIDATES as f64;
        let candidates =
            std::iter::successors(Some(step), |step| Some(step * 1.25)).take_while(|&s| s < FARTHEST * cam.size());
        let mut before = low;
        for distance in candidates.map(|step| low + step) {
            if passes(distance) {
                let least = edge(distance, before);
                return Some((least + INSIDE * least.abs(), f64::INFINITY));
            }
            before = distance;
        }
        return None;
    }
    let mut tried: Vec<f64> = (0..=CANDIDATES).map(|i| low + (high - low) * i as f64 / CANDIDATES as f64).collect();
    if !tried.iter().any(|&value| passes(value)) {
        // A window narrower than a step is found where the limits are passed by least.
        let excess = |value: f64, steps: usize| {
            conjugate(cam, kind.with(value), radius).map_or(f64::INFINITY, |second| shortfall_of(&second, steps))
        };
        let fails: Vec<f64> = tried.iter().map(|&value| excess(value, LOOK_STEPS)).collect();
        let least = (1..CANDIDATES).min_by(|&a, &b| fails[a].total_cmp(&fails[b]))?;
        let best = lowest(tried[least - 1], tried[least + 1], |value| excess(value, LEAST_STEPS));
        tried.insert(tried.partition_point(|&value| value < best), best);
    }
    let passing: Vec<bool> = tried.iter().map(|&value| passes(value)).collect();
    let (mut best, mut start) = (0..0, None);
    for i in 0..=tried.len() {
        match (passing.get(i).copied().unwrap_or(false), start) {
            (true, None) => start = Some(i),
            (false, Some(from)) => {
                if i - from > best.len() {
                    best = from..i;
                }
                start = None;
            }
            _ => {}
        }
    }
    let (first, last) = (best.start, best.end.checked_sub(1)?);
    let least = if first == 0 { tried[0] } else { edge(tried[first], tried[first - 1]) };
    let greatest = if last + 1 == tried.len() { tried[last] } else { edge(tried[last], tried[last + 1]) };
    let inside = INSIDE * (greatest - least).max(INSIDE);
    Some((least + inside, greatest - inside))
}

/// The tie of that kind with which the second cam passes its geometric limits by least: the nearest there is to a pair where none
/// is possible. None when the kind of tie leaves no room at all.
#[must_use]
pub fn nearest_tie(cam: &Cam, kind: Tie, radius: Option<f64>) -> Option<Tie> {
    let own = radius_index(&cam.follower).map_or(0.0, |index| cam.follower.values[index]);
    let (low, high) = Across { cam, top: top(cam), radius: radius.unwrap_or(own) }.bounds(kind)?;
    let excess = |value: f64, steps: usize| {
        conjugate(cam, kind.with(value), radius).map_or(f64::INFINITY, |second| shortfall_of(&second, steps))
    };
    let high = if high.is_finite() { high } else { low + 10.0 * cam.size() };
    let at = |i: usize| low + (high - low) * i as f64 / CANDIDATES as f64;
    let fails: Vec<f64> = (0..=CANDIDATES).map(|i| excess(at(i), LOOK_STEPS)).collect();
    let least = (1..CANDIDATES).min_by(|&a, &b| fails[a].total_cmp(&fails[b]))?;
    let best = lowest(at(least - 1), at(least + 1), |value| excess(value, LEAST_STEPS));
    fails[least].is_finite().then(|| kind.with(best))
}

/// Where `f` is least between two values, by the golden section.
fn lowest(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    for _ in 0..HALVINGS {
        let (left, right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        if f(left) < f(right) { high = right } else { low = left }
    }
    0.5 * (low + high)
}

/// The tie of that kind with which the second base circle is as large as the first; none when it leaves no room, or is of the
/// wrong kind for the follower.
#[must_use]
pub fn balanced_tie(cam: &Cam, kind: Tie) -> Option<Tie> {
    let follower = &cam.follower;
    let radius = radius_index(follower).map_or(0.0, |index| follower.values[index]);
    let across = Across { cam, top: top(cam), radius };
    let (min, max) = across.bounds(kind)?;
    let value = match (follower.body, follower.element, kind) {
        (Body::Slide, Element::Face { normal, point }, _) => {
            along(point, normal) + follower.base_radius + across.top * normal.im
        }
        (Body::Slide, Element::Disc { centre, .. }, _) => 2.0 * centre.im + across.top,
        (Body::Swing { .. }, _, Tie::BaseRadius(_)) => follower.base_radius,
        (Body::Swing { pivot }, element, _) => {
            let opening = across.opening_for(pivot, element, follower.base_radius);
            follower.opening()? + across.top + opening
        }
    };
    (value > min && value < max).then(|| kind.with(value))
}

/// The angle between the arms, or the faces, of a pair that swings; radians.
#[must_use]
pub fn angle_between(first: &Cam, second: &Cam) -> Option<f64> {
    let Body::Swing { pivot } = first.follower.body else { return None };
    let turn = match (first.follower.element, second.follower.element) {
        (Element::Disc { centre: one, .. }, Element::Disc { centre: two, .. }) => (two - pivot) / (one - pivot),
        (Element::Face { normal: one, .. }, Element::Face { normal: two, .. }) => -two / one,
        _ => return None,
    };
    Some(turn.arg().rem_euclid(TAU))
}

/// A second element placed across the shaft.
struct Across<'a> {
    cam: &'a Cam,
    /// Greatest displacement of the first.
    top: f64,
    /// Radius of the second disc.
    radius: f64,
}

impl Across<'_> {
    /// The open interval of ties that leave room for a second cam, or nothing for a tie of the wrong kind.
    fn bounds(&self, tie: Tie) -> Option<(f64, f64)> {
        match (self.cam.follower.body, self.cam.follower.element, tie) {
            (Body::Slide, Element::Face { normal, point }, Tie::Distance(_)) => {
                Some((along(point, normal) + self.top * normal.im, f64::INFINITY))
            }
            (Body::Slide, Element::Disc { centre, .. }, Tie::Distance(_)) => {
                let clear = (self.radius * self.radius - centre.re * centre.re).max(0.0).sqrt();
                Some((centre.im + self.top + clear, f64::INFINITY))
            }
            (Body::Swing { pivot }, element, Tie::Angle(_)) => {
                let first = self.cam.follower.opening()? + self.top;
                let (least, most) = self.openings(pivot, element);
                Some((first + least, first + most))
            }
            (Body::Swing { pivot }, element, Tie::BaseRadius(_)) => {
                let (least, most) = self.openings(pivot, element);
                Some((self.base_radius(pivot, element, least).max(0.0), self.base_radius(pivot, element, most)))
            }
            _ => None,
        }
    }

    /// Base radius of the second cam, and the second element where it is when the follower is at s = 0.
    fn place(&self, tie: Tie) -> Option<(f64, Element)> {
        let follower = &self.cam.follower;
        match (follower.body, follower.element, tie) {
            (Body::Slide, Element::Face { normal, point }, Tie::Distance(distance)) => {
                let support = distance - along(point, normal);
                Some((support - self.top * normal.im, Element::Face { normal: -normal, point: normal * -support }))
            }
            (Body::Slide, Element::Disc { centre, .. }, Tie::Distance(distance)) => {
                let centre = centre - Point::new(0.0, distance);
                let lowest = Point::new(centre.re, centre.im + self.top);
                Some((lowest.norm() - self.radius, Element::Disc { centre, radius: self.radius }))
            }
            (Body::Swing { pivot }, element, Tie::Angle(_) | Tie::BaseRadius(_)) => {
                let first = self.cam.follower.opening()?;
                let opening = match tie {
                    Tie::BaseRadius(radius) => self.opening_for(pivot, element, radius),
                    _ => tie.value() - first - self.top,
                };
                let turn = Point::from_polar(1.0, first + self.top + opening);
                let second = match element {
                    Element::Disc { centre, .. } => {
                        Element::Disc { centre: pivot + (centre - pivot) * turn, radius: self.radius }
                    }
                    Element::Face { normal, point } => {
                        let offset = along(point - pivot, normal);
                        // The first face mirrored in the line of centres, turned with the follower's arms.
                        let normal = normal * turn * -1.0;
                        Element::Face { normal, point: pivot + normal * offset }
                    }
                };
                let base_radius = match tie {
                    Tie::BaseRadius(radius) => radius,
                    _ => self.base_radius(pivot, element, opening),
                };
                Some((base_radius, second))
            }
            _ => None,
        }
    }

    /// Least and greatest ξ₂ (when the follower is at the top): the second cam has a size, and the arm stays on its side, where a swing of
    /// half a turn leaves no room.
    fn openings(&self, pivot: Point, element: Element) -> (f64, f64) {
        let distance = pivot.norm();
        match element {
            Element::Disc { centre, .. } => {
                let arm = (centre - pivot).norm();
                let cosine = (distance * distance + arm * arm - self.radius * self.radius) / (2.0 * distance * arm);
                let clear = if (distance - arm).abs() >= self.radius { 0.0 } else { cosine.clamp(-1.0, 1.0).acos() };
                (clear, (PI - self.top).max(clear))
            }
            Element::Face { normal, point } => {
                let offset = along(point - pivot, normal);
                let least = (-offset / distance).clamp(-1.0, 1.0).asin();
                (least, (FRAC_PI_2 - self.top).max(least))
            }
        }
    }

    fn base_radius(&self, pivot: Point, element: Element, opening: f64) -> f64 {
        let distance = pivot.norm();
        match element {
            Element::Disc { centre, .. } => {
                let arm = (centre - pivot).norm();
                // Law of cosines with the half angle, which keeps its digits.
                let half = (0.5 * opening).sin();
                ((distance - arm).powi(2) + 4.0 * distance * arm * half * half).sqrt() - self.radius
            }
            Element::Face { normal, point } => along(point - pivot, normal) + distance * opening.sin(),
        }
    }

    fn opening_for(&self, pivot: Point, element: Element, base_radius: f64) -> f64 {
        let distance = pivot.norm();
        match element {
            Element::Disc { centre, .. } => {
                let arm = (centre - pivot).norm();
                let prime = base_radius + self.radius;
                let squared = (prime * prime - (distance - arm).powi(2)) / (4.0 * distance * arm);
                2.0 * squared.clamp(0.0, 1.0).sqrt().asin()
            }
            Element::Face { normal, point } => {
                ((base_radius - along(point - pivot, normal)) / distance).clamp(-1.0, 1.0).asin()
            }
        }
    }
}

/// Greatest displacement of the follower.
fn top(cam: &Cam) -> f64 {
    extremes(cam, &Samples::on_grid(cam, LOOK_STEPS), Quantity::S).max
}

fn radius_index(follower: &Follower) -> Option<usize> {
    follower.kind.index_of("roller_radius").or_else(|| follower.kind.index_of("face_radius"))
}

fn along(point: Point, normal: Point) -> f64 {
    point.re * normal.re + point.im * normal.im
}
