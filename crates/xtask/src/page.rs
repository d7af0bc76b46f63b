//! `index.html` as it is packed: it points into the folder named by content, and asks early for all it will need.

use std::path::Path;

use crate::{
    html::{self, Kind, Load},
    poster::Poster,
    wasm,
};

/// The words that every visit needs: a module a language, of which a visit loads one.
pub const WORDS: [&str; 2] = ["web/strings/page.en.js", "web/strings/page.es.js"];

/// Their names without the language.
const ANY_WORDS: &str = "page";

/// The packed page.
pub struct Page<'a> {
    folder: &'a str,
    loads: &'a [Load],
    poster: &'a Poster,
}

impl<'a> Page<'a> {
    /// `folder` beside it holds everything else.
    pub fn new(folder: &'a str, loads: &'a [Load], poster: &'a Poster) -> Page<'a> {
        Page { folder, loads, poster }
    }

    /// `index.html` with the addresses of the packed files.
    pub fn rewrite(&self, html: &str) -> String {
        let mut styled = false;
        html::rewrite(html, self.loads, |load| match load.kind {
            Kind::Style(_) if styled => String::new(),
            Kind::Style(_) => {
                styled = true;
                let sheet = format!("<link rel=\"stylesheet\" href=\"{}\">", self.packed("style.css"));
                // What takes longest is asked for first.
                [self.hints(), sheet].join("\n    ")
            }
            // It is the first to know the language, so it asks for the words.
            Kind::Script => {
                let (script, words, known) = (self.script(load), self.packed(ANY_WORDS), self.poster.known());
                format!("<script src=\"{script}\" data-words=\"{words}\"{known}></script>")
            }
            Kind::Module => format!("<script type=\"module\" src=\"{}\"></script>", self.script(load)),
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
        first.extend([self.glue(), self.packed(&format!("{ANY_WORDS}.es.js")), self.module_file()]);
        first
    }

    /// Hints to fetch the module at once, not when the script asks for it. The script itself has none: its tag is found early enough, and all
    /// that is fetched at the same time as the style sheet delays the first paint.
    fn hints(&self) -> String {
        format!(
            "<link rel=\"preload\" href=\"{}\" as=\"fetch\" type=\"application/wasm\" crossorigin>\n    \
             <link rel=\"modulepreload\" href=\"{}\">",
            self.module_file(),
            self.glue()
        )
    }

    /// The JavaScript of that module.
    fn glue(&self) -> String {
        self.packed(&format!("pkg/{}", wasm::PAGE.glue()))
    }

    /// The module of the main screen.
    fn module_file(&self) -> String {
        self.packed(&format!("pkg/{}", wasm::PAGE.file()))
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
