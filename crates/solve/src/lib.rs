//! The worked solution of a design: what a professor writes on the blackboard to derive this very cam, from the conditions to the verdict.
//!
//! [`solve`] gives a [`Document`], a tree of headings, sentences, formulas and tables; [`markdown()`], [`latex()`] and [`html()`] print it. Every
//! number comes from the core (or is a number of the core in the unit of the design): the text puts it in its place and never computes it
//! anew. Symbols are those of a [`Symbols`] table.
//!
//! ```
//! use levalab_format::{Study, example};
//! use levalab_solve::{Request, markdown, solve};
//! use levalab_words::Language;
//!
//! let study = Study::without_columns(example("R1").unwrap())?;
//! let text = markdown(&solve(&study, &Request::default()), Language::En);
//! assert!(text.contains("-30.37"));
//! # Ok::<(), levalab_format::DesignError>(())
//! ```
//!
//! Not here: the theory behind it, which is `levalab-theory`, and what is drawn.

mod application;
mod board;
mod contact;
mod curve;
mod document;
mod expression;
mod extremes;
mod given;
mod html;
mod inner;
mod joints;
mod latex;
mod layout;
mod limit;
mod markdown;
mod number;
mod pair;
mod program;
mod segment;
mod sizing;
mod substitute;
mod substitution;
mod symbols;
mod system;
mod verdict;

pub use document::{Block, Document, Inline, Line, Table};
pub use html::{html, page};
pub use latex::latex;
pub use markdown::markdown;
pub use symbols::Symbols;

use board::{Board, two};
use levalab_format::Study;
use levalab_words::Language;
use substitution::Place;

/// What is asked of a solution.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The language of its sentences.
    pub language: Language,
    /// Where numbers are put into the formulas, degrees (length for a cam that travels); where |v| is greatest when it is not told.
    pub theta: Option<f64>,
    /// The only segment to work out, from 0; all of them when it is not told.
    pub segment: Option<usize>,
    /// The symbols to write in.
    pub symbols: Symbols,
}

/// The worked solution of a design.
#[must_use]
pub fn solve(study: &Study, request: &Request) -> Document {
    let mut board = Board::new(study.first(), request.language);
    let title = board.words(two("Worked solution", "Solución desarrollada"), &[]);
    let own = &study.design().title;
    let title = if own.is_empty() { title } else { format!("{title}: {own}") };
    let place = Place::of(&board, request);
    given::write(&mut board);
    program::write(&mut board, request.segment);
    joints::write(&mut board, request.segment);
    if request.segment.is_none() {
        extremes::write(&mut board);
    }
    substitution::write(&mut board, &place);
    if request.segment.is_none() {
        application::write(&mut board, &place);
        sizing::write(&mut board);
        verdict::write(&mut board);
    }
    let mut blocks = board.blocks;
    if let (Some(second), None) = (study.second(), request.segment) {
        let mut board = Board::new(second, request.language);
        pair::write(&mut board, study.first().cam(), &place);
        blocks.extend(board.blocks);
    }
    Document { title, blocks }.with_symbols(&request.symbols)
}
