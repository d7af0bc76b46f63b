//! What a course tells before laws and followers, and after them.

use super::{Two, two};

/// A section of theory.
pub struct Concept {
    /// Its place in the page.
    pub id: &'static str,
    /// Its heading.
    pub name: Two,
    /// Its text, in the markup of [`crate::html`].
    pub text: Two,
    /// The drawing beside it, by name.
    pub drawing: Option<&'static str>,
}

/// What comes before the laws.
pub const MOTION: &[Concept] = &[
    Concept {
        id: "svaj",
        name: two("Displacement and its derivatives", "El desplazamiento y sus derivadas"),
        text: two(
            "The motion of the follower is drawn against the angle $θ$ of the cam, not against time: the same cam turns slowly or fast. So velocity, acceleration and jerk are derivatives with respect to $θ$ in radians.

$$v = (d s)/(d θ), a = (d^2 s)/(d θ^2), j = (d^3 s)/(d θ^3)$$

With the cam at a constant speed $ω$ each derivative with respect to time takes one more factor $ω$:

$$V = v ω, A = a ω^2, J = j ω^3$$

So at twice the speed the inertia forces are four times as large. $v$ has a meaning of its own: it is a length, the distance from the cam's centre to the instant centre of cam and follower, which gives the pressure angle.

A *segment* of the program spans $β$ and lifts the follower by $L$. Its law is a curve $y(x)$ from (0, 0) to (1, 1), stretched to fit:

$$s = s_0 + L y(x), x = θ/β$$

$$v = (L)/β y'(x), a = (L)/(β^2) y''(x), j = (L)/(β^3) y'''(x)$$

with $β$ in radians. Halving $β$ doubles the velocity, makes the acceleration four times and the jerk eight times as large. That is why a law is known by the peaks of $y'$, $y''$ and $y'''$.",
            "El movimiento del seguidor se representa frente al ángulo $θ$ de la leva y no frente al tiempo: la misma leva gira despacio o deprisa. Por eso la velocidad, la aceleración y la sobreaceleración son derivadas respecto a $θ$ en radianes.

$$v = (d s)/(d θ), a = (d^2 s)/(d θ^2), j = (d^3 s)/(d θ^3)$$

Con la leva a velocidad constante $ω$, cada derivada respecto al tiempo lleva un factor $ω$ más:

$$V = v ω, A = a ω^2, J = j ω^3$$

Así, al doble de velocidad las fuerzas de inercia son cuatro veces mayores. La $v$ tiene además significado propio: es una longitud, la distancia del centro de la leva al centro instantáneo relativo de leva y seguidor, de la que sale el ángulo de presión.

Un *tramo* del programa abarca $β$ y eleva el seguidor $L$. Su ley es una curva $y(x)$ de (0, 0) a (1, 1), estirada a su medida:

$$s = s_0 + L y(x), x = θ/β$$

$$v = (L)/β y'(x), a = (L)/(β^2) y''(x), j = (L)/(β^3) y'''(x)$$

con $β$ en radianes. Con la mitad de $β$ la velocidad se duplica, la aceleración se multiplica por cuatro y la sobreaceleración por ocho. Por eso una ley se conoce por los máximos de $y'$, $y''$ e $y'''$.",
        ),
        drawing: Some("motion"),
    },
    Concept {
        id: "fundamental-law",
        name: two("The fundamental law of cam design", "La ley fundamental del diseño de levas"),
        text: two(
            "The displacement must be continuous with its first and second derivatives over the whole turn, also where 360° joins 0°; at high speed the third must be finite, and better continuous.

- If $s$ jumps, the follower would be in two places at once.
- If $v$ jumps, the acceleration is infinite: a blow in every turn.
- If $a$ jumps, the force jumps: the follower vibrates. Only in cams of constant breadth, which turn slowly and are held from both sides, is it tolerated.
- If $j$ jumps, it does no harm while the cam turns slowly and excites vibration when it turns fast.

So the verdict is *acceptable* when $s$, $v$, $a$ and $j$ are continuous, *not for high speeds* when only $j$ jumps, and *unacceptable* otherwise. LevaLab does not look for jumps among samples: at every joint it compares the limit from the left with the limit from the right, which are exact.",
            "El desplazamiento debe ser continuo junto con sus derivadas primera y segunda en toda la vuelta, también donde los 360° enlazan con los 0°; a altas velocidades la tercera debe ser finita, y mejor continua.

- Si salta $s$, el seguidor tendría que estar en dos sitios a la vez.
- Si salta $v$, la aceleración es infinita: un golpe en cada vuelta.
- Si salta $a$, salta la fuerza: el seguidor vibra. Solo se tolera en las levas de anchura constante, que giran despacio y van sujetas por los dos lados.
- Si salta $j$, no importa mientras la leva gire despacio, y excita vibraciones cuando gira deprisa.

Así, el veredicto es *aceptable* si $s$, $v$, $a$ y $j$ son continuas, *no apta para altas velocidades* si solo salta $j$, e *inaceptable* en los demás casos. LevaLab no busca los saltos entre muestras: en cada unión compara el límite por la izquierda con el límite por la derecha, que son exactos.",
        ),
        drawing: None,
    },
];

