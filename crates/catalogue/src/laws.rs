//! The row of every law. To add a law, add its row here; see *How to add a law* in `ARCHITECTURE.md`.

use crate::check::{has_one_row_in_the_catalogue, have_codes_of_their_own};
use crate::label::{find, labels_of};
use crate::{Label, Name, Two, Version, two};
use levalab_core::Law;
use levalab_core::law::{CIRCULAR_ARC, Group};

/// A law.
pub struct LawRow {
    /// The law's id in the core and in files.
    pub id: &'static str,
    /// Its code in a link: a capital, and a small letter where several laws are of one family. Never given to another law.
    pub link: &'static str,
    /// The first version of file and link that knows it.
    pub since: Version,
    /// Its name.
    pub name: Name,
    /// The idea in a sentence or two.
    pub idea: Two,
    /// When to take it, and when not.
    pub advice: Two,
    /// Formulas of a law whose curve depends on given data, one per line; empty for other laws, whose formulas are printed from their curves.
    pub formulas: &'static [&'static str],
    /// The book; `None` for a derivation of our own.
    pub source: Option<&'static str>,
}

const NORTON: Option<&str> = Some("R. L. Norton, Cam Design and Manufacturing Handbook");
const ROTHBART: Option<&str> = Some("H. A. Rothbart, Cam Design Handbook");
const SHIGLEY: Option<&str> = Some("J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms");
const CHEN: Option<&str> = Some("F. Y. Chen, Mechanics and Design of Cam Mechanisms");

/// The row of a law.
#[must_use]
pub fn law_row(law: &Law) -> Option<&'static LawRow> {
    LAWS.iter().find(|row| row.id == law.id)
}

/// The names and the code of a law.
#[must_use]
pub fn law_label(law: &Law) -> Option<&'static Label> {
    find(&LABELS, law.id)
}

/// The id of a group of laws, and its heading in a menu.
#[must_use]
pub const fn law_group(group: Group) -> (&'static str, Two) {
    match group {
        Group::Basic => ("basic", two("Basic", "Básicas")),
        Group::Standard => ("standard", two("Standard", "Normalizadas")),
        Group::Half => ("half", two("Halves, to join stretches", "Mitades, para enlazar tramos")),
        Group::Matched => ("matched", two("Matched to their neighbours", "Ajustadas a sus vecinas")),
        Group::Free => ("free", two("Free", "Libres")),
    }
}

