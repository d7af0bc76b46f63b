//! From what a machine must do to a whole program: dwells, straight stretches and points are joined by the smoothest law that may stand there.
//!
//! The rule: every law that keeps *v* and *a* continuous (and *j*, for high speeds) and stays on or above the base circle is tried in each gap, and
//! the one with the lowest peak of the derivative asked for is taken. What was tried is told along with the choice.

use crate::extreme::root;
use crate::law::{Arguments, Condition, Data, Given, Group, LAWS, Law, Piece, matched_polynomial};
use crate::program::MIN_BETA;
use crate::{CLOSING_TOLERANCE, MAX_SEGMENTS, Program, Segment, Svaj};
use std::f64::consts::TAU;

/// Something that the machine must do. Angles in radians, heights above the base circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Demand {
    /// Stay at a height.
    Dwell {
        /// From this θ.
        from: f64,
        /// To this one.
        to: f64,
        /// The height.
        height: f64,
    },
    /// Go from a height to another at constant velocity.
    Straight {
        /// From this θ.
        from: f64,
        /// To this one.
        to: f64,
        /// The height at `from`.
        start: f64,
        /// The height at `to`.
        end: f64,
    },
    /// Pass through a point.
    Pass {
        /// Its θ.
        at: f64,
        /// Its height.
        height: f64,
        /// The velocity there, when it matters.
        velocity: Option<f64>,
    },
}

/// How smooth the joining has to be, and what is to be small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Taste {
    /// True when *j* must be continuous too, as high speeds need.
    pub high_speed: bool,
    /// The order of the derivative whose peak is to be low: 1 *v*, 2 *a*, 3 *j*.
    pub least: usize,
}

/// A joined program, and why it is as it is.
#[derive(Clone, Debug)]
pub struct Joining {
    /// The segments of the whole turn.
    pub segments: Vec<Segment>,
    /// What was chosen in each gap, in order.
    pub choices: Vec<Choice>,
}

/// What was chosen in a gap.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Where the gap begins, radians.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The first of its segments.
    pub segment: usize,
    /// Why.
    pub reason: Reason,
    /// Everything that was tried, the chosen one first and then by its peak; none where there was nothing to choose.
    pub tried: Vec<Tried>,
}

/// Why a way of joining was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The follower is already at its height.
    Stays,
    /// Both sides lie on one straight line.
    InLine,
    /// Nothing else is smooth enough there.
    Only,
    /// It has the lowest peak.
    Least,
}

/// A way of joining.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// How.
    pub way: Way,
    /// Its peaks of |v|, |a| and |j|.
    pub peaks: [f64; 3],
    /// False when it would go below the base circle.
    pub above: bool,
}

/// How a gap is joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// By one segment of a law.
    Law(&'static Law),
    /// At rest for a while, beside a segment of a law.
    Waiting(&'static Law),
    /// By a polynomial from point to point, with the velocity at each taken from the points beside it.
    Pieces,
    /// By a polynomial from point to point, at rest for an instant at each.
    Stops,
}

/// What makes a joining impossible, and the demand to blame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoinError {
    /// Its index in the list as it was given.
    pub demand: usize,
    /// What is wrong.
    pub problem: JoinProblem,
}

/// What can be wrong with a list of demands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JoinProblem {
    /// There is none, or nothing moves.
    Nothing,
    /// There are more than a program has room for.
    TooMany,
    /// It does not lie within the turn, ends before it begins, or has a number that is not finite.
    Place,
    /// It begins before another one ends.
    Overlap {
        /// The other one.
        other: usize,
    },
    /// It begins where another one ends, and *s* or *v* would jump.
    Clash {
        /// The other one.
        other: usize,
    },
    /// It is below the base circle, or goes on below it.
    Low,
    /// At θ = 0 the follower is on the base circle, and this one begins there at another height.
    StartsHigh,
    /// After it no law comes by without going below the base circle.
    NoWay,
}

/// What the follower does where a gap begins or ends.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Rest,
    Line,
    Instant,
}

/// A demand in its place.
#[derive(Clone, Copy)]
struct Anchor {
    demand: usize,
    from: f64,
    to: f64,
    start: Svaj,
    end: Svaj,
    side: Side,
    /// False for a point, even where the follower rests for an instant.
    lasts: bool,
}

/// A segment with its curve over x ∈ [0, 1], in absolute heights.
struct Leg {
    segment: Segment,
    pieces: Vec<Piece>,
}

struct Candidate {
    way: Way,
    legs: Vec<Leg>,
}

/// A height or a velocity that differs by less than this part of the greatest height (a radian) does not differ.
const SAME: f64 = 1e-9;

/// Digits of an acceleration or a jerk that is chosen here, so that both sides write the same.
const CHOSEN_DIGITS: i32 = 4;

