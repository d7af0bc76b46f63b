//! What ends the program: one line, and an exit code as in BSD's `sysexits.h`.

use levalab_export::Refusal;
use levalab_format::DesignError;
use levalab_words::{FileProblem, Language};
use std::fmt::Display;
use std::io::{self, Write};
use std::process::ExitCode;

/// The command line makes no sense.
const USAGE: u8 = 64;

/// The design or the link is bad.
const DATA: u8 = 65;

/// There is no such file, or it cannot be read.
const NO_INPUT: u8 = 66;

/// The result cannot be written.
const IO: u8 = 74;

/// Why the program ends without a result.
pub struct Failure {
    code: u8,
    /// A place in the input or the name of the input; empty when it is about neither.
    place: String,
    message: String,
}

impl Failure {
    /// Wrong use of the command.
    pub fn usage(message: String) -> Self {
        Self { code: USAGE, place: String::new(), message }
    }

    /// Something wrong at a place of the input.
    pub fn data(place: impl Display, message: String) -> Self {
        Self { code: DATA, place: place.to_string(), message }
    }

    /// A design that is refused: its file, and the place in it unless all of it is refused.
    pub fn design(error: &DesignError, file: &str, language: Language) -> Self {
        let (file, path) = (shown(file), error.path.to_string());
        let place = if path.is_empty() { file } else { format!("{file}: {path}") };
        Self::data(place, levalab_words::design_error(language, error))
    }

    /// A file that cannot be read.
    pub fn no_input(file: &str, error: &io::Error, language: Language) -> Self {
        let problem = match error.kind() {
            io::ErrorKind::NotFound => FileProblem::Absent,
            io::ErrorKind::PermissionDenied => FileProblem::Forbidden,
            io::ErrorKind::IsADirectory => FileProblem::Folder,
            _ => FileProblem::Unreadable,
        };
        Self { code: NO_INPUT, place: shown(file), message: levalab_words::file(language, problem).to_owned() }
    }

    /// Standard output that cannot be written.
    pub fn no_output(language: Language) -> Self {
        let message = levalab_words::file(language, FileProblem::Unwritable).to_owned();
        Self { code: IO, place: String::new(), message }
    }

    /// A file that cannot be written.
    pub fn unwritable(file: &str, language: Language) -> Self {
        Self { place: shown(file), ..Self::no_output(language) }
    }

    /// Something that cannot be exported: an option that makes no sense, or a cam that is not fit for it.
    pub fn export(refusal: &Refusal, file: &str, language: Language) -> Self {
        let message = refusal.sentence(language);
        match refusal.option() {
            Some(option) => Self { code: USAGE, place: format!("--{option}"), message },
            None => Self { code: DATA, place: shown(file), message },
        }
    }

    /// Tells it, and gives the exit code.
    pub fn report(&self) -> ExitCode {
        self.tell();
        ExitCode::from(self.code)
    }

    /// Tells it on one line of standard error.
    pub fn tell(&self) {
        let Self { place, message, .. } = self;
        let colon = if place.is_empty() { "" } else { ": " };
        // When standard error is closed there is nobody to tell.
        let _ = writeln!(io::stderr(), "levalab: {place}{colon}{message}");
    }

    /// The exit code.
    pub fn code(&self) -> u8 {
        self.code
    }
}

/// A file's name as it goes into an error line.
pub fn shown(file: &str) -> String {
    if file.chars().any(char::is_control) { levalab_format::quoted(file) } else { file.to_owned() }
}
