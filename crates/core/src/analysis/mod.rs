//! Everything there is to say about a cam.

mod column;
mod hollow;
mod judgement;
mod summary;

pub use column::Column;
pub(crate) use judgement::finding;
pub use summary::{Face, Summary};

use crate::samples::Samples;
use crate::{Cam, Finding, Joint, Level};
use column::tabulate;
use hollow::inflections;
use judgement::judge;
use summary::summarise;

/// A cam analysed.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// Extremes over the turn.
    pub summary: Summary,
    /// θ of every inflection of the profile, where it passes from convex to hollow or back, in order; none under a flat face, which needs ρ > 0.
    pub inflections: Vec<f64>,
    /// Every joint, the one at θ = 0 first.
    pub joints: Vec<Joint>,
    /// The findings, sorted by [`Finding::gravest_first`].
    pub findings: Vec<Finding>,
    /// The verdict.
    pub level: Level,
    columns: Vec<Vec<f64>>,
}

impl Analysis {
    /// Analyses a cam at `steps` equal steps over the turn: `steps` + 1 rows, the last repeating the first, a row on a joint
    /// holding the limits from the right. At least one step is taken.
    ///
    /// The summary and the verdict are exact whatever `steps` is.
    #[must_use]
    pub fn of(cam: &Cam, steps: usize) -> Self {
        let steps = steps.max(1);
        let samples = Samples::of(cam, steps);
        let inflections = inflections(cam, &samples);
        let summary = summarise(cam, &samples, &inflections);
        let joints = cam.program.classified_joints();
        let findings = judge(cam, &samples, &summary, &joints);
        let level = findings.iter().map(|finding| finding.level).max().unwrap_or(Level::Acceptable);
        Self {
            columns: tabulate(cam, &samples, steps),
            summary,
            inflections: inflections.places,
            joints,
            findings,
            level,
        }
    }

    /// True when an analysis of the cam finds nothing but what is of the motion.
    pub(crate) fn geometry_passes(cam: &Cam) -> bool {
        let samples = Samples::of(cam, 1);
        let summary = summarise(cam, &samples, &inflections(cam, &samples));
        judgement::geometry_passes(cam, &samples, &summary)
    }

    /// A column, or nothing when it does not apply to this follower.
    #[must_use]
    pub fn column(&self, column: Column) -> Option<&[f64]> {
        let values = &self.columns[column as usize];
        (!values.is_empty()).then_some(values)
    }
}
