//! Claims about sentences.

use super::*;
use levalab_core::{
    Analysis, Closure, Column, ExpressionFault, ExpressionProblem, FindingKind, Instead, LAWS, Level, Misfit,
    RoughnessCause,
};
use levalab_format::measured::{Curve, MeasuredProblem};
use levalab_format::{
    CamRefusal, DataRefusal, JsonFault, Kind, Measure, Path, Price, Problem, ProgramRefusal, cures, example,
};

fn report(name: &str) -> (Design, Report) {
    let design = example(name).expect(name);
    let report = report_of(&design);
    (design, report)
}

fn report_of(design: &Design) -> Report {
    let cam = design.cam().expect("a cam");
    Report::of(design, &cam, &Analysis::of(&cam, 1))
}

fn finding_of(kind: FindingKind) -> DesignFinding {
    let places = vec![120.0, 240.0];
    DesignFinding {
        kind,
        level: kind.severity(Closure::Force),
        theta: 120.0,
        interval: Some([350.0, 370.0]),
        places,
        value: Some(-12.345),
        limit: Some(30.0),
    }
}

const KINDS: [FindingKind; 18] = [
    FindingKind::Jump(0),
    FindingKind::Jump(1),
    FindingKind::Jump(2),
    FindingKind::Jump(3),
    FindingKind::PressureAngle,
    FindingKind::Cusp,
    FindingKind::Undercut,
    FindingKind::ConcaveFlat,
    FindingKind::BelowBase,
    FindingKind::Doubtful,
    FindingKind::NotProved(0),
    FindingKind::NotProved(3),
    FindingKind::SelfCrossing,
    FindingKind::ArmCutsCam,
    FindingKind::PivotInsideCam,
    FindingKind::FaceOvertaken,
    FindingKind::ContactPastPivot,
    FindingKind::GrooveUndercut,
];

