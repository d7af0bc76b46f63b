//! What is drawn of any cam: finite, inside the plot, and where the plot area says it is.

#[path = "../../../tests/support/mod.rs"]
mod support;

use levalab_chart::{Diagram, PlotArea, Quantity, SUBPIXELS, Style, Timing, colour, draw, svg};
use levalab_core::{Analysis, Cam, Motion, Svaj};
use levalab_numbers::write::DecimalSign;
use plotters::prelude::IntoDrawingArea;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};
use proptest::prelude::*;
use std::cell::RefCell;
use std::rc::Rc;
use support::random;

/// A colour that nothing but the curve has.
const CURVE: &str = "#123456";

/// Width of a figure, in heights of the type; few fonts have wider ones.
const FIGURE: f64 = 0.64;

const UNITS: f64 = SUBPIXELS as f64;

fn quantity() -> impl Strategy<Value = Quantity> {
    prop::sample::select(&Quantity::ALL[..])
}

fn style() -> impl Strategy<Value = Style> {
    (200.0..1200.0, 40.0..400.0, 9.0..20.0, any::<bool>(), any::<bool>()).prop_map(
        |(width, height, font_size, x_labels, decimal_comma): (f64, f64, f64, bool, bool)| Style {
            width: width.round(),
            height: (height + 3.0 * font_size).round(),
            font_size,
            x_labels,
            decimal_sign: if decimal_comma { DecimalSign::Comma } else { DecimalSign::Point },
            curve: colour(CURVE).expect("a colour"),
            ..Style::default()
        },
    )
}

fn timing() -> impl Strategy<Value = Timing> {
    prop_oneof![Just(Timing::PerRadian), (0.01..1000.0).prop_map(Timing::PerSecond)]
}

/// Values of an attribute in all elements of a kind that have another text in them.
fn attributes<'a>(text: &'a str, tag: &'a str, with: &'a str, name: &str) -> Vec<&'a str> {
    let key = format!(" {name}=\"");
    let elements = text.split('<').filter(|element| element.starts_with(tag) && element.contains(with));
    elements.filter_map(|element| element.split_once(&key)?.1.split('"').next()).collect()
}

fn number(text: &str) -> f64 {
    let number: f64 = text.parse().unwrap_or_else(|_| panic!("{text} is a number"));
    assert!(number.is_finite());
    number
}

/// The points of the curve, in units.
fn curve(text: &str) -> Vec<(f64, f64)> {
    let own = format!("opacity=\"1\" stroke=\"{CURVE}\"");
    let lines = attributes(text, "polyline", &own, "points");
    let points = lines.iter().flat_map(|line| line.split_whitespace());
    points.map(|point| point.split_once(',').expect("x and y")).map(|(x, y)| (number(x), number(y))).collect()
}

/// Width of a character, in heights of the type.
fn width_of(character: char) -> f64 {
    match character {
        '\u{202f}' => 0.2,
        '\u{2212}' | '×' => 0.84,
        '0'..='9' => FIGURE,
        '.' | ',' => FIGURE / 2.0,
        _ => 0.42,
    }
}

/// Least and greatest value of a quantity within `reach` degrees of θ, looked at closely enough for half a wave in between.
fn around(quantity: Quantity, cam: &Cam, theta: f64, reach: f64) -> (f64, f64) {
    const PARTS: i32 = 64;
    let value = |motion: Svaj| match quantity {
        Quantity::S => motion.s,
        Quantity::V => motion.v,
        Quantity::A => motion.a,
        Quantity::J => motion.j,
        Quantity::PressureAngle => cam.follower.contact(motion).pressure_angle.to_degrees(),
        Quantity::Rho => cam.follower.profile_radius(cam.follower.contact(motion).bend),
        Quantity::Contact => cam.follower.contact(motion).reach,
    };
    let swings = cam.follower.kind().motion == Motion::Oscillating
        && !matches!(quantity, Quantity::PressureAngle | Quantity::Contact);
    within(cam, theta, reach, PARTS, |motion| if swings { value(motion).to_degrees() } else { value(motion) })
}

/// Least and greatest of what follows from the motion within `reach` degrees of θ, limits at joints included: each stretch is looked at in as many parts.
fn within(cam: &Cam, theta: f64, reach: f64, parts: i32, value: impl Fn(Svaj) -> f64) -> (f64, f64) {
    let (from, to) = ((theta - reach).to_radians(), (theta + reach).to_radians());
    let mut found = (f64::INFINITY, f64::NEG_INFINITY);
    for stretch in cam.program.stretches() {
        let (from, to) = (from.max(stretch.from), to.min(stretch.to));
        if from > to {
            continue;
        }
        for i in 0..=parts {
            let value = value(stretch.at(from + (to - from) * f64::from(i) / f64::from(parts)));
            found = (found.0.min(value), found.1.max(value));
        }
    }
    found
}

