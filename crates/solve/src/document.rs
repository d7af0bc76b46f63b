//! The solution as a tree: headings, sentences, formulas and tables, which the writers print.

use crate::Symbols;
use levalab_formula::{Formula, parse};

/// A text in blocks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// What it is called.
    pub title: String,
    /// What it says, in order.
    pub blocks: Vec<Block>,
}

/// A block of text.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A heading: 1 for a part, 2 for a part of a part.
    Heading(u8, Line),
    /// A paragraph.
    Paragraph(Line),
    /// A formula on a line of its own.
    Formula(Formula),
    /// Sentences, one after another, each marked.
    List(Vec<Line>),
    /// A table with its heads.
    Table(Table),
}

/// Cells in rows and columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// What it shows.
    pub caption: Line,
    /// The heads of its columns.
    pub heads: Vec<Line>,
    /// Its rows, as long as the heads.
    pub rows: Vec<Vec<Line>>,
}

/// Words and formulas in a line.
pub type Line = Vec<Inline>;

/// A part of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Inline {
    /// Words.
    Text(String),
    /// A formula.
    Formula(Formula),
}

/// A line from words with formulas between `$` and `$`.
#[must_use]
pub fn line(text: &str) -> Line {
    let parts = text.split('$').enumerate().filter(|(_, part)| !part.is_empty());
    parts
        .map(|(i, part)| if i % 2 == 0 { Inline::Text(part.to_owned()) } else { Inline::Formula(formula(part)) })
        .collect()
}

/// A formula from its notation. One of ours that cannot be read would be a misprint, which the tests do not let pass; it is shown as it is
/// written.
#[must_use]
pub fn formula(notation: &str) -> Formula {
    parse(notation).unwrap_or_else(|misprint| {
        debug_assert!(false, "{misprint}");
        Formula::Text(notation.to_owned())
    })
}

impl Document {
    /// The same with the symbols of another notation.
    #[must_use]
    pub fn with_symbols(mut self, symbols: &Symbols) -> Self {
        for formula in self.formulas_mut() {
            symbols.rename(formula);
        }
        self
    }

    /// Every formula in it.
    fn formulas_mut(&mut self) -> Vec<&mut Formula> {
        let mut found = Vec::new();
        for block in &mut self.blocks {
            match block {
                Block::Heading(_, line) | Block::Paragraph(line) => found.extend(formulas_of(line)),
                Block::Formula(formula) => found.push(formula),
                Block::List(lines) => found.extend(lines.iter_mut().flat_map(formulas_of)),
                Block::Table(table) => {
                    let rows = table.rows.iter_mut().flatten();
                    let lines = table.heads.iter_mut().chain(rows).chain([&mut table.caption]);
                    found.extend(lines.flat_map(formulas_of));
                }
            }
        }
        found
    }
}

fn formulas_of(line: &mut Line) -> Vec<&mut Formula> {
    line.iter_mut()
        .filter_map(|part| match part {
            Inline::Formula(formula) => Some(formula),
            Inline::Text(_) => None,
        })
        .collect()
}
