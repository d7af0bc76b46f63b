//! Everything that has a value at each station, as columns.

use crate::samples::{Quantity, Samples};
use crate::{Cam, Closure, Contact, Point};

/// A column of the analysis, in the units of the core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// θ, radians.
    Theta,
    /// Displacement.
    S,
    /// ds/dθ.
    V,
    /// d²s/dθ².
    A,
    /// d³s/dθ³.
    J,
    /// φ, radians.
    PressureAngle,
    /// ρ of the profile.
    Rho,
    /// ρp of the pitch curve.
    RhoPitch,
    /// Profile in the cam's frame.
    X,
    /// Profile in the cam's frame.
    Y,
    /// Pitch curve in the cam's frame.
    PitchX,
    /// Pitch curve in the cam's frame.
    PitchY,
    /// Contact on a flat face.
    Contact,
    /// Outer wall of a groove in the cam's frame.
    OuterX,
    /// Outer wall of a groove in the cam's frame.
    OuterY,
}

impl Column {
    /// Every column, in the order of reports.
    pub const ALL: [Self; 15] = [
        Self::Theta,
        Self::S,
        Self::V,
        Self::A,
        Self::J,
        Self::PressureAngle,
        Self::Rho,
        Self::RhoPitch,
        Self::X,
        Self::Y,
        Self::PitchX,
        Self::PitchY,
        Self::Contact,
        Self::OuterX,
        Self::OuterY,
    ];

    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Theta => "theta",
            Self::S => "s",
            Self::V => "v",
            Self::A => "a",
            Self::J => "j",
            Self::PressureAngle => "pressure_angle",
            Self::Rho => "rho",
            Self::RhoPitch => "rho_pitch",
            Self::X => "x",
            Self::Y => "y",
            Self::PitchX => "pitch_x",
            Self::PitchY => "pitch_y",
            Self::Contact => "contact",
            Self::OuterX => "outer_x",
            Self::OuterY => "outer_y",
        }
    }
}

/// The columns asked for: what was sampled at the stations of the grid, thinned when it is finer, closed by the row at the end of the
/// cycle: the first again when it comes round, the last limit from within when it does not.
pub(super) fn tabulate(cam: &Cam, samples: &Samples, steps: usize) -> Vec<Vec<f64>> {
    let every = samples.stations() / steps;
    let span = cam.program.span();
    let end = (!cam.program.is_cyclic()).then(|| cam.at(span).1);
    let follower = &cam.follower;
    let own = |quantity: Quantity| samples.rows(quantity, every);
    let of_bend = |radius: &dyn Fn(f64) -> f64| {
        let (mut bends, last) = own(Quantity::Bend);
        bends.iter_mut().for_each(|bend| *bend = radius(*bend));
        (bends, last.map(radius))
    };
    let part = |points: &[Point], of: fn(&Contact) -> Point, part: fn(&Point) -> f64| {
        let last = end.as_ref().map(|contact| part(&cam.in_cam_frame(of(contact), span)));
        (with_room(points.iter().step_by(every).map(part)), last)
    };
    // The outer wall lies as far from the trace point as the inner one, on the other side.
    let outer = |part: fn(&Point) -> f64| {
        if cam.closure != Closure::Groove {
            return Default::default();
        }
        let mirrored = |(inner, trace): (&Point, &Point)| part(&(trace * 2.0 - inner));
        let walls = samples.profile.iter().zip(&samples.pitch).step_by(every).map(mirrored);
        (
            with_room(walls),
            end.as_ref().map(|contact| part(&cam.in_cam_frame(contact.trace * 2.0 - contact.point, span))),
        )
    };
    let of = |column: Column| match column {
        Column::Theta => (with_room((0..steps).map(|row| samples.station(row * every))), Some(span)),
        Column::S => own(Quantity::S),
        Column::V => own(Quantity::V),
        Column::A => own(Quantity::A),
        Column::J => own(Quantity::J),
        Column::PressureAngle => own(Quantity::PressureAngle),
        Column::Rho => of_bend(&|bend| follower.profile_radius(bend)),
        Column::RhoPitch if follower.is_flat() => Default::default(),
        Column::RhoPitch => of_bend(&|bend| 1.0 / bend),
        Column::X => part(&samples.profile, |contact| contact.point, |point| point.re),
        Column::Y => part(&samples.profile, |contact| contact.point, |point| point.im),
        Column::PitchX => part(&samples.pitch, |contact| contact.trace, |point| point.re),
        Column::PitchY => part(&samples.pitch, |contact| contact.trace, |point| point.im),
        Column::Contact => own(Quantity::Reach),
        Column::OuterX => outer(|point| point.re),
        Column::OuterY => outer(|point| point.im),
    };
    let closed = |column: Column| {
        let (mut values, last) = of(column);
        if let Some(&first) = values.first() {
            let comes_round = end.is_none() && column != Column::Theta;
            values.push(last.filter(|_| !comes_round).unwrap_or(first));
        }
        values
    };
    Column::ALL.into_iter().map(closed).collect()
}

/// Values in a list that has room for the row at the end.
fn with_room(values: impl ExactSizeIterator<Item = f64>) -> Vec<f64> {
    let mut list = Vec::with_capacity(values.len() + 1);
    list.extend(values);
    list
}
