//! An application in the design file: read, written and checked.

use super::{ApplicationDesign, TargetsBy};
use crate::check::check_range;
use crate::fields::{Field, Object};
use crate::limits::{MAX_TARGETS, OUTPUT, PROPERTY, SEAT_ANGLE, SIZE, TIME};
use crate::write::number;
use crate::{CamRefusal, DataRefusal, Design, DesignError, Measure, Path};
use levalab_core::Motion;
use levalab_core::application::{APPLICATIONS, MAX_APPLICATION_PARAMETERS, Magnitude, Setting};
use serde_json::Value;

/// The value that a design gives when it leaves a parameter out.
pub(crate) fn default_of(setting: &Setting) -> Option<f64> {
    setting.default.map(|value| if setting.magnitude == Magnitude::Angle { value.to_degrees() } else { value })
}

pub(crate) fn read(object: &Object) -> Result<ApplicationDesign, DesignError> {
    let application = APPLICATIONS[object.word("kind", &ids())?];
    let known: Vec<&'static str> =
        ["kind", "output", "by", "targets"].into_iter().chain(application.parameters.iter().map(|p| p.key)).collect();
    object.only(&known)?;
    let mut values = [0.0; MAX_APPLICATION_PARAMETERS];
    for (value, setting) in values.iter_mut().zip(application.parameters) {
        *value = match (object.optional(setting.key), default_of(setting)) {
            (None, Some(usual)) => usual,
            _ => object.required(setting.key)?.number()?,
        };
    }
    let outputs: Vec<&'static str> = application.outputs.iter().map(|output| output.id).collect();
    let told = |key: &str, words: &[&'static str]| object.optional(key).map_or(Ok(0), |_| object.word(key, words));
    let (output, by) = (told("output", &outputs)?, told("by", &TargetsBy::WORDS)?);
    let each = |list: Field| list.items(MAX_TARGETS)?.map(|item| item.pair()).collect();
    Ok(ApplicationDesign {
        application,
        values,
        output,
        by: if by == 0 { TargetsBy::Theta } else { TargetsBy::Time },
        targets: object.optional("targets").map_or(Ok(Vec::new()), each)?,
    })
}

fn ids() -> Vec<&'static str> {
    APPLICATIONS.iter().map(|application| application.id).collect()
}

/// The fields in a design file; what is as usual is left out, but for parameters.
pub(crate) fn entries(design: &ApplicationDesign) -> Vec<(&'static str, Value)> {
    let ApplicationDesign { application, values, output, by, targets } = design;
    let parameters = application.parameters.iter().zip(values);
    let mut entries: Vec<(&'static str, Value)> = vec![("kind", application.id.into())];
    entries.extend(parameters.map(|(setting, &value)| (setting.key, number(value))));
    if *output > 0 {
        entries.push(("output", design.main().id.into()));
    }
    if *by == TargetsBy::Time {
        entries.push(("by", by.word().into()));
    }
    if !targets.is_empty() {
        let points = targets.iter().map(|&[at, value]| Value::from(vec![number(at), number(value)]));
        entries.push(("targets", points.collect()));
    }
    entries
}

impl Design {
    /// Refuses an application that has no place here, and numbers out of range.
    pub(crate) fn check_application(&self) -> Result<(), DesignError> {
        let Some(ApplicationDesign { application, values, by, targets, .. }) = &self.application else { return Ok(()) };
        if self.follower.motion == Motion::Oscillating {
            return Err(DesignError::at("application", CamRefusal::SwingingApplication));
        }
        let here = |key: &'static str| Path::from(["application", key]);
        for (setting, &value) in application.parameters.iter().zip(values) {
            let (range, measure) = match setting.magnitude {
                Magnitude::Length => (&SIZE, Measure::Length),
                Magnitude::Angle => (&SEAT_ANGLE, Measure::Degrees),
                _ => (&PROPERTY, Measure::Ratio),
            };
            check_range(here(setting.key), value, range, measure)?;
        }
        let (places, measure) = match by {
            TargetsBy::Theta => (0.0..=self.kind.travel().unwrap_or(360.0), self.stride()),
            TargetsBy::Time => (TIME, Measure::Ratio),
        };
        if targets.len() > MAX_TARGETS {
            let problem = DataRefusal::WrongCount { found: targets.len(), min: 0, max: MAX_TARGETS };
            return Err(DesignError::at(here("targets"), problem));
        }
        for (item, &[at, value]) in targets.iter().enumerate() {
            let place = here("targets").join(item);
            check_range(place.join(0), at, &places, measure)?;
            check_range(place.join(1), value, &OUTPUT, Measure::Ratio)?;
        }
        Ok(())
    }
}
