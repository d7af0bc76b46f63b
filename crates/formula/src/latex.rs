//! A formula as LaTeX, for what goes between `$` and `$`; it needs amsmath.

use crate::mathml::function_name;
use crate::{Bond, Formula, bond, is_bare, is_close, is_variable, letter_of};
use levalab_words::Language;

/// A formula in LaTeX's mathematical mode.
#[must_use]
pub fn latex(formula: &Formula, language: Language) -> String {
    Writer { language }.row(formula)
}

struct Writer {
    language: Language,
}

impl Writer {
    fn row(&self, formula: &Formula) -> String {
        match formula {
            Formula::Number(digits) => self.number(digits),
            Formula::Symbol(name) => symbol(name),
            Formula::Text(text) => words(text),
            Formula::Negative(inner) => format!("-{}", self.within(inner, Bond::Product)),
            Formula::Sum(terms) => self.sum(terms),
            Formula::Product(factors) => self.product(factors),
            Formula::Times(sign, a, b) => {
                joined(&[&self.within(a, Bond::Product), operator(*sign), &self.within(b, Bond::Product)])
            }
            Formula::Fraction(above, below) => format!("\\frac{{{}}}{{{}}}", self.row(above), self.row(below)),
            Formula::Power(base, raised) => self.power(base, raised),
            Formula::Call("sqrt", inner) => format!("\\sqrt{{{}}}", self.row(inner)),
            Formula::Call("exp", inner) => format!("\\mathrm{{e}}^{{{}}}", self.row(inner)),
            Formula::Call(name, inner) => joined(&[&self.function(name), &self.argument(inner)]),
            Formula::Apply(function, inner) => format!("{}({})", self.row(function), self.row(inner)),
            Formula::Size(inner) => format!("\\left|{}\\right|", self.row(inner)),
            Formula::Bracket(inner) => format!("\\left[{}\\right]", self.row(inner)),
            Formula::Relation(first, rest) => rest
                .iter()
                .fold(self.row(first), |before, (sign, side)| joined(&[&before, operator(*sign), &self.row(side)])),
            Formula::List(items) => items.iter().map(|item| self.row(item)).collect::<Vec<_>>().join(",\\quad "),
            Formula::Matrix(rows) => self.matrix(rows),
            Formula::Lines(first, lines) => self.lines(first, lines),
        }
    }

    fn number(&self, digits: &str) -> String {
        match (digits, self.language) {
            ("∞", _) => "\\infty".to_owned(),
            ("…", _) => "\\ldots".to_owned(),
            // Braces keep the comma from being set as the one between the items of a list.
            (digits, Language::Es) => digits.replace('.', "{,}"),
            (digits, _) => digits.to_owned(),
        }
    }

    fn matrix(&self, rows: &[Vec<Formula>]) -> String {
        // An array, since the columns of `pmatrix` are counted and centred.
        let columns = "r".repeat(rows.iter().map(Vec::len).max().unwrap_or(1));
        let row = |row: &Vec<Formula>| row.iter().map(|entry| self.row(entry)).collect::<Vec<_>>().join(" & ");
        let rows = rows.iter().map(row).collect::<Vec<_>>().join(" \\\\ ");
        format!("\\left(\\begin{{array}}{{{columns}}} {rows} \\end{{array}}\\right)")
    }

    fn lines(&self, first: &Formula, lines: &[(char, Formula)]) -> String {
        let mut left = self.row(first);
        let line = |(sign, line): &(char, Formula)| {
            let goes_on = if ['+', '−'].contains(sign) { "\\quad " } else { "" };
            let left = std::mem::take(&mut left);
            format!("{left} & {goes_on}{}", joined(&[operator(*sign), &self.row(line)]))
        };
        let lines = lines.iter().map(line).collect::<Vec<_>>().join(" \\\\ ");
        format!("\\begin{{aligned}} {lines} \\end{{aligned}}")
    }

    fn sum(&self, terms: &[(char, Formula)]) -> String {
        let mut text = String::new();
        for (i, (sign, term)) in terms.iter().enumerate() {
            let term = self.within(term, Bond::Product);
            text = match (i, sign) {
                (0, '+') => term,
                (0, '−') => format!("-{term}"),
                (_, sign) => joined(&[&text, operator(*sign), &term]),
            };
        }
        text
    }

