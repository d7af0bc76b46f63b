//! What would put a finding right: computed for the cam at hand, and tried before it is offered.

mod choice;
mod laws;

use crate::sizing::{nearest_length, smallest_size};
use crate::{Analysis, Body, Cam, Closure, Drive, Finding, FindingKind, Law, Level, Replay, balanced_eccentricity};
use laws::law_cures;

/// A change that removes a finding.
#[derive(Clone, Debug, PartialEq)]
pub enum Cure {
    /// The smallest base radius with which the geometry passes.
    BaseRadius(f64),
    /// The shortest travel with which the geometry passes, all β's in proportion.
    Travel(f64),
    /// The eccentricity that makes |φ| equal in rise and return; |φ| (radians) is then `pressure_angle`.
    Eccentricity {
        /// e.
        value: f64,
        /// The greatest |φ| that remains, radians.
        pressure_angle: f64,
    },
    /// Another length of an oscillating follower with which the geometry passes, the nearest to the present one.
    Length {
        /// The name of the parameter: `arm` or `pivot_distance`.
        key: &'static str,
        /// Its value.
        value: f64,
    },
    /// Other laws for some segments, by index; β and L stay.
    Laws {
        /// The segments to change.
        changes: Vec<(usize, &'static Law)>,
        /// The lowest order that still jumps anywhere, when one does.
        remaining_jump: Option<u8>,
    },
    /// No cure, but an advice: size alone does not put the finding right. Either no size passes, or only a size out of proportion.
    NoSize {
        /// The base radius (or the travel) with which the geometry would pass.
        needed: Option<f64>,
        /// What would put it right instead.
        instead: Instead,
    },
}

/// What puts a finding of the geometry right where size does not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instead {
    /// Less lift where the finding is, or the same over more of the turn.
    GentlerMotion,
    /// A smaller angle of the inclined face, which alone decides φ.
    SmallerFaceAngle,
    /// A motion whose velocity (or displacement) does not jump.
    SmoothMotion,
}

/// |φ| gained by a balancing eccentricity must be worth it: this many radians (half a degree) at least.
const WORTHWHILE: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// An eccentricity smaller than this part of the base radius is none.
const NO_OFFSET: f64 = 1e-6;

/// A size that a cure proposes is at most this many times the base radius and the lift together, and at least the same part of it:
/// beyond that the machine would have to be designed anew.
const BELIEVABLE_RATIO: f64 = 5.0;

/// The smallest and the largest size that a cure may propose for a cam: a length, between what the roller and a shaft leave room
/// for and five times the base radius (or the travel) and the lift together. The lift of an oscillating follower is that of the end
/// of its arm, or of a face at its pivot's distance.
#[must_use]
pub fn believable_sizes(cam: &Cam) -> (f64, f64) {
    let follower = &cam.follower;
    let (low, high) = cam.program.ranges()[0];
    let risen = high - low;
    let lever = match follower.body {
        Body::Slide => 1.0,
        Body::Swing { pivot } => follower.value("arm").unwrap_or(pivot.norm()),
    };
    let reach = cam.size() + risen * lever;
    let roller = if follower.drive == Drive::Turns { follower.value("roller_radius").unwrap_or(0.0) } else { 0.0 };
    (roller.max(reach / BELIEVABLE_RATIO), reach * BELIEVABLE_RATIO)
}

/// The cures of each finding of an analysis, in the order of the findings: the cure that keeps most of the design first, and of two
/// that keep as much the one with the lower price.
///
/// A cure keeps dwells, stretches of constant velocity and the curves of free laws, the heights at all borders and the lift. Each
/// has been tried: the finding is gone in the cam it gives, and nothing geometric is wrong there that was not before; or, for an
/// eccentricity that does not suffice, the pressure angle is lower.
#[must_use]
pub fn prescribe(cam: &Cam, analysis: &Analysis) -> Vec<Vec<Cure>> {
    Replay::whole(|replay| prescribe_in_parts(cam, analysis, replay))
}

