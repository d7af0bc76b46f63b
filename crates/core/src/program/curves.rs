//! The curves of a program: those of each segment, scaled to its β and its rise and joined to those of its neighbours.

use super::{Program, Segment};
use crate::law::{Arguments, Given, Piece, Shape, Solved, matched_polynomial};
use crate::{Cycle, ProgramError, ProgramProblem, Stretch, Svaj};
use std::f64::consts::{PI, TAU};

impl Program {
    pub(super) fn join(&self, solved: Vec<Option<Solved>>) -> Result<Vec<Stretch>, ProgramError> {
        let n = self.segments.len();
        let mut fixed: Vec<Vec<Stretch>> = Vec::with_capacity(n);
        for (k, solved) in solved.into_iter().enumerate() {
            fixed.push(match solved {
                Some(solved) => self.stretches_of(k, solved.pieces),
                None if self.segments[k].law.is_matched() => Vec::new(),
                None => self.stretches_of(k, self.unit_pieces(k)?),
            });
        }
        for k in 0..n {
            if let Shape::Matched(orders) = self.segments[k].law.shape {
                let (before, after) = (fixed[(k + n - 1) % n].last(), fixed[(k + 1) % n].first());
                let start = before.map_or_else(Svaj::default, |s| s.at(s.to)) * self.round_the_end(k == 0);
                let end = after.map_or_else(Svaj::default, |s| s.at(s.from)) * self.round_the_end(k + 1 == n);
                fixed[k] = vec![self.matched_stretch(k, orders, start, end)];
            }
        }
        Ok(fixed.into_iter().flatten().collect())
    }

    /// What the neighbour's derivatives count when it is met round the end of the cycle: as they are in a turn; upside down when
    /// the other half is the image of this one; nothing where a travel turns back, since the follower rests there.
    fn round_the_end(&self, round: bool) -> f64 {
        match self.cycle {
            Cycle::Mirrored if round => -1.0,
            Cycle::Travel(_) if round => 0.0,
            _ => 1.0,
        }
    }

    /// Appends the image of the first half of the turn: s(θ + π) = L − s(θ).
    pub(super) fn mirror(&mut self) {
        let (count, top) = (self.segments.len(), self.heights[self.segments.len()]);
        self.segments.extend_from_within(..);
        self.segments[count..].iter_mut().for_each(|segment| segment.rise = -segment.rise);
        self.borders.extend_from_within(1..);
        self.borders[count + 1..].iter_mut().for_each(|border| *border += PI);
        self.borders[2 * count] = TAU;
        self.heights.extend_from_within(1..);
        self.heights[count + 1..].iter_mut().for_each(|height| *height = top - *height);
        let images: Vec<Stretch> = self.stretches.iter().map(|stretch| stretch.image(count, top)).collect();
        self.stretches.extend(images);
        if let Some(last) = self.stretches.last_mut() {
            last.to = TAU;
        }
    }

    fn unit_pieces(&self, k: usize) -> Result<Vec<Piece>, ProgramError> {
        let segment = &self.segments[k];
        let arguments = Arguments { parameters: segment.parameters, falling: segment.rise < 0.0, beta: segment.beta };
        let pieces = segment.law.unit(arguments).map_err(|problem| ProgramError {
            segment: k,
            problem: ProgramProblem::Parameter {
                key: segment.law.parameters[problem.parameter].key,
                found: segment.parameters[problem.parameter],
                min: problem.min,
                max: problem.max,
            },
        })?;
        let scaled = |piece: Piece| Piece { curve: piece.curve.scaled(segment.rise, self.heights[k]), ..piece };
        Ok(pieces.into_iter().map(scaled).collect())
    }

    fn stretches_of(&self, k: usize, pieces: Vec<Piece>) -> Vec<Stretch> {
        let mut from = 0.0;
        let scaled = pieces.into_iter().map(|piece| {
            let from = std::mem::replace(&mut from, piece.until);
            self.stretch(k, piece, from)
        });
        scaled.collect()
    }

    fn matched_stretch(&self, k: usize, orders: usize, start: Svaj, end: Svaj) -> Stretch {
        let in_x = |limit: Svaj, height: f64| Svaj { s: height, ..limit.stretched(1.0 / self.segments[k].beta) };
        let curve = matched_polynomial(orders, in_x(start, self.heights[k]), in_x(end, self.heights[k + 1]));
        self.stretch(k, Piece::new(1.0, curve), 0.0)
    }

