//! What a diagram of *s* shows of the data that a curve is made from: measured points with their residuals, ordinates, knots.

use crate::Design;
use crate::report::{scale_of, tidy};
use levalab_core::law::{Data, DataKind};
use levalab_core::{Cam, Column};

/// What a mark stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// A point of a table.
    Point,
    /// An ordinate of a Bézier curve.
    Ordinate,
    /// A knot of a spline, told or not.
    Knot,
}

/// A place that a diagram shows, in the units of the design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// What it stands for.
    pub kind: MarkKind,
    /// Index of its segment.
    pub segment: usize,
    /// Its place in the list of the segment's data.
    pub item: usize,
    /// Where, from the segment's start.
    pub at: f64,
    /// Where in the cycle.
    pub theta: f64,
    /// Its height; that of the curve for a knot.
    pub height: f64,
    /// How much higher the curve lies there.
    pub residual: f64,
}

/// The marks of every segment that has any, for a design and its cam.
#[must_use]
pub fn marks(design: &Design, cam: &Cam) -> Vec<Mark> {
    let mut border = 0.0;
    let mut marks = Vec::new();
    for (k, segment) in design.segments.iter().enumerate() {
        let curve = |at: f64| {
            // From within, also at the end.
            let own = || cam.program.stretches().iter().filter(|stretch| stretch.segment == k);
            let (from, to) = (cam.program.borders()[k], cam.program.borders()[k + 1]);
            let theta = from + (to - from) * (at / segment.beta);
            let stretch = own().find(|stretch| theta < stretch.to).or_else(|| own().next_back());
            stretch.map_or(0.0, |stretch| stretch.at(theta.min(stretch.to)).s * scale_of(design, Column::S))
        };
        let mark = |kind: MarkKind, item: usize, at: f64, height: Option<f64>| {
            let found = curve(at);
            let height = height.unwrap_or(found);
            Mark { kind, segment: k, item, at, theta: tidy(border + at), height, residual: found - height }
        };
        match &segment.data {
            Data::Points(points) => {
                let each = points.iter().enumerate();
                marks.extend(each.map(|(i, &[at, height])| mark(MarkKind::Point, i, at, Some(height))));
            }
            Data::Ordinates(heights) => {
                let step = segment.beta / (heights.len() - 1) as f64;
                let each = heights.iter().enumerate();
                marks.extend(each.map(|(i, &height)| mark(MarkKind::Ordinate, i, step * i as f64, Some(height))));
            }
            _ if segment.law.free().is_some_and(|free| free.data == DataKind::Spline) => {
                let own: Vec<f64> =
                    cam.program.stretches().iter().filter(|s| s.segment == k).map(|stretch| stretch.to).collect();
                let span = cam.program.borders()[k + 1] - cam.program.borders()[k];
                let at = |to: f64| tidy((to - cam.program.borders()[k]) / span * segment.beta);
                let inner = own.iter().take(own.len().saturating_sub(1)).enumerate();
                marks.extend(inner.map(|(i, &to)| mark(MarkKind::Knot, i, at(to), None)));
            }
            _ => {}
        }
        border += segment.beta;
    }
    marks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;
    use serde_json::json;

    fn marks_of(segment: &serde_json::Value) -> Vec<Mark> {
        let mut value = example("9RT").expect("9RT").to_value();
        value["segments"] =
            json!([{"law": "dwell", "beta": 60}, segment, {"law": "cycloidal", "beta": 180, "rise": -10}]);
        let (design, cam, _) = Design::open(&value).expect("a design");
        marks(&design, &cam)
    }

    #[test]
    fn residuals_are_what_the_curve_leaves_of_each_point() {
        let points = json!([[0, 0], [30, 0.9], [60, 5.2], [90, 9.1], [120, 10]]);
        let through = marks_of(&json!({"law": "table", "beta": 120, "points": points}));
        assert_eq!(through.len(), 5);
        assert!(through.iter().all(|mark| mark.kind == MarkKind::Point && mark.residual.abs() < 1e-12), "{through:?}");
        assert_eq!((through[2].at, through[2].theta, through[2].height), (60.0, 120.0, 5.2));
        let smooth = marks_of(&json!({"law": "table", "beta": 120, "smoothing": 0.1, "points": points}));
        let mean = (smooth.iter().map(|mark| mark.residual.powi(2)).sum::<f64>() / 3.0).sqrt();
        assert!((mean - 0.1).abs() < 1e-8, "{mean}");
        assert!(smooth[0].residual.abs() < 1e-12 && smooth[4].residual.abs() < 1e-12, "{smooth:?}");
    }

    #[test]
    fn ordinates_stand_at_even_steps_and_knots_where_pieces_join() {
        let ordinates = marks_of(&json!({"law": "bezier", "beta": 120, "ordinates": [0, 0, 0, 10, 10, 10]}));
        let places: Vec<f64> = ordinates.iter().map(|mark| mark.theta).collect();
        assert_eq!(places, [60.0, 84.0, 108.0, 132.0, 156.0, 180.0]);
        let condition = |at: f64, order: u8, value: f64| json!({"at": at, "order": order, "value": value});
        let mut conditions: Vec<_> = (0..3).map(|order| condition(0.0, order, 0.0)).collect();
        conditions.extend([condition(40.0, 0, 3.0), condition(80.0, 0, 8.0)]);
        conditions.extend((0..3).map(|order| condition(120.0, order, if order == 0 { 10.0 } else { 0.0 })));
        let spline = json!({"law": "bspline", "beta": 120, "degree": 5, "conditions": conditions, "knots": [45, 75]});
        let knots: Vec<(f64, f64)> = marks_of(&spline).iter().map(|mark| (mark.at, mark.theta)).collect();
        assert_eq!(knots, [(45.0, 105.0), (75.0, 135.0)]);
    }
}
