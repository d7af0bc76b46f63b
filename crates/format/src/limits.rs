//! What a design may hold at most, and why: a design may come from anywhere, so its size and range are bounded before
//! anything is computed.

use std::ops::RangeInclusive;

pub use levalab_core::MAX_SEGMENTS;

/// Largest design file that is read, bytes: more than the largest that the limits below allow.
pub const MAX_FILE_BYTES: usize = 1 << 20;

/// How deep objects and lists of a design file nest at most: a design has six levels, and no file can exhaust the stack.
pub const MAX_FILE_DEPTH: usize = 16;

/// Longest title, characters: what fits a line of a diagram.
pub const MAX_TITLE: usize = 64;

/// Longest link that is opened, characters.
pub const MAX_LINK_OPENED: usize = 8192;

/// Longest link that is made, characters: what chat programs, mail readers and QR codes still carry whole.
pub const MAX_LINK_MADE: usize = 2000;

/// Most bytes that the section of tables of a link unpacks to.
pub const MAX_INFLATED: usize = 1 << 16;

/// How many bytes one packed byte of a link may unpack to: no more than tables come to, so that no link can exhaust the memory.
pub const MAX_INFLATION: usize = 100;

/// Most points of a table in a file or a link of version 1.
pub const MAX_TABLE_POINTS_OF_VERSION_1: usize = 128;

/// Most points of measured data that are read, to be reduced to those of a table.
pub const MAX_MEASURED_POINTS: usize = 8192;

/// Most points of all tables of a design that needs version 2: two of the largest tables, computed within a frame or two.
pub const MAX_DESIGN_POINTS: usize = 2048;

/// Sizes (radii, arms, distances), in the unit of the design: from a nanometre in mm to a kilometre, beyond any cam, and
/// with room for the cubes and fifth powers of the formulas in an `f64`.
pub const SIZE: RangeInclusive<f64> = 1e-6..=1e6;

/// Lengths that may be negative or zero (eccentricity, offsets): as large as sizes.
pub const OFFSET: RangeInclusive<f64> = -1e6..=1e6;

/// Rises of a translating follower: as large as sizes.
pub const RISE: RangeInclusive<f64> = -1e6..=1e6;

/// Rises of an oscillating follower, degrees: half a turn to either side.
pub const SWING: RangeInclusive<f64> = -180.0..=180.0;

/// Derivatives of *s* that a curve is asked to have: what the largest lift comes to within a small part of a turn.
pub const DERIVATIVE: RangeInclusive<f64> = -1e9..=1e9;

/// β, degrees: from a thousandth of a degree, below what any cam grinder divides, to a turn.
pub const BETA: RangeInclusive<f64> = 1e-3..=360.0;

/// Angles that place a follower, degrees: a turn to either side.
pub const ANGLE: RangeInclusive<f64> = -360.0..=360.0;

/// Speed in any of its units: above a turn in a few hundred years, below what holds together.
pub const SPEED: RangeInclusive<f64> = 1e-9..=1e9;

/// Most points to hit in an application: a sheet of measurements, and still a link that travels.
pub const MAX_TARGETS: usize = 64;

/// Stiffnesses and pressures of an application, in any unit.
pub const PROPERTY: RangeInclusive<f64> = 1e-12..=1e12;

/// Values that an application is to hit.
pub const OUTPUT: RangeInclusive<f64> = -1e12..=1e12;

/// Seconds at which an application is to hit a value: as far as the slowest cam turns.
pub const TIME: RangeInclusive<f64> = 0.0..=1e9;

/// The angle of a valve's seat, degrees: flat, and below where the head would wedge itself in.
pub const SEAT_ANGLE: RangeInclusive<f64> = 0.0..=75.0;

/// How far the β's may miss 360°, and the rises the starting height, in degrees or in the unit of the design.
pub const SUM_TOLERANCE: f64 = 1e-9;

/// What adding numbers near 360 may round away: a sum that misses by exactly [`SUM_TOLERANCE`] still passes.
pub const SUM_ROUNDING: f64 = 1e-12;

/// True for a character that turns the direction of the text after it, and so can make a title read as another.
#[must_use]
pub fn is_bidirectional(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// True for a character that leaves no mark: white space, and what Unicode calls default ignorable (joiners, fillers, selectors,
/// tags), with the blank pattern of Braille. A text of these alone looks empty, and one that begins with them looks as if it began later.
#[must_use]
pub fn is_invisible(c: char) -> bool {
    c.is_whitespace()
        || c.is_control()
        || matches!(c,
            '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}' | '\u{180b}'..='\u{180f}'
            | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{2800}' | '\u{3164}'
            | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{ffa0}' | '\u{fff0}'..='\u{fffb}' | '\u{1bca0}'..='\u{1bca3}'
            | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}')
}

/// True for a character that a title may not hold: controls, line and paragraph separators, changes of direction.
#[must_use]
pub fn is_unfit_for_title(c: char) -> bool {
    c.is_control() || is_bidirectional(c) || matches!(c, '\u{2028}' | '\u{2029}')
}
