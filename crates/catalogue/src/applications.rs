//! The row of every application. To add an application, add its row here; see *How to add an application* in `ARCHITECTURE.md`.

use crate::check::{has_one_row_in_the_catalogue, have_codes_of_their_own};
use crate::label::{find, labels_of};
use crate::{Label, Name, Two, Version, two};
use levalab_core::application::Application;

/// The id of a parameter, an output or a figure of an application, and its name within a sentence.
pub type PartName = (&'static str, Two);

/// An application.
pub struct ApplicationRow {
    /// The application's id in the core and in files.
    pub id: &'static str,
    /// Its letter in a link. Never given to another application.
    pub link: &'static str,
    /// The first version of file and link that knows it.
    pub since: Version,
    /// Its name.
    pub name: Name,
    /// The names of its parameters, outputs and figures.
    pub parts: &'static [PartName],
    /// The idea in a sentence.
    pub idea: Two,
    /// The book; `None` for a derivation of our own.
    pub source: Option<&'static str>,
}

const FORCE: PartName = ("force", two("force", "fuerza"));
const STIFFNESS: PartName = ("stiffness", two("stiffness", "rigidez"));
const PISTON_RADIUS: PartName = ("piston_radius", two("piston radius", "radio del pistón"));
const PISTON_AREA: PartName = ("piston_area", two("piston area", "área del pistón"));
const OWN: Option<&str> = None;

/// The names and the letter of an application.
#[must_use]
pub fn application_label(application: &Application) -> Option<&'static Label> {
    find(&LABELS, application.id)
}

/// The name of a parameter, an output or a figure of an application.
#[must_use]
pub fn part_name(id: &str) -> Option<Two> {
    PARTS.iter().copied().flatten().find(|part| part.0 == id).map(|part| part.1)
}

/// Every application that the core lists.
pub const APPLICATIONS: &[ApplicationRow] = &[
    ApplicationRow {
        id: "force",
        link: "k",
        since: Version::One,
        name: Name {
            noun: two("force in proportion to the displacement", "fuerza proporcional al desplazamiento"),
            alone: two("force in proportion to the displacement", "fuerza proporcional al desplazamiento"),
            menu: two("Force in proportion to the displacement", "Fuerza proporcional al desplazamiento"),
        },
        parts: &[FORCE, STIFFNESS],
        idea: two("A spring that the follower compresses.", "Un resorte que el seguidor comprime."),
        source: OWN,
    },
    ApplicationRow {
        id: "piston-force",
        link: "p",
        since: Version::One,
        name: Name {
            noun: two("force of a piston on enclosed fluid", "fuerza de un pistón sobre fluido encerrado"),
            alone: two("force of a piston on enclosed fluid", "fuerza de un pistón sobre fluido encerrado"),
            menu: two("Force of a piston on enclosed fluid", "Fuerza de un pistón sobre fluido encerrado"),
        },
        parts: &[
            FORCE,
            STIFFNESS,
            PISTON_RADIUS,
            PISTON_AREA,
            ("pressure", two("pressure", "presión")),
            ("pressure_per_volume", two("pressure per volume", "presión por volumen")),
        ],
        idea: two(
            "A piston that compresses a fluid whose pressure rises in proportion to the volume that is swept.",
            "Un pistón que comprime un fluido cuya presión crece en proporción al volumen barrido.",
        ),
        source: OWN,
    },
    ApplicationRow {
        id: "pump",
        link: "u",
        since: Version::One,
        name: Name {
            noun: two("piston pump", "bomba de pistón"),
            alone: two("piston pump", "bomba de pistón"),
            menu: two("Piston pump", "Bomba de pistón"),
        },
        parts: &[
            PISTON_RADIUS,
            PISTON_AREA,
            ("volume", two("swept volume", "volumen barrido")),
            ("flow", two("flow", "caudal")),
        ],
        idea: two(
            "A piston that delivers the volume of every rise of the follower.",
            "Un pistón que entrega el volumen de cada subida del seguidor.",
        ),
        source: OWN,
    },
    ApplicationRow {
        id: "valve",
        link: "v",
        since: Version::One,
        name: Name {
            noun: two("poppet valve", "válvula de asiento"),
            alone: two("poppet valve", "válvula de asiento"),
            menu: two("Poppet valve", "Válvula de asiento"),
        },
        parts: &[
            ("area", two("curtain area", "área de la cortina")),
            ("seat_diameter", two("inner diameter of the seat", "diámetro interior del asiento")),
            ("seat_angle", two("seat angle", "ángulo del asiento")),
        ],
        idea: two(
            "A valve that the follower lifts off its conical seat: the gas passes through the curtain between them.",
            "Una válvula que el seguidor levanta de su asiento cónico: el gas pasa por la cortina que queda entre ambos.",
        ),
        source: Some("J. B. Heywood, Internal Combustion Engine Fundamentals, §6.3.2"),
    },
];

static LABELS: [Label; APPLICATIONS.len()] = labels();

static PARTS: [&[PartName]; APPLICATIONS.len()] = {
    let mut parts: [&[PartName]; APPLICATIONS.len()] = [&[]; APPLICATIONS.len()];
    let mut k = 0;
    while k < APPLICATIONS.len() {
        parts[k] = APPLICATIONS[k].parts;
        k += 1;
    }
    parts
};

const fn labels() -> [Label; APPLICATIONS.len()] {
    labels_of!(APPLICATIONS)
}

const _: () = {
    let labels = labels();
    let mut k = 0;
    while k < levalab_core::application::APPLICATIONS.len() {
        has_one_row_in_the_catalogue(levalab_core::application::APPLICATIONS[k].id, &labels);
        k += 1;
    }
    have_codes_of_their_own(&labels);
};
