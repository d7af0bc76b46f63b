//! Spanish: names, verdicts, links and files.

mod data;
mod finding;
mod problem;

use crate::voice::{FileProblem, Voice, joints_of_the_jerk, rests, row, worst_kinds};
use crate::{Language, Units};
use levalab_core::{FindingKind, Level};
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Problem, Remedy, quoted};

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
            "polynomial" => "polinómica libre",
            "bspline" => "B-spline",
            "bezier" => "de Bézier",
            "table" => "por tabla de puntos",
            "formula" => "por fórmula",
            "circular-arc" => "de arco de circunferencia",
            _ => return None,
        })
    }

    fn law_alone(&self, id: &str) -> Option<&'static str> {
        self.law(id).map(|name| name.strip_prefix("de ").or_else(|| name.strip_prefix("por ")).unwrap_or(name))
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
            Level::Acceptable if rests(report) => {
                "Aceptable, pero nada se mueve: todas las elevaciones son 0.".to_owned()
            }
            Level::Acceptable if joints > 0 => {
                "Aceptable: el marco rodea la leva y los saltos de aceleración no los separan.".to_owned()
            }
            Level::Acceptable => {
                "Aceptable: el movimiento es suave hasta la sobreaceleración y el perfil es correcto.".to_owned()
            }
            Level::LowSpeed if joints_of_the_jerk(report) == 0 => {
                "No apta para altas velocidades mientras no se demuestre: se alcanzó el límite de cálculo sin asegurar todos los extremos."
                    .to_owned()
            }
            Level::LowSpeed if joints_of_the_jerk(report) == 1 => {
                "No apta para altas velocidades: la sobreaceleración salta en una unión.".to_owned()
            }
            Level::LowSpeed => {
                let joints = joints_of_the_jerk(report);
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
        finding::finding(finding, units)
    }

    fn cure(&self, finding: &DesignFinding, remedy: &Remedy, units: Units) -> String {
        finding::cure(finding, remedy, units)
    }

    fn problem(&self, problem: &Problem) -> String {
        problem::problem(problem)
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
            LinkError::Newer { found } => {
                format!(
                    "El enlace se hizo con una versión más nueva de LevaLab: aquí no se conoce su parte {}.",
                    quoted(found)
                )
            }
            LinkError::Unreadable => {
                "El enlace está entero, pero no es un diseño que este programa sepa leer.".to_owned()
            }
            LinkError::Design(error) => self.problem(&error.problem),
        }
    }

    fn link_from_query(&self) -> &'static str {
        "El enlace venía detrás de «?» y no de «#», así que el diseño sí llegó al servidor de esta página. Ahora la dirección lo lleva detrás de «#», que no sale del navegador."
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
        FindingKind::NotProved(_) => "no se han demostrado todos los extremos",
        FindingKind::Doubtful => "las condiciones apenas determinan una curva",
        FindingKind::BelowBase => "el seguidor baja de la circunferencia base",
        FindingKind::SelfCrossing => "el perfil se corta a sí mismo",
        FindingKind::ArmCutsCam => "el seguidor penetra en la leva",
        FindingKind::PivotInsideCam => "la leva barre la articulación",
        FindingKind::FaceOvertaken => "la cara gira más deprisa que la leva",
        FindingKind::ContactPastPivot => "el contacto pasa al otro lado de la articulación",
    }
}
