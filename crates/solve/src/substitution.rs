//! Numbers put into the formulas at one θ.

use crate::Request;
use crate::board::{Board, LETTERS, TIMED, Two, two};
use crate::contact::{Measure, Rules, angle_of, is_beyond, rules};
use crate::curve::derivative;
use crate::document::formula;
use crate::number;
use crate::segment::{Part, sided};
use crate::substitute::{Values, substituted};
use levalab_formula::Formula;

/// Where numbers are put in, and why there.
pub struct Place {
    theta: f64,
    chosen: Option<Two>,
}

impl Place {
    /// θ, in the core's unit.
    pub fn theta(&self) -> f64 {
        self.theta
    }
}

/// How far from the extreme of a smooth curve, as a part of the cycle, a search by values may end.
const HALF_THE_DIGITS: f64 = 1e-7;

/// The place that is asked for, or where |v| is greatest: in the cycle, or in the only segment that is asked for.
pub fn place(board: &Board, request: &Request) -> Place {
    let program = &board.cam().program;
    let given = request.theta.filter(|theta| theta.is_finite());
    if let Some(theta) = given {
        let theta =
            if board.travels() { theta.clamp(0.0, program.span()) } else { theta.rem_euclid(360.0).to_radians() };
        return Place { theta, chosen: None };
    }
    let Some(k) = request.segment.filter(|&k| k < program.given().len()) else {
        let chosen = two("There $|v|$ is greatest in the cycle.", "Allí $|v|$ es máxima en el ciclo.");
        return Place { theta: fastest(board), chosen: Some(chosen) };
    };
    let part = Part::of(board, k);
    let mut best = (part.from, 0.0);
    for stretch in &part.stretches {
        for theta in stretch.zeros(2).into_iter().chain([stretch.from]) {
            let speed = stretch.at(theta).v.abs();
            if speed > best.1 {
                best = (theta, speed);
            }
        }
    }
    Place {
        theta: best.0,
        chosen: Some(two("There $|v|$ is greatest in the segment.", "Allí $|v|$ es máxima en el tramo.")),
    }
}

/// Where |v| is greatest in the cycle. The core's search by values knows the place to half the digits; the zero of *a* beside it has them all.
fn fastest(board: &Board) -> f64 {
    let (program, near) = (&board.cam().program, board.subject.analysis.summary.v.greatest_size().1);
    let stretch = &program.stretches()[program.stretch_index(near)];
    let off = |theta: f64| (theta - near).abs();
    let zero = stretch.zeros(2).into_iter().min_by(|&a, &b| off(a).total_cmp(&off(b)));
    zero.filter(|&theta| off(theta) < HALF_THE_DIGITS * program.span()).unwrap_or(near)
}

pub fn write(board: &mut Board, place: &Place) {
    let theta = place.theta;
    let shown = if place.chosen.is_some() { board.solved_place(theta) } else { board.place(theta) };
    board.heading(1, two("Numbers put in at $θ = {theta}$", "Sustitución en $θ = {theta}$"), &[("theta", &shown)]);
    if let Some(chosen) = place.chosen {
        board.say(chosen, &[]);
    }
    motion(board, theta);
    contact_at(board, theta);
}

