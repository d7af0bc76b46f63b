//! The worked solution of a design: a tree for the page to make nodes of, and text to copy.

use js_sys::Array;
use levalab_edge::{language, value};
use levalab_format::Study;
use levalab_formula::{Element, Node};
use levalab_solve::{Document, Request, Symbols, html, latex, markdown, solve};
use levalab_words::Language;
use wasm_bindgen::prelude::*;

/// The solution as a list of nodes: a text, or a list of tag, attributes (name and value by turns) and children. Nothing when the design
/// is no cam. `theta` and `segment` (from 0) as in [`Request`].
#[wasm_bindgen(unchecked_return_type = "SolutionNode[] | undefined")]
pub fn solution(
    design: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
    theta: Option<f64>,
    segment: Option<usize>,
) -> Option<Array> {
    let language = language(words);
    let document = solved(design, language, theta, segment)?;
    Some(html(&document, language).iter().map(node).collect())
}

/// The solution as text, `latex` or `markdown`; empty when the design is no cam.
#[wasm_bindgen]
pub fn solution_text(
    design: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
    theta: Option<f64>,
    segment: Option<usize>,
    #[wasm_bindgen(unchecked_param_type = "\"latex\" | \"markdown\"")] to: &str,
) -> String {
    let language = language(words);
    let written = |document: Document| match to {
        "latex" => latex(&document, language),
        _ => markdown(&document, language),
    };
    solved(design, language, theta, segment).map(written).unwrap_or_default()
}

fn solved(design: &JsValue, language: Language, theta: Option<f64>, segment: Option<usize>) -> Option<Document> {
    let study = Study::open(&value(design), 1).ok()?;
    let segment = segment.filter(|&k| k < study.segments());
    let symbols = Symbols::of(study.design());
    Some(solve(&study, &Request { language, theta, segment, symbols }))
}

fn node(node: &Node) -> JsValue {
    match node {
        Node::Text(text) => text.into(),
        Node::Element(Element { name, attributes, children }) => {
            let pairs: Array =
                attributes.iter().flat_map(|(name, value)| [JsValue::from(*name), value.into()]).collect();
            let list = Array::of2(&(*name).into(), &pairs);
            children.iter().for_each(|child| {
                list.push(&self::node(child));
            });
            list.into()
        }
    }
}
