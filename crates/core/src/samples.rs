//! A cam looked at in enough places: every smooth stretch with both its ends, and all the stations of the answer.

use crate::{Cam, Contact, Point, Stretch, Svaj};
use std::f64::consts::TAU;
use std::ops::Range;

/// Fewest steps in which a turn is looked at, so that a verdict does not hang on how many rows were asked for.
const LEAST_STEPS: usize = 720;

/// Fewest steps in which a stretch is looked at, however short: its extremes lie between neighbours of one bump.
const LEAST_STEPS_OF_A_STRETCH: usize = 8;

/// A station this close to a joint (radians) lies on it.
const SNAP: f64 = 1e-11;

/// Motion and contact at one θ of one stretch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub theta: f64,
    pub motion: Svaj,
    pub contact: Contact,
}

/// Samples of a whole turn in order, stretch by stretch, both ends of each included as one-sided limits.
pub(crate) struct Samples {
    pub all: Vec<Sample>,
    /// The samples of each stretch.
    pub ranges: Vec<Range<usize>>,
    /// For each of the stations 0 … `steps`, which sample it is; the last repeats the first.
    pub stations: Vec<u32>,
}

impl Samples {
    /// Samples for an exact answer with `steps` rows.
    pub fn of(cam: &Cam, steps: usize) -> Self {
        Self::with_steps(cam, steps, steps * LEAST_STEPS.div_ceil(steps))
    }

    /// Few samples, for a first look.
    pub fn coarse(cam: &Cam, steps: usize) -> Self {
        Self::with_steps(cam, steps, steps)
    }

    fn with_steps(cam: &Cam, steps: usize, fine: usize) -> Self {
        let stretches = cam.program.stretches();
        let mut samples = Self {
            all: Vec::with_capacity(fine + 2 + stretches.len() * 4),
            ranges: Vec::with_capacity(stretches.len()),
            stations: Vec::with_capacity(steps + 1),
        };
        let (step, every) = (TAU / fine as f64, fine / steps);
        let mut next = 0;
        for stretch in stretches {
            next = samples.look_along(cam, stretch, next, fine, step, every);
        }
        samples.stations.push(samples.stations[0]);
        samples
    }

    /// Looks along one stretch from grid station `k` on; gives the first grid station of the next one.
    fn look_along(&mut self, cam: &Cam, stretch: &Stretch, mut k: usize, fine: usize, step: f64, every: usize) -> usize {
        let first = self.all.len();
        let mut look = |theta: f64| {
            let motion = stretch.at(theta);
            self.all.push(Sample { theta, motion, contact: cam.follower.contact(motion) });
        };
        let on_the_grid = ((stretch.to - stretch.from) / step) as usize;
        let extra = if on_the_grid < LEAST_STEPS_OF_A_STRETCH { LEAST_STEPS_OF_A_STRETCH } else { 0 };
        let mut between = (1..extra).map(|i| stretch.from + (stretch.to - stretch.from) * i as f64 / extra as f64).peekable();
        let mut count = first;
        if k >= fine || k as f64 * step > stretch.from + SNAP {
            look(stretch.from);
            count += 1;
        }
        while k < fine && k as f64 * step < stretch.to - SNAP {
            let theta = k as f64 * step;
            while let Some(early) = between.next_if(|&early| early < theta - SNAP) {
                look(early);
                count += 1;
            }
            look(theta);
            if k % every == 0 {
                self.stations.push(count as u32);
            }
            count += 1;
            k += 1;
        }
        for late in between {
            look(late);
        }
        look(stretch.to);
        self.ranges.push(first..self.all.len());
        k
    }

    /// The profile in the cam's frame, sample by sample.
    pub fn profile(&self, cam: &Cam) -> Vec<Point> {
        self.all.iter().map(|sample| cam.in_cam_frame(sample.contact.point, sample.theta)).collect()
    }
}
