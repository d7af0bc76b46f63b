//! A number as it is typed: digits, signs, products, quotients, powers, sums, π, brackets, mixed fractions.

use crate::NumberProblem;

/// Maximum depth of brackets and signs: what is typed in a field has one or two.
const MAX_DEPTH: usize = 32;

/// Reads a calculation from the beginning of a text; returns its value and what follows it, which is taken for a unit.
pub(crate) fn calculation(text: &str) -> Result<(f64, &str), NumberProblem> {
    let mut reader = Reader { rest: text, depth: 0 };
    let value = reader.sum()?;
    Ok((value, reader.rest.trim_start()))
}

/// The rest of the text, read from the left.
struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl<'a> Reader<'a> {
    fn sum(&mut self) -> Result<f64, NumberProblem> {
        let mut sum = self.product()?;
        loop {
            if self.eat(&['+']) {
                sum += self.product()?;
            } else if self.eat(MINUS_SIGNS) {
                sum -= self.product()?;
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Result<f64, NumberProblem> {
        let mut product = self.signed()?;
        loop {
            if self.eat(&['*', '·', '×', '⋅']) {
                product *= self.signed()?;
            } else if self.next_divides() {
                self.eat(&['/', '÷', ':']);
                let divisor = self.signed()?;
                if divisor == 0.0 {
                    return Err(NumberProblem::DivisionByZero);
                }
                product /= divisor;
            } else if let Some(pi) = self.pi() {
                // 2π
                product *= self.raised(pi)?;
            } else {
                return Ok(product);
            }
        }
    }

    /// A quotient goes on with a number; `1/s` after a number is a unit.
    fn next_divides(&self) -> bool {
        let rest = self.rest.trim_start();
        let Some(divisor) = rest.strip_prefix(['/', '÷', ':']) else { return false };
        let divisor = divisor.trim_start();
        divisor.is_empty()
            || divisor.starts_with(|c: char| c.is_ascii_digit() || ".,(+-−–πp".contains(c))
                && !divisor.starts_with("ps")
    }

    fn signed(&mut self) -> Result<f64, NumberProblem> {
        if self.eat(MINUS_SIGNS) {
            return self.deeper(Self::signed).map(|value| -value);
        }
        if self.eat(&['+']) {
            return self.deeper(Self::signed);
        }
        let base = self.atom()?;
        self.raised(base)
    }

    /// A power binds from the right: 2^3^2 is 2^9.
    fn raised(&mut self, base: f64) -> Result<f64, NumberProblem> {
        if self.eat(&['^']) {
            return self.deeper(Self::signed).map(|power| base.powf(power));
        }
        for (sign, power) in [('²', 2), ('³', 3)] {
            if self.eat(&[sign]) {
                return Ok(base.powi(power));
            }
        }
        Ok(base)
    }

    fn atom(&mut self) -> Result<f64, NumberProblem> {
        if self.eat(&['(']) {
            let value = self.deeper(Self::sum)?;
            return if self.eat(&[')']) { Ok(value) } else { Err(NumberProblem::Unreadable) };
        }
        match self.pi() {
            Some(pi) => Ok(pi),
            None => self.number(),
        }
    }

    fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T, NumberProblem>) -> Result<T, NumberProblem> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(NumberProblem::Unreadable);
        }
        let read = read(self);
        self.depth -= 1;
        read
    }

    fn pi(&mut self) -> Option<f64> {
        let rest = self.rest.trim_start();
        let after = ["π", "pi", "PI", "Pi"].into_iter().find_map(|name| rest.strip_prefix(name))?;
        // `pie` is no π.
        if after.starts_with(char::is_alphabetic) {
            return None;
        }
        self.rest = after;
        Some(std::f64::consts::PI)
    }

    /// A decimal number with point or comma, thousands parted by spaces or apostrophes, an exponent; or a mixed fraction: `1 1/4`.
    fn number(&mut self) -> Result<f64, NumberProblem> {
        let rest = self.rest.trim_start();
        let (text, after) = digits_of(rest)?;
        let value: f64 = text.parse().map_err(|_| NumberProblem::Unreadable)?;
        if !value.is_finite() {
            return Err(NumberProblem::Huge);
        }
        self.rest = after;
        if !text.contains(['.', 'e'])
            && let Some((fraction, after)) = proper_fraction(after)?
        {
            self.rest = after;
            return Ok(value + fraction);
        }
        Ok(value)
    }

    fn eat(&mut self, signs: &[char]) -> bool {
        let rest = self.rest.trim_start();
        match rest.strip_prefix(signs) {
            Some(after) => {
                self.rest = after;
                true
            }
            None => false,
        }
    }
}