fn problems() -> Vec<Problem> {
    let measure = Measure::Degrees;
    vec![
        Problem::FileTooLarge { bytes: 2_000_000, limit: 1_048_576 },
        Problem::NotText,
        Problem::TitleInvisible,
        Problem::NotJson { line: 3, column: 7, fault: JsonFault::Syntax },
        Problem::NotJson { line: 3, column: 7, fault: JsonFault::End },
        Problem::NotJson { line: 3, column: 7, fault: JsonFault::DecimalComma },
        Problem::NotJson { line: 3, column: 7, fault: JsonFault::Surrogate },
        Problem::NotJson { line: 3, column: 7, fault: JsonFault::Depth },
        Problem::DecimalComma { found: "1,5".to_owned() },
        Problem::NotFinite,
        Problem::WrongKind { found: Kind::Null, expected: Kind::Number },
        Problem::Missing,
        Problem::UnknownField { expected: vec!["law", "beta", "rise"] },
        Problem::DuplicateField,
        Problem::WrongWord { found: "a\nb".to_owned(), expected: vec!["mm", "cm"] },
        Problem::WrongWord { found: "levalab".to_owned(), expected: vec!["levalab/1"] },
        Problem::NewerFormat { found: "levalab/3".to_owned() },
        Problem::Program(ProgramRefusal::TooManyPoints { found: 2049, limit: 2048 }),
        Problem::OutOfRange { found: 361.0, min: 0.001, max: 360.0, measure },
        Problem::NotBetween { found: 90.0, min: -90.0, max: 90.0, measure },
        Problem::NotPositive { found: -3.0, measure: Measure::Length },
        Problem::TitleTooLong { found: 65, limit: 64 },
        Problem::TitleCharacter { found: '\u{202e}', position: 3 },
        Problem::Program(ProgramRefusal::NoSegments),
        Problem::Program(ProgramRefusal::TooManySegments { found: 65, limit: 64 }),
        Problem::Join(levalab_core::JoinProblem::Nothing),
        Problem::Join(levalab_core::JoinProblem::TooMany),
        Problem::Join(levalab_core::JoinProblem::Place),
        Problem::Join(levalab_core::JoinProblem::Overlap { other: 0 }),
        Problem::Join(levalab_core::JoinProblem::Clash { other: 0 }),
        Problem::Join(levalab_core::JoinProblem::Low),
        Problem::Join(levalab_core::JoinProblem::StartsHigh),
        Problem::Join(levalab_core::JoinProblem::NoWay),
        Problem::Program(ProgramRefusal::DwellRises { found: 1.5, measure }),
        DataRefusal::WrongOrder { found: 2.5 }.into(),
        DataRefusal::WrongCount { found: 0, min: 1, max: 24 }.into(),
        DataRefusal::WrongCount { found: 25, min: 1, max: 24 }.into(),
        DataRefusal::Repeated { other: 0 }.into(),
        DataRefusal::NoHeight.into(),
        DataRefusal::Dependent { items: vec![1] }.into(),
        DataRefusal::Dependent { items: vec![0, 2, 3] }.into(),
        DataRefusal::KnotCount { found: 2, expected: 0 }.into(),
        DataRefusal::KnotCount { found: 2, expected: 3 }.into(),
        DataRefusal::KnotOrder.into(),
        DataRefusal::KnotPlace { item: 6, from: 95.0, to: 99.0, measure }.into(),
        DataRefusal::NotAtEnd { found: 99.5, expected: 100.0, measure }.into(),
        DataRefusal::Unordered.into(),
        DataRefusal::Undefined { x: 0.25, cause: RoughnessCause::Power }.into(),
        DataRefusal::Undefined { x: 0.25, cause: RoughnessCause::Division }.into(),
        DataRefusal::Undefined { x: 0.25, cause: RoughnessCause::TooLarge }.into(),
        DataRefusal::Undefined { x: 0.25, cause: RoughnessCause::Edge }.into(),
        fault(ExpressionFault::Ends),
        fault(ExpressionFault::TooLong { limit: 512 }),
        fault(ExpressionFault::TooDeep),
        fault(ExpressionFault::Unexpected('\n')),
        fault(ExpressionFault::Unknown("y".to_owned())),
        fault(ExpressionFault::Open),
        fault(ExpressionFault::NoArgument("sin".to_owned())),
        fault(ExpressionFault::Number),
        DataRefusal::RiseDisagrees { found: 10.0, expected: 9.5, measure }.into(),
        Problem::Program(ProgramRefusal::AdjacentPolynomials { next: 2 }),
        Problem::Program(ProgramRefusal::Turn { found: 359.0, whole: 360.0, measure }),
        Problem::Program(ProgramRefusal::Turn { found: 170.0, whole: 180.0, measure }),
        Problem::Program(ProgramRefusal::Turn { found: 95.5, whole: 100.0, measure: Measure::Length }),
        Problem::Cam(CamRefusal::Unsuited { kind: "translating" }),
        Problem::Cam(CamRefusal::OffCentre { found: 3.0, measure: Measure::Length, kind: "constant-breadth" }),
        Problem::Cam(CamRefusal::Breadth { found: 60.0, base_radius: 30.0 }),
        Problem::Cam(CamRefusal::BreadthTravel { found: 9.0, travel: 10.0, breadth: 70.0, base_radius: 30.0 }),
        Problem::Cam(CamRefusal::Sides { found: 4.0, most: 31.0 }),
        Problem::Cam(CamRefusal::SharpArcs { found: 10.0, least: 42.26, half: 50.0 }),
        Problem::Cam(CamRefusal::TooClose { found: 70.0, least: 74.0 }),
        Problem::Cam(CamRefusal::SwingingApplication),
        Problem::OneOf { expected: vec!["angle", "base_radius"] },
        Problem::Program(ProgramRefusal::Closing { found: 0.1, measure }),
        Problem::Program(ProgramRefusal::Beginning { found: 5.0, measure }),
        Problem::Program(ProgramRefusal::BelowBase { found: -0.1, measure }),
        Problem::Misfit(Misfit::Eccentricity { eccentricity: 42.0, prime_radius: 42.0 }),
        Problem::Misfit(Misfit::Triangle { pivot_distance: 200.0, arm: 80.0, prime_radius: 50.0 }),
        Problem::Misfit(Misfit::FaceOutOfReach { pivot_distance: 30.0, needed: 40.0 }),
    ]
}

fn fault(kind: ExpressionFault) -> Problem {
    DataRefusal::Expression(ExpressionProblem { at: 3, kind }).into()
}

fn links() -> Vec<LinkError> {
    vec![
        LinkError::Empty,
        LinkError::TooLong(TooLong { found: 9000, limit: 8192 }),
        LinkError::Character { found: '%', position: 3 },
        LinkError::Damaged,
        LinkError::Version { found: "3".to_owned() },
        LinkError::Newer { found: "x".to_owned() },
        LinkError::Unreadable,
        LinkError::Design(DesignError {
            path: Path::from("segments"),
            problem: Problem::Program(ProgramRefusal::NoSegments),
        }),
    ]
}

/// One line, a capital or a figure first, a full stop last, no number of the wrong language, nothing unknown.
fn check(language: Language, sentence: &str) {
    assert!(sentence.ends_with('.') && !sentence.contains(['\n', '\r']), "{sentence:?}");
    assert!(!sentence.contains("..") && !sentence.contains("  ") && !sentence.contains('–'), "{sentence:?}");
    let foreign = if language == Language::Es { "12.3" } else { "12,3" };
    assert!(!sentence.contains(foreign), "{sentence:?}");
}

