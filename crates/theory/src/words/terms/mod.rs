//! Every magnitude: symbol, name, unit, sign and definition. The page's question marks show these.

mod contact;
mod geometry;
mod kinds;
mod layers;
mod motion;
mod program;

use super::{Two, two};

/// A magnitude.
pub struct Term {
    /// Its place in the page, and what a question mark asks for.
    pub id: &'static str,
    /// Its symbol in the notation of formulas; empty when it has none.
    pub symbol: &'static str,
    /// Its name.
    pub name: Two,
    /// Its unit.
    pub unit: Two,
    /// What plus and minus mean.
    pub sign: Option<Two>,
    /// What it is.
    pub text: Two,
    /// Its formula.
    pub formula: Option<&'static str>,
    /// The drawing, and the part of it that is lit.
    pub drawing: Option<(&'static str, &'static str)>,
    /// Where the theory tells more: an anchor.
    pub theory: &'static str,
}

/// A group of terms under a heading.
pub struct Group {
    /// Its heading.
    pub name: Two,
    /// Its terms.
    pub terms: &'static [Term],
}

const LENGTH: Two = two("length", "longitud");
const DEGREES: Two = two("degrees", "grados");
const NONE: Two = two("none", "ninguna");

const PLAIN: Term = Term {
    id: "",
    symbol: "",
    name: two("", ""),
    unit: NONE,
    sign: None,
    text: two("", ""),
    formula: None,
    drawing: None,
    theory: "svaj",
};

/// Every term, in the order of the page.
pub const GROUPS: &[Group] = &[
    Group { name: two("Cam and follower", "Leva y seguidor"), terms: geometry::TERMS },
    Group { name: two("Motion program", "Programa de movimiento"), terms: program::TERMS },
    Group { name: two("Motion", "Movimiento"), terms: motion::TERMS },
    Group { name: two("Contact", "Contacto"), terms: contact::TERMS },
    Group { name: two("What is drawn on the mechanism", "Lo que se dibuja sobre el mecanismo"), terms: layers::TERMS },
    Group { name: two("Other kinds of cam", "Otras clases de leva"), terms: kinds::TERMS },
];

/// The term of that name.
#[must_use]
pub fn term(id: &str) -> Option<&'static Term> {
    GROUPS.iter().flat_map(|group| group.terms).find(|term| term.id == id)
}
