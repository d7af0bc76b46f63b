//! The letters that a notation has for the magnitudes: the one place where those of a book are put in the place of ours.

use levalab_formula::Formula;

/// A notation: for each of our symbols that it writes otherwise, ours and its own, as in formulas (`R_b`, `φ`). Empty, it is ours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Symbols(Vec<(&'static str, String)>);

impl Symbols {
    /// A notation from pairs: our symbol, then its own.
    #[must_use]
    pub fn new(pairs: Vec<(&'static str, String)>) -> Self {
        Self(pairs)
    }

    /// Writes a formula in it.
    pub(crate) fn rename(&self, formula: &mut Formula) {
        if self.0.is_empty() {
            return;
        }
        if let Formula::Symbol(name) = formula {
            let primes = name.len() - name.trim_end_matches('\'').len();
            let bare = &name[..name.len() - primes];
            if let Some((_, other)) = self.0.iter().find(|(ours, _)| *ours == bare) {
                *name = format!("{other}{}", "'".repeat(primes));
            }
        }
        for part in formula.parts_mut() {
            self.rename(part);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_formula::parse;

    #[test]
    fn a_notation_changes_symbols_wherever_they_stand() {
        let symbols = Symbols::new(vec![("s", "y".into()), ("R_b", "r_0".into())]);
        let mut formula = parse("ρ = R_b + s + s' (2s)^2/R_p").expect("read");
        symbols.rename(&mut formula);
        assert_eq!(formula, parse("ρ = r_0 + y + y' (2y)^2/R_p").expect("read"));
    }
}
