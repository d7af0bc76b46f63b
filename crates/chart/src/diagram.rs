//! A diagram as data: what there is to draw, in the units of its axes.

use crate::gather::{gather, place};
use crate::radius;
use crate::{Quantity, Timing};
use levalab_core::application::{ApplicationValues, Output, OutputLaw};
use levalab_core::{Analysis, Cam};
use std::f64::consts::TAU;
use std::ops::Range;

/// A quantity whose greatest value is this small beside the motion's own scale is zero, and what is left is rounding.
const NOTHING: f64 = 1e-9;

/// How far a limited quantity is shown, as a multiple of its limit: a little of what lies beyond is seen.
const BEYOND: f64 = 1.12;

/// How much is shown beyond the ends of a face, as a part of its length.
const BEYOND_FACE: f64 = 0.08;

/// A quantity over one turn, ready to be drawn at any size. θ in degrees, values in the units of the design.
#[derive(Clone, Debug)]
pub struct Diagram {
    pub(crate) quantity: Quantity,
    /// The points of all runs, one after another.
    pub(crate) points: Vec<Point>,
    pub(crate) runs: Vec<Run>,
    pub(crate) jumps: Vec<Jump>,
    /// The length of a cam that travels, whose places are lengths.
    pub(crate) travel: Option<f64>,
    /// Borders of the segments.
    pub(crate) borders: Vec<f64>,
    /// There is a line at every label of θ, as on paper to draw on.
    pub(crate) ruled: bool,
    /// Values that should not be passed.
    pub(crate) limits: Vec<f64>,
    /// Ranges of values beyond the limits.
    pub(crate) forbidden: Vec<(f64, f64)>,
    /// Points to hit.
    pub(crate) targets: Vec<Point>,
    /// Places worth a dot.
    pub(crate) extremes: Vec<Point>,
    pub(crate) extent: Extent,
    /// Radius of the follower's disc; none for a face.
    pub(crate) radius: Option<f64>,
    /// The same quantity of other cams, drawn behind.
    pub(crate) beside: Vec<Diagram>,
}

/// θ and a value.
pub(crate) type Point = (f64, f64);

/// A stretch of the curve without a break.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    /// Its points.
    pub points: Range<usize>,
    /// It comes in over the border of the plot.
    pub comes_in: bool,
    /// It goes out over the border of the plot.
    pub goes_out: bool,
}

/// A jump of the quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jump {
    pub theta: f64,
    pub before: f64,
    pub after: f64,
}

/// The values that the plot must show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub low: f64,
    pub high: f64,
    /// The curve goes on beyond: no margin is added, because the curve has been cut exactly here.
    pub cut: bool,
    /// There is nothing but zero, and the extent is arbitrary.
    pub empty: bool,
}

impl Extent {
    /// What shows both.
    fn with(self, other: Self) -> Self {
        match (self.empty, other.empty) {
            (true, false) => other,
            (false, true) => self,
            _ => Self {
                low: self.low.min(other.low),
                high: self.high.max(other.high),
                cut: self.cut || other.cut,
                empty: self.empty && other.empty,
            },
        }
    }
}

impl Diagram {
    /// Gathers a diagram. `analysis` must be that of `cam`; its rows are the points of the curve, and joints are added.
    #[must_use]
    pub fn of(quantity: Quantity, cam: &Cam, analysis: &Analysis, timing: Timing) -> Self {
        let mut diagram = Self::whole(quantity, cam, analysis, timing);
        diagram.cut();
        diagram
    }

    /// The same for several cams: the last in front, the others behind it in the looks that
    /// [`Style::others`](crate::Style::others) gives them. None without any.
    #[must_use]
    pub fn among(quantity: Quantity, cams: &[(&Cam, &Analysis, Timing)]) -> Option<Self> {
        let each = cams.iter().map(|&(cam, analysis, timing)| Self::whole(quantity, cam, analysis, timing));
        let mut diagrams: Vec<Self> = each.collect();
        let extent = diagrams.iter().map(|diagram| diagram.extent).reduce(Extent::with)?;
        for diagram in &mut diagrams {
            diagram.extent = extent;
            diagram.cut();
        }
        let front = diagrams.pop()?;
        Some(Self { beside: diagrams, ..front })
    }

    /// The displacement as a sheet to draw on: exactly the heights from `low` to `high` over a turn, ruled evenly, with the curve of a
    /// cam when there is one and no notes in the way.
    #[must_use]
    pub fn sheet(curve: Option<(&Cam, &Analysis)>, low: f64, high: f64) -> Self {
        let mut diagram = curve
            .map_or_else(Self::blank, |(cam, analysis)| Self::whole(Quantity::S, cam, analysis, Timing::PerRadian));
        diagram.borders.clear();
        diagram.ruled = true;
        diagram.extremes.clear();
        // What is cut off bends like a height, not like a radius.
        diagram.radius = None;
        diagram.extent = Extent { low, high, cut: true, empty: false };
        diagram.cut();
        diagram
    }

    /// No curve at all.
    fn blank() -> Self {
        Self {
            quantity: Quantity::S,
            points: Vec::new(),
            runs: Vec::new(),
            jumps: Vec::new(),
            travel: None,
            borders: Vec::new(),
            ruled: false,
            limits: Vec::new(),
            forbidden: Vec::new(),
            targets: Vec::new(),
            extremes: Vec::new(),
            extent: Extent { low: 0.0, high: 0.0, cut: false, empty: true },
            radius: None,
            beside: Vec::new(),
        }
    }

