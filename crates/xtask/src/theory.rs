//! The pages of theory, terms and manual: written into `web/theory/` by the crate `theory`, with labels and drawings of the page.

use std::{fs, io::Write, path::Path, process::Stdio};

use anyhow::{Context, Result, ensure};

use crate::process::{self, cargo};

/// Style sheets that these pages, and the cards that show parts of them, load by name.
pub const SHEETS: [&str; 3] = ["web/styles/theory.css", "web/styles/help.css", "web/styles/exports.css"];

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

/// The terms of a language as a template for the single-file page, whose question marks can load nothing.
pub fn terms(theory: &Path, language: &str) -> Result<String> {
    let page = fs::read_to_string(theory.join(format!("terms-{language}.html"))).context("the page of terms")?;
    let (_, rest) = page.split_once("<main>").context("the page of terms has no <main>")?;
    let (main, _) = rest.split_once("</main>").context("the <main> of the page of terms has no end")?;
    Ok(format!("<template id=\"terms-{language}\">{main}</template>\n  "))
}
