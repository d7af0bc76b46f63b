//! Random designs for tests, from a seed.

use crate::data;
use crate::design::default_of;
use crate::limits::MAX_SEGMENTS;
use crate::{
    ApplicationDesign, BreadthGenerator, CamKind, Conjugate, Design, LengthUnit, Notation, SegmentDesign, Speed,
    SpeedUnit, TargetsBy,
};
use levalab_core::application::{APPLICATIONS, MAX_APPLICATION_PARAMETERS};
use levalab_core::law::{Condition, Data, DataKind, MAX_LAW_PARAMETERS, usual_knots};
use levalab_core::{FOLLOWERS, Generator, LAWS, Law, Quantity, Rotation, Tie};

/// A small generator of random numbers (SplitMix64), the same on every machine.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A generator that always gives the same numbers for the same seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Sixty-four random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 up to but not including `end`.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end.max(1) as u64) as usize
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// True once in `n` times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// One of several.
    pub fn pick<'a, T>(&mut self, from: &'a [T]) -> &'a T {
        &from[self.below(from.len())]
    }
}

/// A random design that passes every check: any law, any follower, a few segments or many, round numbers or long ones.
#[must_use]
pub fn design(random: &mut Random) -> Design {
    loop {
        let candidate = candidate(random);
        if candidate.cam().is_ok() {
            return candidate;
        }
    }
}

fn candidate(random: &mut Random) -> Design {
    let follower = *random.pick(FOLLOWERS);
    // Most cams are of a hand's size; some are at the ends of what is allowed.
    let size = if random.once_in(8) { 10_f64.powf(random.between(-4.0, 4.0)) } else { random.between(10.0, 100.0) };
    let decimals = Decimals::pick(random);
    let oscillating = follower.id.starts_with("oscillating");
    let travel = if oscillating { 20.0 } else { 0.7 * size };
    let mut values = [0.0; 4];
    for (value, parameter) in values.iter_mut().zip(follower.parameters) {
        let default = default_of(parameter, 1.0);
        *value = match (parameter.quantity, default) {
            (_, Some(default)) if random.once_in(2) => default,
            (Quantity::Angle, _) => decimals.round(random.between(-80.0, 80.0)),
            (_, None) => decimals.round(size * random.between(0.1, 2.5)),
            (_, Some(_)) => decimals.round(size * random.between(-0.9, 0.9)),
        };
    }
    let kind = kind(random, decimals, size);
    let ready = kind.generator().is_some();
    let travels = kind.travel().is_some();
    if matches!(kind, CamKind::ConstantBreadth { .. } | CamKind::Translating { .. }) {
        // These need the follower in line with the cam.
        for (value, parameter) in values.iter_mut().zip(follower.parameters) {
            *value = default_of(parameter, 1.0).unwrap_or(*value);
        }
    }
    let base_radius = if travels { 0.0 } else { decimals.round(size) };
    let mut segments = if ready { Vec::new() } else { segments(random, decimals, travel, kind.whole()) };
    if let (CamKind::ConstantBreadth { breadth, .. }, Some(last)) = (kind, segments.last_mut()) {
        // Half a turn ends as high as the breadth asks for.
        last.rise = tidy(last.rise + breadth - 2.0 * base_radius);
        if last.law.is_dwell() || last.law.free().is_some() {
            last.law = Law::by_id("cycloidal").unwrap_or(last.law);
            last.parameters = last.law.default_parameters();
            last.data = Data::None;
        }
    }
    let title = title(random);
    // Half of the designs are told in our own symbols.
    let notation = Notation::ALL.get(title.chars().count() % 12).copied().unwrap_or_default();
    Design {
        title,
        length_unit: *random.pick(&LengthUnit::ALL),
        speed: speed(random, decimals, travels),
        kind,
        rotation: if travels {
            Rotation::default()
        } else {
            *random.pick(&[Rotation::CounterClockwise, Rotation::Clockwise])
        },
        base_radius,
        follower,
        values,
        segments,
        conjugate: random.once_in(5).then(|| second(random, decimals, size, oscillating)),
        notation,
        application: (!oscillating && random.once_in(4)).then(|| application(random, decimals, kind)),
    }
}

fn kind(random: &mut Random, decimals: Decimals, size: f64) -> CamKind {
    let breadth = |random: &mut Random, generator| {
        let breadth = tidy(2.0 * decimals.round(size) + decimals.round(size * random.between(0.05, 0.6)));
        CamKind::ConstantBreadth { breadth, generator }
    };
    match random.below(10) {
        0 => CamKind::Grooved,
        1 => CamKind::Translating { length: decimals.round(size * random.between(1.0, 5.0)) },
        2 => breadth(random, BreadthGenerator::Ready(Generator::Harmonic)),
        3 => {
            let sides = 3 + 2 * random.below(15) as u32;
            breadth(random, BreadthGenerator::Ready(Generator::CircularArc { sides }))
        }
        4 => breadth(random, BreadthGenerator::Mirror),
        _ => CamKind::Rotating,
    }
}

