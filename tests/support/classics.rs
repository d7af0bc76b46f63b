//! Examples that several tests look at, by the names that they have in `examples/`.

use super::{degrees, follower, lengths};
use levalab_core::{Cam, Rotation};

/// 9RT: four laws, four dwells, a radial roller.
pub fn nine_rt() -> Cam {
    let program = lengths(&[
        ("modified-sine", 50.0, 10.0),
        ("dwell", 40.0, 0.0),
        ("cycloidal", 50.0, -10.0),
        ("dwell", 40.0, 0.0),
        ("polynomial-3-4-5", 50.0, 10.0),
        ("dwell", 40.0, 0.0),
        ("polynomial-4-5-6-7", 50.0, -10.0),
        ("dwell", 40.0, 0.0),
    ]);
    Cam::new(program, follower("translating-roller", 35.0, &[("roller_radius", 7.0)], Rotation::CounterClockwise))
}

/// 2RO: an oscillating roller.
pub fn two_ro() -> Cam {
    let rows = [("polynomial-4-5-6-7", 120.0, 10.0), ("dwell", 120.0, 0.0), ("polynomial-4-5-6-7", 120.0, -10.0)];
    let given = [("roller_radius", 10.0), ("arm", 80.0), ("pivot_distance", 80.0)];
    Cam::new(degrees(&rows), follower("oscillating-roller", 40.0, &given, Rotation::CounterClockwise))
}
