//! The file of notices: each text once, with the packages that are under it and whose work they are.

use std::{cmp::Reverse, collections::BTreeMap, fmt::Write};

use anyhow::{Context, Result};

use super::notice::{ALLOWED, Notice, allowed};

const HEAD: &str = "\
Third-party notices of LevaLab
==============================

LevaLab is under the MIT License. The page, the page in a single file and the command have the following works of others built in.
Where a work is offered under several licences, it is used under the one that it stands under here.
Written by `cargo xtask licences`.
";

/// A text and the notices that it serves.
struct Group {
    licence: &'static str,
    text: String,
    notices: Vec<Notice>,
}

/// All notices, put together by their texts.
pub struct Document {
    groups: Vec<Group>,
}

impl Document {
    /// Puts texts together that differ in their line ends, quotation marks and letter case alone.
    pub fn new(notices: Vec<Notice>) -> Result<Document> {
        let mut groups: BTreeMap<(usize, String), Group> = BTreeMap::new();
        let (with_text, without): (Vec<_>, Vec<_>) = notices.into_iter().partition(|notice| notice.text.is_some());
        for notice in with_text {
            let text = notice.text.clone().unwrap_or_default();
            let group = Group { licence: notice.licence, text: text.clone(), notices: Vec::new() };
            groups.entry((rank(notice.licence), plain(&text))).or_insert(group).notices.push(notice);
        }
        for notice in without {
            // The text that most others have.
            let same = groups.values_mut().filter(|group| group.licence == notice.licence);
            let group = same.max_by_key(|group| group.notices.len());
            group.with_context(|| format!("{}: no text of {}", notice.package, notice.licence))?.notices.push(notice);
        }
        let mut groups: Vec<Group> = groups.into_values().collect();
        groups.sort_by_key(|group| (rank(group.licence), Reverse(group.notices.len())));
        Ok(Document { groups })
    }

    /// The whole file.
    pub fn text(&self) -> String {
        let mut written = HEAD.to_owned();
        let mut before = "";
        for group in &self.groups {
            let name = allowed(group.licence).map_or(group.licence, |licence| licence.name);
            let again = if group.licence == before { ", another wording" } else { "" };
            before = group.licence;
            let _ = write!(written, "\n\n## {name}{again}\n\n");
            for notice in &group.notices {
                let _ = writeln!(written, "* {}", notice.package);
                for holder in &notice.holders {
                    let _ = writeln!(written, "  {holder}");
                }
            }
            let _ = write!(written, "\n{}\n", unindented(&group.text));
        }
        written
    }

    /// What a file written earlier lacks.
    pub fn missing_in(&self, written: &str) -> Vec<String> {
        let mut missing = Vec::new();
        let plain_written = plain(written);
        let entries: Vec<&str> = written.split("\n* ").collect();
        for group in &self.groups {
            if !plain_written.contains(&plain(&group.text)) {
                missing.push(format!("the {} of {} is missing", group.licence, group.notices[0].package));
            }
            for notice in &group.notices {
                let entry = entry(notice);
                if !entries.iter().any(|written| *written == entry || written.starts_with(&format!("{entry}\n"))) {
                    missing.push(format!(
                        "the notice of {} under {} is missing or another",
                        notice.package, notice.licence
                    ));
                }
            }
        }
        missing
    }
}

/// A package as the file tells of it.
fn entry(notice: &Notice) -> String {
    notice.holders.iter().fold(notice.package.clone(), |entry, holder| entry + "\n  " + holder)
}

/// Name and version of each package that a file tells of; the parts of the standard library have no version.
pub fn packages_in(written: &str) -> impl Iterator<Item = (&str, &str)> {
    let entries = written.lines().filter_map(|line| line.strip_prefix("* ")?.split_once(' '));
    entries.filter(|(_, version)| version.starts_with(|c: char| c.is_ascii_digit()) && !version.contains(' '))
}

fn rank(id: &str) -> usize {
    ALLOWED.iter().position(|licence| licence.id == id).unwrap_or(ALLOWED.len())
}

/// A text without anything that a copy may change.
fn plain(text: &str) -> String {
    let text = text.replace("https:", "http:").replace(['“', '”', '`', '\''], "\"").to_lowercase();
    text.trim_end_matches('.').split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A text without the spaces that every line begins with, and without those that lines end with.
fn unindented(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    let indented = lines.iter().skip(1).filter(|line| !line.is_empty());
    let common = indented.map(|line| line.len() - line.trim_start().len()).min().unwrap_or(0);
    let cut = |line: &&str| line.get(common..).unwrap_or(line.trim_start()).to_owned();
    let mut text = lines.first().map(|line| (*line).to_owned()).unwrap_or_default();
    for line in lines.iter().skip(1) {
        text += "\n";
        text += &cut(line);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn notice(package: &str, holder: &str, text: Option<&str>) -> Notice {
        Notice { package: package.into(), licence: "MIT", holders: vec![holder.into()], text: text.map(str::to_owned) }
    }

    fn document() -> Document {
        let text = "Permission is \"granted\"\n  to anybody.";
        let notices = [
            notice("a 1.0.0", "Copyright A", Some(text)),
            notice("b 2.0.0", "Copyright B", Some("permission is “granted” to\nanybody.")),
            notice("core (standard library of Rust)", "Copyright R", None),
        ];
        Document::new(notices.into()).expect("texts for all")
    }

    #[test]
    fn a_text_stands_once_below_all_that_are_under_it() {
        let written = document().text();
        assert_eq!(plain(&written).matches("permission is").count(), 1);
        let expected = "* a 1.0.0\n  Copyright A\n* b 2.0.0\n  Copyright B\n* core (standard library of Rust)\n  Copyright R\n\nPermission";
        assert!(written.contains(expected), "{written}");
        assert_eq!(packages_in(&written).collect::<Vec<_>>(), [("a", "1.0.0"), ("b", "2.0.0")]);
    }

    #[test]
    fn what_was_written_lacks_nothing_and_what_was_taken_away_is_missed() {
        let written = document().text();
        assert_eq!(document().missing_in(&written), [""; 0]);
        for part in ["* a 1.0.0\n", "Copyright B", "to anybody", "* core"] {
            assert_eq!(document().missing_in(&written.replace(part, "")).len(), 1, "{part}");
        }
    }

    #[test]
    fn a_licence_without_any_text_is_refused() {
        assert!(Document::new(vec![notice("core", "Copyright R", None)]).is_err());
    }
}
