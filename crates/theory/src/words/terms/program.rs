//! The motion program.

use super::{DEGREES, LENGTH, PLAIN, Term};
use crate::words::two;

pub(super) const TERMS: &[Term] = &[
    Term {
        id: "law",
        name: two("Motion law", "Ley de movimiento"),
        text: two(
            "How the follower goes from one height to the next: a curve $y(x)$ from (0, 0) to (1, 1), stretched to $β$ and $L$. The small curve in each row is its acceleration.",
            "Cómo pasa el seguidor de una altura a la siguiente: una curva $y(x)$ de (0, 0) a (1, 1), estirada a $β$ y $L$. La curva pequeña de cada fila es su aceleración.",
        ),
        formula: Some("s = s_0 + L y(x), x = θ/β"),
        drawing: Some(("motion", "s")),
        theory: "laws",
        ..PLAIN
    },
    Term {
        id: "beta",
        symbol: "β",
        name: two("Angle of a segment", "Ángulo de un tramo"),
        unit: DEGREES,
        text: two(
            "Angle of the cam that the segment spans. All of them add up to 360°.",
            "Ángulo de la leva que abarca el tramo. Todos suman 360°.",
        ),
        drawing: Some(("motion", "beta")),
        ..PLAIN
    },
    Term {
        id: "rise",
        symbol: "L",
        name: two("Rise of a segment", "Elevación de un tramo"),
        unit: two("length; degrees when the follower oscillates", "longitud; grados si el seguidor es oscilante"),
        sign: Some(two(
            "Positive for a rise, negative for a return.",
            "Positiva en una subida, negativa en un retorno.",
        )),
        text: two(
            "Height that the follower gains over the segment. All of them add up to zero.",
            "Altura que gana el seguidor en el tramo. Todas suman cero.",
        ),
        drawing: Some(("motion", "rise")),
        ..PLAIN
    },
    Term {
        id: "b",
        symbol: "b",
        name: two("Sine share", "Parte de seno"),
        text: two(
            "Share of an SCCA segment with sine acceleration, half of it at each end. With none the acceleration jumps beside a dwell.",
            "Parte de un tramo SCCA con aceleración senoidal, la mitad en cada extremo. Si es nula, la aceleración salta junto a un detenimiento.",
        ),
        formula: Some("b + c + d = 1"),
        drawing: Some(("scca", "b")),
        theory: "scca",
        ..PLAIN
    },
    Term {
        id: "c",
        symbol: "c",
        name: two("Constant share", "Parte constante"),
        text: two(
            "Share of an SCCA segment with constant acceleration, half of it on each side of the middle. What is left, $d$, is a cosine.",
            "Parte de un tramo SCCA con aceleración constante, la mitad a cada lado del centro. Lo que queda, $d$, es un coseno.",
        ),
        formula: Some("d = 1 - b - c"),
        drawing: Some(("scca", "c")),
        theory: "scca",
        ..PLAIN
    },
    Term {
        id: "crossover",
        symbol: "x_c",
        name: two("Crossover", "Cruce"),
        text: two(
            "Part of $β$ at which the acceleration of a skewed law changes sign and the velocity is greatest; ½ in a symmetrical one. The peaks on both sides are as $(1 - x_c)$ to $x_c$.",
            "Parte de $β$ en la que la aceleración de una ley asimétrica cambia de signo y la velocidad es máxima; ½ en una simétrica. Los máximos a ambos lados son como $(1 - x_c)$ a $x_c$.",
        ),
        theory: "skewed-scca",
        ..PLAIN
    },
    Term {
        id: "beta1",
        symbol: "β_1",
        name: two("Angle of the first parabola", "Ángulo de la primera parábola"),
        unit: DEGREES,
        text: two(
            "Angle over which the speed of a modified uniform motion grows evenly, from rest to that of the straight line.",
            "Ángulo durante el que crece uniformemente la velocidad de un movimiento uniforme modificado, del reposo a la de la recta.",
        ),
        formula: Some("β_1 + β_2 + β_3 = β"),
        theory: "parabolic-blend",
        ..PLAIN
    },
    Term {
        id: "beta3",
        symbol: "β_3",
        name: two("Angle of the last parabola", "Ángulo de la última parábola"),
        unit: DEGREES,
        text: two(
            "Angle over which the speed of a modified uniform motion falls evenly, from that of the straight line to rest.",
            "Ángulo durante el que decrece uniformemente la velocidad de un movimiento uniforme modificado, de la de la recta al reposo.",
        ),
        formula: Some("β_1 + β_2 + β_3 = β"),
        theory: "parabolic-blend",
        ..PLAIN
    },
    Term {
        id: "degree",
        symbol: "n",
        name: two("Degree of a spline", "Grado de una spline"),
        text: two(
            "Degree of the polynomials that make up the curve, from 4 to 8. With 5 or more the jerk is smooth at the knots too.",
            "Grado de los polinomios que forman la curva, de 4 a 8. Con 5 o más también la sobreaceleración es suave en los nudos.",
        ),
        theory: "bspline",
        ..PLAIN
    },
    Term {
        id: "knots",
        symbol: "θ_k",
        name: two("Knots of a spline", "Nudos de una spline"),
        unit: DEGREES,
        text: two(
            "Where the polynomials of a B-spline join, from the start of the segment. Left out, each is the mean of as many neighbouring conditions as the degree. Knots close together let the curve turn faster there; each condition must lie within its own B-spline (Schoenberg and Whitney).",
            "Donde se unen los polinomios de una B-spline, desde el comienzo del tramo. Si no se dan, cada uno es la media de tantas condiciones vecinas como indica el grado. Unos nudos próximos dejan que la curva cambie allí más deprisa; cada condición debe caer dentro de su propia B-spline (Schoenberg y Whitney).",
        ),
        theory: "bspline",
        ..PLAIN
    },
    Term {
        id: "smoothing",
        symbol: "δ",
        name: two("Smoothing of a table", "Suavizado de una tabla"),
        unit: LENGTH,
        text: two(
            "How far the curve may pass from the measured points: the root mean square of the residuals at the inner points. Of all such curves it is the one with the least jerk. With 0 it goes through them all. A good value is the error of the measurement.",
            "Cuánto puede separarse la curva de los puntos medidos: la media cuadrática de los residuos en los puntos interiores. De todas las curvas así es la de menor sobreaceleración. Con 0 pasa por todos. Un buen valor es el error de medida.",
        ),
        theory: "table",
        ..PLAIN
    },
    Term {
        id: "points",
        symbol: "θ_k, s_k",
        name: two("Table of points", "Tabla de puntos"),
        unit: two("degrees and length", "grados y longitud"),
        text: two(
            "Measured angles from the start of the segment, with their heights. They can be pasted from a spreadsheet or a cam editor, or opened as a file; more points than are needed are reduced within a residual that you choose.",
            "Ángulos medidos desde el comienzo del tramo, con sus alturas. Se pueden pegar desde una hoja de cálculo o un editor de levas, o abrir como archivo; si hay más puntos de los necesarios, se reducen con el residuo que usted elija.",
        ),
        theory: "table",
        ..PLAIN
    },
    Term {
        id: "ordinates",
        symbol: "p_k",
        name: two("Ordinates of a Bézier curve", "Ordenadas de una curva de Bézier"),
        unit: LENGTH,
        text: two(
            "Heights at even steps that draw the curve towards them; it goes through the first and the last. Three equal ones at an end are a rest there.",
            "Alturas a pasos iguales que atraen la curva; esta pasa por la primera y por la última. Tres iguales en un extremo son allí un reposo.",
        ),
        formula: Some("y = p_0 (1 - x)^n + n p_1 x (1 - x)^(n - 1) + … + p_n x^n"),
        theory: "bezier",
        ..PLAIN
    },
    Term {
        id: "expression",
        symbol: "s",
        name: two("Formula of a segment", "Fórmula de un tramo"),
        unit: LENGTH,
        text: two(
            "Height above the base circle as an expression of $x$, $θ$, $β$ and $L$; products need no sign. Its angles are radians, $s$ and $L$ of an oscillating follower too. Its derivatives are exact.",
            "Altura sobre la circunferencia base como expresión de $x$, $θ$, $β$ y $L$; los productos no necesitan signo. Sus ángulos van en radianes, también $s$ y $L$ de un seguidor oscilante. Sus derivadas son exactas.",
        ),
        formula: Some("s = f(x, θ, β, L)"),
        theory: "formula",
        ..PLAIN
    },
    Term {
        id: "conditions",
        name: two("Conditions of a polynomial", "Condiciones de un polinomio"),
        text: two(
            "What the motion must do at given places: a height, a velocity, an acceleration or a jerk. An empty cell leaves it free. With $n$ conditions the polynomial has degree $n - 1$.",
            "Lo que debe cumplir el movimiento en ciertos lugares: una altura, una velocidad, una aceleración o una sobreaceleración. Una celda vacía lo deja libre. Con $n$ condiciones el polinomio es de grado $n - 1$.",
        ),
        formula: Some("s = c_0 + c_1 x + c_2 x^2 + … + c_(n−1) x^(n - 1)"),
        theory: "polynomial",
        ..PLAIN
    },
];
