//! `levalab licenses`: its own licence, and those of everything that is built in.

use crate::run::said;

#[test]
fn its_own_licence_and_those_of_others_are_written_whole() {
    let written = said(&["licenses"]);
    for part in [include_str!("../../../../LICENSE"), include_str!("../../../../LICENSE-THIRD-PARTY.txt")] {
        assert!(written.contains(part.trim()));
    }
    for work in
        ["\n* nalgebra ", "\n* clap ", "\n* epaint_default_fonts ", "\n* alloc, core, std (standard library of Rust)\n"]
    {
        assert!(written.contains(work), "{work}");
    }
}

#[test]
fn either_spelling_is_understood() {
    assert_eq!(said(&["licences"]), said(&["licenses"]));
}
