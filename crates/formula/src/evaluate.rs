//! The value of a formula, in complex numbers: points of the plane are magnitudes too.

use crate::Formula;
use nalgebra::Complex;

type Value = Complex<f64>;

impl Formula {
    /// Its value where `known` gives the symbols theirs; none when a symbol is unknown or there is nothing to compute.
    pub fn value(&self, known: &dyn Fn(&str) -> Option<Value>) -> Option<Value> {
        let of = |formula: &Formula| formula.value(known);
        Some(match self {
            Self::Number(digits) => Value::from(digits.parse::<f64>().ok()?),
            Self::Symbol(name) => match (known(name), name.as_str()) {
                (Some(value), _) => value,
                (None, "π") => Value::from(std::f64::consts::PI),
                (None, "i") => Value::i(),
                _ => return None,
            },
            Self::Negative(inner) => -of(inner)?,
            Self::Bracket(inner) => of(inner)?,
            Self::Size(inner) => Value::from(of(inner)?.norm()),
            Self::Sum(terms) => {
                let mut sum = Value::default();
                for (sign, term) in terms {
                    match sign {
                        '+' => sum += of(term)?,
                        '−' => sum -= of(term)?,
                        _ => return None,
                    }
                }
                sum
            }
            Self::Product(factors) => {
                let mut product = Value::from(1.0);
                for factor in factors {
                    product *= of(factor)?;
                }
                product
            }
            Self::Times('×', a, b) => Value::from((of(a)?.conj() * of(b)?).im),
            Self::Times(_, a, b) => of(a)? * of(b)?,
            Self::Fraction(above, below) => of(above)? / of(below)?,
            Self::Power(base, raised) => {
                let (base, raised) = (of(base)?, of(raised)?);
                let whole = raised.re.round();
                if raised.im == 0.0 && (raised.re - whole).abs() == 0.0 {
                    base.powi(whole as i32)
                } else {
                    base.powc(raised)
                }
            }
            Self::Call(name, argument) => call(name, argument, known)?,
            Self::Text(_)
            | Self::Apply(..)
            | Self::Relation(..)
            | Self::List(_)
            | Self::Matrix(_)
            | Self::Lines(..) => return None,
        })
    }
}

fn call(name: &str, argument: &Formula, known: &dyn Fn(&str) -> Option<Value>) -> Option<Value> {
    if let ("min" | "max", Formula::List(items)) = (name, argument) {
        let values = items.iter().map(|item| item.value(known).map(|value| value.re)).collect::<Option<Vec<f64>>>()?;
        let chosen =
            if name == "min" { values.into_iter().reduce(f64::min) } else { values.into_iter().reduce(f64::max) };
        return chosen.map(Value::from);
    }
    let value = argument.value(known)?;
    Some(match name {
        "sin" => value.sin(),
        "cos" => value.cos(),
        "tan" => value.tan(),
        "arctan" => value.atan(),
        "arcsin" => value.asin(),
        "arccos" => value.acos(),
        "arg" => Value::from(value.arg()),
        "sqrt" => value.sqrt(),
        "exp" => value.exp(),
        "ln" => value.ln(),
        "log" => value.log(10.0),
        "sinh" => value.sinh(),
        "cosh" => value.cosh(),
        "tanh" => value.tanh(),
        "sign" => Value::from(value.re.signum()),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    fn value(text: &str) -> Value {
        let known = |name: &str| match name {
            "a" => Some(Value::from(2.0)),
            "b_1" => Some(Value::from(3.0)),
            "P'" => Some(Value::new(1.0, 2.0)),
            _ => None,
        };
        parse(text).expect(text).value(&known).expect(text)
    }

    #[test]
    fn formulas_mean_what_they_mean_in_books() {
        for (text, expected) in [
            ("2a b_1", 12.0),
            ("1/2 a^2", 2.0),
            ("a^2/2 - b_1", -1.0),
            ("-a^2 + 10", 6.0),
            ("a (b_1 + 1)/4", 2.0),
            ("sin(πa/4) + sqrt(b_1 + 1)", 3.0),
            ("|P'|^2", 5.0),
            ("P' × (i P')", 5.0),
            ("max(a, b_1) · [1 + 1]", 6.0),
            ("2^-a", 0.25),
        ] {
            assert!((value(text) - Value::from(expected)).norm() < 1e-14, "{text}: {}", value(text));
        }
        assert!((value("exp(iπ)") + 1.0).norm() < 1e-14);
    }
}
