//! The current cam: checked, analysed, and asked about until the next good one takes its place.

use crate::instant;
use crate::report::{PageReport, of_both, told_cures};
use levalab_core::{Column, Svaj};
use levalab_edge::{Failure, language, object};
use levalab_format::report::scale_of;
use levalab_format::{CamStudy, CureJob, Design, Outline, Study, clean};
use plotters::style::RGBColor;
use serde::Serialize;
use std::rc::Rc;
use wasm_bindgen::prelude::*;

/// Maximum number of steps in which the page may ask for a turn.
const MAX_SAMPLES: usize = 36_000;

/// The page's one object.
#[wasm_bindgen]
#[derive(Default)]
pub struct Lab {
    current: Option<Rc<Study>>,
    /// The search for the cures of each cam; a new design drops it.
    jobs: Vec<CureJob>,
    /// Cams whose curves are drawn behind those of the current one.
    pub(crate) beside: Vec<Beside>,
}

/// A cam whose curves are drawn behind those of another, and how they look.
pub struct Beside {
    pub study: Rc<Study>,
    pub colour: RGBColor,
    pub dash: Vec<f64>,
}

/// The report on a design that makes a cam, or what is wrong with it; in either case the outline of its program, unless it is no
/// design file at all.
#[derive(Serialize)]
struct Answer {
    #[serde(flatten)]
    opened: Opened,
    outline: Option<Outline>,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Opened {
    Report(Box<PageReport>),
    Error(Failure),
}

#[wasm_bindgen]
impl Lab {
    /// A laboratory without a cam.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Checks and analyses a design. A good one becomes the current one; otherwise the last good one stays.
    ///
    /// # Errors
    /// Never: what is no design is an answer.
    #[wasm_bindgen(unchecked_return_type = "Opened")]
    pub fn open(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Design")] design: &JsValue,
        samples: usize,
        #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
    ) -> Result<JsValue, JsError> {
        let language = language(words);
        let draft = Design::draft(&levalab_edge::value(design));
        let outline = draft.as_ref().ok().map(Design::outline);
        let study = draft.and_then(|draft| Study::of_draft(draft, samples.clamp(1, MAX_SAMPLES)));
        let opened = match study {
            Ok(study) => {
                let report = PageReport::of(&study, language);
                self.current = Some(Rc::new(study));
                self.jobs.clear();
                Opened::Report(Box::new(report))
            }
            Err(error) => Opened::Error(Failure::of(language, &error)),
        };
        object(&Answer { opened, outline })
    }

    /// The cures of each finding of the current cam, or of both cams of a pair, in the order of the verdict. Slower than an analysis: for when the hand rests.
    ///
    /// # Errors
    /// Never, for any current cam.
    #[wasm_bindgen(unchecked_return_type = "Cure[][]")]
    pub fn cures(&self, #[wasm_bindgen(unchecked_param_type = "Language")] words: &str) -> Result<JsValue, JsError> {
        let cams = self.cams();
        let of_each = cams.iter().map(|cam| told_cures(cam, cam.cures(), language(words))).collect();
        object(&of_both(&cams, of_each))
    }

    /// Goes on with the search for the cures, as [`Lab::cures`] gives them; the budget is the number of looks at a cam that this part may
    /// take. Undefined while the search is not done. Opening a design drops the search.
    ///
    /// # Errors
    /// Never, for any current cam.
    #[wasm_bindgen(unchecked_return_type = "Cure[][] | undefined")]
    pub fn step_cures(
        &mut self,
        budget: usize,
        #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
    ) -> Result<JsValue, JsError> {
        let cams: Vec<&CamStudy> = self.current.iter().flat_map(|study| study.cams()).collect();
        self.jobs.resize_with(cams.len(), CureJob::default);
        let mut of_each = Vec::new();
        for (cam, job) in cams.iter().zip(&mut self.jobs) {
            let Some(cures) = cam.step_cures(job, budget) else { return Ok(JsValue::UNDEFINED) };
            of_each.push(told_cures(cam, cures, language(words)));
        }
        object(&of_both(&cams, of_each))
    }

    /// A column of the current cam, `samples` + 1 values; empty when it does not apply.
    pub fn column(
        &self,
        #[wasm_bindgen(unchecked_param_type = "ColumnName")] name: &str,
        second: Option<bool>,
    ) -> Vec<f64> {
        let wanted = Column::ALL.into_iter().find(|column| column.name() == name);
        self.cam(second).zip(wanted).and_then(|(cam, wanted)| cam.column(wanted)).unwrap_or_default()
    }

    /// The limits of s, v, a, j (per radian, in the unit of s, without the noise of rounding) before a border of the segments, and after it; empty when there is none.
    pub fn limits(&self, border: usize) -> Vec<f64> {
        self.cam(None).map_or_else(Vec::new, |cam| limits(cam, border))
    }

    /// Exact values at θ (degrees, any turn; length for a cam that travels), in the order of the `INSTANT` table.
    pub fn at(&self, theta: f64, out: &mut [f64], second: Option<bool>) {
        match self.cam(second) {
            Some(study) => instant::fill(study.cam(), study.design().omega(), theta, out),
            None => out.fill(f64::NAN),
        }
    }
}

impl Lab {
    /// The current study, to be kept by another laboratory.
    pub(crate) fn shared(&self) -> Option<Rc<Study>> {
        self.current.clone()
    }

    /// The cams of the current design.
    fn cams(&self) -> Vec<&CamStudy> {
        self.current.iter().flat_map(|study| study.cams()).collect()
    }

    /// The current cam, or the second one of its pair.
    fn cam(&self, second: Option<bool>) -> Option<&CamStudy> {
        let study = self.current.as_ref()?;
        if second == Some(true) { study.second() } else { Some(study.first()) }
    }

    /// The current cam, or the second one of its pair, for the diagrams.
    pub(crate) fn drawn(&self, second: Option<bool>) -> Result<&CamStudy, JsError> {
        self.cam(second).ok_or_else(|| JsError::new("no such cam has been opened"))
    }
}

fn limits(study: &CamStudy, border: usize) -> Vec<f64> {
    let borders = study.cam().program.borders();
    // The last border is the first again.
    let theta = borders.get(border).map(|&theta| if border + 1 == borders.len() { borders[0] } else { theta });
    let joint = theta.and_then(|theta| study.analysis().joints.iter().find(|joint| joint.theta == theta));
    let scale = scale_of(study.design(), Column::S);
    let side = |motion: Svaj| (0..4).map(move |order| noticed(clean(motion.order(order) * scale)));
    joint.map_or_else(Vec::new, |joint| side(joint.before).chain(side(joint.after)).collect())
}

/// A derivative at a border that is smaller than this, per radian and in the unit of *s*, is rounding.
const LIMIT_TOLERANCE: f64 = 1e-9;

fn noticed(value: f64) -> f64 {
    if value.abs() < LIMIT_TOLERANCE { 0.0 } else { value }
}
