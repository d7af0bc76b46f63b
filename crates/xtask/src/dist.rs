//! The page packed into `dist/`: static files with relative addresses, for any web server and any path.
//!
//! All but `index.html` lies in a folder named by its content, so files of two releases never meet in a browser's cache.

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, bail, ensure};
use serde_json::json;
use walkdir::WalkDir;

use crate::{
    html::{self, Kind, Load},
    offline::{self, Release},
    page::{self, Page},
    poster::Poster,
    process::{self, told},
    project, setup, single,
    size::{Size, kilobytes},
    theory,
    wasm::{self, Build},
};

/// What everything on the main screen may weigh in one language, gzip: it arrives in 2.5 s at 1.6 Mbit/s.
const FIRST_LOAD_GOAL: usize = 360_000;

/// Names of formats, which programs compare but never visit: those of the web, and those of the parts of a workbook.
const NAMESPACES: [&str; 4] = [
    "http://www.w3.org/",
    "http://schemas.openxmlformats.org/",
    "http://schemas.microsoft.com/",
    "http://purl.org/dc/",
];

/// Packs the page and prints what it weighs.
pub fn run() -> Result<()> {
    pack()?;
    Ok(())
}

/// Packs the page and prints what it weighs; gives the folder with everything but `index.html`.
pub fn pack() -> Result<PathBuf> {
    setup::node_modules()?;
    wasm::build(Build::Shipped)?;
    theory::build()?;
    let packed = told("packing dist", write)?;
    forbid_other_hosts(&project::path("dist"))?;
    print_sizes(&packed)?;
    Ok(packed.folder)
}

/// What was packed.
struct Packed {
    folder: PathBuf,
    /// Files a first visit loads, relative to `dist/`.
    first: Vec<String>,
}

fn write() -> Result<Packed> {
    let dist = project::path("dist");
    if dist.exists() {
        fs::remove_dir_all(&dist).context("dist")?;
    }
    let fresh = dist.join("new");
    fs::create_dir_all(&fresh)?;
    let html = fs::read_to_string(project::path("index.html")).context("index.html")?;
    let loads = html::loads(&html);
    let whole = project::target()?.join("single");
    bundle(&fresh, &whole, &loads)?;
    let poster = Poster::draw(&loads)?;
    add_styles(&fresh.join("style.css"), &poster.styles)?;
    copy_others(&fresh)?;
    let hash = content_hash(&fresh)?;
    let folder = dist.join(&hash);
    fs::rename(&fresh, &folder)?;
    theory::publish(&folder, &dist, &hash)?;
    let page = Page::new(&hash, &loads, &poster);
    fs::write(dist.join("index.html"), html::packed_as(&poster.fill(&page.rewrite(&html))?, "site"))?;
    let page_files = names(&dist)?;
    let single = single::Parts {
        html: &html,
        loads: &loads,
        poster: &poster,
        scripts: &whole,
        packed: &folder,
        theory: &dist.join("theory"),
    };
    fs::write(dist.join(single::FILE), single.page()?).context(single::FILE)?;
    write_workers(&dist, &hash, &page_files)?;
    Ok(Packed { folder, first: page.first() })
}

/// Writes what keeps the page, and what keeps the single file.
fn write_workers(dist: &Path, folder: &str, page_files: &[String]) -> Result<()> {
    let page = Release { worker: offline::WORKER, folder, page: "index.html", files: page_files };
    page.write_worker(dist)?;
    let file = [single::FILE.to_owned()];
    let single = Release { worker: offline::SINGLE_WORKER, folder: "", page: single::FILE, files: &file };
    single.write_worker(dist)
}

/// Joins and minifies scripts and styles.
fn bundle(out: &Path, single: &Path, loads: &[Load]) -> Result<()> {
    let of_kind = |kind: Kind| loads.iter().filter(move |load| load.kind == kind).map(|load| load.file.as_str());
    let styles = loads.iter().filter_map(|load| match &load.kind {
        Kind::Style(media) => Some(json!({ "file": load.file, "media": media })),
        _ => None,
    });
    let order = json!({
        "out": out,
        "single": single,
        "main": of_kind(Kind::Module).next().context("index.html names no module")?,
        "named": page::WORDS,
        "glues": wasm::MODULES.map(glue),
        "scripts": of_kind(Kind::Script).collect::<Vec<_>>(),
        "styles": styles.collect::<Vec<_>>(),
        "sheets": theory::SHEETS,
    });
    process::run(&mut process::node(["crates/xtask/src/bundle.js", &order.to_string()]))
}

