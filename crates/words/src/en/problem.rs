//! What is wrong with a design, in English.

use super::{EN, data};
use crate::voice::{measured, row_of};
use levalab_core::Misfit;
use levalab_format::{CamRefusal, EditRefusal, JsonFault, Kind, Measure, Problem, ProgramRefusal, quoted};

pub(super) fn problem(problem: &Problem) -> String {
    match problem {
        Problem::FileTooLarge { limit, .. } => {
            format!("The file has more than {} bytes, and no design has.", EN.exact(*limit as f64))
        }
        Problem::NotText => "The file is not text in UTF-8.".to_owned(),
        Problem::NotJson { line, column, fault } => not_json(*line, *column, *fault),
        Problem::NotFinite => "The number is too large to be held.".to_owned(),
        Problem::WrongKind { found, expected } => {
            format!("There should be {} here, and there is {}.", kind(*expected), kind(*found))
        }
        Problem::DecimalComma { found } => {
            format!("{} is a text; a number has no quotes and a decimal point, as in 1.5.", quoted(found))
        }
        Problem::Missing => "This field is missing.".to_owned(),
        Problem::UnknownField { expected } => {
            format!("This field has no meaning here; those that have are {}.", row_of(expected, "and"))
        }
        Problem::DuplicateField => "This field is there twice.".to_owned(),
        Problem::WrongWord { found, expected } => match expected.as_slice() {
            [only] => format!("{} is not known here; it can only be {only}.", quoted(found)),
            _ => format!("{} is none of the choices: {}.", quoted(found), expected.join(", ")),
        },
        Problem::NewerFormat { found } => {
            format!("The file is {}, made by a newer version of LevaLab.", quoted(found))
        }
        Problem::OutOfRange { found, min, max, measure } => {
            let [found, min, max] = [found, min, max].map(|value| measured(*value, *measure, EN));
            format!("{found} is out of range: it must be from {min} to {max}.")
        }
        Problem::NotBetween { found, min, max, measure } => {
            let [found, min, max] = [found, min, max].map(|value| measured(*value, *measure, EN));
            format!("{found} is out of range: it must be more than {min} and less than {max}.")
        }
        Problem::NotPositive { found, measure } => {
            format!("It must be more than zero, and it is {}.", measured(*found, *measure, EN))
        }
        Problem::TitleTooLong { found, limit } => {
            format!("The title has {found} characters; there is room for {limit}.")
        }
        Problem::TitleCharacter { found, position } => {
            format!("Character {position} of the title (U+{:04X}) cannot be seen.", u32::from(*found))
        }
        Problem::TitleInvisible => "Nothing of the title can be seen: leave it empty, or give it a letter.".to_owned(),
        Problem::OneOf { expected } => format!("Only one of {} can be given.", row_of(expected, "and")),
        Problem::Program(refusal) => program(*refusal),
        Problem::Data(refusal) => data::refusal(refusal),
        Problem::Join(problem) => crate::join::problem(EN, *problem),
        Problem::Misfit(problem) => misfit(*problem),
        Problem::Cam(refusal) => cam(*refusal),
        Problem::Edit(refusal) => edit(*refusal),
        Problem::NoAssignment { found } => {
            format!("{} is no change; a path, an equals sign and a value are, as in cam.base_radius=36.", quoted(found))
        }
        Problem::NoIndex { found } => {
            format!("A place in a list is a whole number, 0 for the first, and this is {}.", EN.exact(*found))
        }
    }
}

/// Text that is not JSON.
fn not_json(line: usize, column: usize, fault: JsonFault) -> String {
    match fault {
        JsonFault::Syntax => format!("The text is not JSON from line {line}, column {column} on."),
        JsonFault::End => format!("The text ends in the middle of the design, in line {line}, column {column}."),
        JsonFault::DecimalComma => {
            format!("There is a decimal comma in line {line}, column {column}; JSON has a decimal point, as in 1.5.")
        }
        JsonFault::Surrogate => {
            format!("There is half a character in line {line}, column {column}: one half of a surrogate pair.")
        }
        JsonFault::Depth => {
            format!("Lists and objects are nested deeper than in any design, in line {line}, column {column}.")
        }
    }
}

/// Segments that make no program.
fn program(refusal: ProgramRefusal) -> String {
    match refusal {
        ProgramRefusal::NoSegments => "There are no segments; at least one is needed.".to_owned(),
        ProgramRefusal::TooManySegments { found, limit } => {
            format!("There are {found} segments; there is room for {limit}.")
        }
        ProgramRefusal::TooManyPoints { found, limit } => {
            format!("The tables have {found} points in all; there is room for {limit}.")
        }
        ProgramRefusal::DwellRises { found, measure } => {
            format!("A dwell cannot rise, and this one rises {}.", measured(found, measure, EN))
        }
        ProgramRefusal::AdjacentPolynomials { next } => {
            format!(
                "It takes its end conditions from its neighbours, and so does segment {}: they cannot be side by side.",
                next + 1
            )
        }
        ProgramRefusal::Turn { found, whole, measure } => {
            let missing = whole - found;
            let (sum, difference) = (measured(found, measure, EN), measured(missing.abs(), measure, EN));
            let rest = match (measure, missing > 0.0) {
                (Measure::Degrees, true) => "too few",
                (Measure::Degrees, false) => "too many",
                (_, true) => "too short",
                (_, false) => "too long",
            };
            let cycle = match (measure, whole < 360.0) {
                (Measure::Degrees, false) => "a whole turn".to_owned(),
                (Measure::Degrees, true) => "half a turn, which its image completes".to_owned(),
                _ => format!("a travel of {}", EN.exact(whole)),
            };
            format!("The segments add up to {sum}, {difference} {rest} for {cycle}.")
        }
        ProgramRefusal::Closing { found, measure } => {
            let height = measured(found, measure, EN);
            format!("The rises add up to {height}; they must add up to 0, so that the turn ends where it begins.")
        }
        ProgramRefusal::Beginning { found, measure } => {
            let height = measured(found, measure, EN);
            format!(
                "The first segment begins at {height}; it must begin at 0, on the base circle: subtract {height} from it."
            )
        }
        ProgramRefusal::BelowBase { found, measure } => {
            format!("The follower would end at {}, below the base circle.", measured(found, measure, EN))
        }
    }
}

