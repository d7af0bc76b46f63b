//! Fewer points for the same line.

use crate::sketch::At;

/// How far, in units, the line may pass from a point that is left out: a tenth of a device pixel is not seen.
const TOLERANCE: f64 = 0.75;

/// Adds the points of a curve, which never runs backwards, that a line needs to pass within [`TOLERANCE`] of all of them.
pub(crate) fn thin(curve: impl Iterator<Item = At>, kept: &mut Vec<At>) {
    let mut curve = curve;
    let Some(mut anchor) = curve.next() else { return };
    kept.push(anchor);
    let (mut last, mut cone) = (anchor, OPEN);
    for point in curve {
        let seen = slopes(anchor, point);
        let Some(narrowed) = seen.and_then(|(slope, reach)| within(cone, slope, reach)) else {
            if last != anchor {
                kept.push(last);
                anchor = last;
            }
            if anchor.0 == point.0 && anchor != point {
                kept.push(point);
                anchor = point;
            }
            cone = slopes(anchor, point).and_then(|(slope, reach)| within(OPEN, slope, reach)).unwrap_or(OPEN);
            last = point;
            continue;
        };
        (last, cone) = (point, narrowed);
    }
    if last != anchor {
        kept.push(last);
    }
}

/// Every slope.
const OPEN: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Slope of the line to a point, and by how much it may differ and still pass near; nothing when it is upright.
fn slopes(from: At, to: At) -> Option<(f64, f64)> {
    let (across, down) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
    (across > 0.0).then(|| (down / across, TOLERANCE / across))
}

/// The cone narrowed to lines that pass near one more point, when the line to the point itself lies in it.
fn within((low, high): (f64, f64), slope: f64, reach: f64) -> Option<(f64, f64)> {
    (low <= slope && slope <= high).then(|| (low.max(slope - reach), high.min(slope + reach)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Height of a line through points at `x`.
    fn height(line: &[At], x: i32) -> f64 {
        let pair = line.windows(2).find(|pair| pair[0].0 <= x && x <= pair[1].0).expect("within the line");
        let part = f64::from(x - pair[0].0) / f64::from((pair[1].0 - pair[0].0).max(1));
        f64::from(pair[0].1) + part * f64::from(pair[1].1 - pair[0].1)
    }

    #[test]
    fn a_thinned_line_passes_near_every_point() {
        let curve: Vec<At> =
            (0..720).map(|i| (i * 9, (f64::from(i) / 40.0).sin().mul_add(700.0, 0.5) as i32)).collect();
        let mut kept = Vec::new();
        thin(curve.iter().copied(), &mut kept);
        assert!(kept.len() < curve.len() / 3, "{} of {}", kept.len(), curve.len());
        assert_eq!((kept.first(), kept.last()), (curve.first(), curve.last()));
        for &(x, y) in &curve {
            assert!((height(&kept, x) - f64::from(y)).abs() <= TOLERANCE + 1e-9, "at {x}");
        }
    }

    #[test]
    fn corners_and_upright_lines_are_kept() {
        let corner = [(0, 0), (5, 0), (10, 0), (10, 40), (20, 40), (30, 80)];
        let mut kept = Vec::new();
        thin(corner.into_iter(), &mut kept);
        assert_eq!(kept, [(0, 0), (10, 0), (10, 40), (20, 40), (30, 80)]);
        kept.clear();
        thin([(3, 4), (3, 4)].into_iter(), &mut kept);
        assert_eq!(kept, [(3, 4)]);
    }
}
