//! Roller that moves along +y, its axis at eccentricity e to the right of the cam's centre.

use super::place::{ECCENTRICITY, ROLLER_RADIUS, positive, sliding_disc};
use super::{ContactKind, FollowerKind, Motion};

/// tan φ = (v − σe)/(s₀ + s).
pub const KIND: FollowerKind = FollowerKind {
    id: "translating-roller",
    motion: Motion::Translating,
    contact: ContactKind::Roller,
    parameters: &[ROLLER_RADIUS, ECCENTRICITY],
    place: |base_radius, &[radius, eccentricity, ..]| {
        positive(ROLLER_RADIUS.key, radius)?;
        sliding_disc(base_radius, radius, eccentricity)
    },
};
