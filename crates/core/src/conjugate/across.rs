//! Where a second element lies, across the shaft from the first, and how large its cam is.

use super::Tie;
use crate::extreme::extremes;
use crate::samples::{Quantity, Samples};
use crate::{Body, Cam, Element, Follower, Point};
use std::f64::consts::{FRAC_PI_2, PI};

/// Samples in which the top of the motion is looked for; it is refined between them.
const LOOK_STEPS: usize = 120;

/// A second element placed across the shaft.
pub(super) struct Across<'a> {
    pub cam: &'a Cam,
    /// Greatest displacement of the first.
    pub top: f64,
    /// Radius of the second disc.
    pub radius: f64,
}

impl<'a> Across<'a> {
    /// Across from the element of a cam; its disc has the radius of the first when no other is given.
    pub fn of(cam: &'a Cam, radius: Option<f64>) -> Self {
        let own = |index: usize| radius.unwrap_or(cam.follower.values[index]);
        let top = extremes(cam, &Samples::on_grid(cam, LOOK_STEPS), Quantity::S).max;
        Self { cam, top, radius: radius_index(&cam.follower).map_or(0.0, own) }
    }

    /// The open interval of ties that leave room for a second cam, or nothing for a tie of the wrong kind.
    pub fn bounds(&self, tie: Tie) -> Option<(f64, f64)> {
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
    pub fn place(&self, tie: Tie) -> Option<(f64, Element)> {
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

    /// Rb₂ for an angle ξ₂.
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

    /// ξ₂ with which the second cam has that base radius.
    pub fn opening_for(&self, pivot: Point, element: Element, base_radius: f64) -> f64 {
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

/// Which parameter of a follower is the radius of its disc.
pub(super) fn radius_index(follower: &Follower) -> Option<usize> {
    follower.kind.index_of("roller_radius").or_else(|| follower.kind.index_of("face_radius"))
}

/// How far a point lies along a unit normal.
pub(super) fn along(point: Point, normal: Point) -> f64 {
    point.re * normal.re + point.im * normal.im
}
