//! Tables as other programs read them: the workbook by a reader that shares nothing with the writer, CSV cell by cell.

use calamine::{Data, Range, Reader, Xlsx, open_workbook_from_rs};
use levalab_core::{Analysis, Column};
use levalab_export::{Separator, Step, Subject, Table, csv, xlsx};
use levalab_format::report::column;
use levalab_format::{Design, EXAMPLES, Study, example};
use levalab_words::Language;
use std::io::Cursor;

/// Tables have twelve digits.
const TOLERANCE: f64 = 1e-11;

fn with_subject<T>(design: &Design, language: Language, look: impl FnOnce(&Subject) -> T) -> T {
    let study = Study::without_columns(design.clone()).expect("a good design");
    look(&Subject { study: &study, language })
}

fn sheets(design: &Design, language: Language, step: Step) -> Vec<(String, Range<Data>)> {
    let bytes = with_subject(design, language, |subject| xlsx(subject, step)).expect("a workbook");
    let mut book: Xlsx<_> = open_workbook_from_rs(Cursor::new(bytes)).expect("it opens");
    book.worksheets()
}

fn numbers(range: &Range<Data>, column: u32) -> Vec<f64> {
    let rows = range.height() as u32;
    let cell = |row| match range.get_value((row, column)) {
        Some(Data::Float(value)) => *value,
        other => panic!("row {row}, column {column}: {other:?} is no number"),
    };
    (1..rows).map(cell).collect()
}

fn assert_near(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let scale = expected.iter().fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()));
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!((found - expected).abs() <= TOLERANCE * scale, "{what}[{k}]: {found}, not {expected}");
    }
}

#[test]
fn a_workbook_has_a_sheet_for_each_group_in_the_language() {
    let names = |name: &str, language| -> Vec<String> {
        let design = example(name).expect(name);
        sheets(&design, language, Step::OF_TABLES).into_iter().map(|(name, _)| name).collect()
    };
    assert_eq!(
        names("9RT", Language::En),
        ["Design", "Motion", "Profile (polar)", "Profile (cartesian)", "Pitch curve", "Verdict"]
    );
    assert_eq!(
        names("9RT", Language::Es),
        ["Diseño", "Movimiento", "Perfil (polares)", "Perfil (cartesianas)", "Curva de paso", "Veredicto"]
    );
    assert!(!names("10EX", Language::En).contains(&"Pitch curve".to_owned()), "a flat face has no pitch curve");
}

#[test]
fn numbers_in_the_workbook_are_those_of_the_analysis() {
    for (name, _) in EXAMPLES {
        let design = example(name).expect(name);
        let cam = design.cam().expect(name);
        let step = Step::of_degrees(2.5).expect("it divides the turn");
        let analysis = Analysis::of(&cam, step.count());
        let of = |which| column(&design, &analysis, which).expect(name);
        let sheets = sheets(&design, Language::Es, step);
        let motion = &sheets[1].1;
        for (at, which) in [Column::Theta, Column::S, Column::V, Column::A, Column::J].into_iter().enumerate() {
            // The time stands second.
            let at = if at == 0 { 0 } else { at as u32 + 1 };
            assert_near(&numbers(motion, at), &of(which), &format!("{name} {}", which.name()));
        }
        let omega = design.omega();
        let travels = design.kind.travel().is_some();
        let turn = |place: &f64| if travels { *place } else { place.to_radians() };
        let times: Vec<f64> = of(Column::Theta).iter().map(|place| turn(place) / omega).collect();
        assert_near(&numbers(motion, 1), &times, &format!("{name} t"));
        let accelerations: Vec<f64> = of(Column::A).iter().map(|a| a * omega * omega).collect();
        assert_near(&numbers(motion, 7), &accelerations, &format!("{name} A"));
        let (x, y) = (of(Column::X), of(Column::Y));
        let named = |name: &str| sheets.iter().find(|(known, _)| known == name).map(|(_, sheet)| sheet);
        let cartesian = named("Perfil (cartesianas)").expect(name);
        assert_near(&numbers(cartesian, 1), &x, &format!("{name} x"));
        assert_near(&numbers(cartesian, 2), &y, &format!("{name} y"));
        let Some(polar) = named("Perfil (polares)") else {
            assert!(travels, "{name}");
            continue;
        };
        let (angles, radii) = (numbers(polar, 1), numbers(polar, 2));
        for k in 0..x.len() {
            let (sin, cos) = angles[k].to_radians().sin_cos();
            let near = 1e-9 * radii[k];
            assert!((radii[k] * cos - x[k]).abs() < near && (radii[k] * sin - y[k]).abs() < near, "{name}[{k}]");
        }
    }
}

