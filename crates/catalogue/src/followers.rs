//! The row of every follower. To add a follower, add its row here; see *How to add a follower* in `ARCHITECTURE.md`.

use crate::check::{has_one_row_in_the_catalogue, have_codes_of_their_own};
use crate::label::{find, labels_of};
use crate::{Label, Name, Two, Version, two};
use levalab_core::FollowerKind;

/// A follower. All formulas are for either sense of rotation: σ is +1 counter-clockwise, −1 clockwise.
pub struct FollowerRow {
    /// The follower's id in the core.
    pub id: &'static str,
    /// Its code in a link, a capital. Never given to another follower.
    pub link: &'static str,
    /// The first version of file and link that knows it.
    pub since: Version,
    /// Its name.
    pub name: Name,
    /// What it is and where it serves.
    pub idea: Two,
    /// How the profile is found.
    pub construction: &'static [&'static str],
    /// φ.
    pub pressure_angle: &'static str,
    /// ρ of the profile, and the formulas of which it is made.
    pub radius: &'static [&'static str],
    /// Where it touches, or how it slides.
    pub contact: Two,
    /// The failures of such a cam, and their cures.
    pub fails: Two,
    /// The book; `None` for a derivation of our own.
    pub source: Option<&'static str>,
}

const PITCH: &str = "P = F exp(-iσθ), P' = (F' - iσF) exp(-iσθ), P'' = (F'' - 2iσF' - F) exp(-iσθ)";
const RADIUS_OF_PITCH: &str = "ρ_p = -σ (|P'|^3)/(P' × P'')";
const SLIDING_TRACE: &str = "F = e + i(s_0 + s), F' = iv, F'' = ia";
const SLIDING_ANGLE: &str = "tan(φ) = (v - σe)/(s_0 + s)";
const SOURCE: Option<&str> = Some("R. L. Norton, Cam Design and Manufacturing Handbook, ch. 7");

/// The row of a follower.
#[must_use]
pub fn follower_row(kind: &FollowerKind) -> Option<&'static FollowerRow> {
    FOLLOWERS.iter().find(|row| row.id == kind.id)
}

/// The names and the code of a follower.
#[must_use]
pub fn follower_label(kind: &FollowerKind) -> Option<&'static Label> {
    find(&LABELS, kind.id)
}

