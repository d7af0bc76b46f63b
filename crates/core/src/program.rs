//! The motion program: segments that cover one cycle of the cam, joined into a list of smooth pieces.

use crate::law::{Arguments, Data, Given, Law, MAX_LAW_PARAMETERS, Piece, Shape, Solved, matched_polynomial};
use crate::{Cycle, ProgramError, ProgramProblem, Stretch, Svaj};
use std::f64::consts::{PI, TAU};

/// One stretch of the program.
#[derive(Clone, Debug)]
pub struct Segment {
    /// How the follower moves.
    pub law: &'static Law,
    /// Cam angle spanned, radians; length of travel spanned, for a translating cam.
    pub beta: f64,
    /// Height gained, negative in a return; length, or radians for an oscillating follower. That of a free law follows from its
    /// data; for a formula it is its L.
    pub rise: f64,
    /// The law's own parameters, in the order of [`Law::parameters`].
    pub parameters: [f64; MAX_LAW_PARAMETERS],
    /// What a free law is made from.
    pub data: Data,
}

impl Segment {
    /// A segment of a law that takes no parameters of its own, or takes them at their defaults.
    #[must_use]
    pub fn new(law: &'static Law, beta: f64, rise: f64) -> Self {
        Self { law, beta, rise, parameters: law.default_parameters(), data: Data::None }
    }

    /// A segment from a law's name and an angle in degrees, as tables in books give them.
    #[must_use]
    pub fn of(id: &str, degrees: f64, rise: f64) -> Option<Self> {
        Law::by_id(id).map(|law| Self::new(law, degrees.to_radians(), rise))
    }
}

/// Most segments that a program may have: the cap that links and forms share.
pub const MAX_SEGMENTS: usize = 64;

/// How far β's may miss a whole turn, in radians: 10⁻⁹ degrees, what typed decimals add up to at worst. For a travel, the same
/// part of its length.
pub const TURN_TOLERANCE: f64 = 1e-9 * TAU / 360.0;

/// How far the end may miss the start, in units of the design.
pub const CLOSING_TOLERANCE: f64 = 1e-9;

/// The narrowest segment, radians (a thousandth of a degree): less is below what any cam grinder divides. For a travel, the same
/// part of its length.
pub const MIN_BETA: f64 = 1e-3 * TAU / 360.0;

/// A jump smaller than this part of the greatest value of its derivative is rounding, not a jump.
const JUMP_TOLERANCE: f64 = 1e-9;

/// A station this close to a joint (radians, or the same part of a travel) lies on it, and takes the limit from the right.
const SNAP: f64 = 1e-11;

/// A system worse conditioned than this leaves fewer than six of an `f64`'s sixteen digits: its curve is not to be trusted.
pub(crate) const LEAST_TRUSTED: f64 = 1e10;

/// A joint between smooth stretches of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Where it is, radians.
    pub theta: f64,
    /// The segment that begins there, or within which it lies.
    pub segment: usize,
    /// Limit from the left.
    pub before: Svaj,
    /// Limit from the right.
    pub after: Svaj,
    /// The lowest order that jumps there: 0 for *s* to 3 for *j*.
    pub jump: Option<u8>,
}

/// A segment whose curve its data hardly determine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubt {
    /// Index of the segment.
    pub segment: usize,
    /// The condition number of its system.
    pub condition: f64,
    /// The most with which a curve is trusted.
    pub limit: f64,
}

/// A checked cyclic motion program.
#[derive(Clone, Debug)]
pub struct Program {
    cycle: Cycle,
    segments: Vec<Segment>,
    borders: Vec<f64>,
    heights: Vec<f64>,
    stretches: Vec<Stretch>,
    doubts: Vec<Doubt>,
}

impl Program {
    /// Joins segments that cover one turn into a program.
    ///
    /// # Errors
    /// Names the segment and says what is wrong: a β or L that cannot be, a dwell that rises, parameters of a law out of
    /// range, a turn that is not whole, an end that misses the start, a joint below the base circle, or two generic
    /// polynomials side by side (cyclically), which would have no end conditions to take.
    pub fn new(segments: &[Segment]) -> Result<Self, ProgramError> {
        Self::on(Cycle::Turn, segments)
    }

