//! Which parts of an expression are lengths: what a change of unit has to know.

use super::{Constant, Expression, ExpressionProblem, Op};
use std::ops::Range;

impl Constant {
    /// The power of the unit of length that it is measured in; places are lengths on a cam that travels.
    fn degree(self, travels: bool) -> i32 {
        match self {
            Self::Rise | Self::Start => 1,
            Self::Theta | Self::Beta => i32::from(travels),
            Self::X | Self::Pi | Self::Euler => 0,
        }
    }
}

impl Expression {
    /// The power of the unit of length that the value is measured in: 1 for a length whatever the unit, none when terms of different
    /// powers are added, as in L + 5.
    #[must_use]
    pub fn degree(&self, travels: bool) -> Option<i32> {
        // The power of each operand, and its value when it is a plain number.
        let mut stack: Vec<(i32, Option<f64>)> = Vec::new();
        for op in &self.ops {
            let operand = match *op {
                Op::Number(value) => (0, Some(value)),
                Op::Constant(constant) => (constant.degree(travels), None),
                Op::Neg => {
                    let (degree, value) = stack.pop()?;
                    (degree, value.map(|value| -value))
                }
                Op::Call(_) => match stack.pop()? {
                    (0, _) => (0, None),
                    _ => return None,
                },
                Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Pow => {
                    let ((right, exponent), (left, _)) = (stack.pop()?, stack.pop()?);
                    match op {
                        Op::Mul => (left + right, None),
                        Op::Div => (left - right, None),
                        Op::Pow if right != 0 => return None,
                        Op::Pow if left == 0 => (0, None),
                        Op::Pow => (left * exponent.filter(|n| n.fract() == 0.0 && n.abs() < 100.0)? as i32, None),
                        _ if left == right => (left, None),
                        _ => return None,
                    }
                }
            };
            stack.push(operand);
        }
        stack.pop().map(|(degree, _)| degree)
    }

    /// Where a text names lengths, as ranges of characters.
    ///
    /// # Errors
    /// As [`Expression::parse`].
    pub fn lengths(text: &str, travels: bool) -> Result<Vec<Range<usize>>, ExpressionProblem> {
        let named = Self::read(text)?.1;
        Ok(named.into_iter().filter(|(_, constant)| constant.degree(travels) != 0).map(|(place, _)| place).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn degree(text: &str, travels: bool) -> Option<i32> {
        Expression::parse(text).expect(text).degree(travels)
    }

    #[test]
    fn a_length_is_told_from_what_only_has_its_number() {
        for text in ["s₀ + L (10x³ − 15x⁴ + 6x⁵)", "L sin(πθ/β)", "-L^3/s0^2", "L^2/L", "β L/θ", "L·L^-0 + s0"]
        {
            assert_eq!(degree(text, false), Some(1), "{text}");
        }
        for (text, found) in
            [("5", Some(0)), ("5 + L", None), ("sin(L)", None), ("2^L", None), ("L^x", None), ("L²", Some(2))]
        {
            assert_eq!(degree(text, false), found, "{text}");
        }
        assert_eq!((degree("θ/2", false), degree("θ/2", true), degree("sin(θ)L", true)), (Some(0), Some(1), None));
    }

    #[test]
    fn names_of_lengths_are_found_where_they_stand() {
        assert_eq!(Expression::lengths("2L + s₀ x", false), Ok(vec![1..2, 5..7]));
        assert_eq!(Expression::lengths("theta Lx", true), Ok(vec![0..5, 6..7]));
        assert_eq!(Expression::lengths("theta·x", false), Ok(Vec::new()));
    }
}
