//! A design with everything that follows from it: the one thing that page, command, exports and worked solution ask.

use crate::compare::Figures;
use crate::report::{self, Report};
use crate::{CureJob, Design, DesignCure, DesignError, MotionUnits, Notation, Outcome};
use levalab_core::{Analysis, Cam, Column, Level};
use serde_json::Value;
use std::sync::Arc;

/// A good design, its cam (or the two cams of a conjugate pair), and the analysis of each.
///
/// What `Study::of` returns is checked: every question about it has an answer.
#[derive(Clone, Debug)]
pub struct Study {
    first: CamStudy,
    second: Option<CamStudy>,
}

/// One cam of a design with its analysis, in radians, and its report, in the units of the design.
#[derive(Clone, Debug)]
pub struct CamStudy {
    design: Arc<Design>,
    cam: Cam,
    analysis: Analysis,
    report: Report,
}

/// Rows of an analysis of which only extremes, joints and findings are asked: these are exact with any number of rows.
const FEWEST_ROWS: usize = 1;

impl Study {
    /// Studies a design; the columns have `rows` + 1 values.
    ///
    /// # Errors
    /// Returns an error if the design is no cam.
    pub fn of(design: Design, rows: usize) -> Result<Self, DesignError> {
        let (first, second) = design.cams()?;
        Ok(Self::of_cams(design, first, second, rows))
    }

    /// Studies a design that is being worked on, in its canonical form.
    ///
    /// # Errors
    /// Returns an error if the design is no cam.
    pub fn of_draft(draft: Design, rows: usize) -> Result<Self, DesignError> {
        let (design, first, second) = draft.with_cams()?;
        Ok(Self::of_cams(design, first, second, rows))
    }

    /// Studies the design in an object of the shape of a design file.
    ///
    /// # Errors
    /// As [`Design::from_value`].
    pub fn open(value: &Value, rows: usize) -> Result<Self, DesignError> {
        let (design, first, second) = Design::open(value)?;
        Ok(Self::of_cams(design, first, second, rows))
    }

    /// Studies the design in the bytes of a design file.
    ///
    /// # Errors
    /// As [`Design::from_bytes`].
    pub fn from_bytes(bytes: &[u8], rows: usize) -> Result<Self, DesignError> {
        let (design, first, second) = Design::open_bytes(bytes)?;
        Ok(Self::of_cams(design, first, second, rows))
    }

    fn of_cams(design: Design, first: Cam, second: Option<Cam>, rows: usize) -> Self {
        let design = Arc::new(design);
        let studied = |cam: Cam| CamStudy::of(Arc::clone(&design), cam, rows);
        Self { second: second.map(studied), first: studied(first) }
    }

    /// The same study with the symbols of another notation.
    #[must_use]
    pub fn in_notation(self, notation: Notation) -> Self {
        let design = Arc::new(Design { notation, ..Design::clone(&self.first.design) });
        let renamed = |cam: CamStudy| CamStudy { design: Arc::clone(&design), ..cam };
        Self { second: self.second.map(renamed), first: renamed(self.first) }
    }

    /// Studies a design for its extremes, joints, findings and cures, which need no columns.
    ///
    /// # Errors
    /// Returns an error if the design is no cam.
    pub fn without_columns(design: Design) -> Result<Self, DesignError> {
        Self::of(design, FEWEST_ROWS)
    }

    /// The design.
    #[must_use]
    pub fn design(&self) -> &Design {
        self.first.design()
    }

    /// The cam of the design; of a conjugate pair, the first one.
    #[must_use]
    pub fn first(&self) -> &CamStudy {
        &self.first
    }

    /// The second cam of a conjugate pair.
    #[must_use]
    pub fn second(&self) -> Option<&CamStudy> {
        self.second.as_ref()
    }

    /// The first cam, and the second one of a conjugate pair.
    pub fn cams(&self) -> impl Iterator<Item = &CamStudy> {
        [&self.first].into_iter().chain(&self.second)
    }

    /// The worse verdict of its cams.
    #[must_use]
    pub fn level(&self) -> Level {
        self.cams().map(|cam| cam.report.level).max().unwrap_or(self.first.report.level)
    }

