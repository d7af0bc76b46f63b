//! `index.html` as it is packed: it points into the folder named by content, and asks early for all it will need.

use std::path::Path;

use crate::{
    html::{self, Kind, Load},
    wasm,
};

/// The module's JavaScript, relative to the packed folder.
const GLUE: &str = "pkg/levalab_wasm.js";

/// The packed page.
pub struct Page<'a> {
    folder: &'a str,
    loads: &'a [Load],
    parts: &'a [String],
}

impl<'a> Page<'a> {
    /// `folder` beside it holds everything else; `parts` are the scripts that its modules import at once.
    pub fn new(folder: &'a str, loads: &'a [Load], parts: &'a [String]) -> Page<'a> {
        Page { folder, loads, parts }
    }

    /// `index.html` with the addresses of the packed files.
    pub fn rewrite(&self, html: &str) -> String {
        let mut styled = false;
        html::rewrite(html, self.loads, |load| match load.kind {
            Kind::Style(_) if styled => String::new(),
            Kind::Style(_) => {
                styled = true;
                format!("<link rel=\"stylesheet\" href=\"{}\">", self.packed("style.css"))
            }
            Kind::Script => format!("<script src=\"{}\"></script>", self.script(load)),
            Kind::Module => self.module(load),
            Kind::Hint => String::new(),
            Kind::Page => load.tag.replace("web/", ""),
            Kind::Other => load.tag.replace(&load.file, &self.other(load)),
        })
    }

    /// Everything that a first visit loads.
    pub fn first(&self) -> Vec<String> {
        let mut first = vec!["index.html".to_owned(), self.packed("style.css")];
        first.extend(self.loads.iter().filter_map(|load| match load.kind {
            Kind::Script | Kind::Module => Some(self.script(load)),
            Kind::Other => Some(self.other(load)),
            Kind::Style(_) | Kind::Hint | Kind::Page => None,
        }));
        first.extend(self.early());
        first.push(self.module_file());
        first
    }

    /// The script, and hints to fetch all it needs at the same time, not one after the other.
    fn module(&self, load: &Load) -> String {
        let wasm = self.module_file();
        let mut tags =
            vec![format!("<link rel=\"preload\" href=\"{wasm}\" as=\"fetch\" type=\"application/wasm\" crossorigin>")];
        tags.extend(self.early().map(|part| format!("<link rel=\"modulepreload\" href=\"{part}\">")));
        tags.push(format!("<script type=\"module\" src=\"{}\"></script>", self.script(load)));
        tags.join("\n    ")
    }

    /// Scripts that `index.html` does not name but its modules need at once.
    fn early(&self) -> impl Iterator<Item = String> {
        let parts = self.parts.iter().map(String::as_str);
        parts.chain([GLUE]).map(|part| self.packed(part))
    }

    /// The part of the module that the first picture needs.
    fn module_file(&self) -> String {
        self.packed(&format!("pkg/{}", wasm::FIRST))
    }

    fn packed(&self, file: &str) -> String {
        format!("{}/{file}", self.folder)
    }

    /// Scripts lie flat in the packed folder.
    fn script(&self, load: &Load) -> String {
        let name = Path::new(&load.file).file_name().unwrap_or_default();
        self.packed(&name.to_string_lossy())
    }

    /// Other files keep the place they have under `web/`.
    fn other(&self, load: &Load) -> String {
        self.packed(load.file.trim_start_matches("web/"))
    }
}
