//! The solution as Markdown, its mathematics as LaTeX between `$` and `$`.

use crate::document::{Block, Document, Inline, Line, Table};
use levalab_words::Language;

/// The document as Markdown.
#[must_use]
pub fn markdown(document: &Document, language: Language) -> String {
    let mut text = format!("# {}\n", escaped(&document.title));
    for block in &document.blocks {
        text.push('\n');
        text += &match block {
            Block::Heading(level, line) => {
                format!("{} {}\n", "#".repeat(usize::from(*level) + 1), written(line, language))
            }
            Block::Paragraph(line) => written(line, language) + "\n",
            Block::Formula(formula) => format!("$${}$$\n", levalab_formula::latex(formula, language)),
            Block::List(lines) => lines.iter().map(|line| format!("- {}\n", written(line, language))).collect(),
            Block::Table(table) => rows(table, language),
        };
    }
    text
}

fn rows(table: &Table, language: Language) -> String {
    let row = |cells: &[Line]| {
        let cells: Vec<String> = cells.iter().map(|cell| written(cell, language).replace('|', "\\vert ")).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rule = format!("|{}\n", " --- |".repeat(table.heads.len()));
    let body: String = table.rows.iter().map(|cells| row(cells)).collect();
    format!("*{}*\n\n{}{rule}{body}", written(&table.caption, language), row(&table.heads))
}

fn written(line: &Line, language: Language) -> String {
    let part = |part: &Inline| match part {
        Inline::Text(text) => escaped(text),
        Inline::Formula(formula) => format!("${}$", levalab_formula::latex(formula, language)),
    };
    line.iter().map(part).collect()
}

/// Text in which nothing is taken for a mark.
fn escaped(text: &str) -> String {
    let mut safe = String::new();
    for c in text.chars() {
        if "\\`*_[]<>#$|~&".contains(c) {
            safe.push('\\');
        }
        safe.push(c);
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::line;

    #[test]
    fn marks_in_a_title_are_text() {
        let document = Document {
            title: "a*b_c | <i> &amp; &#65;".into(),
            blocks: vec![Block::Paragraph(line("With $x = 0.5$ it is *so*."))],
        };
        assert_eq!(
            markdown(&document, Language::Es),
            "# a\\*b\\_c \\| \\<i\\> \\&amp; \\&\\#65;\n\nWith $x = 0{,}5$ it is \\*so\\*.\n"
        );
    }
}