fn unit_of_x(area: &PlotArea) -> f64 {
    (area.x_max - area.x_min) / (area.width * UNITS)
}

fn unit_of_y(area: &PlotArea) -> f64 {
    (area.y_max - area.y_min) / (area.height * UNITS)
}

proptest! {
    #![proptest_config(random::cases(300))]

    #[test]
    fn everything_is_finite_and_inside(cam in random::cam(), quantity in quantity(), timing in timing(), style in style()) {
        let diagram = Diagram::of(quantity, &cam, &Analysis::of(&cam, 360), timing);
        let (text, area) = svg(&diagram, &style);
        prop_assert!(!text.contains("NaN") && !text.contains("inf"));
        prop_assert!(area.y_min < area.y_max && area.width > 0.0 && area.height > 0.0, "{area:?}");
        for (x, y) in curve(&text) {
            prop_assert!(x >= area.left * UNITS && x <= (area.left + area.width) * UNITS, "x = {x} in {area:?}");
            prop_assert!(y >= area.top * UNITS - 0.5 && y <= (area.top + area.height) * UNITS + 0.5, "y = {y} in {area:?}");
        }
    }

    #[test]
    fn other_cams_are_inside_too(cams in [random::cam(), random::cam()], quantity in quantity(), style in style()) {
        const OTHER: &str = "#654321";
        let analyses = cams.each_ref().map(|cam| Analysis::of(cam, 360));
        let both = [0, 1].map(|k| (&cams[k], &analyses[k], Timing::PerRadian));
        let diagram = Diagram::among(quantity, &both).expect("two cams");
        let others = vec![(colour(OTHER).expect("a colour"), vec![4.0, 2.0])];
        let (text, area) = svg(&diagram, &Style { others, ..style });
        prop_assert!(!text.contains("NaN") && !text.contains("inf"));
        prop_assert!(area.y_min < area.y_max, "{area:?}");
        let own = format!("opacity=\"1\" stroke=\"{OTHER}\"");
        let drawn = attributes(&text, "polyline", &own, "points");
        prop_assert!(!drawn.is_empty(), "the other cam is not drawn");
        for (x, y) in drawn.iter().flat_map(|line| line.split_whitespace()).filter_map(|point| point.split_once(',')) {
            let (x, y) = (number(x), number(y));
            prop_assert!(x >= area.left * UNITS && x <= (area.left + area.width) * UNITS, "x = {x} in {area:?}");
            prop_assert!(y >= area.top * UNITS - 0.5 && y <= (area.top + area.height) * UNITS + 0.5, "y = {y} in {area:?}");
        }
    }

    #[test]
    fn no_text_is_cut_off(cam in random::cam(), quantity in quantity(), timing in timing(), style in style()) {
        let diagram = Diagram::of(quantity, &cam, &Analysis::of(&cam, 360), timing);
        let (text, _) = svg(&diagram, &style);
        let em = style.font_size * UNITS;
        for element in text.split("<text").skip(1) {
            let element = format!("<text{element}");
            let of = |name| number(attributes(&element, "text", "", name)[0]);
            let label = element.split('>').nth(1).and_then(|rest| rest.split('<').next()).unwrap_or("").trim();
            let width = label.chars().map(width_of).sum::<f64>() * em;
            let before = match attributes(&element, "text", "", "text-anchor")[0] {
                "start" => 0.0,
                "middle" => width / 2.0,
                _ => width,
            };
            prop_assert!(of("x") - before >= 0.0 && of("x") - before + width <= style.width * UNITS + 1.0, "{label} at {}", of("x"));
            prop_assert!(of("y") >= 0.4 * em && of("y") <= style.height * UNITS - 0.3 * em, "{label} at {}", of("y"));
        }
    }

    #[test]
    fn points_lie_where_the_area_says(cam in random::cam(), quantity in quantity(), style in style()) {
        prop_assume!(quantity != Quantity::Rho);
        let diagram = Diagram::of(quantity, &cam, &Analysis::of(&cam, 720), Timing::PerRadian);
        let (text, area) = svg(&diagram, &style);
        for (x, y) in curve(&text) {
            let theta = area.x_min + (x - area.left * UNITS) * unit_of_x(&area);
            let value = area.y_max - (y - area.top * UNITS) * unit_of_y(&area);
            let (low, high) = around(quantity, &cam, theta, unit_of_x(&area));
            let slack = unit_of_y(&area);
            prop_assert!(low - slack <= value && value <= high + slack, "{value} at {theta}, but {low} … {high}");
        }
    }

    #[test]
    fn a_radius_is_drawn_between_its_neighbours(cam in random::cam(), style in style()) {
        let diagram = Diagram::of(Quantity::Rho, &cam, &Analysis::of(&cam, 720), Timing::PerRadian);
        let (text, area) = svg(&diagram, &style);
        let step = 0.5;
        let flat = cam.follower.is_flat();
        let bend = |rho: f64| if flat { rho } else { 1.0 / (rho + cam.follower.disc_radius()) };
        for (x, y) in curve(&text) {
            let theta = area.x_min + (x - area.left * UNITS) * unit_of_x(&area);
            let value = area.y_max - (y - area.top * UNITS) * unit_of_y(&area);
            let bends = [value - 2.0 * unit_of_y(&area), value + 2.0 * unit_of_y(&area)].map(bend);
            let (low, high) = around_bend(&cam, theta, step + unit_of_x(&area), bend);
            let (least, greatest) = (bends[0].min(bends[1]), bends[0].max(bends[1]));
            // The least and the greatest bend lie between the places looked at.
            let missed = 0.02 * (high - low);
            prop_assert!(greatest >= low - missed && least <= high + missed || least < 0.0 && greatest > 0.0, "{value} at {theta}: {bends:?} in {low} … {high}");
        }
    }
}

