//! The solid as its file holds it, read by a reader of its own: closed, right side out, and as large as it should be.

use levalab_core::{Analysis, Column};
use levalab_export::{Keyway, Refusal, Shaft, Step, Subject, stl};
use levalab_format::testing::{self, Random};
use levalab_format::{CamKind, Design, EXAMPLES, Study, example};
use levalab_words::Language;
use std::collections::HashMap;

/// The file's numbers have 24 bits.
const SINGLE: f64 = 1e-5;

type Corner = [f32; 3];

/// Reads binary STL: normal and corners of each triangle.
fn read(bytes: &[u8]) -> Vec<(Corner, [Corner; 3])> {
    let number = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
    let corner = |at: usize| [number(at), number(at + 4), number(at + 8)];
    let count = u32::from_le_bytes(bytes[80..84].try_into().expect("four bytes")) as usize;
    assert_eq!(bytes.len(), 84 + 50 * count, "the file is as long as it says");
    assert!(!bytes.starts_with(b"solid"), "it would be taken for text");
    let triangle = |k: usize| {
        let at = 84 + 50 * k;
        (corner(at), [corner(at + 12), corner(at + 24), corner(at + 36)])
    };
    (0..count).map(triangle).collect()
}

/// Every edge is there twice, once each way: nothing is open and nothing is inside out beside its neighbour.
fn assert_closed(triangles: &[(Corner, [Corner; 3])], what: &str) {
    let bits = |corner: Corner| corner.map(|part| (part + 0.0).to_bits());
    let mut edges: HashMap<_, i32> = HashMap::new();
    for (_, [a, b, c]) in triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            assert_ne!(bits(*from), bits(*to), "{what}: a triangle without an area");
            *edges.entry((bits(*from), bits(*to))).or_default() += 1;
        }
    }
    for (&(from, to), &times) in &edges {
        assert_eq!(times, 1, "{what}: an edge is there {times} times");
        assert_eq!(edges.get(&(to, from)), Some(&1), "{what}: an edge has no neighbour");
    }
}

