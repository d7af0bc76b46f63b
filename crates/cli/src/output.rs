//! Standard output.

use crate::failure::Failure;
use levalab_words::Language;
use std::io::{self, Write};

/// Writes a result, all of it at once. A reader that has seen enough and closed the pipe is no error.
pub fn write(text: &str, language: Language) -> Result<(), Failure> {
    write_bytes(text.as_bytes(), language)
}

/// The same for what is not text.
pub fn write_bytes(bytes: &[u8], language: Language) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    match output.write_all(bytes).and_then(|()| output.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::no_output(language)),
        _ => Ok(()),
    }
}
