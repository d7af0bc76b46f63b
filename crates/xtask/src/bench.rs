//! Measures: the core by criterion, the page in a browser; each figure beside its goal.

use anyhow::Result;

use crate::{dist, process, project, setup};

/// What to measure.
#[derive(clap::Args)]
pub struct Options {
    /// Only the core, without a browser.
    #[arg(long, conflicts_with = "page")]
    core: bool,
    /// Only the page.
    #[arg(long)]
    page: bool,
}

/// Measures and prints.
pub fn run(options: &Options) -> Result<()> {
    if !options.page {
        process::run(&mut process::cargo(["bench", "--package", "levalab-core"]))?;
    }
    if !options.core {
        dist::pack()?;
        let mut command = process::node([project::path("tests/browser/bench.js")]);
        command.env("LEVALAB_BROWSER", setup::browser()?);
        process::run(&mut command)?;
    }
    Ok(())
}
