//! Cam and follower.

use super::{DEGREES, LENGTH, PLAIN, Term};
use crate::words::two;

pub(super) const TERMS: &[Term] = &[
    Term {
        id: "follower",
        name: two("Follower", "Seguidor"),
        text: two(
            "What touches the cam and does the work. It *translates* along an axis or *oscillates* about a pivot, and touches with a roller, a knife edge, a curved face or a flat face.",
            "Lo que toca la leva y hace el trabajo. Se *traslada* según un eje u *oscila* alrededor de una articulación, y toca con un rodillo, una cuchilla, una cara curva o una cara plana.",
        ),
        drawing: Some(("translating-roller", "")),
        theory: "translating-roller",
        ..PLAIN
    },
    Term {
        id: "base_radius",
        symbol: "R_b",
        name: two("Base radius", "Radio base"),
        unit: LENGTH,
        text: two(
            "Radius of the base circle, the largest circle about the cam's centre that fits inside the profile: there the follower rests with $s = 0$.",
            "Radio de la circunferencia base, la mayor circunferencia con centro en el de la leva que cabe dentro del perfil: en ella el seguidor reposa con $s = 0$.",
        ),
        drawing: Some(("translating-roller", "base_radius")),
        theory: "sizing",
        ..PLAIN
    },
    Term {
        id: "roller_radius",
        symbol: "R_f",
        name: two("Roller radius", "Radio del rodillo"),
        unit: LENGTH,
        text: two(
            "Radius of the roller. The profile is the pitch curve moved inwards by it; a roller larger than the least $ρ_p$ undercuts the cam.",
            "Radio del rodillo. El perfil es la curva de paso llevada hacia dentro esa distancia; un rodillo mayor que el mínimo $ρ_p$ deja la leva rebajada.",
        ),
        formula: Some("R_p = R_b + R_f"),
        drawing: Some(("translating-roller", "roller_radius")),
        theory: "translating-roller",
        ..PLAIN
    },
    Term {
        id: "face_radius",
        symbol: "R_f",
        name: two("Face radius", "Radio de la cara"),
        unit: LENGTH,
        text: two(
            "Radius of the arc that slides on the cam. It counts as a roller of that size that does not turn.",
            "Radio del arco que desliza sobre la leva. Equivale a un rodillo de ese tamaño que no gira.",
        ),
        drawing: Some(("translating-curved", "face_radius")),
        theory: "translating-curved",
        ..PLAIN
    },
    Term {
        id: "eccentricity",
        symbol: "e",
        name: two("Eccentricity", "Excentricidad"),
        unit: LENGTH,
        sign: Some(two(
            "Positive when the axis is to the right of the cam's centre.",
            "Positiva cuando el eje está a la derecha del centro de la leva.",
        )),
        text: two(
            "Distance from the cam's centre to the axis of the follower. With a counter-clockwise cam a positive one lowers the pressure angle of the rise and raises that of the return.",
            "Distancia del centro de la leva al eje del seguidor. Con una leva antihoraria, si es positiva baja el ángulo de presión de la subida y aumenta el del retorno.",
        ),
        formula: Some("tan(φ) = (v - σe)/(s_0 + s)"),
        drawing: Some(("translating-roller", "eccentricity")),
        theory: "pressure-angle",
    },
    Term {
        id: "face_angle",
        symbol: "γ",
        name: two("Face angle", "Ángulo de la cara"),
        unit: DEGREES,
        sign: Some(two(
            "Positive when the face is turned counter-clockwise from the horizontal.",
            "Positivo cuando la cara está girada en sentido antihorario respecto a la horizontal.",
        )),
        text: two(
            "Inclination of the flat face. It is also the pressure angle, the same over the whole turn.",
            "Inclinación de la cara plana. Es también el ángulo de presión, igual en toda la vuelta.",
        ),
        formula: Some("φ = σγ"),
        drawing: Some(("translating-flat", "face_angle")),
        theory: "translating-flat",
    },
    Term {
        id: "arm",
        symbol: "A",
        name: two("Arm", "Brazo"),
        unit: LENGTH,
        text: two("From the pivot to the centre of the roller.", "De la articulación al centro del rodillo."),
        drawing: Some(("oscillating-roller", "arm")),
        theory: "oscillating-roller",
        ..PLAIN
    },
    Term {
        id: "pivot_distance",
        symbol: "m",
        name: two("Pivot distance", "Distancia a la articulación"),
        unit: LENGTH,
        text: two(
            "From the cam's centre to the pivot. With $A$ and $R_p$ it must make a triangle.",
            "Del centro de la leva a la articulación. Con $A$ y $R_p$ debe formar un triángulo.",
        ),
        formula: Some("|m - A| < R_p < m + A"),
        drawing: Some(("oscillating-roller", "pivot_distance")),
        theory: "oscillating-roller",
        ..PLAIN
    },
    Term {
        id: "pivot_angle",
        symbol: "ψ",
        name: two("Pivot angle", "Ángulo de la articulación"),
        unit: DEGREES,
        sign: Some(two(
            "Counter-clockwise from the horizontal to the right.",
            "En sentido antihorario desde la horizontal hacia la derecha.",
        )),
        text: two(
            "Direction of the pivot seen from the cam's centre. It turns the whole follower about the cam and changes nothing else.",
            "Dirección de la articulación vista desde el centro de la leva. Gira todo el seguidor alrededor de la leva y no cambia nada más.",
        ),
        drawing: Some(("oscillating-roller", "pivot_angle")),
        theory: "oscillating-roller",
        ..PLAIN
    },
    Term {
        id: "face_offset",
        symbol: "f",
        name: two("Face offset", "Descentrado de la cara"),
        unit: LENGTH,
        sign: Some(two(
            "Positive when the face lies beyond the pivot, away from the cam.",
            "Positivo cuando la cara queda más allá de la articulación, lejos de la leva.",
        )),
        text: two(
            "Distance from the pivot to the line of the face.",
            "Distancia de la articulación a la recta de la cara.",
        ),
        formula: Some("sin(ξ_0) = (R_b - f)/m"),
        drawing: Some(("oscillating-flat", "face_offset")),
        theory: "oscillating-flat",
    },
    Term {
        id: "speed",
        symbol: "ω",
        name: two("Speed", "Velocidad de la leva"),
        unit: two("rad/s, rpm or rev/s", "rad/s, rpm o rev/s"),
        text: two(
            "Angular velocity of the cam, constant. The geometry does not depend on it; the derivatives by time do.",
            "Velocidad angular de la leva, constante. La geometría no depende de ella; las derivadas respecto al tiempo, sí.",
        ),
        formula: Some("V = vω, A = aω^2, J = jω^3"),
        drawing: Some(("mechanism", "theta")),
        ..PLAIN
    },
    Term {
        id: "rotation",
        symbol: "σ",
        name: two("Rotation", "Sentido de giro"),
        sign: Some(two("$σ = +1$ counter-clockwise, $σ = -1$ clockwise.", "$σ = +1$ antihorario, $σ = -1$ horario.")),
        text: two(
            "The sense in which the cam turns. Turning it the other way mirrors the profile; with eccentricity or an arm it also changes the pressure angle.",
            "El sentido en que gira la leva. Si se invierte, el perfil es su simétrico; con excentricidad o con brazo cambia además el ángulo de presión.",
        ),
        drawing: Some(("mechanism", "theta")),
        theory: "inversion",
        ..PLAIN
    },
];
