//! Drawing with plotters.

use crate::frame::{Frame, PlotArea};
use crate::sketch::{Dash, Mark, Sketch};
use crate::style::Style;
use crate::{Diagram, axes, extremes, trace};
use plotters::coord::Shift;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::element::{Circle, PathElement, Polygon, Rectangle};
use plotters::prelude::{DrawingArea, DrawingBackend};
use plotters::style::text_anchor::{Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, RGBAColor, ShapeStyle, TextStyle};

/// Dashes and gaps of limit lines and of steps, CSS pixels.
const LIMIT_DASH: [f64; 2] = [6.0, 4.0];
const STEP_DASH: [f64; 2] = [2.0, 2.0];

/// The kind of error that a backend may give.
type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

/// Draws a diagram over the whole of `area`, whose surface is scaled by 1/[`SUBPIXELS`](crate::SUBPIXELS).
///
/// plotters knows no dashes, but surfaces do: `set_dash` is told the pattern of the strokes that follow, in units of the
/// drawing, whenever it changes; an empty one is a full line, and so is the last.
///
/// # Errors
/// Those of the backend.
pub fn draw<DB: DrawingBackend>(
    area: &DrawingArea<DB, Shift>,
    diagram: &Diagram,
    style: &Style,
    mut set_dash: impl FnMut(&[f64]),
) -> Result<PlotArea, DrawingAreaErrorKind<DB::ErrorType>> {
    let (frame, sketch) = lay_out(diagram, style);
    let medium = Medium::CANVAS;
    let text = medium.text(&frame, style);
    let mut current = Dash::Full;
    for mark in &sketch.marks {
        let wanted = mark.dash();
        if wanted != current {
            set_dash(&pattern(wanted, &frame, style));
            current = wanted;
        }
        paint(area, &sketch, mark, &text, medium.drop(&frame))?;
    }
    if current != Dash::Full {
        set_dash(&[]);
    }
    Ok(frame.area(style))
}

/// Lays a diagram out, from back to front.
pub(crate) fn lay_out(diagram: &Diagram, style: &Style) -> (Frame, Sketch) {
    let frame = Frame::new(diagram, style);
    let mut sketch =
        Sketch { points: Vec::with_capacity(diagram.points.len() + FEW_POINTS), marks: Vec::with_capacity(FEW_POINTS) };
    let colour = style.background.to_rgba();
    sketch.marks.push(Mark::Band { from: (0, 0), to: (frame.width, frame.height), colour });
    let ticks = axes::ticks(diagram, &frame);
    axes::draw(&mut sketch, diagram, &frame, style, ticks);
    trace::steps(&mut sketch, diagram, &frame, style);
    let curve = trace::curve(&mut sketch, diagram, &frame, style);
    trace::arrows(&mut sketch, diagram, &frame, style);
    trace::marks(&mut sketch, diagram, &frame, style);
    extremes::draw(&mut sketch, diagram, &frame, style, ticks, curve);
    (frame, sketch)
}

/// Points and marks of a usual diagram besides its curve.
const FEW_POINTS: usize = 128;

/// Where backends differ in setting text.
#[derive(Clone, Copy)]
pub(crate) struct Medium {
    /// What the size is multiplied by to come out right.
    size: f64,
    /// How much lower text must be put for its figures to be centred, in heights of the type.
    drop: f64,
}

impl Medium {
    pub const CANVAS: Self = Self { size: 1.0, drop: 0.04 };
    /// plotters-svg divides the size by 1.24, and centres on small letters.
    pub const SVG: Self = Self { size: 1.24, drop: 0.1 };

    pub fn text<'a>(self, frame: &Frame, style: &'a Style) -> TextStyle<'a> {
        FontDesc::new(FontFamily::from(style.font.as_str()), frame.em * self.size, FontStyle::Normal).color(&style.ink)
    }

    pub fn drop(self, frame: &Frame) -> i32 {
        frame.ems(self.drop)
    }
}

impl Mark {
    pub fn dash(&self) -> Dash {
        match self {
            Self::Line { dash, .. } => *dash,
            _ => Dash::Full,
        }
    }
}

/// Lengths of dashes and gaps in units; nothing for a full line.
pub(crate) fn pattern(dash: Dash, frame: &Frame, style: &Style) -> Vec<f64> {
    let lengths: &[f64] = match dash {
        Dash::Full => &[],
        Dash::Curve => &style.dash,
        Dash::Limit => &LIMIT_DASH,
        Dash::Step => &STEP_DASH,
    };
    lengths.iter().map(|length| length * frame.pixel).collect()
}

/// Draws one mark.
pub(crate) fn paint<DB: DrawingBackend>(
    area: &DrawingArea<DB, Shift>,
    sketch: &Sketch,
    mark: &Mark,
    text: &TextStyle,
    drop: i32,
) -> Drawn<DB> {
    match *mark {
        Mark::Band { from, to, colour } => area.draw(&Rectangle::new([from, to], colour.filled())),
        Mark::Line { ref points, width, colour, .. } => {
            area.draw(&PathElement::new(&sketch.points[points.clone()], stroke(colour, width)))
        }
        Mark::Wedge { ref points, colour } => area.draw(&Polygon::new(&sketch.points[points.clone()], colour)),
        Mark::Dot { centre, radius, colour } => area.draw(&Circle::new(centre, radius, colour.filled())),
        Mark::Ring { centre, radius, width, colour } => area.draw(&Circle::new(centre, radius, stroke(colour, width))),
        Mark::Text { text: ref label, at: (x, y), anchor, colour } => {
            let style =
                TextStyle { color: colour.to_backend_color(), pos: Pos::new(anchor, VPos::Center), ..text.clone() };
            area.draw_text(label, &style, (x, y + drop))
        }
    }
}

fn stroke(colour: RGBAColor, width: i32) -> ShapeStyle {
    colour.stroke_width(width.unsigned_abs())
}
