//! Diagrams of a cam over one turn: s, v, a, j, pressure angle and radius of curvature.
//!
//! A [`Diagram`] is gathered from a cam and its analysis: a curve that breaks exactly where the quantity jumps, the limits
//! and the extremes. [`draw`] lays it out in the space that a [`Style`] gives and draws it with plotters on any
//! [`DrawingBackend`](plotters::prelude::DrawingBackend); [`svg`] is the same drawing as text. Both return the [`PlotArea`],
//! so that a cursor can be laid over the drawing to the pixel.
//!
//! ```
//! use levalab_chart::{Diagram, Quantity, Style, Timing, svg};
//! use levalab_core::{Analysis, Cam, Follower, Program, Segment};
//!
//! let rows = [("parabolic", 180.0, 20.0), ("parabolic", 180.0, -20.0)];
//! let segments = rows.map(|(law, beta, rise)| Segment::of(law, beta, rise).unwrap());
//! let cam = Cam::new(Program::new(&segments)?, Follower::translating_knife(40.0)?);
//! let diagram = Diagram::of(Quantity::A, &cam, &Analysis::of(&cam, 720), Timing::PerRadian);
//! let (text, area) = svg(&diagram, &Style { width: 420.0, height: 110.0, ..Style::default() });
//! assert!(text.starts_with("<svg") && area.x_max == 360.0);
//! # Ok::<(), levalab_core::CamError>(())
//! ```
//!
//! * Backends of plotters draw at whole coordinates, so everything is laid out in units of 1/[`SUBPIXELS`] of a pixel: slow
//!   curves stay smooth and strokes keep their widths. The surface is scaled down by as much.
//! * Text is never measured: only numbers are drawn, and their widths are known well enough. Names and units belong to
//!   whoever shows the diagram.
//!
//! Not here: the moving cursor, captions, colours of a theme.

mod axes;
mod diagram;
mod extremes;
mod frame;
mod gather;
mod paint;
mod quantity;
mod radius;
mod sketch;
mod space;
mod style;
mod svg;
mod thin;
mod ticks;
mod trace;

pub use diagram::Diagram;
pub use frame::PlotArea;
pub use paint::draw;
pub use quantity::{Quantity, Timing};
pub use style::{SUBPIXELS, Style, colour};
pub use svg::svg;
