//! The kinds of cam that a design may be, and what each asks of its follower and its segments.

use crate::decimal::Decimal;
use crate::limits::SIZE;
use crate::{CamRefusal, Design, DesignError, Measure};
use levalab_core::{
    Closure, ContactKind, Cycle, FollowerKind, Generator, MAX_SIDES, Motion, Rotation, sharpest_base_radius,
};

/// Every kind has its row in the catalogue.
const _: () = {
    let mut k = 0;
    while k < CamKind::WORDS.len() {
        assert!(levalab_catalogue::is_a_kind(CamKind::WORDS[k]));
        k += 1;
    }
};

/// What a cam is, besides its base circle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum CamKind {
    /// A plate that turns, with a follower that a force, or a second cam, keeps on it.
    #[default]
    Rotating,
    /// A disc that turns, with a groove in its face that a roller runs in.
    Grooved,
    /// A plate that turns between two parallel faces, or two rollers, of a yoke.
    ConstantBreadth {
        /// dc: the distance between the faces, or between the near sides of the rollers. The travel is dc − 2Rb.
        breadth: f64,
        /// Where its motion comes from.
        generator: BreadthGenerator,
    },
    /// A plate that travels back and forth (a wedge): β's are lengths along it.
    Translating {
        /// How far it travels.
        length: f64,
    },
}

/// Where the motion of a cam of constant breadth comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BreadthGenerator {
    /// A ready-made motion; the design has no segments of its own.
    Ready(Generator),
    /// The design's segments over half a turn, completed by their image.
    Mirror,
}

impl CamKind {
    /// The words for the kinds, in the order of a menu.
    pub const WORDS: [&str; 4] = ["rotating", "grooved", "constant-breadth", "translating"];

    /// Its word in design files.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::WORDS[match self {
            Self::Rotating => 0,
            Self::Grooved => 1,
            Self::ConstantBreadth { .. } => 2,
            Self::Translating { .. } => 3,
        }]
    }

    /// How cam and follower are kept together.
    #[must_use]
    pub fn closure(self) -> Closure {
        match self {
            Self::Rotating | Self::Translating { .. } => Closure::Force,
            Self::Grooved => Closure::Groove,
            Self::ConstantBreadth { .. } => Closure::Yoke,
        }
    }

    /// The length of a cam that travels.
    #[must_use]
    pub fn travel(self) -> Option<f64> {
        match self {
            Self::Translating { length } => Some(length),
            _ => None,
        }
    }

    /// The ready-made motion that the segments come from.
    #[must_use]
    pub fn generator(self) -> Option<Generator> {
        match self {
            Self::ConstantBreadth { generator: BreadthGenerator::Ready(generator), .. } => Some(generator),
            _ => None,
        }
    }

    /// How the design's segments make a whole cycle.
    #[must_use]
    pub fn cycle(self) -> Cycle {
        match self {
            Self::Rotating | Self::Grooved => Cycle::Turn,
            Self::ConstantBreadth { .. } => Cycle::Mirrored,
            Self::Translating { length } => Cycle::Travel(length),
        }
    }

    /// What the β's of the design's segments must add up to: degrees, or length.
    #[must_use]
    pub fn whole(self) -> f64 {
        match self {
            Self::Rotating | Self::Grooved => 360.0,
            Self::ConstantBreadth { .. } => 180.0,
            Self::Translating { length } => length,
        }
    }
}

impl BreadthGenerator {
    /// The words for the generators, in the order of a menu.
    pub const WORDS: [&str; 3] = ["harmonic", "circular-arc", "mirror"];

    /// Its word in design files.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::WORDS[match self {
            Self::Ready(Generator::Harmonic) => 0,
            Self::Ready(Generator::CircularArc { .. }) => 1,
            Self::Mirror => 2,
        }]
    }
}

