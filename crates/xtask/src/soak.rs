//! Many random designs and damaged links through the design file and the link, in search of one that breaks them.

use anyhow::Result;

use crate::process::{self, run_told};

/// How many.
#[derive(clap::Args)]
pub struct Options {
    /// Random designs and damaged links to try, of each.
    #[arg(long, default_value_t = SHORT)]
    count: u64,
}

/// How many are tried when nothing is said, and by `cargo xtask test`.
const SHORT: u64 = 100_000;

impl Default for Options {
    fn default() -> Self {
        Self { count: SHORT }
    }
}

/// Runs the soak test, optimised, with the count asked for.
pub fn run(options: &Options) -> Result<()> {
    let arguments = ["test", "--release", "--package", "levalab-format", "--test", "soak", "--", "--nocapture"];
    let mut command = process::cargo(arguments);
    command.env("LEVALAB_SOAK", options.count.to_string());
    run_told(&format!("trying {} designs and damaged links", options.count), &mut command)
}