    /// Number of segments of the motion program, also of a ready-made motion.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.first.cam.program.given().len()
    }

    /// The figures by which designs are compared.
    #[must_use]
    pub fn figures(&self) -> Figures {
        Figures::of(self)
    }

    /// The outputs, figures and targets of the application; `None` if the design has no application.
    #[must_use]
    pub fn outcome(&self) -> Option<Outcome> {
        let CamStudy { design, cam, analysis, .. } = &self.first;
        design.application.as_ref().map(|application| application.outcome(design, cam, analysis))
    }
}

impl CamStudy {
    fn of(design: Arc<Design>, cam: Cam, rows: usize) -> Self {
        let analysis = Analysis::of(&cam, rows);
        let report = Report::of(&design, &cam, &analysis);
        Self { design, cam, analysis, report }
    }

    /// The design that the cam belongs to.
    #[must_use]
    pub fn design(&self) -> &Design {
        &self.design
    }

    /// The cam, in radians.
    #[must_use]
    pub fn cam(&self) -> &Cam {
        &self.cam
    }

    /// The analysis, in radians.
    #[must_use]
    pub fn analysis(&self) -> &Analysis {
        &self.analysis
    }

    /// The report, in the units of the design.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The units of its displacement and derivatives.
    #[must_use]
    pub fn units(&self) -> MotionUnits {
        MotionUnits::of(&self.design)
    }

    /// The same cam with columns of `rows` + 1 values.
    #[must_use]
    pub fn with_rows(&self, rows: usize) -> Self {
        Self::of(Arc::clone(&self.design), self.cam.clone(), rows)
    }

    /// A column in the units of the design; `None` if it does not apply to the follower.
    #[must_use]
    pub fn column(&self, column: Column) -> Option<Vec<f64>> {
        report::column(&self.design, &self.analysis, column)
    }

    /// Every column that applies, with its name, in the order of reports.
    #[must_use]
    pub fn columns(&self) -> Vec<(&'static str, Vec<f64>)> {
        report::columns(&self.design, &self.analysis)
    }

    /// The cures of each finding, in the order of the findings, the best cure first.
    #[must_use]
    pub fn cures(&self) -> Vec<Vec<DesignCure>> {
        crate::cures(&self.design, &self.cam, &self.analysis)
    }

    /// Goes on with a search for the cures, as [`CamStudy::cures`] gives them. The budget is the number of looks at a cam that this part
    /// may take. Returns `None` while the search is not done.
    #[must_use]
    pub fn step_cures(&self, job: &mut CureJob, budget: usize) -> Option<Vec<Vec<DesignCure>>> {
        job.step(&self.design, &self.cam, &self.analysis, budget)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{EXAMPLES, example};

    #[test]
    fn a_study_says_of_every_example_what_its_parts_say() {
        for (name, _) in EXAMPLES {
            let design = example(name).expect(name);
            let study = Study::of(design.clone(), 36).expect(name);
            let cam = design.cam().expect(name);
            let analysis = Analysis::of(&cam, 36);
            assert_eq!(study.first().report(), &Report::of(&design, &cam, &analysis), "{name}");
            assert_eq!(study.first().columns(), report::columns(&design, &analysis), "{name}");
            assert_eq!(study.second().is_some(), design.second(&cam).expect(name).is_some(), "{name}");
            assert_eq!(study.outcome().is_some(), design.application.is_some(), "{name}");
        }
    }

    #[test]
    fn the_report_does_not_depend_on_the_rows() {
        let study = Study::without_columns(example("2RO").expect("2RO")).expect("a cam");
        let finer = study.first().with_rows(720);
        assert_eq!(finer.report(), study.first().report());
        assert_eq!(finer.column(Column::S).map(|values| values.len()), Some(721));
    }

    #[test]
    fn a_design_that_is_no_cam_has_no_study() {
        let mut design = example("9RT").expect("9RT");
        design.segments.pop();
        assert_eq!(Study::without_columns(design.clone()).err(), design.cam().err());
    }
}
