//! `levalab check`: the verdict in words.

use crate::failure::{Failure, shown};
use crate::{input, output};
use levalab_core::{Level, profiles_coincide};
use levalab_format::{CamStudy, Study};
use levalab_words::Language;
use std::num::NonZero;
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::thread;

/// Writes the verdict on each file, in the order of the files; the exit code is the worst of them all. A file that cannot be judged is
/// told and the rest are judged all the same.
///
/// Files are judged on all cores, by plain threads that take the next one as they are ready: verdicts share nothing, so a pool with
/// queues of its own would add nothing but a dependency.
pub fn run(files: &[String], language: Language) -> Result<ExitCode, Failure> {
    let next = AtomicUsize::new(0);
    let (judged, verdicts) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..workers(files.len()) {
            let judged = judged.clone();
            let work = || {
                let judged = judged;
                while let Some((place, file)) = take(&next, files) {
                    // Nobody listens any more when the output cannot be written.
                    if judged.send((place, judge(file, language))).is_err() {
                        return;
                    }
                }
            };
            // Where the system gives no thread more, those that there are do the work.
            let _ = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
        }
        drop(judged);
        tell(files, verdicts, language)
    })
}

/// Bytes of stack for each thread: as many as the main thread has on most systems.
const STACK: usize = 8 << 20;

/// As many threads as there are cores, and no more than files.
fn workers(files: usize) -> usize {
    thread::available_parallelism().map_or(1, NonZero::get).min(files)
}

/// The next file that nobody has taken, with its place in the row.
fn take<'a>(next: &AtomicUsize, files: &'a [String]) -> Option<(usize, &'a String)> {
    let place = next.fetch_add(1, Ordering::Relaxed);
    files.get(place).map(|file| (place, file))
}

/// A verdict, or why there is none.
type Judged = Result<(Level, String), Failure>;

/// Writes each verdict as soon as those before it are written.
fn tell(files: &[String], verdicts: Receiver<(usize, Judged)>, language: Language) -> Result<ExitCode, Failure> {
    let mut waiting: Vec<Option<Judged>> = files.iter().map(|_| None).collect();
    let (mut written, mut worst) = (0, 0);
    for (place, verdict) in verdicts {
        waiting[place] = Some(verdict);
        while let Some(verdict) = waiting.get_mut(written).and_then(Option::take) {
            worst = worst.max(write(files, written, verdict, language)?);
            written += 1;
        }
    }
    // A system that gave no thread at all leaves the work here.
    for place in written..files.len() {
        worst = worst.max(write(files, place, judge(&files[place], language), language)?);
    }
    Ok(ExitCode::from(worst))
}

/// Writes one verdict, or why there is none, and gives the exit code that it stands for.
fn write(files: &[String], place: usize, verdict: Judged, language: Language) -> Result<u8, Failure> {
    match verdict {
        Ok((level, verdict)) => {
            let name = if files.len() > 1 { format!("{}: ", shown(&files[place])) } else { String::new() };
            output::write(&format!("{name}{verdict}"), language)?;
            Ok(code_of(level))
        }
        Err(failure) => {
            failure.tell();
            Ok(failure.code())
        }
    }
}

fn code_of(level: Level) -> u8 {
    match level {
        Level::Acceptable => 0,
        Level::LowSpeed => 1,
        Level::Unacceptable => 2,
    }
}

/// The verdict on a design: the worse of its cams, and what is said of each.
fn judge(file: &str, language: Language) -> Judged {
    // The verdict is exact with any number of rows.
    let study = input::study(file, 1, language)?;
    let text = verdict(study.first(), language);
    let text = match study.second() {
        Some(second) => {
            let more = verdict(second, language);
            let one = if profiles_coincide(study.first().cam(), second.cam()) {
                levalab_words::profiles_coincide(language).to_owned() + "\n"
            } else {
                String::new()
            };
            text + &levalab_words::of_second_cam(language, &more) + &one
        }
        None => text,
    };
    Ok((study.level(), text + &application(&study, language)))
}

/// What comes of the application, when there is one. It is no part of the verdict.
fn application(study: &Study, language: Language) -> String {
    let Some((set, outcome)) = study.design().application.as_ref().zip(study.outcome()) else { return String::new() };
    let head = levalab_words::application_title(language, set.application);
    let sentences = levalab_words::outcome(language, study.design(), &outcome);
    sentences.iter().fold(format!("{head}:\n"), |text, sentence| text + &format!("  {sentence}\n"))
}

/// The headline, then each finding with its cures.
fn verdict(cam: &CamStudy, language: Language) -> String {
    let (design, report) = (cam.design(), cam.report());
    let mut text = levalab_words::headline(language, report) + "\n";
    for (finding, cures) in report.findings.iter().zip(&cam.cures()) {
        text += &format!("  {}\n", levalab_words::finding(language, design, finding));
        for cure in cures {
            text += &format!("  → {}\n", levalab_words::cure(language, design, finding, &cure.remedy));
        }
    }
    text
}