    /// Joins segments into a program on any cycle.
    ///
    /// # Errors
    /// As [`Program::new`]; half a turn that is mirrored, and a travel, may end at another height than they start.
    pub fn on(cycle: Cycle, segments: &[Segment]) -> Result<Self, ProgramError> {
        check_each(cycle, segments)?;
        let borders = running_sum(segments);
        let (heights, solved) = climb(cycle, segments)?;
        check_cycle(cycle, segments, &borders, &heights)?;
        let doubt = |(segment, solved): (usize, &Option<Solved>)| {
            let condition = solved.as_ref()?.condition;
            (condition > LEAST_TRUSTED).then_some(Doubt { segment, condition, limit: LEAST_TRUSTED })
        };
        let doubts = solved.iter().enumerate().filter_map(doubt).collect();
        let mut program = Self { cycle, segments: segments.to_vec(), borders, heights, stretches: Vec::new(), doubts };
        let last = program.segments.len();
        program.borders[last] = cycle.given();
        if cycle == Cycle::Turn {
            program.heights[last] = 0.0;
        }
        program.stretches = program.join(solved)?;
        if cycle == Cycle::Mirrored {
            program.mirror();
        }
        Ok(program)
    }

    /// The motion of a second element fixed to the same follower, on the other side of the shaft: `top` − s(θ).
    #[must_use]
    pub fn reversed(&self, top: f64) -> Self {
        let mut program = self.clone();
        for segment in &mut program.segments {
            segment.rise = -segment.rise;
        }
        for height in &mut program.heights {
            *height = top - *height;
        }
        for stretch in &mut program.stretches {
            stretch.curve = stretch.curve.clone().scaled(-1.0, top);
        }
        program
    }

    /// How its segments make a whole cycle.
    #[must_use]
    pub fn cycle(&self) -> Cycle {
        self.cycle
    }

    /// What it covers: 2π, or the length of a travel.
    #[must_use]
    pub fn span(&self) -> f64 {
        self.cycle.span()
    }

    /// True when its end is its beginning, as for a cam that turns.
    #[must_use]
    pub fn is_cyclic(&self) -> bool {
        !matches!(self.cycle, Cycle::Travel(_))
    }

    /// A difference in θ too small to tell places apart.
    fn snap(&self) -> f64 {
        SNAP * (self.span() / TAU)
    }

    /// The segments over the whole cycle: those it was made from and, when they are mirrored, their images.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// The segments it was made from: half of them when the other half is their image.
    #[must_use]
    pub fn given(&self) -> &[Segment] {
        let images = if self.cycle == Cycle::Mirrored { self.segments.len() / 2 } else { 0 };
        &self.segments[..self.segments.len() - images]
    }

    /// θ of the borders of the segments, from 0 to the [`span`](Self::span): one more than there are segments.
    #[must_use]
    pub fn borders(&self) -> &[f64] {
        &self.borders
    }

    /// *s* at the borders of the segments: one more than there are segments.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The segments whose curve is not to be trusted.
    #[must_use]
    pub fn doubts(&self) -> &[Doubt] {
        &self.doubts
    }

    /// The smooth stretches, in order, from 0 to the [`span`](Self::span).
    #[must_use]
    pub fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// Displacement and derivatives at any θ; on a joint, the limit from the right. A travel is held at its ends.
    #[must_use]
    pub fn at(&self, theta: f64) -> Svaj {
        let span = self.span();
        if !self.is_cyclic() {
            let theta = theta.clamp(0.0, span);
            return self.stretches[self.stretch_index(theta)].at(theta);
        }
        let theta = theta.rem_euclid(span);
        // A hair before the end of the turn is its beginning.
        let theta = if theta >= span - SNAP { 0.0 } else { theta };
        self.stretches[self.stretch_index(theta)].at(theta)
    }

    /// Index of the stretch that holds for `theta` within the span; on a joint, the one to its right.
    #[must_use]
    pub fn stretch_index(&self, theta: f64) -> usize {
        let snap = self.snap();
        self.stretches.partition_point(|stretch| stretch.to <= theta + snap).min(self.stretches.len() - 1)
    }

    /// Every joint between smooth stretches, the one at θ = 0 first: θ, the stretch that begins there and the limits on both
    /// sides. At the ends of a travel, where the cam turns back, the limits are those of the same end, run forth and back.
    pub fn joints(&self) -> impl Iterator<Item = (f64, &Stretch, Svaj, Svaj)> {
        let n = self.stretches.len();
        let last = &self.stretches[n - 1];
        let end = last.at(last.to);
        let start = if self.is_cyclic() { end } else { run_back(self.stretches[0].at(0.0)) };
        let turning = (!self.is_cyclic()).then(|| (last.to, last, end, run_back(end)));
        let inner = (0..n).map(move |i| {
            let after = &self.stretches[i];
            let before = if i == 0 { start } else { self.stretches[i - 1].at(self.stretches[i - 1].to) };
            (after.from, after, before, after.at(after.from))
        });
        inner.chain(turning)
    }

