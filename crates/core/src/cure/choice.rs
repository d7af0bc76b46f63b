//! The choice of as few changes of laws as possible with which a program should be smooth, found along the cycle in linear time.

use crate::law::Shape;
use crate::program::ends;
use crate::{Cycle, Law, Program, Segment, Svaj};

/// Limits that differ by less than this part of the largest of their order should be continuous. It only proposes: every choice is
/// tried on the program that it gives.
const NEAR: f64 = 1e-9;

/// What becomes of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SegmentOption {
    /// It stays as it is.
    Keep,
    /// It takes a polynomial that matches its neighbours.
    Match,
    /// It takes the law of a fixed curve.
    Replace,
}

/// Every option, the cheapest first, with its cost: a segment changed counts most, and a polynomial that matches is preferred.
const OPTIONS: [(SegmentOption, u32); 3] =
    [(SegmentOption::Keep, 0), (SegmentOption::Match, 1000), (SegmentOption::Replace, 1001)];

/// How a segment meets its neighbours under an option.
#[derive(Clone, Copy, Debug)]
enum Meeting {
    /// The option is not open to it.
    Never,
    /// With limits of its own at both ends, and the lowest order that jumps within it.
    Fixed([Svaj; 2], Option<u8>),
    /// With the limits of its neighbours, in so many orders.
    Matched(usize),
}

/// How every segment meets its neighbours under each option.
pub(super) struct Joining {
    each: Vec<[Meeting; 3]>,
    cycle: Cycle,
    scales: [f64; 4],
}

impl Joining {
    /// The meetings of a program as it is; `kept` segments may not be changed.
    pub fn of(program: &Program, kept: &[bool]) -> Self {
        let mut each: Vec<[Meeting; 3]> = Vec::with_capacity(kept.len());
        let (mut inner, mut limits) = (vec![None::<u8>; kept.len()], vec![None::<[Svaj; 2]>; kept.len()]);
        for joint in program.classified_joints() {
            let k = joint.segment;
            let is_inner =
                k < kept.len() && joint.theta > program.borders()[k] && joint.theta < program.borders()[k + 1];
            if let Some(jump) = joint.jump.filter(|_| is_inner) {
                inner[k] = Some(inner[k].map_or(jump, |lowest| lowest.min(jump)));
            }
        }
        for stretch in program.stretches().iter().filter(|stretch| stretch.segment < kept.len()) {
            let (first, last) = (stretch.at(stretch.from), stretch.at(stretch.to));
            let known = limits[stretch.segment].map_or(first, |[first, _]| first);
            limits[stretch.segment] = Some([known, last]);
        }
        for (k, segment) in program.given().iter().enumerate() {
            let now = match (segment.law.shape, limits[k]) {
                (Shape::Matched(orders), _) => Meeting::Matched(orders),
                (_, Some(limits)) => Meeting::Fixed(limits, inner[k]),
                _ => Meeting::Never,
            };
            let open = if kept[k] { Meeting::Never } else { Meeting::Matched(0) };
            each.push([now, open, open]);
        }
        Self { each, cycle: program.cycle(), scales: program.sizes() }
    }

    /// True when a joint between two segments that cannot change jumps in an order up to the given one, whatever becomes of the others.
    pub fn is_refuted(&self, order: u8) -> bool {
        let fixed = |each: &[Meeting; 3]| matches!(each, [Meeting::Fixed(..), Meeting::Never, Meeting::Never]);
        let stays = |k: usize| fixed(&self.each[k]);
        let n = self.each.len();
        let inner = |each: &[Meeting; 3]| matches!(each[0], Meeting::Fixed(_, Some(jump)) if jump <= order);
        (0..n).any(|k| stays(k) && inner(&self.each[k]))
            || self.joints().any(|(k, next)| {
                stays(k) && stays(next) && !self.meets(k, self.each[k][0], next, self.each[next][0], order)
            })
    }

    /// The same with what the two options of a change stand for.
    pub fn with(&self, program: &Program, law: &'static Law, polynomial: &'static Law) -> Self {
        let orders = if let Shape::Matched(orders) = polynomial.shape { orders } else { 0 };
        let option = |(segment, each): (&Segment, &[Meeting; 3])| {
            let [now, Meeting::Matched(_), _] = *each else { return *each };
            let replaced = Segment::new(law, segment.beta, segment.rise);
            let fixed = ends(&replaced).map_or(Meeting::Never, |ends| Meeting::Fixed(ends.limits, ends.inner_jump));
            [now, Meeting::Matched(orders), fixed]
        };
        let each = program.given().iter().zip(&self.each).map(option).collect();
        Self { each, cycle: self.cycle, scales: self.scales }
    }

