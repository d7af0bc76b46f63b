//! English: names, verdicts, links and files.

mod data;
mod finding;
mod problem;

use crate::voice::{FileProblem, Voice, joints_of_the_jerk, rests, row, worst_kinds};
use crate::{Language, Units};
use levalab_catalogue::finding_label;
use levalab_core::Level;
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Problem, Remedy, quoted};

pub(crate) struct English;

const EN: Language = Language::En;

impl Voice for English {
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
                    worst_kinds(report).into_iter().map(|kind| finding_label(kind).reason.within(EN).to_owned()).collect();
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
