//! Dots at the extremes, each with its value when there is room.

use crate::diagram::{Diagram, Jump};
use crate::frame::Frame;
use crate::sketch::{At, Mark, Sketch};
use crate::space::{Room, Space};
use crate::style::Style;
use crate::ticks::{Ticks, ten_to};
use crate::trace::TARGET;
use levalab_numbers::write::measured;
use plotters::style::Color;
use plotters::style::text_anchor::HPos;

/// Radius of a dot, in widths of the curve.
const DOT: f64 = 1.5;

/// Distances from dot to label that are tried, in heights of the type.
const DISTANCES: [f64; 4] = [0.45, 0.8, 1.2, 1.7];

/// Degrees: an extreme this near to a jump is one of its limits, and has a mark already.
const AT_JUMP: f64 = 1e-6;

/// Draws dots and values.
pub(crate) fn draw(
    sketch: &mut Sketch,
    diagram: &Diagram,
    frame: &Frame,
    style: &Style,
    ticks: Ticks,
    space: &mut Space,
) {
    let radius = frame.css(DOT * style.stroke);
    for &target in &diagram.targets {
        space.take_dot(frame.at(target), frame.css(TARGET * style.stroke));
    }
    for &extreme in &diagram.extremes {
        space.take_dot(frame.at(extreme), radius);
    }
    for &(theta, value) in &diagram.extremes {
        let centre = frame.at((theta, value));
        let at_jump = |jump: &Jump| (jump.theta - theta).abs() < AT_JUMP;
        if !diagram.jumps.iter().any(at_jump) {
            sketch.marks.push(Mark::Dot { centre, radius, colour: style.curve.to_rgba() });
        }
        let text = measured(value / ten_to(ticks.exponent), style.decimal_sign);
        let below = diagram.extremes.iter().any(|other| other.1 > value) || value < 0.0 && diagram.extremes.len() == 1;
        let mut places = candidates(frame, centre, space.size(&text), below).into_iter();
        if let Some((anchor, room)) = places.find(|&(_, room)| space.is_free(room, &sketch.points)) {
            let x = match anchor {
                HPos::Left => room.left,
                HPos::Right => room.right,
                HPos::Center => (room.left + room.right) / 2,
            };
            sketch.text(text, (x, (room.top + room.bottom) / 2), anchor, style.ink.to_rgba());
            space.take(room);
        }
    }
}

/// Places for a label, the best first: beyond the extreme, beside it, and under the arch that it is the top of.
fn candidates(frame: &Frame, (x, y): At, size: (i32, i32), below: bool) -> Vec<(HPos, Room)> {
    let (width, height) = size;
    let gap = frame.ems(DISTANCES[0]);
    let beyond = if below { y + gap } else { y - gap - height };
    let mut places = vec![
        (HPos::Center, Room::new(x - width / 2, beyond, size)),
        (HPos::Left, Room::new(x - gap / 2, beyond, size)),
        (HPos::Right, Room::new(x + gap / 2 - width, beyond, size)),
    ];
    for distance in DISTANCES {
        let away = frame.ems(distance);
        for top in [y - height / 2, if below { y - height / 4 } else { y - height * 3 / 4 }] {
            places.push((HPos::Left, Room::new(x + away, top, size)));
            places.push((HPos::Right, Room::new(x - away - width, top, size)));
        }
    }
    for distance in DISTANCES {
        let away = frame.ems(distance);
        let under = if below { y - away - height } else { y + away };
        places.push((HPos::Center, Room::new(x - width / 2, under, size)));
    }
    places
}
