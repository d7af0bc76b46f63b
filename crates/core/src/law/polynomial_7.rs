//! Generic polynomial of degree 7: agrees in *s*, *v*, *a* and *j* with both neighbours.

use super::{Group, Law, Shape};

/// s = Σ cₖ·xᵏ with 8 coefficients, half of them fixed by each neighbour.
pub const LAW: Law = Law { id: "polynomial-7", group: Group::Matched, parameters: &[], shape: Shape::Matched(4) };
