//! Knife edge that moves along +y: the pitch curve is the profile.

use super::place::{ECCENTRICITY, sliding_disc};
use super::{ContactKind, FollowerKind, Motion};

/// A disc of radius 0.
pub const KIND: FollowerKind = FollowerKind {
    id: "translating-knife",
    motion: Motion::Translating,
    contact: ContactKind::Knife,
    parameters: &[ECCENTRICITY],
    place: |base_radius, &[eccentricity, ..]| sliding_disc(base_radius, 0.0, eccentricity),
};
