//! Random programs, followers and cams for property tests: all laws, all followers, both rotations.

use super::ROTATIONS;
use levalab_core::{
    Cam, FOLLOWERS, Follower, FollowerKind, LAWS, Law, Motion, Parameter, Program, Quantity, Rotation, Segment,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use std::f64::consts::{PI, TAU};

/// A number of cases, always the same ones, so that a change is blamed only for what it broke. In the environment,
/// `PROPTEST_RNG_SEED` looks at others, and `PROPTEST_CASES` at more (256, proptest's own default, is once as many).
pub fn cases(cases: u32) -> Config {
    let given = Config::default();
    let rng_seed = if given.rng_seed == RngSeed::Random { RngSeed::Fixed(36) } else { given.rng_seed };
    let cases = (u64::from(cases) * u64::from(given.cases)).div_ceil(256) as u32;
    Config { cases, rng_seed, failure_persistence: None, max_global_rejects: 100 * cases, ..given }
}

/// One segment before it is fitted into a cycle.
type Draft = (&'static Law, f64, f64, f64, f64);

fn draft() -> impl Strategy<Value = Draft> {
    let law = (0..LAWS.len()).prop_map(|k| LAWS[k]);
    (law, 0.1..1.0, 0.0..1.0, 0.0..0.9, 0.0..0.95)
}

/// A program of one to eight segments, no rise of a joint above `lift`.
pub fn program(lift: f64) -> impl Strategy<Value = Program> {
    let fitted = prop::collection::vec(draft(), 1..=8).prop_map(move |drafts| fit(&drafts, lift));
    fitted.prop_filter_map("it closes", |segments| Program::new(&segments).ok())
}

/// Shares the turn out among the segments and joins their heights into a cycle. A dwell stays at its height, generic
/// polynomials are kept apart, and where either cannot be, a cycloidal stands in.
fn fit(drafts: &[Draft], lift: f64) -> Vec<Segment> {
    let sum: f64 = drafts.iter().map(|draft| draft.1).sum();
    let cycloidal = Law::by_id("cycloidal").expect("cycloidal");
    let mut segments: Vec<Segment> = Vec::new();
    let mut height = 0.0;
    for (k, &(law, share, target, b, c)) in drafts.iter().enumerate() {
        let last = k + 1 == drafts.len();
        let beside = segments.last().is_some_and(|before| before.law.is_matched()) || last && drafts[0].0.is_matched();
        let stuck = law.is_dwell() && last && height != 0.0;
        let law = if stuck || law.is_matched() && beside { cycloidal } else { law };
        let target = if last {
            0.0
        } else if law.is_dwell() {
            height
        } else {
            target * lift
        };
        let mut segment = Segment::new(law, share / sum * TAU, target - height);
        segment.data = law.first_data(segment.beta, height, target - height);
        for (value, parameter) in segment.parameters.iter_mut().zip(law.parameters) {
            *value = match parameter.key {
                "b" | "beta1" => b,
                "c" | "beta3" => c * (1.0 - b),
                "crossover" => 0.1 + 0.8 * b,
                "smoothing" if b > 0.5 => 0.02 * b * segment.rise.abs(),
                _ => *value,
            };
        }
        segments.push(segment);
        height = target;
    }
    segments
}

/// A follower that can rest on its base circle, lengths up to a hundred or so.
pub fn follower_of(kind: &'static FollowerKind) -> impl Strategy<Value = Follower> {
    let values = kind.parameters.iter().map(value).collect::<Vec<_>>();
    (5.0..120.0, values, prop::sample::select(&ROTATIONS[..])).prop_filter_map(
        "it rests",
        move |(base_radius, values, rotation)| {
            let mut all = [0.0; 4];
            all[..values.len()].copy_from_slice(&values);
            Follower::new(kind, base_radius, &all, rotation).ok()
        },
    )
}

fn value(parameter: &Parameter) -> BoxedStrategy<f64> {
    match (parameter.key, parameter.quantity) {
        ("eccentricity" | "face_offset", _) => prop_oneof![Just(0.0), -25.0..25.0].boxed(),
        ("roller_radius", _) => (1.0..30.0).boxed(),
        ("pivot_angle", _) => (-PI..PI).boxed(),
        (_, Quantity::Length) => (10.0..180.0).boxed(),
        (_, Quantity::Angle) => prop_oneof![Just(0.0), -0.6..0.6].boxed(),
        (_, Quantity::Ratio | Quantity::Span | Quantity::Height) => (0.0..1.0).boxed(),
    }
}

/// A follower of any kind.
pub fn follower() -> impl Strategy<Value = Follower> {
    prop::sample::select(FOLLOWERS).prop_flat_map(follower_of)
}

/// Any cam: its lift is a length, or an angle when it oscillates, and many are bad cams.
pub fn cam() -> impl Strategy<Value = Cam> {
    prop::sample::select(FOLLOWERS).prop_flat_map(cam_of)
}

/// A cam with a follower of that kind.
pub fn cam_of(kind: &'static FollowerKind) -> impl Strategy<Value = Cam> {
    let most: f64 = if kind.motion == Motion::Oscillating { 0.5 } else { 40.0 };
    (most / 100.0..most)
        .prop_flat_map(move |lift| (program(lift), follower_of(kind)))
        .prop_map(|(program, follower)| Cam::new(program, follower))
}

/// The other sense of rotation.
pub fn opposite(rotation: Rotation) -> Rotation {
    match rotation {
        Rotation::CounterClockwise => Rotation::Clockwise,
        Rotation::Clockwise => Rotation::CounterClockwise,
    }
}
