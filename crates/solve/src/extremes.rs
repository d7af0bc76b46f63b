//! Extreme values: where the next derivative is zero, and the greatest and least of the whole cycle.

use crate::board::{Board, LETTERS, TIMED, cell, two};
use crate::curve::derivative;
use crate::document::{Line, formula, line};
use crate::inner::{self, Inner, Why};
use crate::layout::width;
use crate::limit::nearest;
use crate::number;
use crate::segment::Part;
use levalab_core::{Column, Svaj};
use levalab_format::report::{Place, Range, Report, scale_of};
use levalab_formula::Formula;

/// Extremes of a derivative in a segment that are all told; of more, the greatest and the least.
const TOLD: usize = 6;

/// An equation wider than this is left out: its roots say enough.
const WIDEST: usize = 110;

/// The extremes inside a segment, with the equations that give them.
pub fn within(board: &mut Board, part: &Part) {
    let mut all = Vec::new();
    let mut announced = false;
    for order in 0..3 {
        let found = inner::extremes(&part.stretches, order);
        if let Some((left, sides)) = equation(board, part, order, &found) {
            if !announced {
                board.say(
                    two(
                        "A derivative is greatest or least where the next one is zero:",
                        "Una derivada es máxima o mínima donde la siguiente se anula:",
                    ),
                    &[],
                );
            }
            announced = true;
            board.equate(left, sides);
        }
        all.extend(few(found));
    }
    if all.is_empty() {
        return board.say(
            two(
                "Inside the segment no derivative changes its sign: $s$, $v$ and $a$ are greatest and least at its ends or at its joints.",
                "Dentro del tramo ninguna derivada cambia de signo: $s$, $v$ y $a$ son máximas y mínimas en sus extremos o en sus uniones.",
            ),
            &[],
        );
    }
    let heads = vec![
        board.line(two("where", "donde"), &[]),
        cell("x"),
        cell("θ"),
        board.line(two("extreme", "extremo"), &[]),
        board.line(two("per second", "por segundo"), &[]),
    ];
    let rows = all.iter().map(|found| row(board, part, found)).collect();
    board.table(two("Extreme values inside the segment", "Valores extremos dentro del tramo"), heads, rows);
}

/// A row of the table of extremes inside a segment.
fn row(board: &Board, part: &Part, found: &Inner) -> Vec<Line> {
    let Inner { order, from, to, value, why } = *found;
    let (letter, timed, next) = (LETTERS[order], TIMED[order], LETTERS[order + 1]);
    let reason = match why {
        Why::Zero => cell(&format!("{next} = 0")),
        Why::Crossing => board.line(two("${d}$ changes its sign", "${d}$ cambia de signo"), &[("d", next)]),
        Why::Left => board
            .line(two("${d}$ jumps (limit from the left)", "${d}$ salta (límite por la izquierda)"), &[("d", letter)]),
        Why::Right => board
            .line(two("${d}$ jumps (limit from the right)", "${d}$ salta (límite por la derecha)"), &[("d", letter)]),
    };
    // A derivative that keeps its extreme for a while has two places: where it reaches it and where it leaves it.
    let both = |of: &dyn Fn(f64) -> String| match (of(from), of(to)) {
        (one, other) if one == other => cell(&one),
        (one, other) => {
            board.line(two("${from}$ to ${to}$", "de ${from}$ a ${to}$"), &[("from", &one), ("to", &other)])
        }
    };
    let per_second = match order {
        0 => Line::new(),
        _ => cell(&format!("{timed} = {}{}", board.timed_figure(order, value), board.timed_unit(order))),
    };
    vec![
        reason,
        both(&|theta| number::part((theta - part.from) / part.beta())),
        both(&|theta| board.solved_place(theta)),
        cell(&format!("{letter} = {}", board.derivative(order, value))),
        per_second,
    ]
}

