//! Lists as scripts of the page: what its forms are built from, the names of laws, followers and kinds of cam, and the examples
//! library (designs from `examples/`, words from `crates/words/examples.json`).

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::{
    process::{self, cargo},
    project,
};

/// What to look at in each, in every language.
const NOTES: &str = "crates/words/examples.json";

/// Writes `catalogue.js`, `names.en.js`, `names.es.js` and `examples.js` into the folder of generated files, when they have changed.
pub fn write(folder: &Path) -> Result<()> {
    let examples = serde_json::to_string(&library()?)?;
    let examples =
        format!("/** Made from examples/: change the files there. */\nexport const EXAMPLES = {examples};\n");
    write_script(&folder.join("examples.js"), &examples)?;
    let mut lists = cargo(["run", "--quiet", "--package", "levalab-format", "--example", "catalogue"]);
    let printed = process::printed(&mut lists)?;
    let (lists, names) = printed.split_once('\n').context("the catalogue is two lines")?;
    let names: BTreeMap<&str, BTreeMap<&str, &str>> = serde_json::from_str(names).context("the names")?;
    for (language, names) in names {
        let names = serde_json::to_string(&names)?;
        let of = "@type {Record<string, string>}";
        let names = format!("/** Made from crates/catalogue. {of} */\nexport const names = {names};\n");
        write_script(&folder.join(format!("names.{language}.js")), &names)?;
    }
    let of = "@type {import(\"../types.d.ts\").Catalogue}";
    let lists = format!(
        "/** Made from the lists of crates/core and crates/format. {of} */\nexport const CATALOGUE = {lists};\n"
    );
    write_script(&folder.join("catalogue.js"), &lists)
}

fn write_script(place: &Path, script: &str) -> Result<()> {
    if fs::read_to_string(place).is_ok_and(|found| found == script) {
        return Ok(());
    }
    fs::create_dir_all(place.parent().unwrap_or(place)).context("web/pkg")?;
    fs::write(place, script).with_context(|| place.display().to_string())
}

/// The entries in the order of the notes: id, group, design, and title and note in each language.
fn library() -> Result<Vec<Value>> {
    let folder = project::path("examples");
    let read = |name: String| fs::read_to_string(folder.join(&name)).with_context(|| format!("examples/{name}"));
    let notes = fs::read_to_string(project::path(NOTES)).context(NOTES)?;
    let notes: Vec<Value> = serde_json::from_str(&notes).context(NOTES)?;
    let designs = fs::read_dir(&folder)?
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().ends_with(".lev.json"))
        .count();
    ensure!(designs == notes.len(), "examples/ has {designs} designs, and {NOTES} tells of {}", notes.len());
    let entry = |mut entry: Value| {
        let id = entry["id"].as_str().context("an entry of the notes has no id")?.to_owned();
        entry["design"] = serde_json::from_str(&read(format!("{id}.lev.json"))?).with_context(|| id.clone())?;
        Ok(entry)
    };
    notes.into_iter().map(entry).collect()
}
