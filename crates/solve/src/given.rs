//! What the problem gives: cam, follower, speed and program.

use crate::board::{Board, cell, two};
use crate::number;
use levalab_core::{Drive, Quantity};
use levalab_format::{CamKind, SpeedUnit};

pub fn write(board: &mut Board) {
    board.heading(1, two("Data", "Datos"), &[]);
    let design = board.design();
    let kind = levalab_words::cam_kind(board.language, design.kind.word());
    let follower = levalab_words::follower(board.language, design.follower);
    board.say(
        two("A {kind} and its {follower}; lengths in {unit}.", "Una {kind} y su {follower}; longitudes en {unit}."),
        &[("kind", kind), ("follower", follower), ("unit", design.length_unit.symbol())],
    );
    geometry(board);
    speed(board);
}

fn geometry(board: &mut Board) {
    let (design, follower) = (board.design(), &board.cam().follower);
    let length = board.length();
    let mut shown: Vec<String> = Vec::new();
    match design.kind {
        CamKind::Translating { length: travel } => shown.push(format!("X = {}{length}", number::datum(travel))),
        CamKind::ConstantBreadth { breadth, .. } => {
            shown.push(format!("d_c = {}{length}", number::datum(breadth)));
            shown.push(format!("R_b = {}{length}", number::datum(design.base_radius)));
        }
        CamKind::Rotating | CamKind::Grooved => {
            shown.push(format!("R_b = {}{length}", number::datum(design.base_radius)));
        }
    }
    for (parameter, value) in design.follower.parameters.iter().zip(design.values) {
        let symbol = if parameter.symbol == "Rf" { "R_f" } else { parameter.symbol };
        let unit = match parameter.quantity {
            Quantity::Length | Quantity::Height => length.clone(),
            Quantity::Angle | Quantity::Span => "{°}".to_owned(),
            Quantity::Ratio => String::new(),
        };
        shown.push(format!("{symbol} = {}{unit}", number::datum(value)));
    }
    if follower.drive() == Drive::Turns {
        let sigma = if follower.rotation().sigma() > 0.0 { "1" } else { "-1" };
        shown.push(format!("σ = {sigma}"));
    }
    board.show(&shown.join(", "));
    if follower.drive() == Drive::Turns {
        let offset = design.follower.parameters.iter().any(|parameter| parameter.symbol == "e");
        let senses = if offset {
            two(
                "($σ = 1$ for a cam that turns counter-clockwise, $σ = -1$ clockwise; the follower is above the cam and $e$ is positive to the right.)",
                "($σ = 1$ si la leva gira en sentido antihorario, $σ = -1$ en sentido horario; el seguidor está encima de la leva y $e$ es positiva hacia la derecha.)",
            )
        } else {
            two(
                "($σ = 1$ for a cam that turns counter-clockwise, $σ = -1$ clockwise; the follower is above the cam.)",
                "($σ = 1$ si la leva gira en sentido antihorario, $σ = -1$ en sentido horario; el seguidor está encima de la leva.)",
            )
        };
        board.say(senses, &[]);
    }
    if let Some(travel) = design.breadth_travel() {
        board.say(
            two(
                "Half a turn later the follower has what is left of its travel, so breadth and base circle fix it:",
                "Media vuelta después el seguidor tiene lo que resta de su carrera, así que la fijan la anchura y la circunferencia base:",
            ),
            &[],
        );
        board.show(&format!("s(θ) + s(θ + 180{{°}}) = d_c - 2R_b = {}{length}", number::datum(travel)));
    }
}

fn speed(board: &mut Board) {
    let speed = board.design().speed;
    let (told, omega) = (number::datum(speed.value), number::result(board.design().omega()));
    let text = match speed.unit {
        SpeedUnit::RevolutionsPerMinute => {
            format!("ω = {told} {{rpm}} = (2π)/(60) · {told} {{rad/s}} = {omega} {{rad/s}}")
        }
        SpeedUnit::RevolutionsPerSecond => format!("ω = {told} {{rev/s}} = 2π · {told} {{rad/s}} = {omega} {{rad/s}}"),
        _ if board.travels() => format!("ω = {told}{}", board.timed_unit(1)),
        _ => format!("ω = {omega} {{rad/s}}"),
    };
    board.show(&text);
    let heads = [
        board.line(two("Segment", "Tramo"), &[]),
        board.line(two("Law", "Ley"), &[]),
        cell("β"),
        board.line(two("from $θ$ to", "de $θ$ a"), &[]),
        cell("L"),
        board.line(two("from $s$ to", "de $s$ a"), &[]),
    ];
    let program = &board.cam().program;
    let rows = program.given().iter().enumerate().map(|(k, segment)| {
        let (from, to) = (program.borders()[k], program.borders()[k + 1]);
        let (start, end) = (program.heights()[k], program.heights()[k + 1]);
        vec![
            crate::document::line(&(k + 1).to_string()),
            crate::document::line(levalab_words::law_alone(board.language, segment.law)),
            cell(&board.place(segment.beta)),
            cell(&format!("{} → {}", board.place(from), board.place(to))),
            cell(&board.height(end - start)),
            cell(&format!("{} → {}", board.height(start), board.height(end))),
        ]
    });
    let rows = rows.collect();
    board.table(two("Motion program", "Programa de movimiento"), heads.into(), rows);
}