/// Every follower that the core lists.
pub const FOLLOWERS: &[FollowerRow] = &[
    FollowerRow {
        id: "translating-roller",
        link: "R",
        since: Version::One,
        name: Name {
            noun: two("translating roller follower", "seguidor de traslación con rodillo"),
            alone: two("translating roller follower", "seguidor de traslación con rodillo"),
            menu: two("Translating roller", "De traslación con rodillo"),
        },
        idea: two(
            "A roller at the end of a stem that slides along an axis at distance $e$ from the cam's centre. It rolls, so it wears little: the usual choice in machines.",
            "Un rodillo en el extremo de un vástago que desliza según un eje a distancia $e$ del centro de la leva. Rueda, así que se desgasta poco: es lo habitual en las máquinas.",
        ),
        construction: &["R_p = R_b + R_f, s_0 = sqrt(R_p^2 - e^2)", SLIDING_TRACE, PITCH],
        pressure_angle: SLIDING_ANGLE,
        radius: &[RADIUS_OF_PITCH, "ρ = ρ_p - R_f"],
        contact: two(
            "The profile is the pitch curve $P$ moved inwards along its normal by $R_f$; the contact lies on the line from the centre of the roller to the centre of curvature.",
            "El perfil es la curva de paso $P$ llevada hacia dentro según su normal una distancia $R_f$; el contacto está en la recta que va del centro del rodillo al centro de curvatura.",
        ),
        fails: two(
            "$φ$ beyond 30° pushes the stem against its guide: enlarge $R_b$, or move the axis with $e$ so that rise and return share the angle. Where $0 < ρ_p < R_f$ the cam is undercut, and at $ρ_p = R_f$ it has a point: a smaller roller or a larger base circle. Where the cam is hollow the roller must be smaller than the hollow.",
            "Un $φ$ mayor de 30° empuja el vástago contra su guía: auméntese $R_b$, o desplácese el eje con $e$ para que subida y retorno se repartan el ángulo. Donde $0 < ρ_p < R_f$ la leva queda rebajada, y en $ρ_p = R_f$ tiene un pico: un rodillo menor o una circunferencia base mayor. Donde la leva es cóncava el rodillo debe ser menor que el hueco.",
        ),
        source: SOURCE,
    },
    FollowerRow {
        id: "translating-knife",
        link: "K",
        since: Version::One,
        name: Name {
            noun: two("translating knife-edge follower", "seguidor de traslación con cuchilla"),
            alone: two("translating knife-edge follower", "seguidor de traslación con cuchilla"),
            menu: two("Translating knife edge", "De traslación con cuchilla"),
        },
        idea: two(
            "An edge that rests on the cam: a roller of radius zero. It follows any profile, and it wears away at once: it belongs to the blackboard.",
            "Una arista que se apoya en la leva: un rodillo de radio nulo. Sigue cualquier perfil, y se desgasta enseguida: es propia de la pizarra.",
        ),
        construction: &["s_0 = sqrt(R_b^2 - e^2)", SLIDING_TRACE, PITCH],
        pressure_angle: SLIDING_ANGLE,
        radius: &[RADIUS_OF_PITCH, "ρ = ρ_p"],
        contact: two("The pitch curve is the profile itself.", "La curva de paso es el propio perfil."),
        fails: two(
            "$φ$ as for a roller, with the smaller $R_b$ in place of $R_p$. There is no undercut, but where $ρ = 0$ the cam has a point.",
            "$φ$ como con un rodillo, con $R_b$, que es menor, en lugar de $R_p$. No hay rebaje, pero donde $ρ = 0$ la leva tiene un pico.",
        ),
        source: SOURCE,
    },
    FollowerRow {
        id: "translating-curved",
        link: "C",
        since: Version::One,
        name: Name {
            noun: two("translating curved-face follower", "seguidor de traslación con cara curva"),
            alone: two("translating curved-face follower", "seguidor de traslación con cara curva"),
            menu: two("Translating curved face", "De traslación con cara curva"),
        },
        idea: two(
            "An arc of radius $R_f$ that slides on the cam, also called a mushroom. Its profile is that of a roller of the same radius; what differs is that it slides instead of rolling.",
            "Un arco de radio $R_f$ que desliza sobre la leva, llamado también seta. Su perfil es el de un rodillo del mismo radio; la diferencia es que desliza en lugar de rodar.",
        ),
        construction: &["R_p = R_b + R_f, s_0 = sqrt(R_p^2 - e^2)", SLIDING_TRACE, PITCH],
        pressure_angle: SLIDING_ANGLE,
        radius: &[RADIUS_OF_PITCH, "ρ = ρ_p - R_f"],
        contact: two(
            "The contact walks along the arc: seen from its centre it stands at $φ$ from the axis, so the arc must be at least as wide as $φ$ asks on each side.",
            "El contacto recorre el arco: visto desde su centro forma $φ$ con el eje, así que el arco debe ser al menos tan ancho como pida $φ$ a cada lado.",
        ),
        fails: two(
            "As for a roller. A large $R_f$ needs a large $R_b$: undercut begins where $ρ_p < R_f$.",
            "Como con un rodillo. Un $R_f$ grande pide un $R_b$ grande: el rebaje empieza donde $ρ_p < R_f$.",
        ),
        source: SOURCE,
    },
    FollowerRow {
        id: "translating-flat",
        link: "F",
        since: Version::One,
        name: Name {
            noun: two("translating flat-face follower", "seguidor de traslación con cara plana"),
            alone: two("translating flat-face follower", "seguidor de traslación con cara plana"),
            menu: two("Translating flat face", "De traslación con cara plana"),
        },
        idea: two(
            "A straight face, square to the stem or inclined by $γ$. It is simple and takes no side push when $γ = 0$: the valves of engines.",
            "Una cara recta, perpendicular al vástago o inclinada un ángulo $γ$. Es sencilla y no da empuje lateral si $γ = 0$: las válvulas de los motores.",
        ),
        construction: &["p = R_b + s cos(γ)", "q = -σv cos(γ)", "n = i exp(iγ), P = (p + iq) n exp(-iσθ)"],
        pressure_angle: "φ = σγ",
        radius: &["ρ = R_b + (s + a) cos(γ)"],
        contact: two(
            "The contact walks along the face; $q$ is measured along $i n$, to the left. With $γ = 0$ and a cam that turns counter-clockwise it is at $v$ to the right of the axis, and at $-v$ when it turns the other way. The face must be longer than $v_(max) - v_(min)$.",
            "El contacto recorre la cara; $q$ se mide según $i n$, hacia la izquierda. Con $γ = 0$ y una leva que gira en sentido antihorario está a $v$ a la derecha del eje, y a $-v$ si gira al revés. La cara debe medir más que $v_(max) - v_(min)$.",
        ),
        fails: two(
            "The face cannot enter a hollow: wherever $ρ < 0$ it could not touch, and at $ρ = 0$ the cam has a point. With $γ = 0$ the smallest base circle for a wanted least radius is $R_b = ρ_(min) - min(s + a)$: only the most negative sum of $s$ and $a$ counts.",
            "La cara no puede entrar en un hueco: donde $ρ < 0$ no llegaría a tocar, y en $ρ = 0$ la leva tiene un pico. Con $γ = 0$ la menor circunferencia base para un radio mínimo deseado es $R_b = ρ_(min) - min(s + a)$: solo cuenta la suma más negativa de $s$ y $a$.",
        ),
        source: SOURCE,
    },
    FollowerRow {
        id: "oscillating-roller",
        link: "A",
        since: Version::One,
        name: Name {
            noun: two("oscillating roller follower", "seguidor oscilante con rodillo"),
            alone: two("oscillating roller follower", "seguidor oscilante con rodillo"),
            menu: two("Oscillating roller", "Oscilante con rodillo"),
        },
        idea: two(
            "A roller on an arm of length $A$ that swings about a pivot at distance $m$ and angle $ψ$ from the cam's centre. Here $s$ is an angle: it opens the arm beyond $ξ_0$, its angle to the line of centres at rest.",
            "Un rodillo en un brazo de longitud $A$ que oscila alrededor de una articulación a distancia $m$ y ángulo $ψ$ del centro de la leva. Aquí $s$ es un ángulo: abre el brazo más allá de $ξ_0$, el que forma en reposo con la línea de centros.",
        ),
        construction: &[
            "R_p = R_b + R_f, cos(ξ_0) = (m^2 + A^2 - R_p^2)/(2mA), ξ = ξ_0 + s",
            "F = (m - A exp(-iξ)) exp(iψ)",
            "F' = ivA exp(i(ψ - ξ)), F'' = (ia + v^2) A exp(i(ψ - ξ))",
            PITCH,
        ],
        pressure_angle: "tan(φ) = σ (A(1 + σv) - m cos(ξ))/(m sin(ξ))",
        radius: &[RADIUS_OF_PITCH, "ρ = ρ_p - R_f"],
        contact: two(
            "As with any roller, on its normal; $φ$ is measured from the square to the arm, the way the centre of the roller moves.",
            "Como con cualquier rodillo, en su normal; $φ$ se mide desde la perpendicular al brazo, que es hacia donde se mueve el centro del rodillo.",
        ),
        fails: two(
            "$φ$ beyond 35°: enlarge $R_b$, or move the pivot so that the arm is square to the line from the cam in the middle of its swing. $m$, $A$ and $R_p$ must make a triangle. Undercut and points as with the translating roller; besides, neither arm nor pivot may lie in the way of the cam.",
            "$φ$ mayor de 35°: auméntese $R_b$, o muévase la articulación para que el brazo quede perpendicular a la recta que va a la leva en mitad de su oscilación. $m$, $A$ y $R_p$ deben formar un triángulo. Rebaje y picos como con el rodillo de traslación; además, ni el brazo ni la articulación pueden estorbar a la leva.",
        ),
        source: SOURCE,
    },
    FollowerRow {
        id: "oscillating-flat",
        link: "O",
        since: Version::One,
        name: Name {
            noun: two("oscillating flat-face follower", "seguidor oscilante con cara plana"),
            alone: two("oscillating flat-face follower", "seguidor oscilante con cara plana"),
            menu: two("Oscillating flat face", "Oscilante con cara plana"),
        },
        idea: two(
            "A straight face that swings about a pivot, the line of the face at distance $f$ from it: rockers of engines, presses.",
            "Una cara recta que oscila alrededor de una articulación, con la recta de la cara a distancia $f$ de ella: balancines de motores, prensas.",
        ),
        construction: &["sin(ξ_0) = (R_b - f)/m, ξ = ξ_0 + s", "p = f + m sin(ξ)", "q = -(σv m cos(ξ))/(1 + σv)"],
        pressure_angle: "tan(φ) = σ f/(m cos(ξ) + q)",
        radius: &["ρ = p - σ (q')/(1 + σv)", "q' = -σm (a cos(ξ) - v^2 sin(ξ))/(1 + σv) + (m a v cos(ξ))/(1 + σv)^2"],
        contact: two(
            "The distance along the face from the foot of the pivot to the contact is $m cos(ξ) + q$; its greatest value is the least length of the face.",
            "La distancia a lo largo de la cara desde el pie de la articulación hasta el contacto es $m cos(ξ) + q$; su valor máximo es la menor longitud de la cara.",
        ),
        fails: two(
            "As for a flat face: no hollows. Besides, the face must not turn as fast as the cam and in its sense ($1 + σv > 0$), or the contact would run away along it; and the contact must stay on its own side of the pivot.",
            "Como con una cara plana: nada de huecos. Además, la cara no debe girar tan deprisa como la leva y en su sentido ($1 + σv > 0$), o el contacto se escaparía por ella; y el contacto debe quedarse de su lado de la articulación.",
        ),
        source: SOURCE,
    },
];

static LABELS: [Label; FOLLOWERS.len()] = labels();

const fn labels() -> [Label; FOLLOWERS.len()] {
    labels_of!(FOLLOWERS)
}

const _: () = {
    let labels = labels();
    let mut k = 0;
    while k < levalab_core::FOLLOWERS.len() {
        has_one_row_in_the_catalogue(levalab_core::FOLLOWERS[k].id, &labels);
        k += 1;
    }
    have_codes_of_their_own(&labels);
};
