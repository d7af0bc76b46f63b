//! What is wrong with a text that should be a number.

use crate::Language;
use levalab_numbers::NumberProblem;

/// Maximum number of characters of a typed text that a sentence repeats.
const MAX_REPEATED: usize = 24;

/// What is wrong with what was typed, and what is expected.
#[must_use]
pub fn number_problem(language: Language, typed: &str, problem: &NumberProblem) -> String {
    let text = abridged(typed);
    match language {
        Language::En => in_english(&text, problem),
        Language::Es => in_spanish(&text, problem),
    }
}

fn in_english(text: &str, problem: &NumberProblem) -> String {
    match problem {
        NumberProblem::Empty => "A number is missing here.".to_owned(),
        NumberProblem::TwoSigns => {
            format!("“{text}” has more than one decimal sign: write thousands without a separator.")
        }
        NumberProblem::Exponent => "After “e” the exponent is missing, as in 1.5e3.".to_owned(),
        NumberProblem::Huge => format!("“{text}” is too large."),
        NumberProblem::DivisionByZero => format!("“{text}” divides by zero."),
        NumberProblem::Ambiguous => {
            format!("“{text}” can be read in two ways: write a mixed number as 1 1/4, and thousands without a space.")
        }
        NumberProblem::Unreadable => format!("“{text}” is not a number: write one such as 12.5, −3, 1 1/4 or 22/7."),
        NumberProblem::UnknownUnit { found } => format!("“{}” is not a unit that is known here.", abridged(found)),
        NumberProblem::OtherUnit { found, expected } if expected.is_empty() => {
            format!("A number without a unit is expected here, not one in {}.", abridged(found))
        }
        NumberProblem::OtherUnit { found, expected } => {
            format!("A value in {expected} is expected here, and {} measures something else.", abridged(found))
        }
    }
}

fn in_spanish(text: &str, problem: &NumberProblem) -> String {
    match problem {
        NumberProblem::Empty => "Aquí falta un número.".to_owned(),
        NumberProblem::TwoSigns => {
            format!("«{text}» lleva más de un signo decimal: escriba los millares sin separador.")
        }
        NumberProblem::Exponent => "Tras la «e» falta el exponente, como en 1,5e3.".to_owned(),
        NumberProblem::Huge => format!("«{text}» es demasiado grande."),
        NumberProblem::DivisionByZero => format!("«{text}» divide por cero."),
        NumberProblem::Ambiguous => {
            format!(
                "«{text}» se puede leer de dos maneras: escriba un número mixto como 1 1/4, y los millares sin espacio."
            )
        }
        NumberProblem::Unreadable => format!("«{text}» no es un número: escriba uno como 12,5, −3, 1 1/4 o 22/7."),
        NumberProblem::UnknownUnit { found } => format!("«{}» no es una unidad que se conozca aquí.", abridged(found)),
        NumberProblem::OtherUnit { found, expected } if expected.is_empty() => {
            format!("Aquí va un número sin unidad, no uno en {}.", abridged(found))
        }
        NumberProblem::OtherUnit { found, expected } => {
            format!("Aquí va un valor en {expected}, y {} mide otra cosa.", abridged(found))
        }
    }
}

fn abridged(text: &str) -> String {
    let mut repeated: String = text.chars().take(MAX_REPEATED).collect();
    if text.chars().nth(MAX_REPEATED).is_some() {
        repeated.push('…');
    }
    repeated
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_numbers::read;

    fn told(text: &str, own: &str) -> [String; 2] {
        let problem = read(text, own).expect_err(text);
        Language::ALL.map(|language| number_problem(language, text, &problem))
    }

    #[test]
    fn every_refusal_names_the_text_or_what_is_expected() {
        let [en, es] = told("30 °", "mm");
        assert_eq!(en, "A value in mm is expected here, and ° measures something else.");
        assert_eq!(es, "Aquí va un valor en mm, y ° mide otra cosa.");
        let [en, es] = told("1.234,5", "mm");
        assert!(en.contains("“1.234,5” has more than one decimal sign"), "{en}");
        assert!(es.contains("«1.234,5» lleva más de un signo decimal"), "{es}");
        let [en, _] = told(&"x".repeat(100), "mm");
        assert!(en.contains(&format!("“{}…”", "x".repeat(24))), "{en}");
    }
}