/// What in a follower has no place on a cam of that kind: its motion or its contact.
#[must_use]
pub fn unsuited(kind: &str, follower: &FollowerKind) -> Option<&'static str> {
    let slides = follower.motion == Motion::Translating;
    let contact = follower.contact;
    let [_, grooved, breadth, travels] = CamKind::WORDS.map(|word| word == kind);
    if (breadth || travels) && !slides {
        return Some("motion");
    }
    let suited = match contact {
        ContactKind::Roller => true,
        ContactKind::Knife | ContactKind::Curved => !grooved && !breadth,
        ContactKind::Flat => !grooved && !travels,
    };
    (!suited).then_some("contact")
}

impl Design {
    /// How far the follower of a cam of constant breadth travels: dc − 2Rb.
    #[must_use]
    pub fn breadth_travel(&self) -> Option<f64> {
        match self.kind {
            CamKind::ConstantBreadth { breadth, .. } => {
                let radius = Decimal::of(self.base_radius);
                Some((Decimal::of(breadth) - radius - radius).to_f64())
            }
            _ => None,
        }
    }

    /// Refuses magnitudes that the kind of cam cannot have, and followers that it has no place for.
    pub(crate) fn check_kind(&self) -> Result<(), DesignError> {
        self.check_suited()?;
        match self.kind {
            CamKind::Rotating | CamKind::Grooved => Ok(()),
            CamKind::Translating { length } => {
                let absent = |key| Err(DesignError::at(["cam", key], CamRefusal::Unsuited { kind: self.kind.word() }));
                if self.rotation != Rotation::default() {
                    return absent("rotation");
                }
                if self.base_radius != 0.0 {
                    return absent("base_radius");
                }
                crate::check::check_range(["cam", "length"], length, &SIZE, Measure::Length)
            }
            CamKind::ConstantBreadth { breadth, generator } => self.check_breadth(breadth, generator),
        }
    }

    fn check_breadth(&self, breadth: f64, generator: BreadthGenerator) -> Result<(), DesignError> {
        crate::check::check_range(["cam", "breadth"], breadth, &SIZE, Measure::Length)?;
        let base_radius = self.base_radius;
        if self.breadth_travel().is_some_and(|travel| travel <= 0.0) {
            return Err(DesignError::at(["cam", "breadth"], CamRefusal::Breadth { found: breadth, base_radius }));
        }
        if let BreadthGenerator::Ready(Generator::CircularArc { sides }) = generator {
            if sides.is_multiple_of(2) || !(3..=MAX_SIDES).contains(&sides) {
                let problem = CamRefusal::Sides { found: f64::from(sides), most: f64::from(MAX_SIDES) };
                return Err(DesignError::at(["cam", "sides"], problem));
            }
            let least = sharpest_base_radius(sides, breadth);
            // The sharpest of all is allowed, however its digits are rounded.
            if base_radius < least * (1.0 - 1e-9) {
                let problem = CamRefusal::SharpArcs { found: base_radius, least, half: 0.5 * breadth };
                return Err(DesignError::at(["cam", "base_radius"], problem));
            }
        }
        Ok(())
    }

    fn check_suited(&self) -> Result<(), DesignError> {
        let kind = self.kind.word();
        if let Some(key) = unsuited(kind, self.follower) {
            return Err(DesignError::at(["follower", key], CamRefusal::Unsuited { kind }));
        }
        if matches!(self.kind, CamKind::Rotating | CamKind::Grooved) {
            return Ok(());
        }
        let centred = ["eccentricity", "face_angle"];
        let off_centre = self.follower.parameters.iter().zip(self.values);
        match off_centre.into_iter().find(|(parameter, value)| centred.contains(&parameter.key) && *value != 0.0) {
            Some((parameter, found)) => {
                let measure = Measure::of(parameter);
                Err(DesignError::at(["follower", parameter.key], CamRefusal::OffCentre { found, measure, kind }))
            }
            None => Ok(()),
        }
    }
}
