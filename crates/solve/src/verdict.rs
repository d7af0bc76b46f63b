//! The verdict, argued: each demand with what the cam gives, and the sentences about what is wrong and its cures.

use crate::board::{Board, LETTERS, two};
use crate::document::{Line, line};
use crate::number;
use levalab_core::{Closure, FindingKind};

pub fn write(board: &mut Board) {
    board.heading(1, two("Verdict", "Veredicto"), &[]);
    demands(board);
    let headline = levalab_words::headline(board.language, board.study.report());
    board.say(two("{headline}", "{headline}"), &[("headline", &plain(&headline))]);
    let (design, language) = (board.design(), board.language);
    let cures = board.study.cures();
    let mut lines: Vec<Line> = Vec::new();
    for (finding, cures) in board.study.report().findings.iter().zip(&cures) {
        let told = levalab_words::finding(language, design, finding);
        let cured = cures.iter().map(|cure| levalab_words::cure(language, design, finding, &cure.remedy));
        let text = std::iter::once(told).chain(cured).collect::<Vec<_>>().join(" ");
        lines.push(line(&plain(&text)));
    }
    board.list(lines);
}

fn demands(board: &mut Board) {
    let analysis = board.study.analysis();
    let lowest = analysis.joints.iter().filter_map(|joint| joint.jump).min();
    let closure = board.cam().closure;
    let mut rows: Vec<Vec<Line>> = Vec::new();
    let yes = |kept: bool| board.line(if kept { two("kept", "se cumple") } else { two("broken", "no se cumple") }, &[]);
    for (order, letter) in LETTERS.iter().enumerate() {
        let demand = board.line(two("${letter}$ continuous", "${letter}$ continua"), &[("letter", letter)]);
        let places = analysis.joints.iter().filter(|joint| joint.jump == Some(order as u8)).count();
        let count = places.to_string();
        let (found, answer) = match lowest {
            Some(jump) if usize::from(jump) < order => continue,
            Some(jump) if usize::from(jump) == order => {
                let tolerated = order == 2 && closure == Closure::Yoke || order == 3;
                let answer = match (order, tolerated) {
                    (3, _) if closure != Closure::Yoke => {
                        two("broken: low speeds only", "no se cumple: solo bajas velocidades")
                    }
                    (_, true) => two("broken, but a yoke tolerates it", "no se cumple, pero un yugo lo tolera"),
                    _ => two("broken", "no se cumple"),
                };
                let jumps =
                    board.line(two("jumps at {count} joints", "salta en {count} uniones"), &[("count", &count)]);
                (jumps, board.line(answer, &[]))
            }
            _ => (board.line(two("at every joint", "en todas las uniones"), &[]), yes(true)),
        };
        rows.push(vec![demand, found, answer]);
    }
    let limit = board.cam().follower.pressure_angle_limit();
    let (angle, at) = analysis.summary.pressure_angle.greatest_size();
    let range = analysis.summary.pressure_angle;
    let level = range.max - range.min <= number::NEGLIGIBLE;
    let place = if level { String::new() } else { format!(" ($θ = {}$)", board.solved_place(at)) };
    let found = format!("${}{{°}}${place}", number::angle(angle.to_degrees()));
    let broken = |kinds: fn(&FindingKind) -> bool| analysis.findings.iter().any(|found| kinds(&found.kind));
    let steep = broken(|kind| *kind == FindingKind::PressureAngle);
    rows.push(vec![line(&format!("$|φ| ≤ {}{{°}}$", number::angle(limit.to_degrees()))), line(&found), yes(!steep)]);
    if let Some((value, at)) = analysis.summary.least_convex {
        let found = if value.is_finite() {
            format!("${}{}$ ($θ = {}$)", number::result(value), board.length(), board.solved_place(at))
        } else {
            "$∞$".to_owned()
        };
        rows.push(vec![
            board.line(two("$ρ > 0$ where convex", "$ρ > 0$ donde es convexo"), &[]),
            line(&found),
            yes(value > 0.0),
        ]);
    }
    let heads = vec![
        board.line(two("demand", "exigencia"), &[]),
        board.line(two("this cam", "esta leva"), &[]),
        board.line(two("answer", "respuesta"), &[]),
    ];
    board.table(two("What a good cam must keep", "Lo que debe cumplir una buena leva"), heads, rows);
}

/// A sentence in which nothing is taken for a formula.
fn plain(text: &str) -> String {
    text.replace('$', "")
}
