//! Speed of one whole analysis, beside a bare loop of sines of the same length.

#[path = "../../../tests/support/mod.rs"]
mod support;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use levalab_core::{Analysis, prescribe};
use std::hint::black_box;
use support::classics::{nine_rt, two_ro};

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