fn around_bend(cam: &Cam, theta: f64, reach: f64, bend: impl Fn(f64) -> f64) -> (f64, f64) {
    const PARTS: i32 = 16;
    within(cam, theta, reach, PARTS, |motion| bend(cam.follower.profile_radius(cam.follower.contact(motion).bend)))
}

/// Notes what is drawn and under which dashes.
#[derive(Clone, Default)]
struct Recorder(Rc<RefCell<Record>>);

#[derive(Default)]
struct Record {
    dash: Vec<f64>,
    paths: Vec<(Vec<f64>, Vec<BackendCoord>)>,
    texts: Vec<String>,
    outside: usize,
}

/// Device pixels of the surface, which has [`SUBPIXELS`] times as many units.
const SIZE: (u32, u32) = (420 * 2, 110 * 2);

type Done = Result<(), DrawingErrorKind<std::io::Error>>;

impl Recorder {
    fn note(&self, (x, y): BackendCoord) {
        let within = |place: i32, most: u32| u32::try_from(place).is_ok_and(|place| place <= most * SUBPIXELS);
        let inside = within(x, SIZE.0) && within(y, SIZE.1);
        self.0.borrow_mut().outside += usize::from(!inside);
    }
}

impl DrawingBackend for Recorder {
    type ErrorType = std::io::Error;

    fn get_size(&self) -> (u32, u32) {
        SIZE
    }

    fn ensure_prepared(&mut self) -> Done {
        Ok(())
    }

    fn present(&mut self) -> Done {
        Ok(())
    }

    fn draw_pixel(&mut self, _: BackendCoord, _: BackendColor) -> Done {
        unreachable!("nothing is drawn pixel by pixel")
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, _: &S) -> Done {
        let path: Vec<BackendCoord> = path.into_iter().collect();
        path.iter().for_each(|&at| self.note(at));
        let dash = self.0.borrow().dash.clone();
        self.0.borrow_mut().paths.push((dash, path));
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, _: &S, _: bool) -> Done {
        self.note(from);
        self.note(to);
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, _: &S) -> Done {
        path.into_iter().for_each(|at| self.note(at));
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, _: u32, _: &S, _: bool) -> Done {
        self.note(centre);
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, _: &S, at: BackendCoord) -> Done {
        self.note(at);
        self.0.borrow_mut().texts.push(text.to_owned());
        Ok(())
    }
}

