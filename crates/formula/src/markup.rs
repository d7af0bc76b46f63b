//! Elements of a page, as a tree: written out as text, or made into nodes by whoever shows them.

use std::fmt;

/// An element.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Its tag.
    pub name: &'static str,
    /// Its attributes.
    pub attributes: Vec<(&'static str, String)>,
    /// What it holds.
    pub children: Vec<Node>,
}

/// A piece of a page.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// An element.
    Element(Element),
    /// Text, as it is read.
    Text(String),
}

impl Element {
    /// An element without attributes.
    #[must_use]
    pub fn new(name: &'static str, children: Vec<Node>) -> Self {
        Self { name, attributes: Vec::new(), children }
    }

    /// An element of nothing but text.
    #[must_use]
    pub fn text(name: &'static str, text: impl Into<String>) -> Self {
        Self::new(name, vec![Node::Text(text.into())])
    }

    /// The same with an attribute more.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.attributes.push((name, value.into()));
        self
    }
}

impl From<Element> for Node {
    fn from(element: Element) -> Self {
        Self::Element(element)
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "<{}", self.name)?;
        for (name, value) in &self.attributes {
            write!(f, " {name}=\"{}\"", escape(value))?;
        }
        f.write_str(">")?;
        self.children.iter().try_for_each(|child| child.fmt(f))?;
        if VOID.contains(&self.name) { Ok(()) } else { write!(f, "</{}>", self.name) }
    }
}

/// Elements that hold nothing and are not closed.
const VOID: [&str; 2] = ["br", "meta"];

impl fmt::Display for Node {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Element(element) => element.fmt(f),
            Self::Text(text) => f.write_str(&escape(text)),
        }
    }
}

/// Text that is safe between tags and within attributes.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