/// Joins demands, in any order, into a program of a whole turn.
///
/// # Errors
/// Says which demand cannot be met, and why.
pub fn join(demands: &[Demand], taste: Taste) -> Result<Joining, JoinError> {
    let (anchors, passes) = sorted(demands)?;
    let estimated = instant(&anchors, &passes);
    // A bend at θ = 0 that leaves no way for a gap is straightened.
    joined(&anchors, &passes, estimated, taste).or_else(|_| joined(&anchors, &passes, Svaj::default(), taste))
}

/// The demands in order: those with a length or at θ = 0, and the points between them.
fn sorted(demands: &[Demand]) -> Result<(Vec<Anchor>, Vec<Anchor>), JoinError> {
    let refuse = |demand, problem| Err(JoinError { demand, problem });
    if demands.is_empty() {
        return refuse(0, JoinProblem::Nothing);
    }
    if demands.len() > MAX_SEGMENTS / 2 {
        return refuse(MAX_SEGMENTS / 2, JoinProblem::TooMany);
    }
    let mut all: Vec<Anchor> = demands.iter().enumerate().map(|(k, demand)| placed(k, demand)).collect();
    let scale = all.iter().map(|anchor| anchor.start.s.max(anchor.end.s)).fold(0.0, f64::max);
    for anchor in &all {
        let Anchor { demand, from, to, start, end, side, .. } = *anchor;
        let finite = [from, to, start.s, end.s, start.v].iter().all(|value| value.is_finite());
        let wide = side == Side::Instant || to - from >= MIN_BETA;
        if !finite || !wide || from < 0.0 || to > TAU + MIN_BETA {
            return refuse(demand, JoinProblem::Place);
        }
        let grounded = |motion: Svaj| motion.s <= SAME * scale && motion.v.abs() > SAME * scale;
        if start.s < 0.0 || end.s < 0.0 || grounded(start) || grounded(end) {
            return refuse(demand, JoinProblem::Low);
        }
    }
    all.sort_by(|one, other| one.from.total_cmp(&other.from));
    if all[0].from > MIN_BETA {
        all.insert(
            0,
            Anchor { demand: all[0].demand, ..placed(0, &Demand::Pass { at: 0.0, height: 0.0, velocity: None }) },
        );
    }
    all[0].from = 0.0;
    if all[0].start.s > SAME * scale {
        return refuse(all[0].demand, JoinProblem::StartsHigh);
    }
    for pair in all.windows(2) {
        let [before, after] = [pair[0], pair[1]];
        let twice = before.side == Side::Instant && after.side == Side::Instant && after.from - before.to < MIN_BETA;
        if after.from < before.to - MIN_BETA || twice {
            return refuse(after.demand, JoinProblem::Overlap { other: before.demand });
        }
        meets(before, after, after.from - before.to, scale)?;
    }
    let (first, last) = (all[0], all[all.len() - 1]);
    if all.len() > 1 || first.side != Side::Instant {
        meets(last, Anchor { from: TAU, ..first }, TAU - last.to, scale)?;
    }
    if scale == 0.0 {
        return refuse(0, JoinProblem::Nothing);
    }
    Ok(all.into_iter().partition(|anchor| anchor.side != Side::Instant || anchor.from == 0.0))
}

/// Refuses demands that touch and do not agree.
fn meets(before: Anchor, after: Anchor, gap: f64, scale: f64) -> Result<(), JoinError> {
    let [one, other] = [before.end, after.start];
    let free = one.v == FREE || other.v == FREE;
    let agree = (one.s - other.s).abs() <= SAME * scale && (free || (one.v - other.v).abs() <= SAME * scale);
    if gap < MIN_BETA && !agree {
        return Err(JoinError { demand: after.demand, problem: JoinProblem::Clash { other: before.demand } });
    }
    Ok(())
}

fn placed(demand: usize, what: &Demand) -> Anchor {
    let at = |s: f64, v: f64| Svaj::new(s, v, 0.0, 0.0);
    match *what {
        Demand::Dwell { from, to, height } => {
            Anchor { demand, from, to, start: at(height, 0.0), end: at(height, 0.0), side: Side::Rest, lasts: true }
        }
        Demand::Straight { from, to, start, end } => {
            let slope = (end - start) / (to - from);
            let side = if start == end { Side::Rest } else { Side::Line };
            Anchor { demand, from, to, start: at(start, slope), end: at(end, slope), side, lasts: true }
        }
        // Where no velocity is asked for, NaN stands for what is free; on the base circle there is only one.
        Demand::Pass { at: place, height, velocity } => {
            let v = velocity.unwrap_or(if height == 0.0 { 0.0 } else { FREE });
            let v = if v.is_nan() { FREE } else { v };
            Anchor {
                demand,
                from: place,
                to: place,
                start: at(height, v),
                end: at(height, v),
                side: Side::Instant,
                lasts: false,
            }
        }
    }
}

/// A velocity that is not asked for: it is told apart by being larger than any that could be.
const FREE: f64 = f64::MAX;

