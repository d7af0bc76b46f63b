//! The force of a piston on fluid that is shut in.

use super::{Application, Figure, Magnitude, Output, OutputLaw, PISTON_AREA, PISTON_RADIUS, Setting, disc};

/// The piston drives in a volume A·s; the pressure rises by P/V for each unit of it, so p = (P/V)·A·s, and the force is
/// F = p·A = K·s with K = (P/V)·A². Fluid and vessel are taken together in P/V, and inertia and leaks are left out.
pub const APPLICATION: Application = Application {
    id: "piston-force",
    parameters: &[
        Setting { key: "pressure_per_volume", symbol: "P/V", magnitude: Magnitude::PressurePerVolume, default: None },
        PISTON_RADIUS,
    ],
    outputs: &[
        Output {
            id: "force",
            symbol: "F",
            magnitude: Magnitude::Force,
            law: OutputLaw::OfDisplacement(|values, s| stiffness(values) * s),
            formula: "K s",
            strokes: false,
        },
        Output {
            id: "pressure",
            symbol: "p",
            magnitude: Magnitude::Pressure,
            law: OutputLaw::OfDisplacement(|&[ratio, radius], s| ratio * disc(radius) * s),
            formula: "k_V A_p s",
            strokes: false,
        },
    ],
    figures: &[
        Figure {
            id: "piston_area",
            symbol: "A",
            magnitude: Magnitude::Area,
            of: |&[_, radius]| disc(radius),
            formula: PISTON_AREA,
        },
        Figure { id: "stiffness", symbol: "K", magnitude: Magnitude::Stiffness, of: stiffness, formula: "k_V A_p^2" },
    ],
};

fn stiffness(&[ratio, radius]: &[f64; 2]) -> f64 {
    ratio * disc(radius) * disc(radius)
}
