//! ρ over the turn: a range that tells something, and a curve cut where it leaves it.

use crate::diagram::{Diagram, Extent, Point, Run};
use crate::gather::place;
use levalab_core::{Analysis, Cam};

/// ρ is shown whole while it stays within this many medians of |ρ|.
const TAME: f64 = 4.0;

/// How many medians of |ρ| are shown of one that does not.
const SHOWN: f64 = 3.0;

/// Room around what must be seen of a range that is cut, as a part of it.
const ROOM: f64 = 1.8;

/// Least share of a cut range that lies below zero.
const BELOW: f64 = 0.15;

/// What must be seen is given up beyond so many times the range that the medians ask for.
const GIVEN_UP: f64 = 2.0;

/// Chooses the extent, and notes limits and extremes.
pub(crate) fn finish(diagram: &mut Diagram, cam: &Cam, analysis: &Analysis) {
    let (base, radius) = (cam.follower.base_radius(), cam.follower.disc_radius());
    diagram.extent = extent(diagram, base, analysis);
    diagram.limits = vec![0.0];
    // No hollow is tighter than the roller in it.
    diagram.limits.extend((radius > 0.0).then_some(-radius));
    diagram.forbidden = if cam.follower.is_flat() { vec![(f64::NEG_INFINITY, 0.0)] } else { vec![(-radius, 0.0)] };
    diagram.forbidden.retain(|(from, to)| from < to);
    let summary = &analysis.summary;
    let widest = summary.rho.max.is_finite().then_some((summary.rho.max, summary.rho.max_at));
    let Extent { low, high, .. } = diagram.extent;
    let places = [summary.least_convex, summary.tightest_hollow, widest].into_iter().flatten();
    let level = summary.rho.max - summary.rho.min <= LEVEL * base;
    let places = places.filter(|&(rho, _)| low <= rho && rho <= high).take(if level { 1 } else { 3 });
    diagram.extremes = places.map(|(rho, theta)| (place(cam, theta), rho)).collect();
}

/// Cuts the curve to its extent.
pub(crate) fn cut(diagram: &mut Diagram) {
    let Extent { low, high, .. } = diagram.extent;
    let bend = Bend { radius: diagram.radius, low, high };
    cut_to(diagram, bend);
}

/// A ρ that varies less than this part of the base radius is constant.
const LEVEL: f64 = 1e-9;

/// The whole of a tame ρ; otherwise some medians of |ρ|, with 0, Rb, the least convex ρ and the tightest hollow.
fn extent(diagram: &Diagram, base_radius: f64, analysis: &Analysis) -> Extent {
    let summary = &analysis.summary;
    let (least, greatest) = (summary.rho.min, summary.rho.max);
    let median = median_size(&diagram.points).unwrap_or(base_radius);
    let tame = TAME * median.max(base_radius);
    if least > -tame && greatest < tame {
        return Extent { low: least.min(0.0), high: greatest.max(base_radius), cut: false, empty: false };
    }
    let wanted = SHOWN * median.max(base_radius);
    let must = |place: Option<(f64, f64)>| {
        place.map_or(0.0, |(rho, _)| if rho.abs() < GIVEN_UP * wanted { rho * ROOM } else { 0.0 })
    };
    let (convex, hollow) = (must(summary.least_convex), must(summary.tightest_hollow));
    let high = wanted.max(convex);
    Extent { low: convex.min(hollow).min(-BELOW * high), high, cut: true, empty: false }
}

fn median_size(points: &[Point]) -> Option<f64> {
    let mut sizes: Vec<f64> = points.iter().map(|point| point.1.abs()).filter(|size| size.is_finite()).collect();
    let middle = sizes.len() / 2;
    (!sizes.is_empty()).then(|| *sizes.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// How the profile bends, which is smooth where ρ is not: κp = 1/(ρ + Rf) for a disc, ρ itself for a face.
#[derive(Clone, Copy)]
struct Bend {
    radius: Option<f64>,
    low: f64,
    high: f64,
}

impl Bend {
    fn of(self, rho: f64) -> f64 {
        self.radius.map_or(rho, |radius| 1.0 / (rho + radius))
    }

    fn holds(self, rho: f64) -> bool {
        self.low <= rho && rho <= self.high
    }

    /// True when ρ runs through ±∞ between two neighbours.
    fn passes_infinity(self, from: f64, to: f64) -> bool {
        self.radius.is_some() && (self.of(from) < 0.0) != (self.of(to) < 0.0)
    }

    /// Where the curve from a point inside to a neighbour leaves the range: the bend is taken as straight between them.
    fn exit(self, from: Point, to: Point) -> Option<Point> {
        let (start, end) = (self.of(from.1), self.of(to.1));
        let reach = |border: f64| {
            let part = (self.of(border) - start) / (end - start);
            (part > 0.0 && part <= 1.0).then_some((part, border))
        };
        let (part, border) = match (reach(self.low), reach(self.high)) {
            (Some(a), Some(b)) => {
                if a.0 < b.0 {
                    a
                } else {
                    b
                }
            }
            (a, b) => a.or(b)?,
        };
        Some((from.0 + part * (to.0 - from.0), border))
    }
}

/// A run that is not yet finished.
#[derive(Clone, Copy)]
struct Start {
    first: usize,
    comes_in: bool,
}

/// Keeps what lies in the range, with its ends exactly on the border.
fn cut_to(diagram: &mut Diagram, bend: Bend) {
    let whole = std::mem::take(&mut diagram.points);
    let runs = std::mem::take(&mut diagram.runs);
    diagram.points.reserve(whole.len() + 2 * runs.len());
    for run in runs {
        let mut open: Option<Start> = None;
        let mut last: Option<Point> = None;
        for &point in &whole[run.points] {
            let goes_on = last.is_none_or(|last| !bend.passes_infinity(last.1, point.1));
            if !(goes_on && bend.holds(point.1))
                && let (Some(start), Some(inside)) = (open.take(), last)
            {
                diagram.leave(start, bend.exit(inside, point));
            }
            if bend.holds(point.1) {
                if open.is_none() {
                    open = Some(diagram.enter(last.and_then(|outside| bend.exit(point, outside))));
                }
                diagram.points.push(point);
            }
            last = Some(point);
        }
        if let Some(start) = open {
            diagram.leave(start, None);
        }
    }
}

impl Diagram {
    fn enter(&mut self, border: Option<Point>) -> Start {
        let first = self.points.len();
        self.points.extend(border);
        Start { first, comes_in: border.is_some() }
    }

    fn leave(&mut self, start: Start, border: Option<Point>) {
        self.points.extend(border);
        self.runs.push(Run {
            points: start.first..self.points.len(),
            comes_in: start.comes_in,
            goes_out: border.is_some(),
        });
    }
}
