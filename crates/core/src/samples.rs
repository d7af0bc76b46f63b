//! A cam looked at in enough places: an even grid over the cycle, and the ends of every smooth stretch.

use crate::{Body, Cam, Closure, Contact, Drive, Point, Stretch, Svaj};
use std::f64::consts::TAU;
use std::ops::Range;

/// Fewest steps in which a turn is looked at, so that a verdict does not hang on how many rows were asked for.
pub(crate) const LEAST_STEPS: usize = 720;

/// Fewest steps in which a stretch is looked at for each period of its fastest wave, however short it is: its extremes lie between
/// neighbours of one bump.
const LEAST_STEPS_OF_A_STRETCH: usize = 8;

/// A station this close to a joint (radians) lies on it.
const SNAP: f64 = 1e-11;

/// Stations looked at together. Of their turns of the frame one is computed afresh; the others are products of two.
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
    OuterRadius,
}

impl Quantity {
    const COUNT: usize = 10;
    const ALL: [Self; Self::COUNT] = [
        Self::S,
        Self::V,
        Self::A,
        Self::J,
        Self::PressureAngle,
        Self::Bend,
        Self::Reach,
        Self::Lead,
        Self::Radius,
        Self::OuterRadius,
    ];

    /// True when the verdict on a cam asks for it.
    #[inline(always)]
    fn is_wanted(self, cam: &Cam) -> bool {
        match self {
            Self::S | Self::V | Self::A | Self::J | Self::PressureAngle | Self::Bend => true,
            Self::Reach | Self::Lead => cam.follower.is_flat(),
            // Only a pivot can lie in the way of the cam.
            Self::Radius | Self::OuterRadius => {
                matches!(cam.follower.body, Body::Swing { .. }) && self == Self::outmost(cam)
            }
        }
    }

    /// Distance of the outmost profile from the centre: of the outer wall, where there is a groove.
    #[inline(always)]
    pub fn outmost(cam: &Cam) -> Self {
        if cam.closure == Closure::Groove { Self::OuterRadius } else { Self::Radius }
    }

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
            // The walls of a groove are as far from the trace point on both sides.
            Self::OuterRadius => (contact.trace * 2.0 - contact.point).norm_sqr().sqrt(),
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

/// A cycle sampled: one array a quantity, in the order of θ; those that no verdict on this follower needs are empty.
///
/// A sample is a station of an even grid, or one that a stretch has of its own: its ends, and more when it is short. Where two stretches
/// meet there are two, the limits from either side.
pub(crate) struct Samples {
    /// The samples of each stretch.
    pub spans: Vec<Range<usize>>,
    /// θ of every sample.
    pub theta: Vec<f64>,
    values: [Vec<f64>; Quantity::COUNT],
    /// Which samples are stations of the grid, in runs.
    runs: Vec<Range<usize>>,
    /// What the grid divides, and into how many steps.
    span: f64,
    stations: usize,
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
        let flat = cam.follower.is_flat();
        let room = n + LEAST_STEPS_OF_A_STRETCH * stretches.len();
        let wanted = |quantity: Quantity| quantity.is_wanted(cam);
        let mut samples = Self {
            spans: Vec::with_capacity(stretches.len()),
            theta: Vec::with_capacity(room),
            values: Quantity::ALL.map(|quantity| Vec::with_capacity(if wanted(quantity) { room } else { 0 })),
            runs: Vec::with_capacity(stretches.len()),
            span: cam.program.span(),
            stations: n,
            profile: Vec::with_capacity(n),
            pitch: Vec::with_capacity(if flat { 0 } else { n }),
            turns: match cam.follower.drive {
                Drive::Turns => turns(cam.follower.rotation.sigma(), n),
                Drive::Travels => Vec::new(),
            },
            star_shaped: true,
        };
        let mut block = Block::default();
        for stretch in stretches {
            samples.look_along(cam, stretch, &mut block);
        }
        samples
    }

    /// A quantity at all samples.
    pub fn of_all(&self, quantity: Quantity) -> &[f64] {
        &self.values[quantity as usize]
    }

    /// A quantity at every `every`-th station of the grid, and at the very end of the cycle, from within it.
    pub fn rows(&self, quantity: Quantity, every: usize) -> (Vec<f64>, Option<f64>) {
        let values = self.of_all(quantity);
        let mut rows = Vec::with_capacity(if values.is_empty() { 0 } else { self.stations / every + 1 });
        let mut station = 0_usize;
        for run in self.runs.iter().filter(|_| !values.is_empty()) {
            if every == 1 {
                rows.extend_from_slice(&values[run.clone()]);
            } else {
                let skipped = station.next_multiple_of(every) - station;
                rows.extend(values[run.clone()].iter().skip(skipped).step_by(every));
            }
            station += run.len();
        }
        (rows, values.last().copied())
    }

    /// How many stations the grid has, its end apart.
    pub fn stations(&self) -> usize {
        self.stations
    }

