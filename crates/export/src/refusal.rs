//! Why something cannot be exported.

use levalab_core::FindingKind;
use levalab_format::LengthUnit;
use levalab_words::Language;

/// What stands in the way. Lengths in the unit of the design.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The turn is not a whole number of such steps, degrees.
    Step {
        /// What was asked for.
        found: f64,
    },
    /// A measure that is not a positive number.
    NotPositive {
        /// Which, by the name of its option.
        what: &'static str,
        /// What it was.
        found: f64,
    },
    /// The keyway is as wide as the bore.
    KeywayTooWide {
        /// Its width.
        found: f64,
        /// Diameter of the bore.
        bore: f64,
        /// Unit of both.
        unit: LengthUnit,
    },
    /// Bore or keyway would break through the profile.
    NoRoom {
        /// How far from the centre they go.
        reach: f64,
        /// How near to the centre the profile comes.
        room: f64,
        /// Unit of both.
        unit: LengthUnit,
    },
    /// The profile bounds no solid.
    NotSolid {
        /// What is wrong with it, when a finding says so.
        why: Option<FindingKind>,
    },
    /// A cam that travels has no shaft.
    NoShaft,
    /// Only a flat face has a contact that walks along it.
    NoSuchDiagram,
    /// The diagram of an application that the design does not have.
    NoApplication,
    /// Another writer gave up.
    Failed {
        /// What it said.
        said: String,
    },
}

impl Refusal {
    /// The sentence, in the language.
    #[must_use]
    pub fn sentence(&self, language: Language) -> String {
        let number = |value: f64| language.exact(value);
        let length = |value: f64, unit: LengthUnit| format!("{}\u{a0}{}", language.number(value), unit.symbol());
        match (language, self) {
            (Language::En, Self::Step { found }) => {
                format!("Steps of {}° do not divide a turn evenly into at most 36,000.", number(*found))
            }
            (Language::Es, Self::Step { found }) => {
                format!("Pasos de {}° no dividen la vuelta en partes iguales, 36 000 como mucho.", number(*found))
            }
            (Language::En, Self::NotPositive { found, .. }) => {
                format!("This measure has to be a positive number, and is {}.", number(*found))
            }
            (Language::Es, Self::NotPositive { found, .. }) => {
                format!("Esta medida tiene que ser un número positivo, y es {}.", number(*found))
            }
            (Language::En, Self::KeywayTooWide { found, bore, unit }) => {
                format!(
                    "A keyway {} wide does not fit a bore of {} in diameter.",
                    length(*found, *unit),
                    length(*bore, *unit)
                )
            }
            (Language::Es, Self::KeywayTooWide { found, bore, unit }) => {
                format!(
                    "Un chavetero de {} de ancho no cabe en un agujero de {} de diámetro.",
                    length(*found, *unit),
                    length(*bore, *unit)
                )
            }
            (Language::En, Self::NoRoom { reach, room, unit }) => {
                format!(
                    "Bore and keyway reach {} from the centre, and the profile comes to {} of it.",
                    length(*reach, *unit),
                    length(*room, *unit)
                )
            }
            (Language::Es, Self::NoRoom { reach, room, unit }) => {
                format!(
                    "El agujero con su chavetero llega a {} del centro, y el perfil se acerca a {}.",
                    length(*reach, *unit),
                    length(*room, *unit)
                )
            }
            (Language::En, Self::NotSolid { why: Some(FindingKind::Undercut | FindingKind::ConcaveFlat) }) => {
                "The profile is undercut, so it bounds no solid: cure that first.".to_owned()
            }
            (Language::Es, Self::NotSolid { why: Some(FindingKind::Undercut | FindingKind::ConcaveFlat) }) => {
                "El perfil tiene rebaje y no encierra ningún sólido: corríjalo primero.".to_owned()
            }
            (Language::En, Self::NotSolid { .. }) => {
                "The profile crosses itself, so it bounds no solid: cure that first.".to_owned()
            }
            (Language::Es, Self::NotSolid { .. }) => {
                "El perfil se corta a sí mismo y no encierra ningún sólido: corríjalo primero.".to_owned()
            }
            (Language::En, Self::NoShaft) => "A cam that travels has no shaft.".to_owned(),
            (Language::Es, Self::NoShaft) => "Una leva de traslación no tiene eje.".to_owned(),
            (Language::En, Self::NoSuchDiagram) => "Only on a flat face does the contact walk.".to_owned(),
            (Language::En, Self::NoApplication) => {
                "The design has no application, so there is nothing to draw of one.".to_owned()
            }
            (Language::Es, Self::NoApplication) => {
                "El diseño no tiene aplicación, así que no hay ninguna que dibujar.".to_owned()
            }
            (Language::Es, Self::NoSuchDiagram) => "El contacto solo se desplaza sobre una cara plana.".to_owned(),
            (Language::En, Self::Failed { said }) => format!("The file could not be made: {said}."),
            (Language::Es, Self::Failed { said }) => format!("No se ha podido hacer el archivo: {said}."),
        }
    }

    /// The option that it is about, if any.
    #[must_use]
    pub fn option(&self) -> Option<&'static str> {
        match self {
            Self::Step { .. } => Some("step"),
            Self::NotPositive { what, .. } => Some(what),
            Self::KeywayTooWide { .. } => Some("keyway"),
            Self::NoRoom { .. } | Self::NoShaft => Some("bore"),
            Self::NoSuchDiagram | Self::NoApplication => Some("diagram"),
            Self::NotSolid { .. } | Self::Failed { .. } => None,
        }
    }
}
