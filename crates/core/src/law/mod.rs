//! Motion laws: how a follower goes from one height to the next.
//!
//! A law is a list of smooth pieces ([`Piece`]) over x ∈ [0, 1]; each piece is one [`Curve`]. Everything else (scaling
//! to β and L, one-sided limits, extremes, formulas on paper) follows from that list. To add a law, write one file with
//! a `pub const LAW: Law` and name it in [`LAWS`].

mod asymmetric_3_4_5;
mod bezier;
mod bspline;
mod circular_arc;
mod conditions;
mod constant_velocity;
mod cubic_1;
mod cubic_2;
mod cycloidal;
mod data;
mod double_harmonic;
mod dwell;
mod formula;
mod half_cycloidal_end;
mod half_cycloidal_start;
mod half_harmonic_end;
mod half_harmonic_start;
mod matched;
mod modified_sine;
mod modified_trapezoidal;
mod parabolic;
mod parabolic_blend;
mod polynomial;
mod polynomial_3_4_5;
mod polynomial_4_5_6_7;
mod polynomial_5;
mod polynomial_7;
mod scca;
mod simple_harmonic;
mod skew;
mod skewed_scca;
mod smoothing;
mod system;
mod table;

pub use bezier::MAX_ORDINATES;
pub use bspline::{MAX_SPLINE_CONDITIONS, usual_knots};
pub use circular_arc::LAW as CIRCULAR_ARC;
pub use data::{Condition, Data, DataKind, DataProblem, Given, Solved};
pub use matched::end_system;
pub use polynomial::MAX_CONDITIONS;
pub use system::{ConditionSystem, System, condition_system};
pub use table::MAX_POINTS;

pub(crate) use matched::matched_polynomial;

use crate::{Curve, Form, Parameter, Svaj};

/// Every law there is, in the order in which a menu shows them.
pub const LAWS: &[&Law] = &[
    &dwell::LAW,
    &constant_velocity::LAW,
    &parabolic::LAW,
    &parabolic_blend::LAW,
    &cubic_1::LAW,
    &cubic_2::LAW,
    &simple_harmonic::LAW,
    &double_harmonic::LAW,
    &cycloidal::LAW,
    &polynomial_3_4_5::LAW,
    &polynomial_4_5_6_7::LAW,
    &modified_trapezoidal::LAW,
    &modified_sine::LAW,
    &scca::LAW,
    &skewed_scca::LAW,
    &asymmetric_3_4_5::LAW,
    &half_harmonic_start::LAW,
    &half_harmonic_end::LAW,
    &half_cycloidal_start::LAW,
    &half_cycloidal_end::LAW,
    &polynomial_5::LAW,
    &polynomial_7::LAW,
    &polynomial::LAW,
    &bspline::LAW,
    &bezier::LAW,
    &table::LAW,
    &formula::LAW,
];

/// Most parameters of its own that a law takes.
pub const MAX_LAW_PARAMETERS: usize = 3;

/// A motion law.
#[derive(Debug)]
pub struct Law {
    /// The name used in design files and links, such as `cycloidal`.
    pub id: &'static str,
    /// Where a menu files it.
    pub group: Group,
    /// What it takes besides β and L.
    pub parameters: &'static [Parameter],
    /// How its curve is found.
    pub shape: Shape,
}

/// The families that a menu shows apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Pieces that every program is built from: dwell, constant velocity.
    Basic,
    /// Whole rises and returns, at rest at both ends.
    Standard,
    /// Half motions, at rest at one end only.
    Half,
    /// Polynomials that take their end conditions from their neighbours.
    Matched,
    /// Curves from the user's own data.
    Free,
}

/// How the curve of a law is found.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Stays where it is: y = 0, and no rise is possible.
    Rest,
    /// A fixed curve from (0, 0) to (1, 1).
    Unit(fn(Arguments) -> Result<Vec<Piece>, ArgumentProblem>),
    /// One polynomial that agrees with both neighbours in this many orders (*s* is the first).
    Matched(usize),
    /// A curve from data of the segment's own, which say where it begins and ends: its rise follows from them.
    Free(Free),
}

