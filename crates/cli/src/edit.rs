//! `levalab edit`: a design with some changes made.

use crate::failure::Failure;
use crate::input;
use levalab_format::limits::MAX_FILE_BYTES;
use levalab_format::{DesignError, Edit};
use levalab_words::Language;

/// What to change, in order.
#[derive(clap::Args)]
pub struct Options {
    /// Design file.
    file: String,
    /// A change: `cam.base_radius=36` (nothing after the sign takes the field away), or an edit in JSON such as `{"op":"spread"}`.
    #[arg(required_unless_present = "edits", allow_hyphen_values = false)]
    changes: Vec<String>,
    /// A file with a list of edits in JSON, as a cure has them; made before the others.
    #[arg(long, value_name = "FILE")]
    edits: Option<String>,
}

/// The design file with the changes made.
pub fn run(options: &Options, language: Language) -> Result<String, Failure> {
    let design = input::design(&options.file, language)?;
    let mut edits = match &options.edits {
        Some(file) => listed(file, language)?,
        None => Vec::new(),
    };
    for change in &options.changes {
        edits.extend(read(change).map_err(|error| no_edit(&error, language))?);
    }
    let edited = design.edited(&edits).map_err(|error| Failure::design(&error, &options.file, language))?;
    Ok(edited.to_json())
}

/// The edits of a file.
fn listed(file: &str, language: Language) -> Result<Vec<Edit>, Failure> {
    let bytes = input::read(file, MAX_FILE_BYTES + 1, language)?;
    Edit::from_bytes(&bytes).map_err(|error| Failure::design(&error, file, language))
}

/// The edits of an argument: JSON begins with a bracket, which no path does.
fn read(change: &str) -> Result<Vec<Edit>, DesignError> {
    if change.trim_start().starts_with(['{', '[']) {
        Edit::from_bytes(change.as_bytes())
    } else {
        Edit::assignment(change).map(|edit| vec![edit])
    }
}

fn no_edit(error: &DesignError, language: Language) -> Failure {
    let message = levalab_words::design_error(language, error);
    Failure::usage(if error.path == "edits".into() { message } else { format!("{}: {message}", error.path) })
}
