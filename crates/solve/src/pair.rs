//! The second cam of a conjugate pair.

use crate::board::{Board, two};
use crate::document::{Block, formula};
use crate::number;
use crate::substitute::substituted;
use crate::substitution::{Place, contact_of};
use crate::{extremes, verdict};
use levalab_core::{Body, Cam, Element, angle_between, profiles_coincide};
use levalab_format::Design;

pub fn write(board: &mut Board, first: &Cam, place: &Place) {
    board.heading(1, two("The second cam", "La segunda leva"), &[]);
    board.say(
        two(
            "Its element is fixed to the same follower, on the other side of the shaft: it advances when the first retreats, $s → s_(max) - s$. What ties both gives its size:",
            "Su elemento está unido al mismo seguidor, al otro lado del eje: avanza cuando el primero retrocede, $s → s_(max) - s$. Lo que une ambos da su tamaño:",
        ),
        &[],
    );
    size(board, first);
    if profiles_coincide(first, board.cam()) {
        let note = levalab_words::profiles_coincide(board.language);
        board.say(two(note, note), &[]);
    }
    board.say(
        two(
            "All that follows is of its own $s$, from its own base circle.",
            "Todo lo que sigue se refiere a su propia $s$, desde su propia circunferencia base.",
        ),
        &[],
    );
    extremes::write(board);
    let theta = board.solved_place(place.theta());
    board.heading(2, two("Numbers put in at $θ = {theta}$", "Sustitución en $θ = {theta}$"), &[("theta", &theta)]);
    let motion = place.motion(board.cam());
    board.show(&format!(
        "s = {}, v = {}, a = {}",
        board.derivative(0, motion.s),
        board.derivative(1, motion.v),
        board.derivative(2, motion.a)
    ));
    contact_of(board, motion);
    verdict::write(board);
    // All of it is a part of this part.
    for block in board.blocks.iter_mut().skip(1) {
        if let Block::Heading(level, _) = block {
            *level = 2;
        }
    }
}

/// What the size of the second cam follows from, each letter with its value (angles in radians), and the formula of its squared prime
/// radius or of its base radius.
struct Tied {
    known: Vec<(&'static str, f64, bool)>,
    left: &'static str,
    right: &'static str,
    value: f64,
}

fn tied(design: &Design, first: &Cam, second: &Cam) -> Tied {
    let (one, two) = (&first.follower, &second.follower);
    let value = |key: &str| one.value(key).unwrap_or(0.0);
    let (prime, second_prime) = (one.base_radius() + one.disc_radius(), two.base_radius() + two.disc_radius());
    let swings = matches!(one.body(), Body::Swing { .. });
    let top = ("s_max", two.reversed().unwrap_or(0.0), swings);
    let distance = design.conjugate.map_or(0.0, |pair| pair.tie.value());
    let angle = ("Γ", angle_between(first, second).unwrap_or(0.0), true);
    let opening = ("ξ_0", one.opening().unwrap_or(0.0), true);
    let (m, e) = (("m", value("pivot_distance"), false), value("eccentricity"));
    match (one.element(), swings) {
        (Element::Face { .. }, false) => Tied {
            known: vec![
                ("D", distance, false),
                ("R_b1", one.base_radius(), false),
                top,
                ("γ", value("face_angle"), true),
            ],
            left: "R_(b2)",
            right: if value("face_angle") == 0.0 { "D - R_(b1) - s_(max)" } else { "D - R_(b1) - s_(max) cos(γ)" },
            value: two.base_radius(),
        },
        (Element::Disc { .. }, false) if e == 0.0 => Tied {
            known: vec![("D", distance, false), ("R_p1", prime, false), top],
            left: "R_(p2)",
            right: "D - R_(p1) - s_(max)",
            value: second_prime,
        },
        (Element::Disc { .. }, false) => Tied {
            known: vec![
                ("D", distance, false),
                ("e", e, false),
                ("s_0", ((prime - e) * (prime + e)).sqrt(), false),
                top,
            ],
            left: "R_(p2)",
            right: "sqrt(e^2 + (D - s_0 - s_(max))^2)",
            value: second_prime,
        },
        (Element::Disc { .. }, true) => Tied {
            known: vec![m, ("A", value("arm"), false), angle, opening, top],
            left: "R_(p2)",
            right: "sqrt(m^2 + A^2 - 2m A cos(Γ - ξ_0 - s_(max)))",
            value: second_prime,
        },
        (Element::Face { .. }, true) => Tied {
            known: vec![m, ("f", value("face_offset"), false), angle, opening, top],
            left: "R_(b2)",
            right: "f + m sin(Γ - ξ_0 - s_(max))",
            value: two.base_radius(),
        },
    }
}

fn size(board: &mut Board, first: &Cam) {
    let second = board.cam();
    let Tied { known, left, right, value } = tied(board.design(), first, second);
    let written = |&(letter, value, angle): &(&'static str, f64, bool)| {
        (letter, if angle { number::angle(value.to_degrees()) + "°" } else { number::height(value) })
    };
    let values = known.iter().map(written).collect();
    let symbolic = formula(right);
    let put_in = substituted(&symbolic, &values);
    let length = board.length();
    let told = |value: f64| formula(&(number::result(value) + &length));
    board.equate(formula(left), vec![('=', symbolic), ('=', put_in), ('=', told(value))]);
    let radius = second.follower.disc_radius();
    if radius > 0.0 {
        let (prime, radius, base) =
            (number::result(value), number::datum(radius), number::result(second.follower.base_radius()));
        board.show(&format!("R_(b2) = R_(p2) - R_(f2) = {prime} - {radius} = {base}{length}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_format::testing::{Random, design};
    use levalab_formula::parse;
    use nalgebra::Complex;
    use std::collections::BTreeSet;

    #[test]
    fn the_size_of_a_second_cam_is_that_of_the_formula() {
        let mut random = Random::new(77);
        let mut kinds = BTreeSet::new();
        for _ in 0..600 {
            let design = design(&mut random);
            let Ok(first) = design.cam() else { continue };
            let Ok(Some(second)) = design.second(&first) else { continue };
            let Tied { known, right, value, .. } = tied(&design, &first, &second);
            let of = |letter: &str| known.iter().find(|known| known.0 == letter).map(|known| Complex::from(known.1));
            let found = parse(right).expect(right).value(&of).expect(right).re;
            assert!(
                (found - value).abs() < 1e-7 * (1.0 + value),
                "{} {right}: {found}, not {value}",
                design.follower.id
            );
            kinds.insert(design.follower.id);
        }
        assert!(kinds.len() >= 5, "{kinds:?}");
    }
}
