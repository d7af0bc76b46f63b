//! The solution as a LaTeX document that compiles as it is.

use crate::document::{Block, Document, Inline, Line, Table};
use levalab_formula::{latex_lacks, latex_text};
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
    text += &lacking(document, language);
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

/// A sentence that names the letters of the title for which numbers stand; our own sentences have none.
fn lacking(document: &Document, language: Language) -> String {
    let numbers: Vec<String> =
        latex_lacks(&document.title).iter().map(|c| format!("\\texttt{{U+{:04X}}}", u32::from(*c))).collect();
    if numbers.is_empty() {
        return String::new();
    }
    let sentence = match language {
        Language::En => {
            "The fonts of this document lack characters of the title; their numbers in Unicode stand in their place"
        }
        Language::Es => {
            "Las fuentes de este documento no tienen algunos caracteres del título; en su lugar figura su número de Unicode"
        }
    };
    format!("\n{sentence}: {}.\n", numbers.join(", "))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Request, solve};
    use levalab_format::{EXAMPLES, Study, example};

    #[test]
    fn letters_of_a_title_that_cannot_be_set_are_named_in_a_sentence() {
        let document = Document { title: "日 ñ".into(), blocks: Vec::new() };
        for (language, beginning) in [(Language::En, "The fonts of"), (Language::Es, "Las fuentes de")] {
            let text = latex(&document, language);
            assert!(text.contains("\\section*{\\texttt{U+65E5} ñ}\n"), "{text}");
            assert!(
                text.lines().any(|line| line.starts_with(beginning) && line.ends_with(": \\texttt{U+65E5}.")),
                "{text}"
            );
        }
    }

    #[test]
    fn every_letter_of_our_own_can_be_set() {
        for (name, _) in EXAMPLES {
            let worked = Study::without_columns(example(name).expect(name)).expect(name);
            for language in Language::ALL {
                let text = latex(&solve(&worked, &Request { language, ..Request::default() }), language);
                assert!(!text.contains("U+"), "{name}: {text}");
            }
        }
    }
}
