//! A term as it stands in the page of terms and in the cards of the question marks.

use crate::html::Pen;
use crate::pages::Assets;
use crate::words::terms::Term;
use crate::words::two;
use levalab_formula::escape;

/// The entry of a term: an article that the page of LevaLab takes over as it is.
#[must_use]
pub fn entry(pen: Pen, term: &Term, assets: &Assets) -> String {
    let within = |words: super::words::Two| words.within(pen.language);
    let symbol = if term.symbol.is_empty() {
        String::new()
    } else {
        format!("<span class=\"sign\">{}</span> ", pen.formula(term.symbol))
    };
    let mut rows = String::new();
    if !term.symbol.is_empty() || term.unit.en != "none" {
        rows += &format!("<dt>{}</dt><dd>{}</dd>", within(two("Unit", "Unidad")), pen.line(within(term.unit)));
    }
    if let Some(sign) = term.sign {
        rows += &format!("<dt>{}</dt><dd>{}</dd>", within(two("Sign", "Signo")), pen.line(within(sign)));
    }
    let rows = if rows.is_empty() { rows } else { format!("<dl>{rows}</dl>") };
    let formula = term.formula.map(|formula| pen.displayed(formula)).unwrap_or_default();
    let drawing = term.drawing.map(|(name, lit)| assets.drawing(name, lit)).unwrap_or_default();
    format!(
        "<article class=\"term\" id=\"{id}\"><h3><a href=\"#{id}\">{symbol}{name}</a></h3>{drawing}<p>{text}</p>{formula}{rows}\
         <p class=\"more\"><a href=\"{theory}.html#{anchor}\">{more}</a></p></article>\n",
        id = term.id,
        name = escape(within(term.name)),
        text = pen.line(within(term.text)),
        theory = pen.language.tag(),
        anchor = term.theory,
        more = within(two("In the theory", "En la teoría")),
    )
}
