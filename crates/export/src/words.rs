//! The words that stand in files: names of sheets, heads of columns, labels of drawings, in every language.

use levalab_words::{Language, capital, two};

/// Something that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Word {
    Design,
    Motion,
    Polar,
    Cartesian,
    Verdict,
    Application,
    PerCycle,
    Wanted,
    Found,
    Error,
    CamAngle,
    CamTravel,
    Time,
    Displacement,
    Velocity,
    Acceleration,
    Jerk,
    PressureAngle,
    Curvature,
    PitchCurvature,
    Contact,
    LeastConvex,
    TightestHollow,
    Inflections,
    Profile,
    ProfileAngle,
    ProfileRadius,
    PitchCurve,
    PitchAngle,
    PitchRadius,
    OuterWall,
    OuterAngle,
    OuterRadius,
    Magnitude,
    Value,
    Unit,
    Segment,
    Law,
    From,
    Beta,
    Rise,
    Finding,
    At,
    Limit,
    Cure,
    Quantity,
    Least,
    Greatest,
    BaseCircle,
    BaseLine,
    PrimeCircle,
    Bore,
    Text,
    Scale,
    Check,
}

impl Word {
    /// The word in a language.
    pub fn said(self, language: Language) -> &'static str {
        let (en, es) = self.both();
        two(en, es).within(language)
    }

    fn both(self) -> (&'static str, &'static str) {
        match self {
            Self::Design => ("Design", "Diseño"),
            Self::Motion => ("Motion", "Movimiento"),
            Self::Polar => ("Profile (polar)", "Perfil (polares)"),
            Self::Cartesian => ("Profile (cartesian)", "Perfil (cartesianas)"),
            Self::Verdict => ("Verdict", "Veredicto"),
            Self::Application => ("Application", "Aplicación"),
            Self::PerCycle => ("In each cycle", "En cada ciclo"),
            Self::Wanted => ("Target", "Objetivo"),
            Self::Found => ("Found", "Resultado"),
            Self::Error => ("Error", "Error"),
            Self::CamAngle => ("Cam angle", "Ángulo de la leva"),
            Self::CamTravel => ("Cam travel", "Avance de la leva"),
            Self::Time => ("Time", "Tiempo"),
            Self::Displacement => ("Displacement", "Desplazamiento"),
            Self::Velocity => ("Velocity", "Velocidad"),
            Self::Acceleration => ("Acceleration", "Aceleración"),
            Self::Jerk => ("Jerk", "Sobreaceleración"),
            Self::PressureAngle => ("Pressure angle", "Ángulo de presión"),
            Self::Curvature => ("Radius of curvature", "Radio de curvatura"),
            Self::PitchCurvature => {
                ("Radius of curvature of the pitch curve", "Radio de curvatura de la curva de paso")
            }
            Self::Contact => ("Contact on the face", "Contacto sobre la cara"),
            Self::LeastConvex => ("Minimum convex radius of curvature", "Radio de curvatura convexo mínimo"),
            Self::TightestHollow => ("Tightest hollow", "Concavidad más cerrada"),
            Self::Inflections => ("Inflections", "Inflexiones"),
            Self::Profile => ("Profile", "Perfil"),
            Self::ProfileAngle => ("Profile, polar angle", "Perfil, ángulo polar"),
            Self::ProfileRadius => ("Profile, radius", "Perfil, radio"),
            Self::PitchCurve => ("Pitch curve", "Curva de paso"),
            Self::PitchAngle => ("Pitch curve, polar angle", "Curva de paso, ángulo polar"),
            Self::PitchRadius => ("Pitch curve, radius", "Curva de paso, radio"),
            Self::OuterWall => ("Outer wall", "Pared exterior"),
            Self::OuterAngle => ("Outer wall, polar angle", "Pared exterior, ángulo polar"),
            Self::OuterRadius => ("Outer wall, radius", "Pared exterior, radio"),
            Self::Magnitude => ("Magnitude", "Magnitud"),
            Self::Value => ("Value", "Valor"),
            Self::Unit => ("Unit", "Unidad"),
            Self::Segment => ("Segment", "Tramo"),
            Self::Law => ("Law", "Ley"),
            Self::From => ("From", "Desde"),
            Self::Beta => ("Width β", "Amplitud β"),
            Self::Rise => ("Rise L", "Elevación L"),
            Self::Finding => ("Finding", "Observación"),
            Self::At => ("At", "En"),
            Self::Limit => ("Limit", "Límite"),
            Self::Cure => ("Cure", "Remedio"),
            Self::Quantity => ("Quantity", "Cantidad"),
            Self::Least => ("Least", "Mínimo"),
            Self::Greatest => ("Greatest", "Máximo"),
            Self::BaseCircle => ("Base circle", "Circunferencia base"),
            Self::BaseLine => ("Base line", "Recta base"),
            Self::PrimeCircle => ("Prime circle", "Circunferencia primaria"),
            Self::Bore => ("Bore", "Agujero"),
            Self::Text => ("Text", "Texto"),
            Self::Scale => ("Scale", "Escala"),
            Self::Check => ("100 mm: check it with a ruler", "100 mm: compruébelos con una regla"),
        }
    }
}

