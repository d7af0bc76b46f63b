//! The pages of theory, terms and manual: written into `web/theory/` by the crate `theory`, with labels and drawings of the page.

use std::{fs, io::Write, path::Path, process::Stdio};

use anyhow::{Context, Result, ensure};
use base64::{Engine, engine::general_purpose::STANDARD as BASE64};

use crate::{
    process::{self, cargo},
    size::gzip,
};

/// Style sheets that these pages, and the cards that show parts of them, load by name.
pub const SHEETS: [&str; 3] = ["web/styles/theory.css", "web/styles/help.css", "web/styles/exports.css"];

/// The pages, without their ending.
const PAGES: [&str; 8] = ["en", "es", "terms-en", "terms-es", "manual-en", "manual-es", "licences-en", "licences-es"];

/// Brings `web/theory/` up to date.
pub fn build() -> Result<()> {
    let followers = process::printed(&mut writer("followers"))?;
    let assets = process::printed(&mut process::node(["crates/theory/assets/assets.js", &followers]))?;
    let mut writing = writer("web/theory").stdin(Stdio::piped()).spawn().context("cargo did not start")?;
    writing.stdin.take().context("no standard input")?.write_all(assets.as_bytes())?;
    ensure!(writing.wait()?.success(), "the pages of theory were not written");
    Ok(())
}

fn writer(argument: &str) -> std::process::Command {
    cargo(["run", "--quiet", "--package", "levalab-theory", "--", argument])
}

/// Moves the pages out of the packed folder to an address that stays the same from release to release.
pub fn publish(folder: &Path, dist: &Path, hash: &str) -> Result<()> {
    let (from, to) = (folder.join("theory"), dist.join("theory"));
    fs::create_dir_all(&to)?;
    for entry in fs::read_dir(&from).context("web/theory")? {
        let entry = entry?;
        let page = fs::read_to_string(entry.path())?;
        let packed = ["styles/", "icon.svg", "early.js"]
            .into_iter()
            .fold(page, |page, file| page.replace(&format!("\"../{file}"), &format!("\"../{hash}/{file}")));
        fs::write(to.join(entry.file_name()), packed.replace("\"../../index.html\"", "\"../index.html\""))?;
    }
    fs::remove_dir_all(from).context("theory")
}

/// The pages for the single file, each packed in a script of its own that does not run.
pub fn packed(theory: &Path) -> Result<String> {
    let mut scripts = String::new();
    for name in PAGES {
        let page = fs::read(theory.join(format!("{name}.html"))).with_context(|| format!("the page {name}"))?;
        let packed = BASE64.encode(gzip(&page)?);
        scripts += &format!("<script type=\"text/html;gzip;base64\" id=\"page-{name}\">{packed}</script>\n  ");
    }
    Ok(scripts)
}
