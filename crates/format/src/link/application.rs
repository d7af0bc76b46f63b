//! The application of a design in a link: `o`, its letter, the letter of its output when it is not the first, its parameters, `t` when places
//! of targets are times, and the targets: `okb_93.684p0p56.88_110.27`.

use super::reader::Fields;
use super::{Writer, codes};
use crate::application::default_of;
use crate::limits::MAX_TARGETS;
use crate::{ApplicationDesign, TargetsBy};
use levalab_core::application::{Application, MAX_APPLICATION_PARAMETERS};

/// What stands for the outputs of an application, but for the first.
const OUTPUTS: [char; 3] = ['b', 'c', 'd'];

pub(super) fn write(writer: &mut Writer, design: &ApplicationDesign) {
    let text = &mut writer.text;
    text.push('o');
    text.push_str(codes::of_application(design.application));
    if let Some(letter) = design.output.checked_sub(1).and_then(|k| OUTPUTS.get(k)) {
        text.push(*letter);
    }
    writer.values(&design.values, defaults(design.application));
    if design.by == TargetsBy::Time {
        writer.text.push('t');
    }
    for &[at, value] in &design.targets {
        writer.text.push('p');
        writer.number(at);
        if value != 0.0 {
            writer.value(value);
        }
    }
}

/// None when it cannot be read; nothing within when there is none.
pub(super) fn read(fields: &mut Fields) -> Option<Option<ApplicationDesign>> {
    if !fields.take('o') {
        return Some(None);
    }
    let application = codes::application(fields.next()?)?;
    let told = (1..application.outputs.len()).find(|k| OUTPUTS.get(k - 1).is_some_and(|&letter| fields.take(letter)));
    let values: [f64; MAX_APPLICATION_PARAMETERS] = fields.values(defaults(application))?;
    let by = if fields.take('t') { TargetsBy::Time } else { TargetsBy::Theta };
    let mut targets = Vec::new();
    while targets.len() <= MAX_TARGETS && fields.take('p') {
        let at = fields.number()?;
        let [value] = fields.values([Some(0.0)].into_iter())?;
        targets.push([at, value]);
    }
    Some(Some(ApplicationDesign { application, values, output: told.unwrap_or(0), by, targets }))
}

fn defaults(application: &Application) -> impl Iterator<Item = Option<f64>> {
    application.parameters.iter().map(default_of)
}
