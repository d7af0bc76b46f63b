//! Programs for cams of constant breadth: half a turn that its own image completes.

use crate::law::CIRCULAR_ARC;
use crate::{Cycle, Law, Program, ProgramError, ProgramProblem, Segment};
use std::f64::consts::{FRAC_PI_2, PI};

/// Most sides of a polygon of arcs: its half turn has as many segments, and its whole turn twice as many.
pub const MAX_SIDES: u32 = 31;

/// Ready-made motions whose two halves mirror each other: s(θ) + s(θ + π) is constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Generator {
    /// The classic program: harmonic rise in 120°, dwell 60°, harmonic return in 120°, dwell 60°.
    Harmonic,
    /// Circular arcs about the corners of a regular polygon with an odd number of sides; three make Reuleaux's triangle when
    /// their corners are sharp. Under a flat face ρ takes two values, one for the arcs opposite a corner and one around it.
    CircularArc {
        /// How many sides: 3, 5, … up to [`MAX_SIDES`].
        sides: u32,
    },
}

impl Generator {
    /// The segments of half a turn for a follower that travels so far: L = dc − 2Rb. The other half is s(θ + π) = L − s(θ).
    #[must_use]
    pub fn half_turn(self, travel: f64) -> Vec<Segment> {
        match self {
            Self::Harmonic => {
                let rows = [("simple-harmonic", 120.0, travel), ("dwell", 60.0, 0.0)];
                rows.into_iter().filter_map(|(law, beta, rise)| Segment::of(law, beta, rise)).collect()
            }
            Self::CircularArc { sides } => {
                let arc = |k: u32| {
                    let rise = if k.is_multiple_of(2) { travel } else { -travel };
                    Segment::new(&CIRCULAR_ARC, PI / f64::from(sides), rise)
                };
                (0..sides).map(arc).collect()
            }
        }
    }

    /// The program of a whole turn for a follower that travels so far.
    ///
    /// # Errors
    /// When the travel is not finite, or the sides are not an odd number between 3 and [`MAX_SIDES`].
    pub fn program(self, travel: f64) -> Result<Program, ProgramError> {
        if let Self::CircularArc { sides } = self
            && !(sides % 2 == 1 && (3..=MAX_SIDES).contains(&sides))
        {
            let problem = ProgramProblem::Count { found: sides as usize };
            return Err(ProgramError { segment: 0, problem });
        }
        Program::on(Cycle::Mirrored, &self.half_turn(travel))
    }

    /// The laws it is made of, for tables that name them.
    #[must_use]
    pub fn law(self) -> &'static Law {
        match self {
            Self::Harmonic => self.half_turn(1.0)[0].law,
            Self::CircularArc { .. } => &CIRCULAR_ARC,
        }
    }
}

/// The smallest base radius of a cam of arcs of that breadth: its corners are then sharp, and the arcs about them points.
///
/// With circumradius c and radius r about the corners, Rb = r + c(2k − 1) and dc = 2r + 2ck, k = cos(π/2n); r = 0 gives
/// Rb = dc·(1 − 1/2k).
#[must_use]
pub fn sharpest_base_radius(sides: u32, breadth: f64) -> f64 {
    let k = (FRAC_PI_2 / f64::from(sides)).cos();
    breadth * (1.0 - 0.5 / k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Analysis, Cam, Closure, Column, FindingKind, Follower, Level};

    fn flat(program: Program, base_radius: f64) -> Cam {
        Cam::new(program, Follower::translating_flat(base_radius).expect("it rests")).closed_by(Closure::Yoke)
    }

    #[test]
    fn the_classic_program_is_acceptable_by_the_exception() {
        let cam = flat(Generator::Harmonic.program(20.0).expect("program"), 40.0);
        assert_eq!(cam.breadth(), Some(100.0));
        let analysis = Analysis::of(&cam, 360);
        assert_eq!(analysis.level, Level::Acceptable, "{:?}", analysis.findings);
        assert!(
            analysis.findings.iter().any(|finding| finding.kind == FindingKind::Jump(2)),
            "the jumps are still told"
        );
        let forced = Analysis::of(&cam.closed_by(Closure::Force), 360);
        assert_eq!(forced.level, Level::Unacceptable, "a spring would not tolerate them");
    }

    #[test]
    fn arcs_have_constant_radii_and_a_constant_breadth() {
        for sides in (3..=MAX_SIDES).step_by(2) {
            let (breadth, base_radius): (f64, f64) = (100.0, 49.0_f64.max(sharpest_base_radius(sides, 100.0) + 0.01));
            let travel = breadth - 2.0 * base_radius;
            let cam = flat(Generator::CircularArc { sides }.program(travel).expect("arcs"), base_radius);
            let analysis = Analysis::of(&cam, 720);
            // c from the travel, r from the base radius, as in the drawing of the polygon.
            let k = (FRAC_PI_2 / f64::from(sides)).cos();
            let c = travel / (2.0 * (1.0 - k));
            let r = base_radius - c * (2.0 * k - 1.0);
            let rho = analysis.column(Column::Rho).expect("ρ");
            let scale = 1e-12 * (c + breadth);
            for value in rho {
                let nearest = (value - r).abs().min((value - (breadth - r)).abs());
                assert!(nearest < scale, "{sides} sides: ρ {value}, arcs {r} and {}", breadth - r);
            }
            let measured = analysis.summary.breadth.expect("a yoke");
            assert!((measured.max - breadth).abs() < scale && (measured.min - breadth).abs() < scale, "{sides} sides");
            assert!(analysis.level <= Level::Acceptable, "{:?}", analysis.findings);
        }
    }

    #[test]
    fn sharp_corners_are_cusps() {
        let base_radius = sharpest_base_radius(3, 100.0);
        assert!(
            (base_radius - 100.0 * (1.0 - 1.0 / 3_f64.sqrt())).abs() < 1e-12,
            "the inradius of Reuleaux's triangle"
        );
        let cam =
            flat(Generator::CircularArc { sides: 3 }.program(100.0 - 2.0 * base_radius).expect("arcs"), base_radius);
        let findings = Analysis::of(&cam, 720).findings;
        assert!(findings.iter().any(|finding| finding.kind == FindingKind::Cusp), "{findings:?}");
    }

    #[test]
    fn even_or_too_many_sides_are_refused() {
        for sides in [0, 1, 2, 4, 32, 33] {
            assert!(Generator::CircularArc { sides }.program(1.0).is_err(), "{sides}");
        }
    }

    #[test]
    fn any_half_turn_is_completed_by_its_image() {
        let rows = [("double-harmonic", 70.0, 12.0), ("polynomial-7", 30.0, 3.0), ("cycloidal", 80.0, -5.0)];
        let half: Vec<Segment> = rows.iter().filter_map(|&(law, beta, rise)| Segment::of(law, beta, rise)).collect();
        let program = Program::on(Cycle::Mirrored, &half).expect("half a turn");
        for i in 0..200 {
            let theta = PI * f64::from(i) / 200.0;
            let (here, there) = (program.at(theta), program.at(theta + PI));
            assert!((here.s + there.s - 10.0).abs() < 1e-12 && (here.v + there.v).abs() < 1e-12);
        }
        assert!(program.classified_joints().iter().all(|joint| joint.jump.is_none_or(|order| order > 1)));
        assert_eq!((program.segments().len(), program.borders().len(), program.given().len()), (6, 7, 3));
    }
}
