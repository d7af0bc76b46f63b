//! Why a design has no second cam. Apart from the voices, so that a page that adds none does not carry it.

use crate::{Language, Units, finding, two};
use levalab_core::Tie;
use levalab_format::Design;
use levalab_format::report::Report;

/// What is wrong with the best that there is: which tie it has, and each thing that its cam fails in.
#[must_use]
pub fn no_second(language: Language, design: &Design, tie: Tie, report: &Report) -> String {
    let length = |value: f64| Units::of(design).length(value, language);
    let angle = |value: f64| language.angle(value);
    let nearest = match (language, tie) {
        (Language::En, Tie::Distance(value)) => {
            format!("No distance gives a second cam; the nearest to one is {}.", length(value))
        }
        (Language::Es, Tie::Distance(value)) => {
            format!("Ninguna distancia da una segunda leva; la que más se acerca es {}.", length(value))
        }
        (Language::En, Tie::Angle(value)) => {
            format!("No angle between the arms gives a second cam; the nearest to one is {}.", angle(value))
        }
        (Language::Es, Tie::Angle(value)) => {
            format!("Ningún ángulo entre los brazos da una segunda leva; el que más se acerca es {}.", angle(value))
        }
        (Language::En, Tie::BaseRadius(value)) => {
            format!("No base radius of the second cam works; the nearest is {}.", length(value))
        }
        (Language::Es, Tie::BaseRadius(value)) => {
            format!("Ningún radio base de la segunda leva sirve; el que más se acerca es {}.", length(value))
        }
    };
    let geometric = report.findings.iter().filter(|found| !found.kind.is_of_the_motion());
    let wrong: Vec<String> = geometric.map(|found| finding(language, design, found)).collect();
    let there = two("There, of the second cam:", "Allí, de la segunda leva:").within(language);
    format!("{nearest} {there} {}", wrong.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_format::example;

    #[test]
    fn the_pair_of_the_classic_program_that_cannot_be_says_what_fails() {
        let design = example("11RO").expect("11RO");
        let (tie, report) = design.nearest_second(Tie::Angle(0.0), None).expect("some room");
        let [en, es] = Language::ALL.map(|language| no_second(language, &design, tie, &report));
        assert_eq!(
            en,
            "No angle between the arms gives a second cam; the nearest to one is 98.6°. There, of the second cam: \
             At 134.8° the arm of the follower would cut 1.354\u{a0}mm deep into the cam."
        );
        assert_eq!(
            es,
            "Ningún ángulo entre los brazos da una segunda leva; el que más se acerca es 98,6°. Allí, de la segunda leva: \
             En 134,8° el brazo del seguidor penetraría 1,354\u{a0}mm en la leva."
        );
    }
}