/// How a law is found from data.
#[derive(Clone, Copy, Debug)]
pub struct Free {
    /// What data it takes.
    pub data: DataKind,
    /// The data that a form starts with, for β, a starting height and a rise.
    pub first: fn(f64, f64, f64) -> Data,
    /// The curve, in the units of the design.
    pub solve: fn(&Given) -> Result<Solved, DataProblem>,
}

/// What a unit curve may depend on.
#[derive(Clone, Copy, Debug)]
pub struct Arguments {
    /// The law's own parameters, in the order of [`Law::parameters`].
    pub parameters: [f64; MAX_LAW_PARAMETERS],
    /// True for a return (L < 0).
    pub falling: bool,
    /// The β spanned, radians.
    pub beta: f64,
}

/// Why a law refuses its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArgumentProblem {
    /// Index into [`Law::parameters`] of the one to correct.
    pub parameter: usize,
    /// Least value that would do.
    pub min: f64,
    /// Greatest value that would do.
    pub max: f64,
}

/// One smooth stretch of a law, from the end of the piece before it up to x = `until`: y = curve((x − origin)/span).
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The x at which it ends.
    pub until: f64,
    /// Its curve.
    pub curve: Form,
    /// The x at which the variable of the curve is 0.
    pub origin: f64,
    /// How much of x a unit of the variable of the curve is.
    pub span: f64,
}

impl Piece {
    /// A piece from its end and its curve, in the x of the whole law.
    #[must_use]
    pub fn new(until: f64, curve: impl Into<Form>) -> Self {
        Self { until, curve: curve.into(), origin: 0.0, span: 1.0 }
    }

    /// A piece whose curve runs from 0 to 1 between its own ends, which keeps the digits of narrow ones.
    #[must_use]
    pub fn between(from: f64, until: f64, curve: impl Into<Form>) -> Self {
        Self { until, curve: curve.into(), origin: from, span: until - from }
    }

    /// y and its three derivatives with respect to the x of the whole law.
    #[must_use]
    pub fn at(&self, x: f64) -> Svaj {
        self.curve.at((x - self.origin) / self.span).stretched(self.span)
    }
}

/// Laws are the entries of [`LAWS`]: the same name is the same law.
impl PartialEq for Law {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Law {
    /// The law of that name.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static Law> {
        LAWS.iter().copied().find(|law| law.id == id)
    }

    /// True when the law takes its end conditions from its neighbours.
    #[must_use]
    pub fn is_matched(&self) -> bool {
        matches!(self.shape, Shape::Matched(_))
    }

    /// True when the follower stays still.
    #[must_use]
    pub fn is_dwell(&self) -> bool {
        matches!(self.shape, Shape::Rest)
    }

    /// How it is found from data, for a law that is.
    #[must_use]
    pub fn free(&self) -> Option<&Free> {
        match &self.shape {
            Shape::Free(free) => Some(free),
            _ => None,
        }
    }

    /// The data that a form starts with, for β, a starting height and a rise.
    #[must_use]
    pub fn first_data(&self, beta: f64, start: f64, rise: f64) -> Data {
        self.free().map_or(Data::None, |free| (free.first)(beta, start, rise))
    }

    /// The law's own parameters at the values a form starts with.
    #[must_use]
    pub fn default_parameters(&self) -> [f64; MAX_LAW_PARAMETERS] {
        let mut values = [0.0; MAX_LAW_PARAMETERS];
        for (value, parameter) in values.iter_mut().zip(self.parameters) {
            *value = parameter.default.unwrap_or(0.0);
        }
        values
    }

