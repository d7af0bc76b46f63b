//! Generic polynomial of degree 5: agrees in *s*, *v* and *a* with both neighbours.

use super::{Group, Law, Shape};

/// s = Σ cₖ·xᵏ with 6 coefficients, half of them fixed by each neighbour.
pub const LAW: Law = Law { id: "polynomial-5", group: Group::Matched, parameters: &[], shape: Shape::Matched(3) };
