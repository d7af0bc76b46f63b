//! The curves of a cam as a drawing has them, in the cam's frame, which is the fixed frame at θ = 0.

use crate::{Shaft, Step, Subject};
use levalab_core::{Analysis, Cam, Closure, Column, Point};
use levalab_format::CamStudy;

/// What a curve is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// What is cut: of a groove, its inner wall.
    Profile,
    /// The outer wall of a groove.
    Outer,
    /// The way of the trace point around the cam.
    Pitch,
    /// Where the follower rests at s = 0.
    Base,
    /// The same for the trace point.
    Prime,
    /// The hole for the shaft.
    Bore,
}

/// How far a cam that travels goes down below its base line, as a part of half its length.
const BODY: f64 = 0.2;

/// A curve of one of the cams.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Curve {
    pub role: Role,
    /// It belongs to the second cam of a pair.
    pub second: bool,
    pub shape: Shape,
}

/// How it runs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Through these points and back to the first.
    Closed(Vec<Point>),
    /// Through these points.
    Open(Vec<Point>),
    /// About the cam's centre.
    Circle(f64),
}

/// The curves of the cams: base and prime circle, pitch curve, profile, those that they have, and the hole for the shaft.
pub(crate) fn curves(subject: &Subject, step: Step, shaft: Option<Shaft>) -> Vec<Curve> {
    let cams = subject.cams().enumerate();
    let mut all: Vec<Curve> = cams.flat_map(|(k, cam)| of_cam(cam, k > 0, step)).collect();
    if let Some(shaft) = shaft {
        all.push(Curve { role: Role::Bore, second: false, shape: Shape::Closed(shaft.outline()) });
    }
    all
}

fn of_cam(cam: &CamStudy, second: bool, step: Step) -> Vec<Curve> {
    let study = cam.with_rows(step.count());
    let (cam, analysis) = (study.cam(), study.analysis());
    let follower = &cam.follower;
    let through = |x, y| shape(cam, analysis, x, y);
    let mut shapes = Vec::new();
    if cam.program.is_cyclic() {
        shapes.push((Role::Base, Some(Shape::Circle(follower.base_radius()))));
    } else {
        let ends = [Point::new(0.0, 0.0), Point::new(cam.program.span(), 0.0)];
        shapes.push((Role::Base, Some(Shape::Open(ends.to_vec()))));
    }
    if follower.disc_radius() > 0.0 {
        let prime = follower.base_radius() + follower.disc_radius();
        shapes.push((Role::Prime, cam.program.is_cyclic().then_some(Shape::Circle(prime))));
        shapes.push((Role::Pitch, through(Column::PitchX, Column::PitchY)));
    }
    if cam.closure == Closure::Groove {
        shapes.push((Role::Outer, through(Column::OuterX, Column::OuterY)));
    }
    shapes.push((Role::Profile, through(Column::X, Column::Y)));
    shapes.into_iter().filter_map(|(role, shape)| Some(Curve { role, second, shape: shape? })).collect()
}

/// A curve through the points of two columns; closed without the last row, which is the first.
fn shape(cam: &Cam, analysis: &Analysis, x: Column, y: Column) -> Option<Shape> {
    let mut points = points(analysis, x, y)?;
    if !cam.program.is_cyclic() {
        return Some(Shape::Open(points));
    }
    points.pop();
    Some(Shape::Closed(points))
}

/// The points of two columns, row by row.
fn points(analysis: &Analysis, x: Column, y: Column) -> Option<Vec<Point>> {
    let (x, y) = (analysis.column(x)?, analysis.column(y)?);
    Some(x.iter().zip(y).map(|(&x, &y)| Point::new(x, y)).collect())
}

impl Curve {
    /// Its points; none of a circle.
    pub fn points(&self) -> &[Point] {
        match &self.shape {
            Shape::Closed(points) | Shape::Open(points) => points,
            Shape::Circle(_) => &[],
        }
    }

    /// The outline of the part that it bounds: what travels has a body below its open profile.
    pub fn part(&self, subject: &Subject) -> Vec<Point> {
        let mut points = self.points().to_vec();
        if let (Shape::Open(_), [first, .., last]) = (&self.shape, self.points()) {
            let foot = -BODY * subject.size();
            points.extend([Point::new(last.re, foot), Point::new(first.re, foot)]);
        }
        points
    }
}

/// How near to the centre the profiles come.
pub(crate) fn room(curves: &[Curve]) -> f64 {
    profile(curves).map(|point| point.norm()).fold(f64::INFINITY, f64::min)
}

/// The points of all profiles.
pub(crate) fn profile(curves: &[Curve]) -> impl Iterator<Item = &Point> {
    curves.iter().filter(|curve| curve.role == Role::Profile).flat_map(Curve::points)
}
