//! A cam looked at in enough places: an even grid over the cycle, and the ends of every smooth stretch.

use crate::{Cam, Contact, Drive, Point, Stretch, Svaj};
use std::f64::consts::TAU;
use std::ops::Range;

/// Fewest steps in which a turn is looked at, so that a verdict does not hang on how many rows were asked for.
pub(crate) const LEAST_STEPS: usize = 720;

/// Fewest steps in which a stretch is looked at, however short: its extremes lie between neighbours of one bump.
const LEAST_STEPS_OF_A_STRETCH: usize = 8;

/// A station this close to a joint (radians) lies on it.
const SNAP: f64 = 1e-11;

/// Stations between two turns of the frame that are computed afresh; those between are products of two of them.
const BLOCK: usize = 32;

/// Something that varies along the turn and whose extremes matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    S,
    V,
    A,
    J,
    PressureAngle,
    Bend,
    Reach,
    Lead,
    Radius,
}

impl Quantity {
    const COUNT: usize = 9;
    const ALWAYS: [Self; 6] = [Self::S, Self::V, Self::A, Self::J, Self::PressureAngle, Self::Bend];
    const FLAT: [Self; 2] = [Self::Reach, Self::Lead];

    #[inline(always)]
    pub fn of(self, motion: &Svaj, contact: &Contact) -> f64 {
        match self {
            Self::S => motion.s,
            Self::V => motion.v,
            Self::A => motion.a,
            Self::J => motion.j,
            Self::PressureAngle => contact.pressure_angle,
            Self::Bend => contact.bend,
            Self::Reach => contact.reach,
            Self::Lead => contact.lead,
            Self::Radius => contact.point.norm_sqr().sqrt(),
        }
    }

    /// The quantity that is its derivative, where that is one of them.
    pub fn slope(self) -> Option<Self> {
        match self {
            Self::S => Some(Self::V),
            Self::V => Some(Self::A),
            Self::A => Some(Self::J),
            _ => None,
        }
    }

    /// Its value at θ of a stretch.
    pub fn at(self, cam: &Cam, stretch: &Stretch, theta: f64) -> f64 {
        let motion = stretch.at(theta);
        match self {
            Self::S | Self::V | Self::A | Self::J => self.of(&motion, &NOWHERE),
            _ => self.of(&motion, &cam.contact(motion)),
        }
    }
}

/// Stands in for a contact that is not asked about.
const NOWHERE: Contact = Contact {
    point: Point::new(0.0, 0.0),
    trace: Point::new(0.0, 0.0),
    normal: Point::new(0.0, 0.0),
    pressure_angle: 0.0,
    bend: 0.0,
    reach: 0.0,
    sliding: 0.0,
    lead: 0.0,
};

/// The samples of one stretch: stations of the grid, and some of its own (both ends among them).
#[derive(Clone, Debug)]
pub(crate) struct Span {
    pub grid: Range<usize>,
    pub own: Range<usize>,
}

/// A turn sampled, one array a quantity; those that no verdict on this follower needs are empty.
pub(crate) struct Samples {
    pub spans: Vec<Span>,
    pub theta: Vec<f64>,
    pub own_theta: Vec<f64>,
    grid: [Vec<f64>; Quantity::COUNT],
    own: [Vec<f64>; Quantity::COUNT],
    /// Contact and trace point at the stations of the grid, in the cam's frame.
    pub profile: Vec<Point>,
    pub pitch: Vec<Point>,
    /// e^(−iσθ) at the stations of the grid; none for a cam that travels.
    pub turns: Vec<Point>,
    /// The outward normal looks away from the cam's centre everywhere, or the cam travels: then it always looks up. Such a
    /// profile does not cross itself unless it is undercut.
    pub star_shaped: bool,
}

impl Samples {
    /// Samples for an exact answer with `steps` rows: the grid has a whole multiple of them.
    pub fn of(cam: &Cam, steps: usize) -> Self {
        Self::on_grid(cam, steps * LEAST_STEPS.div_ceil(steps))
    }

    /// Samples on a grid of `n` steps, however coarse.
    pub fn on_grid(cam: &Cam, n: usize) -> Self {
        let stretches = cam.program.stretches();
        let room = |wanted: bool| Vec::with_capacity(if wanted { n + 1 } else { 0 });
        let flat = cam.follower.is_flat();
        let mut samples = Self {
            spans: Vec::with_capacity(stretches.len()),
            theta: room(true),
            own_theta: Vec::with_capacity(3 * stretches.len()),
            grid: std::array::from_fn(|k| room(k < Quantity::ALWAYS.len() || flat && k < Quantity::Radius as usize)),
            own: Default::default(),
            profile: Vec::with_capacity(n + 1),
            pitch: Vec::with_capacity(if flat { 0 } else { n + 1 }),
            turns: match cam.follower.drive {
                Drive::Turns => turns(cam.follower.rotation.sigma(), n),
                Drive::Travels => Vec::new(),
            },
            star_shaped: true,
        };
        for stretch in stretches {
            samples.look_along(cam, stretch, n);
        }
        samples
    }

    /// A quantity at the stations of the grid.
    pub fn grid(&self, quantity: Quantity) -> &[f64] {
        &self.grid[quantity as usize]
    }

