//! The values of a design file, each with its place, so that what is wrong with one can be pointed at.

use crate::measure::default_of;
use crate::{DataRefusal, DesignError, Kind, Path, Problem};
use levalab_core::Parameter;
use serde_json::{Map, Value};

/// A value with its place.
pub(crate) struct Field<'a> {
    pub path: Path,
    pub value: &'a Value,
}

impl Field<'_> {
    /// A number; −0 becomes 0, so that equal designs are written alike.
    pub fn number(&self) -> Result<f64, DesignError> {
        self.value.as_f64().map(|value| value + 0.0).ok_or_else(|| self.no_number())
    }

    /// Why this is not a number: a text with a decimal comma is named as what it is.
    fn no_number(&self) -> DesignError {
        let comma =
            |text: &&str| text.contains(',') && text.replacen(',', ".", 1).parse::<f64>().is_ok_and(f64::is_finite);
        match self.value.as_str().map(str::trim).filter(comma) {
            Some(found) => DesignError::at(self.path.clone(), Problem::DecimalComma { found: found.to_owned() }),
            None => self.wrong_kind(Kind::Number),
        }
    }

    pub fn text(&self) -> Result<String, DesignError> {
        self.value.as_str().map(str::to_owned).ok_or_else(|| self.wrong_kind(Kind::Text))
    }

    pub fn wrong_kind(&self, expected: Kind) -> DesignError {
        DesignError::at(self.path.clone(), Problem::WrongKind { found: kind_of(self.value), expected })
    }

    /// The items of a list, no more than may be.
    pub fn items(&self, limit: usize) -> Result<impl Iterator<Item = Field<'_>>, DesignError> {
        let Value::Array(items) = self.value else { return Err(self.wrong_kind(Kind::List)) };
        if items.len() > limit {
            let problem = DataRefusal::WrongCount { found: items.len(), min: 1, max: limit };
            return Err(DesignError::at(self.path.clone(), problem));
        }
        Ok(items.iter().enumerate().map(|(k, value)| Field { path: self.path.join(k), value }))
    }

    /// A list of two numbers: where, and how much there.
    pub fn pair(&self) -> Result<[f64; 2], DesignError> {
        let numbers: Vec<f64> = self.items(2)?.map(|number| number.number()).collect::<Result<_, _>>()?;
        let [at, value] = numbers[..] else {
            let problem = DataRefusal::WrongCount { found: numbers.len(), min: 2, max: 2 };
            return Err(DesignError::at(self.path.clone(), problem));
        };
        Ok([at, value])
    }
}

/// The kind of a value.
pub(crate) fn kind_of(value: &Value) -> Kind {
    match value {
        Value::Null => Kind::Null,
        Value::Bool(_) => Kind::Boolean,
        Value::Number(_) => Kind::Number,
        Value::String(_) => Kind::Text,
        Value::Array(_) => Kind::List,
        Value::Object(_) => Kind::Object,
    }
}

/// An object with its place.
pub(crate) struct Object<'a> {
    pub path: Path,
    fields: &'a Map<String, Value>,
}

impl<'a> Object<'a> {
    pub fn any(value: &'a Value, path: Path) -> Result<Self, DesignError> {
        match value {
            Value::Object(fields) => Ok(Self { path, fields }),
            _ => Err(Field { path, value }.wrong_kind(Kind::Object)),
        }
    }

    pub fn has(&self, key: &str) -> bool {
        self.fields.contains_key(key)
    }

    pub fn optional(&self, key: &str) -> Option<Field<'a>> {
        self.fields.get(key).map(|value| Field { path: self.path.join(key), value })
    }

    pub fn required(&self, key: &str) -> Result<Field<'a>, DesignError> {
        self.optional(key).ok_or_else(|| DesignError::at(self.path.join(key), Problem::Missing))
    }

    pub fn object(&self, key: &str) -> Result<Self, DesignError> {
        let field = self.required(key)?;
        Self::any(field.value, field.path)
    }

    /// Which of the choices a field names.
    pub fn word(&self, key: &str, choices: &[&'static str]) -> Result<usize, DesignError> {
        let field = self.required(key)?;
        let found = field.text()?;
        choices.iter().position(|&choice| choice == found).ok_or_else(|| DesignError {
            path: field.path,
            problem: Problem::WrongWord { found, expected: choices.to_vec() },
        })
    }

    /// Refuses fields that have no meaning here.
    pub fn only(&self, known: &[&'static str]) -> Result<(), DesignError> {
        match self.fields.keys().find(|key| !known.contains(&key.as_str())) {
            Some(key) => {
                let problem = Problem::UnknownField { expected: known.to_vec() };
                Err(DesignError::at(self.path.join(key.as_str()), problem))
            }
            None => Ok(()),
        }
    }

    /// The parameters of a law or follower, which with the `shared` fields are all there may be.
    pub fn parameters<const N: usize>(
        &self,
        shared: &[&'static str],
        parameters: &[Parameter],
    ) -> Result<[f64; N], DesignError> {
        let known: Vec<&'static str> = shared.iter().copied().chain(parameters.iter().map(|p| p.key)).collect();
        self.only(&known)?;
        let mut values = [0.0; N];
        for (value, parameter) in values.iter_mut().zip(parameters) {
            *value = match default_of(parameter, 1.0) {
                Some(default) if parameter.optional && !self.fields.contains_key(parameter.key) => default,
                _ => self.required(parameter.key)?.number()?,
            };
        }
        Ok(values)
    }
}
