//! The second cam of a conjugate pair.

use crate::board::{Board, two};
use crate::document::Block;
use crate::substitution::{Place, contact_at};
use crate::{extremes, number, verdict};

pub fn write(board: &mut Board, place: &Place) {
    board.heading(1, two("The second cam", "La segunda leva"), &[]);
    let follower = &board.cam().follower;
    let top = follower.reversed.unwrap_or(0.0);
    board.say(
        two(
            "Its element is fixed to the same follower, on the other side of the shaft: it advances when the first retreats. All that follows is of its own $s$, from its own base circle:",
            "Su elemento está unido al mismo seguidor, al otro lado del eje: avanza cuando el primero retrocede. Todo lo que sigue se refiere a su propia $s$, desde su propia circunferencia base:",
        ),
        &[],
    );
    let top = number::height(top * board.scale()) + &board.unit(0);
    board.show(&format!(
        "s → s_(max) - s, s_(max) = {top}, R_b = {}{}",
        number::result(follower.base_radius),
        board.length()
    ));
    extremes::write(board);
    let theta = board.solved_place(place.theta());
    board.heading(2, two("Numbers put in at $θ = {theta}$", "Sustitución en $θ = {theta}$"), &[("theta", &theta)]);
    let motion = board.cam().program.at(place.theta());
    board.show(&format!(
        "s = {}, v = {}, a = {}",
        board.derivative(0, motion.s),
        board.derivative(1, motion.v),
        board.derivative(2, motion.a)
    ));
    contact_at(board, place.theta());
    verdict::write(board);
    // All of it is a part of this part.
    for block in board.blocks.iter_mut().skip(1) {
        if let Block::Heading(level, _) = block {
            *level = 2;
        }
    }
}
