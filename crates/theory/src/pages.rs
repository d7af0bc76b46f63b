//! The pages of a language: theory, terms, manual, licences.

use crate::html::{Labels, Page, Pen, section};
use crate::words::concepts::{Concept, GEOMETRY, KINDS, MOTION};
use crate::words::manual::SCREENS;
use crate::words::terms::{GROUPS, Term};
use crate::words::{Two, two};
use crate::{followers, laws, licences, notations, terms};
use levalab_catalogue::{APPLICATIONS, FINDINGS, Name};
use levalab_core::{FOLLOWERS, LAWS};
use levalab_words::Language;
use std::collections::BTreeMap;

/// What the pages take from the page of LevaLab, so that neither labels nor drawings are made twice.
#[derive(Clone, Debug, Default)]
pub struct Assets {
    /// Labels of controls by language tag.
    pub labels: BTreeMap<String, Labels>,
    /// Drawings as SVG, by name.
    pub drawings: BTreeMap<String, String>,
}

const THEORY: Two = two("Theory", "Teoría");
const TERMS: Two = two("Terms and signs", "Términos y signos");
const MANUAL: Two = two("Manual", "Manual");

/// Name of the page's file: theory is the entrance.
fn file(page: Two, language: Language) -> String {
    let tag = language.tag();
    match page.en {
        "Theory" => format!("{tag}.html"),
        "Manual" => format!("manual-{tag}.html"),
        "Third-party licences" => format!("licences-{tag}.html"),
        _ => format!("terms-{tag}.html"),
    }
}

/// Every page: name of its file, and the file.
#[must_use]
pub fn pages(assets: &Assets) -> Vec<(String, String)> {
    let none = Labels::new();
    let in_language = |language: Language| {
        let pen = Pen { language, labels: assets.labels.get(language.tag()).unwrap_or(&none) };
        [
            whole(pen, THEORY, ABOUT_THEORY, theory(pen, assets)),
            whole(pen, TERMS, ABOUT_TERMS, glossary(pen, assets)),
            whole(pen, MANUAL, ABOUT_MANUAL, manual(pen)),
            whole(pen, licences::NAME, licences::ABOUT, notices(pen)),
        ]
    };
    Language::ALL.into_iter().flat_map(in_language).collect()
}

const ABOUT_THEORY: Two = two(
    "Motion laws, followers and profiles of plate cams, with their formulas.",
    "Leyes de movimiento, seguidores y perfiles de las levas de placa, con sus fórmulas.",
);
const ABOUT_TERMS: Two = two(
    "Every magnitude of a plate cam: symbol, unit, sign and definition.",
    "Cada magnitud de una leva de placa: símbolo, unidad, signo y definición.",
);
const ABOUT_MANUAL: Two = two("How to use LevaLab, part by part.", "Cómo se usa LevaLab, parte por parte.");

/// A list of contents and what it leads to.
struct Body {
    places: Vec<(String, Vec<(String, String)>)>,
    html: String,
}

fn whole(pen: Pen, page: Two, about: Two, body: Body) -> (String, String) {
    let language = pen.language;
    let other = if language == Language::En { Language::Es } else { Language::En };
    let sisters = [MANUAL, THEORY, TERMS].map(|sister| (file(sister, language), sister.within(language)));
    let written = Page {
        file: file(page, language),
        language,
        title: page.within(language),
        about: about.within(language),
        sisters: sisters.to_vec(),
        other: (file(page, other), if other == Language::Es { "Español" } else { "English" }),
        home: two("Back to the cam", "Volver a la leva").within(language),
        contents: two("Contents", "Índice").within(language),
        places: body.places,
        body: body.html,
    };
    (file(page, language), written.html())
}

