//! A design: what a file or a link holds, in the units that people use.

use crate::{ApplicationDesign, CamKind, Conjugate, LengthUnit, Notation, SpeedUnit};
use levalab_core::law::{Data, MAX_LAW_PARAMETERS};
use levalab_core::{FollowerKind, FollowerValues, Law, Motion, Rotation};

/// A cam as it is designed: angles in degrees, lengths in [`length_unit`](Self::length_unit).
///
/// A design that was read from a file or a link has passed every check. One put together by hand is checked by
/// [`Design::cam`].
#[derive(Clone, Debug)]
pub struct Design {
    /// What the user calls it.
    pub title: String,
    /// The unit of all its lengths.
    pub length_unit: LengthUnit,
    /// How fast the cam turns.
    pub speed: Speed,
    /// What kind of cam it is.
    pub kind: CamKind,
    /// The sense in which it turns.
    pub rotation: Rotation,
    /// Rb; 0 for a cam that travels.
    pub base_radius: f64,
    /// What rides on it.
    pub follower: &'static FollowerKind,
    /// The follower's parameters, in the order of [`FollowerKind::parameters`]; angles in degrees.
    pub values: FollowerValues,
    /// The motion program; empty when the kind of cam has one ready-made.
    pub segments: Vec<SegmentDesign>,
    /// The second cam of a conjugate pair.
    pub conjugate: Option<Conjugate>,
    /// What the follower drives.
    pub application: Option<ApplicationDesign>,
    /// Whose symbols it is told in.
    pub notation: Notation,
}

/// The speed of a cam in the unit it was given in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed {
    /// How many.
    pub value: f64,
    /// Of what.
    pub unit: SpeedUnit,
}

/// A segment of the motion program as it is designed.
#[derive(Clone, Debug, PartialEq)]
pub struct SegmentDesign {
    /// How the follower moves.
    pub law: &'static Law,
    /// β, degrees; a length for a cam that travels.
    pub beta: f64,
    /// L: a length, or degrees when the follower swings; negative in a return. 0 when the data of a free law say where it ends.
    pub rise: f64,
    /// The law's own parameters, in the order of [`Law::parameters`]; angles in degrees.
    pub parameters: [f64; MAX_LAW_PARAMETERS],
    /// What a free law is made from: degrees from the segment's start, heights above the base circle in the unit of *s*.
    pub data: Data,
}

impl Design {
    /// ω, rad/s; length per second for a cam that travels.
    #[must_use]
    pub fn omega(&self) -> f64 {
        self.speed.unit.omega(self.speed.value)
    }

    /// True when the follower swings, so that its displacement is an angle.
    #[must_use]
    pub fn is_oscillating(&self) -> bool {
        self.follower.motion == Motion::Oscillating
    }
}

impl PartialEq for Design {
    fn eq(&self, other: &Self) -> bool {
        self.title == other.title
            && self.length_unit == other.length_unit
            && self.speed == other.speed
            && self.kind == other.kind
            && self.rotation == other.rotation
            && self.base_radius == other.base_radius
            && self.follower.id == other.follower.id
            && self.values == other.values
            && self.segments == other.segments
            && self.conjugate == other.conjugate
            && self.application == other.application
            && self.notation == other.notation
    }
}

/// One radian a second.
impl Default for Speed {
    fn default() -> Self {
        Self { value: 1.0, unit: SpeedUnit::default() }
    }
}

/// A follower's motion and contact, the two words of its name: `translating` and `roller`.
#[must_use]
pub fn motion_and_contact(kind: &FollowerKind) -> (&'static str, &'static str) {
    kind.id.split_once('-').unwrap_or((kind.id, ""))
}
