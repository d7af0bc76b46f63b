//! Measured data as text: what cam editors, spreadsheets and test stands write, read as a table of columns and reduced to the points of
//! a table law.
//!
//! The text is read line by line. Comments, words and empty lines are passed over, and the columns are those that most lines have.
//! Separators are tabs, semicolons, spaces, or commas where these are not decimal; a decimal sign is a point or a comma.

mod cells;
mod points;
mod reduce;
#[cfg(test)]
mod tests;

pub use points::{Curve, measured_ends};
pub use reduce::{Ends, Reduced, reduce};

use crate::limits::{MAX_FILE_BYTES, MAX_MEASURED_POINTS};
use cells::{Line, heading_cells, line_of};
use std::borrow::Cow;

/// Measured data as they stand in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The columns of numbers and words.
    pub columns: Vec<Column>,
    /// The numbers of each line that has some, `None` where a column has a word or nothing.
    rows: Vec<Row>,
}

/// A column of measured data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// Its heading; empty when it has none.
    pub heading: String,
    /// Its unit, from its heading or from a line of units; empty when it has none.
    pub unit: String,
    /// True when most lines have a number in it.
    pub is_number: bool,
}

/// A line of numbers.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    /// The line of the text, from 1.
    line: usize,
    values: Vec<Option<f64>>,
}

impl Row {
    /// The number in a column.
    fn value(&self, column: usize) -> Result<f64, MeasuredProblem> {
        let missing = MeasuredProblem::NoValue { line: self.line, column: column + 1 };
        self.values.get(column).copied().flatten().ok_or(missing)
    }
}

/// What is wrong with measured data.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasuredProblem {
    /// More bytes than are read.
    TooLarge {
        /// The most that are read.
        limit: usize,
    },
    /// A line that should be a line of numbers and is not; the first line of words when nothing follows them.
    NotNumbers {
        /// The line, from 1.
        line: usize,
    },
    /// A line without a number in a column that was chosen.
    NoValue {
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
    },
    /// An angle that is not larger than the one before it.
    Unordered {
        /// The line, from 1.
        line: usize,
        /// The angle.
        found: f64,
        /// The one before it.
        before: f64,
    },
    /// More points than are read.
    TooManyPoints {
        /// How many there are.
        found: usize,
        /// The most there may be.
        limit: usize,
    },
    /// Fewer points than make a table.
    TooFewPoints {
        /// How many there are.
        found: usize,
    },
    /// The same column for angle and displacement, or one that there is not.
    Columns,
}

impl Measured {
    /// Reads a text.
    ///
    /// # Errors
    /// Names the first line of numbers that cannot be read, or says that there is none.
    pub fn read(text: &str) -> Result<Self, MeasuredProblem> {
        if text.len() > MAX_FILE_BYTES {
            return Err(MeasuredProblem::TooLarge { limit: MAX_FILE_BYTES });
        }
        let lines: Vec<(usize, Line)> = (1..).zip(text.lines().map(line_of)).collect();
        let (Some(shape), Some(first)) = usual_shape(&lines).unzip() else {
            let words = lines.iter().find(|(_, line)| !line.cells.is_empty());
            return match words {
                Some(&(line, _)) => Err(MeasuredProblem::NotNumbers { line }),
                None => Ok(Self { columns: Vec::new(), rows: Vec::new() }),
            };
        };
        let rows: Vec<Row> = rows_from(&lines[first..], shape.len())?;
        let found = rows.len();
        if found > MAX_MEASURED_POINTS {
            return Err(MeasuredProblem::TooManyPoints { found, limit: MAX_MEASURED_POINTS });
        }
        let mut columns: Vec<Column> =
            shape.iter().map(|&is_number| Column { is_number, ..Column::default() }).collect();
        name(&mut columns, &lines[..first]);
        Ok(Self { columns, rows })
    }

    /// Reads bytes: UTF-8, UTF-16 with its mark, or else Latin-1, since test stands write any of these.
    ///
    /// # Errors
    /// As [`Measured::read`].
    pub fn read_bytes(bytes: &[u8]) -> Result<Self, MeasuredProblem> {
        if bytes.len() > MAX_FILE_BYTES {
            return Err(MeasuredProblem::TooLarge { limit: MAX_FILE_BYTES });
        }
        Self::read(&decoded(bytes))
    }

    /// Lines of numbers.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// True when there is no line of numbers.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// True when there is no choice of columns: two of numbers.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.columns.iter().filter(|column| column.is_number).count() == 2
    }

    /// The first numbers of a column, to recognise it by.
    pub fn sample(&self, column: usize) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().filter_map(move |row| row.values.get(column).copied().flatten())
    }
}

/// Which columns hold numbers in most of the lines that have two numbers or more, and the first line like that.
fn usual_shape(lines: &[(usize, Line)]) -> Option<(Vec<bool>, usize)> {
    let mut shapes: Vec<(Vec<bool>, usize, usize)> = Vec::new();
    for (k, (_, line)) in lines.iter().enumerate() {
        if line.numbers() < 2 {
            continue;
        }
        let shape: Vec<bool> = line.cells.iter().map(|cell| cell.value.is_some()).collect();
        match shapes.iter_mut().find(|known| known.0 == shape) {
            Some(known) => known.1 += 1,
            None => shapes.push((shape, 1, k)),
        }
    }
    // Of equally frequent ones the first.
    let usual = shapes.into_iter().rev().max_by_key(|known| known.1)?;
    Some((usual.0, usual.2))
}

/// The lines of numbers from the first on. A line without any digit is passed over wherever it is; one with more numbers than there are
/// columns is refused, since a space may stand there for a decimal sign.
fn rows_from(lines: &[(usize, Line)], columns: usize) -> Result<Vec<Row>, MeasuredProblem> {
    let mut rows = Vec::with_capacity(lines.len());
    for (line, content) in lines {
        let surplus = content.cells.iter().skip(columns).any(|cell| cell.value.is_some());
        if content.numbers() >= 2 && !surplus {
            let values = content.cells.iter().map(|cell| cell.value).chain(std::iter::repeat(None)).take(columns);
            rows.push(Row { line: *line, values: values.collect() });
        } else if content.has_digit() {
            return Err(MeasuredProblem::NotNumbers { line: *line });
        }
    }
    Ok(rows)
}

/// Names the columns by the last lines of words before the first line of numbers that have as many cells: a line of headings, or one of
/// headings and one of units.
fn name(columns: &mut [Column], before: &[(usize, Line)]) {
    let mut lines =
        before.iter().rev().map(|(_, line)| heading_cells(line, columns.len())).filter(|cells| !cells.is_empty());
    let last = lines.next().unwrap_or_default();
    let is_units = last.len() == columns.len() && last.iter().all(|cell| cell.is_empty() || cells::is_unit(cell));
    let (units, headings) = if is_units { (last, lines.next().unwrap_or_default()) } else { (Vec::new(), last) };
    if headings.len() == columns.len() {
        for (column, heading) in columns.iter_mut().zip(headings) {
            (column.heading, column.unit) = cells::without_unit(&heading);
        }
    }
    for (column, unit) in columns.iter_mut().zip(units) {
        column.unit = cells::bare_unit(&unit).to_owned();
    }
}

fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    let wide = |of: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|pair| of([pair[0], pair[1]])).collect();
        Cow::from(String::from_utf16_lossy(&units))
    };
    match bytes {
        [0xff, 0xfe, ..] => wide(u16::from_le_bytes),
        [0xfe, 0xff, ..] => wide(u16::from_be_bytes),
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text).into(),
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect::<String>().into(),
        },
    }
}
