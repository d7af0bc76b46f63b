//! Why a gap of a program was joined as it was, and what keeps one from being joined.

use crate::{Language, Units, law_alone, two};
use levalab_core::{Choice, JoinProblem, Reason, Taste, Tried, Way};
use levalab_format::Design;

/// Others that are named beside the one chosen.
const NAMED: usize = 3;

/// What was chosen in each gap and why, with the figures that it was compared by; once for gaps of which all that is the same.
#[must_use]
pub fn choices(language: Language, design: &Design, choices: &[Choice], taste: Taste) -> Vec<String> {
    let mut told: Vec<(Vec<String>, String)> = Vec::new();
    for choice in choices {
        let [from, to] = [choice.from, choice.to].map(|theta| language.angle(theta.to_degrees()));
        let span = match language {
            Language::En => format!("from {from} to {to}"),
            Language::Es => format!("de {from} a {to}"),
        };
        let why = reason(language, design, choice, taste);
        match told.iter_mut().find(|(_, known)| *known == why) {
            Some((spans, _)) => spans.push(span),
            None => told.push((vec![span], why)),
        }
    }
    let and = two(" and ", " y ").within(language);
    told.into_iter().map(|(spans, why)| format!("{}: {why}", capitalised(&listed(&spans, and)))).collect()
}

/// `a, b and c`.
fn listed(items: &[String], and: &str) -> String {
    match items {
        [before @ .., last] if !before.is_empty() => format!("{}{and}{last}", before.join(", ")),
        _ => items.concat(),
    }
}

/// With a capital where a sentence begins, which is a plain letter here.
fn capitalised(text: &str) -> String {
    text.get(..1).map_or_else(String::new, str::to_ascii_uppercase) + text.get(1..).unwrap_or_default()
}

fn reason(language: Language, design: &Design, choice: &Choice, taste: Taste) -> String {
    let units = Units::of(design);
    let peak = |tried: &Tried| {
        let value = units.travel(tried.peaks[taste.least - 1], taste.least as u8, language);
        format!("|{}| {value}", ["v", "a", "j"][taste.least - 1])
    };
    let text = match (choice.reason, choice.tried.first(), language) {
        (Reason::Stays, _, Language::En) => "it stays at its height.".to_owned(),
        (Reason::Stays, _, Language::Es) => "se queda a su altura.".to_owned(),
        (Reason::InLine, _, Language::En) => "it goes straight on, at the same velocity.".to_owned(),
        (Reason::InLine, _, Language::Es) => "sigue recto, a la misma velocidad.".to_owned(),
        (Reason::Only, Some(chosen), Language::En) => {
            let order = if taste.high_speed { "jerk" } else { "acceleration" };
            format!(
                "{}, the only one with a continuous {order} here; peak {}.",
                way(language, chosen.way),
                peak(chosen)
            )
        }
        (Reason::Only, Some(chosen), Language::Es) => {
            let order = if taste.high_speed { "sobreaceleración" } else { "aceleración" };
            format!("{}, la única con {order} continua aquí; máximo {}.", way(language, chosen.way), peak(chosen))
        }
        (Reason::Least, Some(chosen), _) => {
            let above = choice.tried[1..].iter().filter(|tried| tried.above);
            let others: Vec<String> =
                above.take(NAMED).map(|tried| format!("{} {}", way(language, tried.way), peak(tried))).collect();
            let others = others.join("; ");
            let beside = match (others.is_empty(), language) {
                (true, _) => String::new(),
                (false, Language::En) => format!(" Next: {others}."),
                (false, Language::Es) => format!(" Después: {others}."),
            };
            let smooth = match (taste.high_speed, language) {
                (false, Language::En) => "continuous acceleration",
                (true, Language::En) => "continuous jerk",
                (false, Language::Es) => "aceleración continua",
                (true, Language::Es) => "sobreaceleración continua",
            };
            let chosen = format!("{}, ", way(language, chosen.way))
                + &match language {
                    Language::En => format!("with {}, the lowest peak of those with {smooth}.", peak(chosen)),
                    Language::Es => format!("con {}, el menor máximo de las que tienen {smooth}.", peak(chosen)),
                };
            chosen + &beside
        }
        (_, None, _) => String::new(),
    };
    let below = choice.tried.iter().filter(|tried| !tried.above).count();
    let below = match (below, language) {
        (0, _) => String::new(),
        (1, Language::En) => " One more would go below the base circle.".to_owned(),
        (count, Language::En) => format!(" {count} more would go below the base circle."),
        (1, Language::Es) => " Otra bajaría de la circunferencia base.".to_owned(),
        (count, Language::Es) => format!(" Otras {count} bajarían de la circunferencia base."),
    };
    text + &below
}

