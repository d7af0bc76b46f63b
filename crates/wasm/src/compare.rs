//! Cams side by side: the curves of other laboratories behind the curves of this one, and the figures for the table.

use crate::lab::{Beside, Current, Lab};
use levalab_format::Figures;
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

    /// The figures of the current cam, in the order of [`levalab_edge::figures`]; empty without a cam.
    pub fn figures(&self) -> Vec<f64> {
        let of =
            |current: &Current| levalab_edge::figures(&Figures::of(&current.design, &current.cam, &current.analysis));
        self.current().map_or_else(|_| Vec::new(), |current| of(current).into())
    }

    /// The face that the contact needs with a margin at each end: from the axis (of a swinging face: from the foot of the pivot) to its
    /// left and its right end, and its length. Empty without a face.
    pub fn face(&self, margin: f64, second: Option<bool>) -> Vec<f64> {
        let face = self.drawn(second).ok().and_then(|current| current.analysis.summary.face(&current.cam, margin));
        face.map_or_else(Vec::new, |face| vec![face.from, face.to, face.length])
    }
}
