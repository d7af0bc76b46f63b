//! The words under the drawing: what each line is, the scale, and a line to check the printer by.

use super::look::{OUTLINE, stroke};
use super::{MARGIN, Sheet};
use crate::Subject;
use crate::curves::{Curve, Role, Shape};
use crate::paper::scale_name;
use crate::svg::{short, through};
use crate::words::Word;
use levalab_core::Point;
use levalab_words::Signs;
use std::fmt::Write;

/// From line to line, mm.
const LINE: f64 = 5.0;

/// Room for the line of 100 mm, mm.
const CHECK: f64 = 12.0;

/// The least width, which its words need and the line of 100 mm, mm.
pub(super) const LEAST_WIDTH: f64 = 108.0;

/// From this width on, the names of the lines stand in two columns, mm.
const TWO_COLUMNS: f64 = 165.0;

const INK: &str = "#16191d";

impl Sheet {
    /// What each line is, the scale, and the line to check it by.
    pub(super) fn legend(&self, text: &mut String, subject: &Subject, curves: &[Curve], title: &str) {
        let said = |word: Word| word.said(subject.language);
        let mut y = self.height - self.legend;
        let caption = format!("{title} · {} {}", said(Word::Scale), scale_name(self.scale));
        self.words(text, MARGIN, y, &caption, "font-weight=\"bold\"");
        let mut entries: Vec<&Curve> = curves.iter().filter(|curve| has_name(curve)).collect();
        entries.sort_by_key(|curve| (curve.second, order(curve.role)));
        let columns = columns(self.width);
        let column = (self.width - 2.0 * MARGIN) / columns as f64;
        for (k, curve) in entries.into_iter().enumerate() {
            let x = MARGIN + column * (k % columns) as f64;
            if k % columns == 0 {
                y += LINE;
            }
            let sample = through([Point::new(x, y - 1.0), Point::new(x + 9.0, y - 1.0)], false);
            let _ = writeln!(text, "<path {} d=\"{sample}\"/>", stroke(curve));
            self.words(text, x + 11.0, y, &name(subject, curve), "");
        }
        if self.check {
            self.check_line(text, said(Word::Check));
        }
    }

    fn check_line(&self, text: &mut String, words: &str) {
        let y = self.height - 7.0;
        let mut data = through([Point::new(MARGIN, y), Point::new(MARGIN + 100.0, y)], false);
        for k in 0..=10 {
            let x = MARGIN + 10.0 * f64::from(k);
            let tick = if k % 5 == 0 { 2.4 } else { 1.4 };
            data += &through([Point::new(x, y), Point::new(x, y - tick)], false);
        }
        let _ =
            writeln!(text, "<path class=\"check\" stroke=\"{INK}\" stroke-width=\"{}\" d=\"{data}\"/>", OUTLINE / 2.0);
        self.words(text, MARGIN, y + LINE, words, "");
    }

    fn words(&self, text: &mut String, x: f64, y: f64, words: &str, look: &str) {
        let space = if look.is_empty() { "" } else { " " };
        let _ =
            writeln!(text, "<text x=\"{}\" y=\"{}\" fill=\"{INK}\"{space}{look}>{words}</text>", short(x), short(y));
    }
}

/// The second cam of a pair is told by its profile and its base circle.
pub(super) fn has_name(curve: &Curve) -> bool {
    match curve.role {
        Role::Bore => false,
        Role::Profile | Role::Base => true,
        Role::Outer | Role::Pitch | Role::Prime => !curve.second,
    }
}

/// Columns in which the names of the lines stand.
fn columns(width: f64) -> usize {
    if width < TWO_COLUMNS { 1 } else { 2 }
}

/// Height of the words under the drawing: the title, then the names of the lines.
pub(super) fn legend_height(width: f64, names: usize, check: bool) -> f64 {
    let lines = 1 + names.div_ceil(columns(width));
    lines as f64 * LINE + if check { CHECK } else { 0.0 }
}

/// The place of a line in the list of names.
fn order(role: Role) -> usize {
    [Role::Profile, Role::Outer, Role::Pitch, Role::Base, Role::Prime]
        .iter()
        .position(|known| *known == role)
        .unwrap_or(0)
}

/// The name of a curve, with its radius when it is a circle.
fn name(subject: &Subject, curve: &Curve) -> String {
    let language = subject.language;
    let word = match curve.role {
        Role::Profile => Word::Profile,
        Role::Outer => Word::OuterWall,
        Role::Pitch => Word::PitchCurve,
        Role::Base if subject.travels() => Word::BaseLine,
        Role::Base => Word::BaseCircle,
        Role::Prime => Word::PrimeCircle,
        Role::Bore => Word::Bore,
    };
    let radius = match curve.shape {
        Shape::Circle(radius) => {
            let symbol = if curve.role == Role::Prime { "R_p" } else { "R_b" };
            let symbol = Signs::of(subject.design().notation).plain(symbol);
            format!(", {symbol} = {} {}", language.number(radius), subject.design().length_unit.symbol())
        }
        Shape::Closed(_) | Shape::Open(_) => String::new(),
    };
    let name = format!("{}{radius}", word.said(language));
    if curve.second { levalab_words::of_second_cam(language, &name) } else { name }
}
