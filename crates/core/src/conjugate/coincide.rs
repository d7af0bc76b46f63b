//! Whether both cams of a pair have one profile.

use crate::{Cam, Point};
use std::f64::consts::TAU;

/// Points of the second profile that are compared with the first one.
const POINTS: usize = 120;

/// Chords of the first profile, which a point may lie on.
const CHORDS: usize = 2_880;

/// Two profiles closer than this part of the size of the cam are one: a chord as long as 1/2,880 of a turn bulges less than 10⁻⁶ of it, and no
/// cam is cut more exactly.
const SAME: f64 = 1e-5;

/// True when the profiles of both cams of a pair coincide on the shaft: a single cam with two elements does what the pair does.
#[must_use]
pub fn profiles_coincide(first: &Cam, second: &Cam) -> bool {
    let point = |cam: &Cam, k: usize, count: usize| {
        let theta = TAU * k as f64 / count as f64;
        cam.in_cam_frame(cam.at(theta).1.point, theta)
    };
    let outline: Vec<Point> = (0..=CHORDS).map(|k| point(first, k, CHORDS)).collect();
    let near = SAME * first.size();
    (0..POINTS).all(|k| {
        let point = point(second, k, POINTS);
        outline.windows(2).any(|chord| distance(point, chord[0], chord[1]) <= near)
    })
}

/// The distance of a point from a chord.
fn distance(point: Point, from: Point, to: Point) -> f64 {
    let (along, off) = (to - from, point - from);
    let length = along.norm_sqr();
    let part = if length > 0.0 { ((off.re * along.re + off.im * along.im) / length).clamp(0.0, 1.0) } else { 0.0 };
    (off - along * part).norm()
}
