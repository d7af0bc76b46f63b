//! What the follower drives, and by what its targets are placed.

use crate::application::{TargetsBy, default_of};
use crate::digits::{clean, round};
use crate::{ApplicationDesign, CamKind, Design, DesignError, EditRefusal};
use levalab_core::application::{Application, MAX_APPLICATION_PARAMETERS, Setting};

/// What has no natural size begins with this.
const FIRST: f64 = 10.0;

/// Lengths of a new application as shares of the base radius.
const SHARES: [(&str, f64); 2] = [("piston_radius", 0.3), ("seat_diameter", 0.8)];

/// What stands for the base radius of a cam that travels, as a share of its length.
const OF_LENGTH: f64 = 0.25;

/// Another application. Parameters that both have are kept; so are points to hit, where the main output is the same.
pub(super) fn change(design: &mut Design, kind: Option<&'static Application>) -> Result<(), DesignError> {
    let Some(application) = kind else {
        design.application = None;
        return Ok(());
    };
    let old = design.application.take();
    let mut values = [0.0; MAX_APPLICATION_PARAMETERS];
    for (value, setting) in values.iter_mut().zip(application.parameters) {
        let kept = old.as_ref().and_then(|old| {
            let index = old.application.parameters.iter().position(|other| other.key == setting.key)?;
            Some(old.values[index])
        });
        *value = kept.unwrap_or_else(|| first(design, setting));
    }
    let main = |application: &Application| application.outputs.first().map(|output| output.id);
    let same = old.filter(|old| old.output == 0 && main(old.application) == main(application));
    let (by, targets) = same.map_or((TargetsBy::default(), Vec::new()), |old| (old.by, old.targets));
    design.application = Some(ApplicationDesign { application, values, output: 0, by, targets });
    Ok(())
}

fn first(design: &Design, setting: &Setting) -> f64 {
    if let Some(usual) = default_of(setting) {
        return usual;
    }
    let size = match design.kind {
        CamKind::Translating { length } => OF_LENGTH * length,
        _ => design.base_radius,
    };
    let share = SHARES.iter().find(|(key, _)| *key == setting.key);
    share.map_or(FIRST, |(_, share)| round(size * share, 1, f64::round))
}

/// The same points by the other measure of their places.
pub(super) fn measure_by(design: &mut Design, by: TargetsBy) -> Result<(), DesignError> {
    let Some(application) = &design.application else {
        return Err(DesignError::at("application", EditRefusal::NoApplication));
    };
    if application.by == by {
        return Ok(());
    }
    let mut after = application.clone();
    if !after.targets.is_empty() {
        let cam = design.cam()?;
        for (target, place) in after.targets.iter_mut().zip(application.places(design, &cam)) {
            target[0] = clean(if by == TargetsBy::Time { place.time } else { place.theta });
        }
    }
    after.by = by;
    design.application = Some(after);
    Ok(())
}
