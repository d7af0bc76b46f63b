//! Running the command, and what every test asks of an answer.

use serde_json::Value;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// The command with its arguments, not yet run.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_levalab"));
    command.args(arguments);
    command
}

/// What comes of it, whatever that is.
pub fn levalab(arguments: &[&str]) -> Output {
    command(arguments).stdin(Stdio::null()).output().expect("levalab runs")
}

/// The same, with something on standard input.
pub fn with_input(arguments: &[&str], input: &[u8]) -> Output {
    let mut command = command(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("levalab runs");
    // One that ends without reading closes the pipe.
    let _ = child.stdin.take().expect("a pipe").write_all(input);
    child.wait_with_output().expect("levalab ends")
}

/// What it writes when all goes well: nothing else is said.
pub fn written(arguments: &[&str]) -> Vec<u8> {
    let output = levalab(arguments);
    assert!(output.status.success() && output.stderr.is_empty(), "{arguments:?}: {}", text(&output.stderr));
    output.stdout
}

/// The same as text.
pub fn said(arguments: &[&str]) -> String {
    text(&written(arguments))
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("text")
}

/// An example as a file.
pub fn file_of(name: &str) -> String {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(format!("{name}.lev.json"));
    file.to_str().expect("a plain path").to_owned()
}

/// An error is one line that begins so, with nothing on standard output.
pub fn check_refusal(output: &Output, code: i32, beginning: &str) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{said}");
    assert_eq!(text(&output.stdout), "", "{said}");
    assert!(said.starts_with(beginning) && said.ends_with('\n') && said.lines().count() == 1, "{said:?}");
}

/// The analysis as JSON.
pub fn analysis(arguments: &[&str]) -> Value {
    serde_json::from_slice(&written(&[&["analyze"], arguments].concat())).expect("JSON")
}
