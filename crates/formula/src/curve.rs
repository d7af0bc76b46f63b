//! The formulas of a law from its own curve: what is printed is what is computed.

use crate::exact::{Exact, peak_notation};
use levalab_core::law::Piece;
use levalab_core::{Curve, Form, MAX_COEFFICIENTS};
use std::f64::consts::{FRAC_PI_2, PI};

/// The notation of y and of its three derivatives, the left side first.
pub const ORDERS: [&str; 4] = ["y", "y'", "y''", "y'''"];

/// A law as formulas.
#[derive(Clone, PartialEq)]
pub struct Written {
    /// The factor C_a that all of its formulas share, when they are simpler with it.
    pub factor: Option<String>,
    /// Each piece.
    pub pieces: Vec<WrittenPiece>,
}

/// A piece of a law as formulas.
#[derive(Clone, PartialEq)]
pub struct WrittenPiece {
    /// Where it holds.
    pub span: String,
    /// y, y′, y″ and y‴ of x, without their left sides.
    pub orders: [String; 4],
}

/// The formulas of these pieces; none when their numbers are not those of books.
#[must_use]
pub fn written(pieces: &[Piece]) -> Option<Written> {
    let plain = terms_of(pieces, 1.0).filter(|pieces| pieces.iter().all(Terms::is_simple));
    let (factor, terms) = match plain {
        Some(terms) => (None, terms),
        None => {
            let peak = peak(pieces);
            (Some(peak_notation(peak)?), terms_of(pieces, 1.0 / peak)?)
        }
    };
    let mut from = "0".to_owned();
    let mut written = Vec::new();
    for (piece, terms) in pieces.iter().zip(terms) {
        let until = Exact::of(piece.until)?.notation("");
        let span = format!("{from} ≤ x ≤ {until}");
        from = until;
        let with_factor = |text: String| if factor.is_some() { times_peak(&text) } else { text };
        written.push(WrittenPiece { span, orders: [0, 1, 2, 3].map(|order| with_factor(terms.notation(order))) });
    }
    Some(Written { factor, pieces: written })
}

/// A sum times C_a, in brackets when there is more than one term.
fn times_peak(text: &str) -> String {
    let mut depth = 0;
    let more = text.char_indices().any(|(i, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0 && (text[i..].starts_with(" + ") || text[i..].starts_with(" - "))
    });
    let (sign, size) = text.strip_prefix('-').map_or(("", text), |size| ("-", size));
    match (more, size) {
        (true, _) => format!("C_a [{text}]"),
        (_, "0") => "0".to_owned(),
        (_, "1") => format!("{sign}C_a"),
        _ => {
            // Numbers come first: 4π C_a cos(4πx).
            let (number, rest) = size.split_at(["sin(", "cos("].iter().find_map(|name| size.find(name)).unwrap_or(0));
            format!("{sign}{number}C_a {rest}")
        }
    }
}

/// Greatest acceleration of a curve whose pieces reach it at an end or where a wave has its crest.
fn peak(pieces: &[Piece]) -> f64 {
    const STEPS: usize = 720;
    let mut from = 0.0;
    let mut peak = 0.0_f64;
    for piece in pieces {
        let at = |i: usize| from + (piece.until - from) * i as f64 / STEPS as f64;
        peak = (0..=STEPS).map(|i| piece.at(at(i)).a.abs()).fold(peak, f64::max);
        from = piece.until;
    }
    peak
}

/// A piece in exact numbers.
struct Terms {
    /// Powers are of 1 − x instead of x.
    reversed: bool,
    powers: Vec<Exact>,
    waves: Vec<Wave>,
}

/// amplitude · sin(frequency·x + phase), or the cosine.
struct Wave {
    amplitude: Exact,
    frequency: Exact,
    /// The phase, less any whole quarter turns.
    phase: Exact,
    /// Quarter turns: 0 is a sine, 1 a cosine.
    quarters: usize,
}

