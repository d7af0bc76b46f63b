//! What the follower drives: its formulas, numbers put in, extremes, and the points to hit.

use crate::board::{Board, cell, two};
use crate::document::{formula, line};
use crate::extremes::{heads, placed};
use crate::number;
use crate::substitute::{Values, substituted};
use crate::substitution::Place;
use levalab_core::application::{Magnitude, OutputLaw};
use levalab_format::{ApplicationDesign, Outcome, OutputRange};
use levalab_words::{application_name, part_name};

pub fn write(board: &mut Board, place: &Place) {
    let Some(set) = &board.design().application else { return };
    let outcome = set.outcome(board.design(), board.cam(), board.study.analysis());
    let name = application_name(board.language, set.application);
    board.heading(1, two("What the follower drives: {name}", "Lo que mueve el seguidor: {name}"), &[("name", name)]);
    let known = parameters(board, set, &outcome);
    outputs(board, set, &outcome, known, place);
    extremes(board, &outcome);
    targets(board, set, &outcome);
}

/// A symbol of the registry as a letter of a formula; that of an area has an index, beside the acceleration.
fn letter(symbol: &'static str) -> &'static str {
    match symbol {
        "A" => "A_p",
        "P/V" => "k_V",
        "Av" => "A_v",
        "Vol" => "{Vol}",
        other => other,
    }
}

/// A number with the unit of what it measures.
fn measured(board: &Board, text: &str, magnitude: Magnitude) -> String {
    let unit = board.design().length_unit.unit_of(magnitude);
    if magnitude == Magnitude::Angle { format!("{text}{{°}}") } else { format!("{text} {{{unit}}}") }
}

/// What is given, and the figures that follow from it alone.
fn parameters(board: &mut Board, set: &ApplicationDesign, outcome: &Outcome) -> Values {
    let mut known: Values = Vec::new();
    let mut told = Vec::new();
    for (setting, value) in set.application.parameters.iter().zip(set.values) {
        let text = number::datum(value);
        let name = part_name(board.language, setting.key);
        told.push(format!("{name} ${} = {}$", letter(setting.symbol), measured(board, &text, setting.magnitude)));
        known.push((letter(setting.symbol), if setting.magnitude == Magnitude::Angle { text + "°" } else { text }));
    }
    board.say(two("Given: {all}.", "Datos: {all}."), &[("all", &told.join(", "))]);
    for (figure, value) in &outcome.figures {
        let symbolic = formula(figure.formula);
        let put_in = substituted(&symbolic, &known);
        let result = formula(&measured(board, &number::result(*value), figure.magnitude));
        board.equate(formula(letter(figure.symbol)), vec![('=', symbolic), ('=', put_in), ('=', result)]);
        known.push((letter(figure.symbol), number::height(*value)));
    }
    known
}

/// Every output where numbers are put in.
fn outputs(board: &mut Board, set: &ApplicationDesign, outcome: &Outcome, mut known: Values, place: &Place) {
    let (motion, omega) = (place.motion(board.cam()), board.design().omega());
    let (s, velocity) = (board.figure(0, motion.s), number::height(board.settled(1, motion.v) * omega));
    let given = format!(
        "s = {}, V = {}{}",
        board.derivative(0, motion.s),
        board.timed_figure(1, motion.v),
        board.timed_unit(1)
    );
    board.say(
        two("At $θ = {theta}$, where ${given}$:", "En $θ = {theta}$, donde ${given}$:"),
        &[("theta", &board.solved_place(place.theta())), ("given", &given)],
    );
    known.extend([("s", s), ("V", velocity)]);
    let values = set.core_values();
    for found in &outcome.outputs {
        let value = found.told(found.output.of(&values, motion, omega));
        let symbolic = formula(found.output.formula);
        let put_in = substituted(&symbolic, &known);
        let result = formula(&measured(board, &number::result(value), found.output.magnitude));
        let mut sides = vec![('=', symbolic)];
        // A valve below its seat is closed, whatever its formula says.
        if motion.s >= 0.0 || matches!(found.output.law, OutputLaw::OfVelocity(_)) {
            sides.push(('=', put_in));
        }
        sides.push(('=', result));
        board.equate(formula(letter(found.output.symbol)), sides);
    }
}

fn extremes(board: &mut Board, outcome: &Outcome) {
    board.say(
        two(
            "Each grows with $s$ or with $V$ alone, so it is greatest and least where that is:",
            "Cada una crece solo con $s$ o con $V$, así que es máxima y mínima donde lo es esta:",
        ),
        &[],
    );
    let heads = heads(board);
    let row = |found: &OutputRange| {
        let OutputRange { output, range, .. } = found;
        let value = |value: f64| cell(&measured(board, &number::height(value), output.magnitude));
        let name = format!("{} ${}$", part_name(board.language, output.id), letter(output.symbol));
        let places = [range.min_at, range.max_at].map(|at| cell(&placed(board, at)));
        let [least_at, most_at] = places;
        vec![line(&name), value(range.min), least_at, value(range.max), most_at]
    };
    let rows = outcome.outputs.iter().map(row).collect();
    board.table(two("Extremes of what comes out", "Extremos de lo que resulta"), heads, rows);
    for found in &outcome.outputs {
        let (Some(cycle), Some(second)) = (found.per_cycle, found.per_second) else { continue };
        let unit = board.design().length_unit.unit_of(found.output.magnitude);
        let told =
            [format!("{} {{{unit}}}", number::result(cycle)), format!("{} {{{unit}/s}}", number::result(second))];
        let text = if board.travels() {
            two(
                "Each journey there and back delivers ${cycle}$ with its rises, which is ${second}$.",
                "Cada ida y vuelta entrega ${cycle}$ con sus subidas, es decir, ${second}$.",
            )
        } else {
            two(
                "Each turn delivers ${cycle}$ with its rises, which is ${second}$.",
                "Cada vuelta entrega ${cycle}$ con sus subidas, es decir, ${second}$.",
            )
        };
        board.say(text, &[("cycle", &told[0]), ("second", &told[1])]);
    }
}

/// The points to hit and the error at each.
fn targets(board: &mut Board, set: &ApplicationDesign, outcome: &Outcome) {
    let main = set.main();
    let unit = board.design().length_unit.unit_of(main.magnitude);
    let symbol = letter(main.symbol);
    let of = |text| format!("{text} (${symbol}$, {unit})");
    let heads = vec![
        cell("θ"),
        line("$t$ (s)"),
        line(&of(board.words(two("wanted", "pedido"), &[]))),
        line(&of(board.words(two("found", "obtenido"), &[]))),
        board.line(two("error", "error"), &[]),
    ];
    let row = |target: &levalab_format::Target| {
        vec![
            cell(&placed(board, target.theta)),
            cell(&number::result(target.time)),
            cell(&number::height(target.value)),
            cell(&number::height(target.found)),
            cell(&number::result(target.error)),
        ]
    };
    let rows = outcome.targets.iter().map(row).collect();
    board.table(two("Points to hit", "Puntos que alcanzar"), heads, rows);
    if let Some(worst) = outcome.worst() {
        let error = measured(board, &number::result(worst.error.abs()), main.magnitude);
        let at = placed(board, worst.theta);
        board.say(
            two("The greatest error is ${error}$, at $θ = {at}$.", "El mayor error es ${error}$, en $θ = {at}$."),
            &[("error", &error), ("at", &at)],
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_core::Svaj;
    use levalab_core::application::APPLICATIONS;
    use levalab_formula::parse;
    use nalgebra::Complex;

    #[test]
    fn printed_formulas_give_what_the_core_computes_for_every_application() {
        for application in APPLICATIONS {
            for values in [[2.5, 0.7], [0.3, 0.4], [30.0, 0.75]] {
                let mut known: Vec<(&str, f64)> =
                    application.parameters.iter().zip(values).map(|(p, value)| (letter(p.symbol), value)).collect();
                let evaluated = |known: &[(&str, f64)], text: &str| {
                    let value =
                        |name: &str| known.iter().find(|(known, _)| *known == name).map(|known| Complex::from(known.1));
                    parse(text).expect(text).value(&value).expect(text).re
                };
                let near = |found: f64, expected: f64, text: &str| {
                    assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{text}: {found}, not {expected}");
                };
                for figure in application.figures {
                    let expected = (figure.of)(&values);
                    near(evaluated(&known, figure.formula), expected, figure.formula);
                    known.push((letter(figure.symbol), expected));
                }
                let (s, v, omega) = (1.3, -0.4, 7.0);
                known.extend([("s", s), ("V", v * omega)]);
                for output in application.outputs {
                    let expected = output.of(&values, Svaj::new(s, v, 0.0, 0.0), omega);
                    near(evaluated(&known, output.formula), expected, output.formula);
                }
            }
        }
    }
}