    /// The law between two rests, from (0, 0) to (1, 1), as smooth pieces; a free law with the data that a form starts with.
    ///
    /// # Errors
    /// When a parameter of the law is outside the range that makes a curve.
    pub fn unit(&self, arguments: Arguments) -> Result<Vec<Piece>, ArgumentProblem> {
        match self.shape {
            Shape::Rest => Ok(single(Curve::polynomial(&[0.0]))),
            Shape::Unit(pieces) => pieces(arguments),
            Shape::Matched(orders) => {
                let curve = matched_polynomial(orders, Svaj::default(), Svaj::new(1.0, 0.0, 0.0, 0.0));
                Ok(single(curve))
            }
            Shape::Free(Free { first, solve, .. }) => {
                let data = first(1.0, 0.0, 1.0);
                Ok(solve(&Given { data: &data, rise: 1.0, parameters: arguments.parameters, ..Given::default() })
                    .map_or_else(|_| Vec::new(), |solved| solved.pieces))
            }
        }
    }
}

/// A law with a single formula.
fn single(curve: Curve) -> Vec<Piece> {
    vec![Piece::new(1.0, curve)]
}

/// A law in two halves: `first` up to x = ½, `second` after it.
fn halves(first: Curve, second: Curve) -> Vec<Piece> {
    vec![Piece::new(0.5, first), Piece::new(1.0, second)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, TAU};

    fn rising(law: &Law) -> Vec<Piece> {
        law.unit(Arguments { parameters: law.default_parameters(), falling: false, beta: 1.0 }).expect(law.id)
    }

    /// Value with one-sided limits: the piece is given, so both sides of a joint can be asked for.
    fn spans(pieces: &[Piece]) -> Vec<(f64, f64, Piece)> {
        let mut from = 0.0;
        pieces.iter().map(|p| (std::mem::replace(&mut from, p.until), p.until, p.clone())).collect()
    }

    fn peak(pieces: &[Piece], order: usize) -> f64 {
        let mut peak = 0.0_f64;
        for (from, to, curve) in spans(pieces) {
            for i in 0..=20_000 {
                let x = from + (to - from) * f64::from(i) / 20_000.0;
                peak = peak.max(curve.at(x).order(order).abs());
            }
        }
        peak
    }

    #[test]
    fn every_law_goes_from_zero_to_one_without_a_step() {
        for law in LAWS.iter().filter(|law| !law.is_dwell()) {
            for falling in [false, true] {
                let pieces =
                    law.unit(Arguments { parameters: law.default_parameters(), falling, beta: 1.0 }).expect(law.id);
                let spans = spans(&pieces);
                assert!(spans[0].2.at(0.0).s.abs() < 1e-14, "{} starts at 0", law.id);
                let (_, end, last) = spans[spans.len() - 1].clone();
                assert!((end - 1.0).abs() < 1e-15 && (last.at(1.0).s - 1.0).abs() < 1e-13, "{} ends at 1", law.id);
                for pair in spans.windows(2) {
                    let (left, right) = (pair[0].2.at(pair[0].1), pair[1].2.at(pair[0].1));
                    assert!((left.s - right.s).abs() < 1e-14 && (left.v - right.v).abs() < 1e-13, "{}", law.id);
                }
            }
        }
    }

    #[test]
    fn derivatives_agree_with_central_differences() {
        let h = 1e-5;
        for law in LAWS {
            for (from, to, curve) in spans(&rising(law)) {
                for i in 1..20 {
                    let x = from + (to - from) * f64::from(i) / 20.0;
                    let (before, here, after) = (curve.at(x - h), curve.at(x), curve.at(x + h));
                    for order in 0..3 {
                        let slope = (after.order(order) - before.order(order)) / (2.0 * h);
                        let exact = here.order(order + 1);
                        assert!((slope - exact).abs() < 1e-6 * (1.0 + exact.abs()), "{} order {order}", law.id);
                    }
                }
            }
        }
    }

    #[test]
    fn peak_factors_are_those_of_the_handbooks() {
        let expected: &[(&str, &[f64])] = &[
            ("dwell", &[0.0, 0.0, 0.0]),
            ("constant-velocity", &[1.0, 0.0, 0.0]),
            ("parabolic", &[2.0, 4.0, 0.0]),
            ("parabolic-blend", &[4.0 / 3.0, 16.0 / 3.0, 0.0]),
            ("cubic-1", &[3.0, 12.0, 24.0]),
            ("cubic-2", &[1.5, 6.0, 12.0]),
            ("simple-harmonic", &[FRAC_PI_2, 4.9348, 15.503]),
            ("double-harmonic", &[2.0405, 9.8696, 42.41]),
            ("cycloidal", &[2.0, TAU, 39.478]),
            ("polynomial-3-4-5", &[1.875, 5.7735, 60.0]),
            ("polynomial-4-5-6-7", &[2.1875, 7.5132, 52.5]),
            ("modified-trapezoidal", &[2.0, 4.8881, 61.43]),
            ("modified-sine", &[1.7596, 5.5280, 69.47]),
        ];
        for (id, peaks) in expected {
            let pieces = rising(Law::by_id(id).expect(id));
            for (order, value) in (1..).zip(*peaks) {
                let found = peak(&pieces, order);
                assert!((found - value).abs() <= 1e-4 * value, "{id} order {order}: {found}");
            }
        }
    }

    #[test]
    fn scca_contains_the_five_classic_laws() {
        let scca = Law::by_id("scca").expect("scca");
        for (id, b, c) in [
            ("parabolic", 0.0, 1.0),
            ("simple-harmonic", 0.0, 0.0),
            ("modified-sine", 0.25, 0.0),
            ("modified-trapezoidal", 0.25, 0.5),
            ("cycloidal", 0.5, 0.0),
        ] {
            let member = scca.unit(Arguments { parameters: [b, c, 0.0], falling: false, beta: 1.0 }).expect(id);
            assert_eq!(member, rising(Law::by_id(id).expect(id)), "{id}");
        }
        let pieces = rising(Law::by_id("cycloidal").expect("cycloidal"));
        assert_eq!(pieces.len(), 1, "a cycloidal is one formula");
        for i in 0..=50 {
            let x = f64::from(i) / 50.0;
            let closed = x - (TAU * x).sin() / TAU;
            assert!((pieces[0].curve.at(x).s - closed).abs() < 1e-15);
        }
    }

    #[test]
    fn scca_refuses_fractions_that_do_not_fit() {
        let scca = Law::by_id("scca").expect("scca");
        for [b, c] in [[-0.1, 0.5], [0.7, 0.5], [1.0, 0.0], [0.5, 0.6], [0.0, 1.2]] {
            let parameters = [b, c, 0.0];
            let answer = scca.unit(Arguments { parameters, falling: false, beta: 1.0 });
            if [b, c] == [1.0, 0.0] {
                assert!(answer.is_ok(), "b = 1 is two whole sine halves");
            } else {
                assert!(answer.is_err(), "{parameters:?}");
            }
        }
    }

    #[test]
    fn double_harmonic_returns_as_its_rise_reversed() {
        let law = Law::by_id("double-harmonic").expect("double-harmonic");
        let (rise, fall) =
            (rising(law), law.unit(Arguments { parameters: [0.0; 3], falling: true, beta: 1.0 }).expect("fall"));
        for i in 0..=20 {
            let x = f64::from(i) / 20.0;
            let reversed = 1.0 - rise[0].at(1.0 - x).s;
            assert!((fall[0].curve.at(x).s - reversed).abs() < 1e-15);
        }
    }

    #[test]
    fn half_laws_rest_at_one_end_and_run_on_at_the_other() {
        for (id, start, end) in [
            ("half-harmonic-start", 0.0, FRAC_PI_2),
            ("half-harmonic-end", FRAC_PI_2, 0.0),
            ("half-cycloidal-start", 0.0, 2.0),
            ("half-cycloidal-end", 2.0, 0.0),
        ] {
            let curve = &rising(Law::by_id(id).expect(id))[0].curve;
            assert!((curve.at(0.0).v - start).abs() < 1e-15 && (curve.at(1.0).v - end).abs() < 1e-15, "{id}");
            if id.starts_with("half-cycloidal") {
                assert!(curve.at(0.0).a.abs() < 1e-15 && curve.at(1.0).a.abs() < 1e-14, "{id}");
            }
        }
    }

    #[test]
    fn names_are_unique() {
        for (i, law) in LAWS.iter().enumerate() {
            assert!(LAWS[..i].iter().all(|other| other.id != law.id), "{}", law.id);
        }
    }
}
