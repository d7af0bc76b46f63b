//! What is drawn, as a list: laid out without a backend, so that it can be looked at in tests.

use plotters::style::RGBAColor;
use plotters::style::text_anchor::HPos;
use std::ops::Range;

/// A place in units.
pub(crate) type At = (i32, i32);

/// Everything to draw, from back to front.
#[derive(Default)]
pub(crate) struct Sketch {
    /// The points of all paths.
    pub points: Vec<At>,
    pub marks: Vec<Mark>,
}

/// How a line is dashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dash {
    /// Not at all.
    Full,
    /// As the style asks for the curve.
    Curve,
    /// Limit lines.
    Limit,
    /// From one limit of a jump to the other.
    Step,
    /// As the style asks for the curve of another cam.
    Other(usize),
}

/// Something to draw.
pub(crate) enum Mark {
    /// A filled rectangle.
    Band { from: At, to: At, colour: RGBAColor },
    /// A line through points.
    Line { points: Range<usize>, width: i32, colour: RGBAColor, dash: Dash },
    /// A filled polygon.
    Wedge { points: Range<usize>, colour: RGBAColor },
    /// A filled circle.
    Dot { centre: At, radius: i32, colour: RGBAColor },
    /// The outline of a circle.
    Ring { centre: At, radius: i32, width: i32, colour: RGBAColor },
    /// A number, its middle at the height given.
    Text { text: String, at: At, anchor: HPos, colour: RGBAColor },
}

impl Sketch {
    pub fn line(&mut self, from: At, to: At, width: i32, colour: RGBAColor, dash: Dash) {
        let start = self.points.len();
        self.points.extend([from, to]);
        self.marks.push(Mark::Line { points: start..start + 2, width, colour, dash });
    }

    pub fn wedge(&mut self, corners: [At; 3], colour: RGBAColor) {
        let start = self.points.len();
        self.points.extend(corners);
        self.marks.push(Mark::Wedge { points: start..start + 3, colour });
    }

    pub fn text(&mut self, text: String, at: At, anchor: HPos, colour: RGBAColor) {
        self.marks.push(Mark::Text { text, at, anchor, colour });
    }
}
