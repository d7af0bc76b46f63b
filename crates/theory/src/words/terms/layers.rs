//! What is drawn on the mechanism.

use super::{LENGTH, PLAIN, Term};
use crate::words::two;

pub(super) const TERMS: &[Term] = &[
    Term {
        id: "layer-base",
        symbol: "R_b",
        name: two("Base circle", "Circunferencia base"),
        unit: LENGTH,
        text: two(
            "The largest circle about the cam's centre within the profile. The lift is measured from it.",
            "La mayor circunferencia con centro en el de la leva dentro del perfil. Desde ella se mide la elevación.",
        ),
        drawing: Some(("mechanism", "base")),
        theory: "sizing",
        ..PLAIN
    },
    Term {
        id: "layer-prime",
        symbol: "R_p",
        name: two("Prime circle", "Circunferencia primaria"),
        unit: LENGTH,
        text: two(
            "The same for the pitch curve: where the centre of the roller is when the follower rests.",
            "Lo mismo para la curva de paso: donde está el centro del rodillo cuando el seguidor reposa.",
        ),
        formula: Some("R_p = R_b + R_f"),
        drawing: Some(("mechanism", "prime")),
        theory: "translating-roller",
        ..PLAIN
    },
    Term {
        id: "layer-pitch",
        symbol: "P",
        name: two("Pitch curve", "Curva de paso"),
        text: two(
            "The path of the roller's centre seen from the cam. The profile runs parallel to it at the distance of the roller's radius.",
            "La trayectoria del centro del rodillo vista desde la leva. El perfil es paralelo a ella, a la distancia del radio del rodillo.",
        ),
        formula: Some("P = F exp(-iσθ)"),
        drawing: Some(("mechanism", "pitch")),
        theory: "inversion",
        ..PLAIN
    },
    Term {
        id: "layer-axes",
        name: two("Axes", "Ejes"),
        text: two(
            "The fixed axes through the cam's centre, and the axis of the follower or the line to its pivot.",
            "Los ejes fijos por el centro de la leva, y el eje del seguidor o la recta hasta su articulación.",
        ),
        drawing: Some(("mechanism", "axes")),
        theory: "inversion",
        ..PLAIN
    },
    Term {
        id: "layer-normal",
        symbol: "φ",
        name: two("Contact normal and φ", "Normal en el contacto y φ"),
        text: two(
            "The line along which the cam pushes, through the contact and the centre of curvature, and its angle to the way the follower moves.",
            "La recta según la cual empuja la leva, por el contacto y el centro de curvatura, y su ángulo con la dirección en que se mueve el seguidor.",
        ),
        drawing: Some(("mechanism", "pressure_angle")),
        theory: "pressure-angle",
        ..PLAIN
    },
    Term {
        id: "layer-osculating",
        symbol: "ρ",
        name: two("Osculating circle", "Círculo osculador"),
        unit: LENGTH,
        text: two(
            "The circle that fits the profile best at the contact: its radius is $ρ$, its centre lies on the normal.",
            "El círculo que mejor se ciñe al perfil en el contacto: su radio es $ρ$ y su centro está en la normal.",
        ),
        drawing: Some(("mechanism", "rho")),
        theory: "radius",
        ..PLAIN
    },
    Term {
        id: "layer-stations",
        name: two("Follower around the cam", "Seguidor alrededor de la leva"),
        text: two(
            "The graphical construction: the cam held still and the follower in many of its positions about it. The profile touches them all.",
            "La construcción gráfica: la leva fija y el seguidor en muchas de sus posiciones a su alrededor. El perfil es tangente a todas.",
        ),
        drawing: Some(("inversion", "")),
        theory: "inversion",
        ..PLAIN
    },
];
