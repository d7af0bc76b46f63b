//! Speed of one whole analysis, beside a bare loop of sines of the same length.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use levalab_core::{Analysis, Cam, Follower, FollowerKind, Program, Rotation, Segment, prescribe};
use std::hint::black_box;

/// Example 9RT: four laws, four dwells, radial roller.
fn nine_rt() -> Cam {
    let rows = [
        ("modified-sine", 50.0, 10.0),
        ("dwell", 40.0, 0.0),
        ("cycloidal", 50.0, -10.0),
        ("dwell", 40.0, 0.0),
        ("polynomial-3-4-5", 50.0, 10.0),
        ("dwell", 40.0, 0.0),
        ("polynomial-4-5-6-7", 50.0, -10.0),
        ("dwell", 40.0, 0.0),
    ];
    cam("translating-roller", 35.0, [7.0, 0.0, 0.0, 0.0], &rows)
}

/// Example 2RO: an oscillating roller.
fn two_ro() -> Cam {
    let rise = 10_f64.to_radians();
    let rows = [("polynomial-4-5-6-7", 120.0, rise), ("dwell", 120.0, 0.0), ("polynomial-4-5-6-7", 120.0, -rise)];
    cam("oscillating-roller", 40.0, [10.0, 80.0, 80.0, 0.0], &rows)
}

fn cam(kind: &str, base_radius: f64, values: [f64; 4], rows: &[(&str, f64, f64)]) -> Cam {
    let segments: Vec<Segment> = rows.iter().filter_map(|&(id, beta, rise)| Segment::of(id, beta, rise)).collect();
    let program = Program::new(&segments).expect("a program");
    let kind = FollowerKind::by_id(kind).expect("a follower");
    let follower = Follower::new(kind, base_radius, values, Rotation::CounterClockwise).expect("a follower");
    Cam::new(program, follower)
}

fn analyze(c: &mut Criterion) {
    let mut group = c.benchmark_group("analyze");
    for (name, cam) in [("9RT", nine_rt()), ("2RO", two_ro())] {
        for steps in [720, 7200] {
            group.bench_with_input(BenchmarkId::new(name, steps), &steps, |b, &steps| {
                b.iter(|| Analysis::of(black_box(&cam), steps));
            });
        }
    }
    group.bench_function("sines/720", |b| {
        b.iter(|| (0..=720).map(|i| black_box(f64::from(i) * 0.008_726_646).sin()).sum::<f64>());
    });
    let steep = nine_rt().with_base_radius(25.0).expect("smaller");
    let analysis = Analysis::of(&steep, 720);
    group.bench_function("prescribe/9RT", |b| b.iter(|| prescribe(black_box(&steep), &analysis)));
    group.finish();
}

criterion_group!(benches, analyze);
criterion_main!(benches);