    /// Every joint, the one at θ = 0 first, with the lowest order that jumps there.
    ///
    /// A difference is a jump when it is more than rounding beside the greatest value of its derivative in the program.
    #[must_use]
    pub fn classified_joints(&self) -> Vec<Joint> {
        let scales: [f64; 4] =
            std::array::from_fn(|order| self.look().map(|motion| motion.order(order).abs()).fold(0.0, f64::max));
        let n = self.stretches.len();
        let classify = |(i, (theta, stretch, before, after)): (usize, (f64, &Stretch, Svaj, Svaj))| {
            let sides = [&self.stretches[(i + n - 1) % n], stretch];
            // What a program may leave open at its end is no jump of s.
            let left_open = [CLOSING_TOLERANCE, 0.0, 0.0, 0.0];
            let jumps = |&order: &usize| {
                (before.order(order) - after.order(order)).abs()
                    > JUMP_TOLERANCE * scales[order]
                        + left_open[order]
                        + sides.map(|side| side.rounding(scales[0], order)).iter().sum::<f64>()
            };
            let jump = (0..4).find(jumps).map(|order| order as u8);
            Joint { theta, segment: stretch.segment, before, after, jump }
        };
        self.joints().enumerate().map(classify).collect()
    }

    /// Motion at a few places of every stretch, both ends included: enough to know how large things are.
    pub(crate) fn look(&self) -> impl Iterator<Item = Svaj> {
        const PARTS: usize = 8;
        self.stretches.iter().flat_map(|stretch| {
            (0..=PARTS).map(move |i| stretch.at(stretch.from + (stretch.to - stretch.from) * i as f64 / PARTS as f64))
        })
    }

