//! The words of the pages, side by side in both languages, so that neither can lack what the other says.

pub mod concepts;
pub mod manual;
pub mod terms;

pub use levalab_words::Two;
pub(crate) use levalab_words::two;

#[cfg(test)]
mod tests {
    use super::{concepts, manual, terms};
    use levalab_catalogue::law_row;
    use levalab_core::law::Shape;
    use levalab_core::{FOLLOWERS, LAWS};
    use levalab_formula::parse;
    use std::collections::BTreeSet;

    #[test]
    fn every_law_has_a_formula() {
        for law in LAWS {
            let row = law_row(law).expect(law.id);
            let fixed = matches!(law.shape, Shape::Unit(_)) && law.parameters.is_empty();
            let printed = fixed
                && law
                    .unit(crate::law_facts::rising(law))
                    .is_ok_and(|pieces| levalab_formula::curve::written(&pieces).is_some());
            assert!(printed || !row.formulas.is_empty(), "{} has no formula", law.id);
        }
    }

    #[test]
    fn every_parameter_is_a_term() {
        let of_laws = LAWS.iter().flat_map(|law| law.parameters);
        for parameter in FOLLOWERS.iter().flat_map(|kind| kind.parameters).chain(of_laws) {
            assert!(terms::term(parameter.key).is_some(), "{} is not explained", parameter.key);
        }
    }

    #[test]
    fn every_formula_can_be_read() {
        let texts = levalab_catalogue::LAWS.iter().flat_map(|row| [row.idea, row.advice]);
        let concepts = [concepts::MOTION, concepts::GEOMETRY, concepts::KINDS];
        let texts = texts.chain(concepts.into_iter().flatten().map(|concept| concept.text));
        let terms = terms::GROUPS.iter().flat_map(|group| group.terms);
        let texts = texts.chain(terms.clone().map(|term| term.text));
        for text in texts.chain(manual::SCREENS.iter().map(|screen| screen.text)).flat_map(|text| [text.en, text.es]) {
            for formula in text.split('$').skip(1).step_by(2).filter(|formula| !formula.is_empty()) {
                assert!(parse(formula).is_ok(), "{formula}");
            }
        }
        let symbols = terms.clone().map(|term| term.symbol).filter(|symbol| !symbol.is_empty());
        let of_laws = levalab_catalogue::LAWS.iter().flat_map(|row| row.formulas).copied();
        for formula in terms.filter_map(|term| term.formula).chain(symbols).chain(of_laws) {
            assert!(parse(formula).is_ok(), "{formula}");
        }
    }

    #[test]
    fn places_are_unique() {
        let places = terms::GROUPS.iter().flat_map(|group| group.terms).map(|term| term.id);
        let unique: BTreeSet<_> = places.clone().collect();
        assert_eq!(unique.len(), places.count());
    }

    #[test]
    fn both_languages_have_the_same_formulas_and_labels() {
        let marks = |text: &str, open: char, close: char| {
            let mut found: Vec<String> = text
                .split(open)
                .skip(1)
                .filter_map(|rest| rest.split_once(close))
                .map(|(inner, _)| inner.to_owned())
                .collect();
            found.sort();
            found
        };
        for screen in manual::SCREENS {
            assert_eq!(marks(screen.text.en, '{', '}'), marks(screen.text.es, '{', '}'), "{}", screen.id);
        }
    }

    /// Keys of the page's strings, as they are written in its files.
    fn known_labels() -> BTreeSet<String> {
        let strings = concat!(env!("CARGO_MANIFEST_DIR"), "/../../web/strings");
        let files =
            std::fs::read_dir(strings).expect("the page has strings").map(|entry| entry.expect("readable").path());
        let files = files.filter(|file| file.to_string_lossy().ends_with("en.js"));
        let texts = files.map(|file| std::fs::read_to_string(file).expect("text"));
        let keys = |text: String| {
            text.lines()
                .filter_map(|line| Some(line.trim().strip_prefix('"')?.split_once("\":")?.0.to_owned()))
                .collect::<Vec<_>>()
        };
        texts.flat_map(keys).collect()
    }

    #[test]
    fn every_label_that_is_named_exists() {
        let known = known_labels();
        let texts = manual::SCREENS.iter().map(|screen| screen.text.en);
        let concepts = [concepts::MOTION, concepts::GEOMETRY, concepts::KINDS]
            .into_iter()
            .flatten()
            .map(|concept| concept.text.en);
        let mut named = 0;
        for text in texts.chain(concepts) {
            let outside_formulas: String = text.split('$').step_by(2).collect();
            for label in outside_formulas.split('{').skip(1).filter_map(|rest| rest.split_once('}')) {
                assert!(known.contains(label.0), "the page has no label `{}`", label.0);
                named += 1;
            }
        }
        assert!(named > 40, "only {named} labels are named");
    }

    #[test]
    fn every_question_mark_of_the_page_is_answered() {
        let mut folders = vec![std::path::PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../web"))];
        let mut asked = 0;
        while let Some(folder) = folders.pop() {
            for file in std::fs::read_dir(folder).expect("readable").map(|entry| entry.expect("readable").path()) {
                if file.is_dir() {
                    folders.push(file);
                } else if file.extension().is_some_and(|extension| extension == "js") {
                    let text = std::fs::read_to_string(&file).expect("text");
                    let own = text.match_indices("mark(\"").filter(|&(at, _)| !text[..at].ends_with('.'));
                    for id in own.filter_map(|(at, call)| text[at + call.len()..].split_once('"')).map(|(id, _)| id) {
                        assert!(
                            id.is_empty() || terms::term(id).is_some(),
                            "{}: `{id}` is not explained",
                            file.display()
                        );
                        asked += 1;
                    }
                }
            }
        }
        assert!(asked >= 4, "only {asked} marks are found");
    }

    #[test]
    fn every_page_can_be_written_and_leads_to_its_sections() {
        let labels: crate::html::Labels = known_labels().into_iter().map(|key| (key, "<label>".to_owned())).collect();
        let in_languages = ["en", "es"].map(|tag| (tag.to_owned(), labels.clone()));
        let pages = crate::pages(&crate::Assets { labels: in_languages.into(), ..Default::default() });
        assert_eq!(pages.len(), 8);
        for (name, html) in pages {
            assert!(!html.contains("<label>"), "{name}: a label is not escaped");
            for place in html.split("href=\"#").skip(1).filter_map(|rest| rest.split_once('"')).map(|(place, _)| place)
            {
                assert!(html.contains(&format!("id=\"{place}\"")), "{name}: #{place} leads nowhere");
            }
        }
    }
}
