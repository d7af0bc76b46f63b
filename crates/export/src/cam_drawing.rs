//! The cam with its follower at θ = 0, drawn to scale as SVG.

mod legend;
mod look;

use crate::curves::{Curve, Role, Shape, curves, profile, room};
use crate::follower_drawing::{Outline, follower};
use crate::paper::{Bounds, scale_for};
use crate::svg::{escaped, short, through};
use crate::{Refusal, Shaft, Step, Subject};
use legend::{LEAST_WIDTH, has_name, legend_height};
use levalab_core::Point;
use look::{OUTLINE, class, stroke};
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
        let title = escaped(&subject.design().title);
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
        let fill = if curve.role == Role::Bore { "#ffffff" } else { "none" };
        let paint = format!("class=\"{}\" fill=\"{fill}\" {}", class(curve.role), stroke(curve));
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
        let arm = 0.3 * subject.design().base_radius;
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
}
