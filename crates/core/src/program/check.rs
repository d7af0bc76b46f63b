//! What cannot be a program, and the segment to blame.

use super::{CLOSING_TOLERANCE, MAX_SEGMENTS, MIN_BETA, Segment, TURN_TOLERANCE};
use crate::{Cycle, ProgramError, ProgramProblem};
use std::f64::consts::TAU;

pub(super) fn check_each(cycle: Cycle, segments: &[Segment]) -> Result<(), ProgramError> {
    let refuse = |segment, problem| Err(ProgramError { segment, problem });
    let most = if cycle == Cycle::Mirrored { MAX_SEGMENTS / 2 } else { MAX_SEGMENTS };
    if segments.is_empty() || segments.len() > most {
        return refuse(0, ProgramProblem::Count { found: segments.len() });
    }
    let (given, part) = (cycle.given(), cycle.span() / TAU);
    for (k, segment) in segments.iter().enumerate() {
        if !segment.beta.is_finite() || segment.beta < MIN_BETA * part || segment.beta > given + TURN_TOLERANCE * part {
            return refuse(k, ProgramProblem::Beta { found: segment.beta });
        }
        if !segment.rise.is_finite() {
            return refuse(k, ProgramProblem::Rise { found: segment.rise });
        }
        if segment.law.is_dwell() && segment.rise != 0.0 {
            return refuse(k, ProgramProblem::DwellRises { found: segment.rise });
        }
        let joins_another = k + 1 < segments.len() || !matches!(cycle, Cycle::Travel(_));
        let next = &segments[(k + 1) % segments.len()];
        if joins_another && segment.law.is_matched() && next.law.is_matched() {
            return refuse(k, ProgramProblem::AdjacentPolynomials { next: (k + 1) % segments.len() });
        }
    }
    Ok(())
}

pub(super) fn check_cycle(
    cycle: Cycle,
    segments: &[Segment],
    borders: &[f64],
    heights: &[f64],
    beginning: f64,
) -> Result<(), ProgramError> {
    let last = segments.len() - 1;
    let (covered, height) = (borders[last + 1], heights[last + 1]);
    if (covered - cycle.given()).abs() > TURN_TOLERANCE * (cycle.span() / TAU) {
        return Err(ProgramError { segment: last, problem: ProgramProblem::Turn { found: covered } });
    }
    let free_end = cycle != Cycle::Turn;
    let checked = if free_end { heights } else { &heights[..=last] };
    if let Some(k) = checked.iter().position(|&height| height < -CLOSING_TOLERANCE) {
        return Err(ProgramError { segment: k - 1, problem: ProgramProblem::BelowBase { found: heights[k] } });
    }
    if !free_end && height.abs() > CLOSING_TOLERANCE {
        if beginning.abs() > CLOSING_TOLERANCE {
            return Err(ProgramError { segment: 0, problem: ProgramProblem::Beginning { found: beginning } });
        }
        return Err(ProgramError { segment: last, problem: ProgramProblem::Closing { found: height } });
    }
    Ok(())
}
