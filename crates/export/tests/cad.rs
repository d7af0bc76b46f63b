//! DXF as another program reads it: closed lines on named layers, in a unit, through the points of the analysis.

use acadrust::{CadDocument, DxfReader, EntityType};
use levalab_core::{Analysis, Column};
use levalab_export::{Keyway, Shaft, Step, Subject, dxf};
use levalab_format::{Design, EXAMPLES, LengthUnit, Study, example};
use levalab_words::Language;
use std::io::Cursor;

/// The writer keeps twelve decimals, in whatever unit.
const TOLERANCE: f64 = 1e-12;

fn read(design: &Design, language: Language, shaft: Option<Shaft>) -> CadDocument {
    let study = Study::without_columns(design.clone()).expect("a good design");
    let bytes = dxf(&Subject { study: &study, language }, Step::OF_CURVES, shaft).expect("it can be drawn");
    DxfReader::from_reader(Cursor::new(bytes)).expect("it is DXF").read().expect("all of it is understood")
}

/// The points of the one line on a layer, which is closed but for a cam that travels.
fn line(drawing: &CadDocument, layer: &str) -> Option<Vec<(f64, f64)>> {
    let lines = drawing.entities().filter_map(|entity| match entity {
        EntityType::LwPolyline(line) if line.common.layer == layer => Some(line),
        _ => None,
    });
    let lines: Vec<_> = lines.collect();
    let travels = circle(drawing, "BASE_CIRCLE").or(circle(drawing, "CIRCUNFERENCIA_BASE")).is_none();
    assert!(lines.len() <= 1 && lines.iter().all(|line| line.is_closed != travels), "{layer}");
    lines.first().map(|line| line.vertices.iter().map(|vertex| (vertex.location.x, vertex.location.y)).collect())
}

fn circle(drawing: &CadDocument, layer: &str) -> Option<f64> {
    drawing.entities().find_map(|entity| match entity {
        EntityType::Circle(circle) if circle.common.layer == layer => Some(circle.radius),
        _ => None,
    })
}

fn assert_rows(found: &[(f64, f64)], analysis: &Analysis, x: Column, y: Column, what: &str) {
    let (x, y) = (analysis.column(x).expect("x"), analysis.column(y).expect("y"));
    let rows = if what == "WEDGE" { x.len() } else { x.len() - 1 };
    assert_eq!(found.len(), rows, "{what}: the last row is the first, where it comes round");
    let size = x.iter().chain(y).fold(1.0_f64, |most, value| most.max(value.abs()));
    for (k, (px, py)) in found.iter().enumerate() {
        assert!((px - x[k]).abs().max((py - y[k]).abs()) <= TOLERANCE * size, "{what}[{k}]: {px}, {py}");
    }
}

#[test]
fn lines_run_through_the_rows_of_the_analysis() {
    for (name, _) in EXAMPLES {
        let design = example(name).expect(name);
        let cam = design.cam().expect(name);
        let analysis = Analysis::of(&cam, Step::OF_CURVES.count());
        let drawing = read(&design, Language::En, None);
        let profile = line(&drawing, "PROFILE").expect(name);
        assert_rows(&profile, &analysis, Column::X, Column::Y, name);
        if design.kind.travel().is_some() {
            assert!(line(&drawing, "BASE_LINE").is_some_and(|ends| ends.len() == 2), "{name}");
        } else {
            assert_eq!(circle(&drawing, "BASE_CIRCLE"), Some(design.base_radius), "{name}");
        }
        let groove = line(&drawing, "OUTER_WALL");
        assert_eq!(groove.is_some(), analysis.column(Column::OuterX).is_some(), "{name}");
        if let Some(groove) = groove {
            assert_rows(&groove, &analysis, Column::OuterX, Column::OuterY, name);
        }
        match line(&drawing, "PITCH_CURVE") {
            Some(pitch) => {
                assert_rows(&pitch, &analysis, Column::PitchX, Column::PitchY, name);
                if design.kind.travel().is_some() {
                    continue;
                }
                let prime = design.base_radius + cam.follower.disc_radius();
                let drawn = circle(&drawing, "PRIME_CIRCLE");
                assert!(drawn.is_some_and(|radius| (radius - prime).abs() <= TOLERANCE * prime.max(1.0)), "{name}");
            }
            None => assert!(cam.follower.is_flat(), "{name} has a pitch curve"),
        }
    }
}

#[test]
fn the_unit_is_declared() {
    let mut design = example("9RT").expect("9RT");
    for (unit, code) in
        [(LengthUnit::Millimetre, 4), (LengthUnit::Centimetre, 5), (LengthUnit::Metre, 6), (LengthUnit::Inch, 1)]
    {
        design.length_unit = unit;
        assert_eq!(read(&design, Language::En, None).header.insertion_units, code);
    }
}

#[test]
fn layers_are_named_in_the_language_and_the_title_is_text() {
    let mut design = example("9RT").expect("9RT");
    design.title = "Leva ρ, 50%%d".to_owned();
    let shaft = Shaft { bore: 20.0, keyway: Some(Keyway { width: 6.0, depth: 2.8 }) };
    let drawing = read(&design, Language::Es, Some(shaft));
    for layer in ["PERFIL", "CURVA_DE_PASO", "AGUJERO"] {
        assert!(line(&drawing, layer).is_some_and(|line| line.len() > 70), "{layer}");
    }
    for layer in ["PERFIL", "CURVA_DE_PASO", "CIRCUNFERENCIA_BASE", "CIRCUNFERENCIA_PRIMARIA", "AGUJERO", "TEXTO"] {
        assert!(drawing.layers.iter().any(|known| known.name == layer), "{layer}");
    }
    let titles: Vec<String> = drawing
        .entities()
        .filter_map(|entity| match entity {
            EntityType::Text(text) => Some(text.value.clone()),
            _ => None,
        })
        .collect();
    assert!(titles.len() == 1 && titles[0].starts_with("Leva ρ, 50%") && !titles[0].contains("%%d"), "{titles:?}");
}
