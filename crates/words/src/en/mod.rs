//! English: names, verdicts, links and files.

mod data;
mod finding;
mod problem;

use crate::voice::{FileProblem, Voice, joints_of_the_jerk, rests, row, worst_kinds};
use crate::{Language, Units};
use levalab_core::{FindingKind, Level};
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Problem, Remedy, quoted};

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
            "polynomial" => "free polynomial",
            "bspline" => "B-spline",
            "bezier" => "Bézier",
            "table" => "table of points",
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
            Level::Acceptable if rests(report) => "Acceptable, but nothing moves: every rise is 0.".to_owned(),
            Level::Acceptable if joints > 0 => {
                "Acceptable: the yoke holds the cam, and jumps of the acceleration do not part them.".to_owned()
            }
            Level::Acceptable => {
                "Acceptable: the motion is smooth up to the jerk, and the profile is sound.".to_owned()
            }
            Level::LowSpeed if joints_of_the_jerk(report) == 0 => {
                "Not for high speeds until it is proved: the limit of the calculation was reached before every extreme was certain."
                    .to_owned()
            }
            Level::LowSpeed if joints_of_the_jerk(report) == 1 => "Not for high speeds: the jerk jumps at one joint.".to_owned(),
            Level::LowSpeed => {
                format!("Not for high speeds: the jerk jumps at {} joints.", joints_of_the_jerk(report))
            }
            Level::Unacceptable => {
                let reasons: Vec<String> =
                    worst_kinds(report).into_iter().map(|kind| reason(kind).to_owned()).collect();
                format!("Unacceptable: {}.", row(&reasons, "and"))
            }
        }
    }

    fn finding(&self, finding: &DesignFinding, units: Units) -> String {
        finding::finding(finding, units)
    }

    fn cure(&self, finding: &DesignFinding, remedy: &Remedy, units: Units) -> String {
        finding::cure(finding, remedy, units)
    }

    fn problem(&self, problem: &Problem) -> String {
        problem::problem(problem)
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
            LinkError::Newer { found } => {
                format!(
                    "The link was made by a newer version of LevaLab: its part {} is not known here.",
                    quoted(found)
                )
            }
            LinkError::Unreadable => "The link is whole, but it is not a design that this program can read.".to_owned(),
            LinkError::Design(error) => self.problem(&error.problem),
        }
    }

    fn link_from_query(&self) -> &'static str {
        "The link came behind “?” instead of “#”, so the design did reach the server of this page. The address now holds it behind “#”, which stays in the browser."
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
        FindingKind::NotProved(_) => "not every extreme is proved",
        FindingKind::Doubtful => "the conditions hardly determine a curve",
        FindingKind::BelowBase => "the follower goes below the base circle",
        FindingKind::SelfCrossing => "the profile crosses itself",
        FindingKind::ArmCutsCam => "the follower cuts into the cam",
        FindingKind::PivotInsideCam => "the cam sweeps over the pivot",
        FindingKind::FaceOvertaken => "the face turns faster than the cam",
        FindingKind::ContactPastPivot => "the contact passes the pivot",
    }
}
