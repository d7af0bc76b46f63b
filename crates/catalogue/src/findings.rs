//! The row of every finding. A kind of finding of the core that has no row here does not compile.

use crate::{Name, Two, two};
use levalab_core::FindingKind;

/// A kind of finding.
pub struct FindingRow {
    /// Its code in reports.
    pub id: &'static str,
    /// Its name.
    pub name: Name,
    /// Why a cam is unacceptable, after a colon: `the profile is undercut`.
    pub reason: Two,
    /// The idea in a sentence.
    pub idea: Two,
    /// The book; `None` for a derivation of our own.
    pub source: Option<&'static str>,
}

/// The part of a row that the page carries.
#[derive(Clone, Copy, Debug)]
pub struct FindingLabel {
    /// The code in reports.
    pub id: &'static str,
    /// Why a cam is unacceptable, after a colon.
    pub reason: Two,
}

impl FindingRow {
    const fn label(&self) -> FindingLabel {
        FindingLabel { id: self.id, reason: self.reason }
    }
}

const NORTON: Option<&str> = Some("R. L. Norton, Cam Design and Manufacturing Handbook");
const NORTON_7: Option<&str> = Some("R. L. Norton, Cam Design and Manufacturing Handbook, ch. 7");
const OWN: Option<&str> = None;

/// The code of a finding, and why it makes a cam unacceptable.
#[must_use]
pub const fn finding_label(kind: FindingKind) -> FindingLabel {
    match kind {
        FindingKind::Jump(0) => const { DISPLACEMENT_JUMP.label() },
        FindingKind::Jump(1) => const { VELOCITY_JUMP.label() },
        FindingKind::Jump(2) => const { ACCELERATION_JUMP.label() },
        FindingKind::Jump(_) => const { JERK_JUMP.label() },
        FindingKind::PressureAngle => const { PRESSURE_ANGLE.label() },
        FindingKind::Cusp => const { CUSP.label() },
        FindingKind::Undercut => const { UNDERCUT.label() },
        FindingKind::GrooveUndercut => const { GROOVE_UNDERCUT.label() },
        FindingKind::ConcaveFlat => const { CONCAVE_FLAT.label() },
        FindingKind::Doubtful => const { DOUBTFUL_CURVE.label() },
        FindingKind::NotProved(_) => const { NOT_PROVED.label() },
        FindingKind::BelowBase => const { BELOW_BASE_CIRCLE.label() },
        FindingKind::SelfCrossing => const { SELF_CROSSING.label() },
        FindingKind::ArmCutsCam => const { ARM_CUTS_CAM.label() },
        FindingKind::PivotInsideCam => const { PIVOT_INSIDE_CAM.label() },
        FindingKind::FaceOvertaken => const { FACE_OVERTAKEN.label() },
        FindingKind::ContactPastPivot => const { CONTACT_PAST_PIVOT.label() },
    }
}

/// Every finding, in the order of the core.
pub const FINDINGS: &[&FindingRow] = &[
    &DISPLACEMENT_JUMP,
    &VELOCITY_JUMP,
    &ACCELERATION_JUMP,
    &JERK_JUMP,
    &PRESSURE_ANGLE,
    &CUSP,
    &UNDERCUT,
    &GROOVE_UNDERCUT,
    &CONCAVE_FLAT,
    &DOUBTFUL_CURVE,
    &NOT_PROVED,
    &BELOW_BASE_CIRCLE,
    &SELF_CROSSING,
    &ARM_CUTS_CAM,
    &PIVOT_INSIDE_CAM,
    &FACE_OVERTAKEN,
    &CONTACT_PAST_PIVOT,
];

const DISPLACEMENT_JUMP: FindingRow = FindingRow {
    id: "displacement-jump",
    name: Name {
        noun: two("jump of the displacement", "salto del desplazamiento"),
        alone: two("jump of the displacement", "salto del desplazamiento"),
        menu: two("Jump of the displacement", "Salto del desplazamiento"),
    },
    reason: two("the displacement jumps", "el desplazamiento salta"),
    idea: two(
        "The displacement is not continuous at a joint: the follower would be in two places at once.",
        "El desplazamiento no es continuo en una unión: el seguidor estaría en dos sitios a la vez.",
    ),
    source: NORTON,
};

const VELOCITY_JUMP: FindingRow = FindingRow {
    id: "velocity-jump",
    name: Name {
        noun: two("jump of the velocity", "salto de la velocidad"),
        alone: two("jump of the velocity", "salto de la velocidad"),
        menu: two("Jump of the velocity", "Salto de la velocidad"),
    },
    reason: two("the velocity jumps", "la velocidad salta"),
    idea: two(
        "The velocity is not continuous at a joint: an infinite acceleration, an impact.",
        "La velocidad no es continua en una unión: una aceleración infinita, un golpe.",
    ),
    source: NORTON,
};

