//! Many random designs and damaged links through the design file and the link, random designs with all their cures, sequences of edits with
//! undo and redo, and random texts as formulas, in search of one that breaks them.

use anyhow::Result;

use crate::process::{self, run_told};

/// How many.
#[derive(clap::Args)]
pub struct Options {
    /// Random designs, damaged links and sequences of edits to try, of each; formulas, which are quick, a million at least.
    #[arg(long, default_value_t = SHORT)]
    count: u64,
}

/// How many are tried when nothing is said, and by `cargo xtask test`.
const SHORT: u64 = 100_000;

/// Fewest texts tried as formulas: they take a second.
const FORMULAS: u64 = 1_000_000;

/// One sequence of edits for so many designs: twenty thousand in the test, two hundred thousand with `--count 1000000`.
const SEQUENCES: u64 = 5;

/// One design in so many is tried with all its cures, which takes hundreds of analyses: a thousand in the test, ten thousand with
/// `--count 1000000`.
const CURED: u64 = 100;

/// One formula for so many designs is surveyed and then sampled a hundred times as densely as usual: twenty thousand with
/// `--count 1000000`, and none for the usual count, since the tests of the core do it already.
const COMPARED: u64 = 50;

impl Default for Options {
    fn default() -> Self {
        Self { count: SHORT }
    }
}

/// Runs the soak test, optimised, with the count asked for.
pub fn run(options: &Options) -> Result<()> {
    let count = options.count;
    let designs = ["--package", "levalab-format", "--test", "soak", "--", "--nocapture"];
    let edits = ["--package", "levalab-format", "--test", "edits", "--", "--nocapture"];
    let formulas =
        ["--package", "levalab-core", "--lib", "--", "any_text_is_an_expression_or_a_refusal", "--nocapture"];
    let cures = ["--package", "levalab-format", "--test", "cures", "--", "every_cure", "--nocapture"];
    let compared = ["--package", "levalab-core", "--test", "formulas", "--", "--nocapture"];
    let all = [
        ("designs and damaged links", count, designs.as_slice()),
        ("sequences of edits", count / SEQUENCES, &edits),
        ("formulas", count.max(FORMULAS), &formulas),
        ("designs with all their cures", count / CURED, &cures),
        ("formulas at two numbers of rows", if count > SHORT { count / COMPARED } else { 0 }, &compared),
    ];
    for (what, count, arguments) in all.into_iter().filter(|(_, count, _)| *count > 0) {
        let mut command = process::cargo(["test", "--release"].into_iter().chain(arguments.iter().copied()));
        command.env("LEVALAB_SOAK", count.to_string());
        run_told(&format!("trying {count} {what}"), &mut command)?;
    }
    Ok(())
}