#[test]
fn sentences_are_one_line_each() {
    let designs = [example("9RT").expect("9RT"), example("2RO").expect("2RO")];
    for language in Language::ALL {
        for design in &designs {
            for found in KINDS.map(finding_of) {
                check(language, &finding(language, design, &found));
                for grows in [true, false] {
                    check(language, &cure(language, design, &found, &Remedy::BaseRadius { value: 43.3, grows }));
                }
                let eased = Remedy::Eccentricity { value: -12.34, pressure_angle: 31.0 };
                check(language, &cure(language, design, &found, &eased));
                for remaining_jump in [None, Some(Column::J), Some(Column::A)] {
                    let changes = vec![(0, LAWS[7]), (2, LAWS[7]), (3, LAWS[8])];
                    let price = Price {
                        pressure_angle: Some((36.0, 31.8)),
                        acceleration: Some(1.19),
                        lift: Some((13.4, 13.3)),
                    };
                    let laws = Remedy::Laws { changes, remaining_jump, price };
                    let told = cure(language, design, &found, &laws);
                    check(language, &told);
                    let words = if language == Language::En {
                        " (price: φ 31.8° → 36°, peak a × 1.19, lift "
                    } else {
                        " (a cambio: φ 31,8° → 36°, a máx. × 1,19, elevación "
                    };
                    assert!(told.contains(words), "{told}");
                }
                for key in ["arm", "pivot_distance"] {
                    check(language, &cure(language, design, &found, &Remedy::Length { key, value: 81.5 }));
                }
                for instead in [Instead::GentlerMotion, Instead::SmallerFaceAngle, Instead::SmoothMotion] {
                    for needed in [None, Some(1793.0)] {
                        check(language, &cure(language, design, &found, &Remedy::NoSize { needed, instead }));
                    }
                }
            }
        }
        for problem in problems() {
            check(language, &design_error(language, &DesignError { path: Path::default(), problem }));
        }
        for error in links() {
            check(language, &link_error(language, &error));
        }
        check(language, &too_long(language, TooLong { found: 2001, limit: 2000 }));
        check(language, link_from_query(language));
        for problem in [
            MeasuredProblem::TooLarge { limit: 1 << 20 },
            MeasuredProblem::NotNumbers { line: 2 },
            MeasuredProblem::NoValue { line: 2, column: 3 },
            MeasuredProblem::Unordered { line: 4, found: 12.25, before: 60.5 },
            MeasuredProblem::TooManyPoints { found: 8193, limit: 8192 },
            MeasuredProblem::TooFewPoints { found: 1 },
            MeasuredProblem::Columns,
        ] {
            check(language, &measured_problem(language, &problem));
        }
        let curve = Curve { points: Vec::new(), first: 12.25, is_completed: true, is_in_radians: true };
        check(language, &measured_note(language, &curve));
        let untouched = Curve { first: 0.0, is_completed: false, is_in_radians: false, ..curve };
        assert_eq!(measured_note(language, &untouched), "");
    }
}

#[test]
fn a_cam_that_travels_is_told_in_its_own_units_and_turns_nowhere() {
    let wedge = example("WEDGE").expect("WEDGE");
    for kind in KINDS {
        let [en, es] = Language::ALL.map(|language| finding(language, &wedge, &finding_of(kind)));
        if !matches!(kind, FindingKind::FaceOvertaken) {
            assert!(!en.contains("turns") && !en.contains("circle") && !en.contains("/rad"), "{en}");
            assert!(!es.contains("gira") && !es.contains("circunferencia") && !es.contains("/rad"), "{es}");
        }
    }
    let told = |order: u8| finding(Language::En, &wedge, &finding_of(FindingKind::Jump(order)));
    assert!(told(3).contains("12.34\u{a0}1/mm² at") || told(3).contains("12.35\u{a0}1/mm² at"), "{}", told(3));
    assert!(told(2).contains("\u{a0}1/mm at"), "{}", told(2));
    assert!(told(1).contains(" at ") && !told(1).contains("/mm"), "{}", told(1));
    assert!(told(3).ends_with("harmless when the cam travels slowly, vibration when it travels fast."), "{}", told(3));
}

#[test]
fn headlines_name_each_reason_once() {
    let (_, mut report) = report("9RT");
    report.findings = KINDS[2..8].iter().chain(&KINDS[2..4]).copied().map(finding_of).collect();
    report.level = Level::Unacceptable;
    assert_eq!(
        headline(Language::En, &report),
        "Unacceptable: the acceleration jumps, the pressure angle is too large, the profile has a cusp, the profile is undercut \
         and the flat face cannot follow the profile."
    );
    let (_, good) = self::report("2RO");
    check(Language::En, &headline(Language::En, &good));
    check(Language::Es, &headline(Language::Es, &good));
}

