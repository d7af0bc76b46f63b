//! Cams side by side: curves of other laboratories behind those of this one, figures for the table, the tournament of the laws.
//!
//! Figures cross as plain numbers that the page reads by position: shapes for them would weigh more than they tell.

use crate::lab::{Beside, Lab};
use crate::object;
use levalab_core::LAWS;
use levalab_format::{Figures, by_law, tournament};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Lab {
    /// Draws this cam alone from now on.
    pub fn alone(&mut self) {
        self.beside.clear();
    }

    /// Draws the current cam of another laboratory behind this one's from now on.
    pub fn beside(&mut self, other: &Lab, colour: &str, dash: Vec<f64>) {
        let looks = |cam| Beside { cam, colour: levalab_chart::colour(colour).unwrap_or_default(), dash };
        self.beside.extend(other.shared().map(looks));
    }

    /// The figures of the current cam, in the order of `FIGURES`; what does not apply is NaN.
    ///
    /// 0 verdict (0 acceptable, 1 not for high speeds, 2 unacceptable), 1 lift, 2–4 peaks of v, a, j, 5–7 of V, A, J, 8–9 least and
    /// greatest φ, 10 greatest |φ|, 11 least convex ρ, 12 length of the face.
    pub fn figures(&self) -> Vec<f64> {
        let figures = |lab: &Self| {
            let current = lab.current().ok()?;
            Some(numbers(&Figures::of(&current.design, &current.cam, &current.analysis)).into())
        };
        figures(self).unwrap_or_default()
    }

    /// The face that the contact needs with a margin at each end: from the axis (of a swinging face: from the foot of the pivot) to its
    /// left and its right end, and its length. Empty without a face.
    pub fn face(&self, margin: f64, second: Option<bool>) -> Vec<f64> {
        let reach = self.drawn(second).ok().and_then(|current| current.analysis.summary.reach);
        reach.map_or_else(Vec::new, |reach| {
            let (left, right) = (reach.min - margin, reach.max + margin);
            vec![left, right, right - left]
        })
    }

    /// The current program moved by every law that fits: for each the place of the law in the catalogue (−1 for the design as it is),
    /// the smallest base radius, and its figures.
    pub fn tournament(&self) -> Vec<f64> {
        let contenders = self.current().ok().and_then(|current| tournament(&current.design).ok()).unwrap_or_default();
        let mut told = Vec::new();
        for contender in &contenders {
            let law = contender.law.and_then(|law| LAWS.iter().position(|&other| other == law));
            told.push(law.map_or(-1.0, |place| place as f64));
            told.push(contender.smallest_base_radius.unwrap_or(f64::NAN));
            told.extend(numbers(&contender.figures));
        }
        told
    }

    /// The current design with one law, told by its place in the catalogue, for every segment that moves.
    ///
    /// # Errors
    /// When there is no cam yet, or no such law.
    #[wasm_bindgen(unchecked_return_type = "Design")]
    pub fn by_law(&self, place: usize) -> Result<JsValue, JsError> {
        let law = LAWS.get(place).ok_or_else(|| JsError::new("no such law"))?;
        let current = self.current()?;
        object(&by_law(&current.design, &current.cam, law))
    }
}

fn numbers(figures: &Figures) -> [f64; 13] {
    let Figures { level, lift, peaks, timed_peaks, pressure_angle, steepest, least_radius, face } = *figures;
    let ([v, a, j], [timed_v, timed_a, timed_j], [low, high]) = (peaks, timed_peaks, pressure_angle);
    let or_none = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let ends = [or_none(least_radius), or_none(face)];
    [f64::from(level as u8), lift, v, a, j, timed_v, timed_a, timed_j, low, high, steepest, ends[0], ends[1]]
}
