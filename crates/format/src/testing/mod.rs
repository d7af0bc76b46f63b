//! Random designs for tests, from a seed.

mod edits;
mod motion;
mod random;

pub use edits::edit;
pub use random::Random;

use crate::measure::default_of;
use crate::{
    ApplicationDesign, BreadthGenerator, CamKind, Conjugate, Design, LengthUnit, Notation, Speed, SpeedUnit, TargetsBy,
};
use levalab_core::application::{APPLICATIONS, MAX_APPLICATION_PARAMETERS};
use levalab_core::law::Data;
use levalab_core::{FOLLOWERS, Generator, Law, Quantity, Rotation, Tie};
use motion::segments;
use random::{Decimals, tidy};

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

/// A random design with a table that version 1 does not hold: measured or smooth, at few decimals or at all of them.
#[must_use]
pub fn long_design(random: &mut Random) -> Design {
    loop {
        let mut design = design(random);
        let decimals = random.below(8) as i32;
        let table = design.segments.iter_mut().find_map(|segment| match &mut segment.data {
            Data::Points(points) => Some((segment.beta, points)),
            _ => None,
        });
        let Some((beta, points)) = table else { continue };
        *points = motion::measured(random, decimals, beta, points);
        if design.cam().is_ok() {
            return design;
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

fn title(random: &mut Random) -> String {
    const LETTERS: &[char] =
        &['a', 'Z', '7', ' ', 'ñ', 'º', '-', '.', '_', '#', '%', '"', '\\', 'β', '日', '🎡', '\u{301}'];
    let length = if random.once_in(4) { random.below(65) } else { random.below(13) };
    let title: String = (0..length).map(|_| *random.pick(LETTERS)).collect();
    // A title of blanks alone is refused.
    if title.chars().all(crate::limits::is_invisible) { String::new() } else { title }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_core::LAWS;
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