    /// θ of a station of the grid.
    #[inline]
    pub fn station(&self, k: usize) -> f64 {
        self.span * k as f64 / self.stations as f64
    }

    fn look_along(&mut self, cam: &Cam, stretch: &Stretch, block: &mut Block) {
        let snap = SNAP * (self.span / TAU);
        let (first, first_sample) = (self.profile.len(), self.theta.len());
        let after = if stretch.to >= self.span {
            self.stations
        } else {
            let step = self.span / self.stations as f64;
            ((((stretch.to - snap) / step).ceil()) as usize).max(first)
        };
        let starts_on_grid = first < after && self.station(first) - stretch.from < snap;
        let least = LEAST_STEPS_OF_A_STRETCH * stretch.periods();
        let parts = if after - first < least { least } else { 1 };
        let mut places = stretch.places_and_steps(parts);
        // A place on a station is that station: rounding alone would tell them apart.
        places.retain(|&own| own == stretch.from || own == stretch.to || self.distance_to_station(own) > snap);
        let mut station = first;
        for (i, &own) in places.iter().enumerate().skip(usize::from(starts_on_grid)) {
            let last = i + 1 == places.len();
            let until = if last { after } else { self.first_station_from(own, station..after) };
            self.look_at_stations(cam, stretch, station..until, block);
            self.look_at(cam, stretch, &[own], block);
            station = until;
        }
        self.spans.push(first_sample..self.theta.len());
    }

    /// How far θ is from the nearest station of the grid.
    fn distance_to_station(&self, theta: f64) -> f64 {
        (theta - self.station((theta / self.span * self.stations as f64).round().max(0.0) as usize)).abs()
    }

    /// The first of some stations of the grid that is not before θ.
    fn first_station_from(&self, theta: f64, stations: Range<usize>) -> usize {
        let estimate = (theta / self.span * self.stations as f64).floor().max(0.0) as usize;
        let first = estimate.saturating_sub(1).clamp(stations.start, stations.end);
        (first..stations.end).find(|&k| self.station(k) >= theta).unwrap_or(stations.end)
    }

    /// Looks at stations of the grid that follow each other.
    fn look_at_stations(&mut self, cam: &Cam, stretch: &Stretch, stations: Range<usize>, block: &mut Block) {
        if stations.is_empty() {
            return;
        }
        self.runs.push(self.theta.len()..self.theta.len() + stations.len());
        for first in stations.clone().step_by(BLOCK) {
            let count = BLOCK.min(stations.end - first);
            let theta: [f64; BLOCK] = std::array::from_fn(|i| self.station(first + i));
            let theta = &theta[..count];
            self.look_at(cam, stretch, theta, block);
            let turns = self.turns.get(first..).unwrap_or_default();
            let in_cam_frame = |points: &[Point; BLOCK], list: &mut Vec<Point>| {
                if turns.is_empty() {
                    list.extend(points.iter().zip(theta).map(|(point, theta)| point + theta));
                } else {
                    list.extend(points[..count].iter().zip(turns).map(|(point, turn)| point * turn));
                }
            };
            in_cam_frame(&block.points, &mut self.profile);
            if !cam.follower.is_flat() {
                in_cam_frame(&block.traces, &mut self.pitch);
            }
        }
    }

    /// Looks at places of a stretch, at most [`BLOCK`] of them.
    fn look_at(&mut self, cam: &Cam, stretch: &Stretch, theta: &[f64], block: &mut Block) {
        let wanted = Quantity::ALL.map(|quantity| quantity.is_wanted(cam));
        let look = |theta: f64| {
            let motion = stretch.at(theta);
            (motion, cam.contact(motion))
        };
        // A dwell is looked at once.
        let still = stretch.is_still().then(|| look(stretch.from));
        let mut away = true;
        for (i, &theta) in theta.iter().enumerate() {
            let (motion, contact) = still.unwrap_or_else(|| look(theta));
            for quantity in Quantity::ALL {
                if wanted[quantity as usize] {
                    block.values[quantity as usize][i] = quantity.of(&motion, &contact);
                }
            }
            (block.points[i], block.traces[i]) = (contact.point, contact.trace);
            away &= looks_away(&contact);
        }
        self.star_shaped &= away || cam.follower.drive == Drive::Travels;
        self.theta.extend_from_slice(theta);
        for (list, values) in
            self.values.iter_mut().zip(&block.values).zip(wanted).filter_map(|(pair, wanted)| wanted.then_some(pair))
        {
            list.extend_from_slice(&values[..theta.len()]);
        }
    }
}

/// Where samples are put side by side before they are appended, since a list that may grow is slow to write to one by one. Points are
/// in the fixed frame.
struct Block {
    values: [[f64; BLOCK]; Quantity::COUNT],
    points: [Point; BLOCK],
    traces: [Point; BLOCK],
}

impl Default for Block {
    fn default() -> Self {
        let nowhere = [Point::default(); BLOCK];
        Self { values: [[0.0; BLOCK]; Quantity::COUNT], points: nowhere, traces: nowhere }
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
