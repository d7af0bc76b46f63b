//! Behind the curve: ticks with their labels, borders of segments, limits.

use crate::diagram::Diagram;
use crate::frame::Frame;
use crate::sketch::{Dash, Mark, Sketch};
use crate::space::{Room, Space};
use crate::style::Style;
use crate::ticks::{Ticks, angle_step};
use levalab_numbers::write::{fixed, power_of_ten};
use plotters::style::text_anchor::HPos;
use plotters::style::{Color, RGBAColor};

/// Least distance of ticks of the y axis, in heights of the type.
const Y_GAP: f64 = 1.7;

/// Least distance of labels of θ, in heights of the type.
const X_GAP: f64 = 2.6;

/// From the plot to the middle of the labels of θ, in heights of the type.
const X_LABEL_DROP: f64 = 1.2;

/// Between the top of the plot and the power of ten in its corner, in heights of the type.
const CORNER: f64 = 0.1;

/// Length of the ticks of θ, in heights of the type.
const TICK: f64 = 0.35;

/// Half the height of a label that must stay within the drawing, in heights of the type.
const HALF_LABEL: f64 = 0.5;

/// One turn, degrees.
const TURN: i32 = 360;

/// Opacity of what lies beyond a limit.
const FORBIDDEN: f64 = 0.07;

/// Opacity of the zero line.
const ZERO: f64 = 0.75;

/// Opacity of limit lines.
const LIMIT: f64 = 0.85;

/// Ticks for the range of the frame.
pub(crate) fn ticks(diagram: &Diagram, frame: &Frame) -> Ticks {
    if diagram.extent.empty {
        return Ticks::zero();
    }
    let (low, high) = frame.values();
    let tall = f64::from(frame.bottom - frame.top) / frame.em;
    Ticks::within(low, high, (high - low) * (Y_GAP / tall).min(1.0))
}

/// Draws what lies behind the curve.
pub(crate) fn draw(sketch: &mut Sketch, diagram: &Diagram, frame: &Frame, style: &Style, ticks: Ticks) {
    forbidden(sketch, diagram, frame, style);
    let grid = style.grid.to_rgba();
    for &border in &diagram.borders {
        vertical(sketch, frame, frame.x(border), grid);
    }
    if diagram.ruled {
        for angle in angles(frame).filter(|&angle| 0 < angle && angle < TURN) {
            vertical(sketch, frame, frame.x(f64::from(angle)), grid);
        }
    }
    for value in ticks.values().filter(|&value| value != 0.0) {
        horizontal(sketch, frame, value, grid, Dash::Full);
    }
    if frame.holds(0.0) && !diagram.limits.contains(&0.0) {
        horizontal(sketch, frame, 0.0, style.muted.mix(ZERO), Dash::Full);
    }
    for &limit in diagram.limits.iter().filter(|&&limit| frame.holds(limit)) {
        horizontal(sketch, frame, limit, style.limit.mix(LIMIT), Dash::Limit);
    }
    if style.x_labels {
        match diagram.travel {
            Some(length) => label_lengths(sketch, frame, style, length),
            None => label_angles(sketch, frame, style),
        }
    }
}

fn forbidden(sketch: &mut Sketch, diagram: &Diagram, frame: &Frame, style: &Style) {
    for &(from, to) in &diagram.forbidden {
        let (top, bottom) = (frame.y_inside(to), frame.y_inside(from));
        if top < bottom {
            let colour = style.limit.mix(FORBIDDEN);
            sketch.marks.push(Mark::Band { from: (frame.left, top), to: (frame.right, bottom), colour });
        }
    }
}

fn vertical(sketch: &mut Sketch, frame: &Frame, x: i32, colour: RGBAColor) {
    let x = frame.sharp(x);
    sketch.line((x, frame.top), (x, frame.bottom), frame.thin(), colour, Dash::Full);
}

fn horizontal(sketch: &mut Sketch, frame: &Frame, value: f64, colour: RGBAColor, dash: Dash) {
    let y = frame.sharp(frame.y(value));
    sketch.line((frame.left, y), (frame.right, y), frame.thin(), colour, dash);
}

/// Labels the ticks of the y axis. The power of ten goes into the plot where it covers nothing, or else above the labels.
pub(crate) fn label_values(sketch: &mut Sketch, frame: &Frame, style: &Style, ticks: Ticks, space: &mut Space) {
    let (x, muted) = (frame.left - frame.ems(frame.label_gap), style.muted.to_rgba());
    let mut highest = frame.ems(HALF_LABEL);
    if ticks.exponent != 0 {
        let text = format!("×{}", power_of_ten(ticks.exponent));
        let (width, height) = space.size(&text);
        let inset = frame.ems(frame.label_gap);
        let corners = [(HPos::Left, frame.left + inset), (HPos::Right, frame.right - inset)];
        let room = |(anchor, x): (HPos, i32)| {
            let left = if matches!(anchor, HPos::Left) { x } else { x - width };
            Room::new(left, frame.top + frame.ems(CORNER), (width, height))
        };
        if let Some(corner) = corners.into_iter().find(|&corner| space.is_free(room(corner), &sketch.points)) {
            let room = room(corner);
            sketch.text(text, (corner.1, (room.top + room.bottom) / 2), corner.0, muted);
            space.take(room);
        } else {
            sketch.text(text, (x, highest), HPos::Right, muted);
            highest += frame.ems(2.0 * HALF_LABEL);
        }
    }
    let lowest = frame.height - frame.ems(HALF_LABEL);
    for value in ticks.values() {
        let y = frame.y(value);
        if highest <= y && y <= lowest {
            sketch.text(ticks.label(value, style.decimal_sign), (x, y), HPos::Right, muted);
        }
    }
}

/// Degrees that are labelled.
fn angles(frame: &Frame) -> impl Iterator<Item = i32> {
    let gap = f64::from(TURN) * frame.em * X_GAP / f64::from(frame.right - frame.left);
    (0..=TURN).step_by(angle_step(gap) as usize)
}

fn label_angles(sketch: &mut Sketch, frame: &Frame, style: &Style) {
    let muted = style.muted.to_rgba();
    for angle in angles(frame) {
        let mut text = fixed(f64::from(angle), 0, style.decimal_sign);
        if angle == TURN {
            text.push('°');
        }
        label_place(sketch, frame, muted, f64::from(angle), text);
    }
}

fn label_lengths(sketch: &mut Sketch, frame: &Frame, style: &Style, length: f64) {
    let gap = length * frame.em * X_GAP / f64::from(frame.right - frame.left);
    let ticks = Ticks::within(0.0, length, gap);
    for value in ticks.values() {
        label_place(sketch, frame, style.muted.to_rgba(), value, ticks.label(value, style.decimal_sign));
    }
}

fn label_place(sketch: &mut Sketch, frame: &Frame, muted: RGBAColor, theta: f64, text: String) {
    let x = frame.x(theta);
    let tick = frame.sharp(x);
    sketch.line((tick, frame.bottom), (tick, frame.bottom + frame.ems(TICK)), frame.thin(), muted, Dash::Full);
    sketch.text(text, (x, frame.bottom + frame.ems(X_LABEL_DROP)), HPos::Center, muted);
}
