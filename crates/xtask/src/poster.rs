//! The first picture: the opening design as the packed page shows it before any script of it has run.

use std::{collections::BTreeMap, process::Stdio};

use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::{
    html::{Kind, Load},
    process,
};

/// What `poster.js` draws.
#[derive(Deserialize)]
pub struct Poster {
    /// What fills each section of the page, by its id.
    sections: BTreeMap<String, Section>,
    /// The style rules that belong to it.
    pub styles: String,
    /// What an address or a store may hold without another picture being meant, by language.
    known: Value,
}

#[derive(Deserialize)]
struct Section {
    html: String,
    attributes: String,
}

impl Poster {
    /// Draws it with the page's modules and the module in `web/pkg/`.
    pub fn draw(loads: &[Load]) -> Result<Poster> {
        let sheets = loads.iter().filter(|load| load.kind == Kind::Style(String::new()));
        let sheets: Vec<_> = sheets.map(|load| load.file.as_str()).collect();
        let mut command = process::node(["crates/xtask/poster/poster.js", &json!(sheets).to_string()]);
        let output = command.stderr(Stdio::inherit()).output().context("node did not start")?;
        ensure!(output.status.success(), "the first picture could not be drawn");
        serde_json::from_slice(&output.stdout).context("poster.js printed no picture")
    }

    /// `index.html` with the picture in its sections.
    pub fn fill(&self, html: &str) -> Result<String> {
        let mut filled = html.to_owned();
        for (id, Section { html, attributes }) in &self.sections {
            let empty = format!("id=\"{id}\"></");
            ensure!(filled.matches(&empty).count() == 1, "index.html has no empty #{id}");
            filled = filled.replacen(&empty, &format!("id=\"{id}\"{attributes}>{html}</"), 1);
        }
        Ok(filled)
    }

    /// The attribute by which the script that runs before the first paint knows the picture.
    pub fn known(&self) -> String {
        format!(" data-known='{}'", self.known.to_string().replace('&', "&amp;").replace('\'', "&#39;"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn poster(known: Value) -> Poster {
        let section = Section { html: "<p data-poster>s</p>".into(), attributes: " data-level=\"bad\"".into() };
        Poster { sections: BTreeMap::from([("verdict".into(), section)]), styles: String::new(), known }
    }

    #[test]
    fn a_section_is_filled_and_must_be_there() {
        let filled = poster(Value::Null).fill("<section id=\"verdict\"></section>").unwrap();
        assert_eq!(filled, "<section id=\"verdict\" data-level=\"bad\"><p data-poster>s</p></section>");
        assert!(poster(Value::Null).fill("<section id=\"other\"></section>").is_err());
    }

    #[test]
    fn what_is_known_is_quoted() {
        assert_eq!(poster(json!({ "en": ["a&b'c"] })).known(), r#" data-known='{"en":["a&amp;b&#39;c"]}'"#);
    }
}