    fn product(&self, factors: &[Formula]) -> String {
        let mut text = String::new();
        for (i, factor) in factors.iter().enumerate() {
            let written = self.within(factor, Bond::Product);
            text = match factor {
                _ if i == 0 => written,
                Formula::Text(unit) if is_close(unit) => text + &written,
                Formula::Text(_) => text + "\\," + &written,
                _ => joined(&[&text, &written]),
            };
        }
        text
    }

    fn power(&self, base: &Formula, raised: &Formula) -> String {
        let raised = self.row(raised);
        if let Formula::Call(name, inner) = base
            && !["sqrt", "exp"].contains(name)
        {
            return joined(&[&format!("{}^{{{raised}}}", self.function(name)), &self.argument(inner)]);
        }
        let base = match base {
            Formula::Fraction(..) | Formula::Power(..) => format!("\\left({}\\right)", self.row(base)),
            Formula::Symbol(name) if name.ends_with('\'') => format!("{{{}}}", self.row(base)),
            _ => self.within(base, Bond::Atom),
        };
        format!("{base}^{{{raised}}}")
    }

    fn function(&self, name: &str) -> String {
        match function_name(name, self.language) {
            known @ ("sin" | "cos" | "tan" | "arctan" | "arcsin" | "arccos" | "arg" | "min" | "max" | "sinh"
            | "cosh" | "tanh" | "ln") => format!("\\{known}"),
            other => format!("\\operatorname{{{}}}", other.replace('í', "\\acute{\\imath}").replace('á', "\\acute{a}")),
        }
    }

    fn argument(&self, inner: &Formula) -> String {
        let row = self.row(inner);
        if is_bare(inner) { row } else { format!("\\left({row}\\right)") }
    }

    fn within(&self, formula: &Formula, needed: Bond) -> String {
        let row = self.row(formula);
        if bond(formula) < needed { format!("\\left({row}\\right)") } else { row }
    }
}

/// Side by side, with a space where a command would run into a letter; it is not seen.
fn joined(parts: &[&str]) -> String {
    parts.iter().filter(|part| !part.is_empty()).copied().collect::<Vec<_>>().join(" ")
}

fn operator(sign: char) -> &'static str {
    match sign {
        '+' => "+",
        '−' => "-",
        '±' => "\\pm",
        '·' => "\\cdot",
        '×' => "\\times",
        '≤' => "\\le",
        '≥' => "\\ge",
        '<' => "<",
        '>' => ">",
        '≈' => "\\approx",
        '≠' => "\\ne",
        '→' => "\\to",
        '⇒' => "\\Rightarrow",
        _ => "=",
    }
}

fn symbol(name: &str) -> String {
    let (letter, index, primes) = letter_of(name);
    let mut text = match dotted(letter) {
        Some((letter, dots)) => format!("\\{dots}{{{letter}}}"),
        None => greek(letter).map_or_else(|| letter.to_owned(), |name| format!("\\{name}")),
    };
    if !index.is_empty() {
        text += &if is_variable(index) { format!("_{{{index}}}") } else { format!("_{{{}}}", words(index)) };
    }
    text + &"'".repeat(primes)
}

/// A letter under one, two or three dots, as some books write derivatives by time, and the command for the dots.
fn dotted(letter: &str) -> Option<(&str, &'static str)> {
    match letter {
        "ẏ" => return Some(("y", "dot")),
        "ÿ" => return Some(("y", "ddot")),
        "ḋ" => return Some(("d", "dot")),
        "ṡ" => return Some(("s", "dot")),
        "Ṡ" => return Some(("S", "dot")),
        _ => {}
    }
    let marks = [('\u{307}', "dot"), ('\u{308}', "ddot"), ('\u{20db}', "dddot")];
    marks.into_iter().find_map(|(mark, dots)| Some((letter.strip_suffix(mark)?, dots)))
}

/// The command of a letter that has one.
fn greek(letter: &str) -> Option<&'static str> {
    const LETTERS: [(&str, &str); 21] = [
        ("α", "alpha"),
        ("β", "beta"),
        ("γ", "gamma"),
        ("δ", "delta"),
        ("ε", "varepsilon"),
        ("η", "eta"),
        ("θ", "theta"),
        ("κ", "kappa"),
        ("λ", "lambda"),
        ("μ", "mu"),
        ("ξ", "xi"),
        ("π", "pi"),
        ("ρ", "rho"),
        ("σ", "sigma"),
        ("τ", "tau"),
        ("φ", "varphi"),
        ("ψ", "psi"),
        ("ω", "omega"),
        ("Γ", "Gamma"),
        ("Δ", "Delta"),
        ("Φ", "Phi"),
    ];
    LETTERS.iter().find(|(known, _)| *known == letter).map(|(_, name)| *name)
}

