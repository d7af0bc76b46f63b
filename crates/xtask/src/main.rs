//! `cargo xtask serve | test | dist | bench | soak | licences`: everything that builds, runs and checks LevaLab.

mod bench;
mod dist;
mod html;
mod library;
mod licences;
mod offline;
mod page;
mod poster;
mod process;
mod project;
mod serve;
mod setup;
mod single;
mod size;
mod soak;
mod test;
mod theory;
mod wasm;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Builds, serves, tests and measures LevaLab.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Builds the page and serves it on this machine; rebuilds when a Rust file changes.
    Serve(serve::Options),
    /// Runs every check; with names, only the steps whose name contains one of them.
    Test(test::Options),
    /// Packs the page into the static folder `dist/`, ready for any web server and any path, and into one file beside.
    Dist,
    /// Measures the core and the page against the goals.
    Bench(bench::Options),
    /// Tries many random designs and damaged links.
    Soak(soak::Options),
    /// Writes the notices of everything that is built in, after a package was added or updated.
    Licences,
}

fn main() -> ExitCode {
    match perform(Arguments::parse().task) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn perform(task: Task) -> anyhow::Result<()> {
    match task {
        Task::Serve(options) => serve::run(&options),
        Task::Test(options) => test::run(&options),
        Task::Dist => dist::run(),
        Task::Bench(options) => bench::run(&options),
        Task::Soak(options) => soak::run(&options),
        Task::Licences => licences::write(),
    }
}
