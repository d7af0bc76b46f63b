//! What is said of an application. Apart from the voices, so that a page without one does not carry it.

use crate::{Language, Units, capital, two};
use levalab_core::application::Magnitude;
use levalab_format::{ApplicationDesign, Design, Outcome, OutputRange, Target};
use levalab_numbers::write;

/// The name of an application, of one of its outputs, parameters or figures, as within a sentence: `piston pump`, `flow`, `piston radius`.
#[must_use]
pub fn application_name(language: Language, id: &str) -> &str {
    let (en, es) = match id {
        "force" => ("force", "fuerza"),
        "piston-force" => ("force of a piston on enclosed fluid", "fuerza de un pistón sobre fluido encerrado"),
        "pump" => ("piston pump", "bomba de pistón"),
        "valve" => ("poppet valve", "válvula de asiento"),
        "pressure" => ("pressure", "presión"),
        "volume" => ("swept volume", "volumen barrido"),
        "flow" => ("flow", "caudal"),
        "area" => ("curtain area", "área de la cortina"),
        "stiffness" => ("stiffness", "rigidez"),
        "pressure_per_volume" => ("pressure per volume", "presión por volumen"),
        "piston_radius" => ("piston radius", "radio del pistón"),
        "piston_area" => ("piston area", "área del pistón"),
        "seat_diameter" => ("inner diameter of the seat", "diámetro interior del asiento"),
        "seat_angle" => ("seat angle", "ángulo del asiento"),
        _ => return id,
    };
    two(en, es).within(language)
}

/// The name of an application where it stands alone, in a menu: a force needs to say in proportion to what.
#[must_use]
pub fn application_title(language: Language, id: &str) -> String {
    let name = match (id, language) {
        ("force", Language::En) => "force in proportion to the displacement",
        ("force", Language::Es) => "fuerza proporcional al desplazamiento",
        _ => application_name(language, id),
    };
    capital(name)
}

/// The same with a capital, as at the head of a line.
#[must_use]
pub fn application_head(language: Language, id: &str) -> String {
    capital(application_name(language, id))
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
        let head = application_head(self.language, output.id);
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
        let name = application_name(language, output.id);
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
    use levalab_core::application::APPLICATIONS;
    use levalab_format::example;

    #[test]
    fn everything_of_an_application_has_a_name_in_every_language() {
        for application in APPLICATIONS {
            let outputs = application.outputs.iter().map(|output| output.id);
            let settings = application.parameters.iter().map(|setting| setting.key);
            let figures = application.figures.iter().map(|figure| figure.id);
            for id in [application.id].into_iter().chain(outputs).chain(settings).chain(figures) {
                let [en, es] = Language::ALL.map(|language| application_name(language, id));
                assert!(en != es && !en.contains(['_', '-']) && !es.contains(['_', '-']), "{id}: {en}, {es}");
            }
        }
    }

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
