//! The letters that a notation has for the magnitudes: the one place where those of a book are put in the place of ours.

use levalab_format::Design;
use levalab_formula::Formula;
use levalab_words::Signs;

/// A notation: for each of our symbols that it writes otherwise, ours and its own, as in formulas (`R_b`, `φ`). Empty, it is ours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Symbols(Vec<(&'static str, String)>);

/// Marks a derivative.
const PRIME: char = '\'';

impl Symbols {
    /// A notation from pairs: our symbol, then its own.
    #[must_use]
    pub fn new(pairs: Vec<(&'static str, String)>) -> Self {
        Self(pairs)
    }

    /// The notation that a design is told in, as far as it fits: a sign that is counted the other way keeps our letter, so that our
    /// formulas stay true of it, and so does what would take the letter of the arm.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let signs = Signs::of(design.notation);
        let kept = |ours: &str| match ours {
            "e" => design.eccentricity_sign() < 0.0,
            "A" => design.is_oscillating(),
            _ => false,
        };
        let mut pairs: Vec<(&'static str, String)> = signs
            .symbols
            .iter()
            .filter(|(ours, _)| !kept(ours))
            .map(|&(ours, theirs)| (ours, theirs.to_owned()))
            .collect();
        if signs.symbol("s") == "y" {
            // The unit curve gives its letter to the displacement.
            pairs.push(("y", "η".to_owned()));
        }
        if signs.symbol("v").ends_with(PRIME) {
            // Where a prime is a derivative by θ, one by x is written with an index.
            let s = signs.symbol("s");
            let by_x = [("s'", "x"), ("s''", "xx"), ("s'''", "xxx")];
            pairs.extend(by_x.map(|(ours, index)| (ours, format!("{s}_{index}"))));
        }
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
            let found = |name: &str| self.0.iter().find(|(ours, _)| *ours == name).map(|(_, other)| other.clone());
            if let Some(other) = found(name) {
                *name = other;
            } else if let Some(other) = found(bare) {
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
