//! The worked solution of a design: what a professor writes on the blackboard to derive this very cam, from the conditions to the verdict.
//!
//! [`solve`] gives a [`Document`], a tree of headings, sentences, formulas and tables; [`markdown()`], [`latex()`] and [`html()`] print it. Every
//! number comes from the core (or is a number of the core in the unit of the design): the text puts it in its place and never computes it
//! anew. Symbols are those of a [`Symbols`] table.
//!
//! ```
//! use levalab_format::example;
//! use levalab_solve::{Request, Worked, markdown, solve};
//! use levalab_words::Language;
//!
//! let worked = Worked::of(example("R1").unwrap())?;
//! let text = markdown(&solve(&worked, &Request::default()), Language::En);
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
use levalab_core::{Analysis, Cam};
use levalab_format::report::Report;
use levalab_format::{Design, DesignError};
use levalab_words::Language;
use substitution::Place;

/// A design with all that follows from it.
pub struct Worked {
    /// The design.
    pub design: Design,
    first: (Cam, Analysis, Report),
    second: Option<(Cam, Analysis, Report)>,
}

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

/// One cam of a design, as it is written about.
pub(crate) struct Subject<'a> {
    pub design: &'a Design,
    pub cam: &'a Cam,
    pub analysis: &'a Analysis,
    pub report: &'a Report,
}

impl Worked {
    /// Analyses a design.
    ///
    /// # Errors
    /// When it is no cam.
    pub fn of(design: Design) -> Result<Self, DesignError> {
        let analysed = |cam: Cam| {
            // Extremes and verdict are exact whatever the steps are.
            let analysis = Analysis::of(&cam, 1);
            let report = Report::of(&design, &cam, &analysis);
            (cam, analysis, report)
        };
        let cam = design.cam()?;
        let second = design.second(&cam)?.map(analysed);
        let first = analysed(cam);
        Ok(Self { first, second, design })
    }

    /// How many segments the design has over what its program tells: its own, or those of a ready-made motion.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.first.0.program.given().len()
    }

    fn subject<'a>(&'a self, (cam, analysis, report): &'a (Cam, Analysis, Report)) -> Subject<'a> {
        Subject { design: &self.design, cam, analysis, report }
    }
}

/// The worked solution of a design.
#[must_use]
pub fn solve(worked: &Worked, request: &Request) -> Document {
    let subject = worked.subject(&worked.first);
    let mut board = Board::new(&subject, request.language);
    let title = board.words(two("Worked solution", "Solución desarrollada"), &[]);
    let title = if worked.design.title.is_empty() { title } else { format!("{title}: {}", worked.design.title) };
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
    if let (Some(second), None) = (&worked.second, request.segment) {
        let subject = worked.subject(second);
        let mut board = Board::new(&subject, request.language);
        pair::write(&mut board, &worked.first.0, &place);
        blocks.extend(board.blocks);
    }
    Document { title, blocks }.with_symbols(&request.symbols)
}
