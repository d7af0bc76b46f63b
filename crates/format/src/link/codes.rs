//! The letters of a link: those of laws, followers and applications are in the catalogue, those of units, notations and ties are here.
//! Once published, a letter is never given to another.

use crate::{LengthUnit, Notation, SpeedUnit};
use levalab_catalogue::{Label, application_label, follower_label, law_label};
use levalab_core::application::{APPLICATIONS, Application};
use levalab_core::{FOLLOWERS, FollowerKind, LAWS, Law, Tie};

const LENGTH_UNIT_CODES: [(LengthUnit, &str); 3] =
    [(LengthUnit::Centimetre, "c"), (LengthUnit::Metre, "m"), (LengthUnit::Inch, "i")];

const SPEED_UNIT_CODES: [(SpeedUnit, &str); 2] =
    [(SpeedUnit::RevolutionsPerMinute, "m"), (SpeedUnit::RevolutionsPerSecond, "s")];

pub(super) fn of_law(law: &Law) -> &'static str {
    code_of(law_label(law))
}

pub(super) fn of_follower(kind: &FollowerKind) -> &'static str {
    code_of(follower_label(kind))
}

pub(super) fn of_application(application: &Application) -> &'static str {
    code_of(application_label(application))
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
    APPLICATIONS.iter().copied().find(|application| of_application(application).starts_with(letter))
}

pub(super) fn length_unit(code: char) -> Option<LengthUnit> {
    LENGTH_UNIT_CODES.iter().find(|entry| entry.1.starts_with(code)).map(|entry| entry.0)
}

pub(super) fn speed_unit(code: char) -> Option<SpeedUnit> {
    SPEED_UNIT_CODES.iter().find(|entry| entry.1.starts_with(code)).map(|entry| entry.0)
}

/// The catalogue has a row, with a code, for everything that a design may hold; without a code the link would not open.
fn code_of(label: Option<&'static Label>) -> &'static str {
    label.map_or("", |label| label.link)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BreadthGenerator, CamKind, example, link};
    use levalab_catalogue::{Version, kind_label};

    #[test]
    fn a_code_leads_back_to_what_it_stands_for() {
        for &entry in LAWS {
            assert_eq!(law(of_law(entry)), Some(entry));
        }
        for &entry in FOLLOWERS {
            assert_eq!(follower(of_follower(entry)).map(|found| found.id), Some(entry.id));
        }
        for &entry in APPLICATIONS {
            let letter = of_application(entry).chars().next().expect(entry.id);
            assert_eq!(application(letter).map(|found| found.id), Some(entry.id));
        }
    }

    #[test]
    fn the_letter_of_a_kind_of_cam_is_that_of_the_catalogue() {
        let kinds = [
            CamKind::Rotating,
            CamKind::Grooved,
            CamKind::ConstantBreadth { breadth: 100.0, generator: BreadthGenerator::Mirror },
            CamKind::Translating { length: 360.0 },
        ];
        let plain = example("9RT").expect("9RT");
        let text = |kind: CamKind| {
            let speed = crate::Speed { unit: link::usual_speed_unit(kind), ..crate::Speed::default() };
            link::write(&crate::Design { kind, speed, ..plain.clone() }, Version::One, None)
        };
        let usual = text(CamKind::Rotating);
        for kind in kinds {
            let own = text(kind);
            let at = own.chars().zip(usual.chars()).position(|(one, other)| one != other).unwrap_or(own.len());
            let letter = kind_label(kind.word()).expect("a row").link;
            assert!(own[at..].starts_with(letter) && letter.is_empty() == (own == usual), "{own}");
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
