//! Many random designs and damaged links through the design file and the link, and random texts as formulas, in search of one that breaks them.

use anyhow::Result;

use crate::process::{self, run_told};

/// How many.
#[derive(clap::Args)]
pub struct Options {
    /// Random designs, damaged links and formulas to try, of each.
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
    let count = options.count;
    let designs = ["--package", "levalab-format", "--test", "soak", "--", "--nocapture"];
    let formulas =
        ["--package", "levalab-core", "--lib", "--", "any_text_is_an_expression_or_a_refusal", "--nocapture"];
    for (what, arguments) in [("designs and damaged links", designs), ("formulas", formulas)] {
        let mut command = process::cargo(["test", "--release"].into_iter().chain(arguments));
        command.env("LEVALAB_SOAK", count.to_string());
        run_told(&format!("trying {count} {what}"), &mut command)?;
    }
    Ok(())
}
