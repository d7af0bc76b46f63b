//! The solution as a LaTeX document that compiles as it is.

use crate::document::{Block, Document, Inline, Line, Table};
use levalab_formula::latex_text;
use levalab_words::Language;

/// The document as LaTeX.
#[must_use]
pub fn latex(document: &Document, language: Language) -> String {
    let babel = match language {
        Language::En => "english",
        Language::Es => "spanish,es-nodecimaldot",
    };
    let mut text = format!(
        "\\documentclass[11pt,a4paper]{{article}}\n\
         \\usepackage[T1]{{fontenc}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage[{babel}]{{babel}}\n\
         \\usepackage{{amsmath,amssymb,longtable,textcomp}}\n\\usepackage[margin=2cm]{{geometry}}\n\
         \\setlength{{\\parindent}}{{0pt}}\n\\setlength{{\\parskip}}{{0.6ex}}\n\
         \\begin{{document}}\n\n\\section*{{{}}}\n",
        latex_text(&document.title)
    );
    for block in &document.blocks {
        text.push('\n');
        text += &match block {
            Block::Heading(level, line) => {
                let name = if *level == 1 { "subsection" } else { "subsubsection" };
                format!("\\{name}*{{{}}}\n", written(line, language))
            }
            Block::Paragraph(line) => written(line, language) + "\n",
            Block::Formula(formula) => format!("\\[{}\\]\n", levalab_formula::latex(formula, language)),
            Block::List(lines) => {
                let items: String = lines.iter().map(|line| format!("\\item {}\n", written(line, language))).collect();
                format!("\\begin{{itemize}}\n{items}\\end{{itemize}}\n")
            }
            Block::Table(table) => rows(table, language),
        };
    }
    text + "\n\\end{document}\n"
}

fn rows(table: &Table, language: Language) -> String {
    let row = |cells: &[Line]| {
        let cells: Vec<String> = cells.iter().map(|cell| written(cell, language)).collect();
        format!("{} \\\\\n", cells.join(" & "))
    };
    let body: String = table.rows.iter().map(|cells| row(cells)).collect();
    format!(
        "\\begin{{longtable}}{{{}}}\n\\multicolumn{{{}}}{{l}}{{\\textit{{{}}}}} \\\\\n\\hline\n{}\\hline\n\\endhead\n{body}\\hline\n\\end{{longtable}}\n",
        "l".repeat(table.heads.len()),
        table.heads.len(),
        written(&table.caption, language),
        row(&table.heads)
    )
}

fn written(line: &Line, language: Language) -> String {
    let part = |part: &Inline| match part {
        Inline::Text(text) => latex_text(text),
        Inline::Formula(formula) => format!("${}$", levalab_formula::latex(formula, language)),
    };
    line.iter().map(part).collect()
}