fn way(language: Language, way: Way) -> String {
    match (way, language) {
        (Way::Law(of), _) => law_alone(language, of).to_owned(),
        (Way::Waiting(of), Language::En) => {
            format!("a dwell and then as short as it can be, {}", law_alone(language, of))
        }
        (Way::Waiting(of), Language::Es) => {
            format!("un detenimiento y, lo más corta posible, {}", law_alone(language, of))
        }
        (Way::Pieces, Language::En) => "a polynomial from point to point".to_owned(),
        (Way::Pieces, Language::Es) => "una polinómica de punto a punto".to_owned(),
        (Way::Stops, Language::En) => "a polynomial from point to point, at rest for an instant at each".to_owned(),
        (Way::Stops, Language::Es) => "una polinómica de punto a punto, en reposo un instante en cada uno".to_owned(),
    }
}

/// What keeps a list of requirements from being met.
pub(crate) fn problem(language: Language, problem: JoinProblem) -> String {
    let [en, es] = match problem {
        JoinProblem::Nothing => [
            "Nothing moves: require a height, a line or a point.",
            "Nada se mueve: pida una altura, una recta o un punto.",
        ],
        JoinProblem::TooMany => [
            "There are more requirements than a program has room for.",
            "Hay más requisitos de los que caben en un programa.",
        ],
        JoinProblem::Place => [
            "It must lie between 0° and 360°, and end after it begins.",
            "Tiene que estar entre 0° y 360°, y acabar después de empezar.",
        ],
        JoinProblem::Overlap { other } => {
            return match language {
                Language::En => format!("It begins before requirement {} ends.", other + 1),
                Language::Es => format!("Empieza antes de que acabe el requisito {}.", other + 1),
            };
        }
        JoinProblem::Clash { other } => {
            return match language {
                Language::En => {
                    format!(
                        "It meets requirement {} at another height or velocity: leave room between them.",
                        other + 1
                    )
                }
                Language::Es => {
                    format!("Toca el requisito {} a otra altura o velocidad: deje sitio entre los dos.", other + 1)
                }
            };
        }
        JoinProblem::Low => [
            "It would go below the base circle: heights are 0 or more, and at 0 the follower can only rest.",
            "Bajaría de la circunferencia base: las alturas son 0 o más, y en 0 el seguidor solo puede reposar.",
        ],
        JoinProblem::StartsHigh => [
            "At 0° the follower is on the base circle, so here s must be 0.",
            "En 0° el seguidor está sobre la circunferencia base, así que aquí s tiene que ser 0.",
        ],
        JoinProblem::NoWay => [
            "After this one no law reaches the next without going below the base circle: leave more room, or more height.",
            "Después de este ninguna ley llega al siguiente sin bajar de la circunferencia base: deje más sitio, o más altura.",
        ],
    };
    two(en, es).within(language).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_alike_are_told_once() {
        let text = r#"{"format": "levalab/1", "title": "", "speed": {"value": 1, "unit": "rad/s"}, "cam": {"kind": "rotating", "base_radius": 40},
            "follower": {"motion": "translating", "contact": "roller", "roller_radius": 8},
            "requirements": [{"dwell": [0, 30], "s": 0}, {"dwell": [90, 120], "s": 10}, {"dwell": [180, 200], "s": 0}, {"dwell": [300, 330], "s": 20}]}"#;
        let joined = levalab_format::joined_from_bytes(text.as_bytes()).expect("joined");
        let told = |language| choices(language, &joined.design, &joined.choices, joined.taste);
        let spans = |sentences: Vec<String>| -> Vec<String> {
            sentences.iter().filter_map(|sentence| Some(sentence.split_once(':')?.0.to_owned())).collect()
        };
        assert_eq!(
            spans(told(Language::En)),
            ["From 30° to 90° and from 120° to 180°", "From 200° to 300°", "From 330° to 360°"]
        );
        assert_eq!(spans(told(Language::Es))[0], "De 30° a 90° y de 120° a 180°");
    }
}
