//! Which tables there are, and the quantities in their columns.

use crate::Subject;
use crate::words::Word;
use levalab_core::{Analysis, Column, Point};
use levalab_format::report;
use levalab_words::Signs;

/// A table of a cam: a sheet of the workbook, or a file of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Table {
    /// Every quantity there is, row by row.
    Everything,
    /// The design, magnitude by magnitude.
    Design,
    /// Displacement and its derivatives, by angle and by time.
    Motion,
    /// The profile by angle and radius.
    Polar,
    /// The profile by x and y.
    Cartesian,
    /// The pitch curve.
    Pitch,
    /// The verdict with its findings, and the extremes.
    Verdict,
    /// What the follower drives, and the points to hit.
    Application,
}

impl Table {
    /// Every table, in the order of a menu.
    pub const ALL: [Self; 8] = [
        Self::Everything,
        Self::Design,
        Self::Motion,
        Self::Polar,
        Self::Cartesian,
        Self::Pitch,
        Self::Verdict,
        Self::Application,
    ];

    /// The sheets of a workbook: nothing is in it twice.
    pub(crate) const SHEETS: [Self; 7] =
        [Self::Design, Self::Motion, Self::Polar, Self::Cartesian, Self::Pitch, Self::Verdict, Self::Application];

    /// Its name in options.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Everything => "everything",
            Self::Design => "design",
            Self::Motion => "motion",
            Self::Polar => "polar",
            Self::Cartesian => "cartesian",
            Self::Pitch => "pitch-curve",
            Self::Verdict => "verdict",
            Self::Application => "application",
        }
    }

    /// The table of that name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|table| table.name() == name)
    }

    /// Its columns, when it has a row for each angle.
    pub(crate) fn measures(self) -> &'static [Measure] {
        use Measure as M;
        match self {
            Self::Everything => &Measure::ALL,
            Self::Motion => &[
                M::Theta,
                M::Time,
                M::S,
                M::V,
                M::A,
                M::J,
                M::TimedV,
                M::TimedA,
                M::TimedJ,
                M::PressureAngle,
                M::Contact,
            ],
            Self::Polar => &[M::Theta, M::Angle, M::Radius, M::Rho, M::OuterAngle, M::OuterRadius],
            Self::Cartesian => &[M::Theta, M::X, M::Y, M::OuterX, M::OuterY],
            Self::Pitch => &[M::Theta, M::PitchX, M::PitchY, M::PitchAngle, M::PitchRadius, M::RhoPitch],
            Self::Design | Self::Verdict | Self::Application => &[],
        }
    }
}

/// A quantity that has a value at every angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    Theta,
    Time,
    S,
    V,
    A,
    J,
    TimedV,
    TimedA,
    TimedJ,
    PressureAngle,
    Rho,
    RhoPitch,
    Contact,
    X,
    Y,
    Angle,
    Radius,
    PitchX,
    PitchY,
    PitchAngle,
    PitchRadius,
    OuterX,
    OuterY,
    OuterAngle,
    OuterRadius,
}

impl Measure {
    const ALL: [Self; 25] = [
        Self::Theta,
        Self::Time,
        Self::S,
        Self::V,
        Self::A,
        Self::J,
        Self::TimedV,
        Self::TimedA,
        Self::TimedJ,
        Self::PressureAngle,
        Self::Rho,
        Self::RhoPitch,
        Self::Contact,
        Self::X,
        Self::Y,
        Self::Angle,
        Self::Radius,
        Self::PitchX,
        Self::PitchY,
        Self::PitchAngle,
        Self::PitchRadius,
        Self::OuterX,
        Self::OuterY,
        Self::OuterAngle,
        Self::OuterRadius,
    ];

    /// What stands over its column: name, symbol and unit.
    pub fn head(self, subject: &Subject) -> String {
        let word = match self {
            Self::Theta if subject.travels() => Word::CamTravel,
            Self::Theta => Word::CamAngle,
            Self::Time => Word::Time,
            Self::S => Word::Displacement,
            Self::V | Self::TimedV => Word::Velocity,
            Self::A | Self::TimedA => Word::Acceleration,
            Self::J | Self::TimedJ => Word::Jerk,
            Self::PressureAngle => Word::PressureAngle,
            Self::Rho => Word::Curvature,
            Self::RhoPitch => Word::PitchCurvature,
            Self::Contact => Word::Contact,
            Self::X | Self::Y => Word::Profile,
            Self::Angle => Word::ProfileAngle,
            Self::Radius => Word::ProfileRadius,
            Self::PitchX | Self::PitchY => Word::PitchCurve,
            Self::PitchAngle => Word::PitchAngle,
            Self::PitchRadius => Word::PitchRadius,
            Self::OuterX | Self::OuterY => Word::OuterWall,
            Self::OuterAngle => Word::OuterAngle,
            Self::OuterRadius => Word::OuterRadius,
        };
        let ours = if self == Self::Theta && subject.travels() { "x" } else { self.symbol() };
        // Coordinates and angles of the profile are no magnitudes of a notation.
        let symbol = match self {
            Self::X | Self::PitchX | Self::OuterX | Self::Y | Self::PitchY | Self::OuterY => ours.to_owned(),
            _ => Signs::of(subject.design().notation).plain(ours),
        };
        match self.unit(subject) {
            unit if unit.is_empty() => format!("{} {symbol}", word.said(subject.language)),
            unit => format!("{} {symbol} ({unit})", word.said(subject.language)),
        }
    }