#[test]
fn an_application_has_a_sheet_with_its_targets_and_its_rows() {
    let design = example("R6").expect("R6");
    let sheets = sheets(&design, Language::En, Step::of_degrees(10.0).expect("it divides the turn"));
    let (name, sheet) = sheets.last().expect("a sheet");
    assert_eq!(name, "Application");
    let row_of = |text: &str| -> Vec<Data> {
        let found = sheet.rows().find(|row| matches!(&row[0], Data::String(cell) if cell == text));
        found.unwrap_or_else(|| panic!("{text} in {sheet:?}")).to_vec()
    };
    let number = |cell: &Data| if let Data::Float(value) = cell { *value } else { panic!("{cell:?} is no number") };
    assert!((number(&row_of("Stiffness K")[1]) - 93.684).abs() < 5e-4);
    assert_eq!(row_of("Stiffness K")[2], Data::String("lbf/in".to_owned()));
    assert!((number(&row_of("Force F (lbf)")[3]) - 126.1825).abs() < 5e-4);
    let hit = sheet.rows().find(|row| row[0] == Data::Float(56.88)).expect("a target");
    assert!((number(&hit[3]) - number(&hit[2]) - number(&hit[4])).abs() < 1e-11 && number(&hit[4]).abs() < 0.005);
    let last: Vec<f64> = sheet.rows().next_back().expect("rows")[..4].iter().map(number).collect();
    assert!(last[0] == 360.0 && (last[1] * 12.566).to_degrees() - 360.0 < 1e-9 && last[2] == 0.0, "{last:?}");
    // Everything in one table has the outputs too, and a design without an application lacks the sheet.
    let of = |table| {
        with_subject(&design, Language::Es, |subject| csv(subject, table, Step::OF_TABLES, Separator::Semicolon))
    };
    assert!(
        of(Table::Everything)
            .lines()
            .next()
            .is_some_and(|heads| heads.ends_with("\"Fuerza F (lbf)\";\"Presión p (psi)\""))
    );
    assert!(!of(Table::Motion).contains("Fuerza"));
    assert!(of(Table::Application).starts_with("\u{feff}\"Fuerza de un pistón sobre fluido encerrado\"\r\n"));
}

#[test]
fn text_in_the_workbook_never_becomes_a_formula() {
    let mut design = example("9RT").expect("9RT");
    design.title = "=1+1".to_owned();
    let sheets = sheets(&design, Language::En, Step::OF_TABLES);
    assert_eq!(sheets[0].1.get_value((1, 1)), Some(&Data::String("=1+1".to_owned())));
}

#[test]
fn the_design_sheet_tells_the_whole_design() {
    let design = example("2RO").expect("2RO");
    let sheets = sheets(&design, Language::Es, Step::OF_TABLES);
    let design = &sheets[0].1;
    let row = |name: &str| {
        design.rows().find(|row| row[0] == Data::String(name.to_owned())).unwrap_or_else(|| panic!("no {name}"))
    };
    assert_eq!(row("Radio base Rb")[1..3], [Data::Float(40.0), Data::String("mm".to_owned())]);
    assert_eq!(row("Brazo A")[1], Data::Float(80.0));
    assert_eq!(row("Ángulo de la articulación ψ")[2], Data::String("°".to_owned()));
    let third = design.rows().find(|row| row[0] == Data::Float(3.0)).expect("three segments");
    assert_eq!(third[1..5], [Data::String("Polinómica 4-5-6-7".into()), 240.0.into(), 120.0.into(), (-10.0).into()]);
}

