//! What a gap may be joined by, and the best of it.

use super::demand::{Anchor, FREE, SAME, Side};
use super::figures::figures;
use super::leg::{Leg, free, known, matched, standing, still};
use super::origin::chosen;
use super::{Reason, Taste, Tried, Way};
use crate::law::Group;
use crate::program::MIN_BETA;
use crate::{CLOSING_TOLERANCE, LAWS, Law, Segment, Svaj};

struct Candidate {
    way: Way,
    legs: Vec<Leg>,
}

/// The best way through a gap.
pub(super) fn fill(
    before: Anchor,
    passes: &[Anchor],
    after: Anchor,
    taste: Taste,
) -> Option<(Reason, Vec<Tried>, Vec<Leg>)> {
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
