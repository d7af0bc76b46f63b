//! A second cam that comes, or is tied another way.

use crate::digits::clean;
use crate::report::degrees;
use crate::{Conjugate, Design, DesignError, EditRefusal};
use levalab_core::{Tie, angle_between};

/// A second cam tied in a way; without a value, the same one where there is one already, and else one that works.
pub(super) fn change(design: &mut Design, key: &'static str, value: Option<f64>) -> Result<(), DesignError> {
    let tie = match key {
        "distance" => Tie::Distance(0.0),
        "angle" => Tie::Angle(0.0),
        _ => Tie::BaseRadius(0.0),
    };
    let radius = design.conjugate.and_then(|pair| pair.radius);
    if let Some(value) = value {
        design.conjugate = Some(Conjugate { tie: tie.with(value), radius });
        return Ok(());
    }
    if let Some(value) = same(design, tie) {
        design.conjugate = Some(Conjugate { tie: tie.with(clean(value)), radius });
        return Ok(());
    }
    let room = design.room_for_second(tie, radius)?;
    let room = room.ok_or_else(|| DesignError::at("conjugate", EditRefusal::NoSecondCam))?;
    design.conjugate = Some(Conjugate { tie: room.tie, radius });
    Ok(())
}

/// The value with which a tie of another kind makes the second cam that the design has.
fn same(design: &Design, tie: Tie) -> Option<f64> {
    design.conjugate?;
    let first = design.cam().ok()?;
    let second = design.second(&first).ok()??;
    match tie {
        Tie::Distance(_) => None,
        Tie::Angle(_) => angle_between(&first, &second).map(degrees),
        Tie::BaseRadius(_) => Some(second.follower.base_radius()),
    }
}
