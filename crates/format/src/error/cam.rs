//! What a kind of cam does not have: followers, magnitudes and second cams that have no place on it.

use crate::Measure;

/// Why a kind of cam and what goes with it do not agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CamRefusal {
    /// A follower, or a second cam, that this kind of cam has no place for.
    Unsuited {
        /// The word for the kind.
        kind: &'static str,
    },
    /// A follower off the centre of a cam that needs it in line.
    OffCentre {
        /// Its eccentricity, or the angle of its face.
        found: f64,
        /// What it measures.
        measure: Measure,
        /// The word for the kind.
        kind: &'static str,
    },
    /// A breadth that leaves no travel: dc ≤ 2Rb.
    Breadth {
        /// The breadth.
        found: f64,
        /// Rb.
        base_radius: f64,
    },
    /// Segments that do not rise by dc − 2Rb over half a turn.
    BreadthTravel {
        /// What they rise by.
        found: f64,
        /// dc − 2Rb.
        travel: f64,
        /// dc.
        breadth: f64,
        /// Rb.
        base_radius: f64,
    },
    /// A polygon whose sides are not an odd number.
    Sides {
        /// How many it has.
        found: f64,
        /// The most it may have.
        most: f64,
    },
    /// A base radius so small that the arcs about the corners would turn inside out.
    SharpArcs {
        /// Rb.
        found: f64,
        /// The least there may be, with sharp corners.
        least: f64,
        /// Half the breadth, which it must stay below.
        half: f64,
    },
    /// An application on a follower that swings: its displacement is an angle.
    SwingingApplication,
    /// A second cam that has no room at that distance.
    TooClose {
        /// The distance.
        found: f64,
        /// It must be more than this.
        least: f64,
    },
}
