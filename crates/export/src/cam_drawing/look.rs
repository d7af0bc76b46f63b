//! The look of the lines, the same as on the page.

use crate::curves::{Curve, Role};

/// Width of a visible outline, mm (ISO 128); other lines are half as wide.
pub(super) const OUTLINE: f64 = 0.5;

/// The outline of the second cam of a pair.
const SECOND: &str = "#8a5300";

/// The colour of a line and its dashes, mm.
fn look(role: Role) -> (&'static str, &'static str) {
    match role {
        Role::Profile | Role::Outer | Role::Bore => ("#2b3238", ""),
        Role::Pitch => ("#0068a4", "1 1"),
        Role::Base => ("#6a737b", "2.4 1.3"),
        Role::Prime => ("#8a6d3b", "3.7 1 0.7 1"),
    }
}

/// The attributes that draw a curve.
pub(super) fn stroke(curve: &Curve) -> String {
    let (colour, dash) = look(curve.role);
    if dash.is_empty() {
        let colour = if curve.second { SECOND } else { colour };
        return format!("stroke=\"{colour}\" stroke-width=\"{OUTLINE}\"");
    }
    format!("stroke=\"{colour}\" stroke-width=\"{}\" stroke-dasharray=\"{dash}\"", OUTLINE / 2.0)
}

/// What a style sheet calls a line.
pub(super) fn class(role: Role) -> &'static str {
    match role {
        Role::Profile => "profile",
        Role::Outer => "outer-wall",
        Role::Pitch => "pitch-curve",
        Role::Base => "base-circle",
        Role::Prime => "prime-circle",
        Role::Bore => "bore",
    }
}
