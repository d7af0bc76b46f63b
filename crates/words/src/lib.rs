//! What LevaLab says about a cam, in English and Spanish, for the page and the command line alike.
//!
//! Every sentence is written by hand in each language (`en/`, `es/`); both say the same things, since a sentence that one of
//! them lacks does not compile. Numbers are written as the language does ([`Language::number`]).
//!
//! ```
//! use levalab_core::Analysis;
//! use levalab_format::{example, report::Report};
//! use levalab_words::{Language, headline};
//!
//! let design = example("9RT").unwrap();
//! let cam = design.cam()?;
//! let report = Report::of(&design, &cam, &Analysis::of(&cam, 720));
//! assert_eq!(headline(Language::En, &report), "Not for high speeds: the jerk jumps at 6 joints.");
//! assert_eq!(headline(Language::Es, &report), "No apta para altas velocidades: la sobreaceleración salta en 6 uniones.");
//! # Ok::<(), levalab_format::DesignError>(())
//! ```
//!
//! Not here: the labels of the page's own buttons and fields.

mod application;
mod en;
mod es;
mod join;
mod measured;
mod notation;
mod number_problem;
mod pair;
mod units;
mod voice;

pub use application::{application_name, application_title, outcome, part_head, part_name};
pub use levalab_catalogue::{Language, Two, capital, two};
pub use measured::{measured_note, measured_problem};
pub use notation::{SIGNS, Signs};
pub use number_problem::number_problem;
pub use pair::no_second;
pub use voice::FileProblem;

pub use join::choices as join_choices;

use levalab_catalogue::{follower_label, kind_label, law_label};
use levalab_core::{FindingKind, FollowerKind, Law, Level};
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Design, DesignError, Remedy};
use units::Units;
use voice::Voice;

/// What a language says.
fn voice(language: Language) -> &'static dyn Voice {
    match language {
        Language::En => &en::English,
        Language::Es => &es::Spanish,
    }
}

/// The name of a law, as it is said before or after the word *law*: `cycloidal`.
#[must_use]
pub fn law(language: Language, law: &Law) -> &'static str {
    law_label(law).map_or(law.id, |label| label.noun.within(language))
}

/// The name of a law where it stands alone, as in the cell of a table: `dwell`.
#[must_use]
pub fn law_alone(language: Language, law: &Law) -> &'static str {
    law_label(law).map_or(law.id, |label| label.alone.within(language))
}

/// The name of a follower, as within a sentence: `oscillating roller follower`.
#[must_use]
pub fn follower(language: Language, kind: &FollowerKind) -> &'static str {
    follower_label(kind).map_or(kind.id, |label| label.noun.within(language))
}

/// The name of a kind of cam from its word in design files: `cam of constant breadth`.
#[must_use]
pub fn cam_kind(language: Language, word: &'static str) -> &'static str {
    kind_label(word).map_or(word, |label| label.noun.within(language))
}

/// What the second cam of a conjugate pair is called, at the head of a line.
#[must_use]
pub fn second_cam(language: Language) -> &'static str {
    voice(language).second_cam()
}

/// Something said of the second cam of a pair in one line: its own beginning goes on in the sentence, without its capital.
#[must_use]
pub fn of_second_cam(language: Language, text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map_or_else(String::new, |first| first.to_lowercase().collect());
    format!("{}, {first}{}", second_cam(language), letters.as_str())
}

/// A note on a pair whose two profiles are one.
#[must_use]
pub fn profiles_coincide(language: Language) -> &'static str {
    two(
        "Both profiles coincide: a single cam with two elements does what the pair does.",
        "Los dos perfiles coinciden: una sola leva con dos elementos hace lo mismo que el par.",
    )
    .within(language)
}

/// The verdict in a word or two, as in a table.
#[must_use]
pub fn level(language: Language, level: Level) -> &'static str {
    voice(language).level(level)
}

/// The verdict in one sentence.
#[must_use]
pub fn headline(language: Language, report: &Report) -> String {
    voice(language).headline(report)
}

/// What a finding is, where, how much, and the limit.
#[must_use]
pub fn finding(language: Language, design: &Design, finding: &DesignFinding) -> String {
    Signs::of(design.notation).say(&voice(language).finding(finding, Units::of(design)))
}

/// The same with derivatives with respect to time, if the sentence has one.
#[must_use]
pub fn finding_by_time(language: Language, design: &Design, finding: &DesignFinding) -> Option<String> {
    let has_derivative = matches!(finding.kind, FindingKind::Jump(order) if order > 0);
    let said = || voice(language).finding(finding, Units::by_time(design));
    has_derivative.then(|| Signs::of(design.notation).say(&said()))
}

/// What would put a finding right. No cure states a derivative: a price in acceleration is a ratio, the same by θ and by time.
#[must_use]
pub fn cure(language: Language, design: &Design, finding: &DesignFinding, remedy: &Remedy) -> String {
    let shown = match *remedy {
        Remedy::Eccentricity { value, pressure_angle } => {
            Some(Remedy::Eccentricity { value: value * design.eccentricity_sign() + 0.0, pressure_angle })
        }
        _ => None,
    };
    let said = voice(language).cure(finding, shown.as_ref().unwrap_or(remedy), Units::of(design));
    Signs::of(design.notation).say(&said)
}

/// What is wrong with a design. The place is not told: it is in [`DesignError::path`].
#[must_use]
pub fn design_error(language: Language, error: &DesignError) -> String {
    voice(language).problem(&error.problem)
}

/// Why a link does not open.
#[must_use]
pub fn link_error(language: Language, error: &LinkError) -> String {
    match error {
        LinkError::Design(error) => format!("{}: {}", error.path, design_error(language, error)),
        _ => voice(language).link(error),
    }
}

/// The sentence about a link that came as the query of an address: unlike a fragment, a query is sent to the server.
#[must_use]
pub fn link_from_query(language: Language) -> &'static str {
    voice(language).link_from_query()
}

/// Why a design has no link.
#[must_use]
pub fn too_long(language: Language, refusal: TooLong) -> String {
    voice(language).too_long(refusal)
}

/// Why a file cannot be used.
#[must_use]
pub fn file(language: Language, problem: FileProblem) -> &'static str {
    voice(language).file(problem)
}

#[cfg(test)]
mod tests;