/// The next derivative set to zero, in numbers, and its roots.
fn equation(board: &Board, part: &Part, order: usize, found: &[Inner]) -> Option<(Formula, Vec<(char, Formula)>)> {
    let scaled = part.whole()?.clone().scaled(board.scale(), 0.0);
    let sum = derivative(&scaled, order + 1, "x")?;
    if found.is_empty() || width(&sum) > WIDEST || found.len() > TOLD {
        return None;
    }
    let left = format!("s{}", "'".repeat(order + 1));
    let roots: Vec<String> = found.iter().map(|f| number::part((f.from - part.from) / part.beta())).collect();
    let roots = formula(&format!("x = {}", roots.join(", ")));
    Some((formula(&left), vec![('=', sum), ('=', Formula::Number("0".into())), ('⇒', roots)]))
}

fn few(mut found: Vec<Inner>) -> Vec<Inner> {
    if found.len() <= TOLD {
        return found;
    }
    found.sort_by(|a, b| a.value.total_cmp(&b.value));
    let greatest = found.pop();
    found.truncate(1);
    found.extend(greatest);
    found
}

/// The heads of a table of least and greatest values.
pub fn heads(board: &Board) -> Vec<Line> {
    vec![
        board.line(two("magnitude", "magnitud"), &[]),
        board.line(two("least", "mínimo"), &[]),
        cell("θ"),
        board.line(two("greatest", "máximo"), &[]),
        cell("θ"),
    ]
}

/// A place in the unit of the design.
pub fn placed(board: &Board, place: f64) -> String {
    if board.travels() { number::height(place) + &board.length() } else { number::angle(place) + "{°}" }
}

/// The whole cycle.
pub fn write(board: &mut Board) {
    board.heading(1, two("Greatest and least values", "Valores máximos y mínimos"), &[]);
    board.say(
        two(
            "Of all extremes inside the segments and the limits at the joints, the greatest and the least; per second, $V = v ω$, $A = a ω^2$, $J = j ω^3$.",
            "De todos los extremos dentro de los tramos y los límites en las uniones, el mayor y el menor; por segundo, $V = v ω$, $A = a ω^2$, $J = j ω^3$.",
        ),
        &[],
    );
    let heads = heads(board);
    let report = board.study.report();
    let omega = board.design().omega();
    let length = board.length();
    let columns = [Column::S, Column::V, Column::A, Column::J];
    let mut rows = Vec::new();
    let mut add = |shown: Shown, column: Column| {
        rows.extend(report.range(column).and_then(|range| extreme_row(board, &shown, column, range)));
    };
    for (order, column) in columns.into_iter().enumerate() {
        let written = if order == 0 { number::height } else { number::result };
        add(Shown { symbol: LETTERS[order], factor: 1.0, unit: board.unit(order), written }, column);
    }
    for (order, column) in columns.into_iter().enumerate().skip(1) {
        let (factor, unit) = (omega.powi(order as i32), board.timed_unit(order));
        add(Shown { symbol: TIMED[order], factor, unit, written: number::result }, column);
    }
    add(Shown { symbol: "φ", factor: 1.0, unit: "{°}".into(), written: number::angle }, Column::PressureAngle);
    for (column, symbol) in [(Column::RhoPitch, "ρ_p"), (Column::Rho, "ρ"), (Column::Contact, "q")] {
        add(Shown { symbol, factor: 1.0, unit: length.clone(), written: number::result }, column);
    }
    board.table(two("Extremes of the whole cycle", "Extremos de todo el ciclo"), heads, rows);
    radius(board);
    face(board);
}

/// The minimum length of a flat face.
fn face(board: &mut Board) {
    let Some(face) = board.study.analysis().summary.face(board.cam(), 0.0) else { return };
    let [from, to, long] = [face.from, face.to, face.length].map(|length| number::result(length) + &board.length());
    let text = if board.swings() {
        two(
            "The face is at least ${long}$ long from the foot of the pivot: it works from ${from}$ to ${to}$.",
            "La cara mide al menos ${long}$ desde el pie de la articulación: trabaja de ${from}$ a ${to}$.",
        )
    } else {
        two(
            "The face is at least ${long}$ long: from $q = {from}$ to $q = {to}$.",
            "La cara mide al menos ${long}$: de $q = {from}$ a $q = {to}$.",
        )
    };
    board.say(text, &[("long", &long), ("from", &from), ("to", &to)]);
}

