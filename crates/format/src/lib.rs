//! Plate cams as data: the design file, the share link, and reports in the units of a design.
//!
//! A [`Design`] is what people work with: degrees, millimetres or inches, revolutions a minute. It is read from a design
//! file ([`Design::from_json`]) or a share link ([`link::decode`]), both of them strict: what is not understood is refused
//! with its place and its reason ([`DesignError`]), never guessed. [`Design::cam`] gives the cam of `levalab-core`, and
//! [`report`] brings the analysis back into the units of the design.
//!
//! ```
//! use levalab_format::{Design, EXAMPLES, link};
//!
//! let (_, json) = EXAMPLES[0];
//! let design = Design::from_json(json)?;
//! let text = link::encode(&design).unwrap();
//! assert_eq!(link::decode(&text).unwrap(), design);
//! # Ok::<(), levalab_format::DesignError>(())
//! ```
//!
//! A change of a design is an [`Edit`]; [`apply`] makes it, whether or not the design makes a cam on the way
//! ([`Design::edited`] asks for one, and [`Design::outline`] says what is still missing). `docs/edits.md` lists the edits.
//!
//! Both formats are versioned, and every version ever published keeps opening. Laws, followers and applications are those that
//! the core lists, and their codes in a link are in `levalab-catalogue`: a new one needs nothing here.
//!
//! Not here: words for people, files on disk.

mod application;
mod auto;
mod catalogue;
mod check;
mod compare;
mod convert;
mod cure;
mod data;
mod decimal;
mod design;
mod digits;
mod edit;
mod error;
mod examples;
mod fields;
mod json;
mod kind;
pub mod limits;
pub mod link;
mod marks;
mod measure;
pub mod measured;
mod notation;
mod outline;
mod pair;
mod path;
mod read;
pub mod report;
mod study;
#[cfg(any(test, feature = "testing"))]
pub mod testing;
mod told;
mod units;
mod version;
mod write;

pub use application::{ApplicationDesign, Outcome, OutputRange, Target, TargetsBy};
pub use auto::{Joined, joined, joined_from_bytes};
pub use catalogue::Catalogue;
pub use compare::{Contender, Figures, by_law, tournament};
pub use cure::{CureJob, DesignCure, Price, Remedy, cures};
pub use data::{data_key, entry as data_entry};
pub use design::{Design, SegmentDesign, Speed, motion_and_contact};
pub use digits::clean;
pub use edit::{Completion, Edit, Left, Unit, apply, apply_to_value};
pub use error::{CamRefusal, DataRefusal, DesignError, EditRefusal, JsonFault, Kind, Problem, ProgramRefusal};
pub use examples::{EXAMPLES, FIRST_EXAMPLE, example};
pub use kind::{BreadthGenerator, CamKind, unsuited};
pub use levalab_catalogue::Version;
pub use marks::{Mark, MarkKind, marks};
pub use measure::Measure;
pub use notation::Notation;
pub use outline::Outline;
pub use pair::{Conjugate, Room};
pub use path::{Path, PathPart, quoted};
pub use study::{CamStudy, Study};
pub use told::{ToldCure, ToldFinding, ToldVerdict};
pub use units::{LengthUnit, MotionUnits, SpeedUnit};