#[test]
fn the_pressure_angle_of_a_textbook_is_told_with_its_cure() {
    let mut design = example("9RT").expect("9RT");
    design.base_radius = 25.0;
    let cam = design.cam().expect("a cam");
    let analysis = Analysis::of(&cam, 1);
    let report = Report::of(&design, &cam, &analysis);
    let steep = report.findings.iter().position(|finding| finding.kind == FindingKind::PressureAngle).expect("steep");
    let found = &report.findings[steep];
    assert_eq!(
        finding(Language::En, &design, found),
        "The pressure angle reaches 34.3° at 296.2°, above the 30° that a translating follower tolerates."
    );
    assert_eq!(
        finding(Language::Es, &design, found),
        "El ángulo de presión llega a 34,3° en 296,2°, por encima de los 30° que tolera un seguidor de traslación."
    );
    let told: Vec<String> = cures(&design, &cam, &analysis)[steep]
        .iter()
        .map(|cured| cure(Language::Es, &design, found, &cured.remedy))
        .collect();
    assert!(
        told.iter()
            .any(|sentence| sentence.starts_with("Con Rb ≥ 3") && sentence.ends_with("mm se mantiene por debajo.")),
        "{told:?}"
    );
}

#[test]
fn numbers_agree_with_their_nouns() {
    let told = |language, found| {
        let problem = Problem::Program(ProgramRefusal::Turn { found, whole: 360.0, measure: Measure::Degrees });
        design_error(language, &DesignError { path: Path::default(), problem })
    };
    assert_eq!(told(Language::Es, 359.0), "Los tramos suman 359°: falta 1° para una vuelta completa.");
    assert_eq!(told(Language::Es, 370.0), "Los tramos suman 370°: sobran 10° para una vuelta completa.");
    assert_eq!(told(Language::En, 359.5), "The segments add up to 359.5°, 0.5° too few for a whole turn.");
    let (_, mut report) = report("9RT");
    report.findings[0].places.truncate(1);
    assert_eq!(headline(Language::En, &report), "Not for high speeds: the jerk jumps at one joint.");
}

#[test]
fn a_cam_that_lifts_nothing_is_said_not_to_move() {
    let mut design = example("9RT").expect("9RT");
    design.segments.iter_mut().for_each(|segment| segment.rise = 0.0);
    let cam = design.cam().expect("a cam");
    let report = Report::of(&design, &cam, &Analysis::of(&cam, 1));
    assert!(headline(Language::En, &report).contains("nothing moves"), "{}", headline(Language::En, &report));
    assert!(headline(Language::Es, &report).contains("nada se mueve"), "{}", headline(Language::Es, &report));
}

#[test]
fn what_is_said_of_the_second_cam_goes_on_in_its_sentence() {
    let said = of_second_cam(Language::En, "Unacceptable: the pressure angle is too large.");
    assert_eq!(said, "Second cam, unacceptable: the pressure angle is too large.");
    assert_eq!(of_second_cam(Language::Es, "Aceptable: todo va bien."), "Segunda leva, aceptable: todo va bien.");
}

#[test]
fn a_jump_is_told_by_angle_and_by_time_in_the_units_of_its_follower() {
    let mut design = example("9RT").expect("9RT");
    design.speed.value = 100.0;
    let mut jump = finding_of(FindingKind::Jump(2));
    (jump.value, jump.interval) = (Some(2.5), None);
    jump.level = Level::Unacceptable;
    let told = |design: &Design, language| {
        let by_time = finding_by_time(language, design, &jump).expect("a derivative");
        [finding(language, design, &jump), by_time]
    };
    let omega = design.omega();
    let [by_angle, by_time] = told(&design, Language::En);
    assert!(by_angle.contains("2.5\u{a0}mm/rad² at"), "{by_angle}");
    assert!(by_time.contains(&format!("{}\u{a0}mm/s² at", Language::En.number(2.5 * omega * omega))), "{by_time}");
    let [by_angle, by_time] = told(&design, Language::Es);
    assert!(by_angle.contains("2,5\u{a0}mm/rad²") && by_time.contains("\u{a0}mm/s²"), "{by_angle} {by_time}");
    let [by_angle, by_time] = told(&example("2RO").expect("2RO"), Language::En);
    assert!(by_angle.contains("2.5°/rad²") && by_time.contains("°/s²"), "{by_angle} {by_time}");
    for kind in KINDS.into_iter().filter(|kind| !matches!(kind, FindingKind::Jump(1..))) {
        assert_eq!(finding_by_time(Language::En, &design, &finding_of(kind)), None, "{kind:?}");
    }
}