/// Every law that the core lists, and the circular arc, of which some cams of constant breadth are made.
pub const LAWS: &[LawRow] = &[
    LawRow {
        id: "dwell",
        link: "D",
        since: Version::One,
        name: Name {
            noun: two("dwell", "de detenimiento"),
            alone: two("dwell", "detenimiento"),
            menu: two("Dwell", "Detenimiento"),
        },
        idea: two(
            "The follower stays at its height while the cam turns: the profile is an arc about the cam's centre, and $v$, $a$ and $j$ are zero.",
            "El seguidor se queda a su altura mientras la leva gira: el perfil es un arco con centro en el de la leva, y $v$, $a$ y $j$ son nulas.",
        ),
        advice: two(
            "Wherever the machine needs time with the follower still. The moves on both sides must bring $v$ and $a$ to zero, and $j$ too if the cam turns fast.",
            "Donde la máquina necesita tiempo con el seguidor quieto. Los movimientos de ambos lados deben llevar a cero $v$ y $a$, y también $j$ si la leva gira deprisa.",
        ),
        formulas: &["s = s_0"],
        source: NORTON,
    },
    LawRow {
        id: "constant-velocity",
        link: "V",
        since: Version::One,
        name: Name {
            noun: two("constant velocity", "de velocidad constante"),
            alone: two("constant velocity", "velocidad constante"),
            menu: two("Constant velocity", "Velocidad constante"),
        },
        idea: two(
            "The straight line of the displacement diagram: equal angles give equal heights. A plate cam with a knife edge on its axis becomes a spiral of Archimedes.",
            "La recta del diagrama de desplazamientos: a ángulos iguales, alturas iguales. Una leva de placa con cuchilla centrada se convierte en una espiral de Arquímedes.",
        ),
        advice: two(
            "Where a process asks for it (a saw, a scanner, a winder). Never beside a dwell: the velocity would jump, which means an infinite acceleration: an impact. Join it with half motions or with polynomials that match their neighbours.",
            "Donde lo pide el proceso (una sierra, un lector, una bobinadora). Nunca junto a un detenimiento: la velocidad saltaría, lo que supone una aceleración infinita, un golpe. Se enlaza con semimovimientos o con polinomios ajustados a sus vecinos.",
        ),
        formulas: &[],
        source: SHIGLEY,
    },
    LawRow {
        id: "parabolic",
        link: "P",
        since: Version::One,
        name: Name {
            noun: two("parabolic", "parabólica"),
            alone: two("parabolic", "parabólica"),
            menu: two("Parabolic", "Parabólica"),
        },
        idea: two(
            "Constant acceleration over the first half and the same deceleration over the second: of all laws between two rests it has the lowest peak acceleration.",
            "Aceleración constante en la primera mitad e igual deceleración en la segunda: de todas las leyes entre dos reposos es la de menor aceleración máxima.",
        ),
        advice: two(
            "As a lesson. The acceleration jumps at both ends and, twice as much, in the middle: the follower is shaken three times in every move. Handouts often print the second half with a plus sign; it is $y = 1 - 2(1 - x)^2$.",
            "Como lección. La aceleración salta en los dos extremos y, el doble, en el centro: el seguidor se sacude tres veces en cada movimiento. En muchos apuntes la segunda mitad aparece con signo más; es $y = 1 - 2(1 - x)^2$.",
        ),
        formulas: &[],
        source: SHIGLEY,
    },
    LawRow {
        id: "parabolic-blend",
        link: "Pb",
        since: Version::One,
        name: Name {
            noun: two("modified uniform (parabola, line, parabola)", "uniforme modificada (parábola, recta, parábola)"),
            alone: two(
                "modified uniform (parabola, line, parabola)",
                "uniforme modificada (parábola, recta, parábola)",
            ),
            menu: two("Modified uniform", "Uniforme modificada"),
        },
        idea: two(
            "A straight stretch between two arcs of parabola (modified uniform motion): the speed rises evenly over $β_1$, stays over $β_2$ and falls evenly over $β_3$.",
            "Un tramo recto entre dos arcos de parábola (movimiento uniforme modificado): la velocidad crece uniformemente durante $β_1$, se mantiene durante $β_2$ y decrece uniformemente durante $β_3$.",
        ),
        advice: two(
            "For a long stretch of nearly constant velocity at low speed. The velocity is continuous, the acceleration is not: it jumps at the four borders.",
            "Para un tramo largo a velocidad casi constante y a baja velocidad. La velocidad es continua y la aceleración no: salta en las cuatro fronteras.",
        ),
        formulas: &[
            "v_(max) = L/(β_1/2 + β_2 + β_3/2)",
            "s = s_0 + (v_(max) θ^2)/(2β_1), θ ≤ β_1",
            "s = s_0 + v_(max) (θ - β_1/2), β_1 ≤ θ ≤ β_1 + β_2",
            "s = s_0 + L - (v_(max) (β - θ)^2)/(2β_3), θ ≥ β_1 + β_2",
        ],
        source: ROTHBART,
    },
    LawRow {
        id: "cubic-1",
        link: "K",
        since: Version::One,
        name: Name {
            noun: two("cubic 1", "cúbica 1"),
            alone: two("cubic 1", "cúbica 1"),
            menu: two("Cubic 1", "Cúbica 1"),
        },
        idea: two(
            "The constant pulse of the first kind: the jerk is the same all along, so that the acceleration grows evenly from zero, swings to its opposite in the middle and comes back to zero.",
            "El pulso constante de primera especie: la sobreaceleración es la misma en todo el tramo, de modo que la aceleración crece uniformemente desde cero, pasa a la opuesta en el centro y vuelve a cero.",
        ),
        advice: two(
            "Hardly ever: soft at the ends, but the step of acceleration in the middle, from +12 to −12, is the largest of the usual laws.",
            "Casi nunca: es suave en los extremos, pero el escalón de aceleración del centro, de +12 a −12, es el mayor de las leyes usuales.",
        ),
        formulas: &[],
        source: ROTHBART,
    },
    LawRow {
        id: "cubic-2",
        link: "Kb",
        since: Version::One,
        name: Name {
            noun: two("cubic 2", "cúbica 2"),
            alone: two("cubic 2", "cúbica 2"),
            menu: two("Cubic 2", "Cúbica 2"),
        },
        idea: two(
            "The constant pulse of the second kind: one cubic for the whole move. Its acceleration falls along a straight line from +6 to −6.",
            "El pulso constante de segunda especie: una sola cúbica para todo el movimiento. Su aceleración decrece en línea recta de +6 a −6.",
        ),
        advice: two(
            "When rise and return follow each other without dwells; beside a dwell its acceleration jumps.",
            "Cuando subida y retorno se siguen sin detenimientos; junto a un detenimiento su aceleración salta.",
        ),
        formulas: &[],
        source: ROTHBART,
    },
    LawRow {
        id: "simple-harmonic",
        link: "H",
        since: Version::One,
        name: Name {
            noun: two("simple harmonic", "armónica simple"),
            alone: two("simple harmonic", "armónica simple"),
            menu: two("Simple harmonic", "Armónica simple"),
        },
        idea: two(
            "The height of a point that goes round a circle: half a wave of cosine. It is what an eccentric circle gives a flat face.",
            "La altura de un punto que recorre una circunferencia: media onda de coseno. Es lo que una excéntrica circular da a un plato plano.",
        ),
        advice: two(
            "Rise 180° and return 180° with nothing between: then every derivative is continuous. Beside a dwell its acceleration jumps by $π^2/2$.",
            "Subida de 180° y retorno de 180° sin nada en medio: entonces todas las derivadas son continuas. Junto a un detenimiento su aceleración salta $π^2/2$.",
        ),
        formulas: &[],
        source: SHIGLEY,
    },
    LawRow {
        id: "double-harmonic",
        link: "Hd",
        since: Version::One,
        name: Name {
            noun: two("double harmonic", "doble armónica"),
            alone: two("double harmonic", "doble armónica"),
            menu: two("Double harmonic", "Doble armónica"),
        },
        idea: two(
            "Two harmonics, the second a quarter as high. It starts as smoothly as can be ($a$ is zero there) and ends with a strong deceleration; the return is the rise reversed in $x$.",
            "Dos armónicos, el segundo con la cuarta parte de altura. Arranca con toda suavidad (allí $a$ es nula) y acaba con una fuerte deceleración; el retorno es la subida invertida en $x$.",
        ),
        advice: two(
            "Dwell, rise and return with only one dwell, below: above, rise and return join with the same acceleration.",
            "Detenimiento, subida y retorno con un único detenimiento, abajo: arriba, subida y retorno se unen con la misma aceleración.",
        ),
        formulas: &[],
        source: CHEN,
    },
    LawRow {
        id: "cycloidal",
        link: "C",
        since: Version::One,
        name: Name {
            noun: two("cycloidal", "cicloidal"),
            alone: two("cycloidal", "cicloidal"),
            menu: two("Cycloidal", "Cicloidal"),
        },
        idea: two(
            "The point of a circle that rolls along the axis of heights: a full sine wave of acceleration. It is the SCCA law with $b = d = 1/2$ and $c = 0$.",
            "El punto de una circunferencia que rueda sobre el eje de alturas: una onda senoidal completa de aceleración. Es la ley SCCA con $b = d = 1/2$ y $c = 0$.",
        ),
        advice: two(
            "The safe choice between dwells: $v$ and $a$ are zero at both ends. Its jerk is not, so that for high speeds the 4-5-6-7 is smoother; its peak velocity asks for a larger base circle than a modified sine.",
            "La elección segura entre detenimientos: $v$ y $a$ son nulas en los dos extremos. Su sobreaceleración no lo es, así que a altas velocidades es más suave la 4-5-6-7; su velocidad máxima pide una circunferencia base mayor que la del seno modificado.",
        ),
        formulas: &[],
        source: NORTON,
    },
    LawRow {
        id: "freudenstein-1-3-5",
        link: "W",
        since: Version::Two,
        name: Name {
            noun: two("Freudenstein 1-3-5", "de Freudenstein 1-3-5"),
            alone: two("Freudenstein 1-3-5", "Freudenstein 1-3-5"),
            menu: two("Freudenstein 1-3-5", "Freudenstein 1-3-5"),
        },
        idea: two(
            "A cycloidal with a third and a fifth harmonic, which flatten its acceleration: the peak falls from 6.28 to 5.06, and that of the velocity stays at 2.",
            "Una cicloidal con un tercer y un quinto armónico, que aplanan su aceleración: el máximo baja de 6,28 a 5,06 y el de la velocidad sigue en 2.",
        ),
        advice: two(
            "Between dwells, where the inertia force matters and few harmonics may reach the machine: it holds the first, the third and the fifth and no others. Its jerk jumps at the ends by more than that of the cycloidal.",
            "Entre detenimientos, cuando importa la fuerza de inercia y a la máquina deben llegar pocos armónicos: contiene el primero, el tercero y el quinto, y ningún otro. Su sobreaceleración salta en los extremos más que la de la cicloidal.",
        ),
        formulas: &[
            "y = x - (1125)/(2384π) (sin(2π x) + (sin(6π x))/54 + (sin(10π x))/1250)",
            "y' = 1 - (1125)/1192 (cos(2π x) + (cos(6π x))/18 + (cos(10π x))/250)",
            "y'' = (1125π)/596 (sin(2π x) + (sin(6π x))/6 + (sin(10π x))/50)",
            "y''' = (1125π^2)/298 (cos(2π x) + (cos(6π x))/2 + (cos(10π x))/10)",
        ],
        source: Some(
            "F. Freudenstein, On the dynamics of high-speed cam profiles, International Journal of Mechanical Sciences 1, 1960",
        ),
    },
    LawRow {
        id: "polynomial-3-4-5",
        link: "Q",
        since: Version::One,
        name: Name {
            noun: two("3-4-5 polynomial", "polinómica 3-4-5"),
            alone: two("3-4-5 polynomial", "polinómica 3-4-5"),
            menu: two("3-4-5 polynomial", "Polinómica 3-4-5"),
        },
        idea: two(
            "The polynomial of lowest degree with $v = a = 0$ at both ends: six conditions, three powers left.",
            "El polinomio de menor grado con $v = a = 0$ en los dos extremos: seis condiciones, quedan tres potencias.",
        ),
        advice: two(
            "Between dwells at moderate speeds: less peak acceleration than the cycloidal. Its jerk jumps at the ends by 60.",
            "Entre detenimientos a velocidades moderadas: menos aceleración máxima que la cicloidal. Su sobreaceleración salta 60 en los extremos.",
        ),
        formulas: &[],
        source: NORTON,
    },
    LawRow {
        id: "polynomial-4-5-6-7",
        link: "S",
        since: Version::One,
        name: Name {
            noun: two("4-5-6-7 polynomial", "polinómica 4-5-6-7"),
            alone: two("4-5-6-7 polynomial", "polinómica 4-5-6-7"),
            menu: two("4-5-6-7 polynomial", "Polinómica 4-5-6-7"),
        },
        idea: two(
            "The polynomial of lowest degree with $v = a = j = 0$ at both ends: eight conditions, four powers left.",
            "El polinomio de menor grado con $v = a = j = 0$ en los dos extremos: ocho condiciones, quedan cuatro potencias.",
        ),
        advice: two(
            "Between dwells at high speeds: nothing jumps up to the jerk. The price is the highest peak acceleration of the smooth laws.",
            "Entre detenimientos a altas velocidades: nada salta hasta la sobreaceleración. El precio es la mayor aceleración máxima de las leyes suaves.",
        ),
        formulas: &[],
        source: NORTON,
    },
    LawRow {
        id: "modified-trapezoidal",
        link: "T",
        since: Version::One,
        name: Name {
            noun: two("modified trapezoidal", "trapezoidal modificada"),
            alone: two("modified trapezoidal", "trapezoidal modificada"),
            menu: two("Modified trapezoidal", "Trapezoidal modificada"),
        },
        idea: two(
            "A trapezoid of acceleration with its corners rounded by sines: the SCCA law with $b = 1/4$, $c = 1/2$, $d = 1/4$.",
            "Un trapecio de aceleración con las esquinas redondeadas por senos: la ley SCCA con $b = 1/4$, $c = 1/2$, $d = 1/4$.",
        ),
        advice: two(
            "Heavy followers: the lowest peak acceleration, and so the lowest inertia force, of the usual laws with continuous acceleration.",
            "Seguidores pesados: la menor aceleración máxima, y por tanto la menor fuerza de inercia, de las leyes usuales con aceleración continua.",
        ),
        formulas: &[],
        source: NORTON,
    },
    LawRow {
        id: "modified-sine",
        link: "M",
        since: Version::One,
        name: Name {
            noun: two("modified sine", "de seno modificado"),
            alone: two("modified sine", "seno modificado"),
            menu: two("Modified sine", "Seno modificado"),
        },
        idea: two(
            "A short sine to begin, a long cosine in the middle, a short sine to end: the SCCA law with $b = 1/4$, $c = 0$, $d = 3/4$.",
            "Un seno corto al empezar, un coseno largo en el centro y un seno corto al acabar: la ley SCCA con $b = 1/4$, $c = 0$, $d = 3/4$.",
        ),
        advice: two(
            "Large masses and indexing tables: low peak velocity and kinetic energy, a torque that changes slowly, and the smallest cam for a given pressure angle.",
            "Grandes masas y mesas divisoras: velocidad máxima y energía cinética bajas, un par que cambia despacio y la leva más pequeña para un ángulo de presión dado.",
        ),
        formulas: &[],
        source: NORTON,
    },
    LawRow {
        id: "scca",
        link: "X",
        since: Version::One,
        name: Name { noun: two("SCCA", "SCCA"), alone: two("SCCA", "SCCA"), menu: two("SCCA", "SCCA") },
        idea: two(
            "A whole family, sine–constant–cosine acceleration. The acceleration grows as a sine over $b/2$, stays over $c/2$, swings to its opposite as a cosine over $d$ and mirrors what came before, with $b + c + d = 1$. Parabolic, harmonic, cycloidal, modified trapezoidal and modified sine are its points.",
            "Toda una familia, aceleración seno–constante–coseno. La aceleración crece como un seno en $b/2$, se mantiene en $c/2$, pasa a la opuesta como un coseno en $d$ y repite lo anterior al revés, con $b + c + d = 1$. La parabólica, la armónica, la cicloidal, la trapezoidal modificada y el seno modificado son puntos suyos.",
        ),
        advice: two(
            "To trade peak velocity for peak acceleration: more $c$ lowers the acceleration, more $d$ the velocity, more $b$ the jerk at the ends. With $b = 0$ the acceleration jumps beside a dwell.",
            "Para cambiar velocidad máxima por aceleración máxima: más $c$ baja la aceleración, más $d$ la velocidad y más $b$ la sobreaceleración de los extremos. Con $b = 0$ la aceleración salta junto a un detenimiento.",
        ),
        formulas: &[
            "C_a = (4π^2)/((π^2 - 8)(b^2 - d^2) - 2π(π - 2)b + π^2)",
            "y'' = C_a sin((πx)/b), 0 ≤ x ≤ b/2",
            "y'' = C_a, b/2 ≤ x ≤ (1 - d)/2",
            "y'' = C_a cos((π)/d (x - (1 - d)/2)), (1 - d)/2 ≤ x ≤ (1 + d)/2",
            "y'' = -C_a, (1 + d)/2 ≤ x ≤ 1 - b/2",
            "y'' = C_a sin((π)/b (x - 1)), 1 - b/2 ≤ x ≤ 1",
        ],
        source: NORTON,
    },
    LawRow {
        id: "skewed-scca",
        link: "Xs",
        since: Version::One,
        name: Name {
            noun: two("skewed SCCA", "SCCA asimétrica"),
            alone: two("skewed SCCA", "SCCA asimétrica"),
            menu: two("Skewed SCCA", "SCCA asimétrica"),
        },
        idea: two(
            "The SCCA family with its crossover, where the acceleration changes sign, moved from the middle to $x_c$: the first half is stretched to $x_c$ and the second to what is left. The peak velocity stays; the acceleration is multiplied by $1/(2x_c)$ and the deceleration by $1/(2(1 - x_c))$.",
            "La familia SCCA con el cruce, donde la aceleración cambia de signo, movido del centro a $x_c$: la primera mitad se estira hasta $x_c$ y la segunda en lo que queda. La velocidad máxima no cambia; la aceleración se multiplica por $1/(2x_c)$ y la deceleración por $1/(2(1 - x_c))$.",
        ),
        advice: two(
            "When a spring must hold the follower on the cam: with $x_c < 1/2$ a rise has a short, hard acceleration, which the cam pushes, and a long, gentle deceleration, which is the spring's, so that a lighter spring is enough. The jerk jumps at the crossover.",
            "Cuando un resorte debe mantener el seguidor sobre la leva: con $x_c < 1/2$ la subida tiene una aceleración corta y fuerte, que empuja la leva, y una deceleración larga y suave, que es cosa del resorte, y basta uno más blando. La sobreaceleración salta en el cruce.",
        ),
        formulas: &[
            "y = 2x_c Y(x/(2x_c)), 0 ≤ x ≤ x_c",
            "y = 1 - 2(1 - x_c)(1 - Y((1 + x - 2x_c)/(2(1 - x_c)))), x_c ≤ x ≤ 1",
            "C_v = C_(v,SCCA), C_a = C_(a,SCCA)/(2x_c), C_a = C_(a,SCCA)/(2(1 - x_c))",
        ],
        source: Some("R. L. Norton, Cam Design and Manufacturing Handbook; H. A. Rothbart, Cam Design Handbook"),
    },
    LawRow {
        id: "asymmetric-3-4-5",
        link: "Qa",
        since: Version::One,
        name: Name {
            noun: two("asymmetric 3-4-5", "3-4-5 asimétrica"),
            alone: two("asymmetric 3-4-5", "3-4-5 asimétrica"),
            menu: two("Asymmetric 3-4-5", "3-4-5 asimétrica"),
        },
        idea: two(
            "The 3-4-5 with its crossover moved from the middle to $x_c$: each half is stretched to its own part of $β$. Peak velocity 15/8 wherever the crossover lies; peaks of acceleration $10/sqrt(3)$ times $1/(2x_c)$ and $1/(2(1 - x_c))$.",
            "La 3-4-5 con el cruce movido del centro a $x_c$: cada mitad se estira en su parte de $β$. Velocidad máxima 15/8 esté donde esté el cruce; aceleraciones máximas $10/sqrt(3)$ por $1/(2x_c)$ y por $1/(2(1 - x_c))$.",
        ),
        advice: two(
            "As the skewed SCCA: to make the deceleration gentler than the acceleration, or the other way round, at moderate speeds. The jerk jumps at the ends and at the crossover.",
            "Como la SCCA asimétrica: para que la deceleración sea más suave que la aceleración, o al revés, a velocidades moderadas. La sobreaceleración salta en los extremos y en el cruce.",
        ),
        formulas: &[
            "y = 2x_c (10u^3 - 15u^4 + 6u^5), u = x/(2x_c), 0 ≤ x ≤ x_c",
            "y = 1 - 2(1 - x_c)(10u^3 - 15u^4 + 6u^5), u = (1 - x)/(2(1 - x_c)), x_c ≤ x ≤ 1",
        ],
        source: Some("R. L. Norton, Cam Design and Manufacturing Handbook; H. A. Rothbart, Cam Design Handbook"),
    },
    LawRow {
        id: "half-harmonic-start",
        link: "Ha",
        since: Version::One,
        name: Name {
            noun: two("half harmonic (start)", "semiarmónica (inicio)"),
            alone: two("half harmonic (start)", "semiarmónica (inicio)"),
            menu: two("Half harmonic (start)", "Semiarmónica (inicio)"),
        },
        idea: two(
            "The first half of a harmonic: from rest to full speed.",
            "La primera mitad de una armónica: del reposo a toda velocidad.",
        ),
        advice: two(
            "Before a stretch of constant velocity of the same slope, at low speed: the acceleration jumps at the start, beside a dwell, and is zero at the end.",
            "Antes de un tramo de velocidad constante con la misma pendiente, a baja velocidad: la aceleración salta al principio, junto a un detenimiento, y se anula al final.",
        ),
        formulas: &[],
        source: SHIGLEY,
    },
    LawRow {
        id: "half-harmonic-end",
        link: "Hb",
        since: Version::One,
        name: Name {
            noun: two("half harmonic (end)", "semiarmónica (final)"),
            alone: two("half harmonic (end)", "semiarmónica (final)"),
            menu: two("Half harmonic (end)", "Semiarmónica (final)"),
        },
        idea: two(
            "The second half of a harmonic: from full speed to rest.",
            "La segunda mitad de una armónica: de toda velocidad al reposo.",
        ),
        advice: two(
            "After a stretch of constant velocity of the same slope, at low speed: the acceleration jumps at the end, beside a dwell.",
            "Después de un tramo de velocidad constante con la misma pendiente, a baja velocidad: la aceleración salta al final, junto a un detenimiento.",
        ),
        formulas: &[],
        source: SHIGLEY,
    },
    LawRow {
        id: "half-cycloidal-start",
        link: "Ca",
        since: Version::One,
        name: Name {
            noun: two("half cycloidal (start)", "semicicloidal (inicio)"),
            alone: two("half cycloidal (start)", "semicicloidal (inicio)"),
            menu: two("Half cycloidal (start)", "Semicicloidal (inicio)"),
        },
        idea: two(
            "The first half of a cycloidal: from rest to full speed, with the acceleration zero at both ends.",
            "La primera mitad de una cicloidal: del reposo a toda velocidad, con aceleración nula en los dos extremos.",
        ),
        advice: two(
            "Before a stretch of constant velocity. The slopes agree when $2L_1/β_1 = L_2/β_2$; only the jerk jumps.",
            "Antes de un tramo de velocidad constante. Las pendientes coinciden cuando $2L_1/β_1 = L_2/β_2$; solo salta la sobreaceleración.",
        ),
        formulas: &[],
        source: SHIGLEY,
    },
    LawRow {
        id: "half-cycloidal-end",
        link: "Cb",
        since: Version::One,
        name: Name {
            noun: two("half cycloidal (end)", "semicicloidal (final)"),
            alone: two("half cycloidal (end)", "semicicloidal (final)"),
            menu: two("Half cycloidal (end)", "Semicicloidal (final)"),
        },
        idea: two(
            "The second half of a cycloidal: from full speed to rest, with the acceleration zero at both ends.",
            "La segunda mitad de una cicloidal: de toda velocidad al reposo, con aceleración nula en los dos extremos.",
        ),
        advice: two(
            "After a stretch of constant velocity. The slopes agree when $L_1/β_1 = 2L_2/β_2$; only the jerk jumps.",
            "Después de un tramo de velocidad constante. Las pendientes coinciden cuando $L_1/β_1 = 2L_2/β_2$; solo salta la sobreaceleración.",
        ),
        formulas: &[],
        source: SHIGLEY,
    },
    LawRow {
        id: "polynomial-5",
        link: "Qm",
        since: Version::One,
        name: Name {
            noun: two("5th-degree polynomial", "polinómica de 5.º grado"),
            alone: two("5th-degree polynomial", "polinómica de 5.º grado"),
            menu: two("5th-degree polynomial", "Polinómica de 5.º grado"),
        },
        idea: two(
            "A polynomial that takes $s$, $v$ and $a$ from both neighbours: six conditions, six coefficients. Half of them are read off the start and the others come from a linear system at $x = 1$. Between two dwells it is the 3-4-5.",
            "Un polinomio que toma $s$, $v$ y $a$ de sus dos vecinos: seis condiciones, seis coeficientes. La mitad se leen en el principio y los otros salen de un sistema lineal en $x = 1$. Entre dos detenimientos es el 3-4-5.",
        ),
        advice: two(
            "To leave or reach a stretch of constant velocity, or any move that does not end at rest. Two of them may not be side by side, since neither would know where to end.",
            "Para salir de un tramo de velocidad constante o llegar a él, o a cualquier movimiento que no acabe en reposo. No puede haber dos seguidos, pues ninguno sabría cómo acabar.",
        ),
        formulas: &[
            "s = c_0 + c_1 x + c_2 x^2 + c_3 x^3 + c_4 x^4 + c_5 x^5",
            "c_0 = s_1, c_1 = β v_1, c_2 = (β^2 a_1)/2",
            "c_3 + c_4 + c_5 = s_2 - c_0 - c_1 - c_2",
            "3c_3 + 4c_4 + 5c_5 = β v_2 - c_1 - 2c_2",
            "6c_3 + 12c_4 + 20c_5 = β^2 a_2 - 2c_2",
        ],
        source: NORTON,
    },
    LawRow {
        id: "polynomial-7",
        link: "Sm",
        since: Version::One,
        name: Name {
            noun: two("7th-degree polynomial", "polinómica de 7.º grado"),
            alone: two("7th-degree polynomial", "polinómica de 7.º grado"),
            menu: two("7th-degree polynomial", "Polinómica de 7.º grado"),
        },
        idea: two(
            "A polynomial that takes $s$, $v$, $a$ and $j$ from both neighbours: eight conditions, eight coefficients. Between two dwells it is the 4-5-6-7.",
            "Un polinomio que toma $s$, $v$, $a$ y $j$ de sus dos vecinos: ocho condiciones, ocho coeficientes. Entre dos detenimientos es el 4-5-6-7.",
        ),
        advice: two(
            "Where not even the jerk may jump. It swings more than the one of degree 5: look at its peak acceleration.",
            "Donde no debe saltar ni la sobreaceleración. Oscila más que el de grado 5: conviene mirar su aceleración máxima.",
        ),
        formulas: &[
            "s = c_0 + c_1 x + c_2 x^2 + … + c_7 x^7",
            "c_0 = s_1, c_1 = β v_1, c_2 = (β^2 a_1)/2, c_3 = (β^3 j_1)/6",
            "c_4 + c_5 + c_6 + c_7 = s_2 - c_0 - c_1 - c_2 - c_3",
            "4c_4 + 5c_5 + 6c_6 + 7c_7 = β v_2 - c_1 - 2c_2 - 3c_3",
            "12c_4 + 20c_5 + 30c_6 + 42c_7 = β^2 a_2 - 2c_2 - 6c_3",
            "24c_4 + 60c_5 + 120c_6 + 210c_7 = β^3 j_2 - 6c_3",
        ],
        source: NORTON,
    },
    LawRow {
        id: "polynomial",
        link: "N",
        since: Version::One,
        name: Name {
            noun: two("free polynomial", "polinómica libre"),
            alone: two("free polynomial", "polinómica libre"),
            menu: two("Free polynomial", "Polinómica libre"),
        },
        idea: two(
            "A polynomial through any list of conditions: at a place, an order (0 for $s$, 1 for $v$, 2 for $a$, 3 for $j$) and a value. With $n$ conditions the degree is $n - 1$.",
            "Un polinomio por cualquier lista de condiciones: en un lugar, un orden (0 para $s$, 1 para $v$, 2 para $a$, 3 para $j$) y un valor. Con $n$ condiciones el grado es $n - 1$.",
        ),
        advice: two(
            "When the machine dictates points or speeds along the way. Every condition adds a power, and high powers swing between the points: with many of them prefer a B-spline.",
            "Cuando la máquina impone puntos o velocidades por el camino. Cada condición añade una potencia, y las potencias altas oscilan entre los puntos: si son muchas es preferible una B-spline.",
        ),
        formulas: &["s = c_0 + c_1 x + c_2 x^2 + … + c_(n−1) x^(n - 1), x = θ/β"],
        source: NORTON,
    },
    LawRow {
        id: "bspline",
        link: "B",
        since: Version::One,
        name: Name {
            noun: two("B-spline", "B-spline"),
            alone: two("B-spline", "B-spline"),
            menu: two("B-spline", "B-spline"),
        },
        idea: two(
            "Polynomials of degree 4 to 8 joined so smoothly that the joints cannot be seen: at the knots all derivatives but the last are continuous. Each coefficient moves only its own stretch of curve.",
            "Polinomios de grado 4 a 8 unidos con tal suavidad que las uniones no se ven: en los nudos son continuas todas las derivadas salvo la última. Cada coeficiente mueve solo su trozo de curva.",
        ),
        advice: two(
            "Many conditions without the swings of one polynomial of high degree.",
            "Muchas condiciones sin las oscilaciones de un único polinomio de grado alto.",
        ),
        formulas: &["s = c_1 N_1(x) + c_2 N_2(x) + … + c_n N_n(x)"],
        source: Some("R. L. Norton, Cam Design and Manufacturing Handbook; C. de Boor, A Practical Guide to Splines"),
    },
    LawRow {
        id: "bezier",
        link: "Z",
        since: Version::One,
        name: Name {
            noun: two("Bézier", "de Bézier"), alone: two("Bézier", "Bézier"), menu: two("Bézier", "Bézier")
        },
        idea: two(
            "A polynomial in Bernstein form: the curve begins at the first ordinate, ends at the last and is drawn towards the others. The first and last two ordinates set the end velocities, three the accelerations, four the jerks.",
            "Un polinomio en la forma de Bernstein: la curva empieza en la primera ordenada, acaba en la última y las demás tiran de ella. Las dos primeras y las dos últimas fijan las velocidades de los extremos; tres, las aceleraciones; cuatro, las sobreaceleraciones.",
        ),
        advice: two(
            "To shape a move by hand: equal ordinates at an end make it rest there.",
            "Para dar forma a un movimiento a mano: unas ordenadas iguales en un extremo hacen que allí repose.",
        ),
        formulas: &["y = p_0 (1 - x)^n + n p_1 x (1 - x)^(n - 1) + … + p_n x^n", "y'(0) = n(p_1 - p_0)"],
        source: Some("G. Farin, Curves and Surfaces for CAGD"),
    },
    LawRow {
        id: "table",
        link: "L",
        since: Version::One,
        name: Name {
            noun: two("table of points", "por tabla de puntos"),
            alone: two("table of points", "tabla de puntos"),
            menu: two("Table of points", "Tabla de puntos"),
        },
        idea: two(
            "Measured points $(θ, s)$, joined by a spline of the fifth degree with a continuous jerk, whose derivatives are then exact. At its ends it takes $v$ and $a$ from its neighbours. With a smoothing $δ$ it passes the inner points at that distance (root mean square) and has the least jerk that this allows.",
            "Puntos medidos $(θ, s)$, unidos por una spline de quinto grado con sobreaceleración continua, cuyas derivadas son después exactas. En los extremos toma $v$ y $a$ de sus vecinos. Con un suavizado $δ$ se aparta de los puntos interiores esa media cuadrática y tiene la menor sobreaceleración que ello permite.",
        ),
        advice: two(
            "To study an existing cam. Each derivative multiplies the errors of measurement: few points with many digits are better than many with few.",
            "Para estudiar una leva existente. Cada derivada multiplica los errores de medida: más valen pocos puntos con muchas cifras que muchos con pocas.",
        ),
        formulas: &["s(θ_k) = s_k, k = 1, …, n"],
        source: Some("C. de Boor, A Practical Guide to Splines"),
    },
    LawRow {
        id: "formula",
        link: "F",
        since: Version::One,
        name: Name {
            noun: two("formula", "por fórmula"),
            alone: two("formula", "fórmula"),
            menu: two("Formula", "Fórmula"),
        },
        idea: two(
            "An expression of your own for $s$, with $x$, $θ$, $β$ and $L$. Its derivatives up to the jerk are exact: they are carried along with the value, not measured on the curve.",
            "Una expresión propia de $s$, con $x$, $θ$, $β$ y $L$. Sus derivadas hasta la sobreaceleración son exactas: se arrastran con el valor, no se miden sobre la curva.",
        ),
        advice: two(
            "Exercises that give the law, and laws that are not in the list. What it does at its ends is up to the formula: the verdict tells whether it joins its neighbours.",
            "Ejercicios que dan la ley, y leyes que no están en la lista. Lo que haga en los extremos depende de la fórmula: el veredicto dice si enlaza con sus vecinos.",
        ),
        formulas: &["s = f(x, θ, β, L)"],
        source: NORTON,
    },
    LawRow {
        id: "circular-arc",
        link: "",
        since: Version::One,
        name: Name {
            noun: two("circular arc", "de arco de circunferencia"),
            alone: two("circular arc", "arco de circunferencia"),
            menu: two("Circular arc", "Arco de circunferencia"),
        },
        idea: two(
            "The motion that an arc of a circle gives a flat face: the support of the circle is a constant and a cosine, so that the radius of curvature of the cam is constant.",
            "El movimiento que un arco de circunferencia da a una cara plana: la función de apoyo de la circunferencia es una constante y un coseno, de modo que el radio de curvatura de la leva es constante.",
        ),
        advice: two(
            "Only in cams of constant breadth that are made of arcs: no menu offers it.",
            "Solo en levas de anchura constante formadas por arcos: ningún menú la ofrece.",
        ),
        formulas: &["y = (1 - cos(β x))/(4 (sin(β/4))^2), 0 ≤ x ≤ 1/2"],
        source: SHIGLEY,
    },
];

static LABELS: [Label; LAWS.len()] = labels();

const fn labels() -> [Label; LAWS.len()] {
    labels_of!(LAWS)
}

const _: () = {
    let labels = labels();
    let mut k = 0;
    while k < levalab_core::LAWS.len() {
        has_one_row_in_the_catalogue(levalab_core::LAWS[k].id, &labels);
        k += 1;
    }
    has_one_row_in_the_catalogue(CIRCULAR_ARC.id, &labels);
    have_codes_of_their_own(&labels);
};
