//! Numbers as they are written in books: sums of fractions times powers of π, recognised from their decimals.

use std::f64::consts::PI;

/// How near a written number must be to the computed one, beside its size: coefficients carry the rounding of a few operations.
const NEAR: f64 = 4e-14;

/// What is smaller is nothing but rounding.
const NOTHING: f64 = 1e-14;

/// Greatest denominator of a number that stands alone, and of one that is a sum of two: more would fit anything.
const DENOMINATOR: i64 = 1024;
const DENOMINATOR_IN_SUM: i64 = 128;

/// Denominators tried for the part of a sum that has π: those of halves of halves, and thirds of them.
const WITH_PI: [i64; 10] = [1, 2, 4, 8, 16, 32, 64, 3, 6, 12];

/// How far a part of a sum may be from zero: coefficients of unit curves are no larger.
const LARGEST_PART: i64 = 12;

/// num/den · π^power
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    num: i64,
    den: i64,
    power: i32,
}

/// A sum of such parts; none is zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Exact(Vec<Part>);

impl Exact {
    /// The number that these decimals are, if it is one of those that books write.
    #[must_use]
    pub fn of(value: f64) -> Option<Self> {
        if value.abs() < NOTHING {
            return Some(Self(Vec::new()));
        }
        Self::alone(value).or_else(|| Self::sum(value))
    }

    /// True for a single fraction times a power of π.
    #[must_use]
    pub fn is_simple(&self) -> bool {
        self.0.len() < 2
    }

    /// True for zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Its decimals.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.0.iter().map(|part| part.value()).sum()
    }

    /// The product of two.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut parts: Vec<Part> = Vec::new();
        for a in &self.0 {
            for b in &other.0 {
                let part = Part::new(a.num * b.num, a.den * b.den, a.power + b.power);
                match parts.iter_mut().find(|known| known.power == part.power) {
                    Some(known) => {
                        *known =
                            Part::new(known.num * part.den + part.num * known.den, known.den * part.den, part.power);
                    }
                    None => parts.push(part),
                }
            }
        }
        parts.retain(|part| part.num != 0);
        Self(parts)
    }

    /// A whole number of times this.
    #[must_use]
    pub fn multiple(&self, factor: i64) -> Self {
        self.times(&Self(vec![Part { num: factor, den: 1, power: 0 }]))
    }

    /// Its opposite.
    #[must_use]
    pub fn negated(&self) -> Self {
        self.multiple(-1)
    }

    /// True when it is written with a minus before it.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        matches!(self.0[..], [part] if part.num < 0)
    }

    /// Itself times `factor` (which may be empty) in the notation of formulas, without the minus before it.
    #[must_use]
    pub fn notation(&self, factor: &str) -> String {
        match self.0[..] {
            [] => "0".to_owned(),
            [part] => part.notation(factor),
            [first, ref rest @ ..] => {
                let mut text = if first.num < 0 { "-".to_owned() } else { String::new() } + &first.notation("");
                for part in rest {
                    text += if part.num < 0 { " - " } else { " + " };
                    text += &part.notation("");
                }
                if factor.is_empty() { text } else { format!("({text}) {factor}") }
            }
        }
    }

    fn alone(value: f64) -> Option<Self> {
        let part = [0, 1, -1, 2, -2, 3, -3].into_iter().find_map(|power| {
            let (num, den) = fraction(value / PI.powi(power), DENOMINATOR)?;
            Some(Part { num, den, power })
        })?;
        Some(Self(vec![part]))
    }

    fn sum(value: f64) -> Option<Self> {
        for power in [-1, -2, 1] {
            for den in WITH_PI {
                for num in (1..=LARGEST_PART * den).flat_map(|num| [num, -num]) {
                    let with_pi = Part::new(num, den, power);
                    if let Some((num, den)) = fraction(value - with_pi.value(), DENOMINATOR_IN_SUM) {
                        return Some(Self(vec![Part { num, den, power: 0 }, with_pi]));
                    }
                }
            }
        }
        None
    }
}

impl Part {
    /// In lowest terms.
    fn new(num: i64, den: i64, power: i32) -> Self {
        let common = gcd(num.abs(), den).max(1);
        Self { num: num / common, den: den / common, power }
    }

    fn value(self) -> f64 {
        self.num as f64 / self.den as f64 * PI.powi(self.power)
    }

