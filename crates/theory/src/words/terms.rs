//! Every magnitude: symbol, name, unit, sign and definition. The page's question marks show these.

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
    Group { name: two("Cam and follower", "Leva y seguidor"), terms: GEOMETRY },
    Group { name: two("Motion program", "Programa de movimiento"), terms: PROGRAM },
    Group { name: two("Motion", "Movimiento"), terms: MOTION },
    Group { name: two("Contact", "Contacto"), terms: CONTACT },
    Group { name: two("What is drawn on the mechanism", "Lo que se dibuja sobre el mecanismo"), terms: LAYERS },
    Group { name: two("Other kinds of cam", "Otras clases de leva"), terms: KINDS },
];

const GEOMETRY: &[Term] = &[
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

const PROGRAM: &[Term] = &[
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
            "Measured angles from the start of the segment, with their heights. They can be pasted from a spreadsheet.",
            "Ángulos medidos desde el comienzo del tramo, con sus alturas. Se pueden pegar desde una hoja de cálculo.",
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
            "Height above the base circle as an expression of $x$, $θ$, $β$ and $L$; products need no sign. Its angles are radians, $s$ and $L$ of a follower that swings too. Its derivatives are exact.",
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

const MOTION: &[Term] = &[
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

const CONTACT: &[Term] = &[
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
            "The least that the flat face must measure so that the contact never leaves it; a margin on each side is wise.",
            "Lo mínimo que debe medir la cara plana para que el contacto no se salga de ella; conviene un margen a cada lado.",
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

const LAYERS: &[Term] = &[
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

const KINDS: &[Term] = &[
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

/// The term of that name.
#[must_use]
pub fn term(id: &str) -> Option<&'static Term> {
    GROUPS.iter().flat_map(|group| group.terms).find(|term| term.id == id)
}
