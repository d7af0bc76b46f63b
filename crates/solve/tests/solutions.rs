//! The solutions of the textbook cases hold the figures of the books, and no design is without a solution.

use levalab_format::testing::{Random, design};
use levalab_format::{EXAMPLES, Study, example};
use levalab_solve::{Block, Document, Request, Symbols, latex, markdown, page, solve};
use levalab_words::Language;

fn request(language: Language) -> Request {
    Request { language, ..Request::default() }
}

fn solution(name: &str, request: &Request) -> String {
    let worked = Study::without_columns(example(name).expect(name)).expect(name);
    markdown(&solve(&worked, request), request.language)
}

fn holds(name: &str, text: &str, figures: &[&str]) {
    for figure in figures {
        assert!(text.contains(figure), "{name} lacks {figure}");
    }
}

#[test]
fn r1_derives_both_quintics_and_judges_the_cam() {
    let text = solution("R1", &request(Language::En));
    holds(
        "R1",
        &text,
        &[
            "s = 0.6 x^{3} - 0.8 x^{4} + 0.3 x^{5}",
            "s = 0.2 + 0.15 x - 2.9 x^{3} + 4.2 x^{4} - 1.65 x^{5}",
            "c_{0} = 0.2,\\quad c_{1} = 0.15,\\quad c_{2} = 0",
            "x = 0.5273",
            "251.18^\\circ",
            "v = -0.18831\\,\\mathrm{m/rad}",
            "V = -1.1832\\,\\mathrm{m/s}",
            "s & = 0.2",
            "0.111365\\,\\mathrm{m}",
            "\\varphi = -30.37^\\circ",
            "0.29665\\,\\mathrm{m}",
            "Unacceptable: the pressure angle is too large.",
        ],
    );
    let spanish = solution("R1", &request(Language::Es));
    holds("R1", &spanish, &["-0{,}18831", "-30{,}37^\\circ", "Tramo 3", "Inaceptable"]);
}

#[test]
fn r4_joins_its_cubic_by_the_quintic_of_the_book() {
    let text = solution("R4", &request(Language::En));
    holds("R4", &text, &["s = 0.05 + 0.06 x + 0.024 x^{2} + 0.068 x^{3} - 0.198 x^{4} + 0.096 x^{5}", "0.05 x^{3}"]);
    let at = Request { theta: Some(315.0), ..request(Language::En) };
    holds(
        "R4",
        &solution("R4", &at),
        &["-0.12732\\,\\mathrm{m/rad}", "-0.26667\\,\\mathrm{m/s}", "0.18402\\,\\mathrm{m}"],
    );
}

#[test]
fn r6_finds_its_six_coefficients_and_its_extremes() {
    let text = solution("R6", &request(Language::En));
    holds(
        "R6",
        &text,
        &[
            "c_{3} = 612.72",
            "c_{4} = -4057.26",
            "c_{5} = 10696.57",
            "c_{6} = -13873.37",
            "c_{7} = 8822.47",
            "c_{8} = -2201.13",
            "1.34689\\,\\mathrm{in}",
            "74.39^\\circ",
            "22.55\\,\\mathrm{in/s}",
            "-21.571\\,\\mathrm{in/s}",
            "685.53\\,\\mathrm{in/s^2}",
            "-594.22\\,\\mathrm{in/s^2}",
            "26.57^\\circ",
            "-25.74^\\circ",
        ],
    );
}

#[test]
fn r6_tells_the_force_on_the_heel_and_the_error_at_each_measured_point() {
    let text = solution("R6", &request(Language::En));
    holds(
        "R6",
        &text,
        &[
            "What the follower drives: force of a piston on enclosed fluid",
            "A_{\\mathrm{p}} = \\pi r^{2} = \\pi \\cdot 0.75^{2} = 1.7671\\,\\mathrm{in^2}",
            "K = k_{\\mathrm{V}} A_{\\mathrm{p}}^{2} = 30 \\cdot 1.76715^{2} = 93.684\\,\\mathrm{lbf/in}",
            "126.183\\,\\mathrm{lbf}",
            "*Points to hit*",
            "| $56.88^\\circ$ | $0.079002$ | $110.282$ | $110.282$ |",
        ],
    );
    holds(
        "R6",
        &solution("R6", &request(Language::Es)),
        &["Lo que mueve el seguidor", "Puntos que alcanzar", "126{,}183"],
    );
}

#[test]
fn r2_r3_and_r5_give_the_figures_that_the_books_misprint() {
    let at = |theta: f64| Request { theta: Some(theta), ..request(Language::En) };
    holds("R2", &solution("R2", &at(120.0)), &["\\varphi = 26.24^\\circ", "0.16\\,\\mathrm{m/s}", "0.076394"]);
    holds("R3", &solution("R3", &at(330.0)), &["V = v \\omega = \\left(-0.11459\\right)", "-0.24\\,\\mathrm{cm/s}"]);
    holds("R3", &solution("R3", &at(150.0)), &["12.1\\,\\mathrm{cm}"]);
    holds(
        "R5",
        &solution("R5", &request(Language::En)),
        &["1029.6\\,\\mathrm{mm/s}", "48185\\,\\mathrm{mm/s^2}", "y = 1 - 2 \\left(1 - x\\right)^{2}"],
    );
}

