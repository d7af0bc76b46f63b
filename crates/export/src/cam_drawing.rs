//! The cam with its follower at θ = 0, drawn to scale as SVG.

use crate::curves::{Curve, Role, Shape, curves, profile, room};
use crate::follower_drawing::{Outline, follower};
use crate::paper::{Bounds, scale_for, scale_name};
use crate::svg::{escaped, short, through};
use crate::words::Word;
use crate::{Refusal, Shaft, Step, Subject};
use levalab_core::Point;
use levalab_words::Signs;
use std::fmt::Write;

/// What the drawing is for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CamDrawing {
    /// Width and height of the paper that it has to fit on, mm; any, and then in true scale, when not given.
    pub room: Option<[f64; 2]>,
    /// A line of 100 mm to check the printer by.
    pub check: bool,
    /// The hole for the shaft.
    pub shaft: Option<Shaft>,
}

/// Around everything, mm.
const MARGIN: f64 = 4.0;

/// Size of the type, mm.
const TYPE: f64 = 3.2;

/// From line to line, mm.
const LINE: f64 = 5.0;

/// Room for the line of 100 mm, mm.
const CHECK: f64 = 12.0;

/// The least width, which its words need and the line of 100 mm, mm.
const LEAST_WIDTH: f64 = 108.0;

/// From this width on, the names of the lines stand in two columns, mm.
const TWO_COLUMNS: f64 = 165.0;

/// Width of a visible outline, mm (ISO 128); other lines are half as wide.
const OUTLINE: f64 = 0.5;

const INK: &str = "#16191d";

/// The outline of the second cam of a pair.
const SECOND: &str = "#8a5300";

/// The look of a line, the same as on the page: its colour and its dashes, mm.
fn look(role: Role) -> (&'static str, &'static str) {
    match role {
        Role::Profile | Role::Outer | Role::Bore => ("#2b3238", ""),
        Role::Pitch => ("#0068a4", "1 1"),
        Role::Base => ("#6a737b", "2.4 1.3"),
        Role::Prime => ("#8a6d3b", "3.7 1 0.7 1"),
    }
}

/// The drawing as SVG text. It is as large as the cam, in millimetres, or in a scale that is told on it.
///
/// # Errors
/// When there is no room for the shaft.
pub fn cam_svg(subject: &Subject, options: &CamDrawing) -> Result<String, Refusal> {
    let curves = curves(subject, Step::OF_CURVES, options.shaft);
    if let Some(shaft) = options.shaft {
        shaft.check(subject, room(&curves))?;
    }
    let follower = follower(subject.cams(), reach(subject, &curves));
    let parts = curves.iter().filter(|curve| curve.role == Role::Profile).flat_map(|curve| curve.part(subject));
    let bounds = follower.iter().fold(bounds(&curves).with(parts), |bounds, outline| bounds.with(outline.corners()));
    let names = curves.iter().filter(|curve| has_name(curve)).count();
    Ok(Sheet::new(subject, options, bounds, names).draw(subject, &curves, &follower))
}

/// The measure of the follower: the greatest radius of the cams, or half of what a cam that travels is long.
fn reach(subject: &Subject, curves: &[Curve]) -> f64 {
    if subject.travels() { subject.size() } else { profile(curves).map(|point| point.norm()).fold(0.0, f64::max) }
}

/// The second cam of a pair is told by its profile and its base circle.
fn has_name(curve: &Curve) -> bool {
    match curve.role {
        Role::Bore => false,
        Role::Profile | Role::Base => true,
        Role::Outer | Role::Pitch | Role::Prime => !curve.second,
    }
}

fn bounds(curves: &[Curve]) -> Bounds {
    curves.iter().fold(Bounds::NONE, |bounds, curve| match &curve.shape {
        Shape::Closed(points) | Shape::Open(points) => bounds.with(points.iter().copied()),
        Shape::Circle(radius) => bounds.with_disc(Point::new(0.0, 0.0), *radius),
    })
}

/// Where everything goes on the paper.
///
/// Lengths are millimetres times `pen`: on a drawing as large as a table, lines and type are as much larger.
struct Sheet {
    pen: f64,
    width: f64,
    height: f64,
    /// Of the centre of the cam.
    origin: Point,
    /// Of paper, to the unit of the design.
    per_unit: f64,
    scale: f64,
    legend: f64,
    check: bool,
}

/// Width of the paper for which lines and type are made, mm.
const USUAL: f64 = 220.0;

