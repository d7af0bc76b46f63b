//! Spanish: names, verdicts, links and files.

mod data;
mod finding;
mod problem;

use crate::voice::{FileProblem, Voice, joints_of_the_jerk, rests, row, worst_kinds};
use crate::{Language, Units};
use levalab_catalogue::finding_label;
use levalab_core::Level;
use levalab_format::link::{LinkError, TooLong};
use levalab_format::report::{DesignFinding, Report};
use levalab_format::{Problem, Remedy, quoted};

pub(crate) struct Spanish;

const ES: Language = Language::Es;

impl Voice for Spanish {
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
                    worst_kinds(report).into_iter().map(|kind| finding_label(kind).reason.within(ES).to_owned()).collect();
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
