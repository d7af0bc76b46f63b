//! A law's section of the theory: everything but its words comes from its own curve.

use crate::figure;
use crate::html::Pen;
use crate::law_facts::LawFacts;
use crate::words::{Two, two};
use levalab_catalogue::{LawRow, law_row};
use levalab_core::{LAWS, Law};
use levalab_formula::curve::{ORDERS, Written, written};
use levalab_formula::escape;

/// Place, name and body.
#[must_use]
pub fn entry(pen: Pen, law: &Law) -> (String, String, String) {
    (law.id.to_owned(), name(pen, law), body(pen, law))
}

/// Its name at the head of a line.
fn name(pen: Pen, law: &Law) -> String {
    levalab_words::capital(levalab_words::law_alone(pen.language, law))
}

fn body(pen: Pen, entry: &Law) -> String {
    let words = law_row(entry);
    let study = LawFacts::of(entry);
    let paragraph = |text: fn(&LawRow) -> Two| {
        words.map(|words| pen.paragraphs(text(words).within(pen.language))).unwrap_or_default()
    };
    let general: String =
        words.map(|words| words.formulas).unwrap_or_default().iter().map(|formula| pen.displayed(formula)).collect();
    let own = study.as_ref().filter(|_| general.is_empty()).and_then(|study| written(&study.pieces));
    let formulas = own.map_or(general, |own| tables(pen, &own));
    let facts = study.as_ref().filter(|study| study.moves()).map(|study| facts(pen, study)).unwrap_or_default();
    let source = words.map(|words| pen.source(words.source)).unwrap_or_default();
    [paragraph(|words| words.idea), formulas, figure::of(pen, entry), facts, paragraph(|words| words.advice), source]
        .concat()
}

/// y and its derivatives, a table for each piece.
fn tables(pen: Pen, own: &Written) -> String {
    let factor = own.factor.as_ref().map(|factor| pen.displayed(&format!("C_a = {factor}"))).unwrap_or_default();
    let whole = own.pieces.len() == 1;
    let piece = |piece: &levalab_formula::curve::WrittenPiece| {
        let span = if whole { String::new() } else { format!("<p class=\"span\">{}</p>", pen.formula(&piece.span)) };
        let orders: String =
            ORDERS.iter().zip(&piece.orders).map(|(left, right)| pen.displayed(&format!("{left} = {right}"))).collect();
        format!("<div class=\"piece\">{span}{orders}</div>")
    };
    format!("{factor}<div class=\"pieces\">{}</div>", own.pieces.iter().map(piece).collect::<String>())
}

/// Peaks, and what jumps between two dwells.
fn facts(pen: Pen, study: &LawFacts) -> String {
    let peaks: Vec<String> = (1..4).map(|order| peak(pen, study, order)).collect();
    let peaks = format!("<p>{}: {}.</p>", two("Peaks", "Valores máximos").within(pen.language), peaks.join(", "));
    format!("{peaks}<p>{}</p>", pen.line(&joins(pen, study)))
}

fn peak(pen: Pen, study: &LawFacts, order: usize) -> String {
    format!("{} = {}", pen.formula(&format!("|{}|", ORDERS[order])), pen.language.number(study.peaks[order]))
}

/// What a law does beside rests, in a sentence.
fn joins(pen: Pen, study: &LawFacts) -> String {
    let worst = (0..4).find(|&order| !study.jumps[order].is_empty());
    let Some(order) = worst else {
        return two(
            "Between dwells nothing jumps up to the jerk: it serves at any speed.",
            "Entre detenimientos nada salta hasta la sobreaceleración: sirve a cualquier velocidad.",
        )
        .within(pen.language)
        .to_owned();
    };
    let places: Vec<String> = study.jumps[order]
        .iter()
        .map(|(x, by)| format!("{} ({})", pen.language.number(*x), pen.language.number(*by)))
        .collect();
    let places = places.join(", ");
    let symbol = ORDERS[order];
    let verdict = match order {
        3 => two("it serves at low speeds", "sirve a bajas velocidades"),
        2 => two("it is not acceptable there", "allí no es aceptable"),
        _ => two("it must never stand there", "nunca debe ponerse allí"),
    };
    match pen.language {
        levalab_words::Language::En => format!("Between dwells ${symbol}$ jumps at $x$ = {places}: {}.", verdict.en),
        levalab_words::Language::Es => {
            format!("Entre detenimientos ${symbol}$ salta en $x$ = {places}: {}.", verdict.es)
        }
    }
}

/// All laws between two rests side by side.
#[must_use]
pub fn overview(pen: Pen) -> String {
    let within = |words: Two| words.within(pen.language);
    let studies = LAWS.iter().filter_map(|law| Some((law, LawFacts::of(law)?))).filter(|(_, study)| study.moves());
    let rows: String = studies
        .map(|(law, study)| {
            let name = escape(&name(pen, law));
            let peaks: String =
                (1..4).map(|order| format!("<td>{}</td>", pen.language.number(study.peaks[order]))).collect();
            let jumps = (0..4).find(|&order| !study.jumps[order].is_empty());
            let jumps = jumps.map_or_else(|| "–".to_owned(), |order| pen.formula(ORDERS[order]));
            format!("<tr><th scope=\"row\"><a href=\"#{}\">{name}</a></th>{peaks}<td>{jumps}</td></tr>", law.id)
        })
        .collect();
    let head = |(order, name): (usize, Two)| {
        format!("<th scope=\"col\">{} {}</th>", within(name), pen.formula(&format!("|{}|", ORDERS[order])))
    };
    let names = [two("velocity", "velocidad"), two("acceleration", "aceleración"), two("jerk", "sobreaceleración")];
    let heads: String = (1..).zip(names).map(head).collect();
    format!(
        "{}<div class=\"wide\"><table><caption>{}</caption><thead><tr><th scope=\"col\">{}</th>{heads}<th scope=\"col\">{}</th></tr></thead><tbody>{rows}</tbody></table></div>",
        pen.paragraphs(within(INTRODUCTION)),
        within(two(
            "Peaks of a unit rise, and the first derivative that jumps between dwells",
            "Máximos de una subida unidad, y la primera derivada que salta entre detenimientos"
        )),
        within(two("Law", "Ley")),
        within(two("Jumps", "Salta")),
    )
}

const INTRODUCTION: Two = two(
    "A law is a curve $y(x)$ from (0, 0) to (1, 1); stretched to $β$ and $L$ it is a segment. The formulas below are printed from the very curves that LevaLab computes with, and the peaks are those of the core. A return uses the same curve with $L < 0$.",
    "Una ley es una curva $y(x)$ de (0, 0) a (1, 1); estirada a $β$ y $L$ es un tramo. Las fórmulas que siguen se imprimen a partir de las mismas curvas con las que calcula LevaLab, y los máximos son los del núcleo de cálculo. Un retorno usa la misma curva con $L < 0$.",
);
