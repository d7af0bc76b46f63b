//! Random edits for tests, possible and impossible ones.

use super::random::Random;
use crate::application::TargetsBy;
use crate::{BreadthGenerator, CamKind, Completion, Design, Edit, LengthUnit, Path, SpeedUnit, Unit};
use levalab_core::application::APPLICATIONS;
use levalab_core::{FOLLOWERS, LAWS};
use serde_json::{Value, json};

/// A random edit of a design, whatever the design: most are possible, some name what is not there, and some numbers are at the
/// ends of what numbers hold.
#[must_use]
pub fn edit(random: &mut Random, design: &Design) -> Edit {
    // One more than there are, now and then.
    let count = design.segments.len() + usize::from(random.once_in(8));
    let segment = random.below(count.max(1));
    let other = random.below(count.max(1));
    match random.below(30) {
        0..=7 => set(random, design),
        8 => Edit::Clear { path: path(random, design) },
        9 => Edit::Insert { at: segment, from: other },
        10 => Edit::Duplicate { segment },
        11 => Edit::Delete { segments: (0..1 + random.below(3)).map(|_| random.below(count.max(1))).collect() },
        12 => Edit::Move { from: segment, to: other },
        13..=15 => Edit::Law { segment, law: random.any(LAWS) },
        16 => Edit::Beta { segment, value: number(random) },
        17..=19 => Edit::Complete(*random.pick(&[
            Completion::Dwell,
            Completion::Return,
            Completion::Stretch,
            Completion::Spread,
            Completion::Close,
        ])),
        20 => Edit::Scale { factor: number(random) },
        21 => of_conditions(random, design, segment),
        22 => Edit::Formula {
            segment,
            text: (*random.pick(&["s₀ + L x", "x^2", "L sin(πx/2)^2", "1/0", "("])).to_owned(),
        },
        23 => Edit::Follower { kind: random.any(FOLLOWERS) },
        24 => Edit::Kind { kind: random.any(&CamKind::WORDS), back: None },
        25 => {
            let sides = random.once_in(2).then(|| random.below(40) as u32);
            Edit::Generator { generator: random.any(&BreadthGenerator::WORDS), sides }
        }
        26 => {
            let tie = *random.pick(&["distance", "angle", "base_radius"]);
            // The search for a value takes as long as all other edits together.
            Edit::Pair { tie, value: (!random.once_in(8)).then(|| number(random)) }
        }
        27 => match random.below(5) {
            0 => Edit::Application { kind: None },
            1 | 2 => Edit::Application { kind: Some(random.any(APPLICATIONS)) },
            3 => Edit::TargetsBy { by: TargetsBy::Time },
            _ => Edit::TargetsBy { by: TargetsBy::Theta },
        },
        28 => {
            let length = Unit::Length(random.any(&LengthUnit::ALL));
            let unit = if random.once_in(2) { length } else { Unit::Speed(random.any(&SpeedUnit::ALL)) };
            if random.once_in(2) { Edit::Convert { unit } } else { Edit::Relabel { unit } }
        }
        _ if random.once_in(20) => Edit::New,
        _ => Edit::Complete(Completion::Spread),
    }
}

/// Another value for a field that the design has, of the same kind more often than not.
fn set(random: &mut Random, design: &Design) -> Edit {
    let path = path(random, design);
    let value = match random.below(10) {
        0 => json!("cycloidal"),
        1 => json!([1, 2]),
        2 => Value::Null,
        _ => json!(number(random)),
    };
    Edit::Set { path, value }
}

fn of_conditions(random: &mut Random, design: &Design, segment: usize) -> Edit {
    let places: Vec<f64> = design.segments.get(segment).map_or_else(Vec::new, |segment| {
        let conditions = segment.data.conditions().unwrap_or_default();
        conditions.iter().map(|condition| condition.at).chain([segment.beta]).collect()
    });
    let at = if places.is_empty() { 0.0 } else { random.any(&places) };
    let order = random.below(4) as u8;
    match random.below(4) {
        0 => Edit::Condition { segment, at, order, value: number(random) },
        1 => Edit::AddCondition { segment },
        2 => Edit::MoveConditions { segment, from: at, to: number(random) },
        _ => Edit::DropConditions { segment, at, order: random.once_in(2).then_some(order) },
    }
}

/// The path of a random field, down to the numbers in lists.
fn path(random: &mut Random, design: &Design) -> Path {
    let file = design.to_value();
    let (mut here, mut path) = (&file, Path::default());
    loop {
        let next = match here {
            Value::Object(fields) if !fields.is_empty() => {
                let key = fields.keys().nth(random.below(fields.len())).map_or("", String::as_str);
                path = path.join(key);
                fields.get(key)
            }
            Value::Array(items) if !items.is_empty() => {
                let index = random.below(items.len());
                path = path.join(index);
                items.get(index)
            }
            _ => None,
        };
        match next {
            Some(value) => here = value,
            None if random.once_in(20) => return path.join("something"),
            None => return path,
        }
    }
}

/// Numbers as people type them, and a few at the ends of what numbers hold.
fn number(random: &mut Random) -> f64 {
    match random.below(12) {
        0 => *random.pick(&[0.0, 1e-9, 1e-300, 5e-324, 1e9, 1e300, -1e300, f64::MAX, 1e-3, -1.0, 360.0]),
        1..=4 => (random.between(-40.0, 120.0) * 10.0).round() / 10.0,
        5..=8 => random.between(1.0, 90.0).round(),
        _ => random.between(0.0, 100.0),
    }
}