/// The signs that stand for a minus.
pub(crate) const MINUS_SIGNS: &[char] = &['-', '−', '–', '‒'];

/// The digits at the beginning of a text in the form that Rust reads, and what follows them.
fn digits_of(text: &str) -> Result<(String, &str), NumberProblem> {
    let mut digits = String::new();
    let mut signs = 0;
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        match c {
            '0'..='9' => digits.push(c),
            '.' | ',' => {
                signs += 1;
                digits.push('.');
            }
            _ if signs == 0 && parts_thousands(&digits, c, rest) => {}
            _ => break,
        }
        rest = &rest[c.len_utf8()..];
    }
    if !digits.contains(|c: char| c.is_ascii_digit()) {
        return Err(NumberProblem::Unreadable);
    }
    if signs > 1 {
        return Err(NumberProblem::TwoSigns);
    }
    if let Some(after) = rest.strip_prefix(['e', 'E']) {
        let (sign, after) = match after.strip_prefix(MINUS_SIGNS) {
            Some(after) => ("-", after),
            None => ("", after.strip_prefix('+').unwrap_or(after)),
        };
        let end = after.find(|c: char| !c.is_ascii_digit()).unwrap_or(after.len());
        if end == 0 {
            return if after.is_empty() { Err(NumberProblem::Exponent) } else { Err(NumberProblem::Unreadable) };
        }
        digits = format!("{digits}e{sign}{}", &after[..end]);
        rest = &after[end..];
    }
    Ok((digits, rest))
}

/// True for a space or an apostrophe between groups of three digits. Three digits before a fraction are its numerator, or they are not:
/// that is for [`proper_fraction`] to refuse.
fn parts_thousands(digits: &str, c: char, rest: &str) -> bool {
    let separates = c.is_whitespace() || matches!(c, '\'' | '’');
    let group: Vec<char> = rest.chars().skip(1).take(4).collect();
    let three = group.len() >= 3 && group[..3].iter().all(char::is_ascii_digit);
    let ends = group.get(3).is_none_or(|next| !next.is_ascii_digit());
    !digits.is_empty() && separates && three && ends && !before_fraction(rest)
}

/// True if the digits that follow are the numerator of a fraction.
fn before_fraction(rest: &str) -> bool {
    let rest = rest.trim_start().trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    rest.starts_with(['/', '÷'])
}

/// A fraction smaller than one behind a whole number and a space, and what follows it: the `1/4` of `1 1/4`. What may be meant otherwise, as in
/// `1 500/2`, is refused.
fn proper_fraction(text: &str) -> Result<Option<(f64, &str)>, NumberProblem> {
    let spaced = text.trim_start();
    if spaced.len() == text.len() || !spaced.starts_with(|c: char| c.is_ascii_digit()) {
        return Ok(None);
    }
    let digits = |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let (numerator, rest) = spaced.split_at(digits(spaced));
    let Some(rest) = rest.trim_start().strip_prefix(['/', '÷']) else { return Err(NumberProblem::Unreadable) };
    let rest = rest.trim_start();
    let (denominator, rest) = rest.split_at(digits(rest));
    match (numerator.parse::<f64>(), denominator.parse::<f64>()) {
        (Ok(numerator), Ok(denominator)) if numerator < denominator && numerator < 100.0 => {
            Ok(Some((numerator / denominator, rest)))
        }
        _ => Err(NumberProblem::Ambiguous),
    }
}
