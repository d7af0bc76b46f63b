//! The names that the page shows, by the keys by which it asks for its words.

use crate::{FOLLOWERS, KINDS, LAWS, Language, law_group};

/// Key and name of everything that the page names in menus and sentences, in one language: `law.cycloidal`, `Cycloidal`.
#[must_use]
pub fn page_names(language: Language) -> Vec<(String, &'static str)> {
    let mut names: Vec<(String, &'static str)> = Vec::new();
    for group in levalab_core::LAWS.iter().map(|law| law_group(law.group)) {
        let entry = (format!("group.{}", group.0), group.1.within(language));
        if !names.contains(&entry) {
            names.push(entry);
        }
    }
    names.extend(LAWS.iter().map(|row| (format!("law.{}", row.id), row.name.menu.within(language))));
    names.extend(KINDS.iter().map(|row| (format!("kind.{}", row.id), row.name.menu.within(language))));
    for row in FOLLOWERS {
        names.push((format!("follower.{}", row.id), row.name.menu.within(language)));
        names.push((format!("follower.noun.{}", row.id), row.name.noun.within(language)));
    }
    names
}
