//! Sound cams of every follower, both rotations and several programs, for tests that sweep them all.

use super::{ROTATIONS, assert_profile_is_sound, degrees, follower, lengths};
use levalab_core::{Cam, FOLLOWERS, Program};

/// Parameters of a follower by their keys, angles in radians.
pub type Parameters = &'static [(&'static str, f64)];

/// Base radius and parameters to try for each follower.
pub fn geometries(id: &str) -> &'static [(f64, Parameters)] {
    match id {
        "translating-roller" => &[
            (40.0, &[("roller_radius", 10.0)]),
            (45.0, &[("roller_radius", 8.0), ("eccentricity", 9.0)]),
            (45.0, &[("roller_radius", 30.0), ("eccentricity", -12.0)]),
        ],
        "translating-knife" => &[(60.0, &[]), (60.0, &[("eccentricity", 8.0)]), (60.0, &[("eccentricity", -8.0)])],
        "translating-curved" => &[
            (50.0, &[("face_radius", 60.0)]),
            (60.0, &[("face_radius", 90.0), ("eccentricity", 15.0)]),
            (60.0, &[("face_radius", 90.0), ("eccentricity", -15.0)]),
        ],
        "translating-flat" => &[(120.0, &[]), (120.0, &[("face_angle", 0.3)]), (120.0, &[("face_angle", -0.25)])],
        "oscillating-roller" => &[
            (50.0, &[("roller_radius", 10.0), ("arm", 70.0), ("pivot_distance", 90.0)]),
            (50.0, &[("roller_radius", 15.0), ("arm", 80.0), ("pivot_distance", 80.0), ("pivot_angle", 0.5)]),
            (50.0, &[("roller_radius", 10.0), ("arm", 90.0), ("pivot_distance", 100.0), ("pivot_angle", -0.7)]),
        ],
        "oscillating-flat" => &[
            (100.0, &[("pivot_distance", 130.0)]),
            (110.0, &[("pivot_distance", 150.0), ("face_offset", 8.0)]),
            (100.0, &[("pivot_distance", 140.0), ("face_offset", -12.0), ("pivot_angle", 0.6)]),
            (100.0, &[("pivot_distance", 130.0), ("pivot_angle", -0.8)]),
        ],
        other => panic!("no geometry to try {other} with: give it one here, and a way to be lowered in rolling.rs"),
    }
}

/// Programs of different laws, gentle enough for every geometry above. Unit: a millimetre, or half a degree.
pub fn programs(id: &str) -> [Program; 4] {
    let rows: [&[(&str, f64, f64)]; 4] = [
        &[("cycloidal", 110.0, 12.0), ("dwell", 50.0, 0.0), ("polynomial-3-4-5", 130.0, -12.0), ("dwell", 70.0, 0.0)],
        &[("simple-harmonic", 170.0, 14.0), ("simple-harmonic", 190.0, -14.0)],
        &[
            ("modified-sine", 100.0, 6.0),
            ("double-harmonic", 100.0, 6.0),
            ("dwell", 20.0, 0.0),
            ("modified-trapezoidal", 140.0, -12.0),
        ],
        &[("dwell", 60.0, 0.0), ("parabolic", 120.0, 10.0), ("polynomial-5", 40.0, 1.0), ("cubic-2", 140.0, -11.0)],
    ];
    rows.map(|rows| {
        let half_degrees: Vec<_> = rows.iter().map(|&(law, beta, rise)| (law, beta, rise / 2.0)).collect();
        if id.starts_with("oscillating") { degrees(&half_degrees) } else { lengths(rows) }
    })
}

/// Every program on every geometry in both rotations, each with a name to tell it by.
pub fn gallery_of(id: &str) -> Vec<(String, Cam)> {
    let mut cams = Vec::new();
    for (which, program) in programs(id).iter().enumerate() {
        for &(base_radius, parameters) in geometries(id) {
            for rotation in ROTATIONS {
                let cam = Cam::new(program.clone(), follower(id, base_radius, parameters, rotation));
                let name = format!("{id} {parameters:?}, program {which}, {rotation:?}");
                assert_profile_is_sound(&cam, &name);
                cams.push((name, cam));
            }
        }
    }
    cams
}

/// The cams of all followers.
pub fn gallery() -> Vec<(String, Cam)> {
    FOLLOWERS.iter().flat_map(|kind| gallery_of(kind.id)).collect()
}
