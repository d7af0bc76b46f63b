//! The letters that stand for laws, followers and units in a link. Once published, a letter is never given to another.

use crate::{LengthUnit, Notation, SpeedUnit};
use levalab_core::application::Application;
use levalab_core::{FOLLOWERS, FollowerKind, LAWS, Law, Tie};

/// Law and code: a capital, and small letters where several laws are of one family.
pub const LAW_CODES: &[(&str, &str)] = &[
    ("dwell", "D"),
    ("constant-velocity", "V"),
    ("parabolic", "P"),
    ("parabolic-blend", "Pb"),
    ("cubic-1", "K"),
    ("cubic-2", "Kb"),
    ("simple-harmonic", "H"),
    ("double-harmonic", "Hd"),
    ("half-harmonic-start", "Ha"),
    ("half-harmonic-end", "Hb"),
    ("cycloidal", "C"),
    ("half-cycloidal-start", "Ca"),
    ("half-cycloidal-end", "Cb"),
    ("polynomial-3-4-5", "Q"),
    ("polynomial-5", "Qm"),
    ("polynomial", "N"),
    ("bspline", "B"),
    ("bezier", "Z"),
    ("table", "L"),
    ("formula", "F"),
    ("polynomial-4-5-6-7", "S"),
    ("polynomial-7", "Sm"),
    ("modified-trapezoidal", "T"),
    ("modified-sine", "M"),
    ("scca", "X"),
    ("skewed-scca", "Xs"),
    ("asymmetric-3-4-5", "Qa"),
];

/// Follower and code: a capital, as for laws.
pub const FOLLOWER_CODES: &[(&str, &str)] = &[
    ("translating-roller", "R"),
    ("translating-knife", "K"),
    ("translating-curved", "C"),
    ("translating-flat", "F"),
    ("oscillating-roller", "A"),
    ("oscillating-flat", "O"),
];

/// Application and code: a small letter.
pub const APPLICATION_CODES: &[(&str, &str)] = &[("force", "k"), ("piston-force", "p"), ("pump", "u"), ("valve", "v")];

const LENGTH_UNIT_CODES: [(LengthUnit, &str); 3] =
    [(LengthUnit::Centimetre, "c"), (LengthUnit::Metre, "m"), (LengthUnit::Inch, "i")];

const SPEED_UNIT_CODES: [(SpeedUnit, &str); 2] =
    [(SpeedUnit::RevolutionsPerMinute, "m"), (SpeedUnit::RevolutionsPerSecond, "s")];

pub(super) fn of_law(law: &Law) -> &'static str {
    code_of(LAW_CODES, law.id)
}

pub(super) fn of_follower(kind: &FollowerKind) -> &'static str {
    code_of(FOLLOWER_CODES, kind.id)
}

pub(super) fn of_application(application: &Application) -> &'static str {
    code_of(APPLICATION_CODES, application.id)
}

/// Empty for millimetres.
pub(super) fn of_length_unit(unit: LengthUnit) -> &'static str {
    LENGTH_UNIT_CODES.iter().find(|entry| entry.0 == unit).map_or("", |entry| entry.1)
}

/// The letter of a notation; that of ours is never written.
pub(super) fn of_notation(notation: Notation) -> char {
    match notation {
        Notation::LevaLab => 'l',
        Notation::Norton => 'n',
        Notation::Shigley => 's',
        Notation::Rothbart => 'r',
        Notation::CardonaClos => 'c',
        Notation::Capitals => 'v',
    }
}

pub(super) fn notation(letter: char) -> Option<Notation> {
    Notation::ALL.into_iter().find(|&notation| of_notation(notation) == letter)
}

/// A second cam, by what ties it to the first.
pub(super) fn of_tie(tie: Tie) -> &'static str {
    match tie {
        Tie::Distance(_) => "kd",
        Tie::Angle(_) => "ka",
        Tie::BaseRadius(_) => "kr",
    }
}

/// A tie from its second letter.
pub(super) fn tie(letter: char) -> Option<fn(f64) -> Tie> {
    match letter {
        'd' => Some(Tie::Distance),
        'a' => Some(Tie::Angle),
        'r' => Some(Tie::BaseRadius),
        _ => None,
    }
}

/// Empty for rad/s, and for the lengths per second of a cam that travels.
pub(super) fn of_speed_unit(unit: SpeedUnit) -> &'static str {
    SPEED_UNIT_CODES.iter().find(|entry| entry.0 == unit).map_or("", |entry| entry.1)
}

pub(super) fn law(code: &str) -> Option<&'static Law> {
    LAWS.iter().copied().find(|law| of_law(law) == code)
}

pub(super) fn follower(code: &str) -> Option<&'static FollowerKind> {
    FOLLOWERS.iter().copied().find(|kind| of_follower(kind) == code)
}

pub(super) fn application(letter: char) -> Option<&'static Application> {
    let entry = APPLICATION_CODES.iter().find(|entry| entry.1.starts_with(letter))?;
    Application::by_id(entry.0)
}

pub(super) fn length_unit(code: char) -> Option<LengthUnit> {
    LENGTH_UNIT_CODES.iter().find(|entry| entry.1.starts_with(code)).map(|entry| entry.0)
}

pub(super) fn speed_unit(code: char) -> Option<SpeedUnit> {
    SPEED_UNIT_CODES.iter().find(|entry| entry.1.starts_with(code)).map(|entry| entry.0)
}

/// No code makes a link that does not open, which the test below rules out.
fn code_of(table: &[(&str, &'static str)], id: &str) -> &'static str {
    table.iter().find(|entry| entry.0 == id).map_or("", |entry| entry.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_core::application::APPLICATIONS;

    fn check(table: &[(&str, &str)], ids: &[&str]) {
        for id in ids {
            assert_eq!(table.iter().filter(|entry| entry.0 == *id).count(), 1, "{id} has one code");
        }
        for (i, (id, code)) in table.iter().enumerate() {
            assert!(ids.contains(id), "{id} is no more");
            assert!(table[..i].iter().all(|other| other.1 != *code), "{code} stands for one thing");
            let mut letters = code.chars();
            assert!(letters.next().is_some_and(|c| c.is_ascii_uppercase()) && letters.all(|c| c.is_ascii_lowercase()));
        }
    }

    #[test]
    fn every_law_and_follower_has_a_code_of_its_own() {
        check(LAW_CODES, &LAWS.iter().map(|law| law.id).collect::<Vec<_>>());
        check(FOLLOWER_CODES, &FOLLOWERS.iter().map(|kind| kind.id).collect::<Vec<_>>());
    }

    #[test]
    fn every_application_has_a_letter_of_its_own() {
        let mut letters: Vec<char> = APPLICATION_CODES.iter().flat_map(|entry| entry.1.chars()).collect();
        assert_eq!(letters.len(), APPLICATIONS.len());
        letters.sort_unstable();
        letters.dedup();
        assert_eq!(letters.len(), APPLICATIONS.len());
        for entry in APPLICATIONS {
            assert_eq!(
                of_application(entry).chars().next().and_then(application).map(|found| found.id),
                Some(entry.id)
            );
        }
    }

    #[test]
    fn every_unit_but_the_usual_one_has_a_code() {
        for unit in LengthUnit::ALL {
            assert_eq!(of_length_unit(unit).is_empty(), unit == LengthUnit::default());
        }
        for unit in SpeedUnit::ALL {
            assert_eq!(of_speed_unit(unit).is_empty(), unit == SpeedUnit::default());
        }
    }
}
