//! A formula as MathML, which browsers set by themselves.

use crate::{Bond, Element, Formula, Node, bond, is_bare, is_close, is_named, is_variable, letter_of};
use levalab_words::Language;

/// A formula within a line of text.
#[must_use]
pub fn inline(formula: &Formula, language: Language) -> String {
    math(formula, language, false).to_string()
}

/// A formula on a line of its own.
#[must_use]
pub fn block(formula: &Formula, language: Language) -> String {
    // Equations side by side are formulas of their own, so that a narrow page can put them one under the other.
    let equations = if let Formula::List(items) = formula { items.iter().collect() } else { vec![formula] };
    let last = equations.len() - 1;
    let written = equations.into_iter().enumerate().map(|(i, equation)| {
        let mut math = math(equation, language, true);
        if i < last {
            math.children.push(separator());
        }
        math.to_string()
    });
    written.collect()
}

/// A formula as an element, in a line or on a line of its own.
#[must_use]
pub fn math(formula: &Formula, language: Language, display: bool) -> Element {
    let math = Element::new("math", Writer { language }.row(formula));
    if display { math.with("display", "block") } else { math }
}

struct Writer {
    language: Language,
}

/// What stands between two factors, and between a function and its argument: nothing that is seen.
const TIMES: &str = "\u{2062}";
const APPLIED: &str = "\u{2061}";

type Row = Vec<Node>;

impl Writer {
    fn row(&self, formula: &Formula) -> Row {
        match formula {
            Formula::Number(digits) if self.language == Language::Es => leaf("mn", digits.replace('.', ",")),
            Formula::Number(digits) => leaf("mn", digits),
            Formula::Symbol(name) => symbol(name),
            Formula::Text(text) => leaf("mtext", text),
            Formula::Negative(inner) => [prefix('−'), self.within(inner, Bond::Product)].concat(),
            Formula::Sum(terms) => self.sum(terms),
            Formula::Product(factors) => self.product(factors),
            Formula::Times(sign, a, b) => {
                [self.within(a, Bond::Product), operator(*sign), self.within(b, Bond::Product)].concat()
            }
            Formula::Fraction(above, below) => element("mfrac", [self.one(above), self.one(below)].concat()),
            Formula::Power(base, raised) => self.power(base, raised),
            Formula::Call("sqrt", inner) => element("msqrt", self.row(inner)),
            Formula::Call("exp", inner) => {
                let e = Element::text("mi", "e").with("mathvariant", "normal").into();
                element("msup", [vec![e], self.one(inner)].concat())
            }
            Formula::Call(name, inner) => [self.function(name), leaf("mo", APPLIED), self.argument(inner)].concat(),
            Formula::Apply(function, inner) => {
                [self.row(function), leaf("mo", APPLIED), fenced('(', self.row(inner), ')')].concat()
            }
            Formula::Size(inner) => fenced('|', self.row(inner), '|'),
            Formula::Bracket(inner) => fenced('[', self.row(inner), ']'),
            Formula::Relation(first, rest) => {
                let rest = rest.iter().flat_map(|(sign, side)| [operator(*sign), self.row(side)].concat());
                self.row(first).into_iter().chain(rest).collect()
            }
            Formula::List(items) => {
                let mut row = Row::new();
                for (i, item) in items.iter().enumerate() {
                    if i > 0 {
                        row.push(separator());
                        row.push(space("0.2em"));
                    }
                    row.extend(self.row(item));
                }
                row
            }
            Formula::Matrix(rows) => {
                let rows = rows.iter().map(|row| self.table_row(row.iter().map(|entry| self.row(entry))));
                fenced('(', element("mtable", rows.collect()), ')')
            }
            Formula::Lines(first, lines) => self.lines(first, lines),
        }
    }

    fn lines(&self, first: &Formula, lines: &[(char, Formula)]) -> Row {
        let mut left = self.row(first);
        let rows = lines.iter().map(|(sign, line)| {
            let goes_on = ['+', '−'].contains(sign);
            let indent = if goes_on { vec![space("1.5em")] } else { Row::new() };
            let right = [indent, operator(*sign), self.row(line)].concat();
            self.table_row([std::mem::take(&mut left), right].into_iter())
        });
        vec![Element::new("mtable", rows.collect()).with("class", "lines").with("displaystyle", "true").into()]
    }

    fn table_row(&self, cells: impl Iterator<Item = Row>) -> Node {
        Element::new("mtr", cells.map(|cell| Element::new("mtd", cell).into()).collect()).into()
    }

    fn product(&self, factors: &[Formula]) -> Row {
        let mut row = Row::new();
        for (i, factor) in factors.iter().enumerate() {
            if i > 0 {
                match factor {
                    Formula::Text(unit) if is_close(unit) => {}
                    Formula::Text(_) => row.push(thin()),
                    other if is_named(other) => row.push(thin()),
                    _ => row.extend(leaf("mo", TIMES)),
                }
            }
            row.extend(self.within(factor, Bond::Product));
        }
        row
    }

