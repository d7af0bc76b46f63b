//! Other kinds of cam: yokes, pairs, wedges and grooves.

use super::{DEGREES, LENGTH, PLAIN, Term};
use crate::words::two;

pub(super) const TERMS: &[Term] = &[
    Term {
        id: "kind",
        name: two("Kind of cam", "Clase de leva"),
        text: two(
            "A plate that turns under one follower; one of constant breadth within a yoke; a groove that holds a roller from both sides; or a wedge that travels to and fro.",
            "Una placa que gira bajo un seguidor; una de anchura constante dentro de un marco; una ranura que sujeta un rodillo por los dos lados; o una cuña que va y viene.",
        ),
        theory: "constant-breadth",
        ..PLAIN
    },
    Term {
        id: "breadth",
        symbol: "d_c",
        name: two("Breadth", "Anchura"),
        unit: LENGTH,
        text: two(
            "Distance between two parallel lines that touch the cam on both sides, the same in every direction; for rollers, the diameter through their centres less their radii.",
            "Distancia entre dos rectas paralelas tangentes a la leva por ambos lados, la misma en todas las direcciones; con rodillos, el diámetro entre sus centros menos sus radios.",
        ),
        formula: Some("d_c = 2R_b + s_(max)"),
        drawing: Some(("breadth", "breadth")),
        theory: "constant-breadth",
        ..PLAIN
    },
    Term {
        id: "length",
        symbol: "l",
        name: two("Length of a translating cam", "Longitud de una leva de traslación"),
        unit: LENGTH,
        text: two(
            "How far a wedge travels before it goes back; its segments add up to it.",
            "Lo que recorre una cuña antes de volver; sus tramos suman esa longitud.",
        ),
        theory: "grooved",
        ..PLAIN
    },
    Term {
        id: "distance",
        symbol: "D",
        name: two("Distance of a conjugate pair", "Distancia de una pareja conjugada"),
        unit: LENGTH,
        text: two(
            "Between the two faces, or the centres of the two rollers, of a follower that rides two cams.",
            "Entre las dos caras, o los centros de los dos rodillos, de un seguidor que va sobre dos levas.",
        ),
        formula: Some("R_(b2) = D - R_b - s_(max)"),
        theory: "conjugate",
        ..PLAIN
    },
    Term {
        id: "angle",
        symbol: "δ",
        name: two("Angle of a conjugate pair", "Ángulo de una pareja conjugada"),
        unit: DEGREES,
        text: two(
            "Between the two arms, or the two faces, of an oscillating follower that rides two cams. Either it or the base radius of the second cam is given, and the other is found.",
            "Entre los dos brazos, o las dos caras, de un seguidor oscilante que va sobre dos levas. Se da o bien este ángulo o bien el radio base de la segunda leva, y se halla el otro.",
        ),
        theory: "conjugate",
        ..PLAIN
    },
    Term {
        id: "generator",
        name: two("Motion of a cam of constant breadth", "Movimiento de una leva de anchura constante"),
        text: two(
            "How the free half turn is filled: the classic harmonic program, arcs of circle on a regular polygon, or the segments of the program mirrored onto the other half.",
            "Cómo se llena la media vuelta libre: el programa armónico clásico, arcos de circunferencia sobre un polígono regular, o los tramos del programa reflejados en la otra mitad.",
        ),
        drawing: Some(("breadth", "")),
        theory: "constant-breadth",
        ..PLAIN
    },
    Term {
        id: "sides",
        name: two("Sides of the polygon", "Lados del polígono"),
        text: two(
            "Vertices of the regular polygon about which the arcs of the cam are drawn: an odd number, so that opposite each vertex there is a side.",
            "Vértices del polígono regular en torno a los que se trazan los arcos de la leva: un número impar, para que frente a cada vértice haya un lado.",
        ),
        drawing: Some(("breadth", "sides")),
        theory: "constant-breadth",
        ..PLAIN
    },
];
