//! Numbers put into the formulas at one θ.

use crate::Request;
use crate::board::{Board, LETTERS, TIMED, Two, two};
use crate::contact::{Measure, Rules, angle_of, is_beyond, rules};
use crate::curve::derivative;
use crate::document::formula;
use crate::limit::{nearest, place_on};
use crate::number;
use crate::segment::{Part, sided};
use crate::substitute::{Values, substituted};
use levalab_core::{Cam, Svaj};
use levalab_formula::Formula;

/// Where numbers are put in, and why there.
pub struct Place {
    theta: f64,
    /// The stretch whose formulas hold: at a joint, the one before it or the one after it.
    stretch: usize,
    chosen: Option<Two>,
}

/// How far from the extreme of a smooth curve, as a part of the cycle, a search by values may end.
const HALF_THE_DIGITS: f64 = 1e-7;

/// Of two values of |v| closer than this part of them, the first is the one to name.
const ROUNDING: f64 = 1e-9;

impl Place {
    /// The place that is asked for, or where |v| has its maximum: in the cycle, or in the only segment that is asked for.
    pub fn of(board: &Board, request: &Request) -> Self {
        let program = &board.cam().program;
        if let Some(theta) = request.theta.filter(|theta| theta.is_finite()) {
            let theta =
                if board.travels() { theta.clamp(0.0, program.span()) } else { theta.rem_euclid(360.0).to_radians() };
            return Self { theta, stretch: program.stretch_index(theta), chosen: None };
        }
        let only = request.segment.filter(|&k| k < program.given().len());
        let (theta, stretch, speed) = fastest(board, only);
        let still = speed <= 0.0;
        let chosen = match only {
            None if still => two(
                "The follower never moves: $v = 0$ in the whole cycle.",
                "El seguidor no se mueve nunca: $v = 0$ en todo el ciclo.",
            ),
            Some(_) if still => {
                two("The follower rests in this segment: $v = 0$.", "El seguidor reposa en este tramo: $v = 0$.")
            }
            None => two("There $|v|$ is greatest in the cycle.", "Allí $|v|$ es máxima en el ciclo."),
            Some(_) => two("There $|v|$ is greatest in the segment.", "Allí $|v|$ es máxima en el tramo."),
        };
        Self { theta, stretch, chosen: Some(chosen) }
    }

    /// θ, in the core's unit.
    pub fn theta(&self) -> f64 {
        self.theta
    }

    /// The motion there, of this cam or of the other one of a pair, whose stretches are as long.
    pub fn motion(&self, cam: &Cam) -> Svaj {
        cam.program.stretches()[self.stretch].at(self.theta)
    }
}

/// Where |v| has its maximum, from which stretch, and its value: in the cycle or in one segment. The limits at both ends of every stretch are looked
/// at, since |v| may grow up to a joint, and jump there.
fn fastest(board: &Board, segment: Option<usize>) -> (f64, usize, f64) {
    let program = &board.cam().program;
    let mut best: Option<(f64, usize, f64)> = None;
    for (k, stretch) in program.stretches().iter().enumerate() {
        if segment.is_some_and(|segment| segment != stretch.segment) {
            continue;
        }
        for theta in std::iter::once(stretch.from).chain(stretch.zeros(2)).chain([stretch.to]) {
            let speed = stretch.at(theta).v.abs();
            if best.is_none_or(|best| speed > best.2 * (1.0 + ROUNDING)) {
                best = Some((theta, k, speed));
            }
        }
    }
    let best = best.unwrap_or((0.0, 0, 0.0));
    // Where the numbers are equal on both sides of a joint, those of the segment that begins there are put in.
    let next = best.1 + 1;
    let begins_next =
        program.stretches().get(next).filter(|next| segment.is_none_or(|segment| segment == next.segment));
    let best = match begins_next {
        Some(after) if after.from == best.0 && after.at(best.0).v.abs() >= best.2 * (1.0 - ROUNDING) => {
            (best.0, next, best.2)
        }
        _ => best,
    };
    searched(board, segment).filter(|found| found.2 > best.2 * (1.0 + ROUNDING)).unwrap_or(best)
}

/// The maximum that the core found in the cycle by a finer search, for a motion with narrow features.
fn searched(board: &Board, segment: Option<usize>) -> Option<(f64, usize, f64)> {
    let (speed, near) = board.study.analysis().summary.v.greatest_size();
    let (k, _) = nearest(board.cam(), near, speed, |motion| motion.v.abs());
    let program = &board.cam().program;
    let (stretch, near) = (&program.stretches()[k], place_on(program, k, near));
    if segment.is_some_and(|segment| segment != stretch.segment) {
        return None;
    }
    let off = |theta: f64| (theta - near).abs();
    let zero = stretch.zeros(2).into_iter().min_by(|&a, &b| off(a).total_cmp(&off(b)));
    let exact = zero.filter(|&theta| off(theta) < HALF_THE_DIGITS * program.span()).unwrap_or(near);
    Some((exact, k, speed))
}

pub fn write(board: &mut Board, place: &Place) {
    let theta = place.theta;
    let shown = if place.chosen.is_some() { board.solved_place(theta) } else { board.place(theta) };
    board.heading(1, two("Numbers put in at $θ = {theta}$", "Sustitución en $θ = {theta}$"), &[("theta", &shown)]);
    if let Some(chosen) = place.chosen {
        board.say(chosen, &[]);
    }
    motion(board, place);
    contact_of(board, place.motion(board.cam()));
}

/// s, v, a, j from the formulas of the segment, and V, A, J.
fn motion(board: &mut Board, place: &Place) {
    let theta = place.theta;
    let stretch = &board.cam().program.stretches()[place.stretch];
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
    } else if (theta - stretch.to).abs() < 1e-9 {
        board.say(
            two(
                "It is a joint: these are the limits from the left.",
                "Es una unión: estos son los límites por la izquierda.",
            ),
            &[],
        );
    }
    let values: Values = vec![(if own { "u" } else { "x" }, x), (if own { "β_u" } else { "β" }, number::result(beta))];
    let motion = place.motion(board.cam());
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
pub fn contact_of(board: &mut Board, motion: Svaj) {
    let rules = rules(board.cam(), motion);
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
