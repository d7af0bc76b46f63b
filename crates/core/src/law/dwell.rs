//! Dwell: the follower rests at the height it has.

use super::{Group, Law, Shape};

/// y = 0.
pub const LAW: Law = Law { id: "dwell", group: Group::Basic, parameters: &[], shape: Shape::Rest };
