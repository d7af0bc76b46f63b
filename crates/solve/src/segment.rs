//! One segment: its conditions, its formulas with numbers put in, and where its derivatives vanish.

mod free;
mod pieces;
mod unit;

pub use pieces::sided;

use crate::board::{Board, two};
use crate::{extremes, number, system};
use levalab_core::law::Shape;
use levalab_core::{Form, Segment, Stretch};
use pieces::formulas;

/// A segment of the motion with what belongs to it.
pub struct Part<'a> {
    pub segment: &'a Segment,
    pub from: f64,
    pub to: f64,
    pub start: f64,
    pub stretches: Vec<&'a Stretch>,
}

impl<'a> Part<'a> {
    pub fn of(board: &Board<'a>, k: usize) -> Self {
        let program = &board.cam().program;
        Self {
            segment: &program.segments()[k],
            from: program.borders()[k],
            to: program.borders()[k + 1],
            start: program.heights()[k],
            stretches: program.stretches().iter().filter(|stretch| stretch.segment == k).collect(),
        }
    }

    pub fn beta(&self) -> f64 {
        self.to - self.from
    }

    /// The curve of a segment that has only one, in x.
    pub fn whole(&self) -> Option<&'a Form> {
        match self.stretches[..] {
            [only] if !self.has_own_variable(only) => Some(only.formula().0),
            _ => None,
        }
    }

    /// True when the variable of a stretch is not the x of the segment.
    fn has_own_variable(&self, stretch: &Stretch) -> bool {
        /// Radians that tell two places apart.
        const NEAR: f64 = 1e-9;
        let (_, origin, beta) = stretch.formula();
        (origin - self.from).abs() > NEAR || (beta - self.beta()).abs() > NEAR
    }
}

/// Writes segment `k`.
pub fn write(board: &mut Board, k: usize) {
    let part = Part::of(board, k);
    let (from, to) = (board.place(part.from), board.place(part.to));
    let law = levalab_words::law(board.language, part.segment.law);
    board.heading(
        2,
        two("Segment {n}: {law}, $ {from} ≤ θ ≤ {to}$", "Tramo {n}: ley {law}, $ {from} ≤ θ ≤ {to}$"),
        &[("n", &(k + 1).to_string()), ("law", law), ("from", &from), ("to", &to)],
    );
    if part.stretches.iter().all(|stretch| stretch.is_still()) {
        let height = board.height(part.start);
        board.say(two("The follower rests:", "El seguidor está en reposo:"), &[]);
        board.show(&format!("s = {height}, v = 0, a = 0, j = 0"));
        return;
    }
    variable(board, "x", part.from, part.beta());
    match part.segment.law.shape {
        Shape::Rest => {}
        Shape::Unit(_) => unit::write(board, &part, k),
        Shape::Matched(orders) => {
            system::between_neighbours(board, &part, orders);
            formulas(board, &part);
        }
        Shape::Free(_) => free::write(board, &part),
    }
    extremes::within(board, &part);
}

/// x = (θ − 90°)/60°, β = 60° = 1.0472 rad
fn variable(board: &mut Board, letter: &str, from: f64, beta: f64) {
    let of = if letter == "x" { "β" } else { "β_u" };
    let above = match board.place(from) {
        _ if from == 0.0 => "θ".to_owned(),
        before if before.starts_with('-') => format!("θ + {}", before.trim_start_matches('-')),
        after => format!("θ - {after}"),
    };
    let own = board.place(beta);
    let radians = if board.travels() { String::new() } else { format!(" = {} {{rad}}", number::result(beta)) };
    board.show(&format!("{letter} = ({above})/({own}), {of} = {own}{radians}"));
}
