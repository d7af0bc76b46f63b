//! A formula as MathML, which browsers set by themselves.

use super::Formula;
use crate::html::escape;
use levalab_words::Language;

/// A formula within a line of text.
#[must_use]
pub fn inline(formula: &Formula, language: Language) -> String {
    format!("<math>{}</math>", Writer { language }.row(formula))
}

/// A formula on a line of its own.
#[must_use]
pub fn block(formula: &Formula, language: Language) -> String {
    let writer = Writer { language };
    // Equations side by side are formulas of their own, so that a narrow page can put them one under the other.
    let equations = if let Formula::List(items) = formula { items.iter().collect() } else { vec![formula] };
    let last = equations.len() - 1;
    let written = equations.into_iter().enumerate().map(|(i, equation)| {
        let comma = if i < last { "<mo separator=\"true\">,</mo>" } else { "" };
        format!("<math display=\"block\">{}{comma}</math>", writer.row(equation))
    });
    written.collect()
}

/// How tightly a formula holds together: parentheses go around what is looser than its surroundings.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Bond {
    List,
    Relation,
    Sum,
    Product,
    Atom,
}

fn bond(formula: &Formula) -> Bond {
    match formula {
        Formula::List(_) => Bond::List,
        Formula::Relation(..) => Bond::Relation,
        Formula::Sum(_) | Formula::Negative(_) => Bond::Sum,
        Formula::Product(_) | Formula::Times(..) => Bond::Product,
        _ => Bond::Atom,
    }
}

struct Writer {
    language: Language,
}

impl Writer {
    fn row(&self, formula: &Formula) -> String {
        match formula {
            Formula::Number(digits) if self.language == Language::Es => {
                format!("<mn>{}</mn>", digits.replace('.', ","))
            }
            Formula::Number(digits) => format!("<mn>{digits}</mn>"),
            Formula::Symbol(name) => symbol(name),
            Formula::Text(text) => format!("<mtext>{}</mtext>", escape(text)),
            Formula::Negative(inner) => format!("<mo form=\"prefix\">−</mo>{}", self.within(inner, Bond::Product)),
            Formula::Sum(terms) => self.sum(terms),
            Formula::Product(factors) => {
                let mut text = String::new();
                for (i, factor) in factors.iter().enumerate() {
                    if i > 0 {
                        text += if is_named(factor) { THIN } else { "<mo>&#x2062;</mo>" };
                    }
                    text += &self.within(factor, Bond::Product);
                }
                text
            }
            Formula::Times(sign, a, b) => {
                format!("{}<mo>{sign}</mo>{}", self.within(a, Bond::Product), self.within(b, Bond::Product))
            }
            Formula::Fraction(above, below) => format!("<mfrac>{}{}</mfrac>", self.one(above), self.one(below)),
            Formula::Power(base, raised) => self.power(base, raised),
            Formula::Call("sqrt", inner) => format!("<msqrt>{}</msqrt>", self.row(inner)),
            Formula::Call("exp", inner) => format!("<msup><mi mathvariant=\"normal\">e</mi>{}</msup>", self.one(inner)),
            Formula::Call(name, inner) => format!("{}<mo>&#x2061;</mo>{}", self.function(name), self.argument(inner)),
            Formula::Apply(function, inner) => {
                format!("{}<mo>&#x2061;</mo><mrow><mo>(</mo>{}<mo>)</mo></mrow>", self.row(function), self.row(inner))
            }
            Formula::Size(inner) => format!("<mrow><mo>|</mo>{}<mo>|</mo></mrow>", self.row(inner)),
            Formula::Bracket(inner) => format!("<mrow><mo>[</mo>{}<mo>]</mo></mrow>", self.row(inner)),
            Formula::Relation(first, rest) => {
                let rest =
                    rest.iter().map(|(sign, side)| format!("<mo>{}</mo>{}", escape(&sign.to_string()), self.row(side)));
                self.row(first) + &rest.collect::<String>()
            }
            Formula::List(items) => {
                let items: Vec<String> = items.iter().map(|item| self.row(item)).collect();
                items.join("<mo separator=\"true\">,</mo><mspace width=\"0.2em\"/>")
            }
        }
    }

    fn sum(&self, terms: &[(char, Formula)]) -> String {
        let mut text = String::new();
        for (i, (sign, term)) in terms.iter().enumerate() {
            match (i, sign) {
                (0, '+') => {}
                (0, sign) => text += &format!("<mo form=\"prefix\">{sign}</mo>"),
                (_, sign) => text += &format!("<mo>{sign}</mo>"),
            }
            text += &self.within(term, Bond::Product);
        }
        text
    }

