//! The follower at θ = 0, as outlines.

use levalab_core::{Body, Closure, Contact, ContactKind, Element, Point};
use levalab_format::CamStudy;
use std::f64::consts::{PI, TAU};

/// The measure of all thicknesses, as a part of the cam's greatest radius.
const THICKNESS: f64 = 0.05;

/// An outline of the follower or of the frame that carries it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outline {
    /// A part.
    Part(Vec<Point>),
    /// A round part.
    Disc(Point, f64),
    /// Something that does not move.
    Ground(Vec<Point>),
}

/// The outlines of the follower of a pair of cams, or of one, the lowest first; `reach` is the greatest radius of the cams.
pub(crate) fn follower<'a>(cams: impl Iterator<Item = &'a CamStudy>, reach: f64) -> Vec<Outline> {
    let t = THICKNESS * reach;
    let mut all = Vec::new();
    for (k, study) in cams.enumerate() {
        let cam = study.cam();
        let (_, contact) = cam.at(0.0);
        match cam.follower.body() {
            // Of a second cam only what touches is drawn: the rest is the first follower's.
            _ if k > 0 => all.push(element(study, &contact, t)),
            Body::Slide => all.extend(sliding(study, &contact, t)),
            Body::Swing { pivot } => all.extend(swinging(study, &contact, pivot, t)),
        }
        if cam.closure == Closure::Yoke {
            let far = cam.at(PI).1;
            let across = Contact { point: -far.point, trace: -far.trace, normal: -far.normal, ..far };
            all.push(element(study, &across, t));
        }
    }
    all
}

/// What touches the cam, alone.
fn element(study: &CamStudy, contact: &Contact, t: f64) -> Outline {
    let cam = study.cam();
    let Contact { trace, point, normal, .. } = *contact;
    match cam.follower.element() {
        Element::Disc { radius, .. } => Outline::Disc(trace, radius.max(0.1 * t)),
        Element::Face { .. } => {
            let (from, to) = face_range(study);
            let half = from.abs().max(to.abs()) + 1.4 * t;
            plate(point, normal * Point::i(), normal, -half, half, t)
        }
    }
}

fn sliding(study: &CamStudy, contact: &Contact, t: f64) -> Vec<Outline> {
    let cam = study.cam();
    let Contact { trace, point, normal, .. } = *contact;
    let up = |x: f64, y: f64| Point::new(x, y);
    match (cam.follower.element(), cam.follower.kind().contact) {
        (Element::Disc { radius, .. }, ContactKind::Roller) => {
            let half = (0.5 * radius).clamp(0.4 * t, 1.1 * t);
            let mut all = stem(trace, half, trace.im, trace.im + radius + 5.0 * t, t);
            all.push(Outline::Disc(trace, radius));
            all.push(Outline::Disc(trace, 0.35 * half));
            all
        }
        (Element::Disc { radius, .. }, ContactKind::Curved) => {
            let arc = (0.12_f64.max(1.5 * t / radius) + steepest(study)).min(1.3);
            let on_arc = |k: i32| trace + Point::from_polar(radius, -PI / 2.0 + arc * f64::from(k) / 24.0);
            let face: Vec<Point> = (-24..=24).map(on_arc).collect();
            let top = trace.im - radius * arc.cos() + 0.8 * t;
            let lid = [up(face[48].re, top), up(face[0].re, top)];
            let mut all = stem(trace, 0.9 * t, top, top + 5.0 * t, t);
            all.push(Outline::Part(face.into_iter().chain(lid).collect()));
            all
        }
        (Element::Disc { .. }, _) => {
            let half = 0.9 * t;
            let mut all = stem(trace, half, trace.im + 2.2 * half, trace.im + 7.0 * t, t);
            let tip = [trace, trace + up(half, 2.2 * half), trace + up(-half, 2.2 * half)];
            all.push(Outline::Part(tip.to_vec()));
            all
        }
        (Element::Face { .. }, _) => {
            let along = normal * -Point::i();
            // Where the face meets the follower's axis.
            let axis = point - along * (point.re / along.re);
            let (from, to) = face_range(study);
            let (a, b) = ((from / along.re).min(-0.9 * t) - 1.4 * t, (to / along.re).max(0.9 * t) + 1.4 * t);
            let mut all = stem(axis, 0.9 * t, axis.im, axis.im + 6.0 * t, t);
            all.push(plate(axis, along, normal, a, b, t));
            all
        }
    }
}

