//! The hole for the shaft.

use crate::{Refusal, Subject};
use levalab_core::Point;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Straight pieces of a bore: their chords pass within a thousandth of its radius.
const PIECES: usize = 72;

/// A bore about the cam's centre, and its keyway. Lengths in the unit of the design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    /// Diameter of the bore.
    pub bore: f64,
    /// A slot in its wall, which points where the follower is at θ = 0.
    pub keyway: Option<Keyway>,
}

/// The slot of a parallel key in a hub.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyway {
    /// Across the slot.
    pub width: f64,
    /// From the wall of the bore to the bottom of the slot.
    pub depth: f64,
}

impl Shaft {
    /// A bore and a keyway that can be cut into a cam whose profile comes to `room` of its centre.
    ///
    /// # Errors
    /// When a measure is not positive, the keyway is wider than the bore, or there is no room.
    pub fn check(&self, subject: &Subject, room: f64) -> Result<(), Refusal> {
        if subject.travels() {
            return Err(Refusal::NoShaft);
        }
        positive("bore", self.bore)?;
        let radius = self.bore / 2.0;
        let mut reach = radius;
        if let Some(Keyway { width, depth }) = self.keyway {
            positive("keyway", width)?;
            positive("keyway", depth)?;
            if width >= self.bore {
                return Err(Refusal::KeywayTooWide {
                    found: width,
                    bore: self.bore,
                    unit: subject.design().length_unit,
                });
            }
            reach = (width / 2.0).hypot(radius + depth);
        }
        if reach < room { Ok(()) } else { Err(Refusal::NoRoom { reach, room, unit: subject.design().length_unit }) }
    }

    /// Its outline, counter-clockwise.
    #[must_use]
    pub fn outline(&self) -> Vec<Point> {
        let radius = self.bore / 2.0;
        let (side, slot) = match self.keyway {
            Some(Keyway { width, depth }) => {
                let half = width / 2.0;
                ((half / radius).asin(), vec![Point::new(half, radius + depth), Point::new(-half, radius + depth)])
            }
            None => (0.0, Vec::new()),
        };
        let around = TAU - 2.0 * side;
        let last = if slot.is_empty() { PIECES } else { PIECES + 1 };
        let arc = (0..last).map(|k| Point::from_polar(radius, FRAC_PI_2 + side + around * k as f64 / PIECES as f64));
        arc.chain(slot).collect()
    }
}

/// Refuses what is not a positive finite number.
pub(crate) fn positive(what: &'static str, found: f64) -> Result<(), Refusal> {
    if found.is_finite() && found > 0.0 { Ok(()) } else { Err(Refusal::NotPositive { what, found }) }
}
