//! The version of file and link that a design needs.

use crate::Design;
use levalab_catalogue::{Label, Version, application_label, follower_label, kind_label, law_label};

/// The first version that knows everything the design names: its laws, its follower, its kind of cam and its application.
#[must_use]
pub fn needed_version(design: &Design) -> Version {
    let laws = design.segments.iter().map(|segment| law_label(segment.law));
    let application = design.application.as_ref().map(|set| application_label(set.application));
    let others = [follower_label(design.follower), kind_label(design.kind.word())];
    let labels = laws.chain(others).chain(application).flatten();
    labels.map(|label: &Label| label.since).max().unwrap_or(Version::One)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::EXAMPLES;
    use levalab_core::LAWS;

    #[test]
    fn examples_need_version_one() {
        for (name, json) in EXAMPLES {
            let design = Design::from_json(json).expect(name);
            assert_eq!(needed_version(&design), Version::One, "{name}");
        }
    }

    #[test]
    fn one_segment_with_a_newer_law_asks_for_its_version() {
        let mut design = crate::example("9RT").expect("9RT");
        for &law in LAWS {
            design.segments[2].law = law;
            assert_eq!(Some(needed_version(&design)), law_label(law).map(|label| label.since), "{}", law.id);
        }
    }
}