/// Words or a unit: upright. No dollar is within, so that it can stand between two of them.
fn words(text: &str) -> String {
    if text == "°" {
        return "^\\circ".to_owned();
    }
    format!(
        "\\mathrm{{{}}}",
        spelled(
            text,
            &|c| match c {
                ' ' => "\\ ".to_owned(),
                other => plain(other).trim_matches('$').to_owned(),
            },
            &str::to_owned
        )
    )
}

/// Running text, in which nothing means anything to LaTeX.
#[must_use]
pub fn latex_text(text: &str) -> String {
    spelled(text, &plain, &|formula| format!("${formula}$"))
}

/// A text character by character, but for what several make together: raised and lowered figures, and letters under marks.
fn spelled(text: &str, character: &dyn Fn(char) -> String, formula: &dyn Fn(&str) -> String) -> String {
    let mut written = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (length, latex) = match script(rest).or_else(|| marked(rest)) {
            Some((length, latex)) => (length, formula(&latex)),
            None => (first.len_utf8(), character(first)),
        };
        written += &latex;
        rest = &rest[length..];
    }
    written
}

/// The raised or lowered figures that a text begins with: how long they are, and what they are in LaTeX.
fn script(text: &str) -> Option<(usize, String)> {
    [('^', "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"), ('_', "₀₁₂₃₄₅₆₇₈₉")].into_iter().find_map(|(command, figures)| {
        let plain = |c| "0123456789-".chars().nth(figures.chars().position(|figure| figure == c)?);
        let found: String = text.chars().map_while(plain).collect();
        let length = text.chars().take(found.len()).map(char::len_utf8).sum();
        let group = if found.len() > 1 { format!("{{{found}}}") } else { found };
        (!group.is_empty()).then(|| (length, format!("{command}{group}")))
    })
}

/// The letter under dots that a text begins with.
fn marked(text: &str) -> Option<(usize, String)> {
    let first = text.chars().next()?.len_utf8();
    let with_mark = first + text[first..].chars().next().map_or(0, char::len_utf8);
    // A ÿ by itself is a letter of names too.
    [with_mark, first].into_iter().filter(|&length| &text[..length] != "ÿ").find_map(|length| {
        let (letter, dots) = dotted(&text[..length])?;
        Some((length, format!("\\{dots}{{{letter}}}")))
    })
}

/// A character of running text; letters and signs that its usual fonts lack are set as mathematics.
fn plain(c: char) -> String {
    if let Some(name) = greek(&c.to_string()) {
        return format!("$\\{name}$");
    }
    match c {
        '−' => "$-$".to_owned(),
        '≤' | '≥' | '≠' | '≈' | '·' | '×' | '→' | '⇒' => format!("${}$", operator(c)),
        '∞' => "$\\infty$".to_owned(),
        '°' => "$^\\circ$".to_owned(),
        '\u{a0}' => "~".to_owned(),
        '\u{202f}' => "\\,".to_owned(),
        '#' | '$' | '%' | '&' | '_' | '{' | '}' => format!("\\{c}"),
        '\\' => "\\textbackslash{}".to_owned(),
        '~' => "\\textasciitilde{}".to_owned(),
        '^' => "\\textasciicircum{}".to_owned(),
        other if is_settable(other) => other.to_string(),
        other => format!("\\texttt{{U+{:04X}}}", u32::from(other)),
    }
}

/// The characters of running text that LaTeX's usual fonts lack, each once: [`latex_text`] writes their numbers in Unicode instead.
#[must_use]
pub fn latex_lacks(text: &str) -> Vec<char> {
    let mut lacking = Vec::new();
    for c in text.chars() {
        let number = format!("\\texttt{{U+{:04X}}}", u32::from(c));
        if latex_text(&c.to_string()) == number && !lacking.contains(&c) {
            lacking.push(c);
        }
    }
    lacking
}

