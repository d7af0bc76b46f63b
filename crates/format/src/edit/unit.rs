//! Other units, and a design to begin with.

use super::{Unit, dwell};
use crate::{CamKind, CamRefusal, Design, DesignError, LengthUnit, Speed, SpeedUnit};
use levalab_core::{FOLLOWERS, Rotation};

/// The base radius and the roller of a new design, in millimetres.
const NEW_MILLIMETRES: [f64; 2] = [40.0, 10.0];

/// The same in inches, in round figures.
const NEW_INCHES: [f64; 2] = [1.6, 0.4];

pub(super) fn convert(design: &mut Design, unit: Unit) -> Result<(), DesignError> {
    *design = match unit {
        Unit::Length(unit) => design.in_unit(unit)?,
        Unit::Speed(unit) => design.in_speed_unit(unit)?,
    };
    Ok(())
}

pub(super) fn relabel(design: &mut Design, unit: Unit) -> Result<(), DesignError> {
    match unit {
        Unit::Length(unit) => *design = design.relabelled(unit),
        Unit::Speed(_) if design.kind.travel().is_some() => {
            return Err(DesignError::at(["speed", "unit"], CamRefusal::Unsuited { kind: design.kind.word() }));
        }
        Unit::Speed(unit) => design.speed.unit = unit,
    }
    Ok(())
}

/// A design to begin with: a radial roller, one dwell, no title, in the units and symbols of the design before.
pub(super) fn begin(design: &mut Design) -> Result<(), DesignError> {
    let [base_radius, roller_radius] = match design.length_unit {
        LengthUnit::Millimetre => NEW_MILLIMETRES,
        LengthUnit::Centimetre => NEW_MILLIMETRES.map(|length| length / 10.0),
        LengthUnit::Metre => NEW_MILLIMETRES.map(|length| length / 1000.0),
        LengthUnit::Inch => NEW_INCHES,
    };
    let unit = match design.speed.unit {
        SpeedUnit::LengthPerSecond => SpeedUnit::default(),
        unit => unit,
    };
    let value = if unit == SpeedUnit::RevolutionsPerMinute { 60.0 } else { 1.0 };
    let follower = FOLLOWERS[0];
    let mut values = [0.0; levalab_core::MAX_FOLLOWER_PARAMETERS];
    values[0] = roller_radius;
    *design = Design {
        title: String::new(),
        length_unit: design.length_unit,
        speed: Speed { value, unit },
        kind: CamKind::Rotating,
        rotation: Rotation::default(),
        base_radius,
        follower,
        values,
        segments: vec![dwell(360.0)],
        conjugate: None,
        application: None,
        notation: design.notation,
    };
    Ok(())
}
