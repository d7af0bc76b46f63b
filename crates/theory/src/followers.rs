//! A follower's section of the theory.

use crate::html::Pen;
use crate::pages::Assets;
use crate::words::two;
use levalab_catalogue::{FollowerRow, follower_row};
use levalab_core::FollowerKind;

/// Place, name and body.
#[must_use]
pub fn entry(pen: Pen, kind: &FollowerKind, assets: &Assets) -> (String, String, String) {
    let name = levalab_words::capital(levalab_words::follower(pen.language, kind));
    let body = follower_row(kind).map(|row| body(pen, row, assets)).unwrap_or_default();
    (kind.id.to_owned(), name, body)
}

fn body(pen: Pen, words: &FollowerRow, assets: &Assets) -> String {
    let within = |words: super::words::Two| words.within(pen.language);
    let formulas = |formulas: &[&str]| formulas.iter().map(|formula| pen.displayed(formula)).collect::<String>();
    let part = |name: super::words::Two, body: String| format!("<h4>{}</h4>{body}", within(name));
    let paragraph = |text: super::words::Two| pen.paragraphs(within(text));
    [
        assets.drawing(words.id, ""),
        paragraph(words.idea),
        part(two("Construction of the profile", "Construcción del perfil"), formulas(words.construction)),
        part(two("Pressure angle", "Ángulo de presión"), formulas(&[words.pressure_angle])),
        part(two("Radius of curvature", "Radio de curvatura"), formulas(words.radius)),
        part(two("Contact", "Contacto"), paragraph(words.contact)),
        part(two("What fails, and its cure", "Qué falla y cómo se remedia"), paragraph(words.fails)),
        pen.source(words.source),
    ]
    .concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_core::{FOLLOWERS, Follower, Rotation, Svaj};
    use levalab_formula::{Formula, parse};
    use nalgebra::Complex;
    use std::collections::BTreeMap;

    type Known = BTreeMap<String, Complex<f64>>;

    /// Learns what the formulas define, and checks those whose sides are all known.
    fn read(text: &str, known: &mut Known) {
        let Ok(formula) = parse(text) else { panic!("{text}") };
        let equations = if let Formula::List(items) = &formula { items.iter().collect() } else { vec![&formula] };
        for equation in equations {
            let sides = equation.sides();
            let value = |side: &Formula| side.value(&|name| known.get(name).copied());
            let Some(right) = value(sides[1]) else { panic!("{text}: nothing is known of the right side") };
            match (sides[0], value(sides[0])) {
                (_, Some(left)) => {
                    assert!((left - right).norm() < 1e-9 * (1.0 + right.norm()), "{text}: {left} and {right}");
                }
                (Formula::Symbol(name), None) => {
                    known.insert(name.clone(), right);
                }
                (Formula::Call(name, inner), None) => {
                    let Formula::Symbol(symbol) = &**inner else { panic!("{text}") };
                    let angle = match *name {
                        "sin" => right.re.asin(),
                        "cos" => right.re.acos(),
                        "tan" => right.re.atan(),
                        _ => panic!("{text}"),
                    };
                    known.insert(symbol.clone(), angle.into());
                }
                _ => panic!("{text}"),
            }
        }
    }

    #[test]
    fn printed_formulas_of_followers_are_those_of_the_core() {
        let motions =
            [Svaj::new(0.1, 0.05, -0.04, 0.0), Svaj::new(0.02, -0.06, 0.09, 0.0), Svaj::new(0.0, 0.0, 0.03, 0.0)];
        for kind in FOLLOWERS {
            let words = follower_row(kind).expect(kind.id);
            for rotation in [Rotation::CounterClockwise, Rotation::Clockwise] {
                for motion in motions {
                    let values = kind.parameters.iter().map(|parameter| match parameter.key {
                        "roller_radius" | "face_radius" => 0.2,
                        "eccentricity" => 0.15,
                        "face_angle" => 0.1,
                        "arm" => 1.7,
                        "pivot_distance" => 2.0,
                        "face_offset" => 0.25,
                        _ => 0.0,
                    });
                    let mut list = [0.0; levalab_core::MAX_FOLLOWER_PARAMETERS];
                    values.enumerate().for_each(|(i, value)| list[i] = value);
                    let placed = Follower::new(kind, 1.0, &list, rotation).expect(kind.id);
                    let contact = placed.contact(motion);
                    let mut known = Known::new();
                    let mut give = |name: &str, value: f64| {
                        known.insert(name.to_owned(), value.into());
                    };
                    for (name, value) in [
                        ("s", motion.s),
                        ("v", motion.v),
                        ("a", motion.a),
                        ("R_b", 1.0),
                        ("σ", rotation.sigma()),
                        ("θ", 0.4),
                    ] {
                        give(name, value);
                    }
                    for (parameter, value) in kind.parameters.iter().zip(list) {
                        let symbol = if parameter.symbol == "Rf" { "R_f" } else { parameter.symbol };
                        give(symbol, value);
                    }
                    words.construction.iter().for_each(|text| read(text, &mut known));
                    read(words.pressure_angle, &mut known);
                    let order =
                        if kind.id == "oscillating-flat" { vec![1, 0] } else { (0..words.radius.len()).collect() };
                    order.iter().for_each(|&i| read(words.radius[i], &mut known));
                    let is = |name: &str, expected: f64| {
                        let found = known[name].re;
                        assert!(
                            (found - expected).abs() < 1e-9 * (1.0 + expected.abs()),
                            "{} {name}: {found}, not {expected}",
                            kind.id
                        );
                    };
                    is("φ", contact.pressure_angle);
                    is("ρ", placed.profile_radius(contact.bend));
                    if let Some(pitch) = known.get("P") {
                        let turned = Complex::from_polar(1.0, -rotation.sigma() * 0.4);
                        assert!((pitch - contact.trace * turned).norm() < 1e-9, "{}: {pitch}", kind.id);
                    }
                }
            }
        }
    }
}
