//! Plate cams for other programs: tables for spreadsheets, drawings for CAD and paper, a solid for a printer.
//!
//! A [`Subject`] is a design with its cam and the language to write in. From it come tables ([`Table`]: [`csv()`], [`xlsx()`]),
//! drawings to scale ([`dxf()`], [`cam_svg`]), diagrams with their names ([`diagram_svg`]), pixels (`png`, with the feature of that
//! name) and a solid ([`stl()`]). All of them are made from the same columns as `levalab analyze`.
//!
//! ```
//! use levalab_export::{Separator, Step, Subject, Table, csv};
//! use levalab_format::{Study, example};
//! use levalab_words::Language;
//!
//! let study = Study::without_columns(example("9RT").unwrap())?;
//! let subject = Subject { study: &study, language: Language::Es };
//! let text = csv(&subject, Table::Everything, Step::of_degrees(10.0).unwrap(), Separator::Semicolon);
//! assert_eq!(text.lines().nth(4).unwrap().split(';').nth(2).unwrap(), "6,72134812486");
//! # Ok::<(), levalab_format::DesignError>(())
//! ```
//!
//! Not here: files on disk, the printed report, G-code.

mod application_sheet;
mod cam_drawing;
mod csv;
mod curves;
mod diagram;
mod dxf;
mod follower_drawing;
mod order;
mod paper;
#[cfg(feature = "png")]
mod png;
mod refusal;
mod shaft;
mod sheets;
mod solid;
mod step;
mod stl;
mod subject;
mod svg;
mod table;
mod verdict_sheet;
mod words;
mod xlsx;

pub use cam_drawing::{CamDrawing, cam_svg};
pub use csv::{Separator, csv};
pub use diagram::{DiagramChoice, diagram_svg};
pub use dxf::dxf;
pub use order::{Format, Order};
#[cfg(feature = "png")]
pub use png::png;
pub use refusal::Refusal;
pub use shaft::{Keyway, Shaft};
pub use step::Step;
pub use stl::stl;
pub use subject::Subject;
pub use table::Table;
pub use xlsx::xlsx;