    fn power(&self, base: &Formula, raised: &Formula) -> String {
        if let Formula::Call(name, inner) = base
            && !["sqrt", "exp"].contains(name)
        {
            let function = format!("<msup>{}{}</msup>", self.function(name), self.one(raised));
            return format!("{function}<mo>&#x2061;</mo>{}", self.argument(inner));
        }
        let base = match base {
            Formula::Fraction(..) | Formula::Power(..) => {
                format!("<mrow><mo>(</mo>{}<mo>)</mo></mrow>", self.row(base))
            }
            _ => format!("<mrow>{}</mrow>", self.within(base, Bond::Atom)),
        };
        format!("<msup>{base}{}</msup>", self.one(raised))
    }

    fn function(&self, name: &str) -> String {
        let name = match (name, self.language) {
            ("sin", Language::Es) => "sen",
            ("arcsin", Language::Es) => "arcsen",
            ("min", Language::Es) => "mín",
            ("max", Language::Es) => "máx",
            ("sign", _) => "sgn",
            (name, _) => name,
        };
        format!("<mi>{name}</mi>")
    }

    /// What a function is applied to: bare when nothing could be taken for what follows.
    fn argument(&self, inner: &Formula) -> String {
        let bare = match inner {
            Formula::Symbol(_) | Formula::Number(_) => true,
            Formula::Product(factors) => {
                factors.iter().all(|factor| matches!(factor, Formula::Symbol(_) | Formula::Number(_)))
            }
            _ => false,
        };
        if bare {
            format!("{THIN}{}", self.row(inner))
        } else {
            format!("<mrow><mo>(</mo>{}<mo>)</mo></mrow>", self.row(inner))
        }
    }

    /// As a single element.
    fn one(&self, formula: &Formula) -> String {
        format!("<mrow>{}</mrow>", self.row(formula))
    }

    /// With parentheses when it holds together less tightly than its surroundings need.
    fn within(&self, formula: &Formula, needed: Bond) -> String {
        let row = self.row(formula);
        if bond(formula) < needed { format!("<mrow><mo>(</mo>{row}<mo>)</mo></mrow>") } else { row }
    }
}

/// Room between a factor and the name of a function.
const THIN: &str = "<mspace width=\"0.17em\"/>";

/// True for what begins with the name of a function.
fn is_named(formula: &Formula) -> bool {
    match formula {
        Formula::Call(name, _) => !["sqrt", "exp"].contains(name),
        Formula::Power(base, _) => is_named(base),
        _ => false,
    }
}

/// A letter with its index and its primes.
fn symbol(name: &str) -> String {
    let bare = name.trim_end_matches('\'');
    let primes = "′".repeat(name.len() - bare.len());
    let (letter, index) = bare.split_once('_').unwrap_or((bare, ""));
    let letter = if ["π", "i"].contains(&letter) {
        format!("<mi mathvariant=\"normal\">{letter}</mi>")
    } else {
        format!("<mi>{letter}</mi>")
    };
    let index = if index.chars().all(|c| c.is_ascii_digit()) {
        format!("<mn>{index}</mn>")
    } else {
        format!("<mtext>{}</mtext>", escape(index))
    };
    let letter = if index == "<mn></mn>" { letter } else { format!("<msub>{letter}{index}</msub>") };
    // Primes stand beside their letter: as a superscript they vanish in fonts that are not made for mathematics.
    if primes.is_empty() { letter } else { format!("<mrow>{letter}<mo lspace=\"0\" rspace=\"0\">{primes}</mo></mrow>") }
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::*;

    fn written(text: &str) -> String {
        Writer { language: Language::Es }.row(&parse(text).expect(text))
    }

    #[test]
    fn formulas_are_set_as_in_books() {
        assert_eq!(written("R_b"), "<msub><mi>R</mi><mtext>b</mtext></msub>");
        assert_eq!(written("y''"), "<mrow><mi>y</mi><mo lspace=\"0\" rspace=\"0\">′′</mo></mrow>");
        assert_eq!(written("0.5"), "<mn>0,5</mn>");
        assert_eq!(
            written("sin(2a)"),
            "<mi>sen</mi><mo>&#x2061;</mo><mspace width=\"0.17em\"/><mn>2</mn><mo>&#x2062;</mo><mi>a</mi>"
        );
        assert_eq!(
            written("(a + b)/c"),
            "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mrow><mi>c</mi></mrow></mfrac>"
        );
        assert_eq!(
            written("2(a − b)^2"),
            "<mn>2</mn><mo>&#x2062;</mo><msup><mrow><mrow><mo>(</mo><mi>a</mi><mo>−</mo><mi>b</mi><mo>)</mo></mrow></mrow><mrow><mn>2</mn></mrow></msup>"
        );
    }
}
