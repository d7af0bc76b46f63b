//! The service worker of the packed page: it keeps all that was packed, for use without the network.

use std::{fs, path::Path};

use anyhow::{Context, Result};
use serde_json::json;

/// Its file, beside `index.html`: it answers for the folder it lies in.
pub const WORKER: &str = "worker.js";

/// Writes the worker for these files, relative to `dist`; `folder` is named by the content of those in it.
pub fn write_worker(dist: &Path, folder: &str, release: &str, files: &[String]) -> Result<()> {
    let kept: Vec<_> = files.iter().map(|file| if file == "index.html" { "" } else { file }).collect();
    let packed = json!({ "release": release, "folder": format!("{folder}/"), "files": kept });
    let worker = format!("globalThis.packed = {packed};\n{}", include_str!("worker.js"));
    fs::write(dist.join(WORKER), worker).context(WORKER)
}
