//! The notices of everything that is built into the page and the command: written into `LICENSE-THIRD-PARTY.txt`, which both carry,
//! and checked against the packages themselves.

mod document;
mod notice;
mod package;
mod standard;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
};

use anyhow::{Context, Result, ensure};

use crate::project;
use document::Document;
use notice::Notice;
use package::{Builds, Package};

/// The file that the command, the page and the single file carry.
const FILE: &str = "LICENSE-THIRD-PARTY.txt";

/// Writes the file anew: for that the packages of every system that the command is built for must be here, or be fetched.
pub fn write() -> Result<()> {
    let packages = package::built_in(Builds::EverySystem)?;
    let document = Document::new(notices(&packages)?)?;
    fs::write(project::path(FILE), document.text()).context(FILE)?;
    println!("{FILE}: {} packages", packages.len());
    Ok(())
}

/// Checks that what is built in here, for the page and for this system, has an allowed licence and its notice in the file, and that the
/// file names nothing that is gone. It works without the network.
pub fn check() -> Result<()> {
    let written = fs::read_to_string(project::path(FILE)).context(FILE)?;
    let packages = package::built_in(Builds::ThisSystem)?;
    let mut wrong = Vec::new();
    match notices(&packages).and_then(Document::new) {
        Ok(document) => wrong.extend(document.missing_in(&written)),
        Err(error) => wrong.push(format!("{error:#}")),
    }
    wrong.extend(stale(&written)?);
    wrong.extend(standard::unknown_in_toolchain()?);
    wrong.extend(shipped_from_npm()?);
    ensure!(wrong.is_empty(), "{}\n`cargo xtask licences` writes {FILE} anew", wrong.join("\n"));
    println!("{} packages, each with its notice in {FILE}", packages.len());
    Ok(())
}

/// What must be said of each package, and of the standard library.
fn notices(packages: &BTreeSet<Package>) -> Result<Vec<Notice>> {
    let mut all = Vec::new();
    let mut refused = Vec::new();
    for package in packages {
        match notice::of(package) {
            Ok(notices) => all.extend(notices),
            Err(error) => refused.push(format!("{package}: {error:#}")),
        }
    }
    ensure!(refused.is_empty(), "{}", refused.join("\n"));
    all.extend(standard::notices());
    Ok(all)
}

/// Packages of npm that the page would need when it runs: it has none, and the file tells of none.
fn shipped_from_npm() -> Result<Option<String>> {
    let manifest = fs::read_to_string(project::path("package.json")).context("package.json")?;
    let manifest: serde_json::Value = serde_json::from_str(&manifest).context("package.json")?;
    let none = manifest.get("dependencies").is_none();
    Ok((!none).then(|| "package.json has dependencies that are no development tools".to_owned()))
}

/// Packages that the file names and `Cargo.lock` does not.
fn stale(written: &str) -> Result<Vec<String>> {
    let lock = fs::read_to_string(project::path("Cargo.lock")).context("Cargo.lock")?;
    let mut locked: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    let mut name = "";
    for line in lock.lines() {
        if let Some(value) = quoted(line, "name = ") {
            name = value;
        } else if let Some(version) = quoted(line, "version = ") {
            locked.entry(name).or_default().push(version);
        }
    }
    let gone = document::packages_in(written).filter(|(name, version)| {
        let versions = locked.get(name);
        !versions.is_some_and(|versions| versions.contains(version))
    });
    Ok(gone.map(|(name, version)| format!("{name} {version} is not in Cargo.lock")).collect())
}

fn quoted<'a>(line: &'a str, key: &str) -> Option<&'a str> {
    line.strip_prefix(key)?.strip_prefix('"')?.strip_suffix('"')
}
