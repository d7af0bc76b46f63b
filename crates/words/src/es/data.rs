//! What is wrong with the data of a free law, in Spanish.

use super::ES;
use crate::voice::{measured, row};
use levalab_core::{ExpressionFault, ExpressionProblem, RoughnessCause};
use levalab_format::{DataRefusal, quoted};

pub(super) fn refusal(refusal: &DataRefusal) -> String {
    match refusal {
        DataRefusal::WrongOrder { found } => {
            format!("El orden tiene que ser 0 para s, 1 para v, 2 para a o 3 para j, y es {}.", ES.exact(*found))
        }
        DataRefusal::WrongCount { found: 0, min, .. } => {
            format!("La lista está vacía; necesita {min} como mínimo.")
        }
        DataRefusal::WrongCount { found, min, max } => {
            format!("La lista tiene {found}; tiene que haber de {min} a {max}.")
        }
        DataRefusal::Repeated { other } => {
            format!("La condición {} ya dice este valor en este sitio.", other + 1)
        }
        DataRefusal::NoHeight => {
            "Ninguna condición dice una altura s, así que la curva podría estar a cualquiera: dé s en algún sitio."
                .to_owned()
        }
        DataRefusal::Dependent { items } if items.len() < 2 => {
            let item = items.first().map_or(1, |item| item + 1);
            format!(
                "Un polinomio con tan pocas condiciones no tiene esa derivada: añada condiciones, o quite la número {item}."
            )
        }
        DataRefusal::Dependent { items } => {
            let named: Vec<String> = items.iter().map(|item| (item + 1).to_string()).collect();
            format!(
                "Ningún polinomio único las cumple todas: las condiciones {} dependen unas de otras, valgan lo que valgan. Mueva o cambie alguna.",
                row(&named, "y")
            )
        }
        DataRefusal::KnotCount { found, expected: 0 } => {
            format!("Con tan pocas condiciones la spline es un solo polinomio y no tiene nudos, y se dan {found}.")
        }
        DataRefusal::KnotCount { found, expected } => {
            format!("Hay {found} nudos; estas condiciones y este grado necesitan {expected}.")
        }
        DataRefusal::KnotOrder => {
            "Los nudos tienen que estar dentro del tramo, cada uno después del anterior.".to_owned()
        }
        DataRefusal::KnotPlace { item, from, to, measure } => {
            let [from, to] = [from, to].map(|value| measured(*value, *measure, ES));
            format!(
                "Con estos nudos la condición {} tendría que estar entre {from} y {to}: ponga más nudos donde haya más condiciones.",
                item + 1
            )
        }
        DataRefusal::NotAtEnd { found, expected, measure } => {
            let [found, expected] = [found, expected].map(|value| measured(*value, *measure, ES));
            format!(
                "La tabla tiene que empezar y acabar con su tramo: este punto está en {found} y debería estar en {expected}."
            )
        }
        DataRefusal::Unordered => "El punto no viene después del anterior.".to_owned(),
        DataRefusal::Expression(problem) => expression(problem),
        DataRefusal::Undefined { x, cause } => {
            let x = ES.number(*x);
            match cause {
                RoughnessCause::Power => format!(
                    "La fórmula no es suave hasta la tercera derivada cerca de x = {x}: contiene una raíz, o una potencia fraccionaria menor que 3, de algo que allí se anula. Reúna las potencias de una misma base en una sola de exponente 3 o mayor, como x^3,5."
                ),
                RoughnessCause::Division => {
                    format!(
                        "La fórmula divide entre cero cerca de x = {x}: simplifique la fracción, o saque del tramo el cero del divisor."
                    )
                }
                RoughnessCause::TooLarge => format!(
                    "Un valor intermedio de la fórmula es demasiado grande para calcular con él cerca de x = {x}: un escalón brusco se escribe con tanh, como L(1+tanh(500(x-0,5)))/2."
                ),
                RoughnessCause::Edge => format!(
                    "La fórmula no es suave hasta la tercera derivada cerca de x = {x}, en el borde del dominio de una de sus funciones."
                ),
            }
        }
        DataRefusal::RiseDisagrees { found, expected, measure } => {
            let [found, expected] = [found, expected].map(|value| measured(*value, *measure, ES));
            format!(
                "Los datos del tramo lo hacen subir {expected} y no {found}: quite la subida, o corrija una de las dos cosas."
            )
        }
    }
}

/// Los caracteres se cuentan desde 1.
fn expression(ExpressionProblem { at, kind }: &ExpressionProblem) -> String {
    let at = at + 1;
    match kind {
        ExpressionFault::Ends => {
            format!("Falta un número, una variable o un paréntesis en el carácter {at}, donde acaba la fórmula.")
        }
        ExpressionFault::TooLong { limit } => {
            format!("La fórmula es demasiado larga: no caben más de {limit} caracteres.")
        }
        ExpressionFault::TooDeep => format!("Demasiados paréntesis o signos unos dentro de otros en el carácter {at}."),
        ExpressionFault::Unexpected(c) => {
            format!("{} no tiene sentido aquí, en el carácter {at}.", quoted(&c.to_string()))
        }
        ExpressionFault::Unknown(name) => format!(
            "{} en el carácter {at} no se conoce: hay x, θ, β, L, s₀, π, e, y funciones como sin (o sen), cos, exp, ln, sqrt.",
            quoted(name)
        ),
        ExpressionFault::Open => format!("El paréntesis del carácter {at} no se cierra."),
        ExpressionFault::NoArgument(name) => {
            format!("{name} en el carácter {at} necesita su argumento entre paréntesis, como en {name}(x).")
        }
        ExpressionFault::Number => format!("El número del carácter {at} no se puede leer."),
    }
}
