//! The versions of design file and link, and which of them a design needs: the only place where laws, followers and data that
//! version 1 does not know are asked for.

use crate::limits::{MAX_DESIGN_POINTS, MAX_TABLE_POINTS_OF_VERSION_1};
use crate::{DataRefusal, Design, DesignError, Path, ProgramRefusal, SegmentDesign};
use levalab_core::law::{Data, MAX_POINTS};
use levalab_core::{FollowerKind, Law};

/// A version of the design file and of the link. Both count alike: a link of a version holds what a file of that version holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// Everything that was known in the first release.
    One,
    /// Tables of more than 128 points.
    Two,
}

/// What the first field of a design file begins with, before the number of its version.
const FORMAT: &str = "levalab/";

impl Version {
    /// The newest that is known here.
    pub const LATEST: Self = Self::Two;

    /// The versions that are read, in order.
    pub const ALL: [Self; 2] = [Self::One, Self::Two];

    /// The first field of a design file of this version.
    #[must_use]
    pub fn format(self) -> &'static str {
        match self {
            Self::One => "levalab/1",
            Self::Two => "levalab/2",
        }
    }

    /// The first field of a link of this version.
    pub(crate) fn number(self) -> &'static str {
        match self {
            Self::One => "1",
            Self::Two => "2",
        }
    }

    /// The most points that a table may have in a design of this version.
    pub(crate) fn max_table_points(self) -> usize {
        match self {
            Self::One => MAX_TABLE_POINTS_OF_VERSION_1,
            Self::Two => MAX_POINTS,
        }
    }

    /// True when a law is known in this version.
    pub(crate) fn has_law(self, law: &Law) -> bool {
        of_law(law) <= self
    }

    /// True when a follower is known in this version.
    pub(crate) fn has_follower(self, kind: &FollowerKind) -> bool {
        of_follower(kind) <= self
    }
}

/// True for the first field of a design file whose version is higher than any known here.
pub(crate) fn is_newer(format: &str) -> bool {
    let number = format.strip_prefix(FORMAT).unwrap_or_default();
    let is_number =
        number.starts_with(|c: char| c.is_ascii_digit() && c != '0') && number.bytes().all(|b| b.is_ascii_digit());
    is_number && !Version::ALL.iter().any(|version| version.number() == number)
}

impl Design {
    /// The version of file and link that the design needs: the lowest that can hold all of its parts.
    #[must_use]
    pub fn version(&self) -> Version {
        let of_segments = self.segments.iter().map(|segment| of_law(segment.law).max(of_data(&segment.data)));
        of_segments.fold(of_follower(self.follower), Version::max)
    }

    /// Refuses tables that are longer than those of a version.
    pub(crate) fn check_tables(&self, version: Version) -> Result<(), DesignError> {
        let max = version.max_table_points();
        let long = |segment: &SegmentDesign| points_of(&segment.data) > max;
        let Some(k) = self.segments.iter().position(long) else { return Ok(()) };
        let found = points_of(&self.segments[k].data);
        let place = Path::from("segments").join(k).join("points");
        Err(DesignError::at(place, DataRefusal::WrongCount { found, min: 2, max }))
    }

    /// Refuses more points than a design may have. Designs of version 1 are bounded by their segments and tables alone.
    pub(crate) fn check_points(&self) -> Result<(), DesignError> {
        let found = self.segments.iter().map(|segment| points_of(&segment.data)).sum();
        if self.version() == Version::One || found <= MAX_DESIGN_POINTS {
            return Ok(());
        }
        Err(DesignError::at("segments", ProgramRefusal::TooManyPoints { found, limit: MAX_DESIGN_POINTS }))
    }
}

/// The version from which a law is known. A law that is new in a version is named here.
fn of_law(_law: &Law) -> Version {
    Version::One
}

/// The version from which a follower is known. A follower that is new in a version is named here.
fn of_follower(_kind: &FollowerKind) -> Version {
    Version::One
}

/// The version from which the data of a law can be held.
fn of_data(data: &Data) -> Version {
    if points_of(data) > MAX_TABLE_POINTS_OF_VERSION_1 { Version::Two } else { Version::One }
}

fn points_of(data: &Data) -> usize {
    match data {
        Data::Points(points) => points.len(),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_count_up_from_one() {
        for (version, number) in Version::ALL.into_iter().zip(1..) {
            assert_eq!(version.format(), format!("levalab/{number}"));
            assert_eq!(version.number(), number.to_string());
        }
        assert_eq!(Version::ALL.last(), Some(&Version::LATEST));
        assert!(Version::ALL.is_sorted());
    }

    #[test]
    fn only_a_higher_number_is_newer() {
        for newer in ["levalab/3", "levalab/10", "levalab/999999999999999999999"] {
            assert!(is_newer(newer), "{newer}");
        }
        for other in [
            "levalab/1",
            "levalab/2",
            "levalab/0",
            "levalab/",
            "levalab/2.1",
            "levalab/-3",
            "levalab/03",
            "lobes/3",
            "",
        ] {
            assert!(!is_newer(other), "{other}");
        }
    }
}
