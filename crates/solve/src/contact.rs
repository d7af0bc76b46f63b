//! φ, ρ and the contact of each follower, as formulas of s, v and a, with the values of the core.

use levalab_core::{Body, Cam, Contact, Drive, Element, Svaj};
use std::f64::consts::PI;

/// What a value is, and so how it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    Length,
    /// Radians, written as degrees.
    Angle,
    /// A pure number, or a derivative of an angle.
    Number,
}

/// A letter with its value.
pub type Known = (&'static str, f64, Measure);

/// A formula: its left side, its right side in letters that are known by then, and what it comes to.
#[derive(Debug)]
pub struct Rule {
    pub left: &'static str,
    pub right: String,
    pub value: f64,
    pub measure: Measure,
}

/// What is known of a cam at an instant, and what follows, in the order in which it does.
pub struct Rules {
    pub known: Vec<Known>,
    pub rules: Vec<Rule>,
    pub motion: Svaj,
    pub contact: Contact,
}

/// The rules of a cam while its follower has a given motion. The second cam of a pair is as if seen from the other side: it turns in the
/// other sense.
pub fn rules(cam: &Cam, motion: Svaj) -> Rules {
    let follower = &cam.follower;
    let contact = cam.contact(motion);
    let value = |key: &str| follower.value(key).unwrap_or(0.0);
    let mirrored = if follower.reversed().is_some() { -1.0 } else { 1.0 };
    let sigma = follower.rotation().sigma() * mirrored;
    let swings = matches!(follower.body(), Body::Swing { .. });
    let of_s = if swings { Measure::Angle } else { Measure::Length };
    let of_v = if swings { Measure::Number } else { Measure::Length };
    let mut known: Vec<Known> = vec![("s", motion.s, of_s), ("v", motion.v, of_v), ("a", motion.a, of_v)];
    let mut rules: Vec<Rule> = Vec::new();
    let mut rule = |left: &'static str, right: &str, value: f64, measure: Measure| {
        rules.push(Rule { left, right: right.to_owned(), value, measure });
    };
    let tangent = contact.pressure_angle.tan();
    let turns = follower.drive() == Drive::Turns;
    if turns {
        known.push(("R_b", follower.base_radius(), Measure::Length));
    }
    match (follower.element(), follower.body()) {
        (Element::Disc { radius, .. }, body) => {
            let rolls = radius > 0.0;
            let prime = follower.base_radius() + radius;
            if rolls {
                known.push(("R_f", radius, Measure::Length));
            }
            if rolls && turns {
                rule("R_p", "R_b + R_f", prime, Measure::Length);
            }
            let start = if rolls { "R_p" } else { "R_b" };
            let pitch = 1.0 / contact.bend;
            match body {
                _ if !turns => {
                    rule("tan(φ)", "v", tangent, Measure::Number);
                    rule("ρ_p", "-([1 + v^2]^(3/2))/a", pitch, Measure::Length);
                }
                Body::Slide if value("eccentricity") == 0.0 => {
                    rule("tan(φ)", &format!("v/({start} + s)"), tangent, Measure::Number);
                    let right = format!("([({start} + s)^2 + v^2]^(3/2))/(({start} + s)^2 + 2v^2 - a({start} + s))");
                    rule("ρ_p", &right, pitch, Measure::Length);
                }
                Body::Slide => {
                    let e = value("eccentricity");
                    known.push(("e", e, Measure::Length));
                    known.push(("σ", sigma, Measure::Number));
                    let height = ((prime - e) * (prime + e)).sqrt();
                    rule("s_0", &format!("sqrt({start}^2 - e^2)"), height, Measure::Length);
                    rule("tan(φ)", "(v - σe)/(s_0 + s)", tangent, Measure::Number);
                    let right = "([(s_0 + s)^2 + (v - σe)^2]^(3/2))/((s_0 + s)^2 + (v - σe)(2v - σe) - a(s_0 + s))";
                    rule("ρ_p", right, pitch, Measure::Length);
                }
                Body::Swing { .. } => {
                    known.push(("A", value("arm"), Measure::Length));
                    known.push(("m", value("pivot_distance"), Measure::Length));
                    known.push(("σ", sigma, Measure::Number));
                    let opening = follower.opening().unwrap_or(0.0) - follower.reversed().unwrap_or(0.0);
                    rule("cos(ξ_0)", &format!("(m^2 + A^2 - {start}^2)/(2m A)"), opening.cos(), Measure::Number);
                    rule("ξ", "ξ_0 + s", opening + motion.s, Measure::Angle);
                    rule("k", "1 + σv", 1.0 + sigma * motion.v, Measure::Number);
                    rule("tan(φ)", "(σ A k - σ m cos(ξ))/(m sin(ξ))", tangent, Measure::Number);
                    let right =
                        "([m^2 + A^2 k^2 - 2m A k cos(ξ)]^(3/2))/(m^2 - m A (k + k^2) cos(ξ) + A^2 k^3 - m A a sin(ξ))";
                    rule("ρ_p", right, pitch, Measure::Length);
                }
            }
            if rolls {
                rule("ρ", "ρ_p - R_f", follower.profile_radius(contact.bend), Measure::Length);
            }
        }
        (Element::Face { .. }, Body::Slide) => {
            let gamma = value("face_angle") * mirrored;
            known.push(("σ", sigma, Measure::Number));
            if gamma == 0.0 {
                rule("φ", "0", contact.pressure_angle, Measure::Angle);
                rule("ρ", "R_b + s + a", contact.bend, Measure::Length);
                rule("q", "σv", contact.reach, Measure::Length);
            } else {
                known.push(("γ", gamma, Measure::Angle));
                rule("φ", "σγ", contact.pressure_angle, Measure::Angle);
                rule("ρ", "R_b + (s + a) cos(γ)", contact.bend, Measure::Length);
                rule("q", "σ v cos^2(γ) - (R_b + s cos(γ)) sin(γ)", contact.reach, Measure::Length);
            }
        }
        (Element::Face { .. }, Body::Swing { .. }) => {
            known.push(("m", value("pivot_distance"), Measure::Length));
            known.push(("f", value("face_offset"), Measure::Length));
            known.push(("σ", sigma, Measure::Number));
            let opening = ((follower.base_radius() - value("face_offset")) / value("pivot_distance")).asin();
            rule("sin(ξ_0)", "(R_b - f)/m", opening.sin(), Measure::Number);
            rule("ξ", "ξ_0 + s", opening + motion.s, Measure::Angle);
            rule("k", "1 + σv", 1.0 + sigma * motion.v, Measure::Number);
            rule("q", "(m cos(ξ))/k", contact.reach, Measure::Length);
            rule("tan(φ)", "(σ f)/q", tangent, Measure::Number);
            let right = "f + m sin(ξ) (1 + 2σv)/(k^2) + (m a cos(ξ))/(k^3)";
            rule("ρ", right, contact.bend, Measure::Length);
        }
    }
    Rules { known, rules, motion, contact }
}

