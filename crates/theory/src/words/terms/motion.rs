//! The motion and its derivatives.

use super::{DEGREES, PLAIN, Term};
use crate::words::two;

pub(super) const TERMS: &[Term] = &[
    Term {
        id: "theta",
        symbol: "θ",
        name: two("Cam angle", "Ángulo de la leva"),
        unit: DEGREES,
        sign: Some(two(
            "It grows as the cam turns, in whichever sense.",
            "Crece al girar la leva, sea cual sea el sentido.",
        )),
        text: two(
            "How far the cam has turned since the beginning of the first segment. One cursor $θ$ moves mechanism, diagrams and figures together.",
            "Lo que ha girado la leva desde el comienzo del primer tramo. Un único cursor $θ$ mueve a la vez el mecanismo, los diagramas y los valores.",
        ),
        drawing: Some(("mechanism", "theta")),
        ..PLAIN
    },
    Term {
        id: "t",
        symbol: "t",
        name: two("Time", "Tiempo"),
        unit: two("seconds", "segundos"),
        text: two("Time since $θ = 0$ at the speed of the design.", "Tiempo desde $θ = 0$ a la velocidad del diseño."),
        formula: Some("t = θ/ω"),
        drawing: Some(("mechanism", "theta")),
        ..PLAIN
    },
    Term {
        id: "s",
        symbol: "s",
        name: two("Displacement", "Desplazamiento"),
        unit: two("length; degrees when the follower oscillates", "longitud; grados si el seguidor es oscilante"),
        sign: Some(two(
            "Positive away from the cam; 0 on the base circle.",
            "Positivo al alejarse de la leva; 0 sobre la circunferencia base.",
        )),
        text: two(
            "How far the follower is from where it rests on the base circle. *s max* is the whole lift.",
            "Lo que se ha separado el seguidor de su reposo en la circunferencia base. *s máx.* es la elevación total.",
        ),
        drawing: Some(("mechanism", "s")),
        ..PLAIN
    },
    Term {
        id: "v",
        symbol: "v, V",
        name: two("Velocity", "Velocidad"),
        unit: two("$v$: length/rad; $V$: length/s", "$v$: longitud/rad; $V$: longitud/s"),
        sign: Some(two("Positive in a rise.", "Positiva en una subida.")),
        text: two(
            "Slope of the displacement diagram. If it jumps, the follower is struck.",
            "Pendiente del diagrama de desplazamientos. Si salta, el seguidor recibe un golpe.",
        ),
        formula: Some("v = (d s)/(d θ), V = vω"),
        drawing: Some(("motion", "v")),
        ..PLAIN
    },
    Term {
        id: "a",
        symbol: "a, A",
        name: two("Acceleration", "Aceleración"),
        unit: two("$a$: length/rad²; $A$: length/s²", "$a$: longitud/rad²; $A$: longitud/s²"),
        sign: Some(two("Positive when the velocity grows.", "Positiva cuando la velocidad crece.")),
        text: two(
            "The inertia force of the follower is its mass times $A$. If it jumps, the force jumps and the follower vibrates.",
            "La fuerza de inercia del seguidor es su masa por $A$. Si salta, salta la fuerza y el seguidor vibra.",
        ),
        formula: Some("a = (d^2 s)/(d θ^2), A = aω^2"),
        drawing: Some(("motion", "a")),
        theory: "fundamental-law",
    },
    Term {
        id: "j",
        symbol: "j, J",
        name: two("Jerk", "Sobreaceleración"),
        unit: two("$j$: length/rad³; $J$: length/s³", "$j$: longitud/rad³; $J$: longitud/s³"),
        sign: Some(two("Positive when the acceleration grows.", "Positiva cuando la aceleración crece.")),
        text: two(
            "How fast the force changes. If it jumps, the cam is not for high speeds.",
            "La rapidez con que cambia la fuerza. Si salta, la leva no es apta para altas velocidades.",
        ),
        formula: Some("j = (d^3 s)/(d θ^3), J = jω^3"),
        drawing: Some(("motion", "j")),
        theory: "fundamental-law",
    },
    Term {
        id: "opening",
        symbol: "ξ_0",
        name: two("Opening at rest", "Abertura en reposo"),
        unit: DEGREES,
        text: two(
            "Angle at the pivot between the line of centres and the arm, or the flat face, at $s = 0$. The follower stands at $ξ_0 + s$.",
            "Ángulo en la articulación entre la línea de centros y el brazo, o la cara plana, con $s = 0$. El seguidor está en $ξ_0 + s$.",
        ),
        formula: Some("cos(ξ_0) = (m^2 + A^2 - R_p^2)/(2mA)"),
        drawing: Some(("oscillating-roller", "arm")),
        theory: "oscillating-roller",
        ..PLAIN
    },
];
