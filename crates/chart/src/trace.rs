//! The curve, its jumps, and where it leaves the plot.

use crate::Quantity;
use crate::diagram::{Diagram, Jump, Run};
use crate::frame::Frame;
use crate::sketch::{At, Dash, Mark, Sketch};
use crate::style::Style;
use crate::thin::thin;
use plotters::style::{Color, RGBAColor, RGBColor};
use std::ops::Range;

/// Radius of the marks of a jump, in widths of the curve.
const MARK: f64 = 1.7;

/// Opacity of the step line of a jump; a jump of *j*, which is no fault at low speed, is told more quietly.
const STEP: f64 = 0.9;
pub(crate) const QUIET_STEP: f64 = 0.5;

/// Length and half the width of the arrow where the curve leaves the plot, in widths of the curve.
const ARROW: (f64, f64) = (4.0, 2.2);

/// Draws the dashed lines from limit to limit.
pub(crate) fn steps(sketch: &mut Sketch, diagram: &Diagram, frame: &Frame, colour: RGBAColor) {
    for jump in &diagram.jumps {
        let (from, to) = (frame.y_inside(jump.before), frame.y_inside(jump.after));
        if from != to {
            let x = frame.x(jump.theta);
            sketch.line((x, from), (x, to), frame.thin(), colour, Dash::Step);
        }
    }
}

/// Draws a curve and notes where the points of its runs are.
pub(crate) fn curve(
    sketch: &mut Sketch,
    diagram: &Diagram,
    frame: &Frame,
    style: &Style,
    (colour, dash): (RGBColor, Dash),
    runs: &mut Vec<Range<usize>>,
) {
    let width = frame.css(style.stroke).max(SHARPEST);
    let colour = colour.to_rgba();
    let run = |run: &Run| {
        let start = sketch.points.len();
        let values = &diagram.points[run.points.clone()];
        thin(values.iter().map(|&point| frame.at(point)), &mut sketch.points);
        let points = start..sketch.points.len();
        if points.len() > 1 {
            sketch.marks.push(Mark::Line { points: points.clone(), width, colour, dash });
        }
        points
    };
    runs.extend(diagram.runs.iter().map(run));
}

/// One device pixel: no curve is thinner.
const SHARPEST: i32 = crate::style::SUBPIXELS as i32;

/// Draws open marks at limits from the left, filled ones at limits from the right, which are the values of the columns.
pub(crate) fn marks(sketch: &mut Sketch, diagram: &Diagram, frame: &Frame, style: &Style) {
    let quiet = diagram.quantity == Quantity::J;
    let radius = frame.css(MARK * style.stroke * if quiet { 0.75 } else { 1.0 });
    let (colour, background) = (if quiet { style.curve } else { style.mark }.to_rgba(), style.background.to_rgba());
    let wraps = |jump: &Jump, theta: f64| (jump.theta - theta).abs() < EDGE_OF_TURN;
    for jump in &diagram.jumps {
        let x = frame.x(jump.theta);
        if frame.holds(jump.before) && !wraps(jump, 0.0) {
            let centre = (x, frame.y(jump.before));
            sketch.marks.push(Mark::Dot { centre, radius, colour: background });
            sketch.marks.push(Mark::Ring { centre, radius, width: frame.thin(), colour });
        }
        if frame.holds(jump.after) && !wraps(jump, frame.whole) {
            sketch.marks.push(Mark::Dot { centre: (x, frame.y(jump.after)), radius, colour });
        }
    }
}

/// Radius of a ring about a point to hit, in widths of the curve.
pub(crate) const TARGET: f64 = 3.4;

/// Draws a ring about each point to hit: open, so that the curve is seen to pass through it or beside it.
pub(crate) fn targets(sketch: &mut Sketch, diagram: &Diagram, frame: &Frame, style: &Style) {
    let radius = frame.css(TARGET * style.stroke);
    let (width, colour) = (frame.css(style.stroke).max(frame.thin()), style.ink.to_rgba());
    let ring = |target: &(f64, f64)| Mark::Ring { centre: frame.at(*target), radius, width, colour };
    sketch.marks.extend(diagram.targets.iter().map(ring));
}

/// Degrees: a jump this near to 0° or 360° is the one where the turn closes.
const EDGE_OF_TURN: f64 = 1e-9;

/// Draws an arrow wherever the curve goes on beyond the plot.
pub(crate) fn arrows(sketch: &mut Sketch, diagram: &Diagram, frame: &Frame, style: &Style, colour: RGBColor) {
    let colour = colour.to_rgba();
    for Run { points, comes_in, goes_out } in &diagram.runs {
        let ends = [comes_in.then_some(points.start), goes_out.then(|| points.end - 1)];
        for end in ends.into_iter().flatten() {
            sketch.wedge(arrow(frame, style, frame.at(diagram.points[end])), colour);
        }
    }
}

fn arrow(frame: &Frame, style: &Style, (x, y): At) -> [At; 3] {
    let (length, half) = (frame.css(ARROW.0 * style.stroke), frame.css(ARROW.1 * style.stroke));
    let tip = if y - frame.top < frame.bottom - y { frame.top } else { frame.bottom };
    let base = if tip == frame.top { tip + length } else { tip - length };
    let x = x.clamp(frame.left + half, (frame.right - half).max(frame.left + half));
    [(x, tip), (x - half, base), (x + half, base)]
}

pub(crate) fn step_colour(diagram: &Diagram, style: &Style) -> RGBAColor {
    if diagram.quantity == Quantity::J { style.curve.mix(QUIET_STEP) } else { style.mark.mix(STEP) }
}
