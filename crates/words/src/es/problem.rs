//! What is wrong with a design, in Spanish.

use super::{ES, data};
use crate::voice::{measured, row_of};
use levalab_core::Misfit;
use levalab_format::{CamRefusal, EditRefusal, JsonFault, Kind, Measure, Problem, ProgramRefusal, quoted};

pub(super) fn problem(problem: &Problem) -> String {
    match problem {
        Problem::FileTooLarge { limit, .. } => {
            format!("El archivo tiene más de {} bytes, y ningún diseño los tiene.", ES.exact(*limit as f64))
        }
        Problem::NotText => "El archivo no es texto en UTF-8.".to_owned(),
        Problem::NotJson { line, column, fault } => not_json(*line, *column, *fault),
        Problem::NotFinite => "El número es demasiado grande.".to_owned(),
        Problem::WrongKind { found, expected } => {
            format!("Aquí tiene que haber {}, y hay {}.", kind(*expected), kind(*found))
        }
        Problem::DecimalComma { found } => {
            format!("{} es un texto; un número va sin comillas y con punto decimal, como 1.5.", quoted(found))
        }
        Problem::Missing => "Falta este campo.".to_owned(),
        Problem::UnknownField { expected } => {
            format!("Este campo no significa nada aquí; los que valen son {}.", row_of(expected, "y"))
        }
        Problem::DuplicateField => "Este campo está dos veces.".to_owned(),
        Problem::WrongWord { found, expected } => match expected.as_slice() {
            [only] => format!("{} no se conoce; aquí solo vale {only}.", quoted(found)),
            _ => format!("{} no es ninguna de las opciones: {}.", quoted(found), expected.join(", ")),
        },
        Problem::NewerFormat { found } => {
            format!("El archivo es {}, hecho con una versión más nueva de LevaLab.", quoted(found))
        }
        Problem::OutOfRange { found, min, max, measure } => {
            let [found, min, max] = [found, min, max].map(|value| measured(*value, *measure, ES));
            format!("{found} está fuera de rango: tiene que ser de {min} a {max}.")
        }
        Problem::NotBetween { found, min, max, measure } => {
            let [found, min, max] = [found, min, max].map(|value| measured(*value, *measure, ES));
            format!("{found} está fuera de rango: tiene que ser mayor que {min} y menor que {max}.")
        }
        Problem::NotPositive { found, measure } => {
            format!("Tiene que ser mayor que cero, y es {}.", measured(*found, *measure, ES))
        }
        Problem::TitleTooLong { found, limit } => {
            format!("El título tiene {found} caracteres y no caben más de {limit}.")
        }
        Problem::TitleCharacter { found, position } => {
            format!("El carácter {position} del título (U+{:04X}) no se puede ver.", u32::from(*found))
        }
        Problem::TitleInvisible => "Del título no se ve nada: déjelo vacío o póngale alguna letra.".to_owned(),
        Problem::OneOf { expected } => format!("Solo se puede dar uno de estos campos: {}.", row_of(expected, "y")),
        Problem::Program(refusal) => program(*refusal),
        Problem::Data(refusal) => data::refusal(refusal),
        Problem::Join(problem) => crate::join::problem(ES, *problem),
        Problem::Misfit(problem) => misfit(*problem),
        Problem::Cam(refusal) => cam(*refusal),
        Problem::Edit(refusal) => edit(*refusal),
        Problem::NoAssignment { found } => {
            format!(
                "{} no es ningún cambio; lo es una ruta, un signo igual y un valor, como cam.base_radius=36.",
                quoted(found)
            )
        }
        Problem::NoIndex { found } => {
            format!("Un lugar de una lista es un número entero, 0 el primero, y este es {}.", ES.exact(*found))
        }
    }
}