    fn symbol(self) -> &'static str {
        match self {
            Self::Theta => "θ",
            Self::Time => "t",
            Self::S => "s",
            Self::V => "v",
            Self::A => "a",
            Self::J => "j",
            Self::TimedV => "V",
            Self::TimedA => "A",
            Self::TimedJ => "J",
            Self::PressureAngle => "φ",
            Self::Rho => "ρ",
            Self::RhoPitch => "ρ_p",
            Self::Contact => "q",
            Self::X | Self::PitchX | Self::OuterX => "x",
            Self::Y | Self::PitchY | Self::OuterY => "y",
            Self::Angle | Self::PitchAngle | Self::OuterAngle => "ψ",
            Self::Radius | Self::PitchRadius | Self::OuterRadius => "r",
        }
    }

    fn unit(self, subject: &Subject) -> String {
        let degrees = || "°".to_owned();
        match self {
            Self::Theta if subject.travels() => subject.design().length_unit.symbol().to_owned(),
            Self::Theta | Self::PressureAngle | Self::Angle | Self::PitchAngle | Self::OuterAngle => degrees(),
            Self::Time => "s".to_owned(),
            Self::S => subject.unit(0, false),
            Self::V => subject.unit(1, false),
            Self::A => subject.unit(2, false),
            Self::J => subject.unit(3, false),
            Self::TimedV => subject.unit(1, true),
            Self::TimedA => subject.unit(2, true),
            Self::TimedJ => subject.unit(3, true),
            _ => subject.design().length_unit.symbol().to_owned(),
        }
    }

    /// Its values at every step of the analysis; nothing when it does not apply.
    pub fn values(self, subject: &Subject, analysis: &Analysis) -> Option<Vec<f64>> {
        let of = |column| report::column(subject.design(), analysis, column);
        let omega = subject.design().omega();
        let times = |column, factor: f64| Some(of(column)?.into_iter().map(|value| value * factor).collect());
        let turned = |x, y, value: fn(Point) -> f64| {
            Some(of(x)?.into_iter().zip(of(y)?).map(|(x, y)| value(Point::new(x, y))).collect())
        };
        match self {
            Self::Theta => of(Column::Theta),
            Self::Time if subject.travels() => times(Column::Theta, 1.0 / omega),
            Self::Time => times(Column::Theta, 1_f64.to_radians() / omega),
            Self::S => of(Column::S),
            Self::V => of(Column::V),
            Self::A => of(Column::A),
            Self::J => of(Column::J),
            Self::TimedV => times(Column::V, omega),
            Self::TimedA => times(Column::A, omega.powi(2)),
            Self::TimedJ => times(Column::J, omega.powi(3)),
            Self::PressureAngle => of(Column::PressureAngle),
            Self::Rho => of(Column::Rho),
            Self::RhoPitch => of(Column::RhoPitch),
            Self::Contact => of(Column::Contact),
            Self::X => of(Column::X),
            Self::Y => of(Column::Y),
            // A cam that travels has no centre.
            Self::Angle | Self::Radius | Self::PitchAngle | Self::PitchRadius if subject.travels() => None,
            Self::OuterX => of(Column::OuterX),
            Self::OuterY => of(Column::OuterY),
            Self::OuterAngle => turned(Column::OuterX, Column::OuterY, direction),
            Self::OuterRadius => turned(Column::OuterX, Column::OuterY, Point::norm),
            Self::Angle => turned(Column::X, Column::Y, direction),
            Self::Radius => turned(Column::X, Column::Y, Point::norm),
            Self::PitchX => of(Column::PitchX),
            Self::PitchY => of(Column::PitchY),
            Self::PitchAngle => turned(Column::PitchX, Column::PitchY, direction),
            Self::PitchRadius => turned(Column::PitchX, Column::PitchY, Point::norm),
        }
    }
}

/// Degrees from +x, 0 ≤ ψ < 360.
fn direction(point: Point) -> f64 {
    let degrees = report::degrees(point.arg());
    if degrees < 0.0 { degrees + 360.0 } else { degrees }
}
