//! The data of a free law in a link, after the numbers of its segment.
//!
//! A condition is a letter for what is known (`s`, `v`, `a`, `j`), where, and the value unless it is zero: `s0v0a0s120_10v120a120`; the knots of a spline
//! follow, each a `k` and where. A table that is in the section of long tables has no points here. A point of a table is `p`, where, and *s*; ordinates are `o` and their values; an expression is `f`, its text as a title is written, and a full stop.

use super::reader::Fields;
use super::{Writer, tables, title};
use crate::Version;
use levalab_core::law::{Condition, Data, DataKind, Law};

/// What a condition is on, by its order.
const ORDERS: [char; 4] = ['s', 'v', 'a', 'j'];

pub(super) fn write(writer: &mut Writer, data: &Data) {
    match data {
        Data::None => {}
        Data::Conditions(conditions) => write_conditions(writer, conditions),
        Data::Spline { conditions, knots } => {
            write_conditions(writer, conditions);
            for &knot in knots {
                writer.text.push('k');
                writer.number(knot);
            }
        }
        Data::Points(points) if writer.version > Version::One && tables::is_packed(points) => {}
        Data::Points(points) => {
            for &[at, s] in points {
                writer.text.push('p');
                writer.number(at);
                if s != 0.0 {
                    writer.value(s);
                }
            }
        }
        Data::Ordinates(ordinates) => {
            writer.text.push('o');
            ordinates.iter().for_each(|&s| writer.value(s));
        }
        Data::Expression(expression) => {
            writer.text.push('f');
            writer.title(expression);
            writer.text.push('.');
        }
    }
}

fn write_conditions(writer: &mut Writer, conditions: &[Condition]) {
    for &Condition { at, order, value } in conditions {
        writer.text.push(ORDERS[usize::from(order) % ORDERS.len()]);
        writer.number(at);
        if value != 0.0 {
            writer.value(value);
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
            while fields.rest.starts_with(['_', '-']) {
                let [s] = fields.values([None].into_iter())?;
                ordinates.push(s);
            }
            Some(Data::Ordinates(ordinates))
        }
        DataKind::Expression => {
            let (expression, rest) = fields.rest.strip_prefix('f')?.split_once('.')?;
            fields.rest = rest;
            Some(Data::Expression(title::read(expression, fields.version)?))
        }
    }
}
