//! What is said of an application. Apart from the voices, so that a page without one does not carry it.

use crate::{Language, Units, capital};
use levalab_catalogue::application_label;
use levalab_core::application::{Application, Magnitude};
use levalab_format::{ApplicationDesign, Design, Outcome, OutputRange, Target};
use levalab_numbers::write;

/// The name of an application within a sentence: `piston pump`.
#[must_use]
pub fn application_name(language: Language, application: &Application) -> &'static str {
    application_label(application).map_or(application.id, |label| label.noun.within(language))
}

/// The name of an application at the head of a line: `Piston pump`.
#[must_use]
pub fn application_title(language: Language, application: &Application) -> String {
    capital(application_name(language, application))
}

/// The name of an output, a parameter or a figure of an application, as within a sentence: `flow`, `piston radius`.
#[must_use]
pub fn part_name(language: Language, id: &'static str) -> &'static str {
    levalab_catalogue::part_name(id).map_or(id, |name| name.within(language))
}

/// The same with a capital, as at the head of a line.
#[must_use]
pub fn part_head(language: Language, id: &'static str) -> String {
    capital(part_name(language, id))
}

/// What comes of an application, a sentence each: extremes, what a turn delivers, every target with its error.
#[must_use]
pub fn outcome(language: Language, design: &Design, outcome: &Outcome) -> Vec<String> {
    let sentences = Sentences { language, design };
    let ranges = outcome.outputs.iter().map(|output| sentences.range(output));
    let delivered = outcome.outputs.iter().filter_map(|output| sentences.delivered(output));
    let main = design.application.as_ref().map(ApplicationDesign::main);
    let targets = outcome.targets.iter().filter_map(|target| Some(sentences.target(main?, target)));
    ranges.chain(delivered).chain(targets).collect()
}

struct Sentences<'a> {
    language: Language,
    design: &'a Design,
}

impl Sentences<'_> {
    fn range(&self, output: &OutputRange) -> String {
        let OutputRange { output, range, .. } = output;
        let told = |value: f64| self.measured(&self.fine(value), output.magnitude);
        let [least, most] = [told(range.min), told(range.max)];
        let [least_at, most_at] = [self.place(range.min_at), self.place(range.max_at)];
        let head = part_head(self.language, output.id);
        match self.language {
            Language::En => format!("{head} from {least} at {least_at} to {most} at {most_at}."),
            Language::Es => format!("{head} de {least} en {least_at} a {most} en {most_at}."),
        }
    }

    fn delivered(&self, output: &OutputRange) -> Option<String> {
        let volume = self.measured(&self.fine(output.per_cycle?), output.output.magnitude);
        let travels = self.design.kind.travel().is_some();
        Some(match (self.language, travels) {
            (Language::En, false) => format!("Each turn delivers {volume}."),
            (Language::Es, false) => format!("Cada vuelta entrega {volume}."),
            (Language::En, true) => format!("Each journey there and back delivers {volume}."),
            (Language::Es, true) => format!("Cada ida y vuelta entrega {volume}."),
        })
    }

    fn target(&self, output: &levalab_core::application::Output, target: &Target) -> String {
        let Target { theta, time, value, found, error } = *target;
        let language = self.language;
        let exact = |value: f64| self.measured(&language.exact(value), output.magnitude);
        let close = |value: f64| self.measured(&language.number(value), output.magnitude);
        let found = self.measured(&self.fine(found), output.magnitude);
        let place = self.place_exact(theta);
        let seconds = format!("{}\u{a0}s", language.number(time));
        let name = part_name(language, output.id);
        match language {
            Language::En => {
                format!("At {place} ({seconds}) the {name} is {found}, to be {}: error {}.", exact(value), close(error))
            }
            Language::Es => {
                format!("En {place} ({seconds}), {name}: {found}, y se pide {}; error {}.", exact(value), close(error))
            }
        }
    }

    /// As many digits as measurements are told with.
    fn fine(&self, value: f64) -> String {
        write::significant(value, 6, self.language.decimal_sign())
    }

    fn measured(&self, number: &str, magnitude: Magnitude) -> String {
        format!("{number}\u{a0}{}", self.design.length_unit.unit_of(magnitude))
    }

    fn place(&self, place: f64) -> String {
        match self.design.kind.travel() {
            Some(_) => Units::of(self.design).length(place, self.language),
            None => self.language.angle(place),
        }
    }

    fn place_exact(&self, place: f64) -> String {
        match self.design.kind.travel() {
            Some(_) => Units::of(self.design).length(place, self.language),
            None => self.fine(place) + "°",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_core::Analysis;
    use levalab_format::example;

    #[test]
    fn the_gait_simulator_in_words() {
        let design = example("R6").expect("R6");
        let cam = design.cam().expect("a cam");
        let application = design.application.as_ref().expect("a piston");
        let found = application.outcome(&design, &cam, &Analysis::of(&cam, 1));
        let said = |language| outcome(language, &design, &found);
        let english = said(Language::En);
        assert_eq!(english.len(), 7);
        let told = "At 56.88° (0.079\u{a0}s) the force is 110.282\u{a0}lbf, to be 110.282\u{a0}lbf: error −1.225·10⁻⁸\u{a0}lbf.";
        assert_eq!(english[3], told);
        let spanish = said(Language::Es);
        let told = "En 56,88° (0,079\u{a0}s), fuerza: 110,282\u{a0}lbf, y se pide 110,282\u{a0}lbf; error −1,225·10⁻⁸\u{a0}lbf.";
        assert_eq!(spanish[3], told);
        assert!(
            spanish[0].starts_with("Fuerza de") && spanish[0].ends_with("a 126,183\u{a0}lbf en 74,4°."),
            "{spanish:?}"
        );
    }
}
