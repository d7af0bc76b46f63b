//! How a diagram looks.

use levalab_numbers::write::DecimalSign;
use plotters::style::RGBColor;

/// Units of drawing to a device pixel. Backends draw at whole units, so this is how fine curves and strokes are.
///
/// Before drawing on a canvas, scale it by 1/`SUBPIXELS`.
pub const SUBPIXELS: u32 = 8;

/// Size, type, colours and strokes. Lengths are CSS pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// Width of the drawing.
    pub width: f64,
    /// Height of the drawing.
    pub height: f64,
    /// Device pixels to a CSS pixel.
    pub pixel_ratio: f64,
    /// Family of the type, as in CSS.
    pub font: String,
    /// Size of the type.
    pub font_size: f64,
    /// Values of the extremes.
    pub ink: RGBColor,
    /// Labels of the axes and the zero line.
    pub muted: RGBColor,
    /// Grid and borders of segments.
    pub grid: RGBColor,
    /// Behind it all.
    pub background: RGBColor,
    /// The curve.
    pub curve: RGBColor,
    /// Limits and what lies beyond them.
    pub limit: RGBColor,
    /// Jumps.
    pub mark: RGBColor,
    /// Dashes and gaps of the curve, empty for a full line; longer when [`stroke`](Self::stroke) is wider than 1.5.
    pub dash: Vec<f64>,
    /// Colour and dashes of the curves of other cams, in their order.
    pub others: Vec<(RGBColor, Vec<f64>)>,
    /// Width of the curve.
    pub stroke: f64,
    /// Labels of θ under the plot, which need [`Style::FOOT`] more height for the same plot.
    pub x_labels: bool,
    /// The decimal sign of its labels.
    pub decimal_sign: DecimalSign,
}

impl Style {
    /// Height of the labels of θ, in heights of the type. They take `(FOOT * font_size).round()` CSS pixels.
    pub const FOOT: f64 = 1.9;

    /// The curve's width for which dashes and thin lines are given.
    const USUAL_STROKE: f64 = 1.5;

    /// How much longer dashes and how much wider thin lines are than usual, when the curve is drawn for a projector.
    pub(crate) fn weight(&self) -> f64 {
        (self.stroke / Self::USUAL_STROKE).max(1.0)
    }
}

/// Dark on white, 420 × 140.
impl Default for Style {
    fn default() -> Self {
        Self {
            width: 420.0,
            height: 140.0,
            pixel_ratio: 1.0,
            font: "sans-serif".to_owned(),
            font_size: 11.0,
            ink: RGBColor(0x16, 0x19, 0x1d),
            muted: RGBColor(0x5b, 0x64, 0x6d),
            grid: RGBColor(0xe1, 0xe4, 0xe7),
            background: RGBColor(0xff, 0xff, 0xff),
            curve: RGBColor(0x00, 0x68, 0xa4),
            limit: RGBColor(0xb3, 0x26, 0x1e),
            mark: RGBColor(0xb3, 0x26, 0x1e),
            dash: Vec::new(),
            others: Vec::new(),
            stroke: 1.5,
            x_labels: true,
            decimal_sign: DecimalSign::Point,
        }
    }
}

/// A colour written `#rrggbb`.
#[must_use]
pub fn colour(text: &str) -> Option<RGBColor> {
    let digits =
        text.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit()))?;
    let part = |from: usize| u8::from_str_radix(&digits[from..from + 2], 16).ok();
    Some(RGBColor(part(0)?, part(2)?, part(4)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_six_hexadecimal_digits() {
        assert_eq!(colour("#0068a4"), Some(RGBColor(0, 0x68, 0xa4)));
        for wrong in ["", "0068a4", "#0068a", "#0068a44", "#+068a4", "#ñ68a4", "red"] {
            assert_eq!(colour(wrong), None, "{wrong}");
        }
    }
}
