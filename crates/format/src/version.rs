//! The version of file and link that a design needs: the rows of the catalogue say it of laws, followers, kinds and applications, this file of
//! data.

use crate::limits::{MAX_DESIGN_POINTS, MAX_TABLE_POINTS_OF_VERSION_1};
use crate::{DataRefusal, Design, DesignError, Path, ProgramRefusal, SegmentDesign};
use levalab_catalogue::{Version, application_label, follower_label, kind_label, law_label};
use levalab_core::law::{Data, MAX_POINTS};
use levalab_core::{FollowerKind, Law};

/// What the first field of a design file begins with, before the number of its version.
const FORMAT: &str = "levalab/";

/// The most points that a table may have in a design of a version.
pub(crate) fn max_table_points(version: Version) -> usize {
    match version {
        Version::One => MAX_TABLE_POINTS_OF_VERSION_1,
        Version::Two => MAX_POINTS,
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
        let application = self.application.as_ref().and_then(|set| application_label(set.application));
        let of_labels = [kind_label(self.kind.word()), application].into_iter().flatten().map(|label| label.since);
        of_segments.chain(of_labels).fold(of_follower(self.follower), Version::max)
    }

    /// Refuses tables that are longer than those of a version.
    pub(crate) fn check_tables(&self, version: Version) -> Result<(), DesignError> {
        let max = max_table_points(version);
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

/// The version from which a law is known.
pub(crate) fn of_law(law: &Law) -> Version {
    law_label(law).map_or(Version::LATEST, |label| label.since)
}

/// The version from which a follower is known.
pub(crate) fn of_follower(kind: &FollowerKind) -> Version {
    follower_label(kind).map_or(Version::LATEST, |label| label.since)
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
    fn one_segment_with_a_newer_law_asks_for_its_version() {
        let mut design = crate::example("9RT").expect("9RT");
        for &law in levalab_core::LAWS {
            design.segments[2].law = law;
            assert_eq!(Some(design.version()), law_label(law).map(|label| label.since), "{}", law.id);
        }
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
