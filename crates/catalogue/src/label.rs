//! What every row has: a name in the forms in which it is shown, a code in links, and the version that first knew it.

use crate::Two;

/// A name in the forms in which it is shown.
#[derive(Clone, Copy, Debug)]
pub struct Name {
    /// The form within a sentence: for a law, the form next to the word *law* (`cycloidal`, `de seno modificado`); for other things, the noun.
    pub noun: Two,
    /// The form for a place without other words, such as the cell of a table: `seno modificado`.
    pub alone: Two,
    /// In a menu of such things, with a capital: `Seno modificado`. The list on the page has room for some 25 letters: what stands in
    /// parentheses may be left out.
    pub menu: Two,
}

/// A version of the design file and of the link. Both count alike: a link of a version holds what a file of that version holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// What the first release knew.
    One,
    /// Laws that are new since, and tables of more than 128 points.
    Two,
}

impl Version {
    /// The newest version.
    pub const LATEST: Self = Self::Two;

    /// The versions that are read, in order.
    pub const ALL: [Self; 2] = [Self::One, Self::Two];

    /// The first field of a design file of this version.
    #[must_use]
    pub fn format(self) -> &'static str {
        match self {
            Self::One => "levalab/1",
            Self::Two => "levalab/2",
        }
    }

    /// The first field of a link of this version.
    #[must_use]
    pub fn number(self) -> &'static str {
        match self {
            Self::One => "1",
            Self::Two => "2",
        }
    }
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
    /// The name for a place without other words.
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

/// The labels of a list of rows, in the order of the rows; usable in constants, where no trait can be called.
macro_rules! labels_of {
    ($rows:expr) => {{
        let mut labels = [crate::Label::NONE; $rows.len()];
        let mut k = 0;
        while k < $rows.len() {
            labels[k] = crate::Label::of($rows[k].id, $rows[k].link, $rows[k].since, &$rows[k].name);
            k += 1;
        }
        labels
    }};
}
pub(crate) use labels_of;

/// The label of that id.
pub(crate) fn find(labels: &'static [Label], id: &str) -> Option<&'static Label> {
    labels.iter().find(|label| label.id == id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_count_up_from_one() {
        for (version, number) in Version::ALL.into_iter().zip(1..) {
            assert_eq!(version.format(), format!("levalab/{number}"));
            assert_eq!(version.number(), number.to_string());
        }
        assert_eq!(Version::ALL.last(), Some(&Version::LATEST));
        assert!(Version::ALL.is_sorted());
    }
}
