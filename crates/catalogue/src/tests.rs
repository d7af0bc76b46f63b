//! Claims about every row.

use super::*;

/// Id, name, texts and source of every row of every list.
fn rows() -> Vec<(&'static str, &'static Name, Vec<&'static str>, Option<&'static str>)> {
    let of = |id, name, idea: Two, source| (id, name, vec![idea.en, idea.es], source);
    let laws = LAWS
        .iter()
        .map(|row| (row.id, &row.name, vec![row.idea.en, row.idea.es, row.advice.en, row.advice.es], row.source));
    let followers = FOLLOWERS.iter().map(|row| {
        let texts = [row.idea, row.contact, row.fails].into_iter().flat_map(|text| [text.en, text.es]);
        (row.id, &row.name, texts.collect(), row.source)
    });
    let kinds = KINDS.iter().map(|row| of(row.id, &row.name, row.idea, row.source));
    let applications = APPLICATIONS.iter().map(|row| of(row.id, &row.name, row.idea, row.source));
    let findings = FINDINGS.iter().map(|row| of(row.id, &row.name, row.idea, row.source));
    laws.chain(followers).chain(kinds).chain(applications).chain(findings).collect()
}

#[test]
fn a_name_has_every_form_in_every_language() {
    for (id, name, ..) in rows() {
        for form in [name.noun, name.alone, name.menu] {
            for text in [form.en, form.es] {
                assert!(!text.is_empty() && text.trim() == text && !text.ends_with('.'), "{id}: {text:?}");
            }
        }
        for (alone, menu) in [(name.alone.en, name.menu.en), (name.alone.es, name.menu.es)] {
            assert_eq!(capital(menu), menu, "{id}: a menu begins with a capital");
            // A menu may explain a name in parentheses.
            let words = |text: &str| text.to_lowercase().split([' ', '-']).map(str::to_owned).collect::<Vec<_>>();
            let known = words(alone);
            let name = menu.split(" (").next().unwrap_or_default();
            assert!(words(name).iter().all(|word| known.contains(word)), "{id}: {menu} is another name than {alone}");
        }
        assert!(!name.alone.es.starts_with("de ") && !name.alone.es.starts_with("por "), "{id}");
    }
}

#[test]
fn a_text_is_a_sentence_and_a_source_is_a_title() {
    for (id, _, texts, source) in rows() {
        assert!(source.is_none_or(|source| source.len() > 10 && !source.ends_with('.')), "{id}: {source:?}");
        for text in texts {
            assert!(text.len() > 20 && text.ends_with('.') && !text.contains("  "), "{id}: {text:?}");
        }
    }
}

#[test]
fn two_things_of_a_list_have_two_names() {
    let named = rows();
    for (k, (id, name, ..)) in named.iter().enumerate() {
        for (other, known, ..) in &named[..k] {
            assert!(name.alone.en != known.alone.en && name.alone.es != known.alone.es, "{id} and {other}");
        }
    }
}

#[test]
fn a_code_is_a_capital_with_small_letters_or_one_small_letter() {
    let capitals = LAWS.iter().map(|row| row.link).chain(FOLLOWERS.iter().map(|row| row.link));
    for code in capitals.filter(|code| !code.is_empty()) {
        let (first, others) = code.split_at(1);
        assert!(first.chars().all(|c| c.is_ascii_uppercase()) && others.chars().all(|c| c.is_ascii_lowercase()));
    }
    let letters = APPLICATIONS.iter().map(|row| row.link).chain(KINDS.iter().map(|row| row.link));
    for letter in letters.filter(|letter| !letter.is_empty()) {
        assert!(letter.len() == 1 && letter.chars().all(|c| c.is_ascii_lowercase()), "{letter}");
    }
}

#[test]
fn every_part_of_an_application_has_a_name_and_no_other_has() {
    for application in levalab_core::application::APPLICATIONS {
        let row = APPLICATIONS.iter().find(|row| row.id == application.id).expect(application.id);
        let outputs = application.outputs.iter().map(|output| output.id);
        let settings = application.parameters.iter().map(|setting| setting.key);
        let figures = application.figures.iter().map(|figure| figure.id);
        let parts: Vec<&str> = outputs.chain(settings).chain(figures).collect();
        for id in &parts {
            assert!(row.parts.iter().any(|part| part.0 == *id), "{} of {} has no name", id, row.id);
        }
        for (id, _) in row.parts {
            assert!(parts.contains(id), "{} has no {id}", row.id);
        }
    }
}

#[test]
fn a_part_has_one_name_in_every_application() {
    let parts: Vec<&PartName> = APPLICATIONS.iter().flat_map(|row| row.parts).collect();
    for (id, name) in &parts {
        for (_, other) in parts.iter().filter(|part| part.0 == *id) {
            assert_eq!((name.en, name.es), (other.en, other.es), "{id}");
        }
    }
}

#[test]
fn every_finding_is_in_the_list_by_its_code() {
    use levalab_core::FindingKind as Kind;
    let kinds =
        [0, 1, 2, 3].map(Kind::Jump).into_iter().chain([Kind::NotProved(0), Kind::Undercut, Kind::ContactPastPivot]);
    for kind in kinds {
        let label = finding_label(kind);
        assert_eq!(FINDINGS.iter().filter(|row| row.id == label.id).count(), 1, "{kind:?}");
    }
}