/// True for a letter or sign that LaTeX sets in running text with the encodings T1 and UTF-8 and the package textcomp: Latin letters of
/// Europe (the table t1enc.dfu) and the signs of usual texts (ts1enc.dfu).
fn is_settable(c: char) -> bool {
    matches!(c,
        ' '..='~' | '\u{a1}'..='\u{ff}' | 'Ă'..='ć' | 'Č'..='đ' | 'Ę'..='ě' | 'Ğ' | 'ğ' | 'İ' | 'ı' | 'Ĺ' | 'ĺ' | 'Ľ' | 'ľ' | 'Ł'..='ń'
        | 'Ň' | 'ň' | 'Ŋ' | 'ŋ' | 'Ő'..='ŕ' | 'Ř'..='ś' | 'Ş'..='ť' | 'Ů'..='ű' | 'Ÿ'..='ž' | '–' | '—' | '‘' | '’' | '‚' | '“' | '”' | '„'
        | '†' | '‡' | '•' | '…' | '‰' | '‹' | '›' | '€' | '№' | '™')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    fn written(text: &str, language: Language) -> String {
        latex(&parse(text).expect(text), language)
    }

    #[test]
    fn formulas_are_written_as_an_author_would() {
        for (text, expected) in [
            ("tan(φ) = (v - σe)/(s_0 + s)", "\\tan \\varphi = \\frac{v - \\sigma e}{s_{0} + s}"),
            ("R_p = R_b + R_f", "R_{\\mathrm{p}} = R_{\\mathrm{b}} + R_{\\mathrm{f}}"),
            ("sin(2πx + 1)", "\\sin \\left(2 \\pi x + 1\\right)"),
            ("1.5 {mm/s²}", "1.5\\,\\mathrm{mm/s^2}"),
            ("30{°}", "30^\\circ"),
            ("[a + b]^(3/2)", "\\left[a + b\\right]^{\\frac{3}{2}}"),
            ("y'^2", "{y'}^{2}"),
        ] {
            assert_eq!(written(text, Language::En), expected);
        }
        assert_eq!(written("sin(x) = 0.5", Language::Es), "\\operatorname{sen} x = 0{,}5");
        assert_eq!(written("min(a)", Language::Es), "\\operatorname{m\\acute{\\imath}n} a");
    }

    #[test]
    fn running_text_has_only_what_every_latex_sets() {
        for (text, expected) in [
            ("−4.7·10⁻⁵ mm at φ = 2°", "$-$4.7$\\cdot$10$^{-5}$ mm at $\\varphi$ = 2$^\\circ$"),
            ("mm/rad²", "mm/rad$^2$"),
            ("from Ṡ to d̈ and y⃛", "from $\\dot{S}$ to $\\ddot{d}$ and $\\dddot{y}$"),
            ("ξ₀ & 50 %", "$\\xi$$_0$ \\& 50 \\%"),
        ] {
            assert_eq!(latex_text(text), expected);
        }
    }

    #[test]
    fn letters_that_no_font_of_latex_has_are_numbers() {
        assert_eq!(latex_text("日 ñ 🎡"), "\\texttt{U+65E5} ñ \\texttt{U+1F3A1}");
        assert_eq!(latex_lacks("日 ñ φ² 日🎡 – ż \u{301}"), ['日', '🎡', '\u{301}']);
        assert_eq!(latex_lacks("Leva de ±3 µm, «½» & 50 % → ∞"), []);
    }

    #[test]
    fn dots_are_commands() {
        for (name, expected) in [("ẏ", "\\dot{y}"), ("Ṡ", "\\dot{S}"), ("d̈", "\\ddot{d}"), ("y⃛", "\\dddot{y}")]
        {
            assert_eq!(latex(&Formula::Symbol(name.into()), Language::En), expected);
        }
    }

    #[test]
    fn matrices_and_lines_have_their_columns() {
        let number = |digits: &str| Formula::Number(digits.into());
        let matrix = Formula::Matrix(vec![vec![number("1"), number("2")], vec![number("3"), number("4")]]);
        assert_eq!(latex(&matrix, Language::En), "\\left(\\begin{array}{rr} 1 & 2 \\\\ 3 & 4 \\end{array}\\right)");
        let lines = Formula::Lines(Box::new(number("1")), vec![('=', number("2")), ('−', number("3"))]);
        assert_eq!(latex(&lines, Language::En), "\\begin{aligned} 1 & = 2 \\\\  & \\quad - 3 \\end{aligned}");
    }
}
