//! Where there is room for a label.

use crate::diagram::{Diagram, Jump};
use crate::frame::Frame;
use crate::sketch::At;
use crate::style::Style;
use std::ops::Range;

/// Height of a label and width of a figure, in heights of the type; generous, since fonts differ.
const LABEL_HEIGHT: f64 = 0.95;
const FIGURE: f64 = 0.6;

/// Between a limit line, or the zero line, and a label, in heights of the type.
const LINE_REACH: f64 = 0.15;

/// Between the curve and a label, in heights of the type.
const CURVE_REACH: f64 = 0.2;

/// Around the step of a jump, in widths of the curve.
const JUMP_REACH: f64 = 2.0;

/// A box in units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room {
    pub left: i32,
    pub top: i32,
    pub right: i32,
    pub bottom: i32,
}

impl Room {
    pub fn new(left: i32, top: i32, (width, height): (i32, i32)) -> Self {
        Self { left, top, right: left + width, bottom: top + height }
    }

    fn grown(self, by: i32) -> Self {
        Self { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    fn overlaps(self, other: Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    /// True when a line from left to right runs through it.
    fn is_crossed(self, (ax, ay): At, (bx, by): At) -> bool {
        let (from, to) = (ax.max(self.left), bx.min(self.right));
        if from > to {
            return false;
        }
        let slope = f64::from(by - ay) / f64::from((bx - ax).max(1));
        let height = |x: i32| f64::from(ay) + slope * f64::from(x - ax);
        let (a, b) = if ax == bx { (f64::from(ay), f64::from(by)) } else { (height(from), height(to)) };
        a.min(b) < f64::from(self.bottom) && a.max(b) > f64::from(self.top)
    }
}

/// The plot, with what must not be covered.
pub(crate) struct Space<'a> {
    frame: &'a Frame,
    /// Points of the runs of the curve.
    runs: &'a [Range<usize>],
    taken: Vec<Room>,
}

impl<'a> Space<'a> {
    pub fn new(diagram: &Diagram, frame: &'a Frame, style: &Style, runs: &'a [Range<usize>]) -> Self {
        let jumps = diagram.jumps.iter().map(|jump| around_jump(frame, style, jump));
        let lines = diagram.limits.iter().copied().chain([0.0]).filter(|&value| frame.holds(value)).map(|value| {
            let (y, reach) = (frame.y(value), frame.ems(LINE_REACH));
            Room { left: frame.left, top: y - reach, right: frame.right, bottom: y + reach }
        });
        Self { frame, runs, taken: jumps.chain(lines).collect() }
    }

    /// Width and height of a label.
    pub fn size(&self, text: &str) -> (i32, i32) {
        (self.frame.ems(FIGURE * text.chars().count() as f64), self.frame.ems(LABEL_HEIGHT))
    }

    /// Nothing else may be put there.
    pub fn take(&mut self, room: Room) {
        self.taken.push(room);
    }

    /// Keeps labels off a dot.
    pub fn take_dot(&mut self, (x, y): At, radius: i32) {
        self.take(Room::new(x - radius, y - radius, (2 * radius, 2 * radius)));
    }

    /// True when a label may be put there. `points` are those of the sketch.
    pub fn is_free(&self, room: Room, points: &[At]) -> bool {
        let frame = self.frame;
        let inside =
            frame.left < room.left && frame.top <= room.top && room.right < frame.right && room.bottom <= frame.bottom;
        let wide = room.grown(frame.ems(CURVE_REACH));
        let crossed = |run: &Range<usize>| points[run.clone()].windows(2).any(|pair| wide.is_crossed(pair[0], pair[1]));
        inside && !self.taken.iter().any(|other| room.overlaps(*other)) && !self.runs.iter().any(crossed)
    }
}

fn around_jump(frame: &Frame, style: &Style, jump: &Jump) -> Room {
    let (x, reach) = (frame.x(jump.theta), frame.css(JUMP_REACH * style.stroke));
    let (a, b) = (frame.y_inside(jump.before), frame.y_inside(jump.after));
    Room { left: x - reach, top: a.min(b) - reach, right: x + reach, bottom: a.max(b) + reach }
}