fn swinging(study: &CamStudy, contact: &Contact, pivot: Point, t: f64) -> Vec<Outline> {
    let cam = study.cam();
    let Contact { trace, point, normal, .. } = *contact;
    let ground = [Point::new(0.0, 0.0), Point::new(1.6 * t, -2.6 * t), Point::new(-1.6 * t, -2.6 * t)];
    let mut all = vec![Outline::Ground(ground.map(|corner| pivot + corner).to_vec())];
    match cam.follower.element() {
        Element::Disc { radius, .. } => {
            let arm = trace - pivot;
            let side = arm / arm.norm() * Point::i() * (0.5 * t);
            all.push(Outline::Part(vec![pivot + side, pivot - side, trace - side, trace + side]));
            all.push(Outline::Disc(trace, radius));
            all.push(Outline::Disc(trace, 0.35 * t.min(radius)));
        }
        Element::Face { .. } => {
            let foot = pivot + normal * ((point - pivot) * normal.conj()).re;
            let along = point - foot;
            let along = if along.norm() > 0.0 { along / along.norm() } else { normal * Point::i() };
            let (_, to) = face_range(study);
            let arm = foot - pivot;
            if arm.norm() > t * 0.1 {
                let side = along * (0.5 * t);
                all.push(Outline::Part(vec![pivot + side, pivot - side, foot - side, foot + side]));
            }
            all.push(plate(foot, along, normal, -t, to + 1.6 * t, t));
        }
    }
    all.push(Outline::Disc(pivot, 0.7 * t));
    all
}

/// Where on the face the contact is, over the turn.
fn face_range(study: &CamStudy) -> (f64, f64) {
    study.analysis().summary.reach.map_or((0.0, 0.0), |reach| (reach.min, reach.max))
}

/// The greatest |φ|, radians: so far to a side the contact of an arc walks.
fn steepest(study: &CamStudy) -> f64 {
    study.analysis().summary.pressure_angle.greatest_size().0
}

/// A stem about the follower's axis, and the guide in which it slides.
fn stem(axis: Point, half: f64, from: f64, to: f64, t: f64) -> Vec<Outline> {
    let rectangle = |left: f64, low: f64, right: f64, high: f64| {
        [(left, low), (right, low), (right, high), (left, high)].map(|(x, y)| Point::new(axis.re + x, y)).to_vec()
    };
    let (inner, outer) = (half + 0.12 * t, half + 2.0 * t);
    let (low, high) = (to - 3.4 * t, to - 0.9 * t);
    vec![
        Outline::Ground(rectangle(-outer, low, -inner, high)),
        Outline::Ground(rectangle(inner, low, outer, high)),
        Outline::Part(rectangle(-half, from, half, to)),
    ]
}

/// A straight face: a plate from `a` to `b` along itself.
fn plate(at: Point, along: Point, normal: Point, a: f64, b: f64, t: f64) -> Outline {
    let (from, to) = (at + along * a, at + along * b);
    Outline::Part(vec![from, to, to + normal * t, from + normal * t])
}

impl Outline {
    /// Points that bound it.
    pub fn corners(&self) -> Vec<Point> {
        match self {
            Self::Part(points) | Self::Ground(points) => points.clone(),
            Self::Disc(centre, radius) => {
                (0..4).map(|k| centre + Point::from_polar(*radius, TAU * f64::from(k) / 4.0)).collect()
            }
        }
    }
}
