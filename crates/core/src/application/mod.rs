//! Applications: what a follower drives, and what comes out of it.
//!
//! Every output is a function of the displacement *s* or of the velocity V that never falls as its argument rises, so that its extremes lie
//! where those of *s* or V lie. To add an application, write one file with a `pub const APPLICATION: Application` and name it in
//! [`APPLICATIONS`].
//!
//! The follower slides: the displacement of one that swings is an angle, and what it drives would need a lever besides.

mod force;
mod piston_force;
mod pump;
mod valve;

use crate::search::root;
use crate::{Cam, Drive, Summary, Svaj};
use std::f64::consts::PI;

/// Every application there is, in the order in which a menu shows them.
pub const APPLICATIONS: &[&Application] =
    &[&force::APPLICATION, &piston_force::APPLICATION, &pump::APPLICATION, &valve::APPLICATION];

/// Most parameters that an application takes.
pub const MAX_APPLICATION_PARAMETERS: usize = 2;

/// An application's parameters, in the order of [`Application::parameters`]; angles in radians.
pub type ApplicationValues = [f64; MAX_APPLICATION_PARAMETERS];

/// Parts of a smooth stretch in which a turning point of *s* is looked for.
const PARTS: usize = 64;

/// What may be measured at a follower, in units that agree with each other: force, and lengths of the design.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Magnitude {
    /// Length.
    Length,
    /// An angle, radians inside.
    Angle,
    /// Length².
    Area,
    /// Length³.
    Volume,
    /// Length³ a second.
    Flow,
    /// Force.
    Force,
    /// Force by length.
    Stiffness,
    /// Force by length².
    Pressure,
    /// Pressure by volume.
    PressurePerVolume,
}

/// Something attached to a follower that slides.
#[derive(Debug)]
pub struct Application {
    /// Its name in design files, such as `pump`.
    pub id: &'static str,
    /// What it takes.
    pub parameters: &'static [Setting],
    /// What comes out, the main one first.
    pub outputs: &'static [Output],
    /// What follows from the parameters alone, and is worth telling.
    pub figures: &'static [Figure],
}

/// A number that an application takes.
#[derive(Debug)]
pub struct Setting {
    /// Its name in design files.
    pub key: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
    /// What it measures.
    pub magnitude: Magnitude,
    /// The value when a design leaves it out.
    pub default: Option<f64>,
}

/// What comes out of an application at each instant.
#[derive(Debug)]
pub struct Output {
    /// Its name in design files and columns.
    pub id: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
    /// What it measures.
    pub magnitude: Magnitude,
    /// What it depends on.
    pub law: OutputLaw,
    /// The same as books write it, of the symbols of parameters and figures, *s* and V.
    pub formula: &'static str,
    /// True for what is drawn in and delivered stroke by stroke, so that the sum of its rises over a cycle is worth telling.
    pub strokes: bool,
}

/// A function that never falls as its argument rises.
#[derive(Clone, Copy, Debug)]
pub enum OutputLaw {
    /// Of the displacement *s*.
    OfDisplacement(fn(&ApplicationValues, f64) -> f64),
    /// Of the velocity V = v·ω.
    OfVelocity(fn(&ApplicationValues, f64) -> f64),
}

/// What follows from the parameters alone.
#[derive(Debug)]
pub struct Figure {
    /// Its name.
    pub id: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
    /// What it measures.
    pub magnitude: Magnitude,
    /// Its value.
    pub of: fn(&ApplicationValues) -> f64,
    /// The same as books write it, of the symbols of parameters and of the figures before it.
    pub formula: &'static str,
}

/// Applications are the entries of [`APPLICATIONS`]: the same name is the same application.
impl PartialEq for Application {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Application {
    /// The application of that name.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static Application> {
        APPLICATIONS.iter().copied().find(|application| application.id == id)
    }
}

impl Output {
    /// Its value for a motion at ω, rad/s, in the [magnitude](Self::magnitude) that it has; V = ω·ds/dθ. The sign is that of *s* or V.
    #[must_use]
    pub fn of(&self, values: &ApplicationValues, motion: Svaj, omega: f64) -> f64 {
        match self.law {
            OutputLaw::OfDisplacement(of) => of(values, motion.s),
            OutputLaw::OfVelocity(of) => of(values, motion.v * omega),
        }
    }

    /// Its least and greatest value, which lie where those of *s* or V lie, since no output falls as its argument rises: value and θ of
    /// each.
    #[must_use]
    pub fn extremes(&self, values: &ApplicationValues, summary: &Summary, omega: f64) -> [(f64, f64); 2] {
        let (found, of, rate) = match self.law {
            OutputLaw::OfDisplacement(of) => (summary.s, of, 1.0),
            OutputLaw::OfVelocity(of) => (summary.v, of, omega),
        };
        [(found.min, found.min_at), (found.max, found.max_at)].map(|(value, at)| (of(values, value * rate), at))
    }

    /// What its rises come to over one cycle (of a cam that travels: forth and back), for an output that works by strokes: Σ (y₂ − y₁)
    /// over every rise of y, from turning point to turning point. None for one that does not.
    #[must_use]
    pub fn per_cycle(&self, values: &ApplicationValues, cam: &Cam) -> Option<f64> {
        let OutputLaw::OfDisplacement(of) = self.law else { return None };
        self.strokes.then(|| rises(cam, |s| of(values, s)))
    }
}

/// The sum of the rises of a function of *s* over one cycle, from turning point to turning point.
fn rises(cam: &Cam, of: impl Fn(f64) -> f64) -> f64 {
    let back_too = cam.follower.drive == Drive::Travels;
    let mut sum = 0.0;
    for stretch in cam.program.stretches().iter().filter(|stretch| !stretch.is_still()) {
        let mut low = (stretch.from, stretch.at(stretch.from));
        let mut climb = |from: f64, to: f64| {
            let gain = of(to) - of(from);
            sum += if back_too { gain.abs() } else { gain.max(0.0) };
        };
        for theta in stretch.places_and_steps(PARTS) {
            let high = (theta, stretch.at(theta));
            if low.1.v * high.1.v < 0.0 {
                let turn = stretch.at(root(low.0, high.0, |theta| stretch.at(theta).v)).s;
                climb(low.1.s, turn);
                climb(turn, high.1.s);
            } else {
                climb(low.1.s, high.1.s);
            }
            low = high;
        }
    }
    sum
}

/// Area of a piston.
fn disc(radius: f64) -> f64 {
    PI * radius * radius
}

/// The radius of a piston.
const PISTON_RADIUS: Setting =
    Setting { key: "piston_radius", symbol: "r", magnitude: Magnitude::Length, default: None };

/// Its area, as books write it.
const PISTON_AREA: &str = "π r^2";

#[cfg(test)]
mod tests;