    /// A quantity at the samples that stretches have of their own.
    pub fn own(&self, quantity: Quantity) -> &[f64] {
        &self.own[quantity as usize]
    }

    /// The value at the very end of the cycle, from within it.
    pub fn last(&self, quantity: Quantity) -> Option<f64> {
        self.own(quantity).last().copied()
    }

    /// Takes the grid's values of a quantity out.
    pub fn take(&mut self, quantity: Quantity) -> Vec<f64> {
        std::mem::take(&mut self.grid[quantity as usize])
    }

    /// Adds the distance of the contact from the cam's centre, which only a cam beside a pivot needs.
    pub fn measure_radius(&mut self, cam: &Cam) {
        self.grid[Quantity::Radius as usize] = self.profile.iter().map(|point| point.norm_sqr().sqrt()).collect();
        let stretches = cam.program.stretches().iter().zip(&self.spans);
        let own = stretches.flat_map(|(stretch, span)| {
            self.own_theta[span.own.clone()].iter().map(move |&theta| Quantity::Radius.at(cam, stretch, theta))
        });
        self.own[Quantity::Radius as usize] = own.collect();
    }

    /// The samples of a stretch in order of θ, with the values of a quantity.
    pub fn along(&self, span: &Span, quantity: Quantity) -> Vec<(f64, f64)> {
        let pairs = |thetas: &[f64], values: &[f64]| -> Vec<(f64, f64)> {
            thetas.iter().copied().zip(values.iter().copied()).collect()
        };
        let mut all = pairs(&self.theta[span.grid.clone()], &self.grid(quantity)[span.grid.clone()]);
        for (theta, value) in pairs(&self.own_theta[span.own.clone()], &self.own(quantity)[span.own.clone()]) {
            let place = if all.last().is_none_or(|last| last.0 < theta) {
                all.len()
            } else {
                all.partition_point(|p| p.0 < theta)
            };
            all.insert(place, (theta, value));
        }
        all
    }

    fn look_along(&mut self, cam: &Cam, stretch: &Stretch, n: usize) {
        let span = cam.program.span();
        let (step, snap) = (span / n as f64, SNAP * (span / TAU));
        let first = self.theta.len();
        let after = if stretch.to >= span { n } else { ((stretch.to - snap) / step).ceil() as usize };
        let look = |theta: f64| {
            let motion = stretch.at(theta);
            (motion, cam.contact(motion))
        };
        // A dwell is looked at once.
        let still = stretch.is_still().then(|| look(stretch.from));
        for k in first..after {
            let theta = span * k as f64 / n as f64;
            let (motion, contact) = still.unwrap_or_else(|| look(theta));
            self.theta.push(theta);
            put(&mut self.grid, cam, &motion, &contact);
            let turn = self.turns.get(k).copied();
            let in_cam_frame = |point: Point| turn.map_or(point + theta, |turn| point * turn);
            self.profile.push(in_cam_frame(contact.point));
            if !cam.follower.is_flat() {
                self.pitch.push(in_cam_frame(contact.trace));
            }
            self.star_shaped &= turn.is_none() || looks_away(&contact);
        }
        let own_first = self.own_theta.len();
        let starts_on_grid = first < after && self.theta[first] - stretch.from < snap;
        let parts = if after.saturating_sub(first) < LEAST_STEPS_OF_A_STRETCH { LEAST_STEPS_OF_A_STRETCH } else { 1 };
        for i in usize::from(starts_on_grid)..=parts {
            let theta = if i == parts {
                stretch.to
            } else {
                stretch.from + (stretch.to - stretch.from) * i as f64 / parts as f64
            };
            let (motion, contact) = look(theta);
            self.own_theta.push(theta);
            put(&mut self.own, cam, &motion, &contact);
            self.star_shaped &= cam.follower.drive == Drive::Travels || looks_away(&contact);
        }
        self.spans.push(Span { grid: first..after.max(first), own: own_first..self.own_theta.len() });
    }
}

#[inline(always)]
fn put(columns: &mut [Vec<f64>; Quantity::COUNT], cam: &Cam, motion: &Svaj, contact: &Contact) {
    for quantity in Quantity::ALWAYS {
        columns[quantity as usize].push(quantity.of(motion, contact));
    }
    if cam.follower.is_flat() {
        for quantity in Quantity::FLAT {
            columns[quantity as usize].push(quantity.of(motion, contact));
        }
    }
}

#[inline(always)]
fn looks_away(contact: &Contact) -> bool {
    contact.point.re * contact.normal.re + contact.point.im * contact.normal.im > 0.0
}

/// e^(−iσθ) at θ = 2πk/n for k = 0 … n: every [`BLOCK`]-th computed, the others one product away, so nothing accumulates.
fn turns(sigma: f64, n: usize) -> Vec<Point> {
    let turn = |k: usize| Point::from_polar(1.0, -sigma * TAU * k as f64 / n as f64);
    let within: [Point; BLOCK] = std::array::from_fn(turn);
    let mut turns = Vec::with_capacity(n + BLOCK);
    for block in (0..=n).step_by(BLOCK) {
        let start = turn(block);
        turns.extend(within.iter().map(|part| start * part));
    }
    turns.truncate(n + 1);
    turns
}
