//! Sequences of random edits with undo and redo, in search of one that panics, gives what is no design, or is not taken back.
//!
//! `LEVALAB_SOAK` says how many sequences; `cargo xtask soak` runs them optimised. The seed is fixed, so a failure can be repeated.

use levalab_format::link;
use levalab_format::testing::{self, Random};
use levalab_format::{Design, Edit, apply, apply_to_value};

/// How many sequences, unless told otherwise.
const COUNT: usize = 2_000;

/// Edits of a sequence at most.
const LENGTH: usize = 12;

fn count() -> usize {
    std::env::var("LEVALAB_SOAK").map_or(COUNT, |text| text.parse().expect("LEVALAB_SOAK is a number"))
}

/// A design on its way through edits, with what undo and redo go back and forth through.
struct Desk {
    design: Design,
    past: Vec<Design>,
    future: Vec<Design>,
}

impl Desk {
    /// Makes an edit, or is as it was; true when it was made.
    fn edit(&mut self, edit: &Edit) -> bool {
        let before = self.design.to_json();
        match apply(&self.design, std::slice::from_ref(edit)) {
            Ok(after) => {
                let whole = format!("{edit:?} of\n{before}");
                assert_eq!(
                    apply_to_value(self.design.to_value(), std::slice::from_ref(edit)).as_ref(),
                    Ok(&after),
                    "{whole}"
                );
                assert_eq!(
                    apply_to_value(after.to_value(), &[]).as_ref(),
                    Ok(&after),
                    "the file gives it back: {whole}"
                );
                self.past.push(std::mem::replace(&mut self.design, after));
                self.future.clear();
                true
            }
            Err(_) => {
                assert_eq!(self.design.to_json(), before, "a refused edit changes nothing");
                false
            }
        }
    }

    fn undo(&mut self) {
        if let Some(before) = self.past.pop() {
            self.future.push(std::mem::replace(&mut self.design, before));
        }
    }

    fn redo(&mut self) {
        if let Some(after) = self.future.pop() {
            self.past.push(std::mem::replace(&mut self.design, after));
        }
    }
}

/// A design that makes a cam is given back by its file and its link; of any other the outline is told without a number that is none.
fn live(design: &Design) -> bool {
    let outline = design.outline();
    let numbers = outline.heights.iter().chain([&outline.left, &outline.open, &outline.lift]);
    assert!(numbers.into_iter().all(|number| number.is_finite()), "{outline:?}\n{}", design.to_json());
    if design.cam().is_err() {
        return false;
    }
    assert_eq!((outline.left, outline.open), (0.0, 0.0), "a cam is closed: {outline:?}\n{}", design.to_json());
    assert_eq!(Design::from_json(&design.to_json()).as_ref(), Ok(design), "the file gives it back");
    if let Ok(text) = link::encode(design) {
        assert_eq!(link::decode(&text).as_ref(), Ok(design), "{text} gives it back");
    }
    true
}

#[test]
fn every_edit_is_good_or_refused_and_undoing_gives_the_design_back() {
    let mut random = Random::new(6);
    let (mut made, mut refused, mut good) = (0_usize, 0_usize, 0_usize);
    for _ in 0..count() {
        let first = testing::design(&mut random);
        let mut desk = Desk { design: first.clone(), past: Vec::new(), future: Vec::new() };
        for _ in 0..1 + random.below(LENGTH) {
            match random.below(6) {
                0 => {
                    let (now, steps) = (desk.design.to_json(), desk.past.len());
                    desk.undo();
                    if steps > 0 && random.once_in(2) {
                        desk.redo();
                        assert_eq!(desk.design.to_json(), now, "redo gives back what undo took");
                    }
                }
                1 => desk.redo(),
                _ => {
                    let edit = testing::edit(&mut random, &desk.design);
                    if desk.edit(&edit) {
                        made += 1;
                        good += usize::from(live(&desk.design));
                    } else {
                        refused += 1;
                    }
                }
            }
        }
        while !desk.past.is_empty() {
            desk.undo();
        }
        assert_eq!((desk.design.to_json(), &desk.design), (first.to_json(), &first), "undone to the beginning");
    }
    assert!(
        made > count() && good > count() / 2 && refused > count() / 4,
        "{made} made, {good} good, {refused} refused"
    );
}
