//! The tables of the documentation that list laws, followers, applications and findings are those of the catalogue.
//! `UPDATE_DOCS=1` writes them anew.

use levalab_catalogue::{APPLICATIONS, FINDINGS, FOLLOWERS, LAWS, Label, Version, law_label};
use levalab_core::application::Application;
use levalab_core::{FollowerKind, LAWS as CORE_LAWS, Parameter};
use levalab_format::{CamKind, data_key, motion_and_contact};
use std::sync::Mutex;

const DOCS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/design-format.md");

/// One table is written at a time.
static WRITING: Mutex<()> = Mutex::new(());

/// The table with these heads has these rows and no others.
fn assert_table(heads: &str, rows: &[String]) {
    let _one_at_a_time = WRITING.lock();
    let page = std::fs::read_to_string(DOCS).expect("the documentation");
    let (before, table) =
        page.split_once(&format!("{heads}\n")).unwrap_or_else(|| panic!("no table begins with {heads}"));
    let (rule, table) = table.split_once('\n').expect("a rule under the heads");
    let written: Vec<&str> = table.lines().take_while(|line| line.starts_with('|')).collect();
    if std::env::var_os("UPDATE_DOCS").is_some() {
        let after: String = table.split_inclusive('\n').skip(written.len()).collect();
        let rows = rows.join("\n");
        return std::fs::write(DOCS, format!("{before}{heads}\n{rule}\n{rows}\n{after}")).expect("written");
    }
    let [missing, stale] = [
        rows.iter().find(|row| !written.contains(&row.as_str())),
        written.iter().copied().map(str::to_owned).find(|row| !rows.contains(row)).as_ref(),
    ]
    .map(|row| row.cloned().unwrap_or_default());
    assert!(
        written == rows,
        "docs/design-format.md lacks: {missing}\nand should not have: {stale}\nUPDATE_DOCS=1 writes it anew"
    );
}

fn quoted(words: impl IntoIterator<Item = impl std::fmt::Display>) -> String {
    words.into_iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}

/// Keys in backquotes, with the value of those that may be left out.
fn keys(parameters: &[Parameter]) -> String {
    let key = |parameter: &Parameter| match parameter.default {
        Some(value) if parameter.optional => format!("`{}` ({value})", parameter.key),
        _ => format!("`{}`", parameter.key),
    };
    parameters.iter().map(key).collect::<Vec<_>>().join(", ")
}

fn since(version: Version) -> u8 {
    match version {
        Version::One => 1,
        Version::Two => 2,
    }
}

#[test]
fn laws_are_those_of_the_catalogue() {
    let row = |label: &Label, takes: String| {
        let Label { id, link, .. } = label;
        format!("| `{id}` | {} | {takes} | `{link}` | {} |", label.alone.en, since(label.since))
    };
    let rows = CORE_LAWS.iter().map(|law| {
        let data = data_key(law).map(|key| format!("`{key}`"));
        let own = Some(keys(law.parameters)).filter(|keys| !keys.is_empty());
        row(law_label(law).expect(law.id), data.into_iter().chain(own).collect::<Vec<_>>().join(", "))
    });
    assert_table("| law | name | takes | code | version |", &rows.collect::<Vec<_>>());
    assert_eq!(LAWS.len(), CORE_LAWS.len() + 1, "only the circular arc is for no design");
}

#[test]
fn followers_are_those_of_the_catalogue() {
    let rows = FOLLOWERS.iter().map(|row| {
        let kind = FollowerKind::by_id(row.id).expect(row.id);
        let (motion, contact) = motion_and_contact(kind);
        let takes = keys(kind.parameters);
        let name = row.name.alone.en;
        format!("| `{motion}` | `{contact}` | {name} | {takes} | `{}` | {} |", row.link, since(row.since))
    });
    assert_table("| motion | contact | name | parameters | code | version |", &rows.collect::<Vec<_>>());
}

#[test]
fn applications_are_those_of_the_catalogue() {
    let rows = APPLICATIONS.iter().map(|row| {
        let application = Application::by_id(row.id).expect(row.id);
        let settings = application.parameters.iter().map(|setting| match setting.default {
            Some(value) => format!("`{}` ({})", setting.key, value.to_degrees()),
            None => format!("`{}`", setting.key),
        });
        let takes = settings.collect::<Vec<_>>().join(", ");
        let gives = quoted(application.outputs.iter().map(|output| output.id));
        format!("| `{}` | {} | {takes} | {gives} | `{}` |", row.id, row.name.alone.en, row.link)
    });
    assert_table("| kind | name | parameters | outputs | code |", &rows.collect::<Vec<_>>());
}

#[test]
fn findings_are_those_of_the_catalogue() {
    let rows = FINDINGS.iter().map(|row| format!("| `{}` | {} | {} |", row.id, row.name.alone.en, row.idea.en));
    assert_table("| code | name | meaning |", &rows.collect::<Vec<_>>());
}

#[test]
fn every_kind_of_cam_is_documented() {
    let page = std::fs::read_to_string(DOCS).expect("the documentation");
    for word in CamKind::WORDS {
        assert!(page.contains(&format!("\n| `{word}` |")), "docs/design-format.md lacks the kind {word}");
    }
}
