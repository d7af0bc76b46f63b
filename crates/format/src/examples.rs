//! The examples library: published cams with known figures.

use crate::Design;

/// The example that the page opens with: four laws side by side.
pub const FIRST_EXAMPLE: &str = include_str!("../../../examples/9RT.lev.json");

/// Every example: its name and its design file. What to look at in each is told in `crates/words/examples.json`.
pub const EXAMPLES: &[(&str, &str)] = &[
    ("1RT", include_str!("../../../examples/1RT.lev.json")),
    ("2RO", include_str!("../../../examples/2RO.lev.json")),
    ("3PT", include_str!("../../../examples/3PT.lev.json")),
    ("4PO", include_str!("../../../examples/4PO.lev.json")),
    ("5ACRT", include_str!("../../../examples/5ACRT.lev.json")),
    ("6ACPT", include_str!("../../../examples/6ACPT.lev.json")),
    ("7CRT", include_str!("../../../examples/7CRT.lev.json")),
    ("8DA", include_str!("../../../examples/8DA.lev.json")),
    ("9RT", FIRST_EXAMPLE),
    ("10EX", include_str!("../../../examples/10EX.lev.json")),
    ("11RO", include_str!("../../../examples/11RO.lev.json")),
    ("12PO", include_str!("../../../examples/12PO.lev.json")),
    ("R1", include_str!("../../../examples/R1.lev.json")),
    ("R2", include_str!("../../../examples/R2.lev.json")),
    ("R3", include_str!("../../../examples/R3.lev.json")),
    ("R4", include_str!("../../../examples/R4.lev.json")),
    ("R5", include_str!("../../../examples/R5.lev.json")),
    ("R6", include_str!("../../../examples/R6.lev.json")),
    ("WEDGE", include_str!("../../../examples/WEDGE.lev.json")),
    ("GROOVE", include_str!("../../../examples/GROOVE.lev.json")),
    ("ARCS", include_str!("../../../examples/ARCS.lev.json")),
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
    fn examples_from_books_are_named_after_themselves_and_all_differ() {
        let mut titles = Vec::new();
        for (name, _) in EXAMPLES {
            let title = example(name).expect(name).title;
            // Those of our own say what they are.
            let of_our_own = name.chars().all(|c| c.is_ascii_uppercase());
            assert!(of_our_own != (title == format!("Example {name}")), "{name}: {title}");
            assert!(!title.is_empty() && !titles.contains(&title), "{title}");
            titles.push(title);
        }
        assert_eq!(example("nothing"), None);
    }
}
