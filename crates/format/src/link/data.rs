//! The data of a free law in a link, after the numbers of its segment.
//!
//! A condition is a letter for what is known (`s`, `v`, `a`, `j`), where, and the value unless it is zero: `s0v0a0s120_10v120a120`.

use super::reader::Fields;
use super::{number, write_value};
use levalab_core::law::{Condition, Data, DataKind, Law};

/// What a condition is on, by its order.
const ORDERS: [char; 4] = ['s', 'v', 'a', 'j'];

pub(super) fn write(text: &mut String, data: &Data) {
    match data {
        Data::None => {}
        Data::Conditions(conditions) => {
            for &Condition { at, order, value } in conditions {
                text.push(ORDERS[usize::from(order) % ORDERS.len()]);
                number::write(text, at);
                if value != 0.0 {
                    write_value(text, value);
                }
            }
        }
    }
}

pub(super) fn read(fields: &mut Fields, law: &Law) -> Option<Data> {
    let Some(free) = law.free() else { return Some(Data::None) };
    match free.data {
        DataKind::Conditions => {
            let mut conditions = Vec::new();
            while let Some(order) = ORDERS.iter().position(|&letter| fields.take(letter)) {
                let at = fields.number()?;
                let [value] = fields.values([Some(0.0)].into_iter())?;
                conditions.push(Condition { at, order: order as u8, value });
            }
            Some(Data::Conditions(conditions))
        }
    }
}
