//! The symbols of other books beside ours, from the one table that everything speaks from.

use crate::html::Pen;
use crate::words::two;
use levalab_formula::escape;
use levalab_words::SIGNS;

/// The magnitudes of the table: those whose symbols differ in some notation come from the table itself.
const ALWAYS: [&str; 6] = ["θ", "β", "L", "R_b", "φ", "ρ"];

/// The table of notations, a column each, and their sources.
#[must_use]
pub fn table(pen: Pen) -> String {
    let within = |words: crate::words::Two| words.within(pen.language);
    let mut magnitudes: Vec<&str> = ALWAYS.to_vec();
    for (ours, _) in SIGNS.iter().flat_map(|signs| signs.symbols) {
        if !magnitudes.contains(ours) {
            magnitudes.push(ours);
        }
    }
    let heads: String = SIGNS.iter().map(|signs| format!("<th scope=\"col\">{}</th>", signs.notation.word())).collect();
    let row = |ours: &&str| {
        let cells: String = SIGNS.iter().map(|signs| format!("<td>{}</td>", symbol(signs.symbol(ours)))).collect();
        format!("<tr>{cells}</tr>")
    };
    let rows: String = magnitudes.iter().map(row).collect();
    let sources: String = SIGNS[1..]
        .iter()
        .map(|signs| format!("<li><b>{}</b>: {}</li>", signs.notation.word(), escape(signs.source)))
        .collect();
    let about = within(two(
        "File → Notation… tells a design in the symbols of another book; what is kept stays the same. Norton's ε is positive on the side where it makes φ smaller in the rise: it is shown and typed with the other sign when the cam turns clockwise. In the rest the signs are ours. The table is written from knowledge of the books, not compared with copies of them; what is in doubt is left as ours.",
        "Archivo → Notación… expresa un diseño con los símbolos de otro libro; lo que se guarda no cambia. La ε de Norton es positiva hacia el lado en que reduce φ en la subida: se muestra y se escribe con el otro signo cuando la leva gira en sentido horario. En lo demás los signos son los nuestros. La tabla está escrita de lo que se sabe de los libros, sin cotejarla con ejemplares; lo dudoso queda como lo nuestro.",
    ));
    format!(
        "<p>{}</p><div class=\"wide\"><table><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table></div><ul>{sources}</ul>",
        escape(about)
    )
}

fn symbol(sign: &str) -> String {
    match sign.split_once('_') {
        Some((letter, index)) => format!("<i>{}</i><sub>{}</sub>", escape(letter), escape(index)),
        None => format!("<i>{}</i>", escape(sign)),
    }
}