const ACCELERATION_JUMP: FindingRow = FindingRow {
    id: "acceleration-jump",
    name: Name {
        noun: two("jump of the acceleration", "salto de la aceleración"),
        alone: two("jump of the acceleration", "salto de la aceleración"),
        menu: two("Jump of the acceleration", "Salto de la aceleración"),
    },
    reason: two("the acceleration jumps", "la aceleración salta"),
    idea: two(
        "The acceleration is not continuous at a joint: the inertia force changes suddenly and the follower vibrates.",
        "La aceleración no es continua en una unión: la fuerza de inercia cambia de repente y el seguidor vibra.",
    ),
    source: NORTON,
};

const JERK_JUMP: FindingRow = FindingRow {
    id: "jerk-jump",
    name: Name {
        noun: two("jump of the jerk", "salto de la sobreaceleración"),
        alone: two("jump of the jerk", "salto de la sobreaceleración"),
        menu: two("Jump of the jerk", "Salto de la sobreaceleración"),
    },
    reason: two("the jerk jumps", "la sobreaceleración salta"),
    idea: two(
        "The jerk is not continuous at a joint: harmless at low speed, vibration at high speed.",
        "La sobreaceleración no es continua en una unión: inofensivo a baja velocidad, vibración a alta velocidad.",
    ),
    source: NORTON,
};

const PRESSURE_ANGLE: FindingRow = FindingRow {
    id: "pressure-angle",
    name: Name {
        noun: two("excessive pressure angle", "ángulo de presión excesivo"),
        alone: two("excessive pressure angle", "ángulo de presión excesivo"),
        menu: two("Excessive pressure angle", "Ángulo de presión excesivo"),
    },
    reason: two("the pressure angle is too large", "el ángulo de presión es excesivo"),
    idea: two(
        "The pressure angle exceeds the limit of good practice, 30° for a translating follower and 35° for an oscillating one.",
        "El ángulo de presión supera el límite de la buena práctica, 30° con seguidor de traslación y 35° con seguidor oscilante.",
    ),
    source: NORTON_7,
};

const CUSP: FindingRow = FindingRow {
    id: "cusp",
    name: Name { noun: two("cusp", "cúspide"), alone: two("cusp", "cúspide"), menu: two("Cusp", "Cúspide") },
    reason: two("the profile has a cusp", "el perfil tiene una cúspide"),
    idea: two(
        "The radius of curvature of the profile is zero: the profile comes to a point, which soon wears away.",
        "El radio de curvatura del perfil es nulo: el perfil acaba en punta, que se desgasta enseguida.",
    ),
    source: NORTON_7,
};

const UNDERCUT: FindingRow = FindingRow {
    id: "undercut",
    name: Name { noun: two("undercut", "rebaje"), alone: two("undercut", "rebaje"), menu: two("Undercut", "Rebaje") },
    reason: two("the profile is undercut", "el perfil tiene rebaje"),
    idea: two(
        "The radius of curvature of the pitch curve is less than that of the roller, which would cut away profile that it needs.",
        "El radio de curvatura de la curva de paso es menor que el del rodillo, que se llevaría perfil que necesita.",
    ),
    source: NORTON_7,
};

const GROOVE_UNDERCUT: FindingRow = FindingRow {
    id: "groove-undercut",
    name: Name {
        noun: two("undercut of the groove", "rebaje de la ranura"),
        alone: two("undercut of the groove", "rebaje de la ranura"),
        menu: two("Undercut of the groove", "Rebaje de la ranura"),
    },
    reason: two("the outer wall of the groove is undercut", "la pared exterior de la ranura tiene rebaje"),
    idea: two(
        "The pitch curve is hollow with a radius less than that of the roller, so that the outer wall of the groove is cut away.",
        "La curva de paso es cóncava con un radio menor que el del rodillo, de modo que la pared exterior de la ranura se pierde.",
    ),
    source: OWN,
};

const CONCAVE_FLAT: FindingRow = FindingRow {
    id: "concave-flat",
    name: Name {
        noun: two("hollow profile under a flat face", "perfil cóncavo bajo una cara plana"),
        alone: two("hollow profile under a flat face", "perfil cóncavo bajo una cara plana"),
        menu: two("Hollow profile under a flat face", "Perfil cóncavo bajo una cara plana"),
    },
    reason: two("the flat face cannot follow the profile", "la cara plana no puede seguir el perfil"),
    idea: two(
        "The profile would have to be hollow, where a flat face cannot touch it.",
        "El perfil tendría que ser cóncavo, y ahí una cara plana no puede tocarlo.",
    ),
    source: NORTON_7,
};

const DOUBTFUL_CURVE: FindingRow = FindingRow {
    id: "doubtful-curve",
    name: Name {
        noun: two("doubtful curve", "curva dudosa"),
        alone: two("doubtful curve", "curva dudosa"),
        menu: two("Doubtful curve", "Curva dudosa"),
    },
    reason: two("the conditions hardly determine a curve", "las condiciones apenas determinan una curva"),
    idea: two(
        "The data of a free law hardly determine its curve: rounding of one of them changes its shape.",
        "Los datos de una ley libre apenas determinan su curva: el redondeo de uno de ellos cambia su forma.",
    ),
    source: OWN,
};