/// s, v, a, j from the formulas of the segment, and V, A, J.
fn motion(board: &mut Board, theta: f64) {
    let program = &board.cam().program;
    let stretch = &program.stretches()[program.stretch_index(theta)];
    let part = Part::of(board, stretch.segment);
    let (form, origin, beta) = stretch.formula();
    let own = (origin - part.from).abs() > 1e-9 || (beta - part.beta()).abs() > 1e-9;
    let (letter, of_beta) = if own { ("u", "β_u") } else { ("x", "β") };
    let x = number::height((theta - origin) / beta);
    board.say(
        two("It lies in segment {n}, with ${letter} = {x}$.", "Está en el tramo {n}, con ${letter} = {x}$."),
        &[("n", &(stretch.segment + 1).to_string()), ("letter", letter), ("x", &x)],
    );
    if (theta - stretch.from).abs() < 1e-9 {
        board.say(
            two(
                "It is a joint: these are the limits from the right.",
                "Es una unión: estos son los límites por la derecha.",
            ),
            &[],
        );
    }
    let values: Values = vec![(if own { "u" } else { "x" }, x), (if own { "β_u" } else { "β" }, number::result(beta))];
    let motion = program.at(theta);
    let scaled = form.clone().scaled(board.scale(), 0.0);
    for (order, name) in LETTERS.iter().enumerate() {
        let told = board.derivative(order, motion.order(order));
        let value = formula(&told);
        match derivative(&scaled, order, letter) {
            Some(sum) if !stretch.is_still() => {
                let (left, right) = sided(order, sum, of_beta);
                let result = match left {
                    Formula::Symbol(_) => ('=', value),
                    _ => ('⇒', formula(&format!("{name} = {told}"))),
                };
                let put_in = substituted(&right, &values);
                let sides = if put_in == right { vec![result] } else { vec![('=', put_in), result] };
                board.equate(left, sides);
            }
            _ => board.show(&format!("{name} = {told}")),
        }
    }
    let omega = number::result(board.design().omega());
    for order in 1..4 {
        let raised = if order == 1 { String::new() } else { format!("^{order}") };
        let (value, timed) = (motion.order(order), TIMED[order]);
        let figure = board.figure(order, value);
        let figure = if figure.starts_with('-') { format!("({figure})") } else { figure };
        let figure = if figure.contains('^') { format!("({})", figure.trim_matches(['(', ')'])) } else { figure };
        let result = format!("{}{}", board.timed_figure(order, value), board.timed_unit(order));
        board.show(&format!("{timed} = {} ω{raised} = {figure} · {omega}{raised} = {result}", LETTERS[order]));
    }
}

/// φ, ρp, ρ and the contact.
pub fn contact_at(board: &mut Board, theta: f64) {
    let rules = rules(board.cam(), theta);
    if board.swings() {
        let [s, v, a] = [0, 1, 2].map(|order| number::result(board.settled(order, rules.motion.order(order))));
        board.say(two("In radians:", "En radianes:"), &[]);
        board.show(&format!("s = {s}, v = {v}, a = {a}"));
    }
    let mut known: Values = Vec::new();
    for &(letter, value, measure) in &rules.known {
        let order = ["s", "v", "a"].iter().position(|known| *known == letter);
        known.push((letter, written(order.map_or(value, |order| board.settled(order, value)), measure)));
    }
    for rule in &rules.rules {
        if is_beyond(&rules.contact) && rule.left == "tan(φ)" {
            board.show(&format!("φ = {}{{°}}", number::angle(rules.contact.pressure_angle.to_degrees())));
            continue;
        }
        let symbolic = formula(&rule.right);
        let put_in = substituted(&symbolic, &known);
        let mut sides = vec![('=', symbolic), ('=', put_in)];
        let shown = told(board, rule.value, rule.measure);
        if shown != rule.right && rule.right != "0" {
            sides.push(('=', formula(&shown)));
        }
        known.push((rule.left, written(rule.value, rule.measure)));
        if let Some((letter, angle)) = angle_of(rule.left, rule.value) {
            let degrees = number::angle(angle.to_degrees());
            sides.push(('⇒', formula(&format!("{letter} = {degrees}{{°}}"))));
            known.push((letter, format!("{degrees}°")));
        }
        board.equate(formula(rule.left), sides);
    }
    straight(board, &rules);
}

/// What an infinite radius means.
fn straight(board: &mut Board, rules: &Rules) {
    if rules.rules.iter().any(|rule| rule.left.starts_with('ρ') && rule.value.is_infinite()) {
        board.say(two("The profile is straight there.", "El perfil es recto allí."), &[]);
    }
}

fn written(value: f64, measure: Measure) -> String {
    match measure {
        Measure::Angle => format!("{}°", number::angle(value.to_degrees())),
        Measure::Length => number::height(value),
        Measure::Number => number::height(number::settled(value, 1.0)),
    }
}

fn told(board: &Board, value: f64, measure: Measure) -> String {
    match measure {
        Measure::Angle => number::angle(value.to_degrees()) + "{°}",
        Measure::Length if value.is_infinite() => number::result(value),
        Measure::Length => number::result(value) + &board.length(),
        Measure::Number => number::result(number::settled(value, 1.0)),
    }
}