fn second(random: &mut Random, decimals: Decimals, size: f64, oscillating: bool) -> Conjugate {
    let tie = match (oscillating, random.once_in(2)) {
        (false, _) => Tie::Distance(decimals.round(size * random.between(2.0, 5.0))),
        (true, false) => Tie::Angle(decimals.round(random.between(40.0, 150.0))),
        (true, true) => Tie::BaseRadius(decimals.round(size * random.between(0.5, 1.5))),
    };
    Conjugate { tie, radius: random.once_in(3).then(|| decimals.round(size * random.between(0.1, 0.5))) }
}

fn application(random: &mut Random, decimals: Decimals, kind: CamKind) -> ApplicationDesign {
    let application = *random.pick(APPLICATIONS);
    let mut values = [0.0; MAX_APPLICATION_PARAMETERS];
    for (value, setting) in values.iter_mut().zip(application.parameters) {
        let default = crate::application::default_of(setting).filter(|_| random.once_in(2));
        *value = default.unwrap_or_else(|| decimals.round(random.between(1.0, 70.0)));
    }
    let by = if random.once_in(3) { TargetsBy::Time } else { TargetsBy::Theta };
    let most = if by == TargetsBy::Time { 20.0 } else { kind.travel().unwrap_or(360.0) };
    let count = random.below(4) * random.below(7);
    let place = |random: &mut Random| decimals.round(most * random.between(0.0, 0.9));
    let height = |random: &mut Random| if random.once_in(3) { 0.0 } else { decimals.round(random.between(-9.0, 99.0)) };
    let targets = (0..count).map(|_| [place(random), height(random)]).collect();
    let output = random.below(application.outputs.len());
    ApplicationDesign { application, values, output, by, targets }
}

fn speed(random: &mut Random, decimals: Decimals, travels: bool) -> Speed {
    let value = if random.once_in(2) { 1.0 } else { decimals.round(10_f64.powf(random.between(-1.0, 4.0))) };
    Speed { value, unit: if travels { SpeedUnit::LengthPerSecond } else { *random.pick(&SpeedUnit::ALL) } }
}

fn segments(random: &mut Random, decimals: Decimals, travel: f64, cycle: f64) -> Vec<SegmentDesign> {
    let count = if random.once_in(20) { 1 + random.below(MAX_SEGMENTS) } else { 2 + random.below(11) };
    let weights: Vec<f64> = (0..count).map(|_| random.between(0.2, 1.0)).collect();
    let whole: f64 = weights.iter().sum();
    let mut left = cycle;
    let mut height = 0.0;
    let mut segments: Vec<SegmentDesign> = Vec::with_capacity(count);
    for (k, weight) in weights.iter().enumerate() {
        let last = k + 1 == count;
        let beta = if last { left } else { decimals.round(cycle * weight / whole) };
        left = tidy(left - beta);
        let target = if last || random.once_in(4) { 0.0 } else { decimals.round(travel * random.unit()) };
        let law = law(random, target == height, segments.last().map(|segment| segment.law));
        let rise = if law.is_dwell() { 0.0 } else { tidy(target - height) };
        height = tidy(height + rise);
        let parameters = parameters(random, decimals, law, beta);
        let span = (beta, tidy(height - rise), height);
        let made = law.free().map_or(Data::None, |free| data_of(random, decimals, free.data, span));
        let made = if random.once_in(3) { knotted(random, decimals, law, parameters, beta, made) } else { made };
        let rise = if law.is_dwell() || data::asks_for_rise(law, &made) { rise } else { 0.0 };
        segments.push(SegmentDesign { law, beta, rise, parameters, data: made });
    }
    segments
}

fn law(random: &mut Random, level: bool, before: Option<&Law>) -> &'static Law {
    loop {
        let law = *random.pick(LAWS);
        let fits = law.is_dwell() == level || level && random.once_in(4);
        if fits && !(law.is_matched() && before.is_none_or(Law::is_matched)) {
            return law;
        }
    }
}

/// Fractions, and parts of β; what does not fit is tried by the caller.
fn parameters(random: &mut Random, decimals: Decimals, law: &Law, beta: f64) -> [f64; MAX_LAW_PARAMETERS] {
    let mut values = [0.0; MAX_LAW_PARAMETERS];
    for (value, parameter) in values.iter_mut().zip(law.parameters) {
        let default = default_of(parameter, beta).filter(|_| random.once_in(2));
        let whole = if parameter.quantity == Quantity::Span { beta } else { 1.0 };
        let default = default.or_else(|| (parameter.key == "degree").then(|| random.below(5) as f64 + 4.0));
        *value = default.unwrap_or_else(|| decimals.round(whole * random.between(0.0, 0.5)));
    }
    values
}