/// How a magnitude is written in the table of extremes.
struct Shown {
    symbol: &'static str,
    factor: f64,
    unit: String,
    written: fn(f64) -> String,
}

/// The minimum and the maximum of a column with their places; none when both are infinite.
fn extreme_row(board: &Board, shown: &Shown, column: Column, range: Range) -> Option<Vec<Line>> {
    if range.min.is_infinite() && range.max.is_infinite() {
        return None;
    }
    let scale = range.max.abs().max(range.min.abs());
    // An angle is measured against a right angle, compared with which its rounding is nothing.
    let scale = if column == Column::PressureAngle { scale.max(90.0) } else { scale };
    let value = |value: f64| {
        let settled = if scale.is_finite() { number::settled(value, scale) } else { value };
        if value.is_finite() { cell(&((shown.written)(settled * shown.factor) + &shown.unit)) } else { line("–") }
    };
    // A magnitude that is the same all along has no place.
    let level = range.max - range.min <= number::NEGLIGIBLE * scale;
    let at = |place: f64, extreme: f64| match extreme.is_finite() && !level {
        true if is_left_limit(board, column, place, extreme) => {
            let place = if place == 0.0 { board.design().place(board.cam().program.span()) } else { place };
            board.line(
                two("${at}$ (limit from the left)", "${at}$ (límite por la izquierda)"),
                &[("at", &placed(board, place))],
            )
        }
        true => cell(&placed(board, place)),
        false => line("–"),
    };
    let Range { min, min_at, max, max_at } = range;
    Some(vec![cell(shown.symbol), value(min), at(min_at, min), value(max), at(max_at, max)])
}

/// True when a column has an extreme at a joint as its limit from the left, and another value from there on.
fn is_left_limit(board: &Board, column: Column, place: f64, extreme: f64) -> bool {
    let cam = board.cam();
    let of = |motion: Svaj| match column {
        Column::S => motion.s,
        Column::V => motion.v,
        Column::A => motion.a,
        Column::J => motion.j,
        Column::PressureAngle => cam.contact(motion).pressure_angle,
        Column::Contact => cam.contact(motion).reach,
        Column::RhoPitch => 1.0 / cam.contact(motion).bend,
        _ => cam.follower.profile_radius(cam.contact(motion).bend),
    };
    let theta = if board.travels() { place } else { place.to_radians() };
    let extreme = extreme / scale_of(board.design(), column);
    nearest(cam, theta, extreme, of).0 != cam.program.stretch_index(theta)
}

/// The sharpest convex place and the tightest hollow, which the range of ρ does not give where the profile has both.
fn radius(board: &mut Board) {
    let Report { least_convex, tightest_hollow, inflections, .. } = board.study.report();
    let written =
        |board: &Board, found: &Place| (number::result(found.value) + &board.length(), placed(board, found.at));
    if let Some(found) = least_convex {
        let (value, at) = written(board, found);
        board.say(
            two(
                "Where the profile is convex its least radius is $ρ = {value}$, at $θ = {at}$.",
                "Donde el perfil es convexo su radio mínimo es $ρ = {value}$, en $θ = {at}$.",
            ),
            &[("value", &value), ("at", &at)],
        );
    }
    if let Some(found) = tightest_hollow {
        let (value, at) = written(board, found);
        board.say(
            two(
                "It is hollow too; the tightest hollow has $ρ = {value}$, at $θ = {at}$.",
                "También es cóncavo; la concavidad más cerrada tiene $ρ = {value}$, en $θ = {at}$.",
            ),
            &[("value", &value), ("at", &at)],
        );
    }
    if inflections.is_empty() {
        return;
    }
    let places: Vec<String> = inflections.iter().map(|&at| format!("${}$", placed(board, at))).collect();
    board.say(
        two(
            "It passes from convex to hollow or back, with $ρ → ±∞$ unless the curvature jumps, at $θ$ = {places}.",
            "Pasa de convexo a cóncavo o al revés, con $ρ → ±∞$ salvo donde la curvatura salta, en $θ$ = {places}.",
        ),
        &[("places", &places.join(", "))],
    );
}
