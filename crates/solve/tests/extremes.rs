//! The worked solution names every extreme of its segments, also on the borders between the pieces of a law and as the limit from one side.

use levalab_format::{Design, Study, example};
use levalab_solve::{Request, markdown, solve};
use levalab_words::Language;

/// A design of a radial roller with these segments.
fn design(segments: &str) -> Design {
    let text = format!(
        r#"{{"format":"levalab/1","cam":{{"kind":"rotating","base_radius":100}},
        "follower":{{"motion":"translating","contact":"roller","roller_radius":10}},"segments":[{segments}]}}"#
    );
    Design::from_json(&text).expect("a design")
}

fn solution(design: Design, request: &Request) -> String {
    markdown(&solve(&Study::without_columns(design).expect("a cam"), request), request.language)
}

/// A rise of 10 mm over 90° by a law, a dwell, the fall, a dwell.
fn rise_and_fall(law: &str) -> Design {
    design(&format!(
        r#"{{"law":"{law}","beta":90,"rise":10}},{{"law":"dwell","beta":90}},
        {{"law":"{law}","beta":90,"rise":-10}},{{"law":"dwell","beta":90}}"#
    ))
}

/// The rows of the table of extremes inside the first segment, each as its cells.
fn rows(text: &str) -> Vec<Vec<String>> {
    let table = text.split("*Extreme values inside the segment*").nth(1).expect("a table of extremes");
    let table = table.split("\n#").next().expect("its section");
    let rows = table.lines().filter(|row| row.starts_with("| ") && !row.starts_with("| where") && !row.contains("---"));
    rows.map(|row| row.trim_matches('|').split('|').map(|cell| cell.trim().replace('$', "")).collect()).collect()
}

fn has(name: &str, rows: &[Vec<String>], reason: &str, x: &str, extreme: &str) {
    let found = rows.iter().any(|row| row[0].contains(reason) && row[1] == x && row[3].contains(extreme));
    assert!(found, "{name} lacks {reason} at x = {x} with {extreme}: {rows:#?}");
}

#[test]
fn the_modified_sine_has_its_peaks_at_the_borders_of_its_pieces() {
    // 5.528 L/β², with L = 10 and β = π/2.
    let rows = rows(&solution(rise_and_fall("modified-sine"), &Request::default()));
    has("modified sine", &rows, "j = 0", "0.125", "a = 22.404");
    has("modified sine", &rows, "j = 0", "0.875", "a = -22.404");
    has("modified sine", &rows, "a = 0", "0.5", "v = 11.202");
}

#[test]
fn parabolic_and_cubic_turn_at_the_middle() {
    // v = 2 L/β where a jumps from + to −.
    let parabolic = rows(&solution(rise_and_fall("parabolic"), &Request::default()));
    has("parabolic", &parabolic, "a changes its sign", "0.5", "v = 12.732");
    // a = ±12 L/β² on the two sides of the middle, v = 3 L/β.
    let cubic = rows(&solution(rise_and_fall("cubic-1"), &Request::default()));
    has("cubic", &cubic, "a changes its sign", "0.5", "v = 19.099");
    has("cubic", &cubic, "a jumps (limit from the left)", "0.5", "a = 48.634");
    has("cubic", &cubic, "a jumps (limit from the right)", "0.5", "a = -48.634");
}

#[test]
fn a_level_peak_has_two_places() {
    // The modified trapezoidal keeps a = 4.888 L/β² from x = 1/8 to 3/8.
    let rows = rows(&solution(rise_and_fall("modified-trapezoidal"), &Request::default()));
    has("modified trapezoidal", &rows, "j = 0", "0.125 to 0.375", "a = 19.81");
    has("modified trapezoidal", &rows, "j = 0", "0.625 to 0.875", "a = -19.81");
    has("modified trapezoidal", &rows, "a = 0", "0.5", "v = 12.732");
}

#[test]
fn an_asymmetric_law_has_its_peak_of_velocity_at_the_crossover() {
    let design = design(
        r#"{"law":"asymmetric-3-4-5","beta":100,"rise":10,"crossover":0.4},{"law":"dwell","beta":60},
        {"law":"cycloidal","beta":150,"rise":-10},{"law":"dwell","beta":50}"#,
    );
    let rows = rows(&solution(design, &Request::default()));
    has("asymmetric 3-4-5", &rows, "a = 0", "0.4", "v = 10.743");
}

#[test]
fn no_law_that_turns_is_said_not_to() {
    for law in ["parabolic", "cubic-1", "cubic-2", "modified-sine", "modified-trapezoidal", "simple-harmonic"] {
        for language in Language::ALL {
            let text = solution(rise_and_fall(law), &Request { language, ..Request::default() });
            assert!(!text.contains("no derivative changes") && !text.contains("ninguna derivada cambia"), "{law}");
        }
    }
}

#[test]
fn the_place_of_numbers_is_a_limit_from_the_left_where_velocity_jumps_down() {
    // s = ±10 (1 − cos(πx/2)) over 90°: |v| grows up to 10 mm/rad at its end, where a dwell begins.
    let inside = r#"{"law":"half-harmonic-start","beta":90,"rise":10},{"law":"dwell","beta":90},{"law":"cycloidal","beta":180,"rise":-10}"#;
    let text = solution(design(inside), &Request::default());
    for figure in
        ["at $\\theta = 90^\\circ$", "segment 1, with $x = 1$", "limits from the left", "= 10\\,\\mathrm{mm/rad}"]
    {
        assert!(text.contains(figure), "lacks {figure}");
    }
    // The same at the end of the turn, where θ = 0 has v = 0.
    let last = r#"{"law":"cycloidal","beta":180,"rise":10},{"law":"dwell","beta":90},{"law":"half-harmonic-start","beta":90,"rise":-10}"#;
    let text = solution(design(last), &Request::default());
    let figures = [
        "at $\\theta = 360^\\circ$",
        "segment 3, with $x = 1$",
        "limits from the left",
        "= -10\\,\\mathrm{mm/rad}",
        "$360^\\circ$ (limit from the left)",
    ];
    for figure in figures {
        assert!(text.contains(figure), "lacks {figure}");
    }
}

#[test]
fn a_segment_alone_is_looked_at_up_to_its_end_by_its_own_formulas() {
    let segments = r#"{"law":"half-cycloidal-start","beta":60,"rise":5},{"law":"constant-velocity","beta":60,"rise":10},
        {"law":"half-cycloidal-end","beta":60,"rise":5},{"law":"dwell","beta":60},{"law":"cycloidal","beta":120,"rise":-20}"#;
    let text = solution(design(segments), &Request { segment: Some(0), ..Request::default() });
    for figure in ["at $\\theta = 60^\\circ$", "It lies in segment 1, with $x = 1$.", "limits from the left"] {
        assert!(text.contains(figure), "lacks {figure}");
    }
}

#[test]
fn a_follower_that_rests_has_no_place_of_maximum_velocity() {
    let mut design = example("9RT").expect("9RT");
    design.segments.iter_mut().for_each(|segment| segment.rise = 0.0);
    let text = solution(design, &Request::default());
    assert!(text.contains("The follower never moves") && !text.contains("is greatest in the cycle"), "{text}");
}
