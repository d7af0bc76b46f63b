//! `levalab auto`: a design from what its machine must do.

use crate::failure::Failure;
use crate::input;
use levalab_format::joined_from_bytes;
use levalab_format::limits::MAX_FILE_BYTES;
use levalab_words::Language;

/// Requirements, and what is wanted of them.
#[derive(clap::Args)]
pub struct Options {
    /// A design file with `requirements` in place of `segments`.
    pub file: String,
    /// Writes why each gap was joined as it was, in place of the design file.
    #[arg(long)]
    pub why: bool,
}

/// The design file, or the reasons.
pub fn run(options: &Options, language: Language) -> Result<String, Failure> {
    let bytes = input::read(&options.file, MAX_FILE_BYTES + 1, language)?;
    let joined = joined_from_bytes(&bytes).map_err(|error| Failure::design(&error, &options.file, language))?;
    if !options.why {
        return Ok(joined.design.to_json());
    }
    let told = levalab_words::join_choices(language, &joined.design, &joined.choices, joined.taste);
    Ok(told.into_iter().map(|sentence| sentence + "\n").collect())
}
