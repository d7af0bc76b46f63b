//! From text to operations: numbers in either decimal form, implicit products, and refusals that point at a character.

use super::names::{Meaning, longest};
use super::{Constant, Expression, ExpressionFault, ExpressionProblem, MAX_EXPRESSION, Op};
use std::ops::Range;

/// Deepest nesting of parentheses, signs and powers.
const MAX_DEPTH: usize = 32;

/// A text on its way to an expression.
struct Parser {
    text: Vec<char>,
    at: usize,
    depth: usize,
    ops: Vec<Op>,
    named: Vec<Named>,
}

/// Where a variable or constant is named, in characters.
type Named = (Range<usize>, Constant);

type Parsed = Result<(), ExpressionProblem>;

impl Expression {
    /// Reads an expression of `x`, `θ` (or `theta`), `β` (`beta`), `L`, `s0` (`s₀`), `π` (`pi`) and `e`.
    ///
    /// # Errors
    /// Says what cannot be read, and at which character.
    pub fn parse(text: &str) -> Result<Self, ExpressionProblem> {
        Self::read(text).map(|(expression, _)| expression)
    }

    /// The same, with the places of its variables.
    pub(super) fn read(text: &str) -> Result<(Self, Vec<Named>), ExpressionProblem> {
        let text: Vec<char> = text.chars().take(MAX_EXPRESSION + 1).collect();
        let mut parser = Parser { text, at: 0, depth: 0, ops: Vec::new(), named: Vec::new() };
        if parser.text.len() > MAX_EXPRESSION {
            return Err(ExpressionProblem {
                at: MAX_EXPRESSION,
                kind: ExpressionFault::TooLong { limit: MAX_EXPRESSION },
            });
        }
        parser.sum()?;
        match parser.peek() {
            None => Ok((Self { ops: parser.ops }, parser.named)),
            Some(c) => parser.refuse(ExpressionFault::Unexpected(c)),
        }
    }
}

impl Parser {
    /// Terms with + and − between them.
    fn sum(&mut self) -> Parsed {
        self.deeper(|parser| {
            parser.product()?;
            loop {
                let op = match parser.peek() {
                    Some('+') => Op::Add,
                    Some('-' | '−' | '–') => Op::Sub,
                    _ => return Ok(()),
                };
                parser.at += 1;
                parser.product()?;
                parser.ops.push(op);
            }
        })
    }

    /// Factors with ·, / or nothing between them.
    fn product(&mut self) -> Parsed {
        self.signed()?;
        loop {
            let op = match self.peek() {
                Some('*' | '·' | '×' | '⋅') => Op::Mul,
                Some('/' | '÷') => Op::Div,
                Some(c) if c == '(' || c.is_alphabetic() => {
                    self.power()?;
                    self.ops.push(Op::Mul);
                    continue;
                }
                _ => return Ok(()),
            };
            self.at += 1;
            self.signed()?;
            self.ops.push(op);
        }
    }

    /// A factor with its sign, which binds less than a power: −x² is −(x²).
    fn signed(&mut self) -> Parsed {
        match self.peek() {
            Some('-' | '−' | '–') => {
                self.at += 1;
                self.deeper(Self::signed)?;
                self.ops.push(Op::Neg);
                Ok(())
            }
            Some('+') => {
                self.at += 1;
                self.deeper(Self::signed)
            }
            _ => self.power(),
        }
    }

    /// A factor and its exponent, which is read from the right: 2^3^2 is 2^(3^2).
    fn power(&mut self) -> Parsed {
        self.factor()?;
        match self.peek() {
            Some('^') => {
                self.at += 1;
                self.deeper(Self::signed)?;
                self.ops.push(Op::Pow);
            }
            Some('*') if self.text.get(self.at + 1) == Some(&'*') => {
                self.at += 2;
                self.deeper(Self::signed)?;
                self.ops.push(Op::Pow);
            }
            Some(c) if superscript(c).is_some() => {
                let mut exponent = 0.0;
                while let Some(digit) = self.text.get(self.at).copied().and_then(superscript) {
                    exponent = 10.0 * exponent + digit;
                    self.at += 1;
                }
                self.ops.extend([Op::Number(exponent), Op::Pow]);
            }
            _ => {}
        }
        Ok(())
    }

