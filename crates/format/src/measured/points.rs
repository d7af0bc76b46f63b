//! From columns to the points of a curve: which column is the angle, in what it is measured, and where the curve closes.

use super::reduce::Ends;
use super::{Measured, MeasuredProblem, Row};
use crate::Design;
use crate::report::tidy;
use levalab_core::{Cycle, Svaj};

/// Points of a measured curve, in the units of a design: degrees from the first point, and the displacement.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The points, the first of them at 0.
    pub points: Vec<[f64; 2]>,
    /// The angle of the first point as it was measured.
    pub first: f64,
    /// True when the end of the turn was not in the text, and is the first point once more.
    pub is_completed: bool,
    /// True when the angles were in radians.
    pub is_in_radians: bool,
}

/// A turn, degrees.
const TURN: f64 = 360.0;

/// A gap before the end of a turn counts as one step when it is no more than so many of the largest steps.
const ONE_STEP: f64 = 1.5;

/// Points in larger steps, degrees, are no turn that lacks its end but a part of one.
const LARGEST_STEP: f64 = 15.0;

/// How far the span of a column may be from a turn and still be taken for one, as a part of it.
const NEARLY_A_TURN: f64 = 0.02;

/// A column rises when all of its steps but one in so many do.
const MOSTLY: usize = 4;

/// Beginnings of headings of a column of angles, in small letters.
const ANGLE_HEADINGS: [&str; 14] =
    ["angle", "theta", "θ", "áng", "Áng", "ang", "crank", "cam a", "phi", "φ", "rot", "master", "winkel", "grado"];

/// Beginnings of headings of a column of displacements, in small letters.
const LIFT_HEADINGS: [&str; 10] = ["lift", "displ", "desp", "elev", "alz", "stroke", "carrera", "slave", "hub", "rise"];

impl Measured {
    /// The columns that are most likely angle and displacement.
    #[must_use]
    pub fn guess(&self) -> [usize; 2] {
        let numbers: Vec<usize> = (0..self.columns.len()).filter(|&k| self.columns[k].is_number).collect();
        if let [first, second] = numbers[..] {
            // Without a heading that says otherwise they are in the usual order.
            let swapped = self.is_named_angle(second) && !self.is_named_angle(first);
            return if swapped { [second, first] } else { [first, second] };
        }
        // Of equally likely ones the first.
        let best = |score: &dyn Fn(usize) -> i32| numbers.iter().copied().rev().max_by_key(|&k| score(k)).unwrap_or(0);
        let angle = best(&|k| self.angle_score(k));
        [angle, best(&|k| if k == angle { i32::MIN } else { self.lift_score(k) + i32::from(k > angle) })]
    }

    /// The points of two columns, in the order of the angle.
    ///
    /// # Errors
    /// Names the line that has no number there, or whose angle does not come after the one before it.
    pub fn curve(&self, angle: usize, lift: usize) -> Result<Curve, MeasuredProblem> {
        if angle == lift || angle.max(lift) >= self.columns.len() {
            return Err(MeasuredProblem::Columns);
        }
        let mut points: Vec<[f64; 2]> = Vec::with_capacity(self.len() + 1);
        let is_in_radians = self.is_in_radians(angle);
        let last = self.len().saturating_sub(1);
        for (k, row) in self.rows.iter().enumerate() {
            let (found, s) = (row.value(angle)?, row.value(lift)?);
            let mut at = if is_in_radians { tidy(found.to_degrees()) } else { found };
            if let (Some(first), Some(before)) = (points.first(), points.last()) {
                // The end of a turn is often written as its beginning.
                if k == last && at == first[0] && tidy(first[0] + TURN) > before[0] {
                    at = tidy(first[0] + TURN);
                }
                if at <= before[0] {
                    return Err(MeasuredProblem::Unordered { line: row.line, found: at, before: before[0] });
                }
            }
            points.push([at, s]);
        }
        if points.len() < 2 {
            return Err(MeasuredProblem::TooFewPoints { found: points.len() });
        }
        let first = points[0][0];
        for point in &mut points {
            point[0] = tidy(point[0] - first);
        }
        Ok(Curve { points, first, is_completed: false, is_in_radians })
    }

