//! Dots at the extremes, each with its value when there is room.

use crate::diagram::Diagram;
use crate::frame::Frame;
use crate::numerals::Numerals;
use crate::sketch::{At, Mark, Sketch};
use crate::style::Style;
use crate::ticks::{Ticks, ten_to};
use plotters::style::Color;
use plotters::style::text_anchor::HPos;
use std::ops::Range;

/// Radius of a dot, in widths of the curve.
const DOT: f64 = 1.5;

/// Height of a label and width of a figure, in heights of the type; generous, since fonts differ.
const LABEL_HEIGHT: f64 = 0.95;
const FIGURE: f64 = 0.6;

/// Distances from dot to label that are tried, in heights of the type.
const DISTANCES: [f64; 4] = [0.45, 0.8, 1.2, 1.7];

/// A box in units: left, top, right, bottom.
type Box4 = (i32, i32, i32, i32);

/// Draws dots and values. `curve` says which points of the sketch are the curve, which no label may cover.
pub(crate) fn draw(
    sketch: &mut Sketch,
    diagram: &Diagram,
    frame: &Frame,
    style: &Style,
    ticks: Ticks,
    curve: Range<usize>,
) {
    let numerals = Numerals { decimal_comma: style.decimal_comma };
    let radius = frame.css(DOT * style.stroke);
    let mut taken: Vec<Box4> = diagram.jumps.iter().map(|jump| around_jump(frame, style, jump)).collect();
    let dots: Vec<At> = diagram.extremes.iter().map(|&extreme| frame.at(extreme)).collect();
    taken.extend(diagram.limits.iter().map(|&limit| (frame.left, frame.y(limit) - 1, frame.right, frame.y(limit) + 1)));
    taken.extend(dots.iter().map(|&(x, y)| (x - radius, y - radius, x + radius, y + radius)));
    for (&(theta, value), &centre) in diagram.extremes.iter().zip(&dots) {
        let at_jump = |jump: &crate::diagram::Jump| (jump.theta - theta).abs() < AT_JUMP;
        if !diagram.jumps.iter().any(at_jump) {
            sketch.marks.push(Mark::Dot { centre, radius, colour: style.curve.to_rgba() });
        }
        let text = numerals.significant(value / ten_to(ticks.exponent));
        let width = frame.ems(FIGURE * text.chars().count() as f64);
        let height = frame.ems(LABEL_HEIGHT);
        let inside = |b: &Box4| frame.left < b.0 && frame.top <= b.1 && b.2 < frame.right && b.3 <= frame.bottom;
        let free = |b: &Box4| {
            inside(b)
                && !taken.iter().any(|other| overlap(*b, *other))
                && !covers(*b, &sketch.points[curve.clone()], diagram, frame)
        };
        let below = frame.y(value) > (frame.top + frame.bottom) / 2;
        if let Some((anchor, place)) =
            candidates(frame, centre, (width, height), below).into_iter().find(|(_, b)| free(b))
        {
            let x = match anchor {
                HPos::Left => place.0,
                HPos::Right => place.2,
                HPos::Center => (place.0 + place.2) / 2,
            };
            sketch.text(text, (x, (place.1 + place.3) / 2), anchor, style.ink.to_rgba());
            taken.push(place);
        }
    }
}

/// Degrees: an extreme this near to a jump is one of its limits, and has a mark already.
const AT_JUMP: f64 = 1e-6;

/// Places for a label, the best first: beyond the extreme, then beside it, near before far.
fn candidates(frame: &Frame, (x, y): At, (width, height): (i32, i32), below: bool) -> Vec<(HPos, Box4)> {
    let gap = frame.ems(DISTANCES[0]);
    let beyond = if below { y + gap } else { y - gap - height };
    let middle = y - height / 2;
    let mut places = vec![(HPos::Center, (x - width / 2, beyond, x + width - width / 2, beyond + height))];
    places.push((HPos::Left, (x - gap / 2, beyond, x - gap / 2 + width, beyond + height)));
    places.push((HPos::Right, (x + gap / 2 - width, beyond, x + gap / 2, beyond + height)));
    for distance in DISTANCES {
        let away = frame.ems(distance);
        for top in [middle, if below { y - height / 4 } else { y - height * 3 / 4 }] {
            places.push((HPos::Left, (x + away, top, x + away + width, top + height)));
            places.push((HPos::Right, (x - away - width, top, x - away, top + height)));
        }
    }
    places
}

fn around_jump(frame: &Frame, style: &Style, jump: &crate::diagram::Jump) -> Box4 {
    let (x, reach) = (frame.x(jump.theta), frame.css(2.0 * style.stroke));
    let (a, b) = (frame.y_inside(jump.before), frame.y_inside(jump.after));
    (x - reach, a.min(b) - reach, x + reach, a.max(b) + reach)
}

fn overlap(a: Box4, b: Box4) -> bool {
    a.0 < b.2 && b.0 < a.2 && a.1 < b.3 && b.1 < a.3
}

/// True when the curve runs through the box. Its pieces are short or level, so their own boxes tell.
fn covers(label: Box4, curve: &[At], diagram: &Diagram, frame: &Frame) -> bool {
    let breaks: Vec<i32> = diagram.jumps.iter().map(|jump| frame.x(jump.theta)).collect();
    curve.windows(2).any(|pair| {
        let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
        let broken = ax == bx && breaks.contains(&ax) || bx < ax;
        !broken && overlap(label, (ax.min(bx) - 1, ay.min(by) - 1, ax.max(bx) + 1, ay.max(by) + 1))
    })
}
