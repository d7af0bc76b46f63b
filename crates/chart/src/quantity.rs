//! What a diagram shows.

use levalab_core::{Cam, Column, Motion, Svaj};

/// A quantity that varies over the turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Displacement.
    S,
    /// Its first derivative.
    V,
    /// Its second derivative.
    A,
    /// Its third derivative.
    J,
    /// Pressure angle φ.
    PressureAngle,
    /// Radius of curvature ρ of the profile.
    Rho,
    /// The contact on a flat face: see [`Contact::reach`](levalab_core::Contact::reach).
    Contact,
}

/// What derivatives are taken by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Timing {
    /// By the cam angle: length/rad, length/rad², …
    PerRadian,
    /// By time, at this ω in rad/s: V = vω, A = aω², J = jω³.
    PerSecond(f64),
}

impl Quantity {
    /// Every quantity, in the order of a menu.
    pub const ALL: [Self; 7] = [Self::S, Self::V, Self::A, Self::J, Self::PressureAngle, Self::Rho, Self::Contact];

    /// Its name in columns and reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.column().name()
    }

    /// The quantity of that name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name() == name)
    }

    /// False for what this follower does not have: a contact that walks along a face.
    #[must_use]
    pub fn applies(self, cam: &Cam) -> bool {
        self != Self::Contact || cam.follower.is_flat()
    }

    pub(crate) fn column(self) -> Column {
        match self {
            Self::S => Column::S,
            Self::V => Column::V,
            Self::A => Column::A,
            Self::J => Column::J,
            Self::PressureAngle => Column::PressureAngle,
            Self::Rho => Column::Rho,
            Self::Contact => Column::Contact,
        }
    }

    /// The highest derivative of the motion that it depends on: where none up to it jumps, neither does the quantity.
    pub(crate) fn order(self) -> u8 {
        match self {
            Self::S => 0,
            Self::V | Self::PressureAngle | Self::Contact => 1,
            Self::A | Self::Rho => 2,
            Self::J => 3,
        }
    }

    /// Its value in the units of the core for a motion, which may be a one-sided limit.
    pub(crate) fn of(self, cam: &Cam, motion: Svaj) -> f64 {
        match self {
            Self::S => motion.s,
            Self::V => motion.v,
            Self::A => motion.a,
            Self::J => motion.j,
            Self::PressureAngle => cam.follower.contact(motion).pressure_angle,
            Self::Rho => cam.follower.profile_radius(cam.contact(motion).bend),
            Self::Contact => cam.follower.contact(motion).reach,
        }
    }

    /// What turns a value of the core into one of the diagram: degrees for angles, powers of ω for time derivatives.
    pub(crate) fn factor(self, cam: &Cam, timing: Timing) -> f64 {
        let angle = 1_f64.to_degrees();
        let rate = match timing {
            Timing::PerRadian => 1.0,
            Timing::PerSecond(omega) => omega.powi(i32::from(self.order())),
        };
        match self {
            Self::PressureAngle => angle,
            Self::Rho | Self::Contact => 1.0,
            Self::S | Self::V | Self::A | Self::J if cam.follower.kind().motion == Motion::Oscillating => angle * rate,
            Self::S | Self::V | Self::A | Self::J => rate,
        }
    }
}