/// Lengths that do not go together.
fn misfit(misfit: Misfit) -> String {
    match misfit {
        Misfit::Eccentricity { eccentricity, prime_radius } => {
            let (e, radius) = (EN.exact(eccentricity), EN.exact(prime_radius));
            format!("An eccentricity of {e} is too large: it must be less than the prime radius, {radius}.")
        }
        Misfit::Triangle { pivot_distance, arm, prime_radius } => {
            let [m, arm, radius] = [pivot_distance, arm, prime_radius].map(|value| EN.exact(value));
            format!(
                "A pivot at {m}, an arm of {arm} and a prime radius of {radius} make no triangle: each must be less than the other two together."
            )
        }
        Misfit::FaceOutOfReach { pivot_distance, needed } => {
            let (m, needed) = (EN.exact(pivot_distance), EN.exact(needed));
            format!("From a pivot at {m} the face cannot touch the base circle: it must be at more than {needed}.")
        }
    }
}

/// Changes that are not possible.
fn edit(refusal: EditRefusal) -> String {
    match refusal {
        EditRefusal::NoItem { count: 0, .. } => "The list is empty: there is nothing at this place.".to_owned(),
        EditRefusal::NoItem { found, count } => {
            format!("There is nothing at place {found}; the list has {count}, counted from 0.")
        }
        EditRefusal::NothingLeft => "Nothing is left to fill.".to_owned(),
        EditRefusal::LastTooShort => {
            "The last segment is too short to give back what the segments have too much.".to_owned()
        }
        EditRefusal::NothingMoves => "No segment moves in such a way that it could end at another height.".to_owned(),
        EditRefusal::NoConditions => "The law of this segment has no conditions.".to_owned(),
        EditRefusal::NoFormula => "The law of this segment is no formula.".to_owned(),
        EditRefusal::NoApplication => "The follower drives nothing.".to_owned(),
        EditRefusal::NoGenerator => "Only a cam of constant breadth has a generator.".to_owned(),
        EditRefusal::NoSecondCam => "No second cam tied in this way works.".to_owned(),
    }
}

/// What a kind of cam does not have.
fn cam(refusal: CamRefusal) -> String {
    match refusal {
        CamRefusal::Unsuited { kind } => {
            format!("It has no place on a {}.", crate::cam_kind(EN, kind))
        }
        CamRefusal::OffCentre { found, measure, kind } => {
            format!(
                "On a {} the follower must be in line: this must be 0, and it is {}.",
                crate::cam_kind(EN, kind),
                measured(found, measure, EN)
            )
        }
        CamRefusal::Breadth { found, base_radius } => {
            let (breadth, twice) = (EN.exact(found), EN.exact(2.0 * base_radius));
            format!(
                "A breadth of {breadth} leaves no travel: breadth = 2·Rb + travel, so it must be more than {twice}."
            )
        }
        CamRefusal::BreadthTravel { found, travel, breadth, base_radius } => {
            let [found, travel, breadth, radius] = [found, travel, breadth, base_radius].map(|v| EN.exact(v));
            format!(
                "Over half a turn the follower must rise by breadth − 2·Rb = {breadth} − 2·{radius} = {travel}, and the segments rise by {found}."
            )
        }
        CamRefusal::Sides { found, most } => {
            let (found, most) = (EN.exact(found), EN.exact(most));
            format!("A polygon of arcs has an odd number of sides from 3 to {most}, and this one has {found}.")
        }
        CamRefusal::SharpArcs { found, least, half } => {
            let (found, least, half) = (EN.exact(found), EN.number(least), EN.exact(half));
            format!(
                "A base radius of {found} is too small for these arcs: it must be from {least} (sharp corners) to less than {half}, half the breadth."
            )
        }
        CamRefusal::TooClose { found, least } => {
            let (found, least) = (EN.exact(found), EN.number(least));
            format!("At a distance of {found} there is no room for a second cam: it must be more than {least}.")
        }
        CamRefusal::SwingingApplication => {
            "The displacement of an oscillating follower is an angle, and an application is driven by a translating follower."
                .to_owned()
        }
    }
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Null => "nothing (null)",
        Kind::Boolean => "true or false",
        Kind::Number => "a number",
        Kind::Text => "a text",
        Kind::List => "a list",
        Kind::Object => "an object",
    }
}
