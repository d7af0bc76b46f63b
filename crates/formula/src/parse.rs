//! Reading the plain notation.

use crate::Formula;
use std::fmt;
use std::iter::Peekable;
use std::str::Chars;

/// Functions by name; all take parentheses.
const FUNCTIONS: [&str; 12] =
    ["sin", "cos", "tan", "arctan", "arcsin", "arccos", "arg", "sqrt", "exp", "min", "max", "sign"];

/// Letters that are functions when parentheses follow them at once; after any other they are a product.
const APPLIED: [&str; 4] = ["s", "y", "f", "ρ"];

const RELATIONS: &str = "=≤≥<>≈≠→⇒";

/// A formula that cannot be read, and how much of it was.
#[derive(Clone, Debug, PartialEq)]
pub struct Misprint(String);

impl fmt::Display for Misprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Reads a formula.
///
/// # Errors
/// When the notation is wrong; told to whoever wrote it, not to users.
pub fn parse(text: &str) -> Result<Formula, Misprint> {
    let mut reader = Reader { rest: text.chars().peekable() };
    let read = reader.list();
    reader.blank();
    match (read, reader.rest.next()) {
        (Some(formula), None) => Ok(formula),
        (_, next) => Err(Misprint(format!("`{text}` cannot be read from {next:?} on"))),
    }
}

struct Reader<'a> {
    rest: Peekable<Chars<'a>>,
}

