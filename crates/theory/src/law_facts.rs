//! What can be said of a law from its own curve: its peaks, and what jumps between two rests.

use levalab_core::law::{Arguments, Piece};
use levalab_core::{Analysis, Cam, Follower, Law, Program, Segment, Svaj};

/// A rise with the parameters that a form starts with.
pub(crate) fn rising(law: &Law) -> Arguments {
    Arguments { parameters: law.default_parameters(), falling: false, beta: 1.0 }
}

/// A jump smaller than this beside the peaks is rounding.
const ROUNDING: f64 = 1e-9;

/// A law between two rests.
pub struct LawFacts {
    /// Its curve.
    pub pieces: Vec<Piece>,
    /// Greatest |y|, |y′|, |y″| and |y‴|.
    pub peaks: [f64; 4],
    /// For each order, the places x where it jumps, the rests at both ends included, and by how much.
    pub jumps: [Vec<(f64, f64)>; 4],
}

impl LawFacts {
    /// Studies a law with the parameters that a form starts with; none when its curve depends on data.
    #[must_use]
    pub fn of(law: &Law) -> Option<Self> {
        let pieces = law.unit(rising(law)).ok()?;
        let peaks = if law.is_dwell() { [0.0; 4] } else { peaks(law)? };
        Some(Self { jumps: jumps(&pieces), pieces, peaks })
    }

    /// False for a dwell.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.peaks[1] > 0.0
    }
}

fn jumps(pieces: &[Piece]) -> [Vec<(f64, f64)>; 4] {
    let mut jumps = [const { Vec::new() }; 4];
    let (mut x, mut before) = (0.0, Svaj::default());
    let rest = Piece::new(1.0, levalab_core::Curve::polynomial(&[1.0]));
    for piece in pieces.iter().chain([&rest]) {
        let step = piece.at(x) - before;
        for (order, places) in jumps.iter_mut().enumerate() {
            if step.order(order).abs() > ROUNDING * 10_f64.powi(order as i32) {
                places.push((x, step.order(order)));
            }
        }
        (x, before) = (piece.until, piece.at(piece.until));
    }
    jumps
}

/// Greatest derivatives, found by the core on a cam: they are those of the law times L/βⁿ.
fn peaks(law: &Law) -> Option<[f64; 4]> {
    let degrees = 120.0;
    let cam = cam(&[("dwell", 60.0, 0.0), (law.id, degrees, 1.0), ("dwell", 60.0, 0.0), (law.id, degrees, -1.0)])?;
    let summary = Analysis::of(&cam, 720).summary;
    let mut stretch = 1.0;
    Some([summary.s, summary.v, summary.a, summary.j].map(|extremes| {
        let peak = extremes.greatest_size().0 * stretch;
        stretch *= degrees.to_radians();
        peak
    }))
}

/// A cam with that program, under a knife edge.
pub(crate) fn cam(rows: &[(&str, f64, f64)]) -> Option<Cam> {
    let segments: Option<Vec<Segment>> = rows.iter().map(|&(law, beta, rise)| Segment::of(law, beta, rise)).collect();
    let program = Program::new(&segments?).ok()?;
    Some(Cam::new(program, Follower::translating_knife(4.0).ok()?))
}