#[test]
fn any_backend_draws_the_same_and_is_told_the_dashes() {
    let rows = [("parabolic", 180.0, 10.0), ("parabolic", 180.0, -10.0)];
    let given = [("roller_radius", 7.0)];
    let follower = support::follower("translating-roller", 35.0, &given, support::ROTATIONS[0]);
    let cam = Cam::new(support::lengths(&rows), follower);
    let diagram = Diagram::of(Quantity::A, &cam, &Analysis::of(&cam, 720), Timing::PerRadian);
    let style = Style { width: 420.0, height: 110.0, pixel_ratio: 2.0, dash: vec![4.0, 2.5], ..Style::default() };
    let recorder = Recorder::default();
    let record = Rc::clone(&recorder.0);
    let area = draw(&recorder.into_drawing_area(), &diagram, &style, |dash| record.borrow_mut().dash = dash.to_vec())
        .expect("drawn");
    let record = record.borrow();
    assert_eq!(record.outside, 0, "all within the drawing");
    assert_eq!(record.dash, [], "full lines again at the end");
    let dashed: Vec<_> = record.paths.iter().filter(|(dash, _)| dash == &[64.0, 40.0]).collect();
    let furthest = dashed.iter().flat_map(|(_, path)| path).map(|at| at.0).max().unwrap_or(0);
    assert_eq!(f64::from(furthest), (area.left + area.width) * 2.0 * UNITS, "the curve goes on to 360°");
    assert_eq!(dashed.len(), 3, "the curve breaks at 90° and 270°, where the acceleration jumps, and nowhere else");
    let (text, same) = svg(&diagram, &style);
    assert_eq!(area, same, "one layout at any pixel ratio");
    for label in &record.texts {
        assert!(text.contains(&format!(">\n{label}\n<")), "{label}");
    }
}

#[test]
fn a_sheet_shows_exactly_its_heights_with_and_without_a_curve() {
    let style = Style { width: 600.0, height: 200.0, curve: colour(CURVE).expect("a colour"), ..Style::default() };
    let (empty, area) = svg(&Diagram::sheet(None, -0.5, 26.0), &style);
    assert_eq!((area.x_min, area.x_max, area.y_min, area.y_max), (0.0, 360.0, -0.5, 26.0));
    assert!(curve(&empty).is_empty());
    let lines = |text: &str| text.matches("<line").count() + text.matches("<polyline").count();
    assert!(lines(&empty) > 12, "it is ruled at every label");

    let segments = [("cycloidal", 180.0, 20.0), ("cycloidal", 180.0, -20.0)];
    let segments = segments.map(|(law, beta, rise)| levalab_core::Segment::of(law, beta, rise).expect("a segment"));
    let follower = levalab_core::Follower::translating_roller(40.0, 10.0);
    let cam = Cam::new(levalab_core::Program::new(&segments).expect("a program"), follower.expect("a follower"));
    let analysis = Analysis::of(&cam, 360);
    for high in [26.0, 15.0] {
        let (text, area) = svg(&Diagram::sheet(Some((&cam, &analysis)), 0.0, high), &style);
        assert_eq!(area.y_max, high);
        let top = area.top * UNITS;
        let highest = curve(&text).into_iter().map(|(_, y)| y).fold(f64::INFINITY, f64::min);
        let expected = (area.top + area.height * (1.0 - 20.0_f64.min(high) / high)) * UNITS;
        assert!((highest - expected.max(top)).abs() <= UNITS, "{highest} is not {expected}");
    }
}

#[test]
fn a_bump_between_two_rows_is_drawn_to_its_extremes() {
    let expression = "5*(1-cos(theta))+1*exp(-((theta-2.2034781806)/0.001)^2)";
    let law = levalab_core::Law::by_id("formula").expect("it is one of the laws");
    let data = levalab_core::law::Data::Expression(expression.to_owned());
    let segment = levalab_core::Segment { data, ..levalab_core::Segment::new(law, std::f64::consts::TAU, 0.0) };
    let program = levalab_core::Program::new(&[segment]).expect("a formula of one turn");
    let cam = Cam::new(
        program,
        support::follower(
            "translating-roller",
            40.0,
            &[("roller_radius", 10.0)],
            levalab_core::Rotation::CounterClockwise,
        ),
    );
    let analysis = Analysis::of(&cam, 720);
    let diagram = Diagram::of(Quantity::A, &cam, &analysis, Timing::PerRadian);
    let (text, area) = svg(
        &diagram,
        &Style { width: 600.0, height: 200.0, curve: colour(CURVE).expect("a colour"), ..Style::default() },
    );
    let extremes = analysis.summary.a;
    assert!(area.y_min <= extremes.min && extremes.max <= area.y_max, "{extremes:?} in {area:?}");
    let heights = || curve(&text).into_iter().map(|(_, y)| y);
    let drawn = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
    let whole = (extremes.max - extremes.min) / unit_of_y(&area);
    assert!((drawn - whole).abs() < 0.01 * whole, "{drawn} of {whole}");
}