/// A field of a design file; one that has no name here goes by its own.
pub(crate) fn field(key: &str, language: Language) -> &str {
    let (en, es) = match key {
        "title" => ("Title", "Título"),
        "length_unit" => ("Unit of length", "Unidad de longitud"),
        "speed" => ("Speed ω", "Velocidad ω"),
        "kind" => ("Cam", "Leva"),
        "rotation" => ("Sense of rotation", "Sentido de giro"),
        "base_radius" => ("Base radius Rb", "Radio base Rb"),
        "prime_radius" => ("Prime radius Rp", "Radio primario Rp"),
        "follower" => ("Follower", "Seguidor"),
        "roller_radius" => ("Roller radius Rf", "Radio del rodillo Rf"),
        "face_radius" => ("Radius of the face Rf", "Radio de la cara Rf"),
        "eccentricity" => ("Eccentricity e", "Excentricidad e"),
        "face_angle" => ("Angle of the face γ", "Ángulo de la cara γ"),
        "arm" => ("Arm A", "Brazo A"),
        "pivot_distance" => ("Distance to the pivot m", "Distancia a la articulación m"),
        "pivot_angle" => ("Angle of the pivot ψ", "Ángulo de la articulación ψ"),
        "face_offset" => ("Offset of the face f", "Descentrado de la cara f"),
        "b" => ("Sine part b", "Parte de seno b"),
        "c" => ("Constant part c", "Parte constante c"),
        "counterclockwise" => ("counter-clockwise", "antihorario"),
        "clockwise" => ("clockwise", "horario"),
        "rotating" => ("rotating plate cam", "leva de placa giratoria"),
        "grooved" => ("grooved face cam", "leva de ranura"),
        "constant-breadth" => ("cam of constant breadth", "leva de anchura constante"),
        "translating" => ("travelling cam (wedge)", "leva de traslación (cuña)"),
        "breadth" => ("Breadth dc", "Anchura dc"),
        "generator" => ("Generator", "Generador"),
        "harmonic" => ("harmonic", "armónico"),
        "circular-arc" => ("circular arcs", "arcos de circunferencia"),
        "mirror" => ("half a turn mirrored", "media vuelta reflejada"),
        "sides" => ("Sides", "Lados"),
        "length" => ("Length", "Longitud"),
        "conjugate" => ("Second cam", "Segunda leva"),
        "distance" => ("Distance between contacts D", "Distancia entre contactos D"),
        "angle" => ("Angle between contacts Γ", "Ángulo entre contactos Γ"),
        _ => return key,
    };
    two(en, es).within(language)
}

/// The name of a law where it stands alone, and not within a sentence as `la ley de seno modificado`.
pub(crate) fn law_alone(name: &str) -> String {
    capital(name.strip_prefix("de ").unwrap_or(name))
}
