//! Units as products of powers: `mm`, `rad/s`, `°/rad²`, `lbf/in`, `MPa/mm³`.

/// What a unit measures, as powers of length, angle, time and force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Dimension([i8; 4]);

/// A unit: what it measures, and how many of the unit of reference it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unit {
    pub dimension: Dimension,
    pub factor: f64,
}

const LENGTH: Dimension = Dimension([1, 0, 0, 0]);
const ANGLE: Dimension = Dimension([0, 1, 0, 0]);
const TIME: Dimension = Dimension([0, 0, 1, 0]);
const FORCE: Dimension = Dimension([0, 0, 0, 1]);
const SPEED: Dimension = Dimension([0, 1, -1, 0]);
const PRESSURE: Dimension = Dimension([-2, 0, 0, 1]);

const TURN: f64 = std::f64::consts::TAU;
const DEGREE: f64 = TURN / 360.0;

/// Symbols in the languages of the page, with what one of each is in millimetres, radians, seconds and newtons. 1 lbf = 4.4482216152605 N and
/// 1 in = 25.4 mm exactly (NIST SP 811, appendix B).
const SYMBOLS: [(&str, Dimension, f64); 48] = [
    ("mm", LENGTH, 1.0),
    ("cm", LENGTH, 10.0),
    ("dm", LENGTH, 100.0),
    ("m", LENGTH, 1000.0),
    ("µm", LENGTH, 0.001),
    ("μm", LENGTH, 0.001),
    ("in", LENGTH, 25.4),
    ("inch", LENGTH, 25.4),
    ("inches", LENGTH, 25.4),
    ("\"", LENGTH, 25.4),
    ("″", LENGTH, 25.4),
    ("pulg", LENGTH, 25.4),
    ("ft", LENGTH, 304.8),
    ("°", ANGLE, DEGREE),
    ("º", ANGLE, DEGREE),
    ("deg", ANGLE, DEGREE),
    ("grados", ANGLE, DEGREE),
    ("degrees", ANGLE, DEGREE),
    ("rad", ANGLE, 1.0),
    ("rev", ANGLE, TURN),
    ("turn", ANGLE, TURN),
    ("turns", ANGLE, TURN),
    ("vuelta", ANGLE, TURN),
    ("vueltas", ANGLE, TURN),
    ("r", ANGLE, TURN),
    ("s", TIME, 1.0),
    ("ms", TIME, 0.001),
    ("min", TIME, 60.0),
    ("h", TIME, 3600.0),
    ("rpm", SPEED, TURN / 60.0),
    ("RPM", SPEED, TURN / 60.0),
    ("r.p.m.", SPEED, TURN / 60.0),
    ("rps", SPEED, TURN),
    ("min⁻¹", SPEED, TURN / 60.0),
    ("N", FORCE, 1.0),
    ("kN", FORCE, 1000.0),
    ("lbf", FORCE, 4.448_221_615_260_5),
    ("lb", FORCE, 4.448_221_615_260_5),
    ("kgf", FORCE, 9.806_65),
    ("kp", FORCE, 9.806_65),
    ("Pa", PRESSURE, 1e-6),
    ("kPa", PRESSURE, 1e-3),
    ("MPa", PRESSURE, 1.0),
    ("GPa", PRESSURE, 1e3),
    ("bar", PRESSURE, 0.1),
    ("psi", PRESSURE, 4.448_221_615_260_5 / (25.4 * 25.4)),
    ("ksi", PRESSURE, 4_448.221_615_260_5 / (25.4 * 25.4)),
    ("1", Dimension([0; 4]), 1.0),
];

/// Maximum power in a unit.
const MAX_POWER: i8 = 9;

impl Unit {
    /// The unit of a plain number.
    const NONE: Self = Self { dimension: Dimension([0; 4]), factor: 1.0 };

    /// Reads a unit; `None` if a symbol is not known.
    pub fn read(text: &str) -> Option<Self> {
        let text = text.trim();
        if text.is_empty() {
            return Some(Self::NONE);
        }
        let mut unit = Self::NONE;
        let mut sign = 1;
        let mut rest = text;
        loop {
            let end = rest.find(['/', '·', '*', '⋅']).unwrap_or(rest.len());
            unit = unit.times(Self::factor_of(rest[..end].trim())?, sign)?;
            let Some(separator) = rest[end..].chars().next() else { return Some(unit) };
            // As in mm/rad·s, which is read from the left.
            sign = if separator == '/' { -1 } else { 1 };
            rest = &rest[end + separator.len_utf8()..];
        }
    }

    /// A symbol with its power: `mm`, `rad²`, `mm^2`, `s2`.
    fn factor_of(text: &str) -> Option<Self> {
        if let Some(unit) = Self::symbol(text) {
            return Some(unit);
        }
        let bare = text.trim_end_matches(|c: char| c.is_ascii_digit() || "²³⁴⁵⁶⁷⁸⁹^".contains(c));
        let power = match &text[bare.len()..] {
            "²" => 2,
            "³" => 3,
            "⁴" => 4,
            "⁵" => 5,
            "⁶" => 6,
            plain => {
                plain.trim_start_matches('^').parse::<i8>().ok().filter(|power| (2..=MAX_POWER).contains(power))?
            }
        };
        Self::NONE.times(Self::symbol(bare)?, power)
    }

    fn symbol(text: &str) -> Option<Self> {
        let found = SYMBOLS.iter().find(|(symbol, ..)| *symbol == text)?;
        Some(Self { dimension: found.1, factor: found.2 })
    }

    /// This unit times a power of another.
    fn times(self, other: Self, power: i8) -> Option<Self> {
        let mut dimension = self.dimension;
        for (own, theirs) in dimension.0.iter_mut().zip(other.dimension.0) {
            *own = own.checked_add(theirs.checked_mul(power)?)?;
        }
        Some(Self { dimension, factor: self.factor * other.factor.powi(i32::from(power)) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_that_a_field_may_have_is_known() {
        let units = [
            "mm", "cm", "m", "in", "°", "rad", "rpm", "rad/s", "rev/s", "mm/s", "in/s", "mm/rad", "mm/rad²", "mm/rad³",
            "°/rad", "°/s²", "1/mm", "1/mm²", "N", "lbf", "N/mm", "lbf/in", "MPa", "N/cm²", "Pa", "psi", "mm²",
            "mm³/s", "MPa/mm³", "N/cm⁵", "psi/in³", "s", "",
        ];
        for unit in units {
            assert!(Unit::read(unit).is_some(), "{unit}");
        }
        for nonsense in ["furlong", "mm/", "/s", "mm²²", "mm^99", "°C", "mm mm"] {
            assert_eq!(Unit::read(nonsense), None, "{nonsense}");
        }
    }

    #[test]
    fn factors_are_those_of_the_books() {
        let ratio = |one: &str, other: &str| {
            let (one, other) = (Unit::read(one).expect(one), Unit::read(other).expect(other));
            assert_eq!(one.dimension, other.dimension);
            one.factor / other.factor
        };
        assert!((ratio("psi", "Pa") - 6_894.757_293_168).abs() < 1e-6);
        assert!((ratio("rpm", "rad/s") - 0.104_719_755_119_66).abs() < 1e-14);
        assert!((ratio("N/cm²", "MPa") - 0.01).abs() < 1e-15);
        assert!((ratio("in³", "mm³") - 16_387.064).abs() < 1e-9);
    }
}