    fn factor(&mut self) -> Parsed {
        match self.peek() {
            None => self.refuse(ExpressionFault::Ends),
            Some('(') => self.parenthesis(),
            Some(c) if starts_number(c) => self.number(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some(c) => self.refuse(ExpressionFault::Unexpected(c)),
        }
    }

    fn parenthesis(&mut self) -> Parsed {
        let opened = self.at;
        self.at += 1;
        self.sum()?;
        match self.peek() {
            Some(')') => {
                self.at += 1;
                Ok(())
            }
            None => Err(ExpressionProblem { at: opened, kind: ExpressionFault::Open }),
            Some(c) => self.refuse(ExpressionFault::Unexpected(c)),
        }
    }

    /// Digits with a point or a comma among them, and a power of ten.
    fn number(&mut self) -> Parsed {
        let start = self.at;
        let mut text = String::new();
        let digits = |parser: &mut Self, text: &mut String| {
            while let Some(c) = parser.text.get(parser.at).copied().filter(char::is_ascii_digit) {
                text.push(c);
                parser.at += 1;
            }
        };
        digits(self, &mut text);
        if matches!(self.text.get(self.at), Some('.' | ',')) {
            text.push('.');
            self.at += 1;
            digits(self, &mut text);
        }
        let sign = usize::from(matches!(self.text.get(self.at + 1), Some('-' | '+' | '−')));
        let digit_after = self.text.get(self.at + 1 + sign).is_some_and(char::is_ascii_digit);
        if matches!(self.text.get(self.at), Some('e' | 'E')) && digit_after {
            text.push('e');
            if sign == 1 && self.text[self.at + 1] != '+' {
                text.push('-');
            }
            self.at += 1 + sign;
            digits(self, &mut text);
        }
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => {
                self.ops.push(Op::Number(value));
                Ok(())
            }
            _ => Err(ExpressionProblem { at: start, kind: ExpressionFault::Number }),
        }
    }

    /// A variable, a constant, or a function and its argument. Names that stand side by side, as in `xsin(x)`, are told apart.
    fn name(&mut self) -> Parsed {
        let start = self.at;
        let name: String = self.text[start..].iter().take_while(|c| c.is_alphanumeric() || **c == '₀').collect();
        let Some((known, meaning)) = longest(&name) else {
            return Err(ExpressionProblem { at: start, kind: ExpressionFault::Unknown(name) });
        };
        self.at += known.chars().count();
        match meaning {
            Meaning::Constant(constant) => {
                self.named.push((start..self.at, constant));
                self.ops.push(Op::Constant(constant));
            }
            Meaning::Function(function) => {
                if self.peek() != Some('(') {
                    return Err(ExpressionProblem { at: start, kind: ExpressionFault::NoArgument(known.to_owned()) });
                }
                self.parenthesis()?;
                self.ops.push(Op::Call(function));
            }
        }
        Ok(())
    }

    /// The next character that is not a space; the place moves to it.
    fn peek(&mut self) -> Option<char> {
        while self.text.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    fn deeper(&mut self, read: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return self.refuse(ExpressionFault::TooDeep);
        }
        read(self)?;
        self.depth -= 1;
        Ok(())
    }

    fn refuse<T>(&self, kind: ExpressionFault) -> Result<T, ExpressionProblem> {
        Err(ExpressionProblem { at: self.at, kind })
    }
}

fn starts_number(c: char) -> bool {
    c.is_ascii_digit() || c == '.' || c == ','
}

fn superscript(c: char) -> Option<f64> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|known| known == c).map(|digit| digit as f64)
}
