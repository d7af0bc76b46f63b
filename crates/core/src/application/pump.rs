//! A piston pump on the follower.

use super::{Application, Figure, Magnitude, Output, OutputLaw, PISTON_AREA, PISTON_RADIUS, disc};

/// The piston has swept Vol = A·s and moves Q = A·V; what rises is delivered, what returns is drawn in, and a turn delivers A times
/// the sum of the rises. Valves close at once and nothing leaks.
pub const APPLICATION: Application = Application {
    id: "pump",
    parameters: &[PISTON_RADIUS],
    outputs: &[
        Output {
            id: "volume",
            symbol: "Vol",
            magnitude: Magnitude::Volume,
            law: OutputLaw::OfDisplacement(|&[radius, ..], s| disc(radius) * s),
            formula: "A_p s",
            strokes: true,
        },
        Output {
            id: "flow",
            symbol: "Q",
            magnitude: Magnitude::Flow,
            law: OutputLaw::OfVelocity(|&[radius, ..], velocity| disc(radius) * velocity),
            formula: "A_p V",
            strokes: false,
        },
    ],
    figures: &[Figure {
        id: "piston_area",
        symbol: "A",
        magnitude: Magnitude::Area,
        of: |&[radius, ..]| disc(radius),
        formula: PISTON_AREA,
    }],
};
