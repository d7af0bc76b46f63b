//! Segments that come, go and move, and the ways to complete a program.

use super::data::{scaled_heights, set_end};
use super::law::with_law;
use super::{Completion, has_segment, no_item, refused};
use crate::data::{stated_end, stretched};
use crate::decimal::Decimal;
use crate::digits::{DIGITS, clean, magnitude, round, rounded_at};
use crate::limits::MAX_SEGMENTS;
use crate::{CamRefusal, Design, DesignError, EditRefusal, Path, ProgramRefusal, SegmentDesign};
use levalab_core::Law;
use levalab_core::law::{Data, MAX_LAW_PARAMETERS};

/// Significant digits of β's that are spread, of the largest.
const SPREAD_DIGITS: i32 = 5;

/// A segment that stays at its height.
pub(super) fn dwell(beta: f64) -> SegmentDesign {
    plain("dwell", beta, 0.0)
}

/// A segment by a law that has no parameters and no data.
pub(super) fn plain(law: &str, beta: f64, rise: f64) -> SegmentDesign {
    let law = Law::by_id(law).unwrap_or(levalab_core::LAWS[0]);
    SegmentDesign { law, beta, rise, parameters: [0.0; MAX_LAW_PARAMETERS], data: Data::None }
}

pub(super) fn insert(design: &mut Design, at: usize, from: usize) -> Result<(), DesignError> {
    has_own_program(design)?;
    let count = design.segments.len();
    if at > count {
        return Err(no_item(&Path::from("segments").join(at), at, count));
    }
    has_room(count + 1)?;
    let left = design.left();
    let beta = if left > Decimal::default() {
        left.to_f64()
    } else if count == 0 {
        design.kind.whole()
    } else {
        has_segment(design, from)?;
        let giver = &mut design.segments[from];
        let half = clean(giver.beta / 2.0);
        *giver = stretched(giver, (Decimal::of(giver.beta) - Decimal::of(half)).to_f64());
        half
    };
    design.segments.insert(at, dwell(beta));
    Ok(())
}

pub(super) fn duplicate(design: &mut Design, segment: usize) -> Result<(), DesignError> {
    has_segment(design, segment)?;
    has_room(design.segments.len() + 1)?;
    let copy = design.segments[segment].clone();
    design.segments.insert(segment, copy);
    Ok(())
}

pub(super) fn delete(design: &mut Design, segments: &[usize]) -> Result<(), DesignError> {
    segments.iter().try_for_each(|&segment| has_segment(design, segment))?;
    let mut place = 0..;
    design.segments.retain(|_| place.next().is_none_or(|k| !segments.contains(&k)));
    if design.segments.is_empty() {
        return Err(DesignError::at("segments", ProgramRefusal::NoSegments));
    }
    Ok(())
}

pub(super) fn shift(design: &mut Design, from: usize, to: usize) -> Result<(), DesignError> {
    has_segment(design, from)?;
    has_segment(design, to)?;
    let segment = design.segments.remove(from);
    design.segments.insert(to, segment);
    Ok(())
}

pub(super) fn set_beta(design: &mut Design, segment: usize, beta: f64) -> Result<(), DesignError> {
    has_segment(design, segment)?;
    design.segments[segment] = stretched(&design.segments[segment], beta);
    Ok(())
}

pub(super) fn scale(design: &mut Design, factor: f64) -> Result<(), DesignError> {
    has_own_program(design)?;
    let scaled = |height: Decimal| Decimal::of(clean(height.to_f64() * factor));
    let heights: Vec<Decimal> = design.draft_heights().into_iter().map(scaled).collect();
    scale_to(design, &heights, factor, factor);
    Ok(())
}

/// Multiplies what lies within the segments, and takes the heights at the borders from a list, so that rounding does not add up.
pub(super) fn scale_to(design: &mut Design, heights: &[Decimal], factor: f64, in_formulas: f64) {
    for (k, segment) in design.segments.iter_mut().enumerate() {
        if segment.rise != 0.0 {
            segment.rise = (heights[k + 1] - heights[k]).to_f64();
        }
        scaled_heights(segment, factor, in_formulas);
        if stated_end(segment).is_some() {
            set_end(segment, heights[k + 1].to_f64());
        }
    }
}

pub(super) fn complete(design: &mut Design, completion: Completion) -> Result<(), DesignError> {
    has_own_program(design)?;
    match completion {
        Completion::Dwell => fill_with_dwell(design),
        Completion::Return => fill_with_return(design),
        Completion::Stretch => stretch_last(design),
        Completion::Spread => spread(design),
        Completion::Close => close(design),
    }
}

