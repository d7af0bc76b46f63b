//! Checks made by the compiler: everything that the core lists has one row, and everything in a link a code of its own.

use crate::Label;

/// Stops the compiler unless exactly one of the labels has the id. The message is the id.
pub(crate) const fn has_one_row_in_the_catalogue(id: &'static str, labels: &[Label]) {
    let mut rows = 0;
    let mut k = 0;
    while k < labels.len() {
        if is_same(id, labels[k].id) {
            rows += 1;
        }
        k += 1;
    }
    if rows != 1 {
        // The row of this id is missing, or there are two.
        panic!("{}", id);
    }
}

/// Stops the compiler when two labels have the same code in a link. The message is the id of the second.
pub(crate) const fn have_codes_of_their_own(labels: &[Label]) {
    let mut k = 0;
    while k < labels.len() {
        let mut before = 0;
        while before < k {
            if !labels[k].link.is_empty() && is_same(labels[k].link, labels[before].link) {
                // The code in a link of this id stands for another one.
                panic!("{}", labels[k].id);
            }
            before += 1;
        }
        k += 1;
    }
}

/// True when two texts are the same; `==` is not for constants.
pub(crate) const fn is_same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    if one.len() != other.len() {
        return false;
    }
    let mut k = 0;
    while k < one.len() {
        if one[k] != other[k] {
            return false;
        }
        k += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_the_same_only_when_every_byte_is() {
        assert!(is_same("pump", "pump") && is_same("", ""));
        for other in ["pum", "pumps", "pumP", ""] {
            assert!(!is_same("pump", other), "{other}");
        }
    }
}