fn terms_of(pieces: &[Piece], scale: f64) -> Option<Vec<Terms>> {
    let of = |piece: &Piece| {
        // A curve in a variable of its own is told by the formula of its law.
        let own = piece.origin != 0.0 || piece.span != 1.0;
        if own { None } else { Terms::of(&piece.curve.clone().scaled(scale, 0.0)) }
    };
    pieces.iter().map(of).collect()
}

impl Terms {
    fn of(form: &Form) -> Option<Self> {
        let polynomial;
        let curve = if let Form::Curve(curve) = form {
            curve
        } else {
            polynomial = Curve::polynomial(&form.coefficients().filter(|all| all.len() <= MAX_COEFFICIENTS)?);
            &polynomial
        };
        let powers: Option<Vec<Exact>> = curve.coefficients().iter().map(|&c| Exact::of(c)).collect();
        let waves: Option<Vec<Wave>> = curve.waves().iter().map(Wave::of).collect();
        let mut terms = Self { reversed: false, powers: powers?, waves: waves? };
        if terms.waves.is_empty()
            && let Some(reversed) = reversed(curve)
            && count(&reversed) < count(&terms.powers)
        {
            (terms.reversed, terms.powers) = (true, reversed);
        }
        Some(terms)
    }

    fn is_simple(&self) -> bool {
        self.powers.iter().all(Exact::is_simple) && self.waves.iter().all(|wave| wave.amplitude.is_simple())
    }

    /// The derivative of that order.
    fn notation(&self, order: usize) -> String {
        let mut sum = Sum::default();
        let mirrored = if self.reversed && order % 2 == 1 { -1 } else { 1 };
        let letter = if self.reversed { "(1 - x)" } else { "x" };
        for (k, coefficient) in self.powers.iter().enumerate().skip(order) {
            let falling: i64 = (0..order).map(|i| (k - i) as i64).product();
            let factor = match k - order {
                0 => String::new(),
                1 => letter.to_owned(),
                power => format!("{letter}^{power}"),
            };
            sum.add(&coefficient.multiple(falling * mirrored), &factor);
        }
        for wave in &self.waves {
            wave.add(order, &mut sum);
        }
        if sum.text.is_empty() { "0".to_owned() } else { sum.text }
    }
}

/// Coefficients in powers of 1 − x.
fn reversed(curve: &Curve) -> Option<Vec<Exact>> {
    let coefficients = curve.coefficients();
    let mut reversed = vec![0.0; coefficients.len()];
    for (k, c) in coefficients.iter().enumerate() {
        // x = 1 − u, so xᵏ = Σ (k over i)·(−u)ⁱ.
        let mut choose = 1.0;
        for (i, slot) in reversed.iter_mut().enumerate().take(k + 1) {
            *slot += c * choose * if i % 2 == 0 { 1.0 } else { -1.0 };
            choose *= (k - i) as f64 / (i + 1) as f64;
        }
    }
    reversed.into_iter().map(Exact::of).collect()
}

fn count(powers: &[Exact]) -> usize {
    powers.iter().filter(|power| !power.is_zero()).count()
}

impl Wave {
    fn of(wave: &levalab_core::Wave) -> Option<Self> {
        let whole = (wave.phase / FRAC_PI_2).round();
        let near = (wave.phase - whole * FRAC_PI_2).abs() < PHASE;
        // A phase that is no whole quarter is kept within an eighth of a turn of none or of half a turn.
        let quarters = if near { whole } else { 2.0 * (wave.phase / PI).round() };
        let phase = if near { 0.0 } else { wave.phase - quarters * FRAC_PI_2 };
        Some(Self {
            amplitude: Exact::of(wave.amplitude)?,
            frequency: Exact::of(wave.frequency)?,
            phase: Exact::of(phase)?,
            quarters: (quarters as i64).rem_euclid(4) as usize,
        })
    }

    /// Each derivative is a quarter turn ahead and as many times larger as the frequency says.
    fn add(&self, order: usize, sum: &mut Sum) {
        let quarters = (self.quarters + order) % 4;
        let mut amplitude = if quarters >= 2 { self.amplitude.negated() } else { self.amplitude.clone() };
        for _ in 0..order {
            amplitude = amplitude.times(&self.frequency);
        }
        let name = if quarters.is_multiple_of(2) { "sin" } else { "cos" };
        let mut angle = self.frequency.notation("x");
        if !self.phase.is_zero() {
            angle += if self.phase.is_negative() { " - " } else { " + " };
            angle += &self.phase.notation("");
        }
        let wave = format!("{name}({angle})");
        // A tall angle stands beside its fraction, not above it.
        if angle.contains('/') { sum.add_beside(&amplitude, &wave) } else { sum.add(&amplitude, &wave) }
    }
}

