//! The continuity check: the limits on both sides of every joint.

use crate::board::{Board, LETTERS, cell, two};
use crate::document::Line;
use levalab_core::Joint;

/// Joints within a segment that are listed one by one; more of them, all smooth, are told together.
const LISTED: usize = 6;

pub fn write(board: &mut Board, only: Option<usize>) {
    board.heading(1, two("Continuity at the joints", "Continuidad en las uniones"), &[]);
    board.say(
        two(
            "The limits from both sides of each joint; one value where they agree, two with ≠ between them where it jumps from the first to the second. A joint where $s$ or $v$ jumps breaks the fundamental law; $a$ must not jump in an acceptable cam, nor $j$ at high speed.",
            "Los límites por ambos lados de cada unión; un solo valor donde coinciden, dos con ≠ entre ellos donde salta del primero al segundo. Un salto de $s$ o de $v$ incumple la ley fundamental; $a$ no debe saltar en una leva aceptable, ni $j$ a altas velocidades.",
        ),
        &[],
    );
    let segments = board.cam().program.given().len();
    let concerns = |joint: &&Joint| match only {
        None => true,
        Some(k) => joint.segment == k || joint.segment == (k + 1) % segments.max(1),
    };
    let joints: Vec<&Joint> = board.study.analysis().joints.iter().filter(concerns).collect();
    let borders = board.cam().program.borders();
    // Smooth joints within a segment that has many of them.
    let is_inner = |joint: &Joint| !borders.contains(&joint.theta);
    let smooth =
        |k: usize| joints.iter().filter(|joint| joint.segment == k && is_inner(joint) && joint.jump.is_none()).count();
    let hidden = |joint: &Joint| is_inner(joint) && joint.jump.is_none() && smooth(joint.segment) > LISTED;
    let mut heads: Vec<Line> = vec![cell("θ")];
    heads.extend((0..4).map(|order| {
        let unit = board.unit(order);
        let unit = unit.trim().trim_start_matches('{').trim_end_matches('}');
        let head = format!("${}$", LETTERS[order]);
        crate::document::line(&if unit.is_empty() { head } else { format!("{head} ({unit})") })
    }));
    heads.push(board.line(two("jumps", "salta"), &[]));
    let row = |joint: &&Joint| {
        let mut row = vec![cell(&board.solved_place(joint.theta))];
        row.extend((0..4).map(|order| {
            let (before, after) =
                (board.figure(order, joint.before.order(order)), board.figure(order, joint.after.order(order)));
            cell(&if before == after { before } else { format!("{before} ≠ {after}") })
        }));
        row.push(
            joint.jump.map_or_else(|| crate::document::line("–"), |order| cell(LETTERS[usize::from(order).min(3)])),
        );
        row
    };
    let rows = joints.iter().filter(|joint| !hidden(joint)).map(row).collect();
    board.table(two("Limits before and after each joint", "Límites antes y después de cada unión"), heads, rows);
    for k in 0..board.cam().program.segments().len() {
        let count = smooth(k);
        if count > LISTED {
            board.say(
                two(
                    "At the {count} inner joints of segment {n} all four are continuous.",
                    "En las {count} uniones interiores del tramo {n} las cuatro son continuas.",
                ),
                &[("count", &count.to_string()), ("n", &(k + 1).to_string())],
            );
        }
    }
}
