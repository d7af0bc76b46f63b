//! What a design's follower drives: its parameters in the units of the design, the points to hit, and what comes of it.

use crate::check::check_range;
use crate::fields::{Field, Object};
use crate::limits::{MAX_TARGETS, OUTPUT, PROPERTY, SEAT_ANGLE, SIZE, TIME};
use crate::report::{Range, column, tidy};
use crate::write::number;
use crate::{CamRefusal, Design, DesignError, LengthUnit, Measure, Path};
use levalab_core::application::{
    APPLICATIONS, Application, ApplicationValues, Figure, MAX_APPLICATION_PARAMETERS, Magnitude, Output, OutputLaw,
    Setting,
};
use levalab_core::{Analysis, Cam, Column, Motion};
use serde_json::Value;
use std::f64::consts::TAU;

/// An application as it is designed: lengths in the unit of the design, angles in degrees, forces in the unit that goes with them.
#[derive(Clone, Debug)]
pub struct ApplicationDesign {
    /// What it is.
    pub application: &'static Application,
    /// Its parameters, in the order of [`Application::parameters`].
    pub values: ApplicationValues,
    /// Which of its outputs the targets are of.
    pub output: usize,
    /// What the places of the targets are.
    pub by: TargetsBy,
    /// Place and value of each point to hit.
    pub targets: Vec<[f64; 2]>,
}

/// What the places of targets are measured in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TargetsBy {
    /// θ in degrees; of a cam that travels, length.
    #[default]
    Theta,
    /// Seconds since θ = 0.
    Time,
}

impl TargetsBy {
    /// The words for them, in the order of a menu.
    pub const WORDS: [&str; 2] = ["theta", "time"];

    /// Its word in design files.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::WORDS[usize::from(self == Self::Time)]
    }
}

impl PartialEq for ApplicationDesign {
    fn eq(&self, other: &Self) -> bool {
        self.application.id == other.application.id
            && self.values == other.values
            && (self.output, self.by) == (other.output, other.by)
            && self.targets == other.targets
    }
}

/// What comes of an application, in the units of the design.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Each output with its extremes.
    pub outputs: Vec<OutputRange>,
    /// What follows from the parameters alone.
    pub figures: Vec<(&'static Figure, f64)>,
    /// What is hit, and what missed.
    pub targets: Vec<Target>,
}

/// An output over the cycle.
#[derive(Clone, Copy, Debug)]
pub struct OutputRange {
    /// Which.
    pub output: &'static Output,
    /// Its least and greatest value, and where.
    pub range: Range,
    /// What a cycle delivers, of an output that works by strokes.
    pub per_cycle: Option<f64>,
    /// The same by second.
    pub per_second: Option<f64>,
}

/// A point to hit, and what is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Where: degrees, or length of a cam that travels.
    pub theta: f64,
    /// When, seconds.
    pub time: f64,
    /// The value to hit.
    pub value: f64,
    /// The value that is there.
    pub found: f64,
    /// What is there less what was to be hit.
    pub error: f64,
}

