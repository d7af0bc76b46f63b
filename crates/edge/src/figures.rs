//! The figures by which cams are compared, as numbers that the page reads by position.

use levalab_format::Figures;

/// The figures in the order of `FIGURES` in `web/compare/cells.js`; a figure that does not apply is NaN.
///
/// 0 verdict (0 acceptable, 1 not for high speeds, 2 unacceptable), 1 lift, 2–4 peaks of v, a, j, 5–7 peaks of V, A, J,
/// 8–9 minimum and maximum of φ, 10 maximum of |φ|, 11 minimum convex ρ, 12 length of the face. Lengths in the unit of the
/// design, angles in degrees.
#[must_use]
pub fn figures(figures: &Figures) -> [f64; 13] {
    let Figures { level, lift, peaks, timed_peaks, pressure_angle, steepest, least_radius, face } = *figures;
    let ([v, a, j], [timed_v, timed_a, timed_j], [low, high]) = (peaks, timed_peaks, pressure_angle);
    let or_none = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let (least_radius, face) = (or_none(least_radius), or_none(face));
    [f64::from(level as u8), lift, v, a, j, timed_v, timed_a, timed_j, low, high, steepest, least_radius, face]
}
