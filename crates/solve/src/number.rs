//! Numbers as a textbook prints them, in the notation of formulas, and sums of terms with numbers.

use levalab_formula::Formula;
use levalab_numbers::write::in_formula;

/// Significant digits of a displacement, of other results, of the entries of a matrix, and of what was typed.
const OF_HEIGHTS: usize = 6;
const OF_RESULTS: usize = 5;
const OF_ENTRIES: usize = 4;
const OF_DATA: usize = 10;

/// Significant digits of the largest coefficient of a polynomial: the others have as many decimals.
const OF_LARGEST: i32 = 7;

/// A coefficient smaller than this part of the largest is rounding.
const ROUNDING: f64 = 1e-11;

/// A displacement.
pub fn height(value: f64) -> String {
    in_formula(value, OF_HEIGHTS)
}

/// A result.
pub fn result(value: f64) -> String {
    in_formula(value, OF_RESULTS)
}

/// An entry of a matrix.
pub fn entry(value: f64) -> String {
    in_formula(value, OF_ENTRIES)
}

/// A number that was typed.
pub fn datum(value: f64) -> String {
    in_formula(value, OF_DATA)
}

/// An angle in degrees, two decimals.
pub fn angle(degrees: f64) -> String {
    fixed(degrees, 2)
}

/// A place x of a segment, four decimals.
pub fn part(x: f64) -> String {
    fixed(x, 4)
}

/// So many decimals at most.
fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return in_formula(value, OF_RESULTS);
    }
    let text = format!("{value:.decimals$}");
    let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

/// Coefficients with the decimals that seven digits of the largest leave; what is rounding is 0.
pub fn coefficients(values: &[f64]) -> Vec<String> {
    let largest = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return values.iter().map(|&value| result(value)).collect();
    }
    let decimals = OF_LARGEST - 1 - largest.log10().floor() as i32;
    let written = |&value: &f64| match usize::try_from(decimals) {
        _ if value.abs() < ROUNDING * largest => "0".to_owned(),
        // Numbers that are all small, or all large, need a power of ten.
        Ok(decimals) if decimals <= 9 => fixed(value, decimals),
        _ => in_formula(value, OF_LARGEST as usize),
    };
    values.iter().map(written).collect()
}

/// A result smaller than this part of the greatest of its kind is 0: places of extremes are known to so many digits.
pub const NEGLIGIBLE: f64 = 1e-8;

/// What is nothing beside a scale is 0.
pub fn settled(value: f64, scale: f64) -> f64 {
    if value.abs() <= NEGLIGIBLE * scale { 0.0 } else { value }
}

/// A number as a formula; a minus stands before it.
pub fn number(text: &str) -> Formula {
    let (negative, size) = text.strip_prefix('-').map_or((false, text), |size| (true, size));
    let size = match size.split_once("·10^") {
        Some((mantissa, exponent)) => Formula::Times(
            '·',
            Box::new(Formula::Number(mantissa.into())),
            Box::new(Formula::Power(Box::new(Formula::Number("10".into())), Box::new(number(exponent)))),
        ),
        None => Formula::Number(size.into()),
    };
    if negative { Formula::Negative(Box::new(size)) } else { size }
}

/// Terms of a sum: numbers as they are written, each with what it is multiplied by; those that are 0 are left out.
#[derive(Default)]
pub struct Terms(Vec<(char, Formula)>);

impl Terms {
    /// Adds a term.
    pub fn add(&mut self, coefficient: &str, factor: Option<Formula>) {
        if coefficient == "0" {
            return;
        }
        let (sign, size) = coefficient.strip_prefix('-').map_or(('+', coefficient), |size| ('−', size));
        let term = match (size, factor) {
            (size, None) => number(size),
            ("1", Some(factor)) => factor,
            (size, Some(factor)) => Formula::Product(vec![number(size), factor]),
        };
        self.0.push((sign, term));
    }

    /// The sum; 0 when there is nothing.
    pub fn sum(mut self) -> Formula {
        match self.0.len() {
            0 => Formula::Number("0".into()),
            1 => {
                let (sign, term) = self.0.remove(0);
                if sign == '−' { Formula::Negative(Box::new(term)) } else { term }
            }
            _ => Formula::Sum(self.0),
        }
    }
}

/// A letter.
pub fn symbol(name: &str) -> Formula {
    Formula::Symbol(name.to_owned())
}

/// A letter raised to a power; none for the power 0.
pub fn power(letter: &Formula, raised: usize) -> Option<Formula> {
    match raised {
        0 => None,
        1 => Some(letter.clone()),
        _ => Some(Formula::Power(Box::new(letter.clone()), Box::new(Formula::Number(raised.to_string())))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_printed_as_in_books() {
        assert_eq!(coefficients(&[0.0, 1e-16, 0.6, -0.800_000_000_000_1, 0.3]), ["0", "0", "0.6", "-0.8", "0.3"]);
        assert_eq!(
            coefficients(&[612.670_4, -4_057.051_2, 10_696.413_9, -13_873.628_1]),
            ["612.67", "-4057.05", "10696.41", "-13873.63"]
        );
    }

    #[test]
    fn angles_and_parts_lose_their_last_zeros() {
        assert_eq!(
            (angle(-30.374), angle(120.0), angle(-0.001), part(0.527_272)),
            ("-30.37".into(), "120".into(), "0".into(), "0.5273".into())
        );
    }
}
