//! A segment of a program: a law, its β and its rise.

use crate::law::{Data, Law, MAX_LAW_PARAMETERS};

/// One stretch of the program.
#[derive(Clone, Debug)]
pub struct Segment {
    /// How the follower moves.
    pub law: &'static Law,
    /// Cam angle spanned, radians; length of travel spanned, for a translating cam.
    pub beta: f64,
    /// Height gained, negative in a return; length, or radians for an oscillating follower. That of a free law follows from its
    /// data; for a formula it is its L.
    pub rise: f64,
    /// The law's own parameters, in the order of [`Law::parameters`].
    pub parameters: [f64; MAX_LAW_PARAMETERS],
    /// What a free law is made from.
    pub data: Data,
}

impl Segment {
    /// A segment of a law that takes no parameters of its own, or takes them at their defaults.
    #[must_use]
    pub fn new(law: &'static Law, beta: f64, rise: f64) -> Self {
        Self { law, beta, rise, parameters: law.default_parameters(), data: Data::None }
    }

    /// A segment from a law's name and an angle in degrees, as tables in books give them.
    #[must_use]
    pub fn of(id: &str, degrees: f64, rise: f64) -> Option<Self> {
        Law::by_id(id).map(|law| Self::new(law, degrees.to_radians(), rise))
    }
}
