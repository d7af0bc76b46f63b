//! Drawings of known cams stay as they are.

#[path = "../../../tests/support/golden.rs"]
mod golden;

use levalab_export::{CamDrawing, DiagramChoice, Keyway, Refusal, Shaft, Subject, cam_svg, diagram_svg, png};
use levalab_format::{Design, Study, example};
use levalab_words::Language;

/// Drawings have three decimals; sines are not the same on all machines.
const TOLERANCE: f64 = 0.0021;

const A4: CamDrawing = CamDrawing { room: Some([180.0, 200.0]), check: true, shaft: None };

fn drawn(design: &Design, language: Language, options: &CamDrawing) -> String {
    let study = Study::without_columns(design.clone()).expect("a good design");
    cam_svg(&Subject { study: &study, language }, options).expect("it can be drawn")
}

fn compare(name: &str, drawn: &str) {
    let kept = golden::kept(name, drawn);
    golden::assert_same(name, &golden::pieces(&kept), &golden::pieces(drawn), TOLERANCE);
}

#[test]
fn cams_in_true_scale() {
    let file = CamDrawing::default();
    compare("9RT-cam", &drawn(&example("9RT").expect("9RT"), Language::Es, &A4));
    compare("2RO-cam", &drawn(&example("2RO").expect("2RO"), Language::En, &file));
    compare("4PO-cam", &drawn(&example("4PO").expect("4PO"), Language::Es, &file));
    let shaft = Some(Shaft { bore: 20.0, keyway: Some(Keyway { width: 6.0, depth: 2.8 }) });
    compare("10EX-cam-bored", &drawn(&example("10EX").expect("10EX"), Language::En, &CamDrawing { shaft, ..file }));
}

#[test]
fn a_cam_that_is_larger_than_the_paper_tells_its_scale() {
    let design = example("R1").expect("R1");
    assert!(drawn(&design, Language::Es, &A4).contains("Escala 1:5"));
    assert!(drawn(&design, Language::Es, &CamDrawing::default()).contains("Escala 1:1"));
    let nine = example("9RT").expect("9RT");
    assert!(drawn(&nine, Language::En, &A4).contains("Scale 1:1"));
}

#[test]
fn a_title_is_text_in_every_drawing() {
    let mut design = example("9RT").expect("9RT");
    design.title = "</title><script>1</script> & \"50%\"".to_owned();
    let study = Study::without_columns(design.clone()).expect("a good design");
    let subject = Subject { study: &study, language: Language::En };
    let diagram = diagram_svg(&subject, DiagramChoice::Svaj, false).expect("it can be drawn");
    for svg in [drawn(&design, Language::En, &A4), diagram] {
        assert!(!svg.contains("<script") && svg.contains("&lt;script&gt;1&lt;/script&gt; &amp; &quot;50%&quot;"));
        png(&svg, 300).expect("it is still a drawing");
    }
}

#[test]
fn a_picture_is_as_wide_as_it_was_asked_to_be_and_not_empty() {
    let design = example("R6").expect("R6");
    let study = Study::without_columns(design.clone()).expect("R6");
    let subject = Subject { study: &study, language: Language::Es };
    let made: Vec<_> = DiagramChoice::all().into_iter().map(|choice| diagram_svg(&subject, choice, true)).collect();
    assert_eq!(made.iter().filter(|made| made.is_err()).count(), 1, "a roller has no contact that walks");
    let mut drawings: Vec<String> = made.into_iter().flatten().collect();
    drawings.push(drawn(&design, Language::Es, &CamDrawing::default()));
    for svg in drawings {
        let bytes = png(&svg, 640).expect("a picture");
        assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n") && bytes[16..20] == 640_u32.to_be_bytes());
        assert!(bytes.len() > 6_000, "there is next to nothing on it: {} bytes", bytes.len());
    }
    assert!(png("no drawing", 100).is_err());
}

#[test]
fn what_the_follower_drives_is_drawn_with_the_points_to_hit_by_angle_or_against_time() {
    let of = |name: &str, per_second: bool| {
        let study = Study::without_columns(example(name).expect(name)).expect(name);
        let subject = Subject { study: &study, language: Language::En };
        diagram_svg(&subject, DiagramChoice::Application, per_second)
    };
    let (by_angle, by_time) = (of("R6", false).expect("R6"), of("R6", true).expect("R6"));
    for said in [">F</tspan> force (lbf)", ">p</tspan> pressure (psi)", "126.2"] {
        assert!(by_angle.contains(said) && by_time.contains(said), "{said}");
    }
    assert!(by_angle.contains("360°") && !by_time.contains('°'), "seconds are no degrees");
    assert_eq!(of("9RT", false), Err(Refusal::NoApplication));
}