    fn join(&self, solved: Vec<Option<Solved>>) -> Result<Vec<Stretch>, ProgramError> {
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
    fn mirror(&mut self) {
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

fn running_sum(segments: &[Segment]) -> Vec<f64> {
    let mut sum = 0.0;
    let sums = segments.iter().map(|segment| {
        sum += segment.beta;
        sum
    });
    std::iter::once(0.0).chain(sums).collect()
}

/// The heights at the borders, and the curves of the free laws, which say for themselves where they end.
fn climb(cycle: Cycle, segments: &[Segment]) -> Result<(Vec<f64>, Vec<Option<Solved>>), ProgramError> {
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

/// The end of a travel as it is met on the way back.
fn run_back(limit: Svaj) -> Svaj {
    Svaj::new(limit.s, -limit.v, limit.a, -limit.j)
}

fn check_each(cycle: Cycle, segments: &[Segment]) -> Result<(), ProgramError> {
    let refuse = |segment, problem| Err(ProgramError { segment, problem });
    let most = if cycle == Cycle::Mirrored { MAX_SEGMENTS / 2 } else { MAX_SEGMENTS };
    if segments.is_empty() || segments.len() > most {
        return refuse(0, ProgramProblem::Count { found: segments.len() });
    }
    let (given, part) = (cycle.given(), cycle.span() / TAU);
    for (k, segment) in segments.iter().enumerate() {
        if !segment.beta.is_finite() || segment.beta < MIN_BETA * part || segment.beta > given + TURN_TOLERANCE * part {
            return refuse(k, ProgramProblem::Beta { found: segment.beta });
        }
        if !segment.rise.is_finite() {
            return refuse(k, ProgramProblem::Rise { found: segment.rise });
        }
        if segment.law.is_dwell() && segment.rise != 0.0 {
            return refuse(k, ProgramProblem::DwellRises { found: segment.rise });
        }
        let joins_another = k + 1 < segments.len() || !matches!(cycle, Cycle::Travel(_));
        let next = &segments[(k + 1) % segments.len()];
        if joins_another && segment.law.is_matched() && next.law.is_matched() {
            return refuse(k, ProgramProblem::AdjacentPolynomials { next: (k + 1) % segments.len() });
        }
    }
    Ok(())
}

fn check_cycle(cycle: Cycle, segments: &[Segment], borders: &[f64], heights: &[f64]) -> Result<(), ProgramError> {
    let last = segments.len() - 1;
    let (covered, height) = (borders[last + 1], heights[last + 1]);
    if (covered - cycle.given()).abs() > TURN_TOLERANCE * (cycle.span() / TAU) {
        return Err(ProgramError { segment: last, problem: ProgramProblem::Turn { found: covered } });
    }
    let free_end = cycle != Cycle::Turn;
    let checked = if free_end { heights } else { &heights[..=last] };
    if let Some(k) = checked.iter().position(|&height| height < -CLOSING_TOLERANCE) {
        return Err(ProgramError { segment: k - 1, problem: ProgramProblem::BelowBase { found: heights[k] } });
    }
    if !free_end && height.abs() > CLOSING_TOLERANCE {
        return Err(ProgramError { segment: last, problem: ProgramProblem::Closing { found: height } });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn program(rows: &[(&str, f64, f64)]) -> Result<Program, ProgramError> {
        let segments: Vec<Segment> = rows.iter().filter_map(|&(id, beta, rise)| Segment::of(id, beta, rise)).collect();
        assert_eq!(segments.len(), rows.len(), "a law's name is misspelt");
        Program::new(&segments)
    }

    fn refusal(rows: &[(&str, f64, f64)]) -> (usize, ProgramProblem) {
        let error = program(rows).expect_err("this cannot be a program");
        (error.segment, error.problem)
    }

    #[test]
    fn a_joint_belongs_to_the_segment_on_its_right() {
        let program = program(&[("constant-velocity", 90.0, 1.0), ("dwell", 90.0, 0.0), ("cycloidal", 180.0, -1.0)])
            .expect("joined");
        let slope = 1.0 / 90_f64.to_radians();
        assert!((program.at(0.0).v - slope).abs() < 1e-15);
        assert!((program.at(TAU).v - slope).abs() < 1e-15 && (program.at(-1e-13).v - slope).abs() < 1e-15);
        assert!(program.at(90_f64.to_radians()).v.abs() < 1e-15);
        assert!((program.at(90_f64.to_radians() - 1e-9).v - slope).abs() < 1e-15);
    }

    #[test]
    fn what_cannot_be_a_program_is_refused_at_its_segment() {
        assert_eq!(refusal(&[]), (0, ProgramProblem::Count { found: 0 }));
        let (segment, problem) = refusal(&[("cycloidal", 180.0, 10.0), ("cycloidal", 170.0, -10.0)]);
        assert!(segment == 1 && matches!(problem, ProgramProblem::Turn { .. }));
        let (segment, problem) = refusal(&[("cycloidal", 180.0, 10.0), ("cycloidal", 180.0, -9.0)]);
        assert!(segment == 1 && matches!(problem, ProgramProblem::Closing { .. }));
        let (segment, problem) = refusal(&[("cycloidal", 180.0, -10.0), ("cycloidal", 180.0, 10.0)]);
        assert!(segment == 0 && matches!(problem, ProgramProblem::BelowBase { .. }));
        let (segment, problem) = refusal(&[("dwell", 180.0, 1.0), ("cycloidal", 180.0, -1.0)]);
        assert!(segment == 0 && matches!(problem, ProgramProblem::DwellRises { .. }));
        let (segment, problem) =
            refusal(&[("polynomial-5", 180.0, 1.0), ("dwell", 90.0, 0.0), ("polynomial-7", 90.0, -1.0)]);
        assert_eq!((segment, problem), (2, ProgramProblem::AdjacentPolynomials { next: 0 }), "neighbours across 0°");
    }

    #[test]
    fn a_generic_polynomial_takes_what_its_neighbours_have() {
        let rows = [("constant-velocity", 90.0, 1.0), ("polynomial-7", 90.0, 0.5), ("simple-harmonic", 180.0, -1.5)];
        let program = program(&rows).expect("joined");
        let joints = program.classified_joints();
        assert_eq!(joints[1].jump, None, "constant velocity to polynomial");
        assert_eq!(joints[2].jump, None, "polynomial to harmonic");
        assert_eq!(joints[0].jump, Some(1), "harmonic to constant velocity");
    }

    #[test]
    fn jumps_are_named_by_their_lowest_order() {
        let between_dwells = |id: &str| {
            let rows = [("dwell", 90.0, 0.0), (id, 90.0, 1.0), ("dwell", 90.0, 0.0), (id, 90.0, -1.0)];
            program(&rows).expect("joined").classified_joints().iter().filter_map(|joint| joint.jump).min()
        };
        assert_eq!(between_dwells("constant-velocity"), Some(1));
        assert_eq!(between_dwells("simple-harmonic"), Some(2));
        assert_eq!(between_dwells("cycloidal"), Some(3));
        assert_eq!(between_dwells("polynomial-4-5-6-7"), None);
    }
}
