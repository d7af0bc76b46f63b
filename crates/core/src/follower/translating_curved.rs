//! Curved (mushroom) face that moves along +y: an arc that slides instead of rolling.
//!
//! The centre of the arc lies on the axis at e; e = 0 is the symmetric mushroom, any other the asymmetric one.

use super::place::{ECCENTRICITY, FACE_RADIUS, positive, sliding_disc};
use super::{ContactKind, FollowerKind, Motion};

/// Same profile as a roller of that radius; the difference is that it slides.
pub const KIND: FollowerKind = FollowerKind {
    id: "translating-curved",
    motion: Motion::Translating,
    contact: ContactKind::Curved,
    parameters: &[FACE_RADIUS, ECCENTRICITY],
    place: |base_radius, &[radius, eccentricity, ..]| {
        positive(FACE_RADIUS.key, radius)?;
        sliding_disc(base_radius, radius, eccentricity)
    },
};