impl Sheet {
    fn new(subject: &Subject, options: &CamDrawing, bounds: Bounds, names: usize) -> Self {
        let mm = subject.millimetres();
        let (wide, tall) = (bounds.width() * mm, bounds.height() * mm);
        let scale = options.room.map_or(1.0, |[width, height]| {
            let words = legend_height(LEAST_WIDTH, names, options.check);
            scale_for(wide, tall, [width - 2.0 * MARGIN, height - 3.0 * MARGIN - words])
        });
        let pen = (wide.max(tall) * scale / USUAL).max(1.0);
        let pen = if options.room.is_some() { 1.0 } else { pen };
        let per_unit = mm * scale / pen;
        let drawn = bounds.width() * per_unit + 2.0 * MARGIN;
        let width = drawn.max(LEAST_WIDTH);
        let legend = legend_height(width, names, options.check);
        let left = MARGIN + (width - drawn) / 2.0;
        Self {
            pen,
            width,
            height: bounds.height() * per_unit + 3.0 * MARGIN + legend,
            origin: Point::new(left - bounds.low.re * per_unit, MARGIN + bounds.high.im * per_unit),
            per_unit,
            scale,
            legend,
            check: options.check,
        }
    }

    fn at(&self, point: Point) -> Point {
        self.origin + point.conj() * self.per_unit
    }

    fn draw(&self, subject: &Subject, curves: &[Curve], follower: &[Outline]) -> String {
        let title = escaped(&subject.design.title);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\" \
             fill=\"none\" stroke-linejoin=\"round\" font-family=\"sans-serif\" font-size=\"{TYPE}\">\n<title>{title}</title>\n",
            short(self.width * self.pen),
            short(self.height * self.pen),
            short(self.width),
            short(self.height)
        );
        // The first cam lies over the second, the follower over both, and the lines over all.
        let part = |curve: &&Curve| matches!(curve.role, Role::Profile | Role::Outer);
        let mut bodies: Vec<&Curve> = curves.iter().filter(part).collect();
        bodies.sort_by_key(|curve| (!curve.second, curve.role == Role::Profile));
        for curve in bodies {
            self.body(&mut text, curve, subject);
        }
        self.follower(&mut text, follower);
        for curve in curves.iter().filter(|curve| !part(curve)).chain(curves.iter().filter(part)) {
            self.curve(&mut text, curve);
        }
        self.axes(&mut text, subject);
        self.legend(&mut text, subject, curves, &title);
        text + "</svg>\n"
    }

    /// What a profile bounds, without its outline; a groove is left white.
    fn body(&self, text: &mut String, curve: &Curve, subject: &Subject) {
        let fill = match (curve.role, curve.second) {
            (Role::Outer, _) => "#ffffff",
            (_, false) => "#dfe4e8",
            (_, true) => "#f0e8da",
        };
        let data = through(curve.part(subject).iter().map(|point| self.at(*point)), true);
        // Writing into a String cannot fail.
        let _ = writeln!(text, "<path class=\"body\" fill=\"{fill}\" fill-opacity=\"0.8\" d=\"{data}\"/>");
    }

    fn curve(&self, text: &mut String, curve: &Curve) {
        let (colour, dash) = look(curve.role);
        let solid = dash.is_empty();
        let width = if solid { OUTLINE } else { OUTLINE / 2.0 };
        let fill = if curve.role == Role::Bore { "#ffffff" } else { "none" };
        let dash = if solid { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
        let colour = if curve.second && solid { SECOND } else { colour };
        let paint = format!(
            "class=\"{}\" fill=\"{fill}\" stroke=\"{colour}\" stroke-width=\"{width}\"{dash}",
            class(curve.role)
        );
        let _ = match &curve.shape {
            Shape::Closed(points) | Shape::Open(points) => {
                let closed = matches!(curve.shape, Shape::Closed(_));
                writeln!(text, "<path {paint} d=\"{}\"/>", through(points.iter().map(|point| self.at(*point)), closed))
            }
            Shape::Circle(radius) => self.circle(text, &paint, Point::new(0.0, 0.0), *radius),
        };
    }

    fn circle(&self, text: &mut String, paint: &str, centre: Point, radius: f64) -> std::fmt::Result {
        let (centre, radius) = (self.at(centre), radius * self.per_unit);
        writeln!(
            text,
            "<circle {paint} cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
            short(centre.re),
            short(centre.im),
            short(radius)
        )
    }

    fn follower(&self, text: &mut String, follower: &[Outline]) {
        let line = OUTLINE / 2.0;
        for outline in follower {
            let paint = match outline {
                Outline::Ground(_) => {
                    format!("class=\"ground\" fill=\"#f0f1f2\" stroke=\"#6a737b\" stroke-width=\"{line}\"")
                }
                _ => format!("class=\"follower\" fill=\"#ffffff\" stroke=\"#2b3238\" stroke-width=\"{line}\""),
            };
            let _ = match outline {
                Outline::Part(points) | Outline::Ground(points) => {
                    writeln!(
                        text,
                        "<path {paint} d=\"{}\"/>",
                        through(points.iter().map(|point| self.at(*point)), true)
                    )
                }
                Outline::Disc(centre, radius) => self.circle(text, &paint, *centre, *radius),
            };
        }
    }

    /// The cross at the cam's centre, in the lines of axes.
    fn axes(&self, text: &mut String, subject: &Subject) {
        if subject.travels() {
            return;
        }
        let arm = 0.3 * subject.design.base_radius;
        let ends = [Point::new(arm, 0.0), Point::new(0.0, arm)];
        for end in ends {
            let data = through([self.at(-end), self.at(end)], false);
            let _ = writeln!(
                text,
                "<path class=\"axis\" stroke=\"#6a737b\" stroke-width=\"{}\" stroke-dasharray=\"4 1 1 1\" d=\"{data}\"/>",
                OUTLINE / 2.0
            );
        }
    }

    /// What each line is, the scale, and the line to check it by.
    fn legend(&self, text: &mut String, subject: &Subject, curves: &[Curve], title: &str) {
        let said = |word: Word| word.said(subject.language);
        let mut y = self.height - self.legend;
        let caption = format!("{title} · {} {}", said(Word::Scale), scale_name(self.scale));
        self.words(text, MARGIN, y, &caption, "font-weight=\"bold\"");
        let mut entries: Vec<&Curve> = curves.iter().filter(|curve| has_name(curve)).collect();
        entries.sort_by_key(|curve| (curve.second, order(curve.role)));
        let columns = columns(self.width);
        let column = (self.width - 2.0 * MARGIN) / columns as f64;
        for (k, curve) in entries.into_iter().enumerate() {
            let x = MARGIN + column * (k % columns) as f64;
            if k % columns == 0 {
                y += LINE;
            }
            let (colour, dash) = look(curve.role);
            let colour = if curve.second && dash.is_empty() { SECOND } else { colour };
            let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
            let width = if dash.is_empty() { OUTLINE } else { OUTLINE / 2.0 };
            let sample = through([Point::new(x, y - 1.0), Point::new(x + 9.0, y - 1.0)], false);
            let _ = writeln!(text, "<path stroke=\"{colour}\" stroke-width=\"{width}\"{dash} d=\"{sample}\"/>");
            self.words(text, x + 11.0, y, &name(subject, curve), "");
        }
        if self.check {
            self.check_line(text, said(Word::Check));
        }
    }

    fn check_line(&self, text: &mut String, words: &str) {
        let y = self.height - 7.0;
        let mut data = through([Point::new(MARGIN, y), Point::new(MARGIN + 100.0, y)], false);
        for k in 0..=10 {
            let x = MARGIN + 10.0 * f64::from(k);
            let tick = if k % 5 == 0 { 2.4 } else { 1.4 };
            data += &through([Point::new(x, y), Point::new(x, y - tick)], false);
        }
        let _ =
            writeln!(text, "<path class=\"check\" stroke=\"{INK}\" stroke-width=\"{}\" d=\"{data}\"/>", OUTLINE / 2.0);
        self.words(text, MARGIN, y + LINE, words, "");
    }

    fn words(&self, text: &mut String, x: f64, y: f64, words: &str, look: &str) {
        let space = if look.is_empty() { "" } else { " " };
        let _ =
            writeln!(text, "<text x=\"{}\" y=\"{}\" fill=\"{INK}\"{space}{look}>{words}</text>", short(x), short(y));
    }
}

