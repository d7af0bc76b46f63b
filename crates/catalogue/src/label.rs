//! What every row has: a name in the forms in which it is shown, a code in links, and the version that first knew it.

use crate::Two;

/// A name in the forms in which it is shown.
#[derive(Clone, Copy, Debug)]
pub struct Name {
    /// Within a sentence: beside the word *law* for a law (`cycloidal`, `de seno modificado`), as a noun for other things.
    pub noun: Two,
    /// Where nothing stands beside it, as in the cell of a table: `seno modificado`.
    pub alone: Two,
    /// In a menu of such things, with a capital: `Seno modificado`. The list on the page has room for some 25 letters: what stands in
    /// parentheses may be left out.
    pub menu: Two,
}

/// A version of design files and links.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// `levalab/1`, and links that begin with 1.
    One,
    /// `levalab/2`, and links that begin with 2.
    Two,
}

/// The part of a row that the page carries; the texts for the pages of theory stay out of it.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// The name in files.
    pub id: &'static str,
    /// The code in a link; empty for what a link says in another way.
    pub link: &'static str,
    /// The first version of file and link that knows it.
    pub since: Version,
    /// The name within a sentence.
    pub noun: Two,
    /// The name where nothing stands beside it.
    pub alone: Two,
}

impl Label {
    pub(crate) const fn of(id: &'static str, link: &'static str, since: Version, name: &Name) -> Self {
        Self { id, link, since, noun: name.noun, alone: name.alone }
    }

    /// A place in a list that is being made.
    pub(crate) const NONE: Self = {
        let empty = crate::two("", "");
        Self { id: "", link: "", since: Version::One, noun: empty, alone: empty }
    };
}

/// The label of that id.
pub(crate) fn find(labels: &'static [Label], id: &str) -> Option<&'static Label> {
    labels.iter().find(|label| label.id == id)
}
