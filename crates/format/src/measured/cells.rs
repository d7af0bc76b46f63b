//! A line of measured data as cells, and what is written in one.

/// A line without its comment.
#[derive(Clone, Debug, Default)]
pub(super) struct Line {
    pub cells: Vec<Cell>,
    /// The whole of a line that is a comment, since headings may stand there.
    pub comment: String,
}

/// A cell of a line.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub text: String,
    /// The number that it is.
    pub value: Option<f64>,
}

/// What makes the whole line a comment where it begins one.
const LINE_COMMENTS: [char; 3] = ['%', '!', '*'];

/// Signs of minus, by which spreadsheets and papers replace the hyphen.
const MINUS: [char; 3] = ['\u{2212}', '\u{2013}', '\u{2012}'];

/// Units of angles and lengths that a column may be in.
const UNITS: [&str; 14] =
    ["°", "deg", "degree", "degrees", "grad", "rad", "mm", "cm", "m", "in", "inch", "µm", "um", "-"];

impl Line {
    pub fn numbers(&self) -> usize {
        self.cells.iter().filter(|cell| cell.value.is_some()).count()
    }

    pub fn has_digit(&self) -> bool {
        self.cells.iter().any(|cell| cell.text.contains(|c: char| c.is_ascii_digit()))
    }
}

/// The cells of a line.
pub(super) fn line_of(line: &str) -> Line {
    let whole = line.trim();
    let end = comment_in(whole).unwrap_or(whole.len());
    let text = if whole.starts_with(LINE_COMMENTS) { "" } else { whole[..end].trim() };
    let comment = if text.is_empty() {
        whole.trim_start_matches(['#', '/', '%', '!', '*', ' ']).to_owned()
    } else {
        String::new()
    };
    let cells = cells_of(text).into_iter().map(|text| Cell { value: number(&text), text }).collect();
    Line { cells, comment }
}

/// Where a comment begins in a line: `#` or `//`.
fn comment_in(line: &str) -> Option<usize> {
    let bytes = line.as_bytes();
    (0..bytes.len()).find(|&at| bytes[at] == b'#' || bytes[at..].starts_with(b"//"))
}

/// The cells of a line of words that may be headings; none when there are not as many as columns.
pub(super) fn heading_cells(line: &Line, columns: usize) -> Vec<String> {
    let own: Vec<String> = line.cells.iter().map(|cell| cell.text.clone()).collect();
    if own.len() == columns {
        return own;
    }
    let text = if own.is_empty() { line.comment.clone() } else { own.join(" ") };
    let by = |separator: char| -> Vec<String> { text.split(separator).map(|cell| cell.trim().to_owned()).collect() };
    let ways = [by('\t'), by(';'), by(','), text.split_whitespace().map(str::to_owned).collect()];
    ways.into_iter().find(|cells| cells.len() == columns && columns > 1).unwrap_or_default()
}

/// True for the name of a unit, in brackets or without.
pub(super) fn is_unit(cell: &str) -> bool {
    UNITS.contains(&bare_unit(cell).to_ascii_lowercase().as_str())
}

/// A unit without its brackets.
pub(super) fn bare_unit(cell: &str) -> &str {
    cell.trim().trim_matches(['[', ']', '(', ')', '{', '}'])
}

/// A heading and the unit that it ends with: `angle [deg]`, `s (mm)`, `theta / rad`.
pub(super) fn without_unit(heading: &str) -> (String, String) {
    let heading = heading.trim();
    let split = heading.rfind(['[', '(', '/', '{', ' ']);
    if let Some((name, unit)) = split.map(|at| heading.split_at(at)) {
        let unit = bare_unit(unit.trim_start_matches(['/', ' ']));
        if is_unit(unit) && !name.trim().is_empty() {
            return (name.trim().trim_end_matches(',').to_owned(), unit.to_owned());
        }
    }
    (heading.to_owned(), String::new())
}

/// Tabs and semicolons part cells; else spaces do, and commas that are no decimal signs.
fn cells_of(line: &str) -> Vec<String> {
    let cells: Vec<&str> = if line.contains(['\t', ';']) {
        line.trim_end_matches(';').split(['\t', ';']).collect()
    } else {
        let words: Vec<&str> = line.split_whitespace().collect();
        let commas = |word: &&str| word.matches(',').count();
        let behind = |word: &&str| word.ends_with(',');
        let (last, others) = words.split_last().map_or((None, [].as_slice()), |(last, others)| (Some(*last), others));
        let part_cells = words.len() == 1 || words.iter().any(|word| commas(word) > 1);
        let all_behind = !others.is_empty() && others.iter().all(behind) && last.is_some_and(|last| commas(&last) == 0);
        if part_cells || all_behind { line.split(',').flat_map(split_words).collect() } else { words }
    };
    cells.into_iter().map(|cell| cell.trim().trim_matches('"').trim().trim_end_matches(',').to_owned()).collect()
}

/// The words of a cell; an empty cell is one.
fn split_words(cell: &str) -> Vec<&str> {
    let words: Vec<&str> = cell.split_whitespace().collect();
    if words.is_empty() { vec![""] } else { words }
}

/// A number as people write it: a decimal comma or point, groups of three digits with spaces between them, a degree sign behind it.
fn number(cell: &str) -> Option<f64> {
    let cell = cell.replace(MINUS, "-");
    let digits = cell.trim().trim_end_matches('°').trim_end();
    let plain = if digits.contains([' ', '\u{a0}', '\u{202f}', '\'']) { ungrouped(digits)? } else { digits.to_owned() };
    // Rust reads words such as "inf" and "nan" too.
    let is_number = plain.starts_with(|c: char| c.is_ascii_digit() || "+-.,".contains(c))
        && plain.chars().all(|c| c.is_ascii_digit() || "+-.,eE".contains(c));
    let one_sign = plain.matches(['.', ',']).count() <= 1;
    (is_number && one_sign).then(|| plain.replace(',', ".").parse::<f64>().ok())?.filter(|value| value.is_finite())
}

/// A number whose digits are in groups of three.
fn ungrouped(text: &str) -> Option<String> {
    let groups: Vec<&str> = text.split([' ', '\u{a0}', '\u{202f}', '\'']).collect();
    let whole = |group: &&str| group.split(['.', ',']).next().is_some_and(|digits| digits.len() == 3);
    groups[1..].iter().all(whole).then(|| groups.concat())
}
