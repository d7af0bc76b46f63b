//! A formula that stays the same motion when its lengths are in another unit.

use super::Change;
use crate::LengthUnit;
use levalab_core::Expression;

impl Change {
    /// The formula in the other unit: as it is when it is a length whatever the unit, as s₀ + L·sin(πx/2) is; else written around the
    /// old one, which stays to be read: `(5 + (25.4L))/25.4`. One that was written around comes back as it was.
    pub(super) fn formula(&self, text: &str) -> String {
        let found = Expression::parse(text);
        if found.is_ok_and(|expression| expression.degree(self.travels) == Some(1)) {
            return text.to_owned();
        }
        let (inner, home) = self.unwrapped(text).unwrap_or_else(|| (text.to_owned(), self.from));
        self.wrapped(&inner, home, self.to).unwrap_or_else(|| text.to_owned())
    }

    /// A formula written in the unit `home`, for numbers in another.
    fn wrapped(&self, text: &str, home: LengthUnit, unit: LengthUnit) -> Option<String> {
        if home == unit {
            return Some(text.to_owned());
        }
        let (factor, larger) = factor(home, unit);
        let named = Expression::lengths(text, self.travels).ok()?;
        let letters: Vec<char> = text.chars().collect();
        let (mut inner, mut from) = (String::new(), 0);
        for place in named {
            inner.extend(&letters[from..place.start]);
            let name: String = letters[place.clone()].iter().collect();
            inner += &if larger { format!("({factor}{name})") } else { format!("({name}/{factor})") };
            from = place.end;
        }
        inner.extend(&letters[from..]);
        Some(if larger { format!("({inner})/{factor}") } else { format!("{factor}({inner})") })
    }

    /// What a formula was before it was written around, and the unit it was in.
    fn unwrapped(&self, text: &str) -> Option<(String, LengthUnit)> {
        LengthUnit::ALL.into_iter().filter(|&home| home != self.from).find_map(|home| {
            let (factor, larger) = factor(home, self.from);
            let (before, after) =
                if larger { ("(".to_owned(), format!(")/{factor}")) } else { (format!("{factor}("), ")".to_owned()) };
            let inner = text.strip_prefix(&before)?.strip_suffix(&after)?;
            let names = ["L", "s₀", "s0", "θ", "theta", "β", "beta"];
            let plain = names.into_iter().fold(inner.to_owned(), |inner, name| {
                inner.replace(&if larger { format!("({factor}{name})") } else { format!("({name}/{factor})") }, name)
            });
            (self.wrapped(&plain, home, self.from)? == text).then_some((plain, home))
        })
    }
}

/// How many of a unit a number in another is to be multiplied by (true) or divided by (false) to give, as a decimal that ends: an inch has
/// 25.4 mm, and a millimetre no such number of inches.
fn factor(home: LengthUnit, unit: LengthUnit) -> (&'static str, bool) {
    use LengthUnit::{Centimetre, Inch, Metre, Millimetre};
    match (home, unit) {
        (Millimetre, Inch) => ("25.4", true),
        (Inch, Millimetre) => ("25.4", false),
        (Centimetre, Inch) => ("2.54", true),
        (Inch, Centimetre) => ("2.54", false),
        (Metre, Inch) => ("0.0254", true),
        (Inch, Metre) => ("0.0254", false),
        (Millimetre, Centimetre) => ("10", true),
        (Centimetre, Millimetre) => ("10", false),
        (Centimetre, Metre) => ("100", true),
        (Metre, Centimetre) => ("100", false),
        (Millimetre, Metre) => ("1000", true),
        (Metre, Millimetre) => ("1000", false),
        _ => ("1", true),
    }
}
