//! The solution as elements of a page, its mathematics as MathML.

use crate::document::{Block, Document, Inline, Line, Table};
use crate::layout::{WHOLE_LINE, width};
use levalab_formula::{Element, Formula, Node, escape, math};
use levalab_words::Language;

/// The document as elements, its title first as a heading of the second level.
#[must_use]
pub fn html(document: &Document, language: Language) -> Vec<Node> {
    let title = Element::text("h2", document.title.clone()).into();
    std::iter::once(title).chain(document.blocks.iter().map(|block| of_block(block, language))).collect()
}

/// The document as a page by itself.
#[must_use]
pub fn page(document: &Document, language: Language) -> String {
    let body: String = html(document, language).iter().map(|node| format!("{node}\n")).collect();
    format!(
        "<!doctype html>\n<html lang=\"{}\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{}</title>\n<style>{STYLE}</style>\n<main class=\"solution\">\n{body}</main>\n</html>\n",
        language.tag(),
        escape(&document.title)
    )
}

/// Looks for a page that stands by itself.
const STYLE: &str = "\
body{font:16px/1.5 system-ui,sans-serif;max-width:52rem;margin:2rem auto;padding:0 1rem}\
math{font-family:\"STIX Two Math\",\"Cambria Math\",\"Latin Modern Math\",\"Libertinus Math\",math,serif}\
.formula{display:flex;flex-wrap:wrap;align-items:center;gap:.4rem 1.6rem;overflow-x:auto;margin:.6rem 0 .6rem 1.5rem;padding-block:.15rem}.formula math{flex:none;margin:0}\
.cells{overflow-x:auto}table{border-collapse:collapse;margin:.75rem 0}caption{text-align:left;font-style:italic}\
th,td{padding:.15rem .6rem;text-align:left;border-bottom:1px solid #9996;white-space:nowrap}\
mtable.lines>mtr>mtd:first-child{text-align:right;padding-right:0}mtable.lines>mtr>mtd+mtd{text-align:left;padding-left:.2em}\
@page{size:A4;margin:18mm}@media print{body{font-size:10.5pt;margin:0;padding:0;max-width:none}h2,h3,h4,:is(h3,h4)+p,p:has(+:is(.formula,.cells)),caption,thead,tr:nth-child(-n+2),tr:nth-last-child(2){break-after:avoid}.wide{font-size:80%}.formula,.short,tr,li{break-inside:avoid}}";

/// Rows of a table, a third of a page, that need not be parted between two.
const SHORT: usize = 16;

fn of_block(block: &Block, language: Language) -> Node {
    match block {
        Block::Heading(1, line) => Element::new("h3", of_line(line, language)).into(),
        Block::Heading(_, line) => Element::new("h4", of_line(line, language)).into(),
        Block::Paragraph(line) => Element::new("p", of_line(line, language)).into(),
        Block::Formula(formula) => of_formula(formula, language),
        Block::List(lines) => {
            let items = lines.iter().map(|line| Element::new("li", of_line(line, language)).into());
            Element::new("ul", items.collect()).into()
        }
        Block::Table(table) => of_table(table, language),
    }
}

/// Equations side by side are formulas of their own, so that a narrow page can put them one under the other.
fn of_formula(formula: &Formula, language: Language) -> Node {
    let equations = if let Formula::List(items) = formula { items.iter().collect() } else { vec![formula] };
    let last = equations.len().saturating_sub(1);
    let each = equations.into_iter().enumerate().map(|(i, equation)| {
        let mut math = math(equation, language, true);
        if i < last {
            math.children.push(Element::text("mo", ",").with("separator", "true").into());
        }
        Node::from(math)
    });
    let fits = matches!(formula, Formula::List(_)) || width(formula) <= WHOLE_LINE;
    Element::new("div", each.collect()).with("class", if fits { "formula" } else { "formula wide" }).into()
}

fn of_table(table: &Table, language: Language) -> Node {
    let head = |head: &Line| {
        let cells = head.iter().map(|part| named(part).unwrap_or_else(|| of_part(part, language))).collect();
        Node::from(Element::new("th", cells).with("scope", "col"))
    };
    let head = table.heads.iter().map(head);
    let row = |cells: &Vec<Line>| {
        let cells = cells.iter().map(|cell| Element::new("td", of_line(cell, language)).into());
        Node::from(Element::new("tr", cells.collect()))
    };
    let inner = Element::new(
        "table",
        vec![
            Element::new("caption", of_line(&table.caption, language)).into(),
            Element::new("thead", vec![Element::new("tr", head.collect()).into()]).into(),
            Element::new("tbody", table.rows.iter().map(row).collect()).into(),
        ],
    );
    // A short table stays on one page.
    let class = if table.rows.len() <= SHORT { "cells short" } else { "cells" };
    Element::new("div", vec![inner.into()]).with("class", class).into()
}

/// A letter at the head of a column, as text: not every reader of screens finds the name of a column in mathematics.
fn named(part: &Inline) -> Option<Node> {
    let Inline::Formula(Formula::Symbol(name)) = part else { return None };
    let (letter, index) = name.split_once('_').unwrap_or((name, ""));
    let mut symbol = Element::text("i", letter).with("class", "symbol");
    if !index.is_empty() {
        symbol.children.push(Element::text("sub", index).into());
    }
    Some(symbol.into())
}

fn of_line(line: &Line, language: Language) -> Vec<Node> {
    line.iter().map(|part| of_part(part, language)).collect()
}

fn of_part(part: &Inline, language: Language) -> Node {
    match part {
        Inline::Text(text) => Node::Text(text.clone()),
        Inline::Formula(formula) => math(formula, language, false).into(),
    }
}
