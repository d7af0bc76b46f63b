//! Running other programs: what is run is said before, how long it took after.

use std::{
    env,
    ffi::OsStr,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::{Duration, Instant},
};

use anyhow::{Context, Result, bail, ensure};

use crate::project;

/// The cargo that runs us, in the root of the checkout.
pub fn cargo<I: IntoIterator<Item: AsRef<OsStr>>>(arguments: I) -> Command {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    program(cargo, arguments)
}

/// Node, in the root of the checkout.
pub fn node<I: IntoIterator<Item: AsRef<OsStr>>>(arguments: I) -> Command {
    program("node", arguments)
}

/// npm, which on Windows is a script that has to be named in full.
pub fn npm<I: IntoIterator<Item: AsRef<OsStr>>>(arguments: I) -> Command {
    program(if cfg!(windows) { "npm.cmd" } else { "npm" }, arguments)
}

/// Any program, in the root of the checkout.
pub fn program<P, I>(program: P, arguments: I) -> Command
where
    P: AsRef<OsStr>,
    I: IntoIterator<Item: AsRef<OsStr>>,
{
    let mut command = Command::new(program);
    command.args(arguments).current_dir(project::root());
    command
}

/// Runs to the end, its output shown as it comes; anything but success is an error.
pub fn run(command: &mut Command) -> Result<()> {
    let name = Path::new(command.get_program()).display().to_string();
    let status = command.status().with_context(|| format!("{name} did not start"))?;
    if !status.success() {
        bail!("{name} ended with {status}");
    }
    Ok(())
}

/// Runs a lengthy command between a line that says what is going on and one that says how long it took.
pub fn run_told(what: &str, command: &mut Command) -> Result<()> {
    told(what, || run(command))
}

/// Does a lengthy thing between two such lines.
pub fn told<T>(what: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
    eprintln!("· {what} …");
    let start = Instant::now();
    let result = work().with_context(|| what.to_owned())?;
    eprintln!("· {what}: done in {}", seconds(start.elapsed()));
    Ok(result)
}

/// `12.3 s`.
pub fn seconds(time: Duration) -> String {
    format!("{:.1} s", time.as_secs_f64())
}

/// The trimmed output of a command, if it starts and succeeds.
pub fn output(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    output.status.success().then_some(text)
}

/// Looks a program up in PATH.
pub fn find(name: &str) -> Option<PathBuf> {
    let file = format!("{name}{}", env::consts::EXE_SUFFIX);
    let folders = env::var_os("PATH")?;
    env::split_paths(&folders).map(|folder| folder.join(&file)).find(|path| path.is_file())
}

/// What a command prints; its complaints are seen.
pub fn printed(command: &mut Command) -> Result<String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.stderr(Stdio::inherit()).output().with_context(|| format!("{name} did not start"))?;
    ensure!(output.status.success(), "{name} failed");
    Ok(String::from_utf8(output.stdout)?)
}
