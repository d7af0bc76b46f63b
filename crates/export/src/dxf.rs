//! DXF for CAD and laser cutters: closed curves on layers, in the unit of the design.

use crate::curves::{Curve, Role, Shape, curves, room};
use crate::words::Word;
use crate::{Refusal, Shaft, Step, Subject};
use dxf::entities::{Circle, Entity, EntityType, LwPolyline, Text};
use dxf::enums::{AcadVersion, Units};
use dxf::tables::Layer;
use dxf::{Color, Drawing, LwPolylineVertex, Point};
use levalab_format::LengthUnit;

/// The oldest version that has light polylines, so that everything opens it; before it they are dropped without a word.
const VERSION: AcadVersion = AcadVersion::R2000;

/// Height of the text, as a part of the base radius.
const TEXT: f64 = 0.12;

/// The drawing: profile, pitch curve, base and prime circle, the shaft's hole, and the title, each on a layer of its own; those of
/// a second cam on layers that end in 2.
///
/// The cam lies as at θ = 0 with its centre at the origin. The points of the profile are the rows of `levalab analyze`.
///
/// # Errors
/// When there is no room for the shaft.
pub fn dxf(subject: &Subject, step: Step, shaft: Option<Shaft>) -> Result<Vec<u8>, Refusal> {
    let curves = curves(subject, step, shaft);
    if let Some(shaft) = shaft {
        shaft.check(subject, room(&curves))?;
    }
    let mut drawing = Drawing::new();
    drawing.header.version = VERSION;
    drawing.header.default_drawing_units = match subject.design().length_unit {
        LengthUnit::Millimetre => Units::Millimeters,
        LengthUnit::Centimetre => Units::Centimeters,
        LengthUnit::Metre => Units::Meters,
        LengthUnit::Inch => Units::Inches,
    };
    for curve in &curves {
        let layer = add_layer(&mut drawing, subject, curve);
        add(&mut drawing, layer, entity(&curve.shape));
    }
    add_title(&mut drawing, subject);
    let mut bytes = Vec::new();
    drawing.save(&mut bytes).map_err(|error| Refusal::Failed { said: error.to_string() })?;
    Ok(bytes)
}

fn entity(shape: &Shape) -> EntityType {
    match shape {
        Shape::Closed(points) | Shape::Open(points) => {
            let mut line = LwPolyline::default();
            line.set_is_closed(matches!(shape, Shape::Closed(_)));
            let vertex =
                |point: &levalab_core::Point| LwPolylineVertex { x: point.re, y: point.im, ..Default::default() };
            line.vertices = points.iter().map(vertex).collect();
            EntityType::LwPolyline(line)
        }
        Shape::Circle(radius) => EntityType::Circle(Circle::new(Point::origin(), *radius)),
    }
}

fn add(drawing: &mut Drawing, layer: String, shape: EntityType) {
    let mut entity = Entity::new(shape);
    entity.common.layer = layer;
    drawing.add_entity(entity);
}

/// The layer of a curve, in a colour of its own.
fn add_layer(drawing: &mut Drawing, subject: &Subject, curve: &Curve) -> String {
    let (word, colour) = match curve.role {
        Role::Profile => (Word::Profile, 7),
        Role::Outer => (Word::OuterWall, 7),
        Role::Base if subject.travels() => (Word::BaseLine, 8),
        Role::Pitch => (Word::PitchCurve, 5),
        Role::Base => (Word::BaseCircle, 8),
        Role::Prime => (Word::PrimeCircle, 30),
        Role::Bore => (Word::Bore, 1),
    };
    let second = if curve.second { " 2" } else { "" };
    layer(drawing, &format!("{}{second}", word.said(subject.language)), colour)
}

fn layer(drawing: &mut Drawing, name: &str, colour: u8) -> String {
    let name = name.to_uppercase().replace(' ', "_");
    if drawing.layers().all(|layer| layer.name != name) {
        drawing.add_layer(Layer { name: name.clone(), color: Color::from_index(colour), ..Layer::default() });
    }
    name
}

/// The title under the drawing, with what is known of the unit.
fn add_title(drawing: &mut Drawing, subject: &Subject) {
    let name = layer(drawing, Word::Text.said(subject.language), 8);
    let radius = subject.size();
    let lowest = drawing.entities().filter_map(lowest).fold(-radius, f64::min);
    let text = Text {
        location: Point::new(-radius, lowest - 3.0 * TEXT * radius, 0.0),
        text_height: TEXT * radius,
        value: plain(&format!("{} ({})", subject.design().title, subject.design().length_unit.symbol())),
        ..Text::default()
    };
    add(drawing, name, EntityType::Text(text));
}

fn lowest(entity: &Entity) -> Option<f64> {
    match &entity.specific {
        EntityType::LwPolyline(line) => line.vertices.iter().map(|vertex| vertex.y).reduce(f64::min),
        EntityType::Circle(circle) => Some(-circle.radius),
        _ => None,
    }
}

/// Text without the sequences that DXF takes for symbols: `%%d` is a degree sign, `\U+2300` a diameter, `^J` a new line.
fn plain(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => safe.push_str("\\U+005C"),
            '^' => safe.push_str("^ "),
            // A sign that no sequence begins with, and that looks the same.
            '%' if safe.ends_with('%') => safe.push_str("\\U+0025"),
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_no_command() {
        assert_eq!(plain("50%%d \\U+2300 ^J\n"), "50%\\U+0025d \\U+005CU+2300 ^ J ");
        assert_eq!(plain("Leva 9RT, 100 %"), "Leva 9RT, 100 %");
    }
}
