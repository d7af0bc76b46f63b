//! A segment of a law between two states of the follower.

use super::demand::{FREE, SAME};
use crate::law::{Arguments, Condition, Data, Given, Piece, matched_polynomial};
use crate::program::LEAST_TRUSTED;
use crate::{Curve, LAWS, Law, Segment, Svaj};

/// A segment with its curve over x ∈ [0, 1], in absolute heights.
pub(super) struct Leg {
    pub segment: Segment,
    pub pieces: Vec<Piece>,
}

pub(super) fn condition(at: f64, order: u8, value: f64) -> Condition {
    Condition { at, order, value }
}

/// What is known of a motion at a place, up to an order; a velocity that is free ends the list.
pub(super) fn known(at: f64, motion: Svaj, orders: usize) -> Vec<Condition> {
    let orders = if motion.v == FREE { 1 } else { orders };
    (0..orders).map(|order| condition(at, order as u8, motion.order(order))).collect()
}

/// A law over a gap, when it starts and ends as the sides do and joins smoothly within.
pub(super) fn standing(law: &'static Law, beta: f64, start: Svaj, end: Svaj, orders: usize) -> Option<Leg> {
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

pub(super) fn matched(law: &'static Law, orders: usize, beta: f64, start: Svaj, end: Svaj) -> Leg {
    let in_x = |motion: Svaj| Svaj { s: motion.s, ..motion.stretched(1.0 / beta) };
    let curve = matched_polynomial(orders, in_x(start), in_x(end));
    Leg { segment: Segment::new(law, beta, end.s - start.s), pieces: vec![Piece::new(1.0, curve)] }
}

pub(super) fn still(beta: f64, height: f64) -> Leg {
    let law = Law::by_id("dwell").unwrap_or(LAWS[0]);
    let pieces = vec![Piece::new(1.0, Curve::polynomial(&[height]))];
    Leg { segment: Segment::new(law, beta, 0.0), pieces }
}

/// A segment of a free law through conditions, when there is one that can be trusted.
pub(super) fn free(law: &'static Law, beta: f64, conditions: Vec<Condition>) -> Option<Leg> {
    let mut segment = Segment::new(law, beta, 0.0);
    segment.data = Data::Conditions(conditions);
    let given = Given { data: &segment.data, beta, parameters: segment.parameters, ..Given::default() };
    let solved = (law.free()?.solve)(&given).ok()?;
    (solved.condition < LEAST_TRUSTED).then_some(Leg { segment, pieces: solved.pieces })
}

pub(super) fn motion(leg: &Leg, x: f64) -> Svaj {
    let piece = leg.pieces.iter().find(|piece| x < piece.until).or(leg.pieces.last());
    piece.map_or_else(Svaj::default, |piece| piece.at(x)).stretched(leg.segment.beta)
}