const NOT_PROVED: FindingRow = FindingRow {
    id: "not-proved",
    name: Name {
        noun: two("extremes not proved", "extremos no demostrados"),
        alone: two("extremes not proved", "extremos no demostrados"),
        menu: two("Extremes not proved", "Extremos no demostrados"),
    },
    reason: two("not every extreme is proved", "no se han demostrado todos los extremos"),
    idea: two(
        "The limit of the calculation was reached before every extreme of a formula was certain.",
        "Se alcanzó el límite del cálculo antes de que fueran seguros todos los extremos de una fórmula.",
    ),
    source: OWN,
};

const BELOW_BASE_CIRCLE: FindingRow = FindingRow {
    id: "below-base-circle",
    name: Name {
        noun: two("follower below the base circle", "seguidor bajo la circunferencia base"),
        alone: two("follower below the base circle", "seguidor bajo la circunferencia base"),
        menu: two("Follower below the base circle", "Seguidor bajo la circunferencia base"),
    },
    reason: two("the follower goes below the base circle", "el seguidor baja de la circunferencia base"),
    idea: two(
        "The displacement is negative: the base circle is no longer the smallest circle of the cam.",
        "El desplazamiento es negativo: la circunferencia base deja de ser la menor de la leva.",
    ),
    source: OWN,
};

const SELF_CROSSING: FindingRow = FindingRow {
    id: "self-crossing",
    name: Name {
        noun: two("profile that crosses itself", "perfil que se corta a sí mismo"),
        alone: two("profile that crosses itself", "perfil que se corta a sí mismo"),
        menu: two("Profile that crosses itself", "Perfil que se corta a sí mismo"),
    },
    reason: two("the profile crosses itself", "el perfil se corta a sí mismo"),
    idea: two(
        "The profile passes twice through the same point, away from any cusp.",
        "El perfil pasa dos veces por el mismo punto, lejos de toda cúspide.",
    ),
    source: OWN,
};

const ARM_CUTS_CAM: FindingRow = FindingRow {
    id: "arm-cuts-cam",
    name: Name {
        noun: two("follower that cuts into the cam", "seguidor que penetra en la leva"),
        alone: two("follower that cuts into the cam", "seguidor que penetra en la leva"),
        menu: two("Follower that cuts into the cam", "Seguidor que penetra en la leva"),
    },
    reason: two("the follower cuts into the cam", "el seguidor penetra en la leva"),
    idea: two(
        "The arm or the stem of the follower would pass through the cam.",
        "El brazo o el vástago del seguidor atravesaría la leva.",
    ),
    source: OWN,
};

const PIVOT_INSIDE_CAM: FindingRow = FindingRow {
    id: "pivot-inside-cam",
    name: Name {
        noun: two("pivot inside the cam", "articulación dentro de la leva"),
        alone: two("pivot inside the cam", "articulación dentro de la leva"),
        menu: two("Pivot inside the cam", "Articulación dentro de la leva"),
    },
    reason: two("the cam sweeps over the pivot", "la leva barre la articulación"),
    idea: two(
        "The cam reaches as far from its centre as the pivot of the follower is.",
        "La leva llega tan lejos de su centro como la articulación del seguidor.",
    ),
    source: OWN,
};

const FACE_OVERTAKEN: FindingRow = FindingRow {
    id: "face-overtaken",
    name: Name {
        noun: two("face that turns faster than the cam", "cara que gira más deprisa que la leva"),
        alone: two("face that turns faster than the cam", "cara que gira más deprisa que la leva"),
        menu: two("Face that turns faster than the cam", "Cara que gira más deprisa que la leva"),
    },
    reason: two("the face turns faster than the cam", "la cara gira más deprisa que la leva"),
    idea: two(
        "An oscillating face turns as fast as the cam and in its sense, so that the contact runs away along it.",
        "Una cara oscilante gira tan deprisa como la leva y en su sentido, de modo que el contacto se escapa por ella.",
    ),
    source: OWN,
};

const CONTACT_PAST_PIVOT: FindingRow = FindingRow {
    id: "contact-past-pivot",
    name: Name {
        noun: two("contact past the pivot", "contacto al otro lado de la articulación"),
        alone: two("contact past the pivot", "contacto al otro lado de la articulación"),
        menu: two("Contact past the pivot", "Contacto al otro lado de la articulación"),
    },
    reason: two("the contact passes the pivot", "el contacto pasa al otro lado de la articulación"),
    idea: two(
        "The contact on an oscillating face would lie on the other side of the pivot.",
        "El contacto en una cara oscilante quedaría al otro lado de la articulación.",
    ),
    source: OWN,
};
