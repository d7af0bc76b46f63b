//! Numbers and units as people write them: read and written in one way everywhere.
//!
//! Fields of the page, the command line and pasted text are read by [`read`]; sentences, tables, readouts, labels of diagrams and formulas
//! are written by [`write`](mod@write).
//!
//! ```
//! use levalab_numbers::{read, write::{DecimalSign, measured}};
//!
//! assert_eq!(read("1 1/4 in", "mm"), Ok(31.75));
//! assert_eq!(read("22/7", ""), Ok(22.0 / 7.0));
//! assert_eq!(measured(-48_185.28, DecimalSign::Comma), "−48\u{202f}185");
//! ```
//!
//! Not here: the words for what is wrong with a number, which are in `levalab-words`.

mod calculation;
mod read;
mod unit;
pub mod write;

pub use read::{NumberProblem, read};