    fn stretch(&self, k: usize, Piece { until, curve, origin, span }: Piece, from: f64) -> Stretch {
        let (start, end) = (self.borders[k], self.borders[k + 1]);
        let beta = end - start;
        let to = if until >= 1.0 { end } else { start + beta * until };
        let (origin, own) = (start + beta * origin, beta * span);
        Stretch { from: start + beta * from, to, segment: k, origin, beta: own, per_beta: 1.0 / own, curve }
    }
}

pub(super) fn running_sum(segments: &[Segment]) -> Vec<f64> {
    let mut sum = 0.0;
    let sums = segments.iter().map(|segment| {
        sum += segment.beta;
        sum
    });
    std::iter::once(0.0).chain(sums).collect()
}

/// The heights at the borders, and the curves of the free laws, which say for themselves where they end.
pub(super) fn climb(cycle: Cycle, segments: &[Segment]) -> Result<(Vec<f64>, Vec<Option<Solved>>), ProgramError> {
    let (mut heights, mut solved) = (vec![0.0], Vec::with_capacity(segments.len()));
    let n = segments.len();
    let round = cycle == Cycle::Turn;
    for (k, segment) in segments.iter().enumerate() {
        let (start, rise) = (heights[k], segment.rise);
        let given = || Given {
            data: &segment.data,
            beta: segment.beta,
            start,
            rise,
            parameters: segment.parameters,
            before: (round || k > 0).then(|| edge(&segments[(k + n - 1) % n], true)).flatten(),
            after: (round || k + 1 < n).then(|| edge(&segments[(k + 1) % n], false)).flatten(),
            alone: round && n == 1,
        };
        let free = segment.law.free().map(|free| (free.solve)(&given())).transpose();
        let free = free.map_err(|problem| ProgramError { segment: k, problem: ProgramProblem::Data(problem) })?;
        let end = free.as_ref().and_then(|solved| solved.pieces.last()).map(|piece| piece.at(1.0).s);
        heights.push(end.unwrap_or(start + rise));
        solved.push(free);
    }
    Ok((heights, solved))
}

/// The derivatives at the start of a segment, or at its end, where they depend on nothing else.
fn edge(segment: &Segment, end: bool) -> Option<Svaj> {
    if !matches!(segment.law.shape, Shape::Rest | Shape::Unit(_)) {
        return None;
    }
    let Segment { parameters, beta, rise, .. } = *segment;
    let pieces = segment.law.unit(Arguments { parameters, falling: rise < 0.0, beta }).ok()?;
    let unit = if end { pieces.last()?.at(1.0) } else { pieces.first()?.at(0.0) };
    Some((unit * rise).stretched(beta))
}

/// How a segment of a fixed law joins others: the limits at its ends, and the lowest order that jumps within it.
pub(crate) struct Ends {
    /// Limits at its start and at its end.
    pub limits: [Svaj; 2],
    /// The lowest order that jumps between its pieces.
    pub inner_jump: Option<u8>,
}

/// Orders of a derivative that differ by less than this part of the larger between two pieces of a law are continuous.
const PIECE_TOLERANCE: f64 = 1e-9;

/// The ends of a segment of a fixed law; `None` for a law that depends on its neighbours or on data.
pub(crate) fn ends(segment: &Segment) -> Option<Ends> {
    if !matches!(segment.law.shape, Shape::Rest | Shape::Unit(_)) {
        return None;
    }
    let Segment { parameters, beta, rise, .. } = *segment;
    let pieces = segment.law.unit(Arguments { parameters, falling: rise < 0.0, beta }).ok()?;
    let limits = [pieces.first()?.at(0.0), pieces.last()?.at(1.0)].map(|unit| (unit * rise).stretched(beta));
    let jumps = |order: &usize| {
        pieces.windows(2).any(|pair| {
            let [before, after] = [pair[0].at(pair[0].until), pair[1].at(pair[0].until)].map(|y| y.order(*order));
            (before - after).abs() > PIECE_TOLERANCE * before.abs().max(after.abs()).max(1.0)
        })
    };
    Some(Ends { limits, inner_jump: (1..4).find(jumps).map(|order| order as u8) })
}
