//! Spanish.

use crate::data_es;
use crate::voice::{Figures, FileProblem, Voice, by_law, measured, row, worst_kinds};
use crate::{Language, Units};
use levalab_core::{Column, FindingKind, Level, Misfit, Tie};
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Kind, Measure, Problem, Remedy, quoted};

pub(crate) struct Spanish;

const ES: Language = Language::Es;

impl Voice for Spanish {
    fn law(&self, id: &str) -> Option<&'static str> {
        Some(match id {
            "dwell" => "de detenimiento",
            "constant-velocity" => "de velocidad constante",
            "parabolic" => "parabólica",
            "parabolic-blend" => "uniforme modificada",
            "cubic-1" => "cúbica 1",
            "cubic-2" => "cúbica 2",
            "simple-harmonic" => "armónica simple",
            "double-harmonic" => "doble armónica",
            "cycloidal" => "cicloidal",
            "polynomial-3-4-5" => "polinómica 3-4-5",
            "polynomial-4-5-6-7" => "polinómica 4-5-6-7",
            "modified-trapezoidal" => "trapezoidal modificada",
            "modified-sine" => "de seno modificado",
            "scca" => "SCCA",
            "skewed-scca" => "SCCA asimétrica",
            "asymmetric-3-4-5" => "3-4-5 asimétrica",
            "half-harmonic-start" => "semiarmónica (inicio)",
            "half-harmonic-end" => "semiarmónica (final)",
            "half-cycloidal-start" => "semicicloidal (inicio)",
            "half-cycloidal-end" => "semicicloidal (final)",
            "polynomial-5" => "polinómica de 5.º grado",
            "polynomial-7" => "polinómica de 7.º grado",
            "polynomial" => "polinómica por condiciones",
            "bspline" => "B-spline",
            "bezier" => "de Bézier",
            "table" => "por tabla",
            "formula" => "por fórmula",
            "circular-arc" => "de arco de circunferencia",
            _ => return None,
        })
    }

    fn follower(&self, id: &str) -> Option<&'static str> {
        Some(match id {
            "translating-roller" => "seguidor de traslación con rodillo",
            "translating-knife" => "seguidor de traslación con cuchilla",
            "translating-curved" => "seguidor de traslación con cara curva",
            "translating-flat" => "seguidor de traslación con cara plana",
            "oscillating-roller" => "seguidor oscilante con rodillo",
            "oscillating-flat" => "seguidor oscilante con cara plana",
            _ => return None,
        })
    }

    fn cam_kind(&self, word: &str) -> Option<&'static str> {
        Some(match word {
            "rotating" => "leva de placa",
            "grooved" => "leva de ranura",
            "constant-breadth" => "leva de anchura constante",
            "translating" => "leva de traslación",
            _ => return None,
        })
    }

    fn second_cam(&self) -> &'static str {
        "Segunda leva"
    }

    fn level(&self, level: Level) -> &'static str {
        match level {
            Level::Acceptable => "aceptable",
            Level::LowSpeed => "no apta para altas velocidades",
            Level::Unacceptable => "inaceptable",
        }
    }

    fn headline(&self, report: &Report) -> String {
        let joints = report.findings.first().map_or(0, |finding| finding.places.len());
        match report.level {
            Level::Acceptable if joints > 0 => {
                "Aceptable: el marco sujeta la leva por los dos lados y los saltos de aceleración no los separan."
                    .to_owned()
            }
            Level::Acceptable => {
                "Aceptable: el movimiento es suave hasta la sobreaceleración y el perfil es correcto.".to_owned()
            }
            Level::LowSpeed if joints == 1 => {
                "No apta para altas velocidades: la sobreaceleración salta en una unión.".to_owned()
            }
            Level::LowSpeed => {
                format!("No apta para altas velocidades: la sobreaceleración salta en {joints} uniones.")
            }
            Level::Unacceptable => {
                let reasons: Vec<String> =
                    worst_kinds(report).into_iter().map(|kind| reason(kind).to_owned()).collect();
                format!("Inaceptable: {}.", row(&reasons, "y"))
            }
        }
    }

    fn finding(&self, finding: &DesignFinding, units: Units) -> String {
        let Figures { at, span, other, count, value, limit } = Figures::of(finding, units, ES);
        let along = |(from, to): (String, String)| format!("De {from} a {to}");
        let around = span.map_or_else(|| format!("En {at}"), along);
        let where_and_how_much = if count > 1 {
            format!("salta en {count} uniones, hasta {value} en {at}")
        } else {
            format!("salta {value} en {at}")
        };
        match finding.kind {
            FindingKind::Jump(0) => {
                format!("El desplazamiento {where_and_how_much}: el seguidor tendría que estar en dos sitios a la vez.")
            }
            FindingKind::Jump(1) => format!("La velocidad {where_and_how_much}: aceleración infinita, un golpe."),
            FindingKind::Jump(2) if finding.level == Level::Acceptable => {
                format!(
                    "La aceleración {where_and_how_much}; solo aquí se tolera, porque el marco toca los dos lados y no puede despegarse."
                )
            }
            FindingKind::Jump(_) if finding.level == Level::Acceptable => {
                format!("La sobreaceleración {where_and_how_much}; se tolera en una leva sujeta por los dos lados.")
            }
            FindingKind::Jump(2) => {
                format!("La aceleración {where_and_how_much}: las fuerzas cambian de golpe y el seguidor vibra.")
            }
            FindingKind::Jump(_) => {
                format!(
                    "La sobreaceleración {where_and_how_much}: a baja velocidad no molesta, a alta velocidad produce vibraciones."
                )
            }
            FindingKind::PressureAngle => {
                let motion = if units.oscillating { "oscilante" } else { "de traslación" };
                format!(
                    "El ángulo de presión llega a {value} en {at}, por encima de los {limit} que tolera un seguidor {motion}."
                )
            }
            FindingKind::Cusp => {
                format!(
                    "El perfil forma una cúspide en {at}: su radio de curvatura es nulo y se desgastaría enseguida."
                )
            }
            FindingKind::Undercut => {
                format!(
                    "{around} hay rebaje (socavación): el radio de curvatura bajaría a {value} en {at} y un rodillo de este tamaño no puede seguir el perfil."
                )
            }
            FindingKind::GrooveUndercut => {
                format!(
                    "{around} hay rebaje (socavación) en la pared exterior de la ranura: la curva primitiva es cóncava con radio {value} en {at}, menor que el del rodillo, {limit}."
                )
            }
            FindingKind::ConcaveFlat => {
                format!(
                    "{around} el perfil tendría que ser cóncavo, y una cara plana no puede tocarlo: el radio de curvatura baja a {value} en {at}."
                )
            }
            FindingKind::Doubtful => {
                format!(
                    "{around} las condiciones apenas determinan la curva: el menor redondeo de una de ellas le cambia la forma, y sus cifras no son de fiar."
                )
            }
            FindingKind::BelowBase => {
                let base = if units.travels { "recta" } else { "circunferencia" };
                format!("El seguidor baja de la {base} base, hasta {value} en {at}.")
            }
            FindingKind::SelfCrossing => {
                format!("El perfil se corta a sí mismo: pasa por el mismo punto en {at} y en {other}.")
            }
            FindingKind::ArmCutsCam if units.oscillating => {
                format!("En {at} el brazo del seguidor penetraría {value} en la leva.")
            }
            FindingKind::ArmCutsCam => format!("En {at} el vástago del seguidor penetraría {value} en la leva."),
            FindingKind::PivotInsideCam => {
                format!(
                    "La leva barre la articulación: en {at} llega a {value} de su centro y la articulación está a {limit}."
                )
            }
            FindingKind::FaceOvertaken => {
                format!(
                    "En {at} la cara gira a {value} veces la velocidad de la leva y en su mismo sentido, y el contacto se escapa a lo largo de ella."
                )
            }
            FindingKind::ContactPastPivot => {
                format!(
                    "{around} el contacto quedaría al otro lado de la articulación, a {value} sobre la cara en {at}."
                )
            }
        }
    }

    fn cure(&self, finding: &DesignFinding, remedy: &Remedy, units: Units) -> String {
        match remedy {
            Remedy::BaseRadius { value, grows } => {
                let sign = if *grows { '≥' } else { '=' };
                format!("Con Rb {sign} {} {}.", units.length(*value, ES), passing(finding.kind, units))
            }
            Remedy::Travel { value } => {
                format!("Con una carrera de {} {}.", units.length(*value, ES), passing(finding.kind, units))
            }
            Remedy::Tie { tie, grows } => {
                let sign = if *grows { '≥' } else { '≤' };
                let what = match tie {
                    Tie::Distance(value) => format!("una distancia {sign} {}", units.length(*value, ES)),
                    Tie::Angle(value) => format!("un ángulo {sign} {} entre los brazos", ES.angle_exact(*value)),
                    Tie::BaseRadius(value) => format!("un segundo radio base {sign} {}", units.length(*value, ES)),
                };
                format!("Con {what} {}.", passing(finding.kind, units))
            }
            Remedy::Eccentricity { value, pressure_angle } => {
                let (e, angle) = (units.length(*value, ES), ES.angle(*pressure_angle));
                if finding.limit.is_some_and(|limit| *pressure_angle <= limit) {
                    format!("Con una excentricidad de {e} no pasa de {angle}.")
                } else {
                    format!("Con una excentricidad de {e} baja a {angle}.")
                }
            }
            Remedy::Laws { changes, remaining_jump } => {
                let groups = by_law(changes)
                    .into_iter()
                    .map(|(law, segments)| format!("la ley {} {}", crate::law(ES, law), in_segments(&segments)));
                let groups: Vec<String> = groups.collect();
                let result = match (finding.kind, remaining_jump) {
                    (FindingKind::BelowBase, _) => "el seguidor no baja de la circunferencia base",
                    (_, None) => "ya no salta nada",
                    (_, Some(Column::J)) => "solo salta la sobreaceleración",
                    (_, Some(_)) => "este salto desaparece",
                };
                format!("Con {} {result}.", row(&groups, "y"))
            }
        }
    }

    fn problem(&self, problem: &Problem) -> String {
        match problem {
            Problem::FileTooLarge { bytes, limit } => {
                format!(
                    "El archivo tiene {} bytes; ningún diseño pasa de {}.",
                    ES.exact(*bytes as f64),
                    ES.exact(*limit as f64)
                )
            }
            Problem::NotText => "El archivo no es texto en UTF-8.".to_owned(),
            Problem::NotJson { line, column } => {
                format!("El texto deja de ser JSON en la línea {line}, columna {}.", (*column).max(1))
            }
            Problem::NotFinite => "El número es demasiado grande.".to_owned(),
            Problem::WrongKind { found, expected } => {
                format!("Aquí tiene que haber {}, y hay {}.", kind(*expected), kind(*found))
            }
            Problem::Missing => "Falta este campo.".to_owned(),
            Problem::UnknownField { expected } => {
                format!("Este campo no significa nada aquí; los que valen son {}.", row_of(expected))
            }
            Problem::DuplicateField => "Este campo está dos veces.".to_owned(),
            Problem::WrongWord { found, expected } => match expected.as_slice() {
                [only] => format!("{} no se conoce; aquí solo vale {only}.", quoted(found)),
                _ => format!("{} no es ninguna de las opciones: {}.", quoted(found), expected.join(", ")),
            },
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
            Problem::NoSegments => "No hay tramos, y hace falta al menos uno.".to_owned(),
            Problem::TooManySegments { found, limit } => format!("Hay {found} tramos y no caben más de {limit}."),
            Problem::DwellRises { found, measure } => {
                format!("Un detenimiento no puede subir, y este sube {}.", measured(*found, *measure, ES))
            }
            Problem::Data(refusal) => data_es::refusal(refusal),
            Problem::Join(problem) => crate::join::problem(ES, *problem),
            Problem::AdjacentPolynomials { next } => {
                format!(
                    "Toma de sus vecinos las condiciones en los extremos, y el tramo {} también: no pueden ir seguidos.",
                    next + 1
                )
            }
            Problem::Turn { found, whole, measure } => {
                let missing = whole - found;
                let (sum, difference) = (measured(*found, *measure, ES), measured(missing.abs(), *measure, ES));
                let rest = match (missing > 0.0, missing.abs() == 1.0) {
                    (true, true) => "falta",
                    (true, false) => "faltan",
                    (false, true) => "sobra",
                    (false, false) => "sobran",
                };
                let cycle = match (measure, *whole < 360.0) {
                    (Measure::Degrees, false) => "una vuelta completa".to_owned(),
                    (Measure::Degrees, true) => "media vuelta, que su imagen completa".to_owned(),
                    _ => format!("una carrera de {}", ES.exact(*whole)),
                };
                format!("Los tramos suman {sum}: {rest} {difference} para {cycle}.")
            }
            Problem::Closing { found, measure } => {
                let height = measured(*found, *measure, ES);
                format!(
                    "Las subidas y bajadas suman {height}; tienen que sumar 0 para que la vuelta acabe donde empieza."
                )
            }
            Problem::BelowBase { found, measure } => {
                format!(
                    "El seguidor acabaría en {}, por debajo de la circunferencia base.",
                    measured(*found, *measure, ES)
                )
            }
            Problem::Misfit(problem) => misfit(*problem),
            Problem::Unsuited { kind } => format!("No tiene sitio en una {}.", crate::cam_kind(ES, kind)),
            Problem::OffCentre { found, measure, kind } => {
                format!(
                    "En una {} el seguidor tiene que estar centrado: aquí debe haber 0, y hay {}.",
                    crate::cam_kind(ES, kind),
                    measured(*found, *measure, ES)
                )
            }
            Problem::Breadth { found, base_radius } => {
                let (breadth, twice) = (ES.exact(*found), ES.exact(2.0 * base_radius));
                format!(
                    "Una anchura de {breadth} no deja carrera: anchura = 2·Rb + carrera, así que tiene que ser mayor que {twice}."
                )
            }
            Problem::BreadthTravel { found, travel, breadth, base_radius } => {
                let [found, travel, breadth, radius] = [found, travel, breadth, base_radius].map(|v| ES.exact(*v));
                format!(
                    "En media vuelta el seguidor tiene que subir anchura − 2·Rb = {breadth} − 2·{radius} = {travel}, y los tramos suben {found}."
                )
            }
            Problem::Sides { found, most } => {
                let (found, most) = (ES.exact(*found), ES.exact(*most));
                format!("Un polígono de arcos tiene un número impar de lados, de 3 a {most}, y este tiene {found}.")
            }
            Problem::SharpArcs { found, least, half } => {
                let (found, least, half) = (ES.exact(*found), ES.number(*least), ES.exact(*half));
                format!(
                    "Un radio base de {found} es demasiado pequeño para estos arcos: tiene que ser al menos {least} (vértices vivos) y menor que {half}, la mitad de la anchura."
                )
            }
            Problem::TooClose { found, least } => {
                let (found, least) = (ES.exact(*found), ES.number(*least));
                format!(
                    "A una distancia de {found} no hay sitio para una segunda leva: tiene que ser mayor que {least}."
                )
            }
            Problem::SwingingApplication => {
                "El desplazamiento de un seguidor oscilante es un ángulo, y una aplicación la mueve un seguidor de traslación."
                    .to_owned()
            }
            Problem::OneOf { expected } => format!("Solo se puede dar uno de estos campos: {}.", row_of(expected)),
        }
    }

    fn link(&self, error: &LinkError) -> String {
        match error {
            LinkError::Empty => "El enlace está vacío.".to_owned(),
            LinkError::TooLong(TooLong { found, limit }) => {
                format!("El enlace tiene {found} caracteres y ninguno pasa de {limit}.")
            }
            LinkError::Character { found, position } => {
                format!(
                    "El enlace está dañado: el carácter {position} es {}, que no aparece en ningún enlace.",
                    quoted(&found.to_string())
                )
            }
            LinkError::Damaged => {
                "El enlace está dañado: por el camino se perdieron o cambiaron caracteres.".to_owned()
            }
            LinkError::Version { found } => {
                format!("El enlace es de la versión {}, más nueva que este programa.", quoted(found))
            }
            LinkError::Unreadable => {
                "El enlace está entero, pero no es un diseño que este programa sepa leer.".to_owned()
            }
            LinkError::Design(error) => self.problem(&error.problem),
        }
    }

    fn too_long(&self, TooLong { found, limit }: TooLong) -> String {
        format!(
            "El enlace tendría {found} caracteres, y con más de {limit} no viaja bien. Guarde el diseño en un archivo."
        )
    }

    fn file(&self, problem: FileProblem) -> &'static str {
        match problem {
            FileProblem::Absent => "No existe ese archivo.",
            FileProblem::Folder => "Es una carpeta, no un archivo.",
            FileProblem::Forbidden => "No hay permiso para leer el archivo.",
            FileProblem::Unreadable => "No se puede leer el archivo.",
            FileProblem::Unwritable => "No se puede escribir el resultado.",
        }
    }
}

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

