//! The row of every kind of cam.

use crate::check::{have_codes_of_their_own, is_same};
use crate::label::{find, labels_of};
use crate::{Label, Name, Two, Version, two};

/// A kind of cam.
pub struct KindRow {
    /// Its word in design files.
    pub id: &'static str,
    /// The letter of the kind in a link; empty for a rotating cam, the usual kind.
    pub link: &'static str,
    /// The first version of file and link that knows it.
    pub since: Version,
    /// Its name.
    pub name: Name,
    /// The idea in a sentence.
    pub idea: Two,
    /// The book; `None` for a derivation of our own.
    pub source: Option<&'static str>,
}

const NORTON: Option<&str> = Some("R. L. Norton, Cam Design and Manufacturing Handbook");
const ROTHBART: Option<&str> = Some("H. A. Rothbart, Cam Design Handbook");

/// The names and the letter of a kind of cam, by its word in design files.
#[must_use]
pub fn kind_label(word: &str) -> Option<&'static Label> {
    find(&LABELS, word)
}

/// True for the word of a kind of cam that has a row here.
#[must_use]
pub const fn is_a_kind(word: &str) -> bool {
    let mut k = 0;
    while k < KINDS.len() {
        if is_same(KINDS[k].id, word) {
            return true;
        }
        k += 1;
    }
    false
}

/// Every kind of cam.
pub const KINDS: &[KindRow] = &[
    KindRow {
        id: "rotating",
        link: "",
        since: Version::One,
        name: Name {
            noun: two("plate cam", "leva de placa"),
            alone: two("plate cam", "leva de placa"),
            menu: two("Plate", "Placa"),
        },
        idea: two(
            "A plate that turns under one follower, which a force or a second cam keeps on it.",
            "Una placa que gira bajo un seguidor, al que una fuerza o una segunda leva mantiene sobre ella.",
        ),
        source: NORTON,
    },
    KindRow {
        id: "grooved",
        link: "g",
        since: Version::One,
        name: Name {
            noun: two("grooved cam", "leva de ranura"),
            alone: two("grooved cam", "leva de ranura"),
            menu: two("Grooved", "Ranura"),
        },
        idea: two(
            "A disc with a groove in its face, which holds a roller from both sides.",
            "Un disco con una ranura en su cara, que sujeta un rodillo por los dos lados.",
        ),
        source: ROTHBART,
    },
    KindRow {
        id: "constant-breadth",
        link: "b",
        since: Version::One,
        name: Name {
            noun: two("cam of constant breadth", "leva de anchura constante"),
            alone: two("cam of constant breadth", "leva de anchura constante"),
            menu: two("Constant breadth", "Anchura constante"),
        },
        idea: two(
            "A plate within a yoke that touches it on both sides, at the same distance in every direction.",
            "Una placa dentro de un marco que la toca por los dos lados, a la misma distancia en todas las direcciones.",
        ),
        source: ROTHBART,
    },
    KindRow {
        id: "translating",
        link: "t",
        since: Version::One,
        name: Name {
            noun: two("translating cam", "leva de traslación"),
            alone: two("translating cam", "leva de traslación"),
            menu: two("Translating (wedge)", "Traslación (cuña)"),
        },
        idea: two("A wedge that travels to and fro under its follower.", "Una cuña que va y viene bajo su seguidor."),
        source: ROTHBART,
    },
];

static LABELS: [Label; KINDS.len()] = labels();

const fn labels() -> [Label; KINDS.len()] {
    labels_of!(KINDS)
}

const _: () = have_codes_of_their_own(&labels());
