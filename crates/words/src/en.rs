//! English.

use crate::data_en;
use crate::voice::{Figures, FileProblem, Voice, by_law, measured, row, worst_kinds};
use crate::{Language, Units};
use levalab_core::{Column, FindingKind, Level, Misfit, Tie};
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Kind, Measure, Problem, Remedy, quoted};

pub(crate) struct English;

const EN: Language = Language::En;

impl Voice for English {
    fn law(&self, id: &str) -> Option<&'static str> {
        Some(match id {
            "dwell" => "dwell",
            "constant-velocity" => "constant velocity",
            "parabolic" => "parabolic",
            "parabolic-blend" => "modified uniform",
            "cubic-1" => "cubic 1",
            "cubic-2" => "cubic 2",
            "simple-harmonic" => "simple harmonic",
            "double-harmonic" => "double harmonic",
            "cycloidal" => "cycloidal",
            "polynomial-3-4-5" => "3-4-5 polynomial",
            "polynomial-4-5-6-7" => "4-5-6-7 polynomial",
            "modified-trapezoidal" => "modified trapezoidal",
            "modified-sine" => "modified sine",
            "scca" => "SCCA",
            "skewed-scca" => "skewed SCCA",
            "asymmetric-3-4-5" => "asymmetric 3-4-5",
            "half-harmonic-start" => "half harmonic (start)",
            "half-harmonic-end" => "half harmonic (end)",
            "half-cycloidal-start" => "half cycloidal (start)",
            "half-cycloidal-end" => "half cycloidal (end)",
            "polynomial-5" => "5th-degree polynomial",
            "polynomial-7" => "7th-degree polynomial",
            "polynomial" => "polynomial through conditions",
            "bspline" => "B-spline",
            "bezier" => "Bézier",
            "table" => "table",
            "formula" => "formula",
            "circular-arc" => "circular arc",
            _ => return None,
        })
    }

    fn follower(&self, id: &str) -> Option<&'static str> {
        Some(match id {
            "translating-roller" => "translating roller follower",
            "translating-knife" => "translating knife-edge follower",
            "translating-curved" => "translating curved-face follower",
            "translating-flat" => "translating flat-face follower",
            "oscillating-roller" => "oscillating roller follower",
            "oscillating-flat" => "oscillating flat-face follower",
            _ => return None,
        })
    }

    fn cam_kind(&self, word: &str) -> Option<&'static str> {
        Some(match word {
            "rotating" => "plate cam",
            "grooved" => "grooved cam",
            "constant-breadth" => "cam of constant breadth",
            "translating" => "translating cam",
            _ => return None,
        })
    }

    fn second_cam(&self) -> &'static str {
        "Second cam"
    }

    fn level(&self, level: Level) -> &'static str {
        match level {
            Level::Acceptable => "acceptable",
            Level::LowSpeed => "not for high speeds",
            Level::Unacceptable => "unacceptable",
        }
    }

    fn headline(&self, report: &Report) -> String {
        let joints = report.findings.first().map_or(0, |finding| finding.places.len());
        match report.level {
            Level::Acceptable if joints > 0 => {
                "Acceptable: the yoke holds the cam on both sides, so that jumps of the acceleration do not part them."
                    .to_owned()
            }
            Level::Acceptable => {
                "Acceptable: the motion is smooth up to the jerk, and the profile is sound.".to_owned()
            }
            Level::LowSpeed if joints == 1 => "Not for high speeds: the jerk jumps at one joint.".to_owned(),
            Level::LowSpeed => format!("Not for high speeds: the jerk jumps at {joints} joints."),
            Level::Unacceptable => {
                let reasons: Vec<String> =
                    worst_kinds(report).into_iter().map(|kind| reason(kind).to_owned()).collect();
                format!("Unacceptable: {}.", row(&reasons, "and"))
            }
        }
    }

    fn finding(&self, finding: &DesignFinding, units: Units) -> String {
        let Figures { at, span, other, count, value, limit } = Figures::of(finding, units, EN);
        let along = |(from, to): (String, String)| format!("From {from} to {to}");
        let around = span.map_or_else(|| format!("At {at}"), along);
        let where_and_how_much = if count > 1 {
            format!("jumps at {count} joints, by up to {value} at {at}")
        } else {
            format!("jumps by {value} at {at}")
        };
        match finding.kind {
            FindingKind::Jump(0) => {
                format!("The displacement {where_and_how_much}: the follower would be in two places at once.")
            }
            FindingKind::Jump(1) => format!("The velocity {where_and_how_much}: an infinite acceleration, a blow."),
            FindingKind::Jump(2) if finding.level == Level::Acceptable => {
                format!(
                    "The acceleration {where_and_how_much}; tolerated here alone, because the yoke touches both sides and cannot lift off."
                )
            }
            FindingKind::Jump(_) if finding.level == Level::Acceptable => {
                format!("The jerk {where_and_how_much}; tolerated in a cam that is held on both sides.")
            }
            FindingKind::Jump(2) => {
                format!(
                    "The acceleration {where_and_how_much}: the forces change at a stroke and the follower vibrates."
                )
            }
            FindingKind::Jump(_) => {
                let moves = if units.travels { "travels" } else { "turns" };
                format!(
                    "The jerk {where_and_how_much}: harmless when the cam {moves} slowly, vibration when it {moves} fast."
                )
            }
            FindingKind::PressureAngle => {
                let motion = if units.oscillating { "an oscillating" } else { "a translating" };
                format!(
                    "The pressure angle reaches {value} at {at}, above the {limit} that {motion} follower tolerates."
                )
            }
            FindingKind::Cusp => {
                format!(
                    "The profile comes to a point at {at}: its radius of curvature is zero, and it would soon wear away."
                )
            }
            FindingKind::Undercut => {
                format!(
                    "{around} the profile is undercut: the radius of curvature would fall to {value} at {at}, and a roller of this size cannot follow."
                )
            }
            FindingKind::GrooveUndercut => {
                format!(
                    "{around} the outer wall of the groove is undercut: the pitch curve is hollow with a radius of {value} at {at}, less than the roller's {limit}."
                )
            }
            FindingKind::ConcaveFlat => {
                format!(
                    "{around} the profile would have to be hollow, which a flat face cannot touch: the radius of curvature falls to {value} at {at}."
                )
            }
            FindingKind::Doubtful => {
                format!(
                    "{around} the conditions hardly determine the curve: the least rounding of one of them changes its shape, and its figures cannot be trusted."
                )
            }
            FindingKind::BelowBase => {
                let base = if units.travels { "line" } else { "circle" };
                format!("The follower goes below the base {base}, down to {value} at {at}.")
            }
            FindingKind::SelfCrossing => {
                format!("The profile crosses itself: it goes through the same point at {at} and at {other}.")
            }
            FindingKind::ArmCutsCam if units.oscillating => {
                format!("At {at} the arm of the follower would cut {value} deep into the cam.")
            }
            FindingKind::ArmCutsCam => format!("At {at} the stem of the follower would cut {value} deep into the cam."),
            FindingKind::PivotInsideCam => {
                format!(
                    "The cam sweeps over the pivot: at {at} it reaches {value} from its centre, and the pivot is at {limit}."
                )
            }
            FindingKind::FaceOvertaken => {
                format!(
                    "At {at} the face turns {value} times as fast as the cam and in its sense, so that the contact runs away along it."
                )
            }
            FindingKind::ContactPastPivot => {
                format!("{around} the contact would be on the other side of the pivot, {value} along the face at {at}.")
            }
        }
    }

    fn cure(&self, finding: &DesignFinding, remedy: &Remedy, units: Units) -> String {
        match remedy {
            Remedy::BaseRadius { value, grows } => {
                let sign = if *grows { '≥' } else { '=' };
                format!("With Rb {sign} {} {}.", units.length(*value, EN), passing(finding.kind, units))
            }
            Remedy::Travel { value } => {
                format!("With a travel of {} {}.", units.length(*value, EN), passing(finding.kind, units))
            }
            Remedy::Tie { tie, grows } => {
                let sign = if *grows { '≥' } else { '≤' };
                let what = match tie {
                    Tie::Distance(value) => format!("a distance {sign} {}", units.length(*value, EN)),
                    Tie::Angle(value) => format!("an angle {sign} {} between the arms", EN.angle_exact(*value)),
                    Tie::BaseRadius(value) => format!("a second base radius {sign} {}", units.length(*value, EN)),
                };
                format!("With {what} {}.", passing(finding.kind, units))
            }
            Remedy::Eccentricity { value, pressure_angle } => {
                let (e, angle) = (units.length(*value, EN), EN.angle(*pressure_angle));
                if finding.limit.is_some_and(|limit| *pressure_angle <= limit) {
                    format!("With an eccentricity of {e} it stays within {angle}.")
                } else {
                    format!("With an eccentricity of {e} it falls to {angle}.")
                }
            }
            Remedy::Laws { changes, remaining_jump } => {
                let groups = by_law(changes)
                    .into_iter()
                    .map(|(law, segments)| format!("the {} law {}", crate::law(EN, law), in_segments(&segments)));
                let groups: Vec<String> = groups.collect();
                let result = match (finding.kind, remaining_jump) {
                    (FindingKind::BelowBase, _) => "the follower stays above the base circle",
                    (_, None) => "nothing jumps any more",
                    (_, Some(Column::J)) => "only the jerk still jumps",
                    (_, Some(_)) => "this jump is gone",
                };
                format!("With {} {result}.", row(&groups, "and"))
            }
        }
    }

    fn problem(&self, problem: &Problem) -> String {
        match problem {
            Problem::FileTooLarge { bytes, limit } => {
                format!(
                    "The file has {} bytes; no design has more than {}.",
                    EN.exact(*bytes as f64),
                    EN.exact(*limit as f64)
                )
            }
            Problem::NotText => "The file is not text in UTF-8.".to_owned(),
            Problem::NotJson { line, column } => {
                format!("The text is not JSON from line {line}, column {} on.", (*column).max(1))
            }
            Problem::NotFinite => "The number is too large to be held.".to_owned(),
            Problem::WrongKind { found, expected } => {
                format!("There should be {} here, and there is {}.", kind(*expected), kind(*found))
            }
            Problem::Missing => "This field is missing.".to_owned(),
            Problem::UnknownField { expected } => {
                format!("This field has no meaning here; those that have are {}.", row_of(expected))
            }
            Problem::DuplicateField => "This field is there twice.".to_owned(),
            Problem::WrongWord { found, expected } => match expected.as_slice() {
                [only] => format!("{} is not known here; it can only be {only}.", quoted(found)),
                _ => format!("{} is none of the choices: {}.", quoted(found), expected.join(", ")),
            },
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
            Problem::NoSegments => "There are no segments; at least one is needed.".to_owned(),
            Problem::TooManySegments { found, limit } => {
                format!("There are {found} segments; there is room for {limit}.")
            }
            Problem::DwellRises { found, measure } => {
                format!("A dwell cannot rise, and this one rises {}.", measured(*found, *measure, EN))
            }
            Problem::Data(refusal) => data_en::refusal(refusal),
            Problem::Join(problem) => crate::join::problem(EN, *problem),
            Problem::AdjacentPolynomials { next } => {
                format!(
                    "It takes its end conditions from its neighbours, and so does segment {}: they cannot be side by side.",
                    next + 1
                )
            }
            Problem::Turn { found, whole, measure } => {
                let missing = whole - found;
                let (sum, difference) = (measured(*found, *measure, EN), measured(missing.abs(), *measure, EN));
                let rest = match (measure, missing > 0.0) {
                    (Measure::Degrees, true) => "too few",
                    (Measure::Degrees, false) => "too many",
                    (_, true) => "too short",
                    (_, false) => "too long",
                };
                let cycle = match (measure, *whole < 360.0) {
                    (Measure::Degrees, false) => "a whole turn".to_owned(),
                    (Measure::Degrees, true) => "half a turn, which its image completes".to_owned(),
                    _ => format!("a travel of {}", EN.exact(*whole)),
                };
                format!("The segments add up to {sum}, {difference} {rest} for {cycle}.")
            }
            Problem::Closing { found, measure } => {
                let height = measured(*found, *measure, EN);
                format!("The rises add up to {height}; they must add up to 0, so that the turn ends where it begins.")
            }
            Problem::BelowBase { found, measure } => {
                format!("The follower would end at {}, below the base circle.", measured(*found, *measure, EN))
            }
            Problem::Misfit(problem) => misfit(*problem),
            Problem::Unsuited { kind } => {
                format!("It has no place on a {}.", crate::cam_kind(EN, kind))
            }
            Problem::OffCentre { found, measure, kind } => {
                format!(
                    "On a {} the follower must be in line: this must be 0, and it is {}.",
                    crate::cam_kind(EN, kind),
                    measured(*found, *measure, EN)
                )
            }
            Problem::Breadth { found, base_radius } => {
                let (breadth, twice) = (EN.exact(*found), EN.exact(2.0 * base_radius));
                format!(
                    "A breadth of {breadth} leaves no travel: breadth = 2·Rb + travel, so it must be more than {twice}."
                )
            }
            Problem::BreadthTravel { found, travel, breadth, base_radius } => {
                let [found, travel, breadth, radius] = [found, travel, breadth, base_radius].map(|v| EN.exact(*v));
                format!(
                    "Over half a turn the follower must rise by breadth − 2·Rb = {breadth} − 2·{radius} = {travel}, and the segments rise by {found}."
                )
            }
            Problem::Sides { found, most } => {
                let (found, most) = (EN.exact(*found), EN.exact(*most));
                format!("A polygon of arcs has an odd number of sides from 3 to {most}, and this one has {found}.")
            }
            Problem::SharpArcs { found, least, half } => {
                let (found, least, half) = (EN.exact(*found), EN.number(*least), EN.exact(*half));
                format!(
                    "A base radius of {found} is too small for these arcs: it must be from {least} (sharp corners) to less than {half}, half the breadth."
                )
            }
            Problem::TooClose { found, least } => {
                let (found, least) = (EN.exact(*found), EN.number(*least));
                format!("At a distance of {found} there is no room for a second cam: it must be more than {least}.")
            }
            Problem::SwingingApplication => {
                "The displacement of a follower that swings is an angle, and an application is driven by a follower that slides."
                    .to_owned()
            }
            Problem::OneOf { expected } => format!("Only one of {} can be given.", row_of(expected)),
        }
    }

    fn link(&self, error: &LinkError) -> String {
        match error {
            LinkError::Empty => "The link is empty.".to_owned(),
            LinkError::TooLong(TooLong { found, limit }) => {
                format!("The link has {found} characters; no link has more than {limit}.")
            }
            LinkError::Character { found, position } => {
                format!(
                    "The link is damaged: character {position} is {}, which no link has.",
                    quoted(&found.to_string())
                )
            }
            LinkError::Damaged => "The link is damaged: characters were lost or changed on the way.".to_owned(),
            LinkError::Version { found } => {
                format!("The link is of version {}, which is newer than this program.", quoted(found))
            }
            LinkError::Unreadable => "The link is whole, but it is not a design that this program can read.".to_owned(),
            LinkError::Design(error) => self.problem(&error.problem),
        }
    }

    fn too_long(&self, TooLong { found, limit }: TooLong) -> String {
        format!(
            "The link would have {found} characters; beyond {limit} it does not travel well. Save the design as a file."
        )
    }

    fn file(&self, problem: FileProblem) -> &'static str {
        match problem {
            FileProblem::Absent => "There is no such file.",
            FileProblem::Folder => "It is a folder, not a file.",
            FileProblem::Forbidden => "The file may not be read.",
            FileProblem::Unreadable => "The file cannot be read.",
            FileProblem::Unwritable => "The result cannot be written.",
        }
    }
}

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

