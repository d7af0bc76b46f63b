//! What the drawing of the mechanism needs to know once for a cam, besides what it asks for at each instant.

use levalab_core::{Analysis, Body, Cam, Column, Drive, Element, Extremes, Follower};
use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Sizes, places and kinds. Lengths in the unit of the design, angles in degrees.
#[derive(Serialize)]
pub struct Mechanism {
    sense: f64,
    base_radius: f64,
    prime_radius: Option<f64>,
    motion: &'static str,
    contact: &'static str,
    roller_radius: f64,
    eccentricity: f64,
    pivot: Option<[f64; 2]>,
    arm: Option<f64>,
    opening: Option<f64>,
    face_offset: f64,
    face_angle: f64,
    face: Option<[f64; 2]>,
    face_length: Option<f64>,
    reach: f64,
    top: f64,
}

impl Mechanism {
    /// The mechanism of a cam.
    pub fn of(cam: &Cam, analysis: &Analysis) -> Self {
        let follower = &cam.follower;
        let (motion, contact) = levalab_format::motion_and_contact(follower.kind());
        let value = |key: &str| follower.value(key);
        let radius = follower.disc_radius();
        Self {
            sense: follower.rotation().sigma(),
            base_radius: follower.base_radius(),
            prime_radius: (!follower.is_flat()).then_some(follower.base_radius() + radius),
            motion,
            contact,
            roller_radius: radius,
            eccentricity: value("eccentricity").unwrap_or(0.0),
            pivot: match follower.body() {
                Body::Swing { pivot } => Some([pivot.re, pivot.im]),
                Body::Slide => None,
            },
            arm: value("arm"),
            opening: follower.opening().map(f64::to_degrees),
            face_offset: value("face_offset").unwrap_or(0.0),
            face_angle: value("face_angle").unwrap_or(0.0).to_degrees(),
            face: analysis.summary.reach.map(|reach| [reach.min, reach.max]),
            face_length: analysis.summary.face(cam, 0.0).map(|face| face.length),
            reach: reach(cam, analysis),
            top: top(follower, &analysis.summary.s),
        }
    }
}

/// The greatest distance of the contact from the cam's centre, or from where the follower stands over a cam that travels.
fn reach(cam: &Cam, analysis: &Analysis) -> f64 {
    let column = |column: Column| analysis.column(column).unwrap_or_default();
    let (theta, x, y) = (column(Column::Theta), column(Column::X), column(Column::Y));
    let away = match cam.follower.drive() {
        Drive::Turns => 0.0,
        Drive::Travels => 1.0,
    };
    let square = |(x, (y, theta)): (&f64, (&f64, &f64))| {
        let x = x - away * theta;
        x * x + y * y
    };
    x.iter().zip(y.iter().zip(theta)).map(square).fold(0.0, f64::max).sqrt()
}

/// The greatest height of the trace point, or of the point that carries a face, while *s* runs through its range.
fn top(follower: &Follower, s: &Extremes) -> f64 {
    let centre = match follower.element() {
        Element::Disc { centre, .. } => centre,
        Element::Face { point, .. } => return point.im + s.max,
    };
    let [low, high] = follower.reversed().map_or([s.min, s.max], |top| [top - s.max, top - s.min]);
    match follower.body() {
        Body::Slide => centre.im + high,
        Body::Swing { pivot } => {
            // The arm falls from the angle it has at the least s to that at the greatest.
            let arm = centre - pivot;
            let [from, to] = [arm.arg() - high, arm.arg() - low];
            let upright = FRAC_PI_2 + ((from - FRAC_PI_2) / TAU).ceil() * TAU;
            let sine = if upright <= to { 1.0 } else { from.sin().max(to.sin()) };
            pivot.im + arm.norm() * sine
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use levalab_format::Design;

    #[test]
    fn reach_and_top_are_those_of_the_contact_all_along() {
        const EXAMPLES: [&str; 5] = [
            include_str!("../../../examples/9RT.lev.json"),
            include_str!("../../../examples/2RO.lev.json"),
            include_str!("../../../examples/4PO.lev.json"),
            include_str!("../../../examples/8DA.lev.json"),
            include_str!("../../../examples/WEDGE.lev.json"),
        ];
        for text in EXAMPLES {
            let design = Design::from_json(text).expect("an example");
            let first = design.cam().expect("an example");
            let second = design.second(&first).expect("an example");
            for cam in [Some(first), second].into_iter().flatten() {
                let mechanism = Mechanism::of(&cam, &Analysis::of(&cam, 720));
                let around = || (0..=3600).map(|part| cam.at(f64::from(part) * cam.program.span() / 3600.0).1);
                let reach = around().map(|contact| contact.point.norm()).fold(0.0, f64::max);
                assert!(
                    (mechanism.reach - reach).abs() < 1e-4 * reach,
                    "{}: {} {reach}",
                    design.title,
                    mechanism.reach
                );
                if !cam.follower.is_flat() {
                    let top = around().map(|contact| contact.trace.im).fold(f64::NEG_INFINITY, f64::max);
                    assert!(
                        (mechanism.top - top).abs() < 1e-4 * top.abs(),
                        "{}: {} {top}",
                        design.title,
                        mechanism.top
                    );
                }
            }
        }
    }

    #[test]
    fn an_arm_that_passes_upright_is_highest_there() {
        let arm = Follower::oscillating_roller(50.0, 10.0, 90.0, 100.0).expect("a triangle");
        let (Body::Swing { pivot }, Element::Disc { centre, .. }) = (arm.body(), arm.element()) else {
            panic!("an arm with a roller")
        };
        let upright = (centre - pivot).arg() - FRAC_PI_2;
        let range = |min: f64, max: f64| Extremes { min, min_at: 0.0, max, max_at: 0.0 };
        assert!((top(&arm, &range(0.0, 2.0 * upright)) - 90.0).abs() < 1e-12);
        assert!((top(&arm, &range(0.0, 0.0)) - centre.im).abs() < 1e-12);
    }
}
