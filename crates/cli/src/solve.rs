//! `levalab solve`: the worked solution of a design.

use crate::failure::Failure;
use crate::input;
use levalab_format::Design;
use levalab_solve::{Request, Symbols, latex, markdown, page, solve};
use levalab_words::Language;

/// What is asked of a solution.
#[derive(clap::Args)]
pub struct Options {
    /// Design file.
    file: String,
    /// The only segment to work out, counted from 1.
    #[arg(long, value_name = "K", allow_negative_numbers = true)]
    segment: Option<usize>,
    /// Where numbers are put into the formulas: degrees, or length for a cam that travels; where |v| is greatest when left out.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    theta: Option<f64>,
    /// What to write: Markdown with formulas in LaTeX, a LaTeX document, or a page with MathML.
    #[arg(long, value_enum, default_value_t = Writer::Markdown)]
    to: Writer,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Writer {
    /// Markdown, with formulas in LaTeX between dollar signs.
    Markdown,
    /// A LaTeX document.
    Latex,
    /// An HTML page, with formulas in MathML.
    Html,
}

/// The solution as text.
pub fn run(options: &Options, language: Language) -> Result<String, Failure> {
    let study = input::study(&options.file, 1, language)?;
    let most = study.segments();
    if let Some(found) = options.segment.filter(|k| !(1..=most).contains(k)) {
        let said = match language {
            Language::En => format!("The design has segments 1 to {most}, and no segment {found}."),
            Language::Es => format!("El diseño tiene los tramos 1 a {most}, y ningún tramo {found}."),
        };
        return Err(Failure::usage(format!("--segment: {said}")));
    }
    if let Some(said) = options.theta.and_then(|theta| wrong_place(theta, study.design(), language)) {
        return Err(Failure::usage(format!("--theta: {said}")));
    }
    let segment = options.segment.map(|k| k - 1);
    let symbols = Symbols::of(study.design());
    let request = Request { language, theta: options.theta, segment, symbols };
    let document = solve(&study, &request);
    Ok(match options.to {
        Writer::Markdown => markdown(&document, language),
        Writer::Latex => latex(&document, language),
        Writer::Html => page(&document, language),
    })
}

/// Degrees to either side that a place may have: an `f64` then still holds the angle within the turn to 10⁻⁹ of a degree.
const MAX_DEGREES: f64 = 1e6;

/// What is wrong with a place where numbers are to be put in: it lies beyond the travel, or so far on that no angle is left.
fn wrong_place(theta: f64, design: &Design, language: Language) -> Option<String> {
    let (least, most) = design.kind.travel().map_or((-MAX_DEGREES, MAX_DEGREES), |length| (0.0, length));
    let [from, to] = [least, most].map(|value| language.exact(value));
    let said = match language {
        Language::En => format!("It must be a number from {from} to {to}."),
        Language::Es => format!("Tiene que ser un número de {from} a {to}."),
    };
    (!(least..=most).contains(&theta)).then_some(said)
}
