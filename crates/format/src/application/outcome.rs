//! What comes of an application: its outputs over the cycle, and how near the points to hit they come.

use super::{ApplicationDesign, TargetsBy};
use crate::Design;
use crate::report::{Range, column, tidy};
use levalab_core::application::{Figure, Output, OutputLaw};
use levalab_core::{Analysis, Cam, Column};
use std::f64::consts::TAU;

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

/// The place of a target by both measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// Where: degrees, or length of a cam that travels.
    pub theta: f64,
    /// When, seconds.
    pub time: f64,
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
            let Place { theta, time } = self.place(design, cam, at);
            Target { theta, time, value, found, error: found - value + 0.0 }
        };
        Outcome {
            figures: self.application.figures.iter().map(|figure| (figure, (figure.of)(&values))).collect(),
            targets: self.targets.iter().map(target).collect(),
            outputs,
        }
    }

    /// Where and when each target is.
    pub(crate) fn places(&self, design: &Design, cam: &Cam) -> Vec<Place> {
        self.targets.iter().map(|&[at, _]| self.place(design, cam, at)).collect()
    }

    fn place(&self, design: &Design, cam: &Cam, at: f64) -> Place {
        let theta = self.core_place(design, cam, at);
        Place {
            theta: if self.by == TargetsBy::Theta { at } else { design.place(theta) },
            time: if self.by == TargetsBy::Time { at } else { tidy(theta / design.omega()) },
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