/// Text that is not JSON.
fn not_json(line: usize, column: usize, fault: JsonFault) -> String {
    match fault {
        JsonFault::Syntax => format!("El texto deja de ser JSON en la línea {line}, columna {column}."),
        JsonFault::End => format!("El texto acaba a mitad del diseño, en la línea {line}, columna {column}."),
        JsonFault::DecimalComma => {
            format!(
                "Hay una coma decimal en la línea {line}, columna {column}; JSON usa el punto decimal, como en 1.5."
            )
        }
        JsonFault::Surrogate => {
            format!("Hay medio carácter en la línea {line}, columna {column}: la mitad de un par sustituto.")
        }
        JsonFault::Depth => format!(
            "Hay más niveles de listas y objetos que en cualquier diseño, en la línea {line}, columna {column}."
        ),
    }
}

/// Segments that make no program.
fn program(refusal: ProgramRefusal) -> String {
    match refusal {
        ProgramRefusal::NoSegments => "No hay tramos, y hace falta al menos uno.".to_owned(),
        ProgramRefusal::TooManySegments { found, limit } => format!("Hay {found} tramos y no caben más de {limit}."),
        ProgramRefusal::TooManyPoints { found, limit } => {
            format!("Las tablas tienen {found} puntos en total y no caben más de {limit}.")
        }
        ProgramRefusal::DwellRises { found, measure } => {
            format!("Un detenimiento no puede subir, y este sube {}.", measured(found, measure, ES))
        }
        ProgramRefusal::AdjacentPolynomials { next } => {
            format!(
                "Toma de sus vecinos las condiciones en los extremos, y el tramo {} también: no pueden ir seguidos.",
                next + 1
            )
        }
        ProgramRefusal::Turn { found, whole, measure } => {
            let missing = whole - found;
            let (sum, difference) = (measured(found, measure, ES), measured(missing.abs(), measure, ES));
            let rest = match (missing > 0.0, missing.abs() == 1.0) {
                (true, true) => "falta",
                (true, false) => "faltan",
                (false, true) => "sobra",
                (false, false) => "sobran",
            };
            let cycle = match (measure, whole < 360.0) {
                (Measure::Degrees, false) => "una vuelta completa".to_owned(),
                (Measure::Degrees, true) => "media vuelta, que su imagen completa".to_owned(),
                _ => format!("una carrera de {}", ES.exact(whole)),
            };
            format!("Los tramos suman {sum}: {rest} {difference} para {cycle}.")
        }
        ProgramRefusal::Closing { found, measure } => {
            let height = measured(found, measure, ES);
            format!("Las subidas y bajadas suman {height}; tienen que sumar 0 para que la vuelta acabe donde empieza.")
        }
        ProgramRefusal::Beginning { found, measure } => {
            let height = measured(found, measure, ES);
            format!(
                "El primer tramo empieza en {height}; tiene que empezar en 0, sobre la circunferencia base: réstele {height}."
            )
        }
        ProgramRefusal::BelowBase { found, measure } => {
            format!("El seguidor acabaría en {}, por debajo de la circunferencia base.", measured(found, measure, ES))
        }
    }
}

/// Lengths that do not go together.
fn misfit(misfit: Misfit) -> String {
    match misfit {
        Misfit::Eccentricity { eccentricity, prime_radius } => {
            let (e, radius) = (ES.exact(eccentricity), ES.exact(prime_radius));
            format!(
                "Una excentricidad de {e} es demasiado grande: tiene que ser menor que el radio primario, {radius}."
            )
        }
        Misfit::Triangle { pivot_distance, arm, prime_radius } => {
            let [m, arm, radius] = [pivot_distance, arm, prime_radius].map(|value| ES.exact(value));
            format!(
                "Una articulación a {m}, un brazo de {arm} y un radio primario de {radius} no forman un triángulo: cada uno tiene que ser menor que la suma de los otros dos."
            )
        }
        Misfit::FaceOutOfReach { pivot_distance, needed } => {
            let (m, needed) = (ES.exact(pivot_distance), ES.exact(needed));
            format!(
                "Desde una articulación a {m} la cara no puede tocar la circunferencia base: tiene que estar a más de {needed}."
            )
        }
    }
}