/// The angle whose sine or cosine a rule tells.
pub fn angle_of(left: &str, value: f64) -> Option<(&'static str, f64)> {
    match left {
        "cos(ξ_0)" => Some(("ξ_0", value.clamp(-1.0, 1.0).acos())),
        "sin(ξ_0)" => Some(("ξ_0", value.clamp(-1.0, 1.0).asin())),
        "tan(φ)" => Some(("φ", value.atan())),
        _ => None,
    }
}

/// An angle of the core beyond a quarter turn has a tangent that does not tell it.
pub fn is_beyond(contact: &Contact) -> bool {
    contact.pressure_angle.abs() > 0.5 * PI
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_format::testing::{Random, design};
    use levalab_formula::parse;
    use nalgebra::Complex;
    use std::f64::consts::TAU;

    fn check(name: &str, cam: &Cam) -> usize {
        let mut checked = 0;
        for i in 0..24 {
            let rules = rules(cam, cam.program.at(cam.program.span() * f64::from(i) / 24.0 + 0.01));
            let mut known = rules.known.clone();
            for rule in &rules.rules {
                let value =
                    |letter: &str| known.iter().find(|(name, ..)| *name == letter).map(|known| Complex::from(known.1));
                let printed = parse(&rule.right).expect(&rule.right).value(&value).expect(&rule.right).re;
                // A radius of curvature that goes to infinity is compared as a curvature, where it is worth anything.
                let near = |a: f64, b: f64| match rule.measure {
                    Measure::Angle => ((a - b) / TAU - ((a - b) / TAU).round()).abs() <= 1e-6,
                    _ => (a - b).abs() <= 1e-6 * (1.0 + a.abs().max(b.abs())),
                };
                let size = 1e6 * cam.follower.base_radius().max(1.0);
                let endless = rule.value.abs() > size && printed.abs() > size;
                let still = rules.contact.bend.abs() < 1e-12;
                // A face that keeps pace with the cam touches it nowhere: k = 0 is divided by.
                let stalled = rules.contact.lead.abs() < 1e-6;
                assert!(
                    endless || still || stalled || near(printed, rule.value),
                    "{name}: {} = {}: {printed}, not {}",
                    rule.left,
                    rule.right,
                    rule.value
                );
                checked += 1;
                known.push((rule.left, rule.value, rule.measure));
                known.extend(angle_of(rule.left, rule.value).map(|(letter, angle)| (letter, angle, Measure::Angle)));
            }
        }
        checked
    }

    #[test]
    fn printed_formulas_give_what_the_core_computes_for_every_follower_and_for_second_cams() {
        let mut random = Random::new(20_260_704);
        let (mut kinds, mut seconds) = (std::collections::BTreeSet::new(), 0);
        for round in 0..1200 {
            let design = design(&mut random);
            let Ok(cam) = design.cam() else { continue };
            kinds.insert((design.follower.id, design.kind.word()));
            check(&format!("{round} {}", design.follower.id), &cam);
            if let Ok(Some(second)) = design.second(&cam) {
                seconds += check(&format!("{round} second {}", design.follower.id), &second);
            }
        }
        assert!(kinds.len() >= 10 && seconds > 100, "{kinds:?} {seconds}");
    }
}
