//! Where cam and follower touch.

use super::{DEGREES, LENGTH, PLAIN, Term};
use crate::words::two;

pub(super) const TERMS: &[Term] = &[
    Term {
        id: "pressure_angle",
        symbol: "φ",
        name: two("Pressure angle", "Ángulo de presión"),
        unit: DEGREES,
        sign: Some(two("Positive in the rise of a radial follower.", "Positivo en la subida de un seguidor centrado.")),
        text: two(
            "Angle between the push of the cam, along the normal at the contact, and the way the follower moves. Good practice keeps it within 30° for a translating follower and 35° for an oscillating one.",
            "Ángulo entre el empuje de la leva, según la normal en el contacto, y la dirección en que se mueve el seguidor. La buena práctica lo mantiene dentro de 30° si el seguidor es de traslación y de 35° si es oscilante.",
        ),
        formula: Some("tan(φ) = (v - σe)/(s_0 + s)"),
        drawing: Some(("mechanism", "pressure_angle")),
        theory: "pressure-angle",
    },
    Term {
        id: "rho",
        symbol: "ρ",
        name: two("Radius of curvature", "Radio de curvatura"),
        unit: LENGTH,
        sign: Some(two(
            "Positive where the cam is convex, negative where it is hollow.",
            "Positivo donde la leva es convexa, negativo donde es cóncava.",
        )),
        text: two(
            "Radius of the circle that fits the profile best at the contact. Small is sharp: at 0 the cam has a point. *ρ min* in the verdict is the least where the cam is convex.",
            "Radio del círculo que mejor se ciñe al perfil en el contacto. Pequeño es agudo: en 0 la leva tiene una cúspide. El *ρ mín.* del veredicto es el menor donde la leva es convexa.",
        ),
        formula: Some("ρ = ρ_p - R_f"),
        drawing: Some(("mechanism", "rho")),
        theory: "radius",
    },
    Term {
        id: "contact",
        symbol: "q",
        name: two("Place of the contact on the face", "Posición del contacto en la cara"),
        unit: LENGTH,
        sign: Some(two(
            "To the right of the axis when the follower translates; away from the pivot when it oscillates.",
            "A la derecha del eje si el seguidor es de traslación; alejándose de la articulación si es oscilante.",
        )),
        text: two(
            "Where the cam touches a flat face: it walks as the cam turns.",
            "Dónde toca la leva a una cara plana: se pasea al girar la leva.",
        ),
        formula: Some("q = σv"),
        drawing: Some(("flat", "contact")),
        theory: "translating-flat",
    },
    Term {
        id: "face",
        name: two("Face length", "Longitud de la cara"),
        unit: LENGTH,
        text: two(
            "The least that the flat face must measure so that the contact never leaves it; a margin on each side is wise. An oscillating face is measured from the foot of the perpendicular from its pivot.",
            "Lo mínimo que debe medir la cara plana para que el contacto no se salga de ella; conviene un margen a cada lado. La cara oscilante se mide desde el pie de la perpendicular trazada desde su articulación.",
        ),
        formula: Some("v_(max) - v_(min)"),
        drawing: Some(("flat", "face")),
        theory: "translating-flat",
        ..PLAIN
    },
    Term {
        id: "sliding",
        symbol: "u",
        name: two("Sliding at the contact", "Deslizamiento en el contacto"),
        unit: two("length/rad; times $ω$, a speed", "longitud/rad; por $ω$, una velocidad"),
        sign: Some(two(
            "Along the tangent, a quarter turn counter-clockwise from the normal.",
            "Según la tangente, un cuarto de vuelta antihorario desde la normal.",
        )),
        text: two(
            "Velocity of the follower's body over the cam along the tangent. With a roller it is the speed at which the roller turns on its pin; without one, it is wear and heat.",
            "Velocidad del cuerpo del seguidor sobre la leva según la tangente. Con rodillo es la velocidad con que gira el rodillo en su eje; sin él, es desgaste y calor.",
        ),
        drawing: Some(("flat", "sliding")),
        theory: "translating-flat",
        ..PLAIN
    },
];
