//! How wide formulas are, and where long ones are broken into lines.

use levalab_formula::Formula;

/// What a line of a printed page takes with ease, in letters: longer equations are broken.
const LINE: usize = 66;

/// What it takes at most: what is wider, as a matrix, has to be set smaller.
pub const WHOLE_LINE: usize = 88;

/// An equation over as many lines as it takes: each side, with the sign before it, on a line of its own when not all fit on one, and sums
/// broken where they are too wide.
pub fn equation(left: Formula, sides: Vec<(char, Formula)>) -> Formula {
    let whole = width(&left) + sides.iter().map(|(_, side)| width(side) + 3).sum::<usize>();
    if whole <= LINE {
        return Formula::Relation(Box::new(left), sides);
    }
    let room = LINE.saturating_sub(width(&left) + 3).max(LINE / 2);
    let lines: Vec<(char, Formula)> = sides.into_iter().flat_map(|(sign, side)| broken(sign, side, room)).collect();
    if lines.len() == 1 { Formula::Relation(Box::new(left), lines) } else { Formula::Lines(Box::new(left), lines) }
}

fn broken(sign: char, side: Formula, room: usize) -> Vec<(char, Formula)> {
    match side {
        Formula::Sum(terms) if terms.iter().map(|(_, term)| width(term) + 3).sum::<usize>() > room => {
            let mut lines: Vec<(char, Vec<(char, Formula)>)> = vec![(sign, Vec::new())];
            let mut used = 0;
            for (sign, term) in terms {
                let needed = width(&term) + 3;
                match lines.last_mut() {
                    Some(line) if used + needed <= room || line.1.is_empty() => {
                        line.1.push((sign, term));
                        used += needed;
                    }
                    _ => {
                        used = needed;
                        // The sign goes before the line, and is not repeated in it.
                        lines.push((sign, vec![('+', term)]));
                    }
                }
            }
            lines.into_iter().map(|(sign, terms)| (sign, Formula::Sum(terms))).collect()
        }
        side => vec![(sign, side)],
    }
}

/// About how many letters wide a formula is.
pub fn width(formula: &Formula) -> usize {
    let sum = |parts: &[Formula]| parts.iter().map(width).sum::<usize>();
    match formula {
        Formula::Number(text) | Formula::Text(text) => text.chars().count(),
        Formula::Symbol(name) => name.chars().filter(|&c| c != '_').count(),
        Formula::Negative(inner) => 1 + width(inner),
        Formula::Sum(terms) => terms.iter().map(|(_, term)| width(term) + 3).sum(),
        Formula::Product(factors) => sum(factors),
        Formula::Times(_, a, b) => width(a) + width(b) + 2,
        Formula::Fraction(above, below) => width(above).max(width(below)),
        Formula::Power(base, raised) => width(base) + width(raised).div_ceil(2),
        Formula::Call("sqrt", inner) | Formula::Size(inner) | Formula::Bracket(inner) => width(inner) + 2,
        Formula::Call(name, inner) => name.len() + width(inner) + 2,
        Formula::Apply(function, inner) => width(function) + width(inner) + 2,
        Formula::Relation(first, rest) => width(first) + rest.iter().map(|(_, side)| width(side) + 3).sum::<usize>(),
        Formula::List(items) => sum(items) + 2 * items.len(),
        Formula::Matrix(rows) => rows.iter().map(|row| sum(row) + 2 * row.len()).max().unwrap_or(0) + 2,
        Formula::Lines(first, lines) => width(first) + lines.iter().map(|(_, line)| width(line) + 3).max().unwrap_or(0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_formula::parse;

    #[test]
    fn what_is_too_wide_goes_on_in_the_next_line() {
        let long =
            parse("1234567.25 x^3 - 7654321.75 x^4 + 1234567.25 x^5 - 7654321.75 x^6 + 1234567.25 x^7 - 12.5 x^8");
        let Formula::Lines(_, lines) = equation(parse("s").expect("s"), vec![('=', long.expect("read"))]) else {
            panic!("one line")
        };
        assert_eq!(lines.iter().map(|(sign, _)| *sign).collect::<Vec<_>>(), ['=', '+']);
        assert!(lines.iter().all(|(_, line)| width(line) <= LINE), "{lines:?}");
        let short = equation(parse("s").expect("s"), vec![('=', parse("1 + x").expect("read"))]);
        assert!(matches!(short, Formula::Relation(..)));
    }
}