fn theory(pen: Pen, assets: &Assets) -> Body {
    let language = pen.language;
    let mut places = Vec::new();
    let mut html = format!("<p class=\"lead\">{}</p>", pen.line(ABOUT_THEORY.within(language)));
    let mut chapter = |name: Two, entries: Vec<(String, String, String)>, before: String, id: &str| {
        let name = name.within(language);
        places.push((name.to_owned(), entries.iter().map(|(id, name, _)| (id.clone(), name.clone())).collect()));
        let sections: String = entries.iter().map(|(id, name, body)| section(3, id, name, body)).collect();
        html.push_str(&section(2, id, name, &(before + &sections)));
    };
    let told = |concepts: &[Concept]| concepts.iter().map(|concept| tell(pen, concept, assets)).collect::<Vec<_>>();
    chapter(two("Motion", "Movimiento"), told(MOTION), String::new(), "motion");
    let entries = LAWS.iter().map(|law| laws::entry(pen, law)).collect();
    chapter(two("Motion laws", "Leyes de movimiento"), entries, laws::overview(pen), "laws");
    chapter(
        two("From the motion to the profile", "Del movimiento al perfil"),
        told(GEOMETRY),
        String::new(),
        "profile",
    );
    let entries = FOLLOWERS.iter().map(|kind| followers::entry(pen, kind, assets)).collect();
    chapter(two("Followers", "Seguidores"), entries, String::new(), "followers");
    chapter(two("Other kinds of cam", "Otras clases de leva"), told(KINDS), String::new(), "kinds");
    let entry = |what: &str, id: &str, name: &Name, idea: Two, source: Option<&str>| {
        let body = pen.paragraphs(idea.within(language)) + &pen.source(source);
        (format!("{what}-{id}"), name.menu.within(language).to_owned(), body)
    };
    let entries =
        APPLICATIONS.iter().map(|row| entry("application", row.id, &row.name, row.idea, row.source)).collect();
    chapter(two("Applications", "Aplicaciones"), entries, String::new(), "applications");
    let entries = FINDINGS.iter().map(|row| entry("finding", row.id, &row.name, row.idea, row.source)).collect();
    chapter(two("What a verdict finds", "Lo que observa un veredicto"), entries, String::new(), "findings");
    Body { places, html }
}

/// A concept: its place, its name, its text.
fn tell(pen: Pen, concept: &Concept, assets: &Assets) -> (String, String, String) {
    let drawing = concept.drawing.map(|name| assets.drawing(name, "")).unwrap_or_default();
    let text = pen.paragraphs(concept.text.within(pen.language));
    (concept.id.to_owned(), concept.name.within(pen.language).to_owned(), drawing + &text)
}

fn glossary(pen: Pen, assets: &Assets) -> Body {
    let mut places = Vec::new();
    let mut html = format!("<p class=\"lead\">{}</p>", pen.line(ABOUT_TERMS.within(pen.language)));
    for group in GROUPS {
        let name = group.name.within(pen.language);
        let terms: Vec<&Term> = group.terms.iter().collect();
        let entries = terms.iter().map(|term| (term.id.to_owned(), term.name.within(pen.language).to_owned()));
        places.push((name.to_owned(), entries.collect()));
        let entries: String = terms.into_iter().map(|term| terms::entry(pen, term, assets)).collect();
        html += &format!("<h2>{name}</h2>{entries}");
    }
    let name = two("Notations", "Notaciones").within(pen.language);
    places.push((String::new(), vec![("notations".to_owned(), name.to_owned())]));
    html += &section(2, "notations", name, &notations::table(pen));
    Body { places, html }
}

fn manual(pen: Pen) -> Body {
    let places = SCREENS.iter().map(|screen| (screen.id.to_owned(), screen.name.within(pen.language).to_owned()));
    let places = vec![(String::new(), places.collect())];
    let html = SCREENS.iter().map(|screen| {
        let text = pen.paragraphs(screen.text.within(pen.language));
        section(2, screen.id, screen.name.within(pen.language), &text)
    });
    Body { places, html: html.collect() }
}

fn notices(pen: Pen) -> Body {
    let (places, html) = licences::body(pen.language);
    Body { places: vec![(String::new(), places)], html }
}

impl Assets {
    /// A drawing with one of its parts lit; nothing when there is none of that name.
    #[must_use]
    pub fn drawing(&self, name: &str, lit: &str) -> String {
        let Some(drawing) = self.drawings.get(name) else { return String::new() };
        let part = format!("data-parameter=\"{lit}\" class=\"");
        let drawing = if lit.is_empty() { drawing.clone() } else { drawing.replace(&part, &format!("{part}lit ")) };
        format!("<figure class=\"drawing\">{drawing}</figure>")
    }
}