/// Data that lead from one height to another over β: round numbers or long ones, few or many.
fn data_of(random: &mut Random, decimals: Decimals, kind: DataKind, (beta, start, end): (f64, f64, f64)) -> Data {
    let lift = start.abs().max(end.abs()).max(1.0);
    match kind {
        DataKind::Conditions | DataKind::Spline => {
            let at = |at: f64, order: u8, value: f64| Condition { at, order, value };
            let mut conditions = vec![at(0.0, 0, start), at(beta, 0, end)];
            for order in 1..4 {
                for place in [0.0, beta] {
                    if !random.once_in(3) {
                        let value =
                            if random.once_in(2) { 0.0 } else { decimals.round(lift * random.between(-1.0, 1.0)) };
                        conditions.push(at(place, order, value));
                    }
                }
            }
            for _ in 0..random.below(3) * random.below(3) {
                let height = decimals.round(lift * random.unit());
                conditions.push(at(decimals.round(beta * random.between(0.05, 0.95)), 0, height));
            }
            Data::Conditions(conditions)
        }
        DataKind::Points => {
            let count = 2 + random.below(12);
            let at = |k: usize| if k + 1 == count { beta } else { tidy(beta * k as f64 / (count - 1) as f64) };
            let height = |random: &mut Random| decimals.round(lift * random.unit());
            let mut points: Vec<[f64; 2]> = (0..count).map(|k| [at(k), height(random)]).collect();
            (points[0][1], points[count - 1][1]) = (start, end);
            Data::Points(points)
        }
        DataKind::Ordinates => {
            let inner = (0..random.below(9)).map(|_| decimals.round(lift * random.unit()));
            let inner: Vec<f64> = inner.collect();
            Data::Ordinates([vec![start], inner, vec![end]].concat())
        }
        DataKind::Expression => {
            let rise = tidy(end - start);
            let texts = [
                "s₀ + L (10x³ − 15x⁴ + 6x⁵)".to_owned(),
                "s0 + L·sin(πx/2)^2".to_owned(),
                format!("{start} + {rise}(1 - cos(πθ/β))/2"),
                format!("{start}+{rise}x^3,5"),
            ];
            Data::Expression(random.pick(&texts).clone())
        }
    }
}

/// A spline with knots of its own, near those that it would take unless told.
fn knotted(
    random: &mut Random,
    decimals: Decimals,
    law: &Law,
    parameters: [f64; MAX_LAW_PARAMETERS],
    beta: f64,
    data: Data,
) -> Data {
    match data {
        Data::Conditions(conditions) if law.free().is_some_and(|free| free.data == DataKind::Spline) => {
            let usual = usual_knots(&conditions, parameters[0] as usize, beta);
            let knots: Vec<f64> =
                usual.iter().map(|knot| decimals.round(knot + beta * random.between(-0.02, 0.02))).collect();
            if knots.is_empty() { Data::Conditions(conditions) } else { Data::Spline { conditions, knots } }
        }
        data => data,
    }
}

fn title(random: &mut Random) -> String {
    const LETTERS: &[char] =
        &['a', 'Z', '7', ' ', 'ñ', 'º', '-', '.', '_', '#', '%', '"', '\\', 'β', '日', '🎡', '\u{301}'];
    let length = if random.once_in(4) { random.below(65) } else { random.below(13) };
    (0..length).map(|_| *random.pick(LETTERS)).collect()
}

/// How many decimals the numbers of a design have; all of them when none is said.
#[derive(Clone, Copy)]
struct Decimals(Option<i32>);

impl Decimals {
    fn pick(random: &mut Random) -> Self {
        Self(*random.pick(&[Some(0), Some(0), Some(1), Some(2), Some(6), None]))
    }

    fn round(self, value: f64) -> f64 {
        match self.0 {
            Some(decimals) if value.abs() > 10_f64.powi(1 - decimals) => {
                let scale = 10_f64.powi(decimals);
                (value * scale).round() / scale
            }
            _ => value,
        }
    }
}

/// A difference of decimals without what binary rounding leaves behind.
fn tidy(value: f64) -> f64 {
    let rounded = (value * 1e9).round() / 1e9;
    if (rounded - value).abs() < 1e-12 { rounded } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn random_designs_cover_every_law_follower_and_kind_of_cam() {
        let mut random = Random::new(1);
        let (mut laws, mut followers, mut many) = (HashSet::new(), HashSet::new(), false);
        let (mut kinds, mut ties) = (HashSet::new(), HashSet::new());
        for _ in 0..2000 {
            let design = design(&mut random);
            laws.extend(design.segments.iter().map(|segment| segment.law.id));
            followers.insert(design.follower.id);
            many |= design.segments.len() > 40;
            kinds.insert(design.kind.word());
            ties.extend(design.conjugate.map(|pair| pair.tie.key()));
        }
        assert_eq!((kinds.len(), ties.len()), (CamKind::WORDS.len(), 3));
        assert_eq!((laws.len(), followers.len(), many), (LAWS.len(), FOLLOWERS.len(), true));
    }
}