    fn notation(self, factor: &str) -> String {
        let count = |whole: i64, power: i32| match (whole, power) {
            (1, 0) => String::new(),
            (whole, 0) => whole.to_string(),
            (1, 1) => "π".to_owned(),
            (whole, 1) => format!("{whole}π"),
            (1, power) => format!("π^{power}"),
            (whole, power) => format!("{whole}π^{power}"),
        };
        let (above, below) = (count(self.num.abs(), self.power.max(0)), count(self.den, (-self.power).max(0)));
        let above = format!("{above} {factor}").trim().to_owned();
        let above = if above.is_empty() { "1".to_owned() } else { above };
        if below.is_empty() { above } else { format!("({above})/({below})") }
    }
}

/// The fraction with the smallest denominator that is this number.
fn fraction(value: f64, largest: i64) -> Option<(i64, i64)> {
    // Convergents of the continued fraction.
    let (mut before, mut last) = ((0, 1), (1, 0));
    let mut rest = value.abs();
    for _ in 0..12 {
        let whole = rest.floor();
        if whole > 1e6 {
            return None;
        }
        let whole = whole as i64;
        let next = (whole * last.0 + before.0, whole * last.1 + before.1);
        (before, last) = (last, next);
        if last.1 > largest {
            return None;
        }
        if (last.0 as f64 / last.1 as f64 - value.abs()).abs() <= NEAR * value.abs().max(1.0) {
            let num = if value < 0.0 { -last.0 } else { last.0 };
            return (num != 0).then_some((num, last.1));
        }
        rest = 1.0 / (rest - rest.floor());
    }
    None
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The factor of a law's acceleration as π^k·p/(q·π + r), which is how books write those of the modified laws.
#[must_use]
pub fn peak_notation(value: f64) -> Option<String> {
    if let Some(exact) = Exact::alone(value) {
        return Some(exact.notation(""));
    }
    for power in 1..=2 {
        for q in 1..=4 {
            for r in 1..=8 {
                let whole = value * (f64::from(q) * PI + f64::from(r)) / PI.powi(power);
                if (whole - whole.round()).abs() < NEAR * 10.0 && whole.round() <= 16.0 {
                    let above = Part { num: whole.round() as i64, den: 1, power }.notation("");
                    let q = if q == 1 { String::new() } else { q.to_string() };
                    return Some(format!("({above})/({q}π + {r})"));
                }
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(value: f64) -> Option<String> {
        Exact::of(value).map(|exact| exact.notation("x"))
    }

    #[test]
    fn numbers_of_books_are_recognised() {
        for (value, expected) in [
            (10.0, "10 x"),
            (-15.0, "15 x"),
            (0.375, "(3 x)/(8)"),
            (1.0 / PI, "(x)/(π)"),
            (-0.5 / PI, "(x)/(2π)"),
            (PI * PI / 2.0, "(π^2 x)/(2)"),
            (4.0 * PI / 3.0, "(4π x)/(3)"),
            (0.25 / PI - 0.125, "(-(1)/(8) + (1)/(4π)) x"),
            (0.0, "0"),
        ] {
            assert_eq!(written(value).as_deref(), Some(expected), "{value}");
        }
    }

    #[test]
    fn other_numbers_are_not_taken_for_those_of_books() {
        for value in [0.123_456_789_012, 4.888_123_9, 1.759_6, std::f64::consts::E, std::f64::consts::SQRT_2] {
            assert_eq!(Exact::of(value), None, "{value}: {:?}", written(value));
        }
    }

    #[test]
    fn products_are_exact() {
        let (a, b) = (Exact::of(0.25 / PI - 0.125).expect("a"), Exact::of(4.0 * PI / 3.0).expect("b"));
        assert!((a.times(&b).value() - a.value() * b.value()).abs() < 1e-15);
        assert!(a.times(&Exact::of(0.0).expect("zero")).is_zero());
    }

    #[test]
    fn peaks_of_the_modified_laws_are_written_as_in_books() {
        assert_eq!(peak_notation(8.0 * PI / (PI + 2.0)).as_deref(), Some("(8π)/(π + 2)"));
        assert_eq!(peak_notation(4.0 * PI * PI / (PI + 4.0)).as_deref(), Some("(4π^2)/(π + 4)"));
        assert_eq!(peak_notation(4.321_987_654_3), None);
    }
}