    fn sum(&self, terms: &[(char, Formula)]) -> Row {
        let mut row = Row::new();
        for (i, (sign, term)) in terms.iter().enumerate() {
            match (i, sign) {
                (0, '+') => {}
                (0, sign) => row.extend(prefix(*sign)),
                (_, sign) => row.extend(operator(*sign)),
            }
            row.extend(self.within(term, Bond::Product));
        }
        row
    }

    fn power(&self, base: &Formula, raised: &Formula) -> Row {
        if let Formula::Call(name, inner) = base
            && !["sqrt", "exp"].contains(name)
        {
            let function = element("msup", [self.function(name), self.one(raised)].concat());
            return [function, leaf("mo", APPLIED), self.argument(inner)].concat();
        }
        let base = match base {
            Formula::Fraction(..) | Formula::Power(..) => fenced('(', self.row(base), ')'),
            _ => element("mrow", self.within(base, Bond::Atom)),
        };
        element("msup", [base, self.one(raised)].concat())
    }

    fn function(&self, name: &str) -> Row {
        leaf("mi", function_name(name, self.language))
    }

    fn argument(&self, inner: &Formula) -> Row {
        let row = self.row(inner);
        if is_bare(inner) { [vec![thin()], row].concat() } else { fenced('(', row, ')') }
    }

    /// As a single element.
    fn one(&self, formula: &Formula) -> Row {
        element("mrow", self.row(formula))
    }

    /// With parentheses when it holds together less tightly than its surroundings need.
    fn within(&self, formula: &Formula, needed: Bond) -> Row {
        let row = self.row(formula);
        if bond(formula) < needed { fenced('(', row, ')') } else { row }
    }
}

/// A function as the language calls it.
pub(crate) fn function_name(name: &str, language: Language) -> &str {
    match (name, language) {
        ("sin", Language::Es) => "sen",
        ("arcsin", Language::Es) => "arcsen",
        ("sinh", Language::Es) => "senh",
        ("min", Language::Es) => "mín",
        ("max", Language::Es) => "máx",
        ("sign", _) => "sgn",
        (name, _) => name,
    }
}

fn element(name: &'static str, children: Row) -> Row {
    vec![Element::new(name, children).into()]
}

fn leaf(name: &'static str, text: impl Into<String>) -> Row {
    vec![Element::text(name, text).into()]
}

fn operator(sign: char) -> Row {
    leaf("mo", sign)
}

fn prefix(sign: char) -> Row {
    vec![Element::text("mo", sign).with("form", "prefix").into()]
}

fn separator() -> Node {
    Element::text("mo", ",").with("separator", "true").into()
}

fn fenced(open: char, inner: Row, close: char) -> Row {
    element("mrow", [operator(open), inner, operator(close)].concat())
}

fn space(width: &'static str) -> Node {
    Element::new("mspace", Row::new()).with("width", width).into()
}

/// Room between a factor and the name of a function, or a unit.
fn thin() -> Node {
    space("0.17em")
}

/// A letter with its index and its primes.
fn symbol(name: &str) -> Row {
    let (letter, index, primes) = letter_of(name);
    let upright = ["π", "i"].contains(&letter);
    let letter = Element::text("mi", letter);
    let letter = vec![if upright { letter.with("mathvariant", "normal") } else { letter }.into()];
    let letter = if index.is_empty() {
        letter
    } else {
        let digits = index.chars().all(|c| c.is_ascii_digit());
        let kind = if digits {
            "mn"
        } else if is_variable(index) {
            "mi"
        } else {
            "mtext"
        };
        element("msub", [letter, leaf(kind, index)].concat())
    };
    // Primes stand beside their letter: as a superscript they vanish in fonts that are not made for mathematics.
    if primes == 0 {
        letter
    } else {
        let primes = Element::text("mo", "′".repeat(primes)).with("lspace", "0").with("rspace", "0").into();
        element("mrow", [letter, vec![primes]].concat())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    fn written(text: &str) -> String {
        let row = Writer { language: Language::Es }.row(&parse(text).expect(text));
        row.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn formulas_are_set_as_in_books() {
        assert_eq!(written("R_b"), "<msub><mi>R</mi><mtext>b</mtext></msub>");
        assert_eq!(written("y''"), "<mrow><mi>y</mi><mo lspace=\"0\" rspace=\"0\">′′</mo></mrow>");
        assert_eq!(written("0.5"), "<mn>0,5</mn>");
        assert_eq!(
            written("sin(2a)"),
            "<mi>sen</mi><mo>\u{2061}</mo><mspace width=\"0.17em\"></mspace><mn>2</mn><mo>\u{2062}</mo><mi>a</mi>"
        );
        assert_eq!(
            written("(a + b)/c"),
            "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mrow><mi>c</mi></mrow></mfrac>"
        );
        assert_eq!(
            written("2(a − b)^2"),
            "<mn>2</mn><mo>\u{2062}</mo><msup><mrow><mrow><mo>(</mo><mi>a</mi><mo>−</mo><mi>b</mi><mo>)</mo></mrow></mrow><mrow><mn>2</mn></mrow></msup>"
        );
    }

    #[test]
    fn what_is_read_as_markup_is_text() {
        assert_eq!(written("a < {<b>}"), "<mi>a</mi><mo>&lt;</mo><mtext>&lt;b&gt;</mtext>");
    }
}