/// What comes between laws and followers.
pub const GEOMETRY: &[Concept] = &[
    Concept {
        id: "inversion",
        name: two("Kinematic inversion", "La inversión cinemática"),
        text: two(
            "Hold the cam still and let the frame turn the other way about it: what moves between cam and follower is the same. The follower then takes all its positions around the cam, and the profile is the curve that touches them all. That is how a profile is drawn by hand, and how LevaLab computes it: the layer {stage.layer.stations} shows it.

A point $F$ of the fixed frame is seen from the cam at

$$P = F exp(-iσθ)$$

in complex numbers, with $σ = +1$ for a cam that turns counter-clockwise and $σ = -1$ for one that turns clockwise. Two ideas give every profile:

- A *disc* (roller, knife edge, curved face): its centre draws the pitch curve $P$, and the profile is its parallel curve at distance $R_f$.
- A *face*: it is a straight line that moves, with normal $n$ at angle $α$ and at distance $p$ from the centre. The profile is its envelope, touched at

$$P = (p + iq) n, q = (d p)/(d α), ρ = p + (d^2 p)/(d α^2)$$",
            "Fíjese la leva y hágase girar el bastidor en sentido contrario a su alrededor: el movimiento relativo de leva y seguidor no cambia. El seguidor ocupa entonces todas sus posiciones alrededor de la leva, y el perfil es la curva tangente a todas ellas. Así se traza un perfil a mano, y así lo calcula LevaLab: lo muestra la capa {stage.layer.stations}.

Un punto $F$ de la referencia fija se ve desde la leva en

$$P = F exp(-iσθ)$$

en números complejos, con $σ = +1$ para una leva que gira en sentido antihorario y $σ = -1$ para una que gira en sentido horario. Dos ideas dan todos los perfiles:

- Un *disco* (rodillo, cuchilla, cara curva): su centro describe la curva de paso $P$, y el perfil es su curva paralela a distancia $R_f$.
- Una *cara*: es una recta que se mueve, de normal $n$ con ángulo $α$ y a distancia $p$ del centro. El perfil es su envolvente, a la que toca en

$$P = (p + iq) n, q = (d p)/(d α), ρ = p + (d^2 p)/(d α^2)$$",
        ),
        drawing: Some("inversion"),
    },
    Concept {
        id: "pressure-angle",
        name: two("The pressure angle", "El ángulo de presión"),
        text: two(
            "The cam pushes along the normal at the contact; the follower can only move along its own way. The angle between the two is $φ$. Of a push $N$ only $N cos(φ)$ moves the follower; $N sin(φ)$ bends the stem in its guide and, with friction, can jam it.

For a translating roller the instant centre of cam and follower lies at distance $v$ from the cam's centre, so that

$$tan(φ) = (v - σe)/(s_0 + s), s_0 = sqrt(R_p^2 - e^2)$$

Good practice keeps $|φ| ≤ 30{°}$ for translating followers and $|φ| ≤ 35{°}$ for oscillating ones. To lower it:

- A larger base circle: $s_0$ grows, and with it the cam.
- Eccentricity on the side that helps the rise: it lowers $φ$ in the rise and raises it in the return, so it pays when one of the two is steeper.
- A law with a lower peak velocity (the modified sine), a longer $β$ or a smaller $L$.

A flat face square to its stem has $φ = 0$ always.",
            "La leva empuja según la normal en el contacto; el seguidor solo puede moverse en su dirección. El ángulo entre ambas es $φ$. De un empuje $N$ solo $N cos(φ)$ mueve el seguidor; $N sin(φ)$ flexiona el vástago en su guía y, con rozamiento, puede acuñarlo.

Con un rodillo de traslación, el centro instantáneo relativo de leva y seguidor está a distancia $v$ del centro de la leva, de modo que

$$tan(φ) = (v - σe)/(s_0 + s), s_0 = sqrt(R_p^2 - e^2)$$

La buena práctica mantiene $|φ| ≤ 30{°}$ en los seguidores de traslación y $|φ| ≤ 35{°}$ en los oscilantes. Para bajarlo:

- Una circunferencia base mayor: crece $s_0$, y con ella la leva.
- Excentricidad hacia el lado que ayuda a la subida: baja $φ$ en la subida y lo aumenta en el retorno, así que compensa cuando una de las dos es más empinada.
- Una ley con menor velocidad máxima (el seno modificado), un $β$ mayor o un $L$ menor.

Una cara plana perpendicular a su vástago tiene siempre $φ = 0$.",
        ),
        drawing: Some("pressure-angle"),
    },
    Concept {
        id: "radius",
        name: two("Radius of curvature, undercut and cusps", "Radio de curvatura, rebaje y cúspides"),
        text: two(
            "$ρ$ is the radius of the circle that fits the profile best at the contact: positive where the cam is convex, negative where it is hollow, infinite where it is straight. That of the pitch curve is $ρ_p$, and for a roller

$$ρ_p = -σ (|P'|^3)/(P' × P''), ρ = ρ_p - R_f$$

- $ρ_p > R_f$: the cam is convex and sound.
- $ρ_p = R_f$: the profile comes to a point, a *cusp*, which would wear away at once: contact stress grows as $1/ρ$.
- $0 < ρ_p < R_f$: the parallel curve folds back on itself. The cutter takes away what another position needs: the cam is *undercut* and the follower does not do what the program says.
- $ρ_p < 0$: the cam is hollow, and a roller fits only if $R_f < |ρ_p|$.

A flat face needs $ρ > 0$ all along. With the face square to the stem

$$ρ = R_b + s + a$$

so only the deceleration near the top, where $a$ is most negative, can harm. The cure is always room: a larger $R_b$, a smaller roller, or a law with a lower peak of $a$.",
            "$ρ$ es el radio del círculo que mejor se ciñe al perfil en el contacto: positivo donde la leva es convexa, negativo donde es cóncava, infinito donde es recta. El de la curva de paso es $ρ_p$, y con un rodillo

$$ρ_p = -σ (|P'|^3)/(P' × P''), ρ = ρ_p - R_f$$

- $ρ_p > R_f$: la leva es convexa y correcta.
- $ρ_p = R_f$: el perfil acaba en punta, una *cúspide*, que se desgastaría enseguida: la tensión de contacto crece con $1/ρ$.
- $0 < ρ_p < R_f$: la curva paralela se pliega sobre sí misma. La fresa se lleva lo que otra posición necesita: la leva queda *rebajada* y el seguidor no hace lo que dice el programa.
- $ρ_p < 0$: la leva es cóncava, y un rodillo solo cabe si $R_f < |ρ_p|$.

Una cara plana necesita $ρ > 0$ en toda la vuelta. Con la cara perpendicular al vástago

$$ρ = R_b + s + a$$

así que solo puede perjudicar la deceleración cercana a lo más alto, donde $a$ es más negativa. El remedio es siempre espacio: mayor $R_b$, un rodillo menor, o una ley con menor máximo de $a$.",
        ),
        drawing: Some("radius"),
    },
    Concept {
        id: "sizing",
        name: two("Sizing the base circle", "Dimensionar la circunferencia base"),
        text: two(
            "The smallest cam is the cheapest and the fastest, and every fault of shape is cured by a larger one. So the base circle is the smallest that satisfies, at once:

- The pressure angle. For a radial roller $tan(φ) = v/(R_p + s)$, so at every angle $R_p ≥ |v|/tan(φ_(max)) - s$; the greatest of these is what is needed.
- The radius of curvature. For a flat face $R_b = ρ_(min) - min(s + a)$; for a roller $ρ_p > R_f$ with some margin, found by trying.
- The shaft: the cam needs a hub, a keyway and material around them.

LevaLab solves each condition for this very cam and offers the result in the verdict: *With Rb ≥ …*. A base circle twice as large moves its rim twice as fast and slides more: larger is not always better.",
            "La leva más pequeña es la más barata y la más rápida, y todo defecto de forma se cura con una mayor. Así que la circunferencia base es la menor que cumple a la vez:

- El ángulo de presión. Con un rodillo centrado $tan(φ) = v/(R_p + s)$, así que en cada ángulo $R_p ≥ |v|/tan(φ_(max)) - s$; el mayor de estos valores es el necesario.
- El radio de curvatura. Con una cara plana $R_b = ρ_(min) - min(s + a)$; con un rodillo $ρ_p > R_f$ con algún margen, que se busca por tanteo.
- El eje: la leva necesita un cubo, un chavetero y material alrededor.

LevaLab resuelve cada condición para esta misma leva y ofrece el resultado en el veredicto: *Con Rb ≥ …*. Una circunferencia base el doble de grande mueve su borde el doble de deprisa y desliza más: mayor no siempre es mejor.",
        ),
        drawing: None,
    },
];

