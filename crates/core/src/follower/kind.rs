//! The list of followers, and what is told of each.

use super::place::Placement;
use super::{
    oscillating_flat, oscillating_roller, translating_curved, translating_flat, translating_knife, translating_roller,
};
use crate::Parameter;

/// Every follower there is, in the order in which a menu shows them.
pub const FOLLOWERS: &[&FollowerKind] = &[
    &translating_roller::KIND,
    &translating_knife::KIND,
    &translating_curved::KIND,
    &translating_flat::KIND,
    &oscillating_roller::KIND,
    &oscillating_flat::KIND,
];

/// Most parameters that a follower takes.
pub const MAX_FOLLOWER_PARAMETERS: usize = 4;

/// A follower's parameters, in the order of [`FollowerKind::parameters`]; angles in radians.
pub type FollowerValues = [f64; MAX_FOLLOWER_PARAMETERS];

/// How the follower moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Along +y.
    Translating,
    /// About a pivot; *s* is an angle.
    Oscillating,
}

/// What touches the cam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactKind {
    /// A roller that turns.
    Roller,
    /// A knife edge.
    Knife,
    /// An arc that slides (mushroom).
    Curved,
    /// A straight face.
    Flat,
}

/// A kind of follower: its name, its parameters and how they place it.
#[derive(Debug)]
pub struct FollowerKind {
    /// Motion and contact in one word, such as `oscillating-roller`.
    pub id: &'static str,
    /// How it moves.
    pub motion: Motion,
    /// What touches.
    pub contact: ContactKind,
    /// What it takes besides the base radius.
    pub parameters: &'static [Parameter],
    pub(super) place: fn(f64, &FollowerValues) -> Placement,
}

/// Followers are the entries of [`FOLLOWERS`]: the same name is the same follower.
impl PartialEq for FollowerKind {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl FollowerKind {
    /// The kind of that name.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static FollowerKind> {
        FOLLOWERS.iter().copied().find(|kind| kind.id == id)
    }

    /// Index of a parameter of that name.
    #[must_use]
    pub fn index_of(&self, key: &str) -> Option<usize> {
        self.parameters.iter().position(|parameter| parameter.key == key)
    }
}