    /// An output of an application at ω, in the units of the design, with the points that it is to hit: place (as drawn) and value.
    #[must_use]
    pub fn of_output(
        output: &Output,
        values: &ApplicationValues,
        cam: &Cam,
        analysis: &Analysis,
        omega: f64,
        targets: &[(f64, f64)],
    ) -> Self {
        let (quantity, rate, of) = match output.law {
            OutputLaw::OfDisplacement(of) => (Quantity::S, 1.0, of),
            OutputLaw::OfVelocity(of) => (Quantity::V, omega, of),
        };
        let shown = |value: f64| of(values, value * rate);
        let mut diagram = gather(quantity, cam, analysis, &shown);
        diagram.targets = targets.to_vec();
        diagram.measure();
        diagram.allow_for_nothing(0.0);
        diagram.note_extremes(cam, analysis, &shown);
        diagram
    }

    /// The same against time, in seconds, for a cam that turns (or travels) at ω.
    #[must_use]
    pub fn against_time(mut self, omega: f64) -> Self {
        let whole = self.travel.unwrap_or(TAU);
        let unit = self.travel.map_or(1_f64.to_radians(), |_| 1.0) / omega;
        let places = self.points.iter_mut().chain(&mut self.extremes).chain(&mut self.targets);
        places.for_each(|point| point.0 *= unit);
        self.borders
            .iter_mut()
            .chain(self.jumps.iter_mut().map(|jump| &mut jump.theta))
            .for_each(|place| *place *= unit);
        self.travel = Some(whole / omega);
        self
    }

    /// Shows the ends of a face that is longer by `margin` at each end than the contact needs, and what lies beyond them.
    #[must_use]
    pub fn with_face(mut self, analysis: &Analysis, margin: f64) -> Self {
        let Some(contact) = analysis.summary.reach.filter(|_| self.quantity == Quantity::Contact) else { return self };
        let (low, high) = (contact.min - margin, contact.max + margin);
        self.limits.extend([low, high]);
        self.forbidden = vec![(f64::NEG_INFINITY, low), (high, f64::INFINITY)];
        let room = BEYOND_FACE * (high - low);
        self.extent = self.extent.with(Extent { low: low - room, high: high + room, cut: false, empty: false });
        self
    }

    fn whole(quantity: Quantity, cam: &Cam, analysis: &Analysis, timing: Timing) -> Self {
        let factor = quantity.factor(cam, timing);
        let shown = |value: f64| value * factor;
        let mut diagram = gather(quantity, cam, analysis, &shown);
        match quantity {
            Quantity::Rho => radius::finish(&mut diagram, cam, analysis),
            Quantity::PressureAngle => diagram.limit_angle(cam.follower.pressure_angle_limit().to_degrees()),
            _ => diagram.measure(),
        }
        if quantity != Quantity::Rho {
            let size = analysis.summary.s.greatest_size().0 * factor;
            diagram.allow_for_nothing(size);
            diagram.note_extremes(cam, analysis, &shown);
        }
        diagram
    }

    /// What it shows.
    #[must_use]
    pub fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// Leaves out what lies beyond the extent.
    fn cut(&mut self) {
        if self.extent.cut {
            radius::cut(self);
        }
    }

    /// The extent of the data, of the points to hit and zero.
    fn measure(&mut self) {
        let all = self.points.iter().chain(&self.targets);
        let (low, high) = all.fold((0.0_f64, 0.0_f64), |(low, high), &(_, value)| (low.min(value), high.max(value)));
        self.extent = Extent { low, high, cut: false, empty: false };
    }

    /// Shows ±`limit` whatever the data: how far it is from the limit is what matters.
    fn limit_angle(&mut self, limit: f64) {
        self.measure();
        self.extent.low = self.extent.low.min(-limit * BEYOND);
        self.extent.high = self.extent.high.max(limit * BEYOND);
        self.limits = vec![-limit, limit];
        self.forbidden = vec![(f64::NEG_INFINITY, -limit), (limit, f64::INFINITY)];
    }

    /// Gives a curve of zeros a sane extent, so that rounding is not blown up to fill the plot.
    fn allow_for_nothing(&mut self, size: f64) {
        let Extent { low, high, .. } = self.extent;
        if high - low <= NOTHING * size || high == low {
            let size = if size > 0.0 { size } else { 1.0 };
            self.extent = Extent { low: -size, high: size, cut: false, empty: true };
        }
    }

    fn note_extremes(&mut self, cam: &Cam, analysis: &Analysis, shown: &dyn Fn(f64) -> f64) {
        let summary = &analysis.summary;
        let found = match self.quantity {
            Quantity::S => summary.s,
            Quantity::V => summary.v,
            Quantity::A => summary.a,
            Quantity::J => summary.j,
            Quantity::PressureAngle => summary.pressure_angle,
            Quantity::Rho => return,
            Quantity::Contact => match summary.reach {
                Some(reach) => reach,
                None => return,
            },
        };
        let significant = NOTHING * (self.extent.high - self.extent.low);
        if self.extent.empty || shown(found.max) - shown(found.min) <= significant {
            return;
        }
        let places = [(found.max_at, found.max), (found.min_at, found.min)];
        let places = places.map(|(theta, value)| (place(cam, theta), shown(value)));
        self.extremes = places.into_iter().filter(|&(_, value)| value.abs() > significant).collect();
    }
}
