//! A force in proportion to the displacement.

use super::{Application, Magnitude, Output, OutputLaw, Setting};

/// F = K·s: a spring, or a column of fluid that is shut in, without preload.
pub const APPLICATION: Application = Application {
    id: "force",
    parameters: &[Setting { key: "stiffness", symbol: "K", magnitude: Magnitude::Stiffness, default: None }],
    outputs: &[Output {
        id: "force",
        symbol: "F",
        magnitude: Magnitude::Force,
        law: OutputLaw::OfDisplacement(|&[stiffness, ..], s| stiffness * s),
        formula: "K s",
        strokes: false,
    }],
    figures: &[],
};
