//! How large the cam must be: from φ, from ρ, and with every limit.

use crate::board::{Board, two};
use crate::contact::rules;
use crate::document::formula;
use crate::limit::nearest;
use crate::number;
use crate::substitute::substituted;
use levalab_core::{SizeLimit, shortest_travel, smallest_base_radius, smallest_for};

pub fn write(board: &mut Board) {
    board.heading(1, two("Size of the cam", "Tamaño de la leva"), &[]);
    let travels = board.travels();
    let symbol = if travels { "X" } else { "R_b" };
    if travels {
        board.say(
            two(
                "With all $β$ in proportion, a longer travel $X$ makes $v$ and $a$ smaller.",
                "Con todos los $β$ en proporción, un recorrido $X$ mayor hace menores $v$ y $a$.",
            ),
            &[],
        );
    }
    slope(board, symbol);
    curvature(board, symbol);
    let cam = board.cam();
    let whole = if travels { shortest_travel(cam) } else { smallest_base_radius(cam) };
    match whole {
        Some(size) if size > VANISHED * size_of(board) => {
            board.say(two("With every geometric limit together:", "Con todos los límites geométricos a la vez:"), &[]);
            board.show(&format!("{symbol} ≥ {}{}", number::result(size), board.length()));
        }
        Some(_) => {}
        None => board.say(
            two(
                "No size of it keeps every geometric limit with this motion and this follower.",
                "Con este movimiento y este seguidor ningún tamaño cumple todos los límites geométricos.",
            ),
            &[],
        ),
    }
}

/// A size this small beside that of the cam is none.
const VANISHED: f64 = 1e-5;

fn size_of(board: &Board) -> f64 {
    if board.travels() { board.cam().program.span() } else { board.cam().follower.base_radius() }
}