/// *a* and *j* at θ = 0, when the follower only touches the base circle there: those of the polynomial through what is on both sides.
fn instant(anchors: &[Anchor], passes: &[Anchor]) -> Svaj {
    let first = anchors[0];
    if first.side != Side::Instant {
        return Svaj::default();
    }
    let all = || anchors[1..].iter().chain(passes);
    let (Some(next), Some(last)) = (
        all().min_by(|one, other| one.from.total_cmp(&other.from)),
        all().max_by(|one, other| one.to.total_cmp(&other.to)),
    ) else {
        return Svaj::default();
    };
    let back = TAU - last.to;
    // What ends on the base circle at the end of the turn rests there.
    if back < MIN_BETA {
        return Svaj::default();
    }
    let span = back + next.from;
    let ends = [(0.0, last.end, last.side), (span, next.start, next.side)];
    let mut conditions = vec![condition(back, 0, 0.0), condition(back, 1, 0.0)];
    for (at, motion, side) in ends {
        conditions.extend(known(at, motion, if side == Side::Instant { 2 } else { 3 }));
    }
    let Some(law) = Law::by_id("polynomial") else { return Svaj::default() };
    let Some(leg) = free(law, span, conditions) else { return Svaj::default() };
    let there = motion(&leg, back / span);
    // On the base circle the follower cannot but turn upwards.
    if there.a <= 0.0 { Svaj::default() } else { Svaj::new(0.0, 0.0, chosen(there.a), chosen(there.j)) }
}

fn chosen(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let unit = 10_f64.powi(value.abs().log10().floor() as i32 + 1 - CHOSEN_DIGITS);
    (value / unit).round() * unit
}

fn joined(anchors: &[Anchor], passes: &[Anchor], bend: Svaj, taste: Taste) -> Result<Joining, JoinError> {
    let mut anchors = anchors.to_vec();
    if anchors[0].side == Side::Instant {
        let jerk = if taste.high_speed { bend.j } else { 0.0 };
        let state = Svaj::new(0.0, 0.0, bend.a, jerk);
        (anchors[0].start, anchors[0].end) = (state, state);
        // Without a bend it is a rest, if only for an instant.
        if state == Svaj::default() {
            anchors[0].side = Side::Rest;
        }
    }
    let mut joining = Joining { segments: Vec::new(), choices: Vec::new() };
    for (k, &before) in anchors.iter().enumerate() {
        let round = k + 1 == anchors.len();
        let after = if round { Anchor { from: TAU, ..anchors[0] } } else { anchors[k + 1] };
        if before.side != Side::Instant && before.to > before.from {
            let law = if before.side == Side::Rest { "dwell" } else { "constant-velocity" };
            let law = Law::by_id(law).unwrap_or(LAWS[0]);
            let beta = before.to.min(TAU) - before.from;
            joining.segments.push(Segment::new(law, beta, before.end.s - before.start.s));
        }
        if after.from - before.to < MIN_BETA {
            continue;
        }
        let between: Vec<Anchor> =
            passes.iter().filter(|pass| pass.from > before.to && pass.from < after.from).copied().collect();
        let (reason, tried, legs) = fill(before, &between, after, taste)
            .ok_or(JoinError { demand: before.demand, problem: JoinProblem::NoWay })?;
        let segment = joining.segments.len();
        joining.choices.push(Choice { from: before.to, to: after.from, segment, reason, tried });
        joining.segments.extend(legs.into_iter().map(|leg| leg.segment));
    }
    let checked = Program::new(&joining.segments);
    let orders = if taste.high_speed { 4 } else { 3 };
    let smooth = |program: &Program| {
        program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| usize::from(order) >= orders))
    };
    match checked {
        Ok(program) if smooth(&program) => Ok(joining),
        _ => Err(JoinError { demand: anchors[0].demand, problem: JoinProblem::NoWay }),
    }
}

