//! The curve of a quantity, joint by joint.

use crate::Quantity;
use crate::diagram::{Diagram, Extent, Jump, Run};
use levalab_core::{Analysis, Cam, Column, Stretch};

/// A difference smaller than this part of the values is rounding, not a jump.
const JUMP_TOLERANCE: f64 = 1e-9;

/// Fewest parts of a stretch that moves, so that one between two rows of the analysis still has its shape.
const LEAST_PARTS: usize = 12;

/// A row this close to a joint (radians) lies on it, and the joint's own limits are taken.
const SNAP: f64 = 1e-11;

/// Rows of the analysis, the narrow features of formulas between them, and both limits at every joint; a new run wherever they differ.
///
/// `shown` makes what is drawn of a value of the core.
pub(crate) fn gather(quantity: Quantity, cam: &Cam, analysis: &Analysis, shown: &dyn Fn(f64) -> f64) -> Diagram {
    let rows = analysis.column(Column::Theta).unwrap_or_default();
    let values = analysis.column(quantity.column()).filter(|_| quantity.applies(cam));
    let stretches = cam.program.stretches();
    let mut diagram = Diagram {
        quantity,
        points: Vec::with_capacity(rows.len() + 2 * stretches.len()),
        runs: Vec::with_capacity(stretches.len()),
        jumps: Vec::new(),
        travel: (!cam.program.is_cyclic()).then(|| cam.program.span()),
        borders: cam.program.borders().iter().map(|&border| place(cam, border)).collect(),
        ruled: false,
        limits: Vec::new(),
        forbidden: Vec::new(),
        extremes: Vec::new(),
        targets: Vec::new(),
        extent: Extent { low: 0.0, high: 0.0, cut: false, empty: false },
        radius: (!cam.follower.is_flat()).then(|| cam.follower.disc_radius()),
        beside: Vec::new(),
    };
    let value = |stretch: &Stretch, theta: f64| shown(quantity.of(cam, stretch.at(theta)));
    let mut start = 0;
    let mut row = 0;
    for (k, stretch) in stretches.iter().enumerate() {
        let first = value(stretch, stretch.from);
        let before = diagram.points.last().map(|point| point.1);
        let may_jump =
            analysis.joints.get(k).is_some_and(|joint| joint.jump.is_some_and(|order| order <= quantity.order()));
        match before {
            Some(before) if !(may_jump && differ(before, first)) => {}
            Some(before) => {
                diagram.jumps.push(Jump { theta: place(cam, stretch.from), before, after: first });
                diagram.end_run(&mut start);
                diagram.points.push((place(cam, stretch.from), first));
            }
            None => diagram.points.push((place(cam, stretch.from), first)),
        }
        row += rows[row..].partition_point(|&theta| theta <= stretch.from + SNAP);
        let after = row + rows[row..].partition_point(|&theta| theta < stretch.to - SNAP);
        let at_row = |k: usize| values.map_or_else(|| value(stretch, rows[k]), |values| shown(values[k]));
        let mut narrow = stretch.places().peekable();
        if stretch.is_still() {
            // Two ends are a straight line.
        } else if after - row + 1 >= LEAST_PARTS || narrow.peek().is_some() {
            for (k, &here) in (row..after).zip(&rows[row..after]) {
                while let Some(theta) = narrow.next_if(|&theta| theta < here) {
                    diagram.points.push((place(cam, theta), value(stretch, theta)));
                }
                diagram.points.push((place(cam, here), at_row(k)));
            }
            diagram.points.extend(narrow.map(|theta| (place(cam, theta), value(stretch, theta))));
        } else {
            let part = (stretch.to - stretch.from) / LEAST_PARTS as f64;
            let inside = (1..LEAST_PARTS).map(|i| stretch.from + part * i as f64);
            diagram.points.extend(inside.map(|theta| (place(cam, theta), value(stretch, theta))));
        }
        diagram.points.push((place(cam, stretch.to), value(stretch, stretch.to)));
        row = after;
    }
    diagram.end_run(&mut start);
    diagram.close_the_cycle(analysis);
    diagram
}

impl Diagram {
    fn end_run(&mut self, start: &mut usize) {
        self.runs.push(Run { points: *start..self.points.len(), comes_in: false, goes_out: false });
        *start = self.points.len();
    }

    /// A jump where the turn begins is shown at both edges, because the last segment joins the first.
    fn close_the_cycle(&mut self, analysis: &Analysis) {
        if self.travel.is_some() {
            return;
        }
        let (Some(&(_, after)), Some(&(end, before))) = (self.points.first(), self.points.last()) else { return };
        let order = self.quantity.order();
        let may_jump = analysis.joints.first().is_some_and(|joint| joint.jump.is_some_and(|jump| jump <= order));
        if may_jump && differ(before, after) {
            self.jumps.insert(0, Jump { theta: 0.0, before, after });
            self.jumps.push(Jump { theta: end, before, after });
        }
    }
}

/// A place of the cycle as it is drawn: degrees, or length for a cam that travels.
pub(crate) fn place(cam: &Cam, theta: f64) -> f64 {
    if cam.program.is_cyclic() { theta.to_degrees() } else { theta }
}

fn differ(a: f64, b: f64) -> bool {
    a.is_infinite() != b.is_infinite() || (a - b).abs() > JUMP_TOLERANCE * a.abs().max(b.abs())
}
