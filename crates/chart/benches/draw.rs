//! How long a diagram takes to gather, and to draw on a backend that does nothing.

use criterion::{Criterion, criterion_group, criterion_main};
use levalab_chart::{Diagram, Quantity, Style, Timing, draw};
use levalab_core::{Analysis, Cam, Follower, Program, Segment};
use plotters::prelude::IntoDrawingArea;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};
use std::hint::black_box;

/// Takes everything and draws nothing.
struct Nowhere;

type Done = Result<(), DrawingErrorKind<std::io::Error>>;

impl DrawingBackend for Nowhere {
    type ErrorType = std::io::Error;

    fn get_size(&self) -> (u32, u32) {
        (6720, 2240)
    }

    fn ensure_prepared(&mut self) -> Done {
        Ok(())
    }

    fn present(&mut self) -> Done {
        Ok(())
    }

    fn draw_pixel(&mut self, _: BackendCoord, _: BackendColor) -> Done {
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, _: &S) -> Done {
        black_box(path.into_iter().map(|(x, y)| x ^ y).fold(0, |all, each| all ^ each));
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(&mut self, _: BackendCoord, _: BackendCoord, _: &S, _: bool) -> Done {
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, _: I, _: &S) -> Done {
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, _: BackendCoord, _: u32, _: &S, _: bool) -> Done {
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, _: &S, _: BackendCoord) -> Done {
        black_box(text);
        Ok(())
    }
}

/// Eight segments of different laws.
fn cam() -> Cam {
    let rows =
        ["modified-sine", "dwell", "cycloidal", "dwell", "polynomial-3-4-5", "dwell", "polynomial-4-5-6-7", "dwell"];
    let rises = [10.0, 0.0, -10.0, 0.0, 10.0, 0.0, -10.0, 0.0];
    let segments: Vec<Segment> = rows
        .iter()
        .zip(rises)
        .filter_map(|(law, rise)| Segment::of(law, if rise == 0.0 { 40.0 } else { 50.0 }, rise))
        .collect();
    let follower = Follower::translating_roller(35.0, 7.0).expect("it rests");
    Cam::new(Program::new(&segments).expect("it closes"), follower)
}

fn draw_all(criterion: &mut Criterion) {
    let cam = cam();
    let analysis = Analysis::of(&cam, 720);
    let style = Style { pixel_ratio: 2.0, dash: vec![4.0, 2.5], ..Style::default() };
    let area = Nowhere.into_drawing_area();
    for quantity in [Quantity::S, Quantity::J, Quantity::Rho] {
        let of = || Diagram::of(quantity, &cam, &analysis, Timing::PerRadian);
        let diagram = of();
        criterion.bench_function(&format!("gather {}", quantity.name()), |bencher| bencher.iter(of));
        criterion.bench_function(&format!("draw {}", quantity.name()), |bencher| {
            bencher.iter(|| draw(&area, black_box(&diagram), &style, |_| {}).is_ok());
        });
    }
}

criterion_group!(benches, draw_all);
criterion_main!(benches);
