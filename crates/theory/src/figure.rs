//! The small diagrams of a law: s, v, a and j of a cam that uses it.

use crate::html::Pen;
use crate::law_facts::cam;
use crate::words::{Two, two};
use levalab_chart::{Diagram, Quantity, Style, Timing, colour, svg};
use levalab_core::law::Group;
use levalab_core::{Analysis, Law};
use levalab_formula::escape;

/// Colour and dash of each quantity on light paper, as the page has them; the style sheet puts the theme's in their place.
const LOOKS: [(Quantity, &str, &[f64], Two); 4] = [
    (Quantity::S, "#0068a4", &[], two("displacement", "desplazamiento")),
    (Quantity::V, "#00735a", &[9.0, 3.0], two("velocity", "velocidad")),
    (Quantity::A, "#b04300", &[4.0, 2.5], two("acceleration", "aceleración")),
    (Quantity::J, "#a03678", &[1.5, 2.5], two("jerk", "sobreaceleración")),
];

/// Rows of a curve: enough for a small drawing.
const ROWS: usize = 240;

/// Diagrams of a unit lift with this law; nothing for one that stays still or needs data.
#[must_use]
pub fn of(pen: Pen, law: &Law) -> String {
    let half = |name: &str| law.id.replace("start", name).replace("end", name);
    let (start, end) = (half("start"), half("end"));
    let rows = match law.group {
        Group::Half => vec![
            ("dwell", 60.0, 0.0),
            (&*start, 75.0, 0.5),
            (&*end, 75.0, 0.5),
            ("dwell", 60.0, 0.0),
            ("polynomial-3-4-5", 90.0, -1.0),
        ],
        _ => vec![("dwell", 60.0, 0.0), (law.id, 120.0, 1.0), ("dwell", 60.0, 0.0), (law.id, 120.0, -1.0)],
    };
    if law.is_dwell() {
        return String::new();
    }
    let Some(cam) = cam(&rows) else { return String::new() };
    let analysis = Analysis::of(&cam, ROWS);
    let drawings = LOOKS.map(|(quantity, tone, dash, name)| {
        let style = Style {
            width: 330.0,
            height: 112.0,
            curve: colour(tone).unwrap_or_default(),
            dash: dash.to_vec(),
            decimal_sign: pen.language.decimal_sign(),
            ..Style::default()
        };
        let (text, _) = svg(&Diagram::of(quantity, &cam, &analysis, Timing::PerRadian), &style);
        let letter = ["s", "v", "a", "j"][quantity as usize];
        let name = name.within(pen.language);
        let label = escape(&format!("{name} {letter} ({})", levalab_words::law(pen.language, law)));
        let text = text.replacen("<svg ", &format!("<svg role=\"img\" aria-label=\"{label}\" "), 1);
        format!("<div class=\"diagram {letter}\"><p><i>{letter}</i> {name}</p>{text}</div>")
    });
    let note = two(
        "Rise and return of a unit lift over 120° each, between dwells; derivatives per radian.",
        "Subida y retorno de una elevación unidad en 120° cada uno, entre detenimientos; derivadas por radián.",
    );
    let halves = two(
        "Both halves over 75° each, a dwell, and a 3-4-5 return; derivatives per radian.",
        "Las dos mitades en 75° cada una, un detenimiento y un retorno 3-4-5; derivadas por radián.",
    );
    let note = if law.group == Group::Half { halves } else { note };
    format!(
        "<figure class=\"diagrams\">{}<figcaption>{}</figcaption></figure>",
        drawings.concat(),
        note.within(pen.language)
    )
}