/// The best way through a gap.
fn fill(before: Anchor, passes: &[Anchor], after: Anchor, taste: Taste) -> Option<(Reason, Vec<Tried>, Vec<Leg>)> {
    let plain = passes.is_empty() && before.side != Side::Instant && after.side != Side::Instant;
    let (start, end, beta) = (before.end, after.start, after.from - before.to);
    let rise = end.s - start.s;
    let alone = |id: &str, reason: Reason| {
        let law = Law::by_id(id)?;
        Some((reason, Vec::new(), vec![Leg { segment: Segment::new(law, beta, rise), pieces: Vec::new() }]))
    };
    let near = |one: f64, other: f64| (one - other).abs() <= SAME * (start.s.abs() + end.s.abs());
    if plain && before.side == Side::Rest && after.side == Side::Rest && near(rise, 0.0) {
        return alone("dwell", Reason::Stays).map(|(reason, tried, mut legs)| {
            legs[0].segment.rise = 0.0;
            (reason, tried, legs)
        });
    }
    if plain && before.side == Side::Line && near(start.v, end.v) && near(start.v * beta, rise) {
        return alone("constant-velocity", Reason::InLine);
    }
    let candidates = if plain { plain_ways(before, after, taste) } else { ways(before, passes, after, taste) };
    let mut judged: Vec<(Tried, Vec<Leg>)> = candidates
        .into_iter()
        .map(|Candidate { way, legs }| {
            let (peaks, lowest) = figures(&legs);
            (Tried { way, peaks, above: lowest >= -CLOSING_TOLERANCE }, legs)
        })
        .collect();
    let worth = |tried: &Tried| (!tried.above, tried.peaks[taste.least - 1]);
    judged.sort_by(|(one, _), (other, _)| {
        let ((below, peak), (other_below, other_peak)) = (worth(one), worth(other));
        below.cmp(&other_below).then(peak.total_cmp(&other_peak))
    });
    let tried: Vec<Tried> = judged.iter().map(|(tried, _)| *tried).collect();
    let (_, legs) = judged.into_iter().next().filter(|(best, _)| best.above)?;
    let reason = if tried.len() == 1 { Reason::Only } else { Reason::Least };
    Some((reason, tried, legs))
}

/// Ways between two stretches, with nothing to pass.
fn plain_ways(before: Anchor, after: Anchor, taste: Taste) -> Vec<Candidate> {
    let (start, end, beta) = (before.end, after.start, after.from - before.to);
    let orders = if taste.high_speed { 4 } else { 3 };
    let one = |law: &'static Law, leg: Leg| Candidate { way: Way::Law(law), legs: vec![leg] };
    let mut ways: Vec<Candidate> = Vec::new();
    if before.side == Side::Rest && after.side == Side::Rest {
        let standard = LAWS.iter().filter(|law| law.group == Group::Standard && law.parameters.is_empty());
        ways.extend(standard.filter_map(|law| Some(one(law, standing(law, beta, start, end, orders)?))));
        return ways;
    }
    let half = LAWS.iter().filter(|law| law.group == Group::Half);
    ways.extend(half.filter_map(|law| Some(one(law, standing(law, beta, start, end, orders)?))));
    // What meets the jerk of its neighbours needs one that is known: that of a stretch, or one that is asked for.
    let jerk_is_known = before.lasts && after.lasts;
    for (id, meets) in [("polynomial-5", 3), ("polynomial-7", 4)] {
        let Some(law) = Law::by_id(id).filter(|_| meets == orders || meets > orders && jerk_is_known) else { continue };
        ways.push(one(law, matched(law, meets, beta, start, end)));
        // From a rest to a line that is steep for so small a rise: it is enough to set out later, and the same the other way round.
        let rise = end.s - start.s;
        let fastest = if before.side == Side::Rest { end.v } else { start.v };
        let needed = 2.0 * rise / fastest;
        if (before.side == Side::Rest) != (after.side == Side::Rest) && needed > MIN_BETA && needed < beta - MIN_BETA {
            let mut legs = vec![matched(law, meets, needed, start, end)];
            let height = if before.side == Side::Rest { start.s } else { end.s };
            legs.insert(if before.side == Side::Rest { 0 } else { 1 }, still(beta - needed, height));
            ways.push(Candidate { way: Way::Waiting(law), legs });
        }
    }
    ways
}

/// Ways through points, or from an instant on the base circle.
fn ways(before: Anchor, passes: &[Anchor], after: Anchor, taste: Taste) -> Vec<Candidate> {
    let (start, end, beta) = (before.end, after.start, after.from - before.to);
    let orders = if taste.high_speed { 4 } else { 3 };
    let mut conditions = known(0.0, start, orders);
    for pass in passes {
        conditions.extend(known(pass.from - before.to, pass.start, 2));
    }
    conditions.extend(known(beta, end, orders));
    let mut ways: Vec<Candidate> = Vec::new();
    for id in ["polynomial", "bspline"] {
        let Some(law) = Law::by_id(id) else { continue };
        // With no more conditions than its degree needs a spline is the polynomial itself.
        let spline = id == "bspline";
        if spline && conditions.len() <= law.default_parameters()[0] as usize + 1 {
            continue;
        }
        if let Some(leg) = free(law, beta, conditions.clone()) {
            ways.push(Candidate { way: Way::Law(law), legs: vec![leg] });
        }
    }
    if passes.is_empty() {
        return ways;
    }
    let nodes: Vec<(f64, Svaj)> = std::iter::once((0.0, start))
        .chain(passes.iter().map(|pass| (pass.from - before.to, pass.start)))
        .chain([(beta, end)])
        .collect();
    for (way, stops) in [(Way::Pieces, false), (Way::Stops, true)] {
        let state = |k: usize| {
            let (_, motion) = nodes[k];
            if motion.v != FREE {
                return motion;
            }
            Svaj { v: if stops { 0.0 } else { chosen(gentle(nodes[k - 1], nodes[k], nodes[k + 1])) }, ..motion }
        };
        let Some(law) = Law::by_id("polynomial") else { continue };
        let legs: Option<Vec<Leg>> = (1..nodes.len())
            .map(|k| {
                let (from, to) = (nodes[k - 1].0, nodes[k].0);
                let ends = [known(0.0, state(k - 1), orders), known(to - from, state(k), orders)];
                free(law, to - from, ends.concat())
            })
            .collect();
        ways.extend(legs.map(|legs| Candidate { way, legs }));
    }
    ways
}

