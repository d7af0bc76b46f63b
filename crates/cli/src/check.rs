//! `levalab check`: the verdict in words.

use crate::failure::{Failure, shown};
use crate::{input, output};
use levalab_core::{Analysis, Cam, Level, profiles_coincide};
use levalab_format::Design;
use levalab_format::report::Report;
use levalab_words::Language;
use std::process::ExitCode;

/// Writes the verdict on each file; the exit code is the worst of them all. A file that cannot be judged is told and the rest are
/// judged all the same.
pub fn run(files: &[String], language: Language) -> Result<ExitCode, Failure> {
    let several = files.len() > 1;
    let mut worst = 0;
    for file in files {
        let code = match judge(file, language) {
            Ok((level, verdict)) => {
                let name = if several { format!("{}: ", shown(file)) } else { String::new() };
                output::write(&format!("{name}{verdict}"), language)?;
                code_of(level)
            }
            Err(failure) => {
                let failure = if several { failure.of(file) } else { failure };
                failure.tell();
                failure.code()
            }
        };
        worst = worst.max(code);
    }
    Ok(ExitCode::from(worst))
}

fn code_of(level: Level) -> u8 {
    match level {
        Level::Acceptable => 0,
        Level::LowSpeed => 1,
        Level::Unacceptable => 2,
    }
}

/// The verdict on a design: the worse of its cams, and what is said of each.
fn judge(file: &str, language: Language) -> Result<(Level, String), Failure> {
    let (design, cams) = input::design_and_cams(file, language)?;
    let (level, text) = verdict(&design, &cams.first, language);
    let (level, text) = match &cams.second {
        Some(second) => {
            let (worse, more) = verdict(&design, second, language);
            let one = if profiles_coincide(&cams.first, second) {
                levalab_words::profiles_coincide(language).to_owned() + "\n"
            } else {
                String::new()
            };
            (level.max(worse), format!("{text}{}: {more}{one}", levalab_words::second_cam(language)))
        }
        None => (level, text),
    };
    Ok((level, text + &application(&design, &cams.first, language)))
}

/// What comes of the application, when there is one. It is no part of the verdict.
fn application(design: &Design, cam: &Cam, language: Language) -> String {
    let Some(set) = &design.application else { return String::new() };
    let outcome = set.outcome(design, cam, &Analysis::of(cam, 1));
    let head = levalab_words::application_title(language, set.application.id);
    let sentences = levalab_words::outcome(language, design, &outcome);
    sentences.iter().fold(format!("{head}:\n"), |text, sentence| text + &format!("  {sentence}\n"))
}

/// The headline, then each finding with its cures.
fn verdict(design: &Design, cam: &Cam, language: Language) -> (Level, String) {
    // The verdict is exact whatever the steps are.
    let analysis = Analysis::of(cam, 1);
    let report = Report::of(design, cam, &analysis);
    let mut text = levalab_words::headline(language, &report) + "\n";
    let cures = levalab_format::cures(design, cam, &analysis);
    for (finding, cures) in report.findings.iter().zip(&cures) {
        text += &format!("  {}\n", levalab_words::finding(language, design, finding));
        for cure in cures {
            text += &format!("  → {}\n", levalab_words::cure(language, design, finding, &cure.remedy));
        }
    }
    (report.level, text)
}
