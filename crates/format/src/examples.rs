//! The examples library: published cams with known figures.

use crate::Design;

/// Every example: its name and its design file.
pub const EXAMPLES: &[(&str, &str)] = &[
    ("R1", include_str!("../../../examples/R1.lev.json")),
    ("R5", include_str!("../../../examples/R5.lev.json")),
    ("2RO", include_str!("../../../examples/2RO.lev.json")),
    ("4PO", include_str!("../../../examples/4PO.lev.json")),
    ("9RT", include_str!("../../../examples/9RT.lev.json")),
    ("10EX", include_str!("../../../examples/10EX.lev.json")),
    ("12PO", include_str!("../../../examples/12PO.lev.json")),
];

/// The design of an example.
#[must_use]
pub fn example(name: &str) -> Option<Design> {
    let (_, json) = EXAMPLES.iter().find(|(id, _)| *id == name)?;
    Design::from_json(json).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::link;

    #[test]
    fn every_example_opens_and_round_trips_as_file_and_as_link() {
        for (name, json) in EXAMPLES {
            let design = Design::from_json(json).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(&design.to_json(), json, "{name} is written as it was read");
            assert_eq!(Design::from_value(&design.to_value()).as_ref(), Ok(&design), "{name}");
            let text = link::encode(&design).expect("short enough");
            assert_eq!(link::decode(&text), Ok(design), "{name}: {text}");
        }
    }

    #[test]
    fn examples_are_named_after_themselves() {
        for (name, _) in EXAMPLES {
            assert_eq!(example(name).map(|design| design.title), Some(format!("Example {name}")));
        }
        assert_eq!(example("nothing"), None);
    }
}