#[test]
fn a_wedge_is_straight_where_it_is_steepest() {
    let text = solution("WEDGE", &request(Language::En));
    holds("WEDGE", &text, &["a = 0", "= \\infty", "The profile is straight there."]);
    assert!(!text.contains("10^{1"), "rounding is printed as a number");
}

#[test]
fn a_law_is_derived_once_and_rounding_is_no_number() {
    let text = solution("12PO", &request(Language::En));
    assert_eq!(text.matches("For $\\frac{1}{8} \\le x").count(), 1, "the trapezoids of six segments are one law");
    holds("12PO", &text, &["are those of segment 1.", "= 0 \\Rightarrow \\varphi = 0^\\circ", "| $0^\\circ$ | kept |"]);
    assert!(!text.contains("10^{-"), "rounding is printed as a number");
    let third = solution("12PO", &Request { segment: Some(2), ..request(Language::En) });
    assert!(
        third.contains("For $\\frac{1}{8} \\le x") && !third.contains("those of segment"),
        "alone it is written out"
    );
    let arcs = solution("ARCS", &request(Language::En));
    holds("ARCS", &arcs, &["s = 39.88499 - 39.88499 \\cos"]);
}

/// Every writer writes it, balanced, and nothing is left in it that the reader should not see.
fn written(name: &str, document: &Document, language: Language) {
    let markdown = markdown(document, language);
    let latex = latex(document, language);
    let page = page(document, language);
    for (text, what) in [(&markdown, "Markdown"), (&latex, "LaTeX")] {
        assert!(!text.contains("NaN"), "{name}: NaN in {what}");
        let depth = text.replace("\\{", "").replace("\\}", "").chars().fold(0_i64, |depth, c| match c {
            '{' => depth + 1,
            '}' => depth - 1,
            _ => depth,
        });
        assert_eq!(depth, 0, "{name}: braces of {what}");
        assert_eq!(text.matches("\\left").count(), text.matches("\\right").count(), "{name}: fences of {what}");
        assert_eq!(text.matches("\\begin{").count(), text.matches("\\end{").count(), "{name}: environments of {what}");
    }
    for tag in ["math", "mrow", "mfrac", "msup", "mtable", "table", "td", "p", "h3"] {
        let opened = page.matches(&format!("<{tag}>")).count() + page.matches(&format!("<{tag} ")).count();
        assert_eq!(opened, page.matches(&format!("</{tag}>")).count(), "{name}: {tag}");
    }
    assert!(!page.contains("NaN") && !page.contains("{}"), "{name}");
    if language == Language::Es {
        let numbers = page.split("<mn>").skip(1).filter_map(|rest| rest.split('<').next());
        assert!(numbers.into_iter().all(|number| !number.contains('.')), "{name}: a decimal point in Spanish");
    }
}

#[test]
fn every_example_has_its_solution_in_both_languages_and_by_every_writer() {
    for (name, _) in EXAMPLES {
        let worked = Study::without_columns(example(name).expect(name)).expect(name);
        for language in Language::ALL {
            let document = solve(&worked, &request(language));
            written(name, &document, language);
            assert!(document.blocks.len() > 20, "{name}: {}", document.blocks.len());
            for segment in 0..worked.segments() {
                let one = Request { segment: Some(segment), ..request(language) };
                written(name, &solve(&worked, &one), language);
            }
        }
    }
}

#[test]
fn random_designs_have_their_solutions() {
    let mut random = Random::new(4_710);
    for round in 0..120 {
        let design = design(&mut random);
        let name = format!("round {round}: {}", design.to_json());
        let worked = Study::without_columns(design).expect("a design that passes every check");
        let language = *random.pick(&Language::ALL);
        let theta = (!random.once_in(3)).then(|| random.between(-400.0, 800.0));
        let segment = random.once_in(2).then(|| random.below(worked.segments()));
        let document = solve(&worked, &Request { language, theta, segment, symbols: Symbols::default() });
        written(&name, &document, language);
    }
}

#[test]
fn another_notation_is_written_throughout() {
    let worked = Study::without_columns(example("R1").expect("R1")).expect("R1");
    let symbols = Symbols::new(vec![("R_b", "r_0".into()), ("φ", "α".into())]);
    let document = solve(&worked, &Request { symbols, ..Request::default() });
    let text = markdown(&document, Language::En);
    assert!(!text.contains("\\varphi") && !text.contains("R_{\\mathrm{b}}") && text.contains("\\alpha = -30.37"));
    assert!(document.blocks.iter().any(|block| matches!(block, Block::Formula(_))));
}