    /// The first two columns of numbers as they stand, in any order.
    ///
    /// # Errors
    /// Names the line that lacks one of them.
    pub fn pairs(&self) -> Result<Vec<[f64; 2]>, MeasuredProblem> {
        let mut numbers = (0..self.columns.len()).filter(|&k| self.columns[k].is_number);
        let (Some(first), Some(second)) = (numbers.next(), numbers.next()) else { return Ok(Vec::new()) };
        let pair = |row: &Row| row.value(first).and_then(|one| Ok([one, row.value(second)?]));
        self.rows.iter().map(pair).collect()
    }

    fn is_in_radians(&self, angle: usize) -> bool {
        let column = &self.columns[angle];
        column.unit.eq_ignore_ascii_case("rad") || column.heading.eq_ignore_ascii_case("rad")
    }

    fn is_named_angle(&self, column: usize) -> bool {
        let heading = self.columns[column].heading.to_ascii_lowercase();
        ANGLE_HEADINGS.iter().any(|beginning| heading.starts_with(beginning)) || self.is_in_radians(column)
    }

    fn angle_score(&self, column: usize) -> i32 {
        let values: Vec<f64> = self.sample(column).collect();
        let steps = values.len().saturating_sub(1);
        let rises = values.windows(2).filter(|pair| pair[0] < pair[1]).count();
        // A slip, or an end that is the beginning once more, does not make another column of it.
        let rising = steps > 0 && rises * MOSTLY >= steps * (MOSTLY - 1);
        let span = values.iter().fold(f64::MIN, |most, value| most.max(*value)) - values.first().unwrap_or(&0.0);
        let turn = if self.is_in_radians(column) { TURN.to_radians() } else { TURN };
        let turns = (span / turn - 1.0).abs() < NEARLY_A_TURN;
        4 * i32::from(self.is_named_angle(column)) + 4 * i32::from(rising) + 2 * i32::from(turns)
            - i32::from(!turns && self.is_counted(column))
    }

    fn lift_score(&self, column: usize) -> i32 {
        let heading = self.columns[column].heading.to_ascii_lowercase();
        let named =
            heading == "s" || heading == "h" || LIFT_HEADINGS.iter().any(|beginning| heading.starts_with(beginning));
        let first = self.sample(column).next();
        let changes = self.sample(column).any(|value| Some(value) != first);
        4 * i32::from(named) + 2 * i32::from(changes) - i32::from(self.is_counted(column))
    }

    /// True when a column counts the lines, from 0 or 1.
    fn is_counted(&self, column: usize) -> bool {
        (0..).zip(self.sample(column)).all(|(k, value)| value == f64::from(k) || value == f64::from(k + 1))
    }
}

impl Curve {
    /// The curve with the end of its turn, when the points stop one step before it.
    #[must_use]
    pub fn completed(mut self) -> Self {
        let (Some(&[_, start]), Some(&[end, _])) = (self.points.first(), self.points.last()) else { return self };
        let step = self.points.windows(2).map(|pair| pair[1][0] - pair[0][0]).fold(0.0, f64::max);
        let gap = TURN - end;
        if gap > 0.0 && gap <= ONE_STEP * step && step <= LARGEST_STEP {
            self.points.push([TURN, start]);
            self.is_completed = true;
        }
        self
    }
}

/// What a table of a design is joined to at the ends of a segment, in the units of the design; the table itself may be any.
#[must_use]
pub fn measured_ends(design: &Design, segment: usize) -> Ends {
    let count = design.segments.len();
    let cycle = design.kind.cycle();
    let round = cycle == Cycle::Turn;
    if round && count == 1 {
        return Ends::Joined;
    }
    let Ok(cam) = design.cam() else { return Ends::Free };
    let (up, along) = (design.lift().to_core(1.0), design.stride().to_core(1.0));
    let edge = |neighbour: usize, end: bool| {
        let law = design.segments.get(neighbour)?.law;
        if law.free().is_some() || law.is_matched() {
            return None;
        }
        let mut own = cam.program.stretches().iter().filter(|stretch| stretch.segment == neighbour);
        let motion = if end { own.next_back().map(|s| s.at(s.to)) } else { own.next().map(|s| s.at(s.from)) }?;
        let scaled = motion * (1.0 / up);
        Some(Svaj::new(scaled.s, scaled.v * along, scaled.a * along.powi(2), scaled.j * along.powi(3)))
    };
    let before = (round || segment > 0).then(|| edge((segment + count - 1) % count, true)).flatten();
    let after = (round || segment + 1 < count).then(|| edge((segment + 1) % count, false)).flatten();
    Ends::Held(before, after)
}
