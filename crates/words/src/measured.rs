//! What is wrong with measured data, and what was made of them.

use crate::Language;
use levalab_format::measured::{Curve, MeasuredProblem};

/// Why measured data are not read.
#[must_use]
pub fn measured_problem(language: Language, problem: &MeasuredProblem) -> String {
    let exact = |value: usize| language.exact(value as f64);
    let angle = |value: f64| language.angle_exact(value);
    match (problem, language) {
        (MeasuredProblem::TooLarge { limit }, Language::En) => {
            format!("The text has more than {} bytes: leave out lines that are not needed.", exact(*limit))
        }
        (MeasuredProblem::TooLarge { limit }, Language::Es) => {
            format!("El texto pasa de {} bytes: quite las líneas que no hagan falta.", exact(*limit))
        }
        (MeasuredProblem::NotNumbers { line }, Language::En) => {
            format!("Line {line} is not two numbers, as in 12.5 and 3.25.")
        }
        (MeasuredProblem::NotNumbers { line }, Language::Es) => {
            format!("En la línea {line} no hay dos números, como 12,5 y 3,25.")
        }
        (MeasuredProblem::NoValue { line, column }, Language::En) => {
            format!("Line {line} has no number in column {column}.")
        }
        (MeasuredProblem::NoValue { line, column }, Language::Es) => {
            format!("La línea {line} no tiene ningún número en la columna {column}.")
        }
        (MeasuredProblem::Unordered { line, found, before }, Language::En) => {
            format!(
                "In line {line} the angle is {}, and {} comes before it: angles must increase.",
                angle(*found),
                angle(*before)
            )
        }
        (MeasuredProblem::Unordered { line, found, before }, Language::Es) => {
            format!(
                "En la línea {line} el ángulo es {} y antes viene {}: los ángulos deben crecer.",
                angle(*found),
                angle(*before)
            )
        }
        (MeasuredProblem::TooManyPoints { found, limit }, Language::En) => {
            format!("There are {} points; there is room for {}.", exact(*found), exact(*limit))
        }
        (MeasuredProblem::TooManyPoints { found, limit }, Language::Es) => {
            format!("Hay {} puntos y no caben más de {}.", exact(*found), exact(*limit))
        }
        (MeasuredProblem::TooFewPoints { found }, Language::En) => {
            format!("A table needs two points or more, and the text has {found}.")
        }
        (MeasuredProblem::TooFewPoints { found }, Language::Es) => {
            format!("Una tabla necesita dos puntos o más y el texto tiene {found}.")
        }
        (MeasuredProblem::Columns, Language::En) => "Choose two different columns for θ and s.".to_owned(),
        (MeasuredProblem::Columns, Language::Es) => "Elija dos columnas distintas para θ y s.".to_owned(),
    }
}

/// What was done to the points of a curve so that they make a table; nothing when it was nothing.
#[must_use]
pub fn measured_note(language: Language, curve: &Curve) -> String {
    let mut notes = Vec::new();
    if curve.is_in_radians {
        notes.push(match language {
            Language::En => "The angles were in radians and are now in degrees.".to_owned(),
            Language::Es => "Los ángulos venían en radianes y ahora están en grados.".to_owned(),
        });
    }
    if curve.is_completed {
        notes.push(match language {
            Language::En => "The end of the turn was missing: it is the first point once more.".to_owned(),
            Language::Es => "Faltaba el final de la vuelta: es otra vez el primer punto.".to_owned(),
        });
    }
    if curve.first != 0.0 {
        let first = language.angle_exact(curve.first);
        notes.push(match language {
            Language::En => format!("θ counts from the first point, measured at {first}."),
            Language::Es => format!("θ cuenta desde el primer punto, medido en {first}."),
        });
    }
    notes.join(" ")
}