impl ApplicationDesign {
    /// The output that the targets are of.
    #[must_use]
    pub fn main(&self) -> &'static Output {
        &self.application.outputs[self.output.min(self.application.outputs.len() - 1)]
    }

    /// Its parameters in the units of the core.
    #[must_use]
    pub fn core_values(&self) -> ApplicationValues {
        let mut values = self.values;
        for (value, setting) in values.iter_mut().zip(self.application.parameters) {
            if setting.magnitude == Magnitude::Angle {
                *value = value.to_radians();
            }
        }
        values
    }

    /// What comes of it.
    #[must_use]
    pub fn outcome(&self, design: &Design, cam: &Cam, analysis: &Analysis) -> Outcome {
        let (values, omega) = (self.core_values(), design.omega());
        let range = |output: &'static Output| {
            let [(min, min_at), (max, max_at)] = output.extremes(&values, &analysis.summary, omega);
            let size = min.abs().max(max.abs());
            let [min, max] = [min, max].map(|value| significant(value, size));
            let range = Range { min, min_at: design.place(min_at), max, max_at: design.place(max_at) };
            let per_cycle = output.per_cycle(&values, cam);
            let cycle = cam.program.span() * if cam.program.is_cyclic() { 1.0 } else { 2.0 };
            OutputRange { output, range, per_cycle, per_second: per_cycle.map(|volume| volume * omega / cycle) }
        };
        let outputs: Vec<OutputRange> = self.application.outputs.iter().map(range).collect();
        let main = outputs[self.output.min(outputs.len() - 1)];
        let target = |&[at, value]: &[f64; 2]| {
            let theta = self.core_place(design, cam, at);
            let found = main.told(self.main().of(&values, cam.program.at(theta), omega));
            let time = if self.by == TargetsBy::Time { at } else { tidy(theta / omega) };
            let place = if self.by == TargetsBy::Theta { at } else { design.place(theta) };
            Target { theta: place, time, value, found, error: found - value + 0.0 }
        };
        Outcome {
            figures: self.application.figures.iter().map(|figure| (figure, (figure.of)(&values))).collect(),
            targets: self.targets.iter().map(target).collect(),
            outputs,
        }
    }

    /// An output at every row of an analysis.
    #[must_use]
    pub fn column(&self, design: &Design, analysis: &Analysis, output: &Output) -> Vec<f64> {
        let values = self.core_values();
        let (source, rate, of) = match output.law {
            OutputLaw::OfDisplacement(of) => (Column::S, 1.0, of),
            OutputLaw::OfVelocity(of) => (Column::V, design.omega(), of),
        };
        let rows = column(design, analysis, source).unwrap_or_default();
        rows.into_iter().map(|row| of(&values, row * rate) + 0.0).collect()
    }

    /// Where on the cam a place of a target is. Times go on from cycle to cycle; a cam that travels comes back.
    fn core_place(&self, design: &Design, cam: &Cam, at: f64) -> f64 {
        let span = cam.program.span();
        match (self.by, cam.program.is_cyclic()) {
            (TargetsBy::Theta, true) => at.to_radians() % TAU,
            (TargetsBy::Theta, false) => at,
            (TargetsBy::Time, true) => (at * design.omega()) % span,
            (TargetsBy::Time, false) => {
                let way = (at * design.omega()) % (2.0 * span);
                if way > span { 2.0 * span - way } else { way }
            }
        }
    }
}

impl OutputRange {
    /// One of its values without the rounding that is left of a height that should be zero.
    #[must_use]
    pub fn told(&self, value: f64) -> f64 {
        significant(value, self.range.min.abs().max(self.range.max.abs()))
    }
}

impl Outcome {
    /// The worst miss.
    #[must_use]
    pub fn worst(&self) -> Option<Target> {
        self.targets.iter().copied().max_by(|a, b| a.error.abs().total_cmp(&b.error.abs()))
    }
}

/// What is nothing beside the greatest is rounding of a height that should be zero.
fn significant(value: f64, greatest: f64) -> f64 {
    const NOTHING: f64 = 1e-13;
    if value.abs() <= NOTHING * greatest { 0.0 } else { value }
}

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
            let problem = crate::DataRefusal::WrongCount { found: targets.len(), min: 0, max: MAX_TARGETS };
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

impl LengthUnit {
    /// The unit of a magnitude beside lengths in this unit: newtons, or pounds-force beside inches.
    #[must_use]
    pub fn unit_of(self, magnitude: Magnitude) -> &'static str {
        let of_each: [&'static str; 4] = match magnitude {
            Magnitude::Length => return self.symbol(),
            Magnitude::Angle => return "°",
            Magnitude::Area => ["mm²", "cm²", "m²", "in²"],
            Magnitude::Volume => ["mm³", "cm³", "m³", "in³"],
            Magnitude::Flow => ["mm³/s", "cm³/s", "m³/s", "in³/s"],
            Magnitude::Force => ["N", "N", "N", "lbf"],
            Magnitude::Stiffness => ["N/mm", "N/cm", "N/m", "lbf/in"],
            Magnitude::Pressure => ["MPa", "N/cm²", "Pa", "psi"],
            Magnitude::PressurePerVolume => ["MPa/mm³", "N/cm⁵", "Pa/m³", "psi/in³"],
        };
        of_each[self as usize]
    }
}
