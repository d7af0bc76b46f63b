//! The notices of everything that is built into the page, as a page of its own.

use crate::html::section;
use crate::words::{Two, two};
use levalab_formula::escape;
use levalab_words::Language;

/// What `cargo xtask licences` wrote: after a head, for each text a heading, the works that are under it, and the text.
const NOTICES: &str = include_str!("../../../LICENSE-THIRD-PARTY.txt");

pub const NAME: Two = two("Third-party licences", "Licencias de terceros");
pub const ABOUT: Two = two(
    "Works of others that are built into LevaLab, and the licences under which they are.",
    "Obras de terceros incluidas en LevaLab y las licencias bajo las que se distribuyen.",
);

const LEAD: Two = two(
    "LevaLab is under the MIT License. The page, the page in a single file and the command have the works of others built in that are \
     listed here, each under the licence it stands under. Where a work is offered under several licences, this is the one it is used under.",
    "LevaLab se distribuye bajo la licencia MIT. La página, la página de un solo archivo y el programa de la línea de órdenes incluyen las obras de terceros que \
     aquí se enumeran, cada una bajo la licencia que la encabeza. Si una obra se ofrece bajo varias licencias, se usa bajo esta. Los \
     textos legales se reproducen en su idioma original.",
);

/// The places and the text of the page.
pub fn body(language: Language) -> (Vec<(String, String)>, String) {
    let mut places = Vec::new();
    let mut html = format!("<p class=\"lead\">{}</p>", escape(LEAD.within(language)));
    for (at, notice) in NOTICES.split("\n## ").skip(1).enumerate() {
        let (name, rest) = notice.split_once("\n\n").unwrap_or((notice, ""));
        let (works, text) = rest.split_once("\n\n").unwrap_or((rest, ""));
        let id = format!("licence-{}", at + 1);
        places.push((id.clone(), name.to_owned()));
        // Names and texts are English wherever they are read.
        let works: String = works.split("* ").skip(1).map(work).collect();
        let content =
            format!("<div lang=\"en\"><ul class=\"works\">{works}</ul><pre>{}</pre></div>", escape(text.trim()));
        html += &section(2, &id, name, &content);
    }
    (places, html)
}

/// A work, and below it whose it is.
fn work(text: &str) -> String {
    let mut lines = text.lines().map(|line| escape(line.trim()));
    let name = lines.next().unwrap_or_default();
    let holders: String = lines.filter(|line| !line.is_empty()).map(|line| format!("<br>{line}")).collect();
    format!("<li><b>{name}</b>{holders}</li>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_work_and_every_text_is_on_the_page_in_either_language() {
        let lines = NOTICES.lines().filter_map(|line| line.strip_prefix("* "));
        let works: Vec<&str> = lines.collect();
        assert!(works.len() > 100, "only {} works", works.len());
        for language in Language::ALL {
            let (places, html) = body(language);
            assert_eq!(places.len(), NOTICES.matches("\n## ").count());
            for work in &works {
                assert!(html.contains(&format!("<li><b>{}</b>", escape(work))), "{work}");
            }
            for words in
                ["Permission is hereby granted, free of charge", "END OF TERMS AND CONDITIONS", "UBUNTU FONT LICENCE"]
            {
                assert!(html.contains(words), "{words}");
            }
        }
    }
}
