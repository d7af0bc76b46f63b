//! Every check there is, one step after the other, with a table at the end.

use std::{
    cell::OnceCell,
    path::PathBuf,
    process::Command,
    time::{Duration, Instant},
};

use anyhow::{Context, Result, anyhow, bail};

use crate::{
    dist, licences,
    process::{self, cargo, node, seconds},
    project,
    setup::{self, WASM, WasmCompiler},
    soak,
    wasm::{self, Build},
};

/// Which steps to run.
#[derive(clap::Args)]
pub struct Options {
    /// Run only the steps whose name contains one of these.
    steps: Vec<String>,
    /// List the steps.
    #[arg(long)]
    list: bool,
}

struct Step {
    name: &'static str,
    claim: &'static str,
    check: fn(&Bench) -> Result<()>,
}

/// What several steps need, made once, by the first that asks.
#[derive(Default)]
struct Bench {
    module: OnceCell<Result<(), String>>,
    packed: OnceCell<Result<PathBuf, String>>,
}

const STEPS: [Step; 15] = [
    Step { name: "format", claim: "Rust is formatted", check: format },
    Step { name: "clippy", claim: "Rust has no warnings", check: clippy },
    Step { name: "clippy-wasm", claim: "neither have the page's modules", check: clippy_wasm },
    Step { name: "native", claim: "Rust tests and documentation examples hold", check: native },
    Step { name: "soak", claim: "no random design or damaged link gets through", check: soak_short },
    Step { name: "independent", claim: "a second set of formulas agrees with the command", check: independent },
    Step { name: "rustdoc", claim: "the documentation builds, its links lead somewhere", check: rustdoc },
    Step { name: "licences", claim: "what is built in has an allowed licence, and its notice", check: licences },
    Step { name: "dist", claim: "the page packs and names no other host", check: packs },
    Step { name: "wasm", claim: "the shipped module computes what the command line does", check: wasm_against_native },
    Step { name: "types", claim: "JavaScript passes strict type checking", check: types },
    Step { name: "lint", claim: "JavaScript passes eslint", check: lint },
    Step { name: "unit", claim: "the page's own tests hold", check: unit },
    Step { name: "serve", claim: "the development server gives the page and nothing else", check: serve },
    Step { name: "browser", claim: "the packed page works in Chromium, and its main job in Firefox", check: browser },
];

/// Runs the steps asked for, all of them even when one fails.
fn run_steps(options: &Options) -> Result<()> {
    let wanted =
        |step: &&Step| options.steps.is_empty() || options.steps.iter().any(|part| step.name.contains(part.as_str()));
    let steps: Vec<_> = STEPS.iter().filter(wanted).collect();
    if steps.is_empty() {
        bail!("no step has such a name; there are {}", STEPS.map(|step| step.name).join(", "));
    }
    let bench = Bench::default();
    let results: Vec<_> = steps.iter().map(|step| perform(step, &bench)).collect();
    print_table(&steps, &results);
    match results.iter().filter(|result| !result.passed).count() {
        0 => Ok(()),
        failures => bail!("{failures} of {} steps failed", steps.len()),
    }
}

/// The command: runs or lists.
pub fn run(options: &Options) -> Result<()> {
    if !options.list {
        return run_steps(options);
    }
    for step in &STEPS {
        println!("{:<12} {}", step.name, step.claim);
    }
    Ok(())
}

struct Outcome {
    passed: bool,
    time: Duration,
}

fn perform(step: &Step, bench: &Bench) -> Outcome {
    println!("\n▶ {}: {}", step.name, step.claim);
    let start = Instant::now();
    let result = (step.check)(bench);
    if let Err(error) = &result {
        println!("✗ {}: {error:#}", step.name);
    }
    Outcome { passed: result.is_ok(), time: start.elapsed() }
}

fn print_table(steps: &[&Step], outcomes: &[Outcome]) {
    println!();
    for (step, outcome) in steps.iter().zip(outcomes) {
        let mark = if outcome.passed { "✓ pass" } else { "✗ FAIL" };
        println!("{mark}  {:<12} {:>8}  {}", step.name, seconds(outcome.time), step.claim);
    }
    let total = outcomes.iter().map(|outcome| outcome.time).sum();
    println!("{:<6}  {:<12} {:>8}", "", "together", seconds(total));
}

impl Bench {
    fn module(&self) -> Result<()> {
        let built = self.module.get_or_init(|| wasm::build(Build::Shipped).map_err(|error| format!("{error:#}")));
        built.clone().map_err(|error| anyhow!(error))
    }

    /// The packed folder with everything but `index.html`.
    fn packed(&self) -> Result<PathBuf> {
        let packed = self.packed.get_or_init(|| dist::pack().map_err(|error| format!("{error:#}")));
        packed.clone().map_err(|error| anyhow!(error))
    }
}