/// A velocity between two chords that does not make the curve turn back (Fritsch and Carlson): their harmonic mean, none at a summit.
fn gentle(before: (f64, Svaj), here: (f64, Svaj), after: (f64, Svaj)) -> f64 {
    let chord = |one: (f64, Svaj), other: (f64, Svaj)| (other.1.s - one.1.s) / (other.0 - one.0);
    let (one, other) = (chord(before, here), chord(here, after));
    if one * other <= 0.0 { 0.0 } else { 2.0 * one * other / (one + other) }
}

fn condition(at: f64, order: u8, value: f64) -> Condition {
    Condition { at, order, value }
}

/// What is known of a motion at a place, up to an order; a velocity that is free ends the list.
fn known(at: f64, motion: Svaj, orders: usize) -> Vec<Condition> {
    let orders = if motion.v == FREE { 1 } else { orders };
    (0..orders).map(|order| condition(at, order as u8, motion.order(order))).collect()
}

/// A law over a gap, when it starts and ends as the sides do and joins smoothly within.
fn standing(law: &'static Law, beta: f64, start: Svaj, end: Svaj, orders: usize) -> Option<Leg> {
    let rise = end.s - start.s;
    let segment = Segment::new(law, beta, rise);
    let arguments = Arguments { parameters: segment.parameters, falling: rise < 0.0, beta };
    let pieces: Vec<Piece> = law
        .unit(arguments)
        .ok()?
        .into_iter()
        .map(|piece| Piece { curve: piece.curve.scaled(rise, start.s), ..piece })
        .collect();
    let agree = |one: Svaj, other: Svaj| {
        (1..orders).all(|order| {
            let (one, other) = (one.order(order), other.order(order) * beta.powi(order as i32));
            (one - other).abs() <= SAME * (rise.abs() + end.s.abs()) * 10_f64.powi(order as i32)
        })
    };
    let inner = pieces.windows(2).all(|pair| {
        let (one, other) = (pair[0].at(pair[0].until), pair[1].at(pair[0].until));
        (1..orders)
            .all(|order| (one.order(order) - other.order(order)).abs() <= SAME * rise.abs() * 10_f64.powi(order as i32))
    });
    let ends = agree(pieces.first()?.at(0.0), start) && agree(pieces.last()?.at(1.0), end);
    (inner && ends).then_some(Leg { segment, pieces })
}

fn matched(law: &'static Law, orders: usize, beta: f64, start: Svaj, end: Svaj) -> Leg {
    let in_x = |motion: Svaj| Svaj { s: motion.s, ..motion.stretched(1.0 / beta) };
    let curve = matched_polynomial(orders, in_x(start), in_x(end));
    Leg { segment: Segment::new(law, beta, end.s - start.s), pieces: vec![Piece::new(1.0, curve)] }
}

fn still(beta: f64, height: f64) -> Leg {
    let law = Law::by_id("dwell").unwrap_or(LAWS[0]);
    let pieces = vec![Piece::new(1.0, crate::Curve::polynomial(&[height]))];
    Leg { segment: Segment::new(law, beta, 0.0), pieces }
}

/// A segment of a free law through conditions, when there is one that can be trusted.
fn free(law: &'static Law, beta: f64, conditions: Vec<Condition>) -> Option<Leg> {
    let mut segment = Segment::new(law, beta, 0.0);
    segment.data = Data::Conditions(conditions);
    let given = Given { data: &segment.data, beta, parameters: segment.parameters, ..Given::default() };
    let solved = (law.free()?.solve)(&given).ok()?;
    (solved.condition < crate::program::LEAST_TRUSTED).then_some(Leg { segment, pieces: solved.pieces })
}

fn motion(leg: &Leg, x: f64) -> Svaj {
    let piece = leg.pieces.iter().find(|piece| x < piece.until).or(leg.pieces.last());
    piece.map_or_else(Svaj::default, |piece| piece.at(x)).stretched(leg.segment.beta)
}

/// Places at which a piece is looked at.
const LOOKS: usize = 64;

