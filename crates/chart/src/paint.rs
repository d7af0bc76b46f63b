//! Drawing with plotters.

use crate::frame::{Frame, PlotArea};
use crate::sketch::{At, Dash, Mark, Sketch};
use crate::space::Space;
use crate::style::Style;
use crate::{Diagram, axes, extremes, trace};
use plotters::coord::Shift;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::element::{Drawable, PointCollection};
use plotters::prelude::{DrawingArea, DrawingBackend};
use plotters::style::text_anchor::{Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, RGBAColor, ShapeStyle, TextStyle};
use plotters_backend::DrawingErrorKind;
use std::cell::RefCell;

/// Dashes and gaps of limit lines and of steps, CSS pixels.
const LIMIT_DASH: [f64; 2] = [6.0, 4.0];
const STEP_DASH: [f64; 2] = [2.0, 2.0];

/// Draws a diagram over the whole surface of `area`, which is scaled by 1/[`SUBPIXELS`](crate::SUBPIXELS).
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
    set_dash: impl FnMut(&[f64]),
) -> Result<PlotArea, DrawingAreaErrorKind<DB::ErrorType>> {
    let (frame, sketch) = lay_out(diagram, style);
    let set_dash = RefCell::new(set_dash);
    area.draw(&Drawing {
        frame: &frame,
        sketch: &sketch,
        marks: &sketch.marks,
        style,
        medium: Medium::CANVAS,
        set_dash,
    })?;
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
    let mut runs = Vec::new();
    for (k, curve) in diagram.beside.iter().chain([diagram]).enumerate() {
        let look = style.others.get(k).filter(|_| k < diagram.beside.len());
        let (colour, dash) = look.map_or((style.curve, Dash::Curve), |(colour, _)| (*colour, Dash::Other(k)));
        let step = if look.is_some() { colour.mix(trace::QUIET_STEP) } else { trace::step_colour(diagram, style) };
        trace::steps(&mut sketch, curve, &frame, step);
        trace::curve(&mut sketch, curve, &frame, style, (colour, dash), &mut runs);
        trace::arrows(&mut sketch, curve, &frame, style, colour);
    }
    trace::marks(&mut sketch, diagram, &frame, style);
    trace::targets(&mut sketch, diagram, &frame, style);
    let mut space = Space::new(diagram, &frame, style, &runs);
    axes::label_values(&mut sketch, &frame, style, ticks, &mut space);
    extremes::draw(&mut sketch, diagram, &frame, style, ticks, &mut space);
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

    fn text<'a>(self, frame: &Frame, style: &'a Style) -> TextStyle<'a> {
        FontDesc::new(FontFamily::Name(&style.font), frame.em * self.size, FontStyle::Normal).color(&style.ink)
    }

    fn drop(self, frame: &Frame) -> i32 {
        frame.ems(self.drop)
    }
}

/// Marks of a sketch as one element of plotters.
///
/// It brings its own points: those that plotters hands on have been held back within the pixels of the surface, of which
/// there are fewer than units.
pub(crate) struct Drawing<'a, F> {
    pub frame: &'a Frame,
    pub sketch: &'a Sketch,
    pub marks: &'a [Mark],
    pub style: &'a Style,
    pub medium: Medium,
    pub set_dash: RefCell<F>,
}

impl<F> PointCollection<'_, At> for &Drawing<'_, F> {
    type Point = At;
    type IntoIter = std::iter::Empty<At>;

    fn point_iter(self) -> Self::IntoIter {
        std::iter::empty()
    }
}

impl<DB: DrawingBackend, F: FnMut(&[f64])> Drawable<DB> for Drawing<'_, F> {
    fn draw<I: Iterator<Item = At>>(
        &self,
        _: I,
        backend: &mut DB,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<DB::ErrorType>> {
        let mut set_dash = self.set_dash.borrow_mut();
        let mut text = self.medium.text(self.frame, self.style);
        let mut current = Dash::Full;
        for mark in self.marks {
            let wanted = mark.dash();
            if wanted != current {
                set_dash(&pattern(wanted, self.frame, self.style));
                current = wanted;
            }
            self.paint(backend, mark, &mut text)?;
        }
        if current != Dash::Full {
            set_dash(&[]);
        }
        Ok(())
    }
}

impl<F> Drawing<'_, F> {
    fn paint<DB: DrawingBackend>(
        &self,
        backend: &mut DB,
        mark: &Mark,
        text: &mut TextStyle,
    ) -> Result<(), DrawingErrorKind<DB::ErrorType>> {
        let points = &self.sketch.points;
        match *mark {
            Mark::Band { from, to, colour } => backend.draw_rect(from, to, &colour, true),
            Mark::Line { points: ref range, width, colour, .. } => {
                backend.draw_path(points[range.clone()].iter().copied(), &stroke(colour, width))
            }
            Mark::Wedge { points: ref range, colour } => {
                backend.fill_polygon(points[range.clone()].iter().copied(), &colour)
            }
            Mark::Dot { centre, radius, colour } => backend.draw_circle(centre, radius.unsigned_abs(), &colour, true),
            Mark::Ring { centre, radius, width, colour } => {
                backend.draw_circle(centre, radius.unsigned_abs(), &stroke(colour, width), false)
            }
            Mark::Text { text: ref label, at: (x, y), anchor, colour } => {
                text.color = colour.to_backend_color();
                text.pos = Pos::new(anchor, VPos::Center);
                backend.draw_text(label, text, (x, y + self.medium.drop(self.frame)))
            }
        }
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
        Dash::Other(k) => style.others.get(k).map_or(&[], |(_, dash)| dash),
    };
    lengths.iter().map(|length| length * frame.pixel * style.weight()).collect()
}

fn stroke(colour: RGBAColor, width: i32) -> ShapeStyle {
    colour.stroke_width(width.unsigned_abs())
}