fn slope(board: &mut Board, symbol: &str) {
    let cam = board.cam();
    let limit = number::angle(cam.follower.pressure_angle_limit().to_degrees());
    let angles = board.study.analysis().summary.pressure_angle;
    let (value, at) = angles.greatest_size();
    if angles.max - angles.min <= number::NEGLIGIBLE {
        let told = format!("$|φ| = {}{{°}}$", number::angle(value.to_degrees()));
        return board.say(
            two(
                "The pressure angle is the same all along, {value}, whatever the size; the limit is {limit}.",
                "El ángulo de presión es siempre el mismo, {value}, con cualquier tamaño; el límite es {limit}.",
            ),
            &[("value", &told), ("limit", &format!("${limit}{{°}}$"))],
        );
    }
    board.say(
        two(
            "From the pressure angle: $|φ|$ is greatest at $θ = {at}$,",
            "Por el ángulo de presión: $|φ|$ es máximo en $θ = {at}$,",
        ),
        &[("at", &board.solved_place(at))],
    );
    // The value that is greatest, with its formula.
    let (_, motion) = nearest(cam, at, value, |motion| cam.contact(motion).pressure_angle.abs());
    let rules = rules(cam, motion);
    let mut known: Vec<(&'static str, String)> =
        rules.known.iter().map(|&(letter, value, _)| (letter, number::height(value))).collect();
    known.extend(rules.rules.iter().map(|rule| (rule.left, number::height(rule.value))));
    let tangent = rules.rules.iter().find(|rule| rule.left == "tan(φ)");
    let degrees = number::angle(value.to_degrees());
    match tangent.filter(|_| !board.swings() && !crate::contact::is_beyond(&rules.contact)) {
        Some(rule) => {
            let symbolic = formula(&rule.right);
            let put_in = substituted(&symbolic, &known);
            let sides = vec![
                ('=', symbolic),
                ('=', put_in),
                ('=', formula(&number::result(rule.value))),
                ('⇒', formula(&format!("|φ| = {degrees}{{°}}"))),
            ];
            board.equate(formula("tan(φ)"), sides);
        }
        None => board.show(&format!("|φ| = {degrees}{{°}}")),
    }
    let within = value <= cam.follower.pressure_angle_limit();
    let needed = smallest_for(cam, SizeLimit::PressureAngle).map(|size| number::result(size) + &board.length());
    match needed {
        Some(size) => {
            board.say(
                two(
                    "and the limit is {limit}. Solved for the size with which its greatest value is just that:",
                    "y el límite es {limit}. Resuelto el tamaño con el que su máximo es justo ese:",
                ),
                &[("limit", &format!("${limit}{{°}}$"))],
            );
            board.show(&format!("|φ| ≤ {limit}{{°}} ⇒ {symbol} ≥ {size}"));
        }
        None if within => board.say(
            two("within the limit of {limit} whatever the size.", "dentro del límite de {limit} con cualquier tamaño."),
            &[("limit", &format!("${limit}{{°}}$"))],
        ),
        None => board.say(
            two(
                "beyond the limit of {limit}, and no size brings it within.",
                "mayor que el límite de {limit}, y ningún tamaño lo cumple.",
            ),
            &[("limit", &format!("${limit}{{°}}$"))],
        ),
    }
}

fn curvature(board: &mut Board, symbol: &str) {
    let cam = board.cam();
    let summary = &board.study.analysis().summary;
    let flat = cam.follower.is_flat();
    let condition = match cam.follower.disc_radius() {
        0.0 if flat => "ρ > 0",
        0.0 => "ρ_p > 0",
        _ => "ρ = ρ_p - R_f > 0",
    };
    let sound = summary.least_convex.is_none_or(|(value, _)| value > 0.0);
    let needed = smallest_for(cam, SizeLimit::Curvature);
    if flat && !board.swings() && cam.follower.value("face_angle") == Some(0.0) {
        let (least, at) = (summary.rho.min, summary.rho.min_at);
        let sum = number::result(least - cam.follower.base_radius());
        board.say(
            two(
                "From the radius of curvature: $ρ = R_b + s + a$ is least at $θ = {at}$,",
                "Por el radio de curvatura: $ρ = R_b + s + a$ es mínimo en $θ = {at}$,",
            ),
            &[("at", &board.solved_place(at))],
        );
        let length = board.length();
        board.show(&format!(
            "ρ_(min) = R_b + min(s + a) = {}{length}, min(s + a) = {sum}{length}",
            number::result(least)
        ));
        match needed {
            Some(_) => board.say(two("so that there is no cusp when", "así que no hay cúspide cuando"), &[]),
            None if sound => {
                board.say(
                    two(
                        "so that there is no cusp, whatever the size.",
                        "así que no hay cúspide, sea cual sea el tamaño.",
                    ),
                    &[],
                );
            }
            None => {
                board.say(two("so that every size has a cusp.", "así que con cualquier tamaño hay cúspide."), &[]);
            }
        }
    } else {
        let lead = match needed {
            Some(_) => two(
                "From the radius of curvature: the profile has neither cusp nor undercut when",
                "Por el radio de curvatura: el perfil no tiene cúspide ni rebaje cuando",
            ),
            None if sound => two(
                "From the radius of curvature: the profile has neither cusp nor undercut when ${condition}$, which holds whatever the size.",
                "Por el radio de curvatura: el perfil no tiene cúspide ni rebaje cuando ${condition}$, lo que se cumple con cualquier tamaño.",
            ),
            None => two(
                "From the radius of curvature: the profile has neither cusp nor undercut when ${condition}$, which no size brings about.",
                "Por el radio de curvatura: el perfil no tiene cúspide ni rebaje cuando ${condition}$, lo que ningún tamaño consigue.",
            ),
        };
        board.say(lead, &[("condition", condition)]);
    }
    if let Some(size) = needed {
        board.show(&format!("{condition} ⇒ {symbol} > {}{}", number::result(size), board.length()));
    }
}