/// The generated JavaScript of a module, for the bundler.
fn glue(module: wasm::Module) -> serde_json::Value {
    json!({ "name": module.stem(), "file": format!("web/pkg/{}", module.glue()), "inline": module.inline })
}

fn add_styles(sheet: &Path, rules: &str) -> Result<()> {
    let styles = fs::read_to_string(sheet).with_context(|| sheet.display().to_string())?;
    fs::write(sheet, format!("{}{rules}\n", styles.trim_end()))?;
    Ok(())
}

/// The module's parts, icons and the like keep the place they have under `web/`.
fn copy_others(fresh: &Path) -> Result<()> {
    let web = project::path("web");
    for entry in WalkDir::new(&web) {
        let entry = entry?;
        let relative = entry.path().strip_prefix(&web)?;
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        let joined = entry
            .path()
            .extension()
            .is_none_or(|extension| ["js", "ts", "css", "md"].iter().any(|other| extension == *other));
        if entry.file_type().is_file() && !hidden && !joined {
            let place = fresh.join(relative);
            fs::create_dir_all(place.parent().unwrap_or(fresh))?;
            fs::copy(entry.path(), &place).with_context(|| place.display().to_string())?;
        }
    }
    let module = fresh.join("pkg").join(wasm::PAGE.file());
    ensure!(module.is_file(), "{} is missing", module.display());
    Ok(())
}

fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in WalkDir::new(folder).sort_by_file_name() {
        let entry = entry?;
        if entry.file_type().is_file() {
            files.push(entry.into_path());
        }
    }
    Ok(files)
}

/// Files by the name that a browser asks for, relative to the folder.
fn names(folder: &Path) -> Result<Vec<String>> {
    let name = |file: PathBuf| Ok(file.strip_prefix(folder)?.to_string_lossy().replace('\\', "/"));
    files(folder)?.into_iter().map(name).collect()
}

/// Eight hexadecimal digits over all names and contents.
fn content_hash(folder: &Path) -> Result<String> {
    let mut checksum = flate2::Crc::new();
    for file in files(folder)? {
        checksum.update(file.strip_prefix(folder)?.to_string_lossy().as_bytes());
        checksum.update(&fs::read(&file)?);
    }
    Ok(format!("{:08x}", checksum.sum()))
}

/// Nothing shipped may name another host; the texts of licences may, as words that lead nowhere.
fn forbid_other_hosts(dist: &Path) -> Result<()> {
    let mut found = Vec::new();
    for file in files(dist)? {
        let text = String::from_utf8_lossy(&fs::read(&file)?).into_owned();
        let addresses = ["http://", "https://", "\"//", "'//", "ws://", "wss://"]
            .iter()
            .flat_map(|scheme| text.match_indices(scheme));
        let quoted = file.file_name().is_some_and(|name| name.to_string_lossy().starts_with("licences-"));
        let leads = |at: usize| text[..at].ends_with(['"', '\'', '=']);
        let addresses = addresses.filter(|&(at, _)| !quoted || leads(at));
        let addresses = addresses.map(|(at, _)| text[at..].chars().take(60).collect::<String>());
        let foreign = addresses.filter(|address| !NAMESPACES.iter().any(|name| address.starts_with(name)));
        found.extend(foreign.map(|address| format!("{}: {address}", file.display())));
    }
    if !found.is_empty() {
        bail!("addresses of other hosts in shipped files:\n{}", found.join("\n"));
    }
    Ok(())
}

fn print_sizes(packed: &Packed) -> Result<()> {
    let dist = project::path("dist");
    let mut total = Size::default();
    println!("{:<44} {:>10} {:>10}", "first load", "raw", "gzip");
    for name in &packed.first {
        let size = Size::of(&dist.join(name))?;
        total = total.plus(size);
        print_size(name, size);
    }
    print_size("together", total);
    for name in names(&dist)? {
        if !packed.first.contains(&name) {
            let when = match name.as_str() {
                offline::WORKER => "once drawn",
                single::FILE | offline::SINGLE_WORKER => "instead of all",
                _ => "on demand",
            };
            print_size(&format!("{when}: {name}"), Size::of(&dist.join(&name))?);
        }
    }
    let verdict = if total.gzip <= FIRST_LOAD_GOAL { "kept" } else { "MISSED" };
    println!("goal: {} gzip, {verdict}", kilobytes(FIRST_LOAD_GOAL));
    Ok(())
}

fn print_size(name: &str, size: Size) {
    println!("{name:<44} {:>10} {:>10}", kilobytes(size.raw), kilobytes(size.gzip));
}
