//! A sheet of paper: what is drawn, in millimetres, and the scale.

use levalab_core::Point;

/// What a drawing needs, in the unit of the design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub low: Point,
    pub high: Point,
}

impl Bounds {
    /// A box that holds nothing yet.
    pub const NONE: Self =
        Self { low: Point::new(f64::INFINITY, f64::INFINITY), high: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY) };

    /// The box that holds these points as well.
    pub fn with(self, points: impl IntoIterator<Item = Point>) -> Self {
        points.into_iter().fold(self, |Self { low, high }, p| Self {
            low: Point::new(low.re.min(p.re), low.im.min(p.im)),
            high: Point::new(high.re.max(p.re), high.im.max(p.im)),
        })
    }

    /// The box that holds a disc as well.
    pub fn with_disc(self, centre: Point, radius: f64) -> Self {
        self.with([centre - Point::new(radius, radius), centre + Point::new(radius, radius)])
    }

    pub fn width(self) -> f64 {
        self.high.re - self.low.re
    }

    pub fn height(self) -> f64 {
        self.high.im - self.low.im
    }
}

/// Paper to part, as ISO 5455 recommends, from true scale down.
const REDUCTIONS: [f64; 12] = [1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.000_5, 0.000_1];

/// The same for what is too small to be seen.
const ENLARGEMENTS: [f64; 7] = [100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0];

/// A part smaller than this (mm) is drawn larger than it is.
const SMALLEST: f64 = 12.0;

/// The scale in which a part of `width` × `height` mm fits: 1, true scale, wherever it can be.
pub(crate) fn scale_for(width: f64, height: f64, room: [f64; 2]) -> f64 {
    let fits = |scale: &f64| width * scale <= room[0] && height * scale <= room[1];
    let scales: &[f64] = if width.max(height) < SMALLEST { &ENLARGEMENTS } else { &REDUCTIONS };
    let least = (room[0] / width).min(room[1] / height);
    scales.iter().copied().find(fits).unwrap_or(least)
}

/// The scale as it is written on drawings: `1:2`, `5:1`.
pub(crate) fn scale_name(scale: f64) -> String {
    if scale >= 1.0 { format!("{scale}:1") } else { format!("1:{}", (1.0 / scale * 1e6).round() / 1e6) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn true_scale_is_taken_wherever_it_fits() {
        let room = [180.0, 180.0];
        for (size, scale) in [(100.0, 1.0), (180.0, 1.0), (181.0, 0.5), (800.0, 0.2), (12.0, 1.0), (5.0, 20.0)] {
            assert_eq!(scale_for(size, size, room), scale, "{size}");
        }
        assert_eq!([1.0, 0.5, 0.2, 20.0].map(scale_name), ["1:1", "1:2", "1:5", "20:1"]);
    }
}