    /// The joints between segments: each index with that of the segment that follows it, the last with the first where the cycle closes.
    fn joints(&self) -> impl Iterator<Item = (usize, usize)> {
        let n = self.each.len();
        let closes = !matches!(self.cycle, Cycle::Travel(_));
        (0..n).filter(move |&k| k + 1 < n || closes).map(move |k| (k, (k + 1) % n))
    }

    /// True when nothing up to the given order should jump between two segments that follow each other.
    fn meets(&self, k: usize, here: Meeting, next: usize, after: Meeting, order: u8) -> bool {
        let sign = if next <= k && self.cycle == Cycle::Mirrored { -1.0 } else { 1.0 };
        match (here, after) {
            (Meeting::Fixed([_, end], _), Meeting::Fixed([start, _], _)) => (1..=usize::from(order)).all(|order| {
                let (before, after) = (end.order(order), sign * start.order(order));
                (before - after).abs() <= NEAR * self.scales[order].max(before.abs()).max(after.abs())
            }),
            (Meeting::Fixed(..), Meeting::Matched(orders)) | (Meeting::Matched(orders), Meeting::Fixed(..)) => {
                orders > usize::from(order)
            }
            _ => false,
        }
    }

    /// True when a segment under an option is smooth inside, and rests at the ends of a travel, up to the given order.
    fn is_smooth(&self, k: usize, meeting: Meeting, order: u8) -> bool {
        let Meeting::Fixed(limits, inner) = meeting else { return !matches!(meeting, Meeting::Never) };
        let turns = |end: Svaj| {
            // Where a travel turns back, v and j are met again with the other sign.
            (1..=usize::from(order)).step_by(2).all(|order| end.order(order).abs() <= NEAR * self.scales[order])
        };
        let travels = matches!(self.cycle, Cycle::Travel(_));
        inner.is_none_or(|jump| jump > order)
            && (!travels || k > 0 || turns(limits[0]))
            && (!travels || k + 1 < self.each.len() || turns(limits[1]))
    }
}

/// The cheapest option for every segment with which no order up to the given one should jump; `None` when there is none. For each
/// option of the first segment the options of the others follow along the cycle.
pub(super) fn cheapest(joining: &Joining, order: u8) -> Option<Vec<SegmentOption>> {
    let first_options = 0..OPTIONS.len();
    let best = first_options.filter_map(|first| cheapest_from(joining, order, first)).min_by_key(|(cost, _)| *cost);
    best.map(|(_, options)| options.into_iter().map(|option| OPTIONS[option].0).collect())
}

fn cheapest_from(joining: &Joining, order: u8, first: usize) -> Option<(u32, Vec<usize>)> {
    let n = joining.each.len();
    let smooth = |k: usize, option: usize| joining.is_smooth(k, joining.each[k][option], order);
    let joins = |k: usize, here: usize, next: usize, after: usize| {
        joining.meets(k, joining.each[k][here], next, joining.each[next][after], order)
    };
    if !smooth(0, first) {
        return None;
    }
    // The cost of the cheapest way to each option of a segment, and the option of the segment before on that way.
    let mut costs = [None; OPTIONS.len()];
    costs[first] = Some(OPTIONS[first].1);
    let mut ways: Vec<[usize; OPTIONS.len()]> = Vec::with_capacity(n);
    for k in 1..n {
        let (mut next, mut way) = ([None; OPTIONS.len()], [0; OPTIONS.len()]);
        for option in (0..OPTIONS.len()).filter(|&option| smooth(k, option)) {
            let reach = |before: usize| {
                costs[before].filter(|_| joins(k - 1, before, k, option)).map(|cost: u32| (cost, before))
            };
            if let Some((cost, before)) = (0..OPTIONS.len()).filter_map(reach).min() {
                next[option] = Some(cost + OPTIONS[option].1);
                way[option] = before;
            }
        }
        costs = next;
        ways.push(way);
    }
    let closes = |option: usize| matches!(joining.cycle, Cycle::Travel(_)) || joins(n - 1, option, 0, first);
    let ends = |option: usize| costs[option].filter(|_| closes(option)).map(|cost| (cost, option));
    let (cost, mut option) = (0..OPTIONS.len()).filter_map(ends).min()?;
    let mut options = vec![option];
    for way in ways.iter().rev() {
        option = way[option];
        options.push(option);
    }
    options.reverse();
    Some((cost, options))
}