fn format(_: &Bench) -> Result<()> {
    process::run(&mut cargo(["fmt", "--all", "--check"]))
}

fn clippy(_: &Bench) -> Result<()> {
    process::run(&mut cargo(["clippy", "--workspace", "--all-targets", "--", "--deny", "warnings"]))
}

fn clippy_wasm(_: &Bench) -> Result<()> {
    match setup::wasm_compiler()? {
        WasmCompiler::Same => {
            let mut command = cargo(["clippy"]);
            process::run(command.args(wasm::packages()).args(["--target", WASM, "--", "--deny", "warnings"]))
        }
        // Clippy belongs to the other compiler: the compiler's own warnings have to do.
        WasmCompiler::Debian { linker } => process::run(&mut wasm::debian_check(&linker)?),
    }
}

fn soak_short(_: &Bench) -> Result<()> {
    soak::run(&soak::Options::default())
}

fn native(_: &Bench) -> Result<()> {
    process::run(&mut cargo(["test", "--workspace"]))
}

fn rustdoc(_: &Bench) -> Result<()> {
    let mut command = cargo(["doc", "--workspace", "--no-deps"]);
    process::run(command.env("RUSTDOCFLAGS", "--deny warnings"))
}

fn licences(_: &Bench) -> Result<()> {
    licences::check()
}

fn packs(bench: &Bench) -> Result<()> {
    bench.packed().map(drop)
}

fn wasm_against_native(bench: &Bench) -> Result<()> {
    let packed = bench.packed()?;
    let mut command = node_test("tests/wasm/*.test.js")?;
    command.env("LEVALAB_CLI", command_line()?).env("LEVALAB_MODULE", packed.join("pkg"));
    process::run(&mut command)
}

fn independent(_: &Bench) -> Result<()> {
    process::run(node_test("tests/independent/*.test.mjs")?.env("LEVALAB_CLI", command_line()?))
}

/// The `levalab` command, up to date.
fn command_line() -> Result<PathBuf> {
    process::run(&mut cargo(["build", "--package", "levalab-cli"]))?;
    Ok(project::target()?.join("debug").join(format!("levalab{}", std::env::consts::EXE_SUFFIX)))
}

fn types(bench: &Bench) -> Result<()> {
    setup::node_modules()?;
    // The module's types are generated with it.
    bench.module()?;
    for project in ["tsconfig.json", "tests/tsconfig.json"] {
        process::run(&mut node_tool("typescript/bin/tsc", &["--project", project]))?;
    }
    Ok(())
}

fn lint(_: &Bench) -> Result<()> {
    setup::node_modules()?;
    process::run(&mut node_tool("eslint/bin/eslint.js", &["--max-warnings=0", "."]))
}

fn unit(bench: &Bench) -> Result<()> {
    bench.module()?;
    process::run(&mut node_test("web/**/*.test.js")?)
}

fn serve(bench: &Bench) -> Result<()> {
    bench.module()?;
    let mut command = node_test("tests/serve/*.test.js")?;
    command.env("LEVALAB_XTASK", std::env::current_exe()?).env("LEVALAB_BROWSER", setup::browser()?);
    process::run(&mut command)
}

fn browser(bench: &Bench) -> Result<()> {
    bench.packed()?;
    let mut command = node_test("tests/browser/*.test.js")?;
    process::run(command.env("LEVALAB_BROWSER", setup::browser()?).env("LEVALAB_FIREFOX", setup::firefox()?))
}

fn node_tool(script: &str, arguments: &[&str]) -> Command {
    let mut command = node([project::npm_tool(script)]);
    command.args(arguments);
    command
}

/// Node's test runner over the files that match; none at all is a failure.
fn node_test(pattern: &str) -> Result<Command> {
    setup::node_modules()?;
    let mut command = node(["--test", "--test-reporter=spec"]);
    command.args(matching(pattern)?);
    Ok(command)
}

/// Files of one folder (`folder/*.test.js`) or of a tree (`folder/**/*.test.js`): Node 20 takes names, not patterns.
fn matching(pattern: &str) -> Result<Vec<PathBuf>> {
    let (folder, name) = pattern.rsplit_once('/').context("a pattern has a folder")?;
    let (folder, depth) = folder.strip_suffix("/**").map_or((folder, 1), |folder| (folder, usize::MAX));
    let ending = name.trim_start_matches('*');
    let entries = walkdir::WalkDir::new(project::path(folder)).max_depth(depth).sort_by_file_name();
    let files: Vec<_> = entries.into_iter().flatten().map(walkdir::DirEntry::into_path).collect();
    let files: Vec<_> = files.into_iter().filter(|file| file.to_string_lossy().ends_with(ending)).collect();
    if files.is_empty() {
        bail!("no file matches {pattern}");
    }
    Ok(files)
}
