//! The formula of a curve with its numbers: polynomials and waves, and their derivatives.

use crate::document::formula;
use crate::number::{self, Terms, power, symbol};
use levalab_core::{Form, Wave};
use levalab_formula::Formula;
use levalab_formula::exact::Exact;
use std::f64::consts::FRAC_PI_2;

/// A phase this near to a whole quarter turn is one, radians.
const PHASE: f64 = 1e-9;

/// The derivative of that order with respect to the letter, in numbers; none for an expression, which is written otherwise.
pub fn derivative(form: &Form, order: usize, letter: &str) -> Option<Formula> {
    let letter = symbol(letter);
    let (powers, waves): (Vec<f64>, &[Wave]) = match form {
        Form::Curve(curve) => (curve.coefficients().to_vec(), curve.waves()),
        Form::Series(series) => (series.coefficients(), &[]),
        Form::Formula(_) => return None,
    };
    let mut terms = Terms::default();
    // What is rounding beside the waves is none of the polynomial's either.
    let highest =
        waves.iter().map(|wave| (wave.amplitude * wave.frequency.powi(order as i32)).abs()).fold(0.0, f64::max);
    let powers: Vec<f64> = differentiated(&powers, order).into_iter().map(|c| number::settled(c, highest)).collect();
    let (amplitudes, factors): (Vec<f64>, Vec<Formula>) = waves.iter().map(|wave| waved(wave, order, &letter)).unzip();
    let all = number::coefficients(&[powers.as_slice(), &amplitudes].concat());
    let (of_powers, of_waves) = all.split_at(powers.len());
    for (k, text) in of_powers.iter().enumerate() {
        terms.add(text, power(&letter, k));
    }
    // Beside a polynomial amplitudes have its decimals; alone, those of a result.
    let alone = of_powers.iter().all(|text| text == "0");
    for ((text, amplitude), factor) in of_waves.iter().zip(amplitudes).zip(factors) {
        terms.add(&if alone { number::result(amplitude) } else { text.clone() }, Some(factor));
    }
    Some(terms.sum())
}

/// Coefficients of a derivative.
fn differentiated(powers: &[f64], order: usize) -> Vec<f64> {
    let falling = |k: usize| (0..order).map(|i| (k - i) as f64).product::<f64>();
    powers.iter().enumerate().skip(order).map(|(k, c)| c * falling(k)).collect()
}

/// A derivative of a wave: its amplitude, and its sine or cosine.
fn waved(wave: &Wave, order: usize, letter: &Formula) -> (f64, Formula) {
    let whole = (wave.phase / FRAC_PI_2).round();
    let near = (wave.phase - whole * FRAC_PI_2).abs() < PHASE;
    let (quarters, phase) = if near { (whole as i64, 0.0) } else { (0, wave.phase) };
    let quarters = (quarters + order as i64).rem_euclid(4);
    let sign = if quarters >= 2 { -1.0 } else { 1.0 };
    let amplitude = sign * wave.amplitude * wave.frequency.powi(order as i32);
    let angle = format!("{} x{}", exactly(wave.frequency), signed(phase));
    let mut angle = formula(&angle);
    replace(&mut angle, letter);
    let name = if quarters % 2 == 0 { "sin" } else { "cos" };
    (amplitude, Formula::Call(name, Box::new(angle)))
}

/// The letter of the curve in the place of x.
fn replace(formula: &mut Formula, letter: &Formula) {
    if *formula == symbol("x") {
        *formula = letter.clone();
    }
    formula.parts_mut().into_iter().for_each(|part| replace(part, letter));
}

/// A number in the notation, as a multiple of π when it is one.
fn exactly(value: f64) -> String {
    Exact::of(value).filter(Exact::is_simple).map_or_else(
        || number::result(value),
        |exact| format!("{}{}", if value < 0.0 { "-" } else { "" }, exact.notation("")),
    )
}

fn signed(phase: f64) -> String {
    match phase {
        0.0 => String::new(),
        phase if phase < 0.0 => format!(" - {}", exactly(-phase)),
        phase => format!(" + {}", exactly(phase)),
    }
}
