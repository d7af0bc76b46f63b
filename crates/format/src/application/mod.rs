//! What a design's follower drives, in the units of the design, and the points to hit.

mod file;
mod outcome;

pub(crate) use file::{default_of, entries, read};
pub use outcome::{Outcome, OutputRange, Target};

use levalab_core::application::{Application, ApplicationValues, Magnitude, Output};

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
}