/// Peaks of |v|, |a| and |j| over legs, and the lowest height.
fn figures(legs: &[Leg]) -> ([f64; 3], f64) {
    let mut peaks = [0.0_f64; 3];
    let mut lowest = f64::INFINITY;
    for leg in legs {
        let mut from = 0.0;
        for piece in &leg.pieces {
            let motion = |x: f64| piece.at(x).stretched(leg.segment.beta);
            let step = (piece.until - from) / LOOKS as f64;
            let looks: Vec<Svaj> = (0..=LOOKS).map(|i| motion(from + step * i as f64)).collect();
            for (order, peak) in (1..).zip(&mut peaks) {
                let size = |i: usize| looks[i].order(order).abs();
                let best = (0..=LOOKS).max_by(|&i, &k| size(i).total_cmp(&size(k))).unwrap_or(0);
                // The peak is that of the parabola through the greatest and its neighbours.
                let top = if (1..LOOKS).contains(&best) {
                    let (left, here, right) = (size(best - 1), size(best), size(best + 1));
                    let bend = left - 2.0 * here + right;
                    if bend < 0.0 { here - (right - left).powi(2) / (8.0 * bend) } else { here }
                } else {
                    size(best)
                };
                *peak = peak.max(top);
            }
            lowest = lowest.min(bottom(from, piece.until, motion));
            from = piece.until;
        }
    }
    (peaks, lowest)
}