/// Why a cam is unacceptable, after a colon.
fn reason(kind: FindingKind) -> &'static str {
    match kind {
        FindingKind::Jump(0) => "the displacement jumps",
        FindingKind::Jump(1) => "the velocity jumps",
        FindingKind::Jump(2) => "the acceleration jumps",
        FindingKind::Jump(_) => "the jerk jumps",
        FindingKind::PressureAngle => "the pressure angle is too large",
        FindingKind::Cusp => "the profile has a cusp",
        FindingKind::Undercut => "the profile is undercut",
        FindingKind::GrooveUndercut => "the outer wall of the groove is undercut",
        FindingKind::ConcaveFlat => "the flat face cannot follow the profile",
        FindingKind::Doubtful => "the conditions hardly determine a curve",
        FindingKind::BelowBase => "the follower goes below the base circle",
        FindingKind::SelfCrossing => "the profile crosses itself",
        FindingKind::ArmCutsCam => "the follower cuts into the cam",
        FindingKind::PivotInsideCam => "the cam sweeps over the pivot",
        FindingKind::FaceOvertaken => "the face turns faster than the cam",
        FindingKind::ContactPastPivot => "the contact passes the pivot",
    }
}

/// What another base circle brings, after it has been named.
fn passing(kind: FindingKind, units: Units) -> &'static str {
    match kind {
        FindingKind::PressureAngle => "it stays below",
        FindingKind::Cusp | FindingKind::Undercut => "the profile has neither cusps nor undercuts",
        FindingKind::GrooveUndercut => "neither wall of the groove is undercut",
        FindingKind::ConcaveFlat => "the flat face touches the whole profile",
        FindingKind::SelfCrossing => "the profile no longer crosses itself",
        FindingKind::ArmCutsCam if units.oscillating => "the arm clears the cam",
        FindingKind::ArmCutsCam => "the stem clears the cam",
        FindingKind::PivotInsideCam => "the cam clears the pivot",
        FindingKind::FaceOvertaken => "the face keeps its contact",
        FindingKind::ContactPastPivot => "the contact stays on its side of the pivot",
        FindingKind::Jump(_) | FindingKind::BelowBase | FindingKind::Doubtful => "the cam is sound",
    }
}

fn in_segments(segments: &[usize]) -> String {
    const NAMED: usize = 8;
    match segments {
        [one] => format!("in segment {one}"),
        many if many.len() > NAMED => format!("in {} segments", many.len()),
        many => format!("in segments {}", row(&many.iter().map(usize::to_string).collect::<Vec<_>>(), "and")),
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

fn row_of(words: &[&str]) -> String {
    row(&words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>(), "and")
}