/// Why a cam is unacceptable, after a colon.
fn reason(kind: FindingKind) -> &'static str {
    match kind {
        FindingKind::Jump(0) => "el desplazamiento salta",
        FindingKind::Jump(1) => "la velocidad salta",
        FindingKind::Jump(2) => "la aceleración salta",
        FindingKind::Jump(_) => "la sobreaceleración salta",
        FindingKind::PressureAngle => "el ángulo de presión es excesivo",
        FindingKind::Cusp => "el perfil tiene una cúspide",
        FindingKind::Undercut => "el perfil tiene rebaje",
        FindingKind::GrooveUndercut => "la pared exterior de la ranura tiene rebaje",
        FindingKind::ConcaveFlat => "la cara plana no puede seguir el perfil",
        FindingKind::Doubtful => "las condiciones apenas determinan una curva",
        FindingKind::BelowBase => "el seguidor baja de la circunferencia base",
        FindingKind::SelfCrossing => "el perfil se corta a sí mismo",
        FindingKind::ArmCutsCam => "el seguidor penetra en la leva",
        FindingKind::PivotInsideCam => "la leva barre la articulación",
        FindingKind::FaceOvertaken => "la cara gira más deprisa que la leva",
        FindingKind::ContactPastPivot => "el contacto pasa al otro lado de la articulación",
    }
}

