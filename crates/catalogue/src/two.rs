//! Names and short texts in both languages, side by side, so that neither can lack what the other says.

use crate::Language;

/// The same in English and in Spanish.
#[derive(Clone, Copy, Debug)]
pub struct Two {
    /// English.
    pub en: &'static str,
    /// Spanish.
    pub es: &'static str,
}

/// Both, English first.
#[must_use]
pub const fn two(en: &'static str, es: &'static str) -> Two {
    Two { en, es }
}

impl Two {
    /// In one of them.
    #[must_use]
    pub fn within(self, language: Language) -> &'static str {
        match language {
            Language::En => self.en,
            Language::Es => self.es,
        }
    }
}

/// A name with a capital, as at the head of a line.
#[must_use]
pub fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
