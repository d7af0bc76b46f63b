//! Cuts so shallow, or so short, that only the curve shows them: near misses of the polygon, refined on the curve.

use super::outline::{Outline, Pair};
use super::{Cut, POLYGON_TOLERANCE, dot};
use crate::Point;
use crate::search::golden_maximum;

/// Near misses that are refined, the nearest first.
const MAX_TOUCHES: usize = 8;

/// Steps of the profile to both sides of a near miss among which the place of contact moves while the arm moves by one step.
const TOUCH_STEPS: f64 = 4.0;

/// Steps of a golden section on the curve: they shorten an interval by 7·10⁻⁵, which makes the value at a smooth peak exact to its
/// square.
const GOLDEN_STEPS: usize = 20;

/// The arm beside a point of the profile that it nearly touches.
#[derive(Clone, Copy)]
struct Touch {
    place: usize,
    vertex: usize,
    distance: f64,
}

impl Outline<'_> {
    /// The deepest of the cuts that only the curve shows.
    pub fn deepest_touch(&self, pairs: &[Pair]) -> Option<Cut> {
        let mut near: Vec<Option<Touch>> = vec![None; self.arms.len()];
        for pairs in pairs.chunk_by(|a, b| a.place == b.place) {
            near[pairs[0].place] = self.near_miss(pairs);
        }
        let distance = |place: usize| near[place % near.len()].map_or(f64::INFINITY, |touch| touch.distance);
        let rounding = POLYGON_TOLERANCE * self.cam.size();
        // A distance that falls by so much from a neighbour does not fall by more on the way to its minimum.
        let nearest = |touch: &&Touch| {
            let around = [distance(touch.place + near.len() - 1), distance(touch.place + 1)];
            let fall = around.into_iter().fold(0.0, f64::max) - touch.distance;
            around.iter().all(|&other| touch.distance <= other) && touch.distance <= rounding + fall
        };
        let mut touches: Vec<&Touch> = near.iter().flatten().filter(nearest).collect();
        touches.sort_unstable_by(|a, b| a.distance.total_cmp(&b.distance));
        touches.truncate(MAX_TOUCHES);
        touches.into_iter().map(|touch| self.refined(*touch)).max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// The point of the profile nearest to the arm at the place of some pairs, when the arm may reach it before it is nearer to another place.
    fn near_miss(&self, pairs: &[Pair]) -> Option<Touch> {
        let Pair { place, moved, .. } = *pairs.first()?;
        let arm = self.arms[place];
        let vertices = self.sides_of(pairs).filter(|&k| self.is_beside(arm, self.points[k]));
        let squared = |vertex: usize| (vertex, arm.distance_squared(self.points[vertex]));
        let (vertex, least) = vertices.map(squared).min_by(|a, b| a.1.total_cmp(&b.1))?;
        (least <= moved * moved).then(|| Touch { place, vertex, distance: least.sqrt() })
    }

    /// How far the profile rises beyond the arm at a near miss, at most: both the place of the arm and that on the profile vary.
    fn refined(&self, touch: Touch) -> Cut {
        let (place, vertex) = (self.step * touch.place as f64, self.step * touch.vertex as f64);
        let outwards = self.cam.in_cam_frame(self.cam.at(vertex).1.normal, vertex);
        let height = |theta: f64| {
            let arm = self.arm_at(theta);
            let across = arm.along() * Point::i() / arm.along().norm().max(f64::MIN_POSITIVE);
            let across = across * dot(across, outwards).signum();
            let beyond = |t: f64| {
                let point = self.cam.in_cam_frame(self.cam.at(t).1.point, t);
                let beside = (0.0..=1.0).contains(&arm.foot(point));
                if beside { dot(across, point - arm.from) } else { f64::NEG_INFINITY }
            };
            let width = TOUCH_STEPS * self.step;
            golden_maximum(vertex - width, vertex + width, GOLDEN_STEPS, beyond).1
        };
        let (theta, depth) = golden_maximum(place - self.step, place + self.step, GOLDEN_STEPS, height);
        Cut { place, theta, depth }
    }
}