/// What another base circle brings, after it has been named.
fn passing(kind: FindingKind, units: Units) -> &'static str {
    match kind {
        FindingKind::PressureAngle => "se mantiene por debajo",
        FindingKind::Cusp | FindingKind::Undercut => "el perfil no tiene cúspides ni rebajes",
        FindingKind::GrooveUndercut => "ninguna pared de la ranura tiene rebaje",
        FindingKind::ConcaveFlat => "la cara plana toca todo el perfil",
        FindingKind::SelfCrossing => "el perfil ya no se corta",
        FindingKind::ArmCutsCam if units.oscillating => "el brazo no toca la leva",
        FindingKind::ArmCutsCam => "el vástago no toca la leva",
        FindingKind::PivotInsideCam => "la leva no llega a la articulación",
        FindingKind::FaceOvertaken => "la cara no pierde el contacto",
        FindingKind::ContactPastPivot => "el contacto no pasa al otro lado de la articulación",
        FindingKind::Jump(_) | FindingKind::BelowBase | FindingKind::Doubtful => "la leva es correcta",
    }
}

fn in_segments(segments: &[usize]) -> String {
    const NAMED: usize = 8;
    match segments {
        [one] => format!("en el tramo {one}"),
        many if many.len() > NAMED => format!("en {} tramos", many.len()),
        many => format!("en los tramos {}", row(&many.iter().map(usize::to_string).collect::<Vec<_>>(), "y")),
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

fn row_of(words: &[&str]) -> String {
    row(&words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>(), "y")
}
