//! `levalab`: analyses and checks design files, turns them into share links and back, and into files for other programs.
//!
//! Results go to standard output; an error is one line on standard error, with nothing on standard output and one of the exit
//! codes of [`Failure`].

mod analyze;
mod auto;
mod check;
mod compare;
mod convert;
mod edit;
mod export;
mod failure;
mod input;
mod output;
mod solve;
mod usage;

use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand, ValueEnum};
use failure::Failure;
use levalab_format::{Notation, link};
use levalab_words::Language;
use std::process::ExitCode;

/// Designs, analyses and checks plate cams.
#[derive(Parser)]
#[command(name = "levalab", version, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Language of sentences.
    #[arg(long, global = true, value_enum, default_value_t = Tongue::En)]
    lang: Tongue,
    /// Symbols to write in; those that the design says when left out.
    #[arg(long, global = true, value_parser = notation)]
    notation: Option<Notation>,
}

const EXIT_CODES: &str = "FILE is a design file (.lev.json), or - for standard input.\n\
    Exit codes: 0 done, 64 wrong use, 65 bad design or link, 66 no such file, 74 cannot write;\n\
    of `check`: 0 acceptable, 1 not for high speeds, 2 unacceptable.";

#[derive(Clone, Copy, ValueEnum)]
enum Tongue {
    /// English.
    En,
    /// Spanish.
    Es,
}

#[derive(Subcommand)]
enum Command {
    /// Writes motion, profile, pressure angle, radius of curvature and verdict, as JSON or CSV.
    Analyze(Analyze),
    /// Writes the verdict in words; the exit code tells it too.
    Check {
        /// Design files; the worst verdict is the exit code.
        #[arg(required = true)]
        files: Vec<String>,
    },
    /// Writes a table of several designs: base radius, peaks, pressure angle, least ρ, verdict.
    Compare {
        /// Design files.
        #[arg(required = true)]
        files: Vec<String>,
    },
    /// Writes a table of the same program with every law that fits, best first.
    Tournament {
        /// Design file; `·` is the design as it is.
        file: String,
        /// What to rank by.
        #[arg(long, value_enum, default_value_t = compare::Rank::Verdict)]
        by: compare::Rank,
    },
    /// Writes the worked solution: conditions, linear systems, formulas, continuity, extremes, substitution, size and verdict.
    Solve(solve::Options),
    /// Writes a file for another program: a table, a drawing or a solid.
    Export(export::Options),
    /// Writes the design file with some changes made.
    Edit(edit::Options),
    /// Writes the design file of the same cam in another unit.
    Convert(convert::Options),
    /// Writes the design file that does what a machine must do: dwells, lines and points, joined by the smoothest laws.
    Auto(auto::Options),
    /// Writes the share link of a design, the part after `#`.
    Link {
        /// Design file.
        file: String,
    },
    /// Writes the design file of a share link.
    Open {
        /// Link, with or without `#` and the address before it, or - for standard input.
        link: String,
    },
    /// Writes the licences of everything that is built in.
    #[command(visible_alias = "licences")]
    Licenses,
}

/// The licence of LevaLab itself.
const LICENSE: &str = include_str!("../../../LICENSE");

/// Notices of the works of others that are built in.
const THIRD_PARTY: &str = include_str!("../../../LICENSE-THIRD-PARTY.txt");

#[derive(Args)]
struct Analyze {
    /// Design file.
    file: String,
    /// Equal steps over the turn; there is one row more.
    #[arg(long, default_value_t = 720, allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=MOST_SAMPLES))]
    samples: u32,
    /// JSON: verdict, summary and columns (the default).
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// CSV: the columns.
    #[arg(long)]
    csv: bool,
}

/// Most steps over a turn: finer than any machine divides, and still some 30 MB of JSON.
const MOST_SAMPLES: i64 = 100_000;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(refusal) => return answer(&refusal),
    };
    let language = match cli.lang {
        Tongue::En => Language::En,
        Tongue::Es => Language::Es,
    };
    input::tell_in(cli.notation);
    run(cli.command, language).unwrap_or_else(|failure| failure.report())
}

fn notation(word: &str) -> Result<Notation, String> {
    Notation::of_word(word).ok_or_else(|| format!("one of {}", Notation::WORDS.join(", ")))
}

fn run(command: Command, language: Language) -> Result<ExitCode, Failure> {
    let text = match command {
        Command::Check { files } => return check::run(&files, language),
        Command::Export(options) => return export::run(&options, language),
        Command::Analyze(Analyze { file, samples, csv, .. }) => {
            let study = input::study(&file, samples as usize, language)?;
            if csv { analyze::csv(&study) } else { analyze::json(&study, language)? }
        }
        Command::Compare { files } => compare::designs(&files, language)?,
        Command::Tournament { file, by } => compare::laws(&file, by, language)?,
        Command::Solve(options) => solve::run(&options, language)?,
        Command::Auto(options) => auto::run(&options, language)?,
        Command::Edit(options) => edit::run(&options, language)?,
        Command::Convert(options) => convert::run(&options, language)?,
        Command::Link { file } => {
            let design = input::design(&file, language)?;
            let refused = |refusal| Failure::data(failure::shown(&file), levalab_words::too_long(language, refusal));
            link::encode(&design).map_err(refused)? + "\n"
        }
        Command::Open { link } => input::design_of_link(&link, language)?.to_json(),
        Command::Licenses => format!("{LICENSE}\n\n{THIRD_PARTY}"),
    };
    output::write(&text, language)?;
    Ok(ExitCode::SUCCESS)
}

/// Help and version when asked for; otherwise what is wrong with the command line, in one line.
fn answer(refusal: &clap::Error) -> ExitCode {
    if matches!(refusal.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        // Nobody is told when help cannot be written.
        let _ = refusal.print();
        return ExitCode::SUCCESS;
    }
    let language = usage::language_of(std::env::args_os());
    Failure::usage(usage::sentence(refusal, language)).report()
}
