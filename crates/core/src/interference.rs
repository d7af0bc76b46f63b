//! Contact where there should be none: a profile that crosses itself.

use crate::analysis::finding;
use crate::samples::Samples;
use crate::{Finding, FindingKind, Point};

/// The profile crossing itself, for a profile without cusps.
///
/// When the outward normal looks away from the centre all along (a star-shaped profile) there is nothing to look for. Otherwise
/// the polygon of samples is searched for two sides that cross, sorted by their left ends.
pub(crate) fn crossing(samples: &Samples) -> Option<Finding> {
    if samples.star_shaped {
        return None;
    }
    let profile = &samples.profile;
    let mut sides: Vec<(f64, f64, usize)> = profile
        .windows(2)
        .enumerate()
        .map(|(i, pair)| (pair[0].re.min(pair[1].re), pair[0].re.max(pair[1].re), i))
        .collect();
    sides.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let last = profile.len() - 2;
    for (k, &(_, right, i)) in sides.iter().enumerate() {
        for &(left, _, other) in &sides[k + 1..] {
            if left > right {
                break;
            }
            let apart = i.abs_diff(other);
            let neighbours = apart <= 2 || apart >= last - 1;
            if !neighbours && sides_cross(&profile[i..=i + 1], &profile[other..=other + 1]) {
                let (theta, second) = (samples.station(i.min(other)), samples.station(i.max(other)));
                return Some(Finding {
                    places: vec![theta, second],
                    ..finding(FindingKind::SelfCrossing, theta, 0.0, 0.0, None)
                });
            }
        }
    }
    None
}

fn sides_cross(a: &[Point], b: &[Point]) -> bool {
    let side = |p: Point, q: Point, r: Point| cross(q - p, r - p);
    side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < 0.0 && side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) < 0.0
}

fn cross(a: Point, b: Point) -> f64 {
    a.re * b.im - a.im * b.re
}