/// The same as [`prescribe`], as a search that runs in parts. Its cost grows in proportion to the number of segments.
#[must_use]
pub fn prescribe_in_parts(cam: &Cam, analysis: &Analysis, replay: &Replay) -> Vec<Vec<Cure>> {
    let geometric = |finding: &Finding| !finding.kind.is_of_the_motion();
    let sound = !analysis.findings.iter().any(geometric);
    let sizes = if sound { Vec::new() } else { size_cures(cam, replay) };
    let of = |finding: &Finding| match finding.kind {
        // What is tolerated needs no cure; a second cam moves as the first makes it.
        FindingKind::Jump(_) | FindingKind::BelowBase
            if finding.level == Level::Acceptable || cam.follower.reversed.is_some() =>
        {
            Vec::new()
        }
        FindingKind::Jump(_) | FindingKind::BelowBase => law_cures(cam, analysis, finding.kind, replay),
        FindingKind::Doubtful | FindingKind::NotProved(_) => Vec::new(),
        FindingKind::PressureAngle if cam.follower.is_flat() && cam.follower.body == Body::Slide => {
            sizes.iter().cloned().map(by_face_angle).collect()
        }
        FindingKind::PressureAngle => with_eccentricity(&sizes, eccentricity(cam, finding, replay)),
        FindingKind::Cusp
        | FindingKind::Undercut
        | FindingKind::GrooveUndercut
        | FindingKind::ConcaveFlat
        | FindingKind::SelfCrossing => sizes.clone(),
        // Where the follower stands in the way, a gentler motion does not move it.
        FindingKind::ArmCutsCam
        | FindingKind::PivotInsideCam
        | FindingKind::FaceOvertaken
        | FindingKind::ContactPastPivot => sizes.iter().filter(|cure| !is_advice(cure)).cloned().collect(),
    };
    analysis.findings.iter().map(of).collect()
}

/// The pressure angle of a flat face that translates is the angle of the face, whatever the motion.
fn by_face_angle(cure: Cure) -> Cure {
    match cure {
        Cure::NoSize { needed, .. } => Cure::NoSize { needed, instead: Instead::SmallerFaceAngle },
        other => other,
    }
}

/// The cures of size with the balancing eccentricity after them, and an advice at the end.
fn with_eccentricity(sizes: &[Cure], eccentricity: Option<Cure>) -> Vec<Cure> {
    let (advice, mut cures): (Vec<Cure>, Vec<Cure>) = sizes.iter().cloned().partition(is_advice);
    cures.extend(eccentricity);
    cures.extend(advice);
    cures
}

fn is_advice(cure: &Cure) -> bool {
    matches!(cure, Cure::NoSize { .. })
}

/// The sizes with which every geometric limit is kept: another base circle or travel, another arm, another distance of the pivot.
fn size_cures(cam: &Cam, replay: &Replay) -> Vec<Cure> {
    if cam.follower.reversed.is_some() {
        return Vec::new();
    }
    let (low, high) = believable_sizes(cam);
    let travels = cam.follower.drive == Drive::Travels;
    let named = |size: f64| if travels { Cure::Travel(size) } else { Cure::BaseRadius(size) };
    let needed = smallest_size(cam, replay);
    let floor_passes = |size: f64| {
        size < low
            && !travels
            && replay.holds(|| cam.with_base_radius(low).is_ok_and(|cam| crate::geometry_passes(&cam)))
    };
    let size = needed.filter(|&size| travels || size >= low).filter(|&size| size <= high);
    let mut cures: Vec<Cure> =
        size.or_else(|| needed.filter(|&size| floor_passes(size)).map(|_| low)).map(named).into_iter().collect();
    for key in ["arm", "pivot_distance"] {
        let Some(index) = cam.follower.kind.index_of(key).filter(|_| !travels) else { continue };
        cures.extend(nearest_length(cam, index, (low, high), replay).map(|value| Cure::Length { key, value }));
    }
    if cures.is_empty() && needed.is_none_or(|size| size > high) {
        let broken = cam.program.classified_joints().iter().any(|joint| joint.jump.is_some_and(|order| order < 2));
        let instead = if needed.is_none() && broken { Instead::SmoothMotion } else { Instead::GentlerMotion };
        cures.push(Cure::NoSize { needed, instead });
    }
    cures
}

/// The balancing eccentricity, when it is worth having: the follower's axis moves, but the cam does not grow.
fn eccentricity(cam: &Cam, finding: &Finding, replay: &Replay) -> Option<Cure> {
    if cam.closure == Closure::Yoke || cam.follower.reversed.is_some() {
        return None;
    }
    let index = cam.follower.kind.index_of("eccentricity")?;
    let [value, pressure_angle, sound] = replay.values(|| {
        let balanced = || {
            let value = balanced_eccentricity(cam)?;
            // Rise and return that mirror each other are balanced on the axis, but for rounding.
            let value = if value.abs() < NO_OFFSET * cam.size() { 0.0 } else { value };
            let moved = cam.with_follower(cam.follower.with_value(index, value).ok()?);
            let analysis = Analysis::of(&moved, 1);
            let motion_or_angle = |f: &Finding| f.kind.is_of_the_motion() || f.kind == FindingKind::PressureAngle;
            let sound = analysis.findings.iter().all(motion_or_angle);
            Some([value, analysis.summary.pressure_angle.greatest_size().0, f64::from(u8::from(sound))])
        };
        balanced().unwrap_or([f64::NAN; 3])
    });
    let worthwhile = sound == 1.0 && pressure_angle < finding.value - WORTHWHILE;
    worthwhile.then_some(Cure::Eccentricity { value, pressure_angle })
}