/// Volume by the divergence theorem: positive when the outside is out.
fn volume(triangles: &[(Corner, [Corner; 3])]) -> f64 {
    let of = |(_, corners): &(Corner, [Corner; 3])| {
        let [a, b, c] = corners.map(|corner| corner.map(f64::from));
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    triangles.iter().map(of).sum::<f64>() / 6.0
}

fn assert_normals_point_out(triangles: &[(Corner, [Corner; 3])], what: &str) {
    for (normal, corners) in triangles {
        let [a, b, c] = corners.map(|corner| corner.map(f64::from));
        let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let along: f64 = cross.iter().zip(normal).map(|(part, n)| part * f64::from(*n)).sum();
        let length = cross.iter().map(|part| part * part).sum::<f64>().sqrt();
        assert!(along >= length * (1.0 - 1e-6), "{what}: {normal:?} on {corners:?}");
    }
}

/// The area within the profile by Green's theorem, in mm², of the polygon through the rows of the analysis.
fn area(design: &Design, steps: usize, mm: f64) -> f64 {
    let cam = design.cam().expect("a good design");
    let analysis = Analysis::of(&cam, steps);
    let (x, y) = (analysis.column(Column::X).expect("x"), analysis.column(Column::Y).expect("y"));
    let twice: f64 = (0..steps).map(|k| x[k] * y[k + 1] - x[k + 1] * y[k]).sum();
    (twice / 2.0).abs() * mm * mm
}

fn made(design: &Design, step: Step, thickness: f64, shaft: Option<Shaft>) -> Result<Vec<u8>, Refusal> {
    let study = Study::without_columns(design.clone()).expect("a good design");
    stl(&Subject { study: &study, language: Language::En }, step, thickness, shaft)
}

#[test]
fn every_example_is_a_closed_solid_of_the_right_size() {
    let mut refused = Vec::new();
    for (name, _) in EXAMPLES {
        let design = example(name).expect(name);
        let mm = match design.length_unit.symbol() {
            "m" => 1000.0,
            "cm" => 10.0,
            "in" => 25.4,
            _ => 1.0,
        };
        let thickness = design.base_radius.max(1.0) / 4.0;
        let triangles = match made(&design, Step::OF_CURVES, thickness, None) {
            Ok(bytes) => read(&bytes),
            Err(refusal) => {
                assert!(matches!(refusal, Refusal::NotSolid { why: Some(_) }), "{name}: {refusal:?}");
                refused.push(*name);
                continue;
            }
        };
        assert_closed(&triangles, name);
        assert_normals_point_out(&triangles, name);
        let one_plate = matches!(design.kind, CamKind::Rotating | CamKind::ConstantBreadth { .. });
        if !one_plate || design.conjugate.is_some() {
            continue;
        }
        let expected = area(&design, 720, mm) * thickness * mm;
        assert!((volume(&triangles) / expected - 1.0).abs() < SINGLE, "{name}: {} of {expected}", volume(&triangles));
    }
    assert!(refused.len() < EXAMPLES.len() / 4, "{refused:?} bound no solid");
}

#[test]
fn bore_and_keyway_are_cut_out() {
    let design = example("9RT").expect("9RT");
    let whole = area(&design, 720, 1.0) * 10.0;
    let bore = Shaft { bore: 20.0, keyway: None };
    let circle = std::f64::consts::PI * 100.0;
    let keyed = Shaft { bore: 20.0, keyway: Some(Keyway { width: 6.0, depth: 2.8 }) };
    // The slot, without what lies within the bore: a rectangle from the chord to the bottom, less the cap of the circle.
    let half = 0.3_f64.asin();
    let cap = 100.0 * (half - half.sin() * half.cos());
    let slot = 6.0 * (12.8 - 10.0 * half.cos()) - cap;
    for (shaft, cut) in [(bore, circle), (keyed, circle + slot)] {
        let triangles = read(&made(&design, Step::OF_CURVES, 10.0, Some(shaft)).expect("it fits"));
        assert_closed(&triangles, "9RT with a bore");
        assert_normals_point_out(&triangles, "9RT with a bore");
        // The bore is a polygon.
        assert!((volume(&triangles) - (whole - cut * 10.0)).abs() < 2e-3 * cut * 10.0, "{shaft:?}");
    }
}

#[test]
fn random_cams_are_closed_solids_or_are_refused() {
    let mut random = Random::new(11);
    let (mut solids, mut refusals) = (0, 0);
    for k in 0..150 {
        let design = testing::design(&mut random);
        let what = format!("design {k}");
        let thickness = design.base_radius.max(1.0);
        match made(&design, Step::of_degrees(2.0).expect("it divides"), thickness, None) {
            Ok(bytes) => {
                assert_closed(&read(&bytes), &what);
                assert!(volume(&read(&bytes)) > 0.0, "{what} is inside out");
                solids += 1;
            }
            Err(refusal) => {
                assert!(matches!(refusal, Refusal::NotSolid { .. }), "{what}: {refusal:?}");
                refusals += 1;
            }
        }
    }
    assert!(solids > 20 && refusals > 5, "{solids} solids and {refusals} refusals tell little");
}

#[test]
fn what_cannot_be_made_is_refused_with_a_reason() {
    let design = example("9RT").expect("9RT");
    let key = |width, depth| Some(Shaft { bore: 20.0, keyway: Some(Keyway { width, depth }) });
    let refused = |thickness, shaft| made(&design, Step::OF_CURVES, thickness, shaft).expect_err("it cannot be made");
    assert!(matches!(refused(0.0, None), Refusal::NotPositive { what: "thickness", .. }));
    assert!(matches!(refused(f64::NAN, None), Refusal::NotPositive { what: "thickness", .. }));
    assert!(matches!(refused(5.0, Some(Shaft { bore: 70.0, keyway: None })), Refusal::NoRoom { .. }));
    assert!(matches!(refused(5.0, key(25.0, 3.0)), Refusal::KeywayTooWide { .. }));
    assert!(matches!(refused(5.0, key(6.0, 26.0)), Refusal::NoRoom { .. }));
    let mut small = design.clone();
    small.base_radius = 10.0;
    let refusal = made(&small, Step::OF_CURVES, 5.0, None).expect_err("its profile is undercut");
    assert!(refusal.sentence(Language::Es).contains("rebaje"), "{refusal:?}");
}

#[test]
fn every_kind_of_cam_is_a_closed_solid() {
    let json = |cam: &str, more: &str| {
        format!(
            r#"{{"format": "levalab/1", "title": "", "length_unit": "mm", "speed": {{"value": 1, "unit": "{}"}}, "cam": {cam}, {more}}}"#,
            if cam.contains("translating") { "mm/s" } else { "rpm" }
        )
    };
    let roller = r#""follower": {"motion": "translating", "contact": "roller", "roller_radius": 7}"#;
    let turn = r#""segments": [{"law": "cycloidal", "beta": 180, "rise": 10}, {"law": "cycloidal", "beta": 180, "rise": -10}]"#;
    let travel = r#""segments": [{"law": "cycloidal", "beta": 60, "rise": 10}, {"law": "dwell", "beta": 60}]"#;
    let plate = r#"{"kind": "rotating", "base_radius": 35}"#;
    let pair = format!(r#"{roller}, "conjugate": {{"distance": 130}}, {turn}"#);
    let kinds = [
        ("groove", r#"{"kind": "grooved", "base_radius": 35}"#, format!("{roller}, {turn}")),
        ("wedge", r#"{"kind": "translating", "length": 120}"#, format!("{roller}, {travel}")),
        ("pair", plate, pair),
    ];
    for (name, cam, more) in kinds {
        let design = Design::from_json(&json(cam, &more)).expect(name);
        let triangles = read(&made(&design, Step::OF_CURVES, 10.0, None).expect(name));
        assert_closed(&triangles, name);
        assert_normals_point_out(&triangles, name);
        let height = triangles.iter().flat_map(|(_, corners)| corners).map(|corner| corner[2]).fold(0.0, f32::max);
        assert_eq!(height, if name == "pair" { 30.0 } else { 10.0 }, "{name}");
        let size = volume(&triangles);
        if name == "groove" {
            // A disc, less a band as wide as the roller and half as deep as the disc: along the pitch curve, whose length is about
            // that of a circle, to within a hundredth.
            let outer =
                triangles.iter().flat_map(|(_, corners)| corners).map(|[x, y, _]| x.hypot(*y)).fold(0.0, f32::max);
            let band = 14.0 * std::f64::consts::TAU * (42.0 + 5.0);
            let expected = std::f64::consts::PI * f64::from(outer).powi(2) * 10.0 - band * 5.0;
            assert!((size / expected - 1.0).abs() < 0.01, "{size} of {expected}");
        }
        match made(&design, Step::OF_CURVES, 10.0, Some(Shaft { bore: 20.0, keyway: None })) {
            Ok(bytes) => {
                assert_closed(&read(&bytes), name);
                assert!(volume(&read(&bytes)) < size, "{name}");
            }
            Err(refusal) => assert_eq!((refusal, name), (Refusal::NoShaft, "wedge")),
        }
    }
}