/// The lowest height between two places: at a look, or in a valley between two, where the velocity changes its sign.
///
/// Towards both ends the looks halve their distance from it: what comes to rest on the base circle may do so from below, in a valley as
/// shallow as the third power of its length.
fn bottom(from: f64, until: f64, motion: impl Fn(f64) -> Svaj) -> f64 {
    const HALVINGS: i32 = 20;
    let step = (until - from) / LOOKS as f64;
    let near = (1..=HALVINGS).map(|k| step * 0.5_f64.powi(k));
    let evenly = (1..LOOKS).map(|i| from + step * i as f64);
    let places = near.clone().rev().map(|apart| from + apart).chain(evenly).chain(near.map(|apart| until - apart));
    let looks: Vec<(f64, Svaj)> = std::iter::once(from).chain(places).chain([until]).map(|x| (x, motion(x))).collect();
    let valleys = looks.windows(2).filter(|pair| pair[0].1.v < 0.0 && pair[1].1.v > 0.0);
    let valleys = valleys.map(|pair| motion(root(pair[0].0, pair[1].0, |x| motion(x).v)).s);
    looks.iter().map(|look| look.1.s).chain(valleys).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const LOW: Taste = Taste { high_speed: false, least: 2 };
    const HIGH: Taste = Taste { high_speed: true, least: 2 };

    fn dwell(from: f64, to: f64, height: f64) -> Demand {
        Demand::Dwell { from: from.to_radians(), to: to.to_radians(), height }
    }

    fn straight(from: f64, to: f64, start: f64, end: f64) -> Demand {
        Demand::Straight { from: from.to_radians(), to: to.to_radians(), start, end }
    }

    fn pass(at: f64, height: f64) -> Demand {
        Demand::Pass { at: at.to_radians(), height, velocity: None }
    }

    fn laws(joining: &Joining) -> Vec<&'static str> {
        joining.segments.iter().map(|segment| segment.law.id).collect()
    }

    #[test]
    fn between_rests_it_takes_the_standard_law_with_the_lowest_peak() {
        let demands = [dwell(0.0, 60.0, 0.0), dwell(180.0, 220.0, 10.0)];
        for (taste, law) in [
            (LOW, "modified-trapezoidal"),
            (Taste { least: 1, ..LOW }, "modified-sine"),
            (Taste { least: 3, ..LOW }, "cycloidal"),
            (HIGH, "polynomial-4-5-6-7"),
        ] {
            let joining = join(&demands, taste).expect("joined");
            assert_eq!(laws(&joining), ["dwell", law, "dwell", law], "{taste:?}");
            assert_eq!(joining.choices[0].tried[0].way, Way::Law(Law::by_id(law).expect(law)));
        }
        // Peaks are those of the handbooks: 4.8881·L/β² for the modified trapezoidal.
        let joining = join(&demands, LOW).expect("joined");
        let expected = 4.8881 * 10.0 / 120_f64.to_radians().powi(2);
        assert!((joining.choices[0].tried[0].peaks[1] / expected - 1.0).abs() < 1e-4);
        assert_eq!(join(&demands, HIGH).expect("joined").choices[0].reason, Reason::Only);
    }

    #[test]
    fn beside_a_straight_stretch_an_exact_half_or_a_polynomial_stands() {
        // 2·L/β of the half cycloidal is the slope of the line: 3/40·2 = 6/40.
        let demands = [dwell(0.0, 40.0, 0.0), straight(80.0, 120.0, 3.0, 9.0), dwell(160.0, 240.0, 12.0)];
        let joining = join(&demands, Taste { least: 3, ..LOW }).expect("joined");
        let tried = &joining.choices[0].tried;
        let half = Law::by_id("half-cycloidal-start").expect("half");
        assert!(tried.iter().any(|tried| tried.way == Way::Law(half)), "{tried:?}");
        assert_eq!(laws(&join(&demands, HIGH).expect("joined"))[1], "polynomial-7");
        // Too steep a line for so small a rise: the follower sets out later.
        let steep = [dwell(0.0, 40.0, 0.0), straight(120.0, 160.0, 1.0, 21.0), dwell(240.0, 260.0, 30.0)];
        let joining = join(&steep, LOW).expect("joined");
        assert!(matches!(joining.choices[0].tried[0].way, Way::Waiting(_)), "{:?}", joining.choices[0]);
        assert!(joining.choices[0].tried.iter().any(|tried| !tried.above), "what dips is told");
    }

    #[test]
    fn what_needs_no_joining_is_held_or_goes_straight_on() {
        let demands = [
            dwell(0.0, 30.0, 0.0),
            dwell(60.0, 90.0, 0.0),
            straight(120.0, 150.0, 3.0, 6.0),
            straight(180.0, 210.0, 9.0, 12.0),
        ];
        let joining = join(&demands, LOW).expect("joined");
        let reasons: Vec<Reason> = joining.choices.iter().map(|choice| choice.reason).collect();
        assert_eq!((reasons[0], reasons[2]), (Reason::Stays, Reason::InLine));
    }

    #[test]
    fn points_are_passed() {
        let demands =
            [dwell(0.0, 30.0, 0.0), pass(70.0, 4.0), pass(110.0, 3.0), pass(150.0, 9.0), dwell(200.0, 220.0, 10.0)];
        for taste in [LOW, HIGH] {
            let joining = join(&demands, taste).expect("joined");
            let program = Program::new(&joining.segments).expect("a program");
            for (at, height) in [(70.0, 4.0), (110.0, 3.0), (150.0, 9.0)] {
                assert!((program.at(f64::to_radians(at)).s - height).abs() < 1e-9, "at {at}");
            }
        }
        // A dwell that ends with the turn is a rest at its beginning.
        let joining = join(&[dwell(50.0, 90.0, 10.0), dwell(320.0, 360.0, 0.0)], LOW).expect("joined");
        assert_eq!(laws(&joining)[0], "modified-trapezoidal");
        // Nothing but points: the turn begins on the base circle, and bends there.
        let joining = join(&[pass(90.0, 6.0), pass(180.0, 10.0), pass(270.0, 6.0)], LOW).expect("joined");
        let program = Program::new(&joining.segments).expect("a program");
        assert!(program.at(0.0).a > 0.0 && program.at(0.0).v.abs() < 1e-9);
        assert!(program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| order == 3)));
    }

    #[test]
    fn a_valley_between_two_looks_is_seen() {
        // The polynomial through these points goes below the base circle for 3° of 290°.
        let demands = [
            pass(40.5, 7.98),
            pass(102.2, 5.29),
            pass(154.0, 9.71),
            pass(228.7, 0.8),
            dwell(290.1, 305.6, 17.28),
            dwell(324.2, 333.6, 0.0),
        ];
        let joining = join(&demands, Taste { high_speed: true, least: 1 }).expect("joined");
        let whole =
            joining.choices[0].tried.iter().find(|tried| matches!(tried.way, Way::Law(law) if law.id == "polynomial"));
        assert!(!whole.expect("tried").above);
        let program = Program::new(&joining.segments).expect("a program");
        assert!((0..=3600).all(|i| program.at(TAU * f64::from(i) / 3600.0).s > -1e-9));
    }

    #[test]
    fn what_only_touches_the_base_circle_lends_no_jerk() {
        // At θ = 0 the follower rests for an instant, and the polynomial before it leaves with a jerk that nobody asked for.
        let demands = [
            straight(32.7, 46.1, 8.72, 16.69),
            dwell(64.4, 75.2, 0.5),
            dwell(110.1, 145.8, 0.5),
            dwell(197.1, 229.9, 0.5),
            pass(279.3, 20.2),
        ];
        let joining = join(&demands, Taste { least: 1, ..LOW }).expect("joined");
        assert_eq!(laws(&joining)[0], "polynomial-5");
        let program = Program::new(&joining.segments).expect("a program");
        assert!((0..=3600).all(|i| program.at(TAU * f64::from(i) / 3600.0).s > -1e-9));
    }

    #[test]
    fn what_cannot_be_joined_is_blamed() {
        let problem = |demands: &[Demand]| join(demands, LOW).expect_err("refused");
        assert_eq!(problem(&[]).problem, JoinProblem::Nothing);
        assert_eq!(problem(&[dwell(0.0, 90.0, 0.0)]).problem, JoinProblem::Nothing);
        assert_eq!(problem(&[dwell(90.0, 60.0, 1.0)]), JoinError { demand: 0, problem: JoinProblem::Place });
        assert_eq!(problem(&[pass(370.0, 1.0)]).problem, JoinProblem::Place);
        let clash = [dwell(0.0, 60.0, 0.0), straight(60.0, 90.0, 0.0, 9.0)];
        assert!(matches!(problem(&clash).problem, JoinProblem::Low | JoinProblem::Clash { .. }));
        assert_eq!(
            problem(&[dwell(0.0, 60.0, 0.0), dwell(50.0, 90.0, 3.0)]),
            JoinError { demand: 1, problem: JoinProblem::Overlap { other: 0 } }
        );
        assert_eq!(problem(&[pass(90.0, 6.0), dwell(90.0, 120.0, 7.0)]).problem, JoinProblem::Clash { other: 0 });
        assert_eq!(problem(&[pass(90.0, -1.0)]).problem, JoinProblem::Low);
        assert_eq!(problem(&[dwell(0.0, 60.0, 3.0), pass(90.0, 6.0)]).problem, JoinProblem::StartsHigh);
        assert_eq!(problem(&[pass(90.0, f64::NAN)]).problem, JoinProblem::Place);
    }

    /// Dwells and points in order over the turn, with room between them, and sometimes a straight stretch.
    fn demands() -> impl Strategy<Value = Vec<Demand>> {
        let one = (0..6_u8, 0.3..1.0_f64, 0.0..20.0_f64, -8.0..8.0_f64);
        prop::collection::vec(one, 1..9).prop_map(|parts| {
            let whole: f64 = parts.iter().map(|part| part.1).sum::<f64>() + 0.5;
            let mut theta = 0.25 / whole * TAU;
            let mut demands = Vec::new();
            for (kind, share, height, rise) in parts {
                let width = share / whole * TAU;
                let (from, to) = (theta + 0.3 * width, theta + 0.7 * width);
                theta += width;
                let height = height + 0.5;
                demands.push(match kind {
                    0 | 1 => Demand::Dwell { from, to, height },
                    2 => Demand::Dwell { from, to, height: 0.0 },
                    3 => Demand::Straight { from, to, start: height + 8.0, end: height + 8.0 + rise },
                    _ => Demand::Pass { at: from, height, velocity: None },
                });
            }
            demands
        })
    }

    #[test]
    fn what_comes_to_rest_on_the_base_circle_does_not_dip_below_it_just_before() {
        let pass = |at: f64, height: f64| Demand::Pass { at, height, velocity: None };
        let demands = [
            Demand::Dwell { from: 0.910_976, to: 1.533_935, height: 3.241_599 },
            pass(2.400_118, 9.009_884),
            pass(3.653_503, 5.501_535),
            Demand::Dwell { from: 4.835_977, to: 5.409_378, height: 0.0 },
        ];
        let program = Program::new(&join(&demands, LOW).expect("joined").segments).expect("a program");
        let lowest = (0..200_000).map(|i| program.at(TAU * f64::from(i) / 200_000.0).s).fold(f64::INFINITY, f64::min);
        assert!(lowest > -1e-9, "down to {lowest}");
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn whatever_is_demanded_is_met_and_smooth(demands in demands(), high_speed: bool, least in 1..4_usize) {
            let straight = demands.iter().any(|demand| matches!(demand, Demand::Straight { .. }));
            let moves = demands.iter().any(|demand| !matches!(demand, Demand::Dwell { height: 0.0, .. }));
            let joining = match join(&demands, Taste { high_speed, least }) {
                Ok(joining) => joining,
                Err(error) => {
                    // A line may come down so steeply that nothing catches it above the base circle.
                    let excused = if moves { straight && error.problem == JoinProblem::NoWay } else { error.problem == JoinProblem::Nothing };
                    prop_assert!(excused, "{error:?}");
                    return Ok(());
                }
            };
            let program = Program::new(&joining.segments).expect("a program");
            let first = if high_speed { 4 } else { 3 };
            prop_assert!(program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| order >= first)));
            let close = |one: f64, other: f64| (one - other).abs() < 1e-7;
            for demand in &demands {
                match *demand {
                    Demand::Dwell { from, to, height } => {
                        let middle = program.at((from + to) / 2.0);
                        prop_assert!(close(middle.s, height) && close(middle.v, 0.0), "{demand:?}: {middle:?}");
                    }
                    Demand::Straight { from, to, start, end } => {
                        let middle = program.at((from + to) / 2.0);
                        let slope = (end - start) / (to - from);
                        prop_assert!(close(middle.s, (start + end) / 2.0) && close(middle.v, slope), "{demand:?}: {middle:?}");
                    }
                    Demand::Pass { at, height, .. } => prop_assert!(close(program.at(at).s, height), "{demand:?}"),
                }
            }
            let lowest = (0..=2000).map(|i| program.at(TAU * f64::from(i) / 2000.0).s).fold(f64::INFINITY, f64::min);
            prop_assert!(lowest > -1e-6, "down to {lowest}");
        }
    }
}
