//! The motion, segment by segment.

use crate::board::{Board, two};
use crate::segment;
use levalab_core::Cycle;

pub fn write(board: &mut Board, only: Option<usize>) {
    board.heading(1, two("Motion, segment by segment", "El movimiento, tramo a tramo"), &[]);
    let measure = if board.travels() { two("a length", "una longitud") } else { two("in radians", "en radianes") }
        .within(board.language);
    board.say(
        two(
            "In each segment $x = (θ - θ_i)/β$ goes from 0 to 1, with $θ_i$ where it begins and $β$ {measure}; each derivative with respect to $θ$ is one with respect to $x$ divided by $β$: $v = (s')/β$, $a = (s'')/(β^2)$, $j = (s''')/(β^3)$.",
            "En cada tramo $x = (θ - θ_i)/β$ va de 0 a 1, con $θ_i$ donde empieza y $β$ {measure}; cada derivada respecto a $θ$ es una respecto a $x$ dividida por $β$: $v = (s')/β$, $a = (s'')/(β^2)$, $j = (s''')/(β^3)$.",
        ),
        &[("measure", measure)],
    );
    let program = &board.cam().program;
    for k in (0..program.given().len()).filter(|&k| only.is_none_or(|only| only == k)) {
        segment::write(board, k);
    }
    if program.cycle() == Cycle::Mirrored {
        board.say(
            two(
                "The second half of the turn is the first one upside down: $s(θ + 180{°}) = L_t - s(θ)$, with $L_t$ the whole travel.",
                "La segunda mitad de la vuelta es la primera invertida: $s(θ + 180{°}) = L_t - s(θ)$, con $L_t$ la carrera total.",
            ),
            &[],
        );
    }
    if board.travels() {
        board.say(
            two(
                "At both ends the cam turns back and runs through the same motion in the other sense; here $θ$ is the length travelled.",
                "En ambos extremos la leva vuelve y recorre el mismo movimiento en sentido contrario; aquí $θ$ es la longitud recorrida.",
            ),
            &[],
        );
    }
}
