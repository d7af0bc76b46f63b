//! The packages of others that are built into the page's modules and into the command, as cargo resolves them.

use std::{collections::BTreeSet, fmt, path::PathBuf};

use anyhow::{Context, Result, bail};
use serde_json::Value;

use crate::{
    process::{self, cargo},
    setup::WASM,
};

/// The roots of the page.
const PAGE: [&str; 2] = ["levalab-wasm", "levalab-export-wasm"];

/// The root of the command.
const COMMAND: &str = "levalab-cli";

/// Systems that the command is built for, by one target each.
const SYSTEMS: [&str; 3] = ["x86_64-unknown-linux-gnu", "x86_64-pc-windows-msvc", "aarch64-apple-darwin"];

/// Which builds of the command count; those of the page always do.
#[derive(Clone, Copy, PartialEq)]
pub enum Builds {
    /// The build of this system alone, whose packages are here when LevaLab was built.
    ThisSystem,
    /// The builds of every system.
    EverySystem,
}

/// A package, with what it says about its licence.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Package {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
    /// Its licences as an SPDX expression, or nearly one.
    pub expression: String,
    /// Its authors, which a package without a notice of its own is ascribed to.
    pub authors: Vec<String>,
    /// Where its files lie.
    pub folder: PathBuf,
}

impl fmt::Display for Package {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name, self.version)
    }
}

/// Every package that is linked in. Macros and build scripts run before and leave nothing of their own.
pub fn built_in(builds: Builds) -> Result<BTreeSet<Package>> {
    let mut linked = linked(&PAGE, WASM, builds)?;
    let host = host()?;
    match builds {
        Builds::ThisSystem => linked.extend(self::linked(&[COMMAND], &host, builds)?),
        Builds::EverySystem => {
            for system in SYSTEMS {
                linked.extend(self::linked(&[COMMAND], system, builds)?);
            }
        }
    }
    let mut found = BTreeSet::new();
    for package in described(builds, &host)?.as_array().context("cargo metadata lists no packages")? {
        let text = |key: &str| package[key].as_str().unwrap_or_default().to_owned();
        // Packages of LevaLab come from no registry.
        if package["source"].is_null() || !linked.remove(&(text("name"), text("version"))) {
            continue;
        }
        let manifest = PathBuf::from(text("manifest_path"));
        let authors = package["authors"].as_array().into_iter().flatten();
        found.insert(Package {
            name: text("name"),
            version: text("version"),
            expression: text("license"),
            authors: authors.filter_map(Value::as_str).map(str::to_owned).collect(),
            folder: manifest.parent().context("a manifest without a folder")?.to_path_buf(),
        });
    }
    linked.retain(|(name, _)| !name.starts_with("levalab-"));
    if let Some((name, version)) = linked.first() {
        bail!("cargo describes no {name} {version}");
    }
    Ok(found)
}

/// Name and version of everything linked into these packages.
fn linked(roots: &[&str], target: &str, builds: Builds) -> Result<BTreeSet<(String, String)>> {
    let mut tree =
        cargo(["tree", "--locked", "--edges=normal,no-proc-macro", "--prefix=none", "--format={p}", "--target"]);
    tree.arg(target).args(roots.iter().flat_map(|root| ["--package", root])).args(offline(builds));
    let printed = process::printed(&mut tree)?;
    let name_and_version = |line: &str| {
        let (name, rest) = line.split_once(" v")?;
        Some((name.to_owned(), rest.split(' ').next()?.to_owned()))
    };
    Ok(printed.lines().filter_map(name_and_version).collect())
}

/// What cargo knows of the packages.
fn described(builds: Builds, host: &str) -> Result<Value> {
    let mut metadata = cargo(["metadata", "--locked", "--format-version=1"]);
    if builds == Builds::ThisSystem {
        metadata.args(["--filter-platform", WASM, "--filter-platform", host]);
    }
    let printed = process::printed(metadata.args(offline(builds)))?;
    let metadata: Value = serde_json::from_str(&printed).context("cargo metadata gave no JSON")?;
    Ok(metadata["packages"].clone())
}

fn offline(builds: Builds) -> Option<&'static str> {
    (builds == Builds::ThisSystem).then_some("--offline")
}

/// The target of this system.
fn host() -> Result<String> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = process::output(&mut process::program(rustc, ["-vV"])).context("rustc did not run")?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(host.context("rustc names no host")?.to_owned())
}