/// Changes that are not possible.
fn edit(refusal: EditRefusal) -> String {
    match refusal {
        EditRefusal::NoItem { count: 0, .. } => "La lista está vacía: no hay nada en este lugar.".to_owned(),
        EditRefusal::NoItem { found, count } => {
            format!("No hay nada en el lugar {found}; la lista tiene {count}, contados desde 0.")
        }
        EditRefusal::NothingLeft => "No queda nada por completar.".to_owned(),
        EditRefusal::LastTooShort => {
            "El último tramo es demasiado corto para devolver lo que sobra en la suma de los tramos.".to_owned()
        }
        EditRefusal::NothingMoves => "Ningún tramo se mueve de modo que pueda terminar a otra altura.".to_owned(),
        EditRefusal::NoConditions => "La ley de este tramo no tiene condiciones.".to_owned(),
        EditRefusal::NoFormula => "La ley de este tramo no es una fórmula.".to_owned(),
        EditRefusal::NoApplication => "El seguidor no acciona nada.".to_owned(),
        EditRefusal::NoGenerator => "Solo una leva de ancho constante tiene generador.".to_owned(),
        EditRefusal::NoSecondCam => "Ninguna segunda leva unida de este modo sirve.".to_owned(),
    }
}

/// What a kind of cam does not have.
fn cam(refusal: CamRefusal) -> String {
    match refusal {
        CamRefusal::Unsuited { kind } => format!("No tiene sitio en una {}.", crate::cam_kind(ES, kind)),
        CamRefusal::OffCentre { found, measure, kind } => {
            format!(
                "En una {} el seguidor tiene que estar centrado: aquí debe haber 0, y hay {}.",
                crate::cam_kind(ES, kind),
                measured(found, measure, ES)
            )
        }
        CamRefusal::Breadth { found, base_radius } => {
            let (breadth, twice) = (ES.exact(found), ES.exact(2.0 * base_radius));
            format!(
                "Una anchura de {breadth} no deja carrera: anchura = 2·Rb + carrera, así que tiene que ser mayor que {twice}."
            )
        }
        CamRefusal::BreadthTravel { found, travel, breadth, base_radius } => {
            let [found, travel, breadth, radius] = [found, travel, breadth, base_radius].map(|v| ES.exact(v));
            format!(
                "En media vuelta el seguidor tiene que subir anchura − 2·Rb = {breadth} − 2·{radius} = {travel}, y los tramos suben {found}."
            )
        }
        CamRefusal::Sides { found, most } => {
            let (found, most) = (ES.exact(found), ES.exact(most));
            format!("Un polígono de arcos tiene un número impar de lados, de 3 a {most}, y este tiene {found}.")
        }
        CamRefusal::SharpArcs { found, least, half } => {
            let (found, least, half) = (ES.exact(found), ES.number(least), ES.exact(half));
            format!(
                "Un radio base de {found} es demasiado pequeño para estos arcos: tiene que ser al menos {least} (vértices vivos) y menor que {half}, la mitad de la anchura."
            )
        }
        CamRefusal::TooClose { found, least } => {
            let (found, least) = (ES.exact(found), ES.number(least));
            format!(
                "A una distancia de {found} no hay sitio para una segunda leva: tiene que ser mayor que {least}."
            )
        }
        CamRefusal::SwingingApplication => {
            "El desplazamiento de un seguidor oscilante es un ángulo, y una aplicación la mueve un seguidor de traslación."
                .to_owned()
        }
    }
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Null => "nada (null)",
        Kind::Boolean => "verdadero o falso",
        Kind::Number => "un número",
        Kind::Text => "un texto",
        Kind::List => "una lista",
        Kind::Object => "un objeto",
    }
}