impl Reader<'_> {
    fn blank(&mut self) {
        while self.rest.next_if(|c| c.is_whitespace()).is_some() {}
    }

    fn peek(&mut self) -> Option<char> {
        self.blank();
        self.rest.peek().copied()
    }

    /// Takes one of these characters, if it is next.
    fn take(&mut self, any: &str) -> Option<char> {
        self.blank();
        self.rest.next_if(|&c| any.contains(c))
    }

    fn list(&mut self) -> Option<Formula> {
        let mut items = vec![self.relation()?];
        while self.take(",").is_some() {
            items.push(self.relation()?);
        }
        Some(if items.len() == 1 { items.remove(0) } else { Formula::List(items) })
    }

    fn relation(&mut self) -> Option<Formula> {
        let first = self.sum()?;
        let mut rest = Vec::new();
        while let Some(sign) = self.take(RELATIONS) {
            rest.push((sign, self.sum()?));
        }
        Some(if rest.is_empty() { first } else { Formula::Relation(Box::new(first), rest) })
    }

    fn sum(&mut self) -> Option<Formula> {
        let sign = self.take("+-−±").unwrap_or('+');
        let first = self.term()?;
        let mut terms = vec![(normal(sign), first)];
        while let Some(sign) = self.take("+-−±") {
            terms.push((normal(sign), self.term()?));
        }
        if terms.len() > 1 {
            return Some(Formula::Sum(terms));
        }
        let (sign, only) = terms.remove(0);
        Some(match sign {
            '−' => Formula::Negative(Box::new(only)),
            '±' => Formula::Sum(vec![('±', only)]),
            _ => only,
        })
    }

    fn term(&mut self) -> Option<Formula> {
        let mut factors = vec![self.factor()?];
        loop {
            if self.take("/").is_some() {
                let above = factors.pop()?;
                factors.push(Formula::Fraction(Box::new(above), Box::new(self.factor()?)));
            } else if let Some(sign) = self.take("·×") {
                let before = product(factors);
                let after = self.factor()?;
                factors = vec![Formula::Times(sign, Box::new(before), Box::new(after))];
            } else if self.peek().is_some_and(begins_factor) {
                factors.push(self.factor()?);
            } else {
                return Some(product(factors));
            }
        }
    }

    fn factor(&mut self) -> Option<Formula> {
        let base = self.atom()?;
        if self.rest.next_if_eq(&'^').is_none() {
            return Some(base);
        }
        let raised = if self.take("-−").is_some() { Formula::Negative(Box::new(self.atom()?)) } else { self.atom()? };
        Some(Formula::Power(Box::new(base), Box::new(raised)))
    }

    fn atom(&mut self) -> Option<Formula> {
        match self.peek()? {
            '(' => self.between('(', ')'),
            '[' => self.between('[', ']').map(|inner| Formula::Bracket(Box::new(inner))),
            '|' => self.between('|', '|').map(|inner| Formula::Size(Box::new(inner))),
            '{' => {
                self.rest.next();
                let mut text = String::new();
                while let Some(c) = self.rest.next_if(|&c| c != '}') {
                    text.push(c);
                }
                self.rest.next_if_eq(&'}')?;
                Some(Formula::Text(text))
            }
            c if c.is_ascii_digit() => {
                let mut digits = String::new();
                while let Some(c) = self.rest.next_if(|&c| c.is_ascii_digit() || c == '.') {
                    digits.push(c);
                }
                Some(Formula::Number(digits))
            }
            '∞' | '…' => self.rest.next().map(|c| Formula::Number(c.into())),
            c if c.is_alphabetic() => self.word(),
            _ => None,
        }
    }

    fn between(&mut self, open: char, close: char) -> Option<Formula> {
        self.rest.next_if_eq(&open)?;
        let inner = self.list()?;
        self.blank();
        self.rest.next_if_eq(&close)?;
        Some(inner)
    }

    /// A function, or a single letter with its index and primes.
    fn word(&mut self) -> Option<Formula> {
        let ahead: String = self.rest.clone().take_while(char::is_ascii_alphabetic).collect();
        if let Some(name) = FUNCTIONS.iter().filter(|name| ahead.starts_with(**name)).max_by_key(|name| name.len()) {
            for _ in 0..name.len() {
                self.rest.next();
            }
            let raised = if self.rest.next_if_eq(&'^').is_some() { Some(self.atom()?) } else { None };
            let call = Formula::Call(name, Box::new(self.between('(', ')')?));
            return Some(match raised {
                Some(power) => Formula::Power(Box::new(call), Box::new(power)),
                None => call,
            });
        }
        let mut symbol: String = self.rest.next()?.into();
        if self.rest.next_if_eq(&'_').is_some() {
            symbol.push('_');
            if self.rest.next_if_eq(&'(').is_some() {
                while let Some(c) = self.rest.next_if(|&c| c != ')') {
                    symbol.push(c);
                }
                self.rest.next_if_eq(&')')?;
            } else {
                symbol.push(self.rest.next()?);
            }
        }
        while self.rest.next_if_eq(&'\'').is_some() {
            symbol.push('\'');
        }
        let letter = symbol.trim_end_matches('\'');
        let applied = APPLIED.contains(&letter) || letter.starts_with("N_");
        let symbol = Formula::Symbol(symbol);
        if applied && self.rest.peek() == Some(&'(') {
            return Some(Formula::Apply(Box::new(symbol), Box::new(self.between('(', ')')?)));
        }
        Some(symbol)
    }
}

fn normal(sign: char) -> char {
    if sign == '-' { '−' } else { sign }
}

fn begins_factor(c: char) -> bool {
    c.is_alphanumeric() || "([{∞…".contains(c)
}

fn product(mut factors: Vec<Formula>) -> Formula {
    if factors.len() == 1 { factors.remove(0) } else { Formula::Product(factors) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_not_read() {
        for text in ["", "a +", "(a", "a)", "sin x", "a / ", "|a", "a_", "{a", "a = ", "#"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn indices_and_primes_belong_to_their_letter() {
        assert_eq!(parse("R_b").expect("read"), Formula::Symbol("R_b".into()));
        assert_eq!(parse("s_(max)").expect("read"), Formula::Symbol("s_max".into()));
        assert_eq!(parse("y''").expect("read"), Formula::Symbol("y''".into()));
    }
}
