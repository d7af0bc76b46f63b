//! What is written on: sentences, formulas and tables in the language of the reader, in the units of the design.

use crate::document::{Block, Line, Table, formula, line};
use crate::layout::equation;
use crate::number;
use levalab_core::law::Arguments;
use levalab_core::{Cam, Column};
use levalab_format::report::scale_of;
use levalab_format::{CamStudy, Design, MotionUnits};
use levalab_formula::Formula;
use levalab_formula::curve::Written;
use levalab_words::Language;
pub use levalab_words::{Two, two};

/// Orders of the derivatives by their letters, per angle and per second.
pub const LETTERS: [&str; 4] = ["s", "v", "a", "j"];
pub const TIMED: [&str; 4] = ["s", "V", "A", "J"];

/// A board about one cam.
pub struct Board<'a> {
    pub study: &'a CamStudy,
    pub language: Language,
    pub blocks: Vec<Block>,
    /// The laws recognised so far, each with the first segment that has it.
    pub known_laws: Vec<KnownLaw>,
}

/// A law as books write it, if they do, with what its curve depends on. Recognising its numbers is slow, so it is done once.
pub struct KnownLaw {
    pub segment: usize,
    pub id: &'static str,
    pub arguments: Arguments,
    pub written: Option<Written>,
}

impl<'a> Board<'a> {
    pub fn new(study: &'a CamStudy, language: Language) -> Self {
        Self { study, language, blocks: Vec::new(), known_laws: Vec::new() }
    }

    pub fn design(&self) -> &'a Design {
        self.study.design()
    }

    pub fn cam(&self) -> &'a Cam {
        self.study.cam()
    }

    /// Words in the language of the board, each `{name}` replaced by what it stands for.
    pub fn words(&self, text: Two, values: &[(&str, &str)]) -> String {
        values.iter().fold(text.within(self.language).to_owned(), |text, (name, value)| {
            text.replace(&format!("{{{name}}}"), value)
        })
    }

    pub fn line(&self, text: Two, values: &[(&str, &str)]) -> Line {
        line(&self.words(text, values))
    }

    pub fn heading(&mut self, level: u8, text: Two, values: &[(&str, &str)]) {
        let line = self.line(text, values);
        self.blocks.push(Block::Heading(level, line));
    }

    pub fn say(&mut self, text: Two, values: &[(&str, &str)]) {
        let line = self.line(text, values);
        self.blocks.push(Block::Paragraph(line));
    }

    /// A formula from its notation.
    pub fn show(&mut self, notation: &str) {
        self.blocks.push(Block::Formula(match formula(notation) {
            Formula::Relation(first, rest) => equation(*first, rest),
            other => other,
        }));
    }

    /// An equation from its sides; what putting numbers in leaves as it was is not said twice.
    pub fn equate(&mut self, left: Formula, mut sides: Vec<(char, Formula)>) {
        sides.dedup_by(|(sign, side), before| *sign == '=' && *side == before.1);
        self.blocks.push(Block::Formula(equation(left, sides)));
    }

    pub fn list(&mut self, lines: Vec<Line>) {
        if !lines.is_empty() {
            self.blocks.push(Block::List(lines));
        }
    }

    /// A table, when it has rows.
    pub fn table(&mut self, caption: Two, heads: Vec<Line>, rows: Vec<Vec<Line>>) {
        if !rows.is_empty() {
            let caption = self.line(caption, &[]);
            self.blocks.push(Block::Table(Table { caption, heads, rows }));
        }
    }

    /// What a displacement of the core is multiplied by for the reader: 1, or degrees in a radian.
    pub fn scale(&self) -> f64 {
        scale_of(self.design(), Column::S)
    }

    pub fn swings(&self) -> bool {
        self.design().is_oscillating()
    }

    pub fn travels(&self) -> bool {
        self.design().kind.travel().is_some()
    }

    /// The unit of length, as it stands after a number in a formula.
    pub fn length(&self) -> String {
        format!(" {{{}}}", self.design().length_unit.symbol())
    }

    /// The unit of a derivative with respect to θ, as it stands after a number in a formula.
    pub fn unit(&self, order: usize) -> String {
        after_number(&MotionUnits::of(self.design()).unit(order as u8, false))
    }

    /// The unit of a derivative by time.
    pub fn timed_unit(&self, order: usize) -> String {
        after_number(&MotionUnits::of(self.design()).unit(order as u8, true))
    }

    /// A place that was typed, or follows from what was, with its unit.
    pub fn place(&self, theta: f64) -> String {
        self.placed(number::height(self.design().place(theta)))
    }

    /// A place that was solved for, with its unit.
    pub fn solved_place(&self, theta: f64) -> String {
        let place = self.design().place(theta);
        self.placed(if self.travels() { number::height(place) } else { number::angle(place) })
    }

    fn placed(&self, text: String) -> String {
        if self.travels() { text + &self.length() } else { text + "{°}" }
    }

    /// A displacement of the core, with its unit.
    pub fn height(&self, value: f64) -> String {
        self.figure(0, value) + &self.unit(0)
    }

    /// A derivative of the core, with its unit.
    pub fn derivative(&self, order: usize, value: f64) -> String {
        self.figure(order, value) + &self.unit(order)
    }

    /// A displacement or a derivative of the core; what is rounding beside the greatest is 0.
    pub fn settled(&self, order: usize, value: f64) -> f64 {
        let summary = &self.study.analysis().summary;
        let extremes = [summary.s, summary.v, summary.a, summary.j][order];
        number::settled(value, extremes.greatest_size().0)
    }

    /// The same as the reader has it.
    pub fn figure(&self, order: usize, value: f64) -> String {
        let settled = self.settled(order, value) * self.scale();
        if order == 0 { number::height(settled) } else { number::result(settled) }
    }

    /// A derivative of the core by time.
    pub fn timed_figure(&self, order: usize, value: f64) -> String {
        number::result(self.settled(order, value) * self.scale() * self.design().omega().powi(order as i32))
    }
}

/// A cell with a formula in it.
pub fn cell(notation: &str) -> Line {
    line(&format!("${notation}$"))
}

/// A unit as it stands after a number in a formula.
fn after_number(unit: &str) -> String {
    match unit {
        "" => String::new(),
        "°" => "{°}".into(),
        _ => format!(" {{{unit}}}"),
    }
}
