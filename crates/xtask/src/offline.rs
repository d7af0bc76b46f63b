//! The service workers, which keep for use without the network what was packed: one the page with all its files, the other the
//! page in a single file.

use std::{fs, path::Path};

use anyhow::{Context, Result};
use base64::{Engine, engine::general_purpose::STANDARD as BASE64};
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

/// The worker of the page, beside `index.html`: it answers for the folder it lies in.
pub const WORKER: &str = "worker.js";

/// The worker of the single file, beside it: it answers for that one address, and no visitor of the page loads it.
pub const SINGLE_WORKER: &str = "levalab-worker.js";

/// A release as a worker keeps it.
pub struct Release<'a> {
    /// File of the worker in `dist`.
    pub worker: &'a str,
    /// The folder in `dist` that is named by the content of the files in it; empty when there is none.
    pub folder: &'a str,
    /// The file that answers at the worker's own scope.
    pub page: &'a str,
    /// Files relative to `dist`, the page among them.
    pub files: &'a [String],
}

impl Release<'_> {
    /// Writes the worker, with the digest of every file: what a browser receives in its place is not kept.
    pub fn write_worker(&self, dist: &Path) -> Result<()> {
        let mut digests = Map::new();
        let mut whole = Sha256::new();
        for file in self.files {
            let bytes = fs::read(dist.join(file)).with_context(|| file.clone())?;
            let digest = format!("sha256-{}", BASE64.encode(Sha256::digest(bytes)));
            let address = if file == self.page { "" } else { file };
            whole.update(format!("{address} {digest}\n"));
            digests.insert(address.to_owned(), Value::String(digest));
        }
        let release: String = whole.finalize().iter().take(4).map(|byte| format!("{byte:02x}")).collect();
        let folder = if self.folder.is_empty() { String::new() } else { format!("{}/", self.folder) };
        let packed = json!({ "release": release, "folder": folder, "files": digests });
        let worker = format!("globalThis.packed = {packed};\n{}", include_str!("worker.js"));
        fs::write(dist.join(self.worker), worker).with_context(|| self.worker.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_worker_names_its_page_by_its_scope_and_every_file_by_its_digest() {
        let dist = std::env::temp_dir().join(format!("levalab-offline-{}", std::process::id()));
        fs::create_dir_all(&dist).expect("a folder");
        for (file, text) in [("index.html", ""), ("a.js", "abc")] {
            fs::write(dist.join(file), text).expect("a file");
        }
        let files = ["index.html", "a.js"].map(str::to_owned);
        let release = Release { worker: WORKER, folder: "f", page: "index.html", files: &files };
        release.write_worker(&dist).expect("a worker");
        let worker = fs::read_to_string(dist.join(WORKER)).expect("the worker");
        fs::remove_dir_all(&dist).expect("the folder");
        let list = worker.lines().next().expect("the list").trim_start_matches("globalThis.packed = ");
        let packed: Value = serde_json::from_str(list.trim_end_matches(';')).expect("JSON");
        assert_eq!(packed["folder"], "f/");
        assert_eq!(packed["files"][""], "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
        assert_eq!(packed["files"]["a.js"], "sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
    }
}
