//! The opening of a poppet valve.

use super::{Application, Magnitude, Output, OutputLaw, Setting};
use std::f64::consts::{FRAC_PI_4, PI};

/// The curtain of a poppet valve that is lifted by *s*: the slant surface of the frustum of a cone between the inner edge of the seat
/// (diameter d, at an angle β to the plane of the seat) and the head,
///
/// Av = π·s·cos β·(d + s·sin β·cos β),
///
/// which is π·d·s for a flat seat. Source: J. B. Heywood, *Internal Combustion Engine Fundamentals*, §6.3.2, equation (6.7) for low lifts, with
/// d = Dv − 2w. Left out: the two further stages of high lifts, where the head clears the seat and where the port is what restricts.
pub const APPLICATION: Application = Application {
    id: "valve",
    parameters: &[
        Setting { key: "seat_diameter", symbol: "d", magnitude: Magnitude::Length, default: None },
        Setting { key: "seat_angle", symbol: "β", magnitude: Magnitude::Angle, default: Some(FRAC_PI_4) },
    ],
    outputs: &[Output {
        id: "area",
        symbol: "Av",
        magnitude: Magnitude::Area,
        law: OutputLaw::OfDisplacement(curtain),
        formula: "π s cos(β) (d + s sin(β) cos(β))",
        strokes: false,
    }],
    figures: &[],
};

/// A valve below its seat is closed.
fn curtain(&[diameter, angle]: &[f64; 2], s: f64) -> f64 {
    let (lift, (sin, cos)) = (s.max(0.0), angle.sin_cos());
    PI * lift * cos * (diameter + lift * sin * cos)
}
