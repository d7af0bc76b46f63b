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

/// The columns asked for: the grid's own arrays, thinned when the grid is finer, closed by the row at the end of the cycle: the
/// first again when it comes round, the last limit from within when it does not.
pub(super) fn tabulate(cam: &Cam, mut samples: Samples, steps: usize) -> Vec<Vec<f64>> {
    let every = samples.theta.len() / steps;
    let span = cam.program.span();
    let end = (!cam.program.is_cyclic()).then(|| cam.at(span).1);
    let finish = |(mut values, last): (Vec<f64>, Option<f64>)| {
        if every > 1 {
            values = values.into_iter().step_by(every).collect();
        }
        if let Some(&first) = values.first() {
            values.push(last.filter(|_| end.is_some()).unwrap_or(first));
        }
        values
    };
    let follower = &cam.follower;
    let bends = (samples.take(Quantity::Bend), samples.last(Quantity::Bend));
    let of_bend = |radius: &dyn Fn(f64) -> f64| {
        (bends.0.iter().map(|&bend| radius(bend)).collect::<Vec<f64>>(), bends.1.map(radius))
    };
    let part = |points: &[Point], of: fn(&Contact) -> Point, part: fn(&Point) -> f64| {
        let last = end.as_ref().map(|contact| part(&cam.in_cam_frame(of(contact), span)));
        (points.iter().map(part).collect::<Vec<f64>>(), last)
    };
    // The outer wall lies as far from the trace point as the inner one, on the other side.
    let outer = |part: fn(&Point) -> f64| {
        let mirrored = |inner: &Point, trace: &Point| part(&(trace * 2.0 - inner));
        let walls = samples.profile.iter().zip(&samples.pitch).map(|(inner, trace)| mirrored(inner, trace)).collect();
        (walls, end.as_ref().map(|contact| part(&cam.in_cam_frame(contact.trace * 2.0 - contact.point, span))))
    };
    let walls = if cam.closure == Closure::Groove { [outer(|p| p.re), outer(|p| p.im)] } else { Default::default() };
    let [outer_x, outer_y] = walls;
    let mut walls = [Some(outer_x), Some(outer_y)];
    let mut of = |column: Column| {
        let mut own = |quantity: Quantity| (samples.take(quantity), samples.last(quantity));
        match column {
            Column::Theta => (std::mem::take(&mut samples.theta), Some(span)),
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
            Column::OuterX => walls[0].take().unwrap_or_default(),
            Column::OuterY => walls[1].take().unwrap_or_default(),
        }
    };
    let mut columns: Vec<Vec<f64>> = Column::ALL.into_iter().map(|column| finish(of(column))).collect();
    if let Some(last) = columns[Column::Theta as usize].last_mut() {
        *last = span;
    }
    columns
}
