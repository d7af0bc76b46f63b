//! Diagrams with the names and units that the page writes beside its own.

use crate::svg::{escaped, short};
use crate::words::Word;
use crate::{Refusal, Subject};
use levalab_chart::{Diagram, Quantity, Style, Timing, colour, svg};
use levalab_core::Analysis;
use levalab_core::application::Output;
use levalab_words::{Language, Signs};
use std::fmt::Write;

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DiagramChoice {
    /// s, v, a and j above each other.
    Svaj,
    /// One of them, φ or ρ.
    One(Quantity),
    /// What comes out of the application, with the points to hit; per second, against time.
    Application,
}

impl DiagramChoice {
    /// Every choice, in the order of a menu.
    #[must_use]
    pub fn all() -> Vec<Self> {
        [Self::Svaj].into_iter().chain(Quantity::ALL.into_iter().map(Self::One)).chain([Self::Application]).collect()
    }

    /// Its name in options.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Svaj => "svaj",
            Self::One(Quantity::PressureAngle) => "pressure-angle",
            Self::One(quantity) => quantity.name(),
            Self::Application => "application",
        }
    }

    /// The choice of that name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|choice| choice.name() == name)
    }
}

/// A diagram with its caption.
struct Plot {
    diagram: Diagram,
    letter: &'static str,
    name: String,
    unit: String,
    /// What lies along the axis, where it is not θ.
    against: &'static str,
    look: (&'static str, &'static [f64]),
}

/// Width of the drawing, CSS pixels.
const WIDTH: f64 = 720.0;

/// Height of a plot that stands alone, of one of two, and of one among four.
const ALONE: f64 = 300.0;
const PAIRED: f64 = 220.0;
const AMONG: f64 = 150.0;

/// Height of the line with its name.
const HEAD: f64 = 22.0;

/// Room for the title.
const TITLE: f64 = 28.0;

const MARGIN: f64 = 10.0;

/// Rows that are drawn.
const STEPS: usize = 720;

/// A diagram, or several above each other, as SVG text, derivatives by angle or by time.
///
/// # Errors
/// When this follower has no such quantity, or the design no application.
pub fn diagram_svg(subject: &Subject, choice: DiagramChoice, per_second: bool) -> Result<String, Refusal> {
    let study = subject.study.first().with_rows(STEPS);
    let analysis = study.analysis();
    let plots = match choice {
        DiagramChoice::Svaj => of_motion(subject, analysis, &SVAJ, per_second),
        DiagramChoice::One(quantity) if !quantity.applies(subject.cam()) => return Err(Refusal::NoSuchDiagram),
        DiagramChoice::One(quantity) => of_motion(subject, analysis, &[quantity], per_second),
        DiagramChoice::Application => of_application(subject, analysis, per_second).ok_or(Refusal::NoApplication)?,
    };
    Ok(stacked(subject, &plots))
}

const SVAJ: [Quantity; 4] = [Quantity::S, Quantity::V, Quantity::A, Quantity::J];

fn of_motion(subject: &Subject, analysis: &Analysis, quantities: &[Quantity], per_second: bool) -> Vec<Plot> {
    let timing = if per_second { Timing::PerSecond(subject.design().omega()) } else { Timing::PerRadian };
    let plot = |&quantity: &Quantity| {
        let (letter, name, unit) = naming(subject, quantity, per_second);
        let diagram = Diagram::of(quantity, subject.cam(), analysis, timing);
        Plot { diagram, letter, name: name.to_owned(), unit, against: "", look: look(quantity) }
    };
    quantities.iter().map(plot).collect()
}

/// Every output, the points to hit in the main one; none when nothing is driven.
fn of_application(subject: &Subject, analysis: &Analysis, against_time: bool) -> Option<Vec<Plot>> {
    let set = subject.design().application.as_ref()?;
    let (values, omega) = (set.core_values(), subject.design().omega());
    let targets = set.outcome(subject.design(), subject.cam(), analysis).targets;
    let targets: Vec<(f64, f64)> = targets.iter().map(|target| (target.theta, target.value)).collect();
    let plot = |(k, output): (usize, &'static Output)| {
        let own = if k == set.output { targets.as_slice() } else { &[] };
        let diagram = Diagram::of_output(output, &values, subject.cam(), analysis, omega, own);
        Plot {
            diagram: if against_time { diagram.against_time(omega) } else { diagram },
            letter: output.symbol,
            name: levalab_words::part_name(subject.language, output.id).to_owned(),
            unit: subject.design().length_unit.unit_of(output.magnitude).to_owned(),
            against: if against_time { ", t (s)" } else { "" },
            look: OUTPUT_LOOKS[k.min(1)],
        }
    };
    Some(set.application.outputs.iter().enumerate().map(plot).collect())
}

/// Colour and dashes of the outputs of an application, the main one first, as on the page.
const OUTPUT_LOOKS: [(&str, &[f64]); 2] = [("#006a73", &[]), ("#8a3d00", &[7.0, 3.0])];

fn stacked(subject: &Subject, plots: &[Plot]) -> String {
    let each = match plots.len() {
        1 => ALONE,
        2 => PAIRED,
        _ => AMONG,
    };
    let mut drawn = String::new();
    let mut y = TITLE + MARGIN;
    for (k, plot) in plots.iter().enumerate() {
        let style = style(plot.look, subject.language, each, k + 1 == plots.len());
        // Writing into a String cannot fail.
        let _ = writeln!(
            drawn,
            "<text x=\"{MARGIN}\" y=\"{}\" font-size=\"12\" fill=\"#16191d\"><tspan font-style=\"italic\" font-weight=\"bold\" \
             fill=\"{}\">{}</tspan> {} ({}){}</text>",
            short(y + HEAD - 7.0),
            plot.look.0,
            plot.letter,
            plot.name,
            plot.unit,
            plot.against
        );
        let (picture, _) = svg(&plot.diagram, &style);
        drawn += &picture.replacen("<svg ", &format!("<svg x=\"{MARGIN}\" y=\"{}\" ", short(y + HEAD)), 1);
        y += HEAD + style.height;
    }
    let (width, height, title) = (WIDTH + 2.0 * MARGIN, y + MARGIN, escaped(&subject.design().title));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\">\n\
         <title>{title}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n\
         <text x=\"{MARGIN}\" y=\"{TITLE}\" font-size=\"16\" font-weight=\"bold\" fill=\"#16191d\">{title}</text>\n{drawn}</svg>\n",
        short(width),
        short(height)
    )
}

fn style((curve, dash): (&str, &[f64]), language: Language, height: f64, last: bool) -> Style {
    let usual = Style::default();
    Style {
        width: WIDTH,
        height: if last { height + (Style::FOOT * usual.font_size).round() } else { height },
        curve: colour(curve).unwrap_or(usual.curve),
        dash: dash.to_vec(),
        x_labels: last,
        decimal_sign: language.decimal_sign(),
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
        Quantity::Rho | Quantity::Contact => subject.design().length_unit.symbol().to_owned(),
        _ => subject.unit(order, per_second),
    };
    (Signs::of(subject.design().notation).symbol(letters[usize::from(per_second)]), word.said(subject.language), unit)
}
