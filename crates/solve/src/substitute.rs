//! Numbers put in the place of letters.

use crate::number::number;
use levalab_formula::Formula;

/// What each letter is worth, as it is written; an angle with `°` at its end.
pub type Values = Vec<(&'static str, String)>;

/// The formula with numbers for its letters. Products of numbers get their points.
pub fn substituted(formula: &Formula, values: &Values) -> Formula {
    let of = |inner: &Formula| Box::new(substituted(inner, values));
    match formula {
        Formula::Symbol(name) => values.iter().find(|(known, _)| known == name).map_or_else(
            || formula.clone(),
            |(_, value)| match value.strip_suffix('°') {
                Some(degrees) => Formula::Product(vec![number(degrees), Formula::Text("°".into())]),
                None => number(value),
            },
        ),
        Formula::Number(_) | Formula::Text(_) => formula.clone(),
        Formula::Negative(inner) => Formula::Negative(of(inner)),
        Formula::Size(inner) => Formula::Size(of(inner)),
        Formula::Bracket(inner) => Formula::Bracket(of(inner)),
        Formula::Call(name, inner) => Formula::Call(name, of(inner)),
        Formula::Times(sign, a, b) => Formula::Times(*sign, of(a), of(b)),
        Formula::Fraction(a, b) => Formula::Fraction(of(a), of(b)),
        Formula::Power(a, b) => Formula::Power(of(a), of(b)),
        Formula::Apply(a, b) => Formula::Apply(a.clone(), of(b)),
        Formula::Product(factors) => product(factors.iter().map(|factor| substituted(factor, values)).collect()),
        Formula::List(items) => Formula::List(items.iter().map(|item| substituted(item, values)).collect()),
        Formula::Sum(terms) => {
            let mut terms: Vec<(char, Formula)> =
                terms.iter().map(|(sign, term)| (*sign, substituted(term, values))).collect();
            // A minus at the head needs no parentheses.
            if let Some((sign, Formula::Negative(inner))) = terms.first()
                && *sign == '+'
            {
                terms[0] = ('−', (**inner).clone());
            }
            Formula::Sum(terms)
        }
        Formula::Relation(first, rest) | Formula::Lines(first, rest) => {
            let rest = rest.iter().map(|(sign, side)| (*sign, substituted(side, values))).collect();
            Formula::Relation(of(first), rest)
        }
        Formula::Matrix(rows) => Formula::Matrix(
            rows.iter().map(|row| row.iter().map(|entry| substituted(entry, values)).collect()).collect(),
        ),
    }
}

/// Factors with a point wherever a number follows another.
fn product(factors: Vec<Formula>) -> Formula {
    let mut factors = factors.into_iter();
    let Some(first) = factors.next() else { return Formula::Number("1".into()) };
    factors.fold(first, |before, factor| match (&before, &factor) {
        (_, Formula::Text(_)) => Formula::Product(vec![before, factor]),
        (_, factor) if begins_with_digit(factor) => Formula::Times('·', Box::new(before), Box::new(factor.clone())),
        _ => match before {
            Formula::Product(mut factors) => {
                factors.push(factor);
                Formula::Product(factors)
            }
            before => Formula::Product(vec![before, factor]),
        },
    })
}

fn begins_with_digit(factor: &Formula) -> bool {
    match factor {
        Formula::Number(_) | Formula::Negative(_) => true,
        Formula::Power(base, _) | Formula::Times(_, base, _) => begins_with_digit(base),
        Formula::Product(factors) => factors.first().is_some_and(begins_with_digit),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use levalab_formula::{latex, parse};
    use levalab_words::Language;

    #[test]
    fn numbers_are_put_in_as_on_the_blackboard() {
        let values = vec![("v", "-0.2".to_owned()), ("s", "0.1".to_owned()), ("ξ", "30°".to_owned())];
        for (text, expected) in [
            ("v - 2s", "-0.2 - 2 \\cdot 0.1"),
            ("s + v", "0.1 + \\left(-0.2\\right)"),
            ("2v^2 - s v", "2 \\cdot \\left(-0.2\\right)^{2} - 0.1 \\cdot \\left(-0.2\\right)"),
            ("m cos(ξ)", "m \\cos \\left(30^\\circ\\right)"),
        ] {
            let found = latex(&substituted(&parse(text).expect(text), &values), Language::En);
            assert_eq!(found, expected, "{text}");
        }
    }
}
