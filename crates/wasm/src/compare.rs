//! Cams side by side: the curves of other laboratories behind the curves of this one, and the figures for the table.

use crate::lab::{Beside, Lab};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Lab {
    /// Draws this cam alone from now on.
    pub fn alone(&mut self) {
        self.beside.clear();
    }

    /// Draws the current cam of another laboratory behind this one's from now on.
    pub fn beside(&mut self, other: &Lab, colour: &str, dash: Vec<f64>) {
        let looks = |study| Beside { study, colour: levalab_chart::colour(colour).unwrap_or_default(), dash };
        self.beside.extend(other.shared().map(looks));
    }

    /// The figures of the current cam, in the order of [`levalab_edge::figures`]; empty without a cam.
    pub fn figures(&self) -> Vec<f64> {
        self.shared().map_or_else(Vec::new, |study| levalab_edge::figures(&study.figures()).into())
    }

    /// The face that the contact needs with a margin at each end: from the axis (of a swinging face: from the foot of the pivot) to its
    /// left and its right end, and its length. Empty without a face.
    pub fn face(&self, margin: f64, second: Option<bool>) -> Vec<f64> {
        let face = self.drawn(second).ok().and_then(|study| study.analysis().summary.face(study.cam(), margin));
        face.map_or_else(Vec::new, |face| vec![face.from, face.to, face.length])
    }
}
