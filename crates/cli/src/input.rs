//! Designs from files, standard input and links.

use crate::failure::Failure;
use levalab_format::limits::{MAX_FILE_BYTES, MAX_LINK_OPENED};
use levalab_format::{Design, Notation, Study, link};
use levalab_words::Language;
use std::fs::File;
use std::io::{self, Read};
use std::sync::OnceLock;

/// The name that stands for standard input.
const STANDARD_INPUT: &str = "-";

/// Longest address before the `#` of a link that is read from standard input, bytes.
const LONGEST_ADDRESS: usize = 8192;

/// The symbols that the command line asks for, whatever a design says.
static NOTATION: OnceLock<Option<Notation>> = OnceLock::new();

/// Tells every design that is read from now on in these symbols.
pub fn tell_in(notation: Option<Notation>) {
    // Asked once, before anything is read.
    let _ = NOTATION.set(notation);
}

fn told(design: Design) -> Design {
    let notation = NOTATION.get().copied().flatten().unwrap_or(design.notation);
    Design { notation, ..design }
}

/// The design of a design file.
pub fn design(name: &str, language: Language) -> Result<Design, Failure> {
    let bytes = read_file(name, language)?;
    Design::from_bytes(&bytes).map(told).map_err(|error| Failure::design(&error, name, language))
}

/// The study of a design file; its columns have `rows` + 1 values.
pub fn study(name: &str, rows: usize, language: Language) -> Result<Study, Failure> {
    let bytes = read_file(name, language)?;
    let study = Study::from_bytes(&bytes, rows).map_err(|error| Failure::design(&error, name, language))?;
    Ok(match NOTATION.get().copied().flatten() {
        Some(notation) => study.in_notation(notation),
        None => study,
    })
}

fn read_file(name: &str, language: Language) -> Result<Vec<u8>, Failure> {
    // One byte more than the limit, so that a file that is too large is seen to be.
    read(name, MAX_FILE_BYTES + 1, language)
}

/// The design of a link.
pub fn design_of_link(text: &str, language: Language) -> Result<Design, Failure> {
    let text = if text == STANDARD_INPUT {
        let bytes = read(text, MAX_LINK_OPENED + LONGEST_ADDRESS, language)?;
        String::from_utf8_lossy(&bytes).into_owned()
    } else {
        text.to_owned()
    };
    let refused = |error| Failure::data("link", levalab_words::link_error(language, &error));
    link::decode(link::within(&text)).map(told).map_err(refused)
}

/// The bytes of a file or of standard input, no more than so many.
pub fn read(name: &str, most: usize, language: Language) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let limit = most as u64;
    let read = if name == STANDARD_INPUT {
        io::stdin().lock().take(limit).read_to_end(&mut bytes)
    } else {
        File::open(name).and_then(|file| file.take(limit).read_to_end(&mut bytes))
    };
    read.map_err(|error| Failure::no_input(name, &error, language))?;
    Ok(bytes)
}