/// Radians: phases nearer than this to a whole quarter turn are one.
const PHASE: f64 = 1e-12;

/// Terms with the signs between them.
#[derive(Default)]
struct Sum {
    text: String,
}

impl Sum {
    fn add(&mut self, coefficient: &Exact, factor: &str) {
        if !coefficient.is_zero() {
            self.sign(coefficient);
            self.text += &coefficient.notation(factor);
        }
    }

    /// The same with the factor after the coefficient, also when that is a fraction.
    fn add_beside(&mut self, coefficient: &Exact, factor: &str) {
        if !coefficient.is_zero() {
            self.sign(coefficient);
            let size = coefficient.notation("");
            self.text += &if size == "1" { factor.to_owned() } else { format!("{size} {factor}") };
        }
    }

    fn sign(&mut self, coefficient: &Exact) {
        self.text += match (self.text.is_empty(), coefficient.is_negative()) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;
    use levalab_core::LAWS;
    use levalab_core::Law;
    use levalab_core::law::Arguments;
    use nalgebra::Complex;

    fn rising(law: &Law) -> Arguments {
        Arguments { parameters: law.default_parameters(), falling: false, beta: 1.0 }
    }

    fn pieces(id: &str) -> Vec<Piece> {
        let law = Law::by_id(id).expect(id);
        law.unit(rising(law)).expect(id)
    }

    #[test]
    fn printed_formulas_give_the_values_of_their_laws() {
        let mut tested = 0;
        for law in LAWS {
            let Ok(pieces) = law.unit(rising(law)) else { continue };
            let Some(written) = written(&pieces) else { continue };
            tested += 1;
            let factor = written.factor.as_ref().map(|text| parse(text).expect(text).value(&|_| None).expect(text));
            let mut from = 0.0;
            for (piece, formulas) in pieces.iter().zip(&written.pieces) {
                for i in 0..=40 {
                    let x = from + (piece.until - from) * f64::from(i) / 40.0;
                    let known = |name: &str| match name {
                        "x" => Some(Complex::from(x)),
                        "C_a" => factor,
                        _ => None,
                    };
                    for (order, text) in formulas.orders.iter().enumerate() {
                        let printed = parse(text).expect(text).value(&known).expect(text).re;
                        let computed = piece.at(x).order(order);
                        assert!(
                            (printed - computed).abs() < 1e-11 * (1.0 + computed.abs()),
                            "{} {text} at {x}",
                            law.id
                        );
                    }
                }
                from = piece.until;
            }
        }
        assert!(tested >= 17, "only {tested} laws have formulas");
    }

    #[test]
    fn formulas_are_those_of_the_books() {
        let first = |id: &str| written(&pieces(id)).expect(id).pieces[0].orders[0].clone();
        assert_eq!(first("polynomial-3-4-5"), "10 x^3 - 15 x^4 + 6 x^5");
        assert_eq!(first("cycloidal"), "x - (sin(2π x))/(2π)");
        assert_eq!(first("simple-harmonic"), "(1)/(2) - (cos(π x))/(2)");
        assert_eq!(first("modified-sine"), "C_a [(x)/(4π) - (sin(4π x))/(16π^2)]");
        let halves = written(&pieces("parabolic")).expect("parabolic");
        assert_eq!(halves.pieces[1].orders[0], "1 - 2 (1 - x)^2");
        assert_eq!(halves.pieces[1].span, "(1)/(2) ≤ x ≤ 1");
        let trapezoid = written(&pieces("modified-trapezoidal")).expect("trapezoid");
        assert_eq!((trapezoid.factor.as_deref(), trapezoid.pieces.len()), (Some("(8π)/(π + 2)"), 5));
    }
}
