//! Whose symbols a design is told in. Which symbols those are is in `levalab-words`.

use crate::Design;

/// A notation: that of a book, of a way of writing, or ours. It changes what is shown and typed, and nothing else of the design.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Notation {
    /// Our own.
    #[default]
    LevaLab,
    /// Norton's.
    Norton,
    /// Uicker, Pennock and Shigley's.
    Shigley,
    /// Rothbart's.
    Rothbart,
    /// Cardona and Clos's.
    CardonaClos,
    /// Capital S, V, A, J, as many courses in Spanish write.
    Capitals,
}

impl Notation {
    /// Every notation, in the order of a menu: ours first.
    pub const ALL: [Self; 6] =
        [Self::LevaLab, Self::Norton, Self::Shigley, Self::Rothbart, Self::CardonaClos, Self::Capitals];

    /// The words for them, in the same order.
    pub const WORDS: [&str; 6] = ["levalab", "norton", "shigley", "rothbart", "cardona-clos", "capitals"];

    /// Its word in design files.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::WORDS[self as usize]
    }

    /// The notation of a word.
    #[must_use]
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|notation| notation.word() == word)
    }
}

impl Design {
    /// What an eccentricity is multiplied by to be shown, and once more to be kept: 1, or −1 where the notation counts it the other way.
    ///
    /// Norton's formula of the pressure angle, φ = atan((v − ε)/(s + √(Rp² − ε²))), names no sense of rotation: ε is positive on the side
    /// where it makes φ smaller in the rise, which is ours when the cam turns counter-clockwise and the other when it turns clockwise.
    #[must_use]
    pub fn eccentricity_sign(&self) -> f64 {
        if self.notation == Notation::Norton { self.rotation.sigma() } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{self, Random};
    use levalab_core::Rotation;

    #[test]
    fn a_notation_is_kept_by_file_and_link_and_ours_is_not_written() {
        for notation in Notation::ALL {
            let design = Design { notation, ..crate::example("9RT").expect("9RT") };
            assert_eq!(Design::from_json(&design.to_json()), Ok(design.clone()));
            assert_eq!(design.to_json().contains("notation"), notation != Notation::LevaLab);
            assert_eq!(crate::link::decode(&crate::link::encode(&design).expect("short")), Ok(design));
            assert_eq!(Notation::of_word(notation.word()), Some(notation));
        }
    }

    #[test]
    fn an_eccentricity_that_is_shown_and_typed_again_is_the_same() {
        let mut random = Random::new(9);
        for _ in 0..200 {
            let design = testing::design(&mut random);
            for notation in Notation::ALL {
                let told = Design { notation, ..design.clone() };
                let sign = told.eccentricity_sign();
                for value in design.values {
                    assert_eq!(value * sign * sign, value);
                }
                let turned = notation == Notation::Norton && design.rotation == Rotation::Clockwise;
                assert_eq!(sign < 0.0, turned);
                // Nothing but what is shown depends on it.
                assert_eq!(
                    told.cam().expect("a cam").follower.values(),
                    design.cam().expect("a cam").follower.values()
                );
            }
        }
    }
}
