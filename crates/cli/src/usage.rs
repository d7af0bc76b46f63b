//! What is wrong with a command line, in one sentence of the language that it asks for.

use clap::Error;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use levalab_words::Language;
use std::ffi::OsString;

/// The language that a command line asks for, before it is known to make sense; English when it asks for none that there is.
pub fn language_of(arguments: impl Iterator<Item = OsString>) -> Language {
    let mut found = None;
    let mut follows = false;
    for argument in arguments {
        let text = argument.to_string_lossy();
        if text == "--" {
            break;
        }
        if follows {
            found = Language::from_tag(&text);
        } else if let Some(tag) = text.strip_prefix("--lang=") {
            found = Language::from_tag(tag);
        }
        follows = text == "--lang";
    }
    found.unwrap_or_default()
}

/// The sentence for a refusal.
pub fn sentence(refusal: &Error, language: Language) -> String {
    let argument = name(&one(refusal, ContextKind::InvalidArg));
    let value = one(refusal, ContextKind::InvalidValue);
    match refusal.kind() {
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand | ErrorKind::MissingSubcommand => {
            two(language, "no command; try 'levalab --help'", "falta la orden; pruebe 'levalab --help'").to_owned()
        }
        ErrorKind::InvalidSubcommand => {
            let command = one(refusal, ContextKind::InvalidSubcommand);
            match language {
                Language::En => format!("There is no command '{command}'; try 'levalab --help'."),
                Language::Es => format!("No existe la orden '{command}'; pruebe 'levalab --help'."),
            }
        }
        ErrorKind::UnknownArgument => unknown(refusal, &argument, language),
        ErrorKind::MissingRequiredArgument => {
            let missing: Vec<String> = all(refusal, ContextKind::InvalidArg).iter().map(|text| name(text)).collect();
            match language {
                Language::En => format!("Missing: {}.", missing.join(", ")),
                Language::Es => format!("Falta: {}.", missing.join(", ")),
            }
        }
        ErrorKind::ArgumentConflict => {
            let other = all(refusal, ContextKind::PriorArg).first().map(|text| name(text)).unwrap_or_default();
            match language {
                Language::En if other == argument => format!("{argument} can be given only once."),
                Language::Es if other == argument => format!("{argument} solo se puede dar una vez."),
                Language::En => format!("{argument} and {other} cannot be given together."),
                Language::Es => format!("{argument} y {other} no se pueden dar a la vez."),
            }
        }
        ErrorKind::InvalidValue | ErrorKind::ValueValidation if !argument.is_empty() => {
            wrong_value(refusal, &argument, &value, language)
        }
        ErrorKind::TooManyValues | ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues | ErrorKind::NoEquals => {
            match language {
                Language::En => format!("{argument} has another number of values."),
                Language::Es => format!("{argument} lleva otro número de valores."),
            }
        }
        ErrorKind::InvalidUtf8 => {
            two(language, "An argument is not text in UTF-8.", "Un argumento no es texto en UTF-8.").to_owned()
        }
        _ => {
            let help = "The command line makes no sense; try 'levalab --help'.";
            two(language, help, "La línea de órdenes no tiene sentido; pruebe 'levalab --help'.").to_owned()
        }
    }
}

fn unknown(refusal: &Error, argument: &str, language: Language) -> String {
    let near = one(refusal, ContextKind::SuggestedArg);
    match (language, near.is_empty()) {
        (Language::En, true) => format!("'{argument}' has no meaning here."),
        (Language::En, false) => format!("'{argument}' has no meaning here; did you mean {near}?"),
        (Language::Es, true) => format!("'{argument}' no tiene sentido aquí."),
        (Language::Es, false) => format!("'{argument}' no tiene sentido aquí; ¿quería decir {near}?"),
    }
}

/// A value that an option does not take, and which it takes.
fn wrong_value(refusal: &Error, argument: &str, value: &str, language: Language) -> String {
    if value.is_empty() {
        return match language {
            Language::En => format!("{argument} needs a value."),
            Language::Es => format!("{argument} necesita un valor."),
        };
    }
    let choices = all(refusal, ContextKind::ValidValue);
    let expected = match expected(argument) {
        Some((en, es)) => two(language, en, es).to_owned(),
        None if choices.is_empty() => two(language, "a number", "un número").to_owned(),
        None => match language {
            Language::En => format!("one of {}", choices.join(", ")),
            Language::Es => format!("uno de {}", choices.join(", ")),
        },
    };
    let value = levalab_format::quoted(value);
    match language {
        Language::En => format!("{argument}: It must be {expected}, and it is {value}."),
        Language::Es => format!("{argument}: Tiene que ser {expected}, y es {value}."),
    }
}

/// Values that a parser of ours takes, of which clap knows no list.
fn expected(argument: &str) -> Option<(&'static str, &'static str)> {
    Some(match argument {
        "--samples" => ("a whole number from 1 to 100\u{202f}000", "un número entero de 1 a 100\u{202f}000"),
        "--width" => ("a whole number from 1 to 10\u{202f}000", "un número entero de 1 a 10\u{202f}000"),
        "--segment" => ("the number of a segment", "el número de un tramo"),
        "--keyway" => ("width x depth, such as 8x3.3", "ancho x profundidad, como 8x3.3"),
        "--unit" => ("one of mm, cm, m, in", "uno de mm, cm, m, in"),
        "--speed" => ("one of rpm, rad/s, rev/s", "uno de rpm, rad/s, rev/s"),
        "--notation" => (
            "one of levalab, norton, shigley, rothbart, cardona-clos, capitals",
            "uno de levalab, norton, shigley, rothbart, cardona-clos, capitals",
        ),
        _ => return None,
    })
}

fn two<'a>(language: Language, en: &'a str, es: &'a str) -> &'a str {
    match language {
        Language::En => en,
        Language::Es => es,
    }
}

/// An option by its name alone: `--bore` for clap's `--bore <BORE>`.
fn name(argument: &str) -> String {
    if argument.starts_with('-') {
        argument.split(' ').next().unwrap_or_default().to_owned()
    } else {
        argument.to_owned()
    }
}

fn one(refusal: &Error, kind: ContextKind) -> String {
    all(refusal, kind).into_iter().next().unwrap_or_default()
}

fn all(refusal: &Error, kind: ContextKind) -> Vec<String> {
    match refusal.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    }
}
