//! Where things are in the checkout, whatever folder the command was started from.

use std::{
    env,
    path::{Path, PathBuf},
    sync::OnceLock,
};

use anyhow::{Context, Result};

use crate::process;

/// The folder that holds the workspace's `Cargo.toml`.
pub fn root() -> &'static Path {
    static ROOT: OnceLock<PathBuf> = OnceLock::new();
    ROOT.get_or_init(|| {
        // Cargo sets the variable when it runs us; the compiled-in value serves a binary started by hand.
        let manifest = env::var("CARGO_MANIFEST_DIR").unwrap_or_else(|_| env!("CARGO_MANIFEST_DIR").into());
        let manifest = Path::new(&manifest);
        manifest.ancestors().nth(2).unwrap_or(manifest).to_path_buf()
    })
}

/// A path inside the checkout.
pub fn path(relative: &str) -> PathBuf {
    root().join(relative)
}

/// Cargo's build folder, as cargo itself resolves it from files and environment.
pub fn target() -> Result<PathBuf> {
    let mut metadata = process::cargo(["metadata", "--no-deps", "--format-version=1", "--offline"]);
    let output = metadata.output().context("cargo metadata did not start")?;
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).context("cargo metadata gave no JSON")?;
    let folder = metadata["target_directory"].as_str().context("cargo metadata names no target_directory")?;
    Ok(folder.into())
}

/// A tool that npm installed, as a script to give to Node.
pub fn npm_tool(relative: &str) -> PathBuf {
    path("node_modules").join(relative)
}
