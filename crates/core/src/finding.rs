//! What a cam can be blamed for, and how badly.

use crate::Closure;
use std::cmp::Ordering;

/// The verdict on a cam.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Green: *s*, *v*, *a* and *j* continuous, nothing out of limits.
    Acceptable,
    /// Amber: the same, but *j* jumps.
    LowSpeed,
    /// Red: everything else.
    Unacceptable,
}

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FindingKind {
    /// A derivative of the displacement jumps; the order is 0 for *s* to 3 for *j*.
    Jump(u8),
    /// |φ| above the limit.
    PressureAngle,
    /// The profile comes to a point: ρ = 0.
    Cusp,
    /// The roller cuts away profile that it needs: 0 < ρp < Rf.
    Undercut,
    /// The same on the outer wall of a groove, where the pitch curve is hollow: −Rf < ρp < 0.
    GrooveUndercut,
    /// A flat face cannot follow a hollow: ρ < 0.
    ConcaveFlat,
    /// The data of a free law hardly determine its curve.
    Doubtful,
    /// A bound on work was reached before the extremes were proved; the lowest order concerned is 0 for *s* to 3 for *j*.
    NotProved(u8),
    /// The follower goes below the base circle: s < 0.
    BelowBase,
    /// The profile crosses itself away from any cusp.
    SelfCrossing,
    /// The arm or stem of the follower cuts through the cam; never that of a grooved cam, which runs above the face.
    ArmCutsCam,
    /// The cam sweeps over the pivot, which stands beside it. A grooved cam reaches at least to the outer wall of its groove; its arm
    /// runs above the face, but the pivot that carries the arm does not stand on the cam.
    PivotInsideCam,
    /// A swinging face turns with the cam as fast as the cam itself, so that the contact runs away.
    FaceOvertaken,
    /// The contact passes the pivot of a swinging face.
    ContactPastPivot,
}

/// Something wrong with a cam: what, where, how much, and the limit. Angles in radians.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What is wrong.
    pub kind: FindingKind,
    /// How bad it is in this cam.
    pub level: Level,
    /// Where it is worst.
    pub theta: f64,
    /// Where it begins and ends, when it is a stretch; the end is beyond 2π when it passes through 0.
    pub interval: Option<(f64, f64)>,
    /// All the places, when there are several.
    pub places: Vec<f64>,
    /// How much: the greatest jump, the worst |φ|, the least ρ, the lowest *s*, the depth of a cut.
    pub value: f64,
    /// The limit it passes.
    pub limit: f64,
}

/// Findings of the same severity whose places differ by less than this (radians, or length) keep the order of their kinds.
const SAME_PLACE: f64 = 1e-6;

impl Finding {
    /// The order in which findings are reported: by severity, the gravest first, and then by θ.
    #[must_use]
    pub fn gravest_first(&self, other: &Self) -> Ordering {
        // Rounded, since a tolerance between two of them would not be transitive.
        let place = |finding: &Self| (finding.theta / SAME_PLACE).round();
        other.level.cmp(&self.level).then(place(self).total_cmp(&place(other)))
    }
}

impl FindingKind {
    /// True when the motion is to blame, whatever the geometry.
    #[must_use]
    pub fn is_of_the_motion(self) -> bool {
        matches!(self, Self::Jump(_) | Self::BelowBase | Self::Doubtful | Self::NotProved(_))
    }

    /// How bad it is in a cam closed in that way: a jump of *j*, or what is not proved, only forbids high
    /// speed, all else is red. A yoke tolerates jumps
    /// of *a* and *j*: the two halves of its program mirror each other, so few programs are without, and it never loses contact.
    #[must_use]
    pub fn severity(self, closure: Closure) -> Level {
        match self {
            Self::Jump(2 | 3) if closure == Closure::Yoke => Level::Acceptable,
            Self::Jump(3) | Self::NotProved(_) => Level::LowSpeed,
            _ => Level::Unacceptable,
        }
    }
}