/// Columns in which the names of the lines stand.
fn columns(width: f64) -> usize {
    if width < TWO_COLUMNS { 1 } else { 2 }
}

/// Height of the words under the drawing: the title, then the names of the lines.
fn legend_height(width: f64, names: usize, check: bool) -> f64 {
    let lines = 1 + names.div_ceil(columns(width));
    lines as f64 * LINE + if check { CHECK } else { 0.0 }
}

/// The place of a line in the list of names.
fn order(role: Role) -> usize {
    [Role::Profile, Role::Outer, Role::Pitch, Role::Base, Role::Prime]
        .iter()
        .position(|known| *known == role)
        .unwrap_or(0)
}

fn class(role: Role) -> &'static str {
    match role {
        Role::Profile => "profile",
        Role::Outer => "outer-wall",
        Role::Pitch => "pitch-curve",
        Role::Base => "base-circle",
        Role::Prime => "prime-circle",
        Role::Bore => "bore",
    }
}

/// The name of a curve, with its radius when it is a circle.
fn name(subject: &Subject, curve: &Curve) -> String {
    let language = subject.language;
    let word = match curve.role {
        Role::Profile => Word::Profile,
        Role::Outer => Word::OuterWall,
        Role::Pitch => Word::PitchCurve,
        Role::Base if subject.travels() => Word::BaseLine,
        Role::Base => Word::BaseCircle,
        Role::Prime => Word::PrimeCircle,
        Role::Bore => Word::Bore,
    };
    let radius = match curve.shape {
        Shape::Circle(radius) => {
            let symbol = if curve.role == Role::Prime { "R_p" } else { "R_b" };
            let symbol = Signs::of(subject.design.notation).plain(symbol);
            format!(", {symbol} = {} {}", language.number(radius), subject.design.length_unit.symbol())
        }
        Shape::Closed(_) | Shape::Open(_) => String::new(),
    };
    let name = format!("{}{radius}", word.said(language));
    if curve.second { format!("{}: {}", levalab_words::second_cam(language), name) } else { name }
}
