//! Plate cams (leva y seguidor): motion laws, followers, profiles and an honest verdict.
//!
//! A [`Program`] joins [`Segment`]s of motion [`law`]s into one cyclic turn; a [`Follower`] rests on a base circle; together
//! they are a [`Cam`], and [`Analysis`] says everything about it: motion, profile, pressure angle, radius of curvature,
//! and what is wrong. [`prescribe`] says what would put it right.
//!
//! ```
//! use levalab_core::{Analysis, Cam, Follower, Level, Program, Segment};
//!
//! let program = Program::new(&[
//!     Segment::of("cycloidal", 120.0, 20.0).unwrap(),
//!     Segment::of("dwell", 60.0, 0.0).unwrap(),
//!     Segment::of("cycloidal", 120.0, -20.0).unwrap(),
//!     Segment::of("dwell", 60.0, 0.0).unwrap(),
//! ])?;
//! let follower = Follower::translating_roller(40.0, 10.0)?;
//! let analysis = Analysis::of(&Cam::new(program, follower), 360);
//! assert_eq!(analysis.level, Level::LowSpeed); // a cycloidal's jerk steps where a dwell begins
//! # Ok::<(), levalab_core::CamError>(())
//! ```
//!
//! * Angles are radians and derivatives are with respect to θ. Lengths are in whatever unit the design uses.
//! * The cam turns about the origin; the follower is on top and positive *s* lifts it. σ = +1 is counter-clockwise.
//! * What cannot be a cam is a [`CamError`]; what can, but should not, is a [`Finding`].
//!
//! Not here: files, links, words, drawings. Elastic followers, clearances and the thickness of arms are left out.

mod analysis;
pub mod application;
mod arm;
mod breadth;
mod cam;
mod conjugate;
mod cure;
mod curve;
mod cycle;
mod error;
mod expression;
mod extreme;
mod finding;
mod follower;
mod form;
mod interference;
mod join;
pub mod law;
mod parameter;
mod program;
mod replay;
mod samples;
mod search;
mod series;
mod sizing;
mod stretch;
mod svaj;

pub use analysis::{Analysis, Column, Face, Summary};
pub use breadth::{Generator, MAX_SIDES, sharpest_base_radius};
pub use cam::{Cam, Closure};
pub use conjugate::{
    Tie, angle_between, balanced_tie, conjugate, nearest_tie, profiles_coincide, working_ties, working_ties_in_parts,
};
pub use cure::{Cure, Instead, believable_sizes, prescribe, prescribe_in_parts};
pub use curve::{Curve, MAX_COEFFICIENTS, Wave};
pub use cycle::Cycle;
pub use error::{CamError, GeometryError, GeometryProblem, Misfit, ProgramError, ProgramProblem};
pub use expression::{
    Constant as ExpressionConstant, Expression, ExpressionFault, ExpressionProblem, Formula,
    Function as ExpressionFunction, MAX_EXPRESSION, Op as ExpressionOp, Roughness, RoughnessCause, Unproved, Variables,
};
pub use extreme::Extremes;
pub use finding::{Finding, FindingKind, Level};
pub use follower::{
    Body, Contact, ContactKind, Drive, Element, FOLLOWERS, Follower, FollowerKind, FollowerValues,
    MAX_FOLLOWER_PARAMETERS, Motion, Point, Rotation,
};
pub use form::Form;
pub use join::{Choice, Demand, JoinError, JoinProblem, Joining, Reason, Taste, Tried, Way, join};
pub use law::{LAWS, Law};
pub use parameter::{Parameter, Quantity};
pub use program::{CLOSING_TOLERANCE, Doubt, Joint, MAX_SEGMENTS, MIN_BETA, Program, Segment, TURN_TOLERANCE};
pub use replay::Replay;
pub use series::Series;
pub use sizing::{
    SizeLimit, balanced_eccentricity, geometry_passes, resized, shortest_travel, smallest_base_radius, smallest_for,
};
pub use stretch::Stretch;
pub use svaj::Svaj;
