//! The data of a free law in a link, after the numbers of its segment.
//!
//! A condition is a letter for what is known (`s`, `v`, `a`, `j`), where, and the value unless it is zero: `s0v0a0s120_10v120a120`; the knots of a spline
//! follow, each a `k` and where. A point of a table is `p`, where, and *s*; ordinates are `o` and their values; an expression is `f`, its text as a title is written, and a full stop.

use super::reader::Fields;
use super::{number, title, write_value};
use levalab_core::law::{Condition, Data, DataKind, Law};

/// What a condition is on, by its order.
const ORDERS: [char; 4] = ['s', 'v', 'a', 'j'];

pub(super) fn write(text: &mut String, data: &Data) {
    match data {
        Data::None => {}
        Data::Conditions(conditions) => write_conditions(text, conditions),
        Data::Spline { conditions, knots } => {
            write_conditions(text, conditions);
            for &knot in knots {
                text.push('k');
                number::write(text, knot);
            }
        }
        Data::Points(points) => {
            for &[at, s] in points {
                text.push('p');
                number::write(text, at);
                if s != 0.0 {
                    write_value(text, s);
                }
            }
        }
        Data::Ordinates(ordinates) => {
            text.push('o');
            ordinates.iter().for_each(|&s| write_value(text, s));
        }
        Data::Expression(expression) => {
            text.push('f');
            title::write(text, expression);
            text.push('.');
        }
    }
}

fn write_conditions(text: &mut String, conditions: &[Condition]) {
    for &Condition { at, order, value } in conditions {
        text.push(ORDERS[usize::from(order) % ORDERS.len()]);
        number::write(text, at);
        if value != 0.0 {
            write_value(text, value);
        }
    }
}

pub(super) fn read(fields: &mut Fields, law: &Law) -> Option<Data> {
    let Some(free) = law.free() else { return Some(Data::None) };
    match free.data {
        DataKind::Conditions | DataKind::Spline => {
            let mut conditions = Vec::new();
            while let Some(order) = ORDERS.iter().position(|&letter| fields.take(letter)) {
                let at = fields.number()?;
                let [value] = fields.values([Some(0.0)].into_iter())?;
                conditions.push(Condition { at, order: order as u8, value });
            }
            let mut knots = Vec::new();
            while free.data == DataKind::Spline && fields.take('k') {
                knots.push(fields.number()?);
            }
            Some(if knots.is_empty() { Data::Conditions(conditions) } else { Data::Spline { conditions, knots } })
        }
        DataKind::Points => {
            let mut points = Vec::new();
            while fields.take('p') {
                let at = fields.number()?;
                let [s] = fields.values([Some(0.0)].into_iter())?;
                points.push([at, s]);
            }
            Some(Data::Points(points))
        }
        DataKind::Ordinates => {
            let mut ordinates = Vec::new();
            fields.take('o').then_some(())?;
            while fields.0.starts_with(['_', '-']) {
                let [s] = fields.values([None].into_iter())?;
                ordinates.push(s);
            }
            Some(Data::Ordinates(ordinates))
        }
        DataKind::Expression => {
            let (expression, rest) = fields.0.strip_prefix('f')?.split_once('.')?;
            fields.0 = rest;
            Some(Data::Expression(title::read(expression)?))
        }
    }
}