fn fill_with_dwell(design: &mut Design) -> Result<(), DesignError> {
    let left = something_left(design)?;
    design.segments.push(dwell(left.to_f64()));
    Ok(())
}

fn fill_with_return(design: &mut Design) -> Result<(), DesignError> {
    let left = something_left(design)?;
    let open = design.open_height();
    if open == Decimal::default() {
        return refused(EditRefusal::NothingLeft);
    }
    let (beta, rise) = (left.to_f64(), (-open).to_f64());
    let beside_matched = [design.segments.first(), design.segments.last()];
    let matched = beside_matched.into_iter().flatten().any(|segment| segment.law.is_matched());
    let model = design.segments.iter().rev().find(|segment| segment.rise != 0.0 && segment.law.free().is_none());
    let model = model.filter(|model| !(matched && model.law.is_matched()));
    design.segments.push(match model {
        Some(model) => SegmentDesign { rise, ..stretched(model, beta) },
        None => plain("cycloidal", beta, rise),
    });
    Ok(())
}

/// What is left of the cycle, when that is something and there is room for a segment more.
fn something_left(design: &Design) -> Result<Decimal, DesignError> {
    has_room(design.segments.len() + 1)?;
    let left = design.left();
    if left > Decimal::default() { Ok(left) } else { refused(EditRefusal::NothingLeft) }
}

fn stretch_last(design: &mut Design) -> Result<(), DesignError> {
    let left = design.left();
    let Some(last) = design.segments.last_mut() else { return refused(EditRefusal::LastTooShort) };
    let beta = Decimal::of(last.beta) + left;
    if beta <= Decimal::default() {
        return refused(EditRefusal::LastTooShort);
    }
    *last = stretched(last, beta.to_f64());
    Ok(())
}

/// Every β in proportion, in five figures of the whole. The last one takes the rounding, or the longest where the last is too
/// short for that.
pub(super) fn spread(design: &mut Design) -> Result<(), DesignError> {
    let whole = design.kind.whole();
    let turn: Decimal = design.segments.iter().map(|segment| Decimal::of(segment.beta)).sum();
    if turn <= Decimal::default() || whole <= 0.0 {
        return refused(EditRefusal::NothingLeft);
    }
    let factor = whole / turn.to_f64();
    let place = magnitude(whole) + 1 - SPREAD_DIGITS;
    for segment in &mut design.segments {
        let exact = segment.beta * factor;
        let rounded = rounded_at(exact, place, f64::round);
        // A sliver keeps digits of its own.
        let beta = if rounded == 0.0 { round(exact, DIGITS, f64::round) } else { rounded };
        *segment = stretched(segment, beta);
    }
    let left = design.left();
    let taken = |segment: &SegmentDesign| Decimal::of(segment.beta) + left;
    let longest = || design.segments.iter().enumerate().max_by(|a, b| a.1.beta.total_cmp(&b.1.beta)).map(|(k, _)| k);
    let last = design.segments.len().checked_sub(1).filter(|&k| taken(&design.segments[k]) > Decimal::default());
    if let Some(k) = last.or_else(longest) {
        design.segments[k] = stretched(&design.segments[k], taken(&design.segments[k]).to_f64());
    }
    Ok(())
}

fn close(design: &mut Design) -> Result<(), DesignError> {
    let Some(k) = design.last_move() else { return refused(EditRefusal::NothingMoves) };
    let heights = design.draft_heights();
    let end = heights[k + 1] - design.open_height();
    let segment = &mut design.segments[k];
    if !set_end(segment, end.to_f64()) {
        segment.rise = (end - heights[k]).to_f64();
    }
    Ok(())
}

/// Refuses a program for a cam whose motion is ready-made.
fn has_own_program(design: &Design) -> Result<(), DesignError> {
    match design.kind.generator() {
        Some(_) => Err(DesignError::at("segments", CamRefusal::Unsuited { kind: design.kind.word() })),
        None => Ok(()),
    }
}

/// Refuses more segments than a program may have.
pub(super) fn has_room(found: usize) -> Result<(), DesignError> {
    if found <= MAX_SEGMENTS {
        return Ok(());
    }
    Err(DesignError::at("segments", ProgramRefusal::TooManySegments { found, limit: MAX_SEGMENTS }))
}

/// A segment that leads from one height to another by a law that fits anywhere.
pub(super) fn bridge(beta: f64, rise: f64) -> SegmentDesign {
    let law = if rise == 0.0 { "dwell" } else { "cycloidal" };
    let segment = plain(law, beta, rise);
    with_law(&segment, segment.law, 0.0, rise)
}