#[test]
fn csv_opens_right_where_its_language_is_spoken() {
    let design = example("R1").expect("R1");
    let cam = design.cam().expect("R1");
    let analysis = Analysis::of(&cam, 36);
    let step = Step::of_degrees(10.0).expect("it divides the turn");
    let s = column(&design, &analysis, Column::S).expect("s");
    for (language, separator, delimiter, sign) in
        [(Language::Es, Separator::Semicolon, ';', ','), (Language::En, Separator::Comma, ',', '.')]
    {
        assert_eq!(Separator::of(language), separator);
        let text = with_subject(&design, language, |subject| csv(subject, Table::Everything, step, separator));
        let text = text.strip_prefix('\u{feff}').expect("the mark that spreadsheets look for");
        let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(delimiter).collect()).collect();
        assert_eq!(rows.len(), 38, "a head, and both ends of the turn");
        // A head may hold a comma, and is then in quotes.
        assert!(rows[1..].iter().all(|row| row.len() == 20), "{text}");
        let third = |row: &Vec<&str>| -> f64 {
            assert!(!row[2].contains(if sign == ',' { '.' } else { ',' }));
            row[2].replace(sign, ".").parse().expect("a number")
        };
        assert_near(&rows[1..].iter().map(third).collect::<Vec<_>>(), &s, "s");
    }
}

#[test]
fn a_title_that_is_a_formula_is_text_in_csv() {
    let mut design = example("9RT").expect("9RT");
    for (title, cell) in [
        ("=HYPERLINK(1)", "\"'=HYPERLINK(1)\""),
        ("@a", "\"'@a\""),
        ("a;b \"c\"", "\"a;b \"\"c\"\"\""),
        ("a;=HYPERLINK(\"http://b\")", "\"a;'=HYPERLINK(\"\"http://b\"\")\""),
    ] {
        design.title = title.to_owned();
        let text = with_subject(&design, Language::Es, |subject| {
            csv(subject, Table::Design, Step::OF_TABLES, Separator::Semicolon)
        });
        assert!(text.contains(&format!("\"Título\";{cell};\"\"\r\n")), "{text}");
    }
}

#[test]
fn every_text_in_csv_is_in_quotes_and_no_number_is() {
    for (name, _) in EXAMPLES {
        let design = example(name).expect(name);
        for (table, separator) in
            Table::ALL.into_iter().flat_map(|table| [(table, Separator::Comma), (table, Separator::Semicolon)])
        {
            let text = with_subject(&design, Language::En, |subject| csv(subject, table, Step::OF_TABLES, separator));
            let (delimiter, decimal) = if separator == Separator::Comma { (',', '.') } else { (';', ',') };
            let mut quoted = false;
            let mut bare = String::new();
            for c in text.trim_start_matches('\u{feff}').chars() {
                if c == '"' {
                    quoted = !quoted;
                } else if !quoted {
                    bare.push(c);
                }
            }
            let cells = bare.lines().flat_map(|line| line.split(delimiter));
            for cell in cells.filter(|cell| !cell.is_empty()) {
                assert!(
                    cell.replace(decimal, ".").parse::<f64>().is_ok_and(f64::is_finite),
                    "{name} {}: {cell}",
                    table.name()
                );
            }
        }
    }
}

#[test]
fn every_table_has_rows_or_does_not_apply() {
    for (name, _) in EXAMPLES {
        let design = example(name).expect(name);
        for table in Table::ALL {
            let text =
                with_subject(&design, Language::En, |subject| csv(subject, table, Step::OF_TABLES, Separator::Comma));
            let applies = match table {
                Table::Pitch => design.cam().is_ok_and(|cam| !cam.follower.is_flat()),
                Table::Polar => design.kind.travel().is_none(),
                Table::Application => design.application.is_some(),
                _ => true,
            };
            assert_eq!(text.lines().count() > 1, applies, "{name} {}", table.name());
        }
    }
}

#[test]
fn the_extremes_of_a_cam_with_hollows_are_its_sharpest_places() {
    let design = example("9RT").expect("9RT");
    let text =
        with_subject(&design, Language::En, |subject| csv(subject, Table::Verdict, Step::OF_TABLES, Separator::Comma));
    let row = |name: &str| text.lines().find(|row| row.trim_start_matches('"').starts_with(name)).map(str::to_owned);
    let convex = row("Minimum convex radius of curvature ρ (mm)").expect("convex");
    let hollow = row("Tightest hollow ρ (mm)").expect("hollow");
    assert!(convex.contains(",11.256") && convex.contains(",283.3697"), "{convex}");
    assert!(hollow.contains(",-47.5") && hollow.contains(",307.8"), "{hollow}");
    // Two for each of the four hollows; the name has a comma of its own.
    assert_eq!(row("Inflections (θ, °)").expect("inflections").matches(',').count(), 9);
    assert!(row("Radius of curvature ρ (mm)").is_none() && !text.contains('∞'), "{text}");
}
