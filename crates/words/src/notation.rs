//! The one table of whose symbols are whose: for each magnitude that a book writes otherwise than we do, its symbol there.
//!
//! Only what is known of a book is in it; what it writes as we do, or what we do not know, stays ours. Its sources and what is left open are
//! told in `docs/notation.md`, which a test holds to this table.

use levalab_format::Notation;

/// The symbols of a notation.
#[derive(Debug)]
pub struct Signs {
    /// Whose.
    pub notation: Notation,
    /// The book and its edition, or what it is.
    pub source: &'static str,
    /// Our symbol and its own, an index after `_`.
    pub symbols: &'static [(&'static str, &'static str)],
}

/// What is written in sentences, where single letters would be words; an eccentricity is told as `e = 5`.
const IN_SENTENCES: [&str; 6] = ["R_b", "R_f", "R_p", "φ", "ρ", "e"];

/// Every notation, in the order of [`Notation::ALL`].
pub const SIGNS: [Signs; 6] = [
    Signs { notation: Notation::LevaLab, source: "LevaLab", symbols: &[] },
    Signs {
        notation: Notation::Norton,
        source: "R. L. Norton, Cam Design and Manufacturing Handbook, 2nd ed., 2009; Design of Machinery",
        symbols: &[("L", "h"), ("e", "ε"), ("ρ_p", "ρ_pitch")],
    },
    Signs {
        notation: Notation::Shigley,
        source: "J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms, 4th ed., 2011",
        symbols: &[
            ("s", "y"),
            ("v", "y'"),
            ("a", "y''"),
            ("j", "y'''"),
            ("V", "ẏ"),
            ("A", "ÿ"),
            ("J", "y⃛"),
            ("R_b", "R_0"),
            ("R_f", "R_r"),
            ("e", "ε"),
        ],
    },
    Signs {
        notation: Notation::Rothbart,
        source: "H. A. Rothbart (ed.), Cam Design Handbook, 2004",
        symbols: &[
            ("s", "y"),
            ("v", "y'"),
            ("a", "y''"),
            ("j", "y'''"),
            ("V", "ẏ"),
            ("A", "ÿ"),
            ("J", "y⃛"),
            ("L", "h"),
            ("R_b", "r_b"),
            ("R_f", "R_r"),
            ("φ", "α"),
        ],
    },
    Signs {
        notation: Notation::CardonaClos,
        source: "S. Cardona, D. Clos, Teoría de máquinas, Edicions UPC, 2001",
        symbols: &[("s", "d"), ("v", "d'"), ("a", "d''"), ("j", "d'''"), ("V", "ḋ"), ("A", "d̈"), ("J", "d⃛")],
    },
    Signs {
        notation: Notation::Capitals,
        source: "θ, β, S, V, A, J",
        symbols: &[("s", "S"), ("v", "V"), ("a", "A"), ("j", "J"), ("V", "Ṡ"), ("A", "S̈"), ("J", "S⃛")],
    },
];

impl Signs {
    /// Those of a notation.
    #[must_use]
    pub fn of(notation: Notation) -> &'static Self {
        &SIGNS[notation as usize]
    }

    /// The symbol that stands for one of ours.
    #[must_use]
    pub fn symbol<'a>(&self, ours: &'a str) -> &'a str {
        self.symbols.iter().find(|(known, _)| *known == ours).map_or(ours, |&(_, theirs)| theirs)
    }

    /// The same on a line of plain text, where an index follows its letter.
    #[must_use]
    pub fn plain(&self, ours: &str) -> String {
        self.symbol(ours).replace('_', "")
    }

    /// A sentence of ours with the symbols of this notation.
    #[must_use]
    pub fn say(&self, text: &str) -> String {
        if self.symbols.is_empty() {
            return text.to_owned();
        }
        let changed = |ours: &&&str| self.symbol(ours) != **ours;
        let known: Vec<(String, String)> =
            IN_SENTENCES.iter().filter(changed).map(|ours| (ours.replace('_', ""), self.plain(ours))).collect();
        let mut said = String::with_capacity(text.len());
        let mut rest = text;
        while let Some(next) = rest.chars().next() {
            let alone = !said.chars().next_back().is_some_and(char::is_alphanumeric);
            let found = known.iter().find(|(ours, _)| alone && stands_for_itself(rest, ours));
            let step = match found {
                Some((ours, theirs)) => {
                    said.push_str(theirs);
                    ours.len()
                }
                None => {
                    said.push(next);
                    next.len_utf8()
                }
            };
            rest = &rest[step..];
        }
        said
    }
}

/// True when a text begins with a symbol that is no part of a word. The letter e is a word of Spanish: it is a symbol before an equals
/// sign or a bound.
fn stands_for_itself(text: &str, symbol: &str) -> bool {
    let Some(after) = text.strip_prefix(symbol) else { return false };
    match symbol {
        "e" => after.trim_start().starts_with(['=', '≥', '≤']),
        _ => !after.starts_with(char::is_alphanumeric),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_order_of_the_notations_and_says_nothing_twice() {
        for (notation, signs) in Notation::ALL.into_iter().zip(&SIGNS) {
            assert_eq!(notation, signs.notation);
            for (k, (ours, theirs)) in signs.symbols.iter().enumerate() {
                assert_ne!(ours, theirs);
                assert!(
                    signs.symbols[..k].iter().all(|other| other.0 != *ours && other.1 != *theirs),
                    "{notation:?} {ours}"
                );
            }
        }
    }

    #[test]
    fn sentences_change_their_symbols_and_nothing_else() {
        let shigley = Signs::of(Notation::Shigley);
        assert_eq!(shigley.say("With Rb ≥ 43.3 mm it stays below."), "With R0 ≥ 43.3 mm it stays below.");
        assert_eq!(
            shigley.say("e = 5, e incluso, Rbx, 2·Rb; excentricidad e = 3"),
            "ε = 5, e incluso, Rbx, 2·R0; excentricidad ε = 3"
        );
        assert_eq!(Signs::of(Notation::Rothbart).say("|φ| ≤ 30°, ρ min"), "|α| ≤ 30°, ρ min");
        assert_eq!(Signs::of(Notation::LevaLab).say("Rb and φ"), "Rb and φ");
    }

    #[test]
    fn the_documented_table_is_this_one() {
        let page = include_str!("../../../docs/notation.md");
        for signs in &SIGNS {
            assert!(
                page.contains(&format!("`{}`", signs.notation.word())) && page.contains(signs.source),
                "{:?}",
                signs.notation
            );
        }
        for ours in ["s", "v", "a", "j", "V", "A", "J", "θ", "β", "L", "R_b", "R_f", "R_p", "e", "φ", "ρ", "ρ_p"] {
            let cells = SIGNS.each_ref().map(|signs| format!(" {} |", signs.symbol(ours)));
            let row = format!("|{}", cells.concat());
            assert!(page.contains(&row), "docs/notation.md lacks the row\n{row}");
        }
    }
}
