//! Where the plot lies, and where a value lies in it.

use crate::diagram::{Diagram, Point};
use crate::sketch::At;
use crate::style::{SUBPIXELS, Style};

/// Left of the plot, in heights of the type: room for the longest label. The same for all, so that stacked plots align.
const GUTTER: f64 = 3.9;

/// Right of the plot, in heights of the type: room for half of "360°".
const RIGHT: f64 = 1.2;

/// Above and below the plot, in heights of the type: room for half a label.
const EDGE: f64 = 0.35;

/// Room between the curve and the edge of the plot, in heights of the type, where there is no label to put.
const CLEAR: f64 = 0.35;

/// The same where the value of an extreme may be put beside it, or above it in a tall plot.
const BESIDE: f64 = 0.75;
const ABOVE: f64 = 1.6;

/// A plot so many heights of the type tall has room for values above its extremes.
const TALL: f64 = 12.0;

/// The most of the height that is given up for room around the curve.
const MOST_ROOM: f64 = 0.5;

/// Between the labels of values and the plot, in heights of the type; further off where handles stand on the edge of the plot.
const LABEL_GAP: f64 = 0.4;
const HANDLE_GAP: f64 = 0.8;

/// One turn.
const TURN: f64 = 360.0;

/// Where the plot lies in the drawing (CSS pixels), and the values at its edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlotArea {
    /// Distance of the plot from the left.
    pub left: f64,
    /// Distance of the plot from the top.
    pub top: f64,
    /// Width of the plot.
    pub width: f64,
    /// Height of the plot.
    pub height: f64,
    /// θ at the left edge, degrees (or length for a cam that travels).
    pub x_min: f64,
    /// θ at the right edge, degrees.
    pub x_max: f64,
    /// Value at the lower edge.
    pub y_min: f64,
    /// Value at the upper edge.
    pub y_max: f64,
}

/// Units beyond which a value of another cam may lie out of the plot without it mattering where: sums of two such places are whole numbers still.
const FAR: f64 = (1 << 28) as f64;

/// The drawing measured in units, which are [`SUBPIXELS`] to a device pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub left: i32,
    pub right: i32,
    pub top: i32,
    pub bottom: i32,
    pub width: i32,
    pub height: i32,
    /// Units to a CSS pixel.
    pub pixel: f64,
    /// Height of the type in units.
    pub em: f64,
    /// θ at the right edge: 360°, or the length of a travel.
    pub whole: f64,
    /// Between the labels of values and the plot, in heights of the type.
    pub label_gap: f64,
    low: f64,
    high: f64,
    /// Thin lines lie on multiples of this.
    grain: f64,
    /// How much wider than usual they are.
    weight: f64,
}

impl Frame {
    pub fn new(diagram: &Diagram, style: &Style) -> Self {
        let units = f64::from(SUBPIXELS);
        let ratio = style.pixel_ratio.max(MIN_RATIO);
        let whole = |css: f64| (css * ratio).round() * units;
        let em = style.font_size.max(1.0);
        let edge = (EDGE * em).round();
        let foot = if style.x_labels { (Style::FOOT * em).round() } else { 0.0 };
        let (width, height) = (whole(style.width).max(units), whole(style.height).max(units));
        let (left, top) = (whole((GUTTER * em).ceil()), whole(edge));
        let right = (width - whole((RIGHT * em).ceil())).max(left + units);
        let bottom = (height - whole(edge) - whole(foot)).max(top + units);
        let (low, high) = range(diagram, (bottom - top) / (em * ratio * units));
        Self {
            left: left as i32,
            right: right as i32,
            top: top as i32,
            bottom: bottom as i32,
            width: width as i32,
            height: height as i32,
            pixel: ratio * units,
            em: em * ratio * units,
            whole: diagram.travel.unwrap_or(TURN),
            label_gap: if diagram.ruled { HANDLE_GAP } else { LABEL_GAP },
            low,
            high,
            weight: style.weight(),
            grain: if ratio.fract() == 0.0 { ratio * units } else { units },
        }
    }

    /// Values at the lower and the upper edge.
    pub fn values(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    pub fn x(&self, theta: f64) -> i32 {
        (f64::from(self.left) + f64::from(self.right - self.left) * theta / self.whole).round() as i32
    }

    pub fn y(&self, value: f64) -> i32 {
        let part = (self.high - value) / (self.high - self.low);
        (f64::from(self.top) + f64::from(self.bottom - self.top) * part).clamp(-FAR, FAR).round() as i32
    }

    pub fn at(&self, (theta, value): Point) -> At {
        (self.x(theta), self.y(value))
    }

    /// Height of a value in the plot, or of the edge that it lies beyond.
    pub fn y_inside(&self, value: f64) -> i32 {
        self.y(value.clamp(self.low, self.high))
    }

    pub fn holds(&self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// Width of a thin line: a CSS pixel or a little more, in whole device pixels.
    pub fn thin(&self) -> i32 {
        let units = f64::from(SUBPIXELS);
        ((self.pixel * self.weight / units).round().max(1.0) * units) as i32
    }

    /// The middle of a thin line near `place` that covers whole pixels and so is sharp.
    pub fn sharp(&self, place: i32) -> i32 {
        let half = f64::from(self.thin()) / 2.0;
        (((f64::from(place) - half) / self.grain).round() * self.grain + half) as i32
    }

    /// A length in CSS pixels as units.
    pub fn css(&self, length: f64) -> i32 {
        (length * self.pixel).round() as i32
    }

    /// A length in heights of the type as units.
    pub fn ems(&self, length: f64) -> i32 {
        (length * self.em).round() as i32
    }

    /// The plot as whoever shows the drawing sees it.
    pub fn area(&self, style: &Style) -> PlotArea {
        let across = style.width / f64::from(self.width);
        let down = style.height / f64::from(self.height);
        PlotArea {
            left: f64::from(self.left) * across,
            top: f64::from(self.top) * down,
            width: f64::from(self.right - self.left) * across,
            height: f64::from(self.bottom - self.top) * down,
            x_min: 0.0,
            x_max: self.whole,
            y_min: self.low,
            y_max: self.high,
        }
    }
}

/// Least device pixels to a CSS pixel that is believed.
const MIN_RATIO: f64 = 0.1;

/// The extent with room around it. `tall` is the height of the plot in heights of the type.
fn range(diagram: &Diagram, tall: f64) -> (f64, f64) {
    let extent = diagram.extent;
    if extent.cut {
        return (extent.low, extent.high);
    }
    let labelled = if tall >= TALL { ABOVE } else { BESIDE };
    let room = |edge: f64| {
        let at_edge = |value: f64| (value - edge).abs() < LABEL_REACH * (extent.high - extent.low);
        if diagram.extremes.iter().any(|&(_, value)| at_edge(value)) { labelled } else { CLEAR }
    };
    let (above, below) = (room(extent.high), room(extent.low));
    let scale = (MOST_ROOM * tall / (above + below)).min(1.0);
    let unit = (extent.high - extent.low) / (tall - scale * (above + below));
    (extent.low - below * scale * unit, extent.high + above * scale * unit)
}

/// An extreme this near to the end of the extent (as a part of it) wants room there for its label.
const LABEL_REACH: f64 = 0.1;
