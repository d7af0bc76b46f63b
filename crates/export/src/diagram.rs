//! Diagrams with the names and units that the page writes beside its own.

use crate::svg::{escaped, short};
use crate::words::Word;
use crate::{Refusal, Subject};
use levalab_chart::{Diagram, Quantity, Style, Timing, colour, svg};
use levalab_core::Analysis;
use levalab_words::{Language, Signs};
use std::fmt::Write;

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DiagramChoice {
    /// s, v, a and j above each other.
    Svaj,
    /// One of them, φ or ρ.
    One(Quantity),
}

impl DiagramChoice {
    /// Every choice, in the order of a menu.
    #[must_use]
    pub fn all() -> Vec<Self> {
        [Self::Svaj].into_iter().chain(Quantity::ALL.into_iter().map(Self::One)).collect()
    }

    /// Its name in options.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Svaj => "svaj",
            Self::One(Quantity::PressureAngle) => "pressure-angle",
            Self::One(quantity) => quantity.name(),
        }
    }

    /// The choice of that name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|choice| choice.name() == name)
    }

    fn quantities(self) -> Vec<Quantity> {
        match self {
            Self::Svaj => vec![Quantity::S, Quantity::V, Quantity::A, Quantity::J],
            Self::One(quantity) => vec![quantity],
        }
    }
}

/// Width of the drawing, CSS pixels.
const WIDTH: f64 = 720.0;

/// Height of a plot that stands alone, and of one among four.
const ALONE: f64 = 300.0;
const AMONG: f64 = 150.0;

/// Height of the line with its name.
const HEAD: f64 = 22.0;

/// Room for the title.
const TITLE: f64 = 28.0;

const MARGIN: f64 = 10.0;

/// Rows that are drawn.
const STEPS: usize = 720;

/// A diagram, or four, as SVG text, derivatives by angle or by time.
///
/// # Errors
/// When this follower has no such quantity.
pub fn diagram_svg(subject: &Subject, choice: DiagramChoice, per_second: bool) -> Result<String, Refusal> {
    if let DiagramChoice::One(quantity) = choice
        && !quantity.applies(subject.cam)
    {
        return Err(Refusal::NoSuchDiagram);
    }
    let analysis = Analysis::of(subject.cam, STEPS);
    let timing = if per_second { Timing::PerSecond(subject.design.omega()) } else { Timing::PerRadian };
    let quantities = choice.quantities();
    let each = if quantities.len() > 1 { AMONG } else { ALONE };
    let mut plots = String::new();
    let mut y = TITLE + MARGIN;
    for (k, quantity) in quantities.iter().enumerate() {
        let last = k + 1 == quantities.len();
        let style = style(*quantity, subject.language, each, last);
        let (ink, _) = look(*quantity);
        let (drawn, _) = svg(&Diagram::of(*quantity, subject.cam, &analysis, timing), &style);
        let (letter, name, unit) = naming(subject, *quantity, per_second);
        // Writing into a String cannot fail.
        let _ = writeln!(
            plots,
            "<text x=\"{MARGIN}\" y=\"{}\" font-size=\"12\" fill=\"#16191d\"><tspan font-style=\"italic\" font-weight=\"bold\" \
             fill=\"{}\">{letter}</tspan> {name} ({unit})</text>",
            short(y + HEAD - 7.0),
            ink
        );
        plots += &drawn.replacen("<svg ", &format!("<svg x=\"{MARGIN}\" y=\"{}\" ", short(y + HEAD)), 1);
        y += HEAD + style.height;
    }
    let (width, height, title) = (WIDTH + 2.0 * MARGIN, y + MARGIN, escaped(&subject.design.title));
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\">\n\
         <title>{title}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n\
         <text x=\"{MARGIN}\" y=\"{TITLE}\" font-size=\"16\" font-weight=\"bold\" fill=\"#16191d\">{title}</text>\n{plots}</svg>\n",
        short(width),
        short(height)
    ))
}

fn style(quantity: Quantity, language: Language, height: f64, last: bool) -> Style {
    let (curve, dash) = look(quantity);
    let usual = Style::default();
    Style {
        width: WIDTH,
        height: if last { height + (Style::FOOT * usual.font_size).round() } else { height },
        curve: colour(curve).unwrap_or(usual.curve),
        dash: dash.to_vec(),
        x_labels: last,
        decimal_comma: language == Language::Es,
        ..usual
    }
}

/// Colour and dashes of a quantity, the same as on the page.
fn look(quantity: Quantity) -> (&'static str, &'static [f64]) {
    match quantity {
        Quantity::S => ("#0068a4", &[]),
        Quantity::V => ("#00735a", &[9.0, 3.0]),
        Quantity::A => ("#b04300", &[4.0, 2.5]),
        Quantity::J => ("#a03678", &[1.5, 2.5]),
        Quantity::PressureAngle => ("#7d5a00", &[10.0, 3.0, 2.0, 3.0]),
        Quantity::Rho => ("#5a4bb8", &[6.0, 2.5, 1.5, 2.5, 1.5, 2.5]),
        Quantity::Contact => ("#3f6600", &[14.0, 3.5]),
    }
}

/// Letter, name and unit of a quantity.
fn naming(subject: &Subject, quantity: Quantity, per_second: bool) -> (&'static str, &'static str, String) {
    let (word, letters, order) = match quantity {
        Quantity::S => (Word::Displacement, ["s", "s"], 0),
        Quantity::V => (Word::Velocity, ["v", "V"], 1),
        Quantity::A => (Word::Acceleration, ["a", "A"], 2),
        Quantity::J => (Word::Jerk, ["j", "J"], 3),
        Quantity::PressureAngle => (Word::PressureAngle, ["φ", "φ"], 0),
        Quantity::Rho => (Word::Curvature, ["ρ", "ρ"], 0),
        Quantity::Contact => (Word::Contact, ["q", "q"], 0),
    };
    let unit = match quantity {
        Quantity::PressureAngle => "°".to_owned(),
        Quantity::Rho | Quantity::Contact => subject.design.length_unit.symbol().to_owned(),
        _ => subject.unit(order, per_second),
    };
    (Signs::of(subject.design.notation).symbol(letters[usize::from(per_second)]), word.said(subject.language), unit)
}