/// What comes after the followers.
pub const KINDS: &[Concept] = &[
    Concept {
        id: "constant-breadth",
        name: two("Cams of constant breadth", "Levas de anchura constante"),
        text: two(
            "A yoke holds the cam from both sides, so that no spring is needed: with two parallel faces the cam has *constant breadth*, with two rollers *constant diameter*. The faces are a constant distance $d_c$ apart, so what one side rises the other falls:

$$s(θ) + s(θ + π) = s_(max), d_c = 2R_b + s_(max)$$

Only half a turn is free, the other half follows. Three ways to fill it:

- The classic program: harmonic rise 120°, dwell 60°, harmonic return 120°, dwell 60°.
- Arcs of circle on a regular polygon with an odd number of sides: the opposite vertex is always the centre of the arc. With three sides and no rounding it is the Reuleaux triangle. The radius of curvature is constant on each arc.
- Any program on the first half turn, mirrored onto the second.

The acceleration usually jumps; that is tolerated here alone, because the yoke is held from both sides and turns slowly. The sum of the radii of curvature at opposite contacts is the breadth:

$$ρ(θ) + ρ(θ + π) = d_c$$",
            "Un marco sujeta la leva por los dos lados, de modo que no hace falta resorte: con dos caras paralelas la leva es de *anchura constante*, con dos rodillos de *diámetro constante*. Las caras están a una distancia constante $d_c$, así que lo que un lado sube lo baja el otro:

$$s(θ) + s(θ + π) = s_(max), d_c = 2R_b + s_(max)$$

Solo media vuelta es libre, la otra media se deduce. Tres maneras de llenarla:

- El programa clásico: subida armónica 120°, detenimiento 60°, retorno armónico 120°, detenimiento 60°.
- Arcos de circunferencia sobre un polígono regular con un número impar de lados: el vértice opuesto es siempre el centro del arco. Con tres lados y sin redondear es el triángulo de Reuleaux. El radio de curvatura es constante en cada arco.
- Cualquier programa en la primera media vuelta, reflejado en la segunda.

La aceleración suele saltar; solo aquí se tolera, porque el marco va sujeto por los dos lados y gira despacio. La suma de los radios de curvatura en contactos opuestos es la anchura:

$$ρ(θ) + ρ(θ + π) = d_c$$",
        ),
        drawing: Some("breadth"),
    },
    Concept {
        id: "conjugate",
        name: two("Conjugate cams", "Levas conjugadas"),
        text: two(
            "A second cam on the same shaft carries a second contact rigidly joined to the first: the follower is held both ways for any program. Seen from the second contact the motion is reversed: it falls where the first rises.

- Translating flat: the opposite face at distance $D$ gives $R_(b2) = D - R_b - s_(max)$ and $s_2 = s_(max) - s$.
- Translating roller: a second roller at distance $D$ of centres, with a radius of its own.
- Oscillating: a second arm or face at a fixed angle to the first; either this angle or $R_(b2)$ is given and the other found.

The second cam has its own pressure angle, curvature and verdict. Some pairs cannot exist: the base circle of the second would vanish, or its roller would not fit; then LevaLab says why and gives the smallest distance or the range of angles.",
            "Una segunda leva en el mismo eje lleva un segundo contacto unido rígidamente al primero: el seguidor queda sujeto en ambos sentidos con cualquier programa. Visto desde el segundo contacto el movimiento está invertido: baja donde el primero sube.

- Plato plano de traslación: la cara opuesta a distancia $D$ da $R_(b2) = D - R_b - s_(max)$ y $s_2 = s_(max) - s$.
- Rodillo de traslación: un segundo rodillo a distancia $D$ entre centros, con radio propio.
- Oscilante: un segundo brazo o cara a un ángulo fijo del primero; se da ese ángulo o $R_(b2)$ y se halla el otro.

La segunda leva tiene su propio ángulo de presión, su curvatura y su veredicto. Algunas parejas no pueden existir: la circunferencia base de la segunda desaparecería, o su rodillo no cabría; entonces LevaLab dice por qué y da la menor distancia o el intervalo de ángulos.",
        ),
        drawing: None,
    },
    Concept {
        id: "grooved",
        name: two("Grooved and translating cams", "Levas de ranura y levas de traslación"),
        text: two(
            "A *grooved* face cam holds its roller between two walls: both parallel curves of one pitch curve, at $R_f$ inwards and outwards. The outer wall has $ρ = ρ_p + R_f$, so only the inner one can be undercut; but where the cam is hollow it is the outer wall that needs $R_f < |ρ_p|$.

A *translating* cam, a wedge, goes back and forth along $x$ instead of turning. Its pitch curve is the displacement diagram itself, raised by $R_f$, and

$$tan(φ) = (d s)/(d x), ρ_p = -((1 + (s')^2)^(3/2))/(s'')$$",
            "Una leva *de ranura* sujeta su rodillo entre dos paredes: las dos curvas paralelas de una misma curva de paso, a $R_f$ hacia dentro y hacia fuera. La pared exterior tiene $ρ = ρ_p + R_f$, así que solo la interior puede quedar rebajada; pero donde la leva es cóncava es la pared exterior la que necesita $R_f < |ρ_p|$.

Una leva *de traslación*, una cuña, va y viene según $x$ en lugar de girar. Su curva de paso es el propio diagrama de desplazamientos, levantado $R_f$, y

$$tan(φ) = (d s)/(d x), ρ_p = -((1 + (s')^2)^(3/2))/(s'')$$",
        ),
        drawing: None,
    },
    Concept {
        id: "application",
        name: two("What the follower drives", "Lo que mueve el seguidor"),
        text: two(
            "A cam is there for what its follower drives. Everything here follows from the displacement $s$, above the lowest place of the follower, and from its velocity $V = v ω$; so the follower must be a translating one, since the displacement of an oscillating one is an angle.

- *Force*: a spring or a column of fluid that is shut in pushes back in proportion, $F = K s$. Of fluid behind a piston of radius $r$, whose pressure rises by $P/V$ for each unit of volume, $K = (P/V) A^2$ with $A = π r^2$, and $p = (P/V) A s$.
- *Pump*: the piston has swept $A s$ and moves the flow $Q = A V$. What rises is delivered and what returns is drawn in, so each turn delivers $A$ times the sum of the rises; leaks and the time that its valves take are left out.
- *Poppet valve*: the passage is the slant surface of a cone between the inner edge of the seat, of diameter $d$, and the head. With a seat at the angle $β$ to its plane

$$A_v = π s cos(β)(d + s sin(β) cos(β))$$

which is $π d s$ for a flat seat (Heywood, *Internal Combustion Engine Fundamentals*, §6.3.2, low lifts). High lifts, where the port itself restricts, are left out.

The other way round, forces, volumes or lifts that were measured say what $s$ must be: divide them by $K$ or $A$ and lay the motion through them. Points to hit show how near it comes, each with its error: what is found less what was wanted.",
            "Una leva existe por lo que mueve su seguidor. Todo lo de aquí sale del desplazamiento $s$, sobre el lugar más bajo del seguidor, y de su velocidad $V = v ω$; por eso el seguidor tiene que ser de traslación, pues el desplazamiento de uno oscilante es un ángulo.

- *Fuerza*: un resorte o una columna de fluido encerrado empuja en proporción, $F = K s$. Con fluido tras un pistón de radio $r$, cuya presión sube $P/V$ por cada unidad de volumen, $K = (P/V) A^2$ con $A = π r^2$, y $p = (P/V) A s$.
- *Bomba*: el pistón ha barrido $A s$ y mueve el caudal $Q = A V$. Lo que sube se entrega y lo que vuelve se aspira, así que cada vuelta entrega $A$ por la suma de las subidas; no se cuentan fugas ni el tiempo que tardan sus válvulas.
- *Válvula de asiento*: el paso es la superficie inclinada de un cono entre el borde interior del asiento, de diámetro $d$, y la cabeza. Con un asiento al ángulo $β$ de su plano

$$A_v = π s cos(β)(d + s sin(β) cos(β))$$

que es $π d s$ con un asiento plano (Heywood, *Internal Combustion Engine Fundamentals*, §6.3.2, alzadas pequeñas). No se tratan las alzadas grandes, en las que limita el propio conducto.

Al revés, unas fuerzas, volúmenes o alzadas medidos dicen cuánto ha de valer $s$: divídalos entre $K$ o $A$ y haga pasar el movimiento por ellos. Los puntos que alcanzar muestran cuánto se acerca, cada uno con su error: lo que resulta menos lo que se pedía.",
        ),
        drawing: None,
    },
];
