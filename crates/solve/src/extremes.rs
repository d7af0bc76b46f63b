//! Extreme values: where the next derivative is zero, and the greatest and least of the whole cycle.

use crate::board::{Board, LETTERS, TIMED, cell, two};
use crate::curve::derivative;
use crate::document::{Line, formula, line};
use crate::layout::width;
use crate::number;
use crate::segment::Part;
use levalab_core::Column;
use levalab_format::report::Range;
use levalab_formula::Formula;

/// Extremes of a derivative in a segment that are all told; of more, the greatest and the least.
const TOLD: usize = 6;

/// An equation wider than this is left out: its roots say enough.
const WIDEST: usize = 110;

/// Where a derivative is greatest or least inside a segment.
struct Found {
    order: usize,
    theta: f64,
    value: f64,
}

/// The extremes inside a segment, with the equations that give them.
pub fn within(board: &mut Board, part: &Part) {
    let mut all = Vec::new();
    let mut announced = false;
    for order in 0..3 {
        let of = |stretch: &&levalab_core::Stretch| {
            let zeros = stretch.zeros(order + 1);
            let value = |theta: f64| Found { order, theta, value: stretch.at(theta).order(order) };
            zeros.into_iter().map(value).collect::<Vec<_>>()
        };
        let found: Vec<Found> = part.stretches.iter().flat_map(of).collect();
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
    let row = |found: &Found| {
        let Found { order, theta, value } = *found;
        let (letter, timed) = (LETTERS[order], TIMED[order]);
        let per_second = match order {
            0 => Line::new(),
            _ => cell(&format!("{timed} = {}{}", board.timed_figure(order, value), board.timed_unit(order))),
        };
        vec![
            cell(&format!("{} = 0", LETTERS[order + 1])),
            cell(&number::part((theta - part.from) / part.beta())),
            cell(&board.solved_place(theta)),
            cell(&format!("{letter} = {}", board.derivative(order, value))),
            per_second,
        ]
    };
    let rows = all.iter().map(row).collect();
    board.table(two("Extreme values inside the segment", "Valores extremos dentro del tramo"), heads, rows);
}

/// The next derivative set to zero, in numbers, and its roots.
fn equation(board: &Board, part: &Part, order: usize, found: &[Found]) -> Option<(Formula, Vec<(char, Formula)>)> {
    let scaled = part.whole()?.clone().scaled(board.scale(), 0.0);
    let sum = derivative(&scaled, order + 1, "x")?;
    if found.is_empty() || width(&sum) > WIDEST || found.len() > TOLD {
        return None;
    }
    let left = format!("s{}", "'".repeat(order + 1));
    let roots: Vec<String> = found.iter().map(|f| number::part((f.theta - part.from) / part.beta())).collect();
    let roots = formula(&format!("x = {}", roots.join(", ")));
    Some((formula(&left), vec![('=', sum), ('=', Formula::Number("0".into())), ('⇒', roots)]))
}

fn few(mut found: Vec<Found>) -> Vec<Found> {
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
    let report = board.subject.report;
    let omega = board.design().omega();
    let length = board.length();
    let mut rows = Vec::new();
    let mut add = |symbol: &str, range: Range, factor: f64, unit: &str, written: fn(f64) -> String| {
        if range.min.is_infinite() && range.max.is_infinite() {
            return;
        }
        let scale = range.max.abs().max(range.min.abs());
        // An angle has a scale of its own, which its rounding is nothing beside.
        let scale = if symbol == "φ" { scale.max(90.0) } else { scale };
        let value = |value: f64| {
            let settled = if scale.is_finite() { number::settled(value, scale) } else { value };
            if value.is_finite() { cell(&(written(settled * factor) + unit)) } else { line("–") }
        };
        // What is the same all along has no place.
        let level = range.max - range.min <= number::NEGLIGIBLE * scale;
        let at = |at: f64, value: f64| if value.is_finite() && !level { cell(&placed(board, at)) } else { line("–") };
        rows.push(vec![
            cell(symbol),
            value(range.min),
            at(range.min_at, range.min),
            value(range.max),
            at(range.max_at, range.max),
        ]);
    };
    let columns = [Column::S, Column::V, Column::A, Column::J];
    for (order, column) in columns.into_iter().enumerate() {
        if let Some(range) = report.range(column) {
            let written = if order == 0 { number::height } else { number::result };
            add(LETTERS[order], range, 1.0, &board.unit(order), written);
        }
    }
    for (order, column) in columns.into_iter().enumerate().skip(1) {
        if let Some(range) = report.range(column) {
            add(TIMED[order], range, omega.powi(order as i32), &board.timed_unit(order), number::result);
        }
    }
    if let Some(range) = report.range(Column::PressureAngle) {
        add("φ", range, 1.0, "{°}", number::angle);
    }
    for (column, symbol) in [(Column::RhoPitch, "ρ_p"), (Column::Rho, "ρ"), (Column::Contact, "q")] {
        if let Some(range) = report.range(column) {
            add(symbol, range, 1.0, &length, number::result);
        }
    }
    board.table(two("Extremes of the whole cycle", "Extremos de todo el ciclo"), heads, rows);
    radius(board);
}

/// What the range of ρ cannot tell where the profile is partly hollow.
fn radius(board: &mut Board) {
    let summary = &board.subject.analysis.summary;
    let (convex, hollow) = (summary.least_convex, summary.tightest_hollow);
    let told =
        |board: &Board, (value, at): (f64, f64)| (number::result(value) + &board.length(), board.solved_place(at));
    if let Some(place) = convex.filter(|(value, _)| value.is_finite()) {
        let (value, at) = told(board, place);
        board.say(
            two(
                "Where the profile is convex its least radius is $ρ = {value}$, at $θ = {at}$.",
                "Donde el perfil es convexo su radio mínimo es $ρ = {value}$, en $θ = {at}$.",
            ),
            &[("value", &value), ("at", &at)],
        );
    }
    if let Some(place) = hollow.filter(|(value, _)| value.is_finite()) {
        let (value, at) = told(board, place);
        board.say(
            two(
                "It is hollow too (there $ρ$ passes from $∞$ to $-∞$); the tightest hollow has $ρ = {value}$, at $θ = {at}$.",
                "También es cóncavo (allí $ρ$ pasa de $∞$ a $-∞$); la concavidad más cerrada tiene $ρ = {value}$, en $θ = {at}$.",
            ),
            &[("value", &value), ("at", &at)],
        );
    }
}
