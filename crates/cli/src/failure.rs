//! What ends the program: one line, and an exit code as in BSD's `sysexits.h`.

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
    line: String,
}

impl Failure {
    /// Wrong use of the command.
    pub fn usage(line: String) -> Self {
        Self { code: USAGE, line }
    }

    /// Something wrong at a place of the input; the place is empty when it is the whole of it.
    pub fn data(place: impl Display, message: impl Display) -> Self {
        let place = place.to_string();
        let line = if place.is_empty() { message.to_string() } else { format!("{place}: {message}") };
        Self { code: DATA, line }
    }

    /// A design that is refused.
    pub fn design(error: &DesignError, language: Language) -> Self {
        Self::data(&error.path, levalab_words::design_error(language, error))
    }

    /// A file that cannot be read.
    pub fn no_input(name: &str, error: &io::Error, language: Language) -> Self {
        let problem = match error.kind() {
            io::ErrorKind::NotFound => FileProblem::Absent,
            io::ErrorKind::PermissionDenied => FileProblem::Forbidden,
            io::ErrorKind::IsADirectory => FileProblem::Folder,
            _ => FileProblem::Unreadable,
        };
        Self { code: NO_INPUT, line: format!("{name}: {}", levalab_words::file(language, problem)) }
    }

    /// Standard output that cannot be written.
    pub fn no_output(language: Language) -> Self {
        Self { code: IO, line: levalab_words::file(language, FileProblem::Unwritable).to_owned() }
    }

    /// The same, naming the file it is about, for a command that takes several.
    pub fn of(self, file: &str) -> Self {
        if self.code == DATA { Self { line: format!("{}: {}", shown(file), self.line), ..self } } else { self }
    }

    /// Tells it, and gives the exit code.
    pub fn report(&self) -> ExitCode {
        self.tell();
        ExitCode::from(self.code)
    }

    /// Tells it on one line of standard error.
    pub fn tell(&self) {
        // When standard error is closed there is nobody to tell.
        let _ = writeln!(io::stderr(), "levalab: {}", self.line);
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
