//! What is found in a cam, and what would put it right, in Spanish.

use super::ES;
use crate::Units;
use crate::voice::{Figures, by_law, row};
use levalab_core::{Column, FindingKind, Instead, Level, Tie};
use levalab_format::report::DesignFinding;
use levalab_format::{Price, Remedy};

pub(super) fn finding(finding: &DesignFinding, units: Units) -> String {
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
                "La aceleración {where_and_how_much}; solo aquí se tolera: el marco toca los dos lados y no puede despegarse."
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
            format!("El perfil forma una cúspide en {at}: su radio de curvatura es nulo y se desgastaría enseguida.")
        }
        FindingKind::Undercut => {
            format!(
                "{around} hay rebaje (socavación): el radio de curvatura bajaría a {value} en {at} y un rodillo de este tamaño no puede seguir el perfil."
            )
        }
        FindingKind::GrooveUndercut => {
            format!(
                "{around} hay rebaje (socavación) en la pared exterior de la ranura: la curva de paso es cóncava con radio {value} en {at}, menor que el del rodillo, {limit}."
            )
        }
        FindingKind::ConcaveFlat => {
            format!(
                "{around} el perfil tendría que ser cóncavo, y una cara plana no puede tocarlo: el radio de curvatura baja a {value} en {at}."
            )
        }
        FindingKind::NotProved(order) => {
            let what = match order {
                0 => "del desplazamiento y de sus derivadas",
                1 => "de la velocidad, la aceleración y la sobreaceleración",
                2 => "de la aceleración y la sobreaceleración",
                _ => "de la sobreaceleración",
            };
            format!(
                "{around} la fórmula varía tan deprisa que se alcanzó el límite de cálculo sin demostrar los extremos {what}: ellos, y lo que de ellos depende, pueden ser mayores que los mostrados."
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
            format!("{around} el contacto quedaría al otro lado de la articulación, a {value} sobre la cara en {at}.")
        }
    }
}

pub(super) fn cure(finding: &DesignFinding, remedy: &Remedy, units: Units) -> String {
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
        Remedy::Length { key, value } => {
            let what = if *key == "arm" { "un brazo" } else { "una distancia a la articulación" };
            format!("Con {what} de {} {}.", units.length(*value, ES), passing(finding.kind, units))
        }
        Remedy::NoSize { needed, instead } => no_size(finding, *needed, *instead, units),
        Remedy::Laws { changes, remaining_jump, price } => {
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
            format!("Con {} {result}{}.", row(&groups, "y"), price_of(price, units))
        }
    }
}

/// What a change of laws gives up, after what it brings: each figure as it is and as it becomes.
fn price_of(price: &Price, units: Units) -> String {
    let angle = price.pressure_angle.map(|(after, before)| format!("φ {} → {}", ES.angle(before), ES.angle(after)));
    let peak = price.acceleration.map(|ratio| format!("a máx. × {}", ES.ratio(ratio)));
    let lift = price
        .lift
        .map(|(after, before)| format!("elevación {} → {}", units.travel(before, 0, ES), units.travel(after, 0, ES)));
    let costs: Vec<String> = angle.into_iter().chain(peak).chain(lift).collect();
    if costs.is_empty() { String::new() } else { format!(" (a cambio: {})", costs.join(", ")) }
}

/// That size is no cure, and what is.
fn no_size(finding: &DesignFinding, needed: Option<f64>, instead: Instead, units: Units) -> String {
    let Figures { at, .. } = Figures::of(finding, units, ES);
    let size = match needed.map(|size| units.length(size, ES)) {
        Some(size) if units.travels => {
            format!("Una carrera más larga no lo remedia: tendría que ser de {size}.")
        }
        Some(size) => format!("El tamaño no lo remedia: Rb tendría que ser de {size}."),
        None if units.travels => "Ninguna carrera lo remedia.".to_owned(),
        None if units.oscillating => "Ninguna longitud razonable lo remedia por sí sola.".to_owned(),
        None => "Ningún tamaño lo remedia.".to_owned(),
    };
    let way = match instead {
        Instead::GentlerMotion => {
            let span = if units.travels { "carrera" } else { "ángulo" };
            format!("Lo remediaría un movimiento más suave en {at}: menos elevación, o la misma en más {span}.")
        }
        Instead::SmallerFaceAngle => "Lo remediaría una inclinación menor de la cara.".to_owned(),
        Instead::SmoothMotion => {
            "Antes hay que quitar al movimiento los saltos de desplazamiento y de velocidad.".to_owned()
        }
    };
    format!("{size} {way}")
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
        FindingKind::Jump(_) | FindingKind::BelowBase | FindingKind::Doubtful | FindingKind::NotProved(_) => {
            "la leva es correcta"
        }
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
