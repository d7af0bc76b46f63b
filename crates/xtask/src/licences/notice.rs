//! What a package's licence asks to be said along with it: its text, and whose work it is.

use std::{fs, path::Path};

use anyhow::{Context, Result, bail, ensure};
use regex::{Regex, RegexBuilder};
use spdx::{Expression, LicenseReq, Licensee, ParseMode};
use walkdir::WalkDir;

use super::package::Package;
use crate::project;

/// A licence that may be built in.
pub struct Licence {
    /// Its SPDX identifier.
    pub id: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Finds its text within a file, any space standing for any other. What stands before and after is whose work it is.
    text: &'static str,
}

/// The licences that may be built in, in the order in which they are chosen where a package offers several.
pub const ALLOWED: [Licence; 11] = [
    Licence {
        id: "MIT",
        name: "MIT License",
        text: "Permission is hereby granted, free of charge.*?DEALINGS IN (THE )?SOFTWARE",
    },
    Licence {
        id: "BSD-2-Clause",
        name: "BSD 2-Clause License",
        text: "Redistribution and use in source and binary forms.*?POSSIBILITY OF SUCH DAMAGE",
    },
    Licence {
        id: "BSD-3-Clause",
        name: "BSD 3-Clause License",
        text: "Redistribution and use in source and binary forms.*?neither the name.*?POSSIBILITY OF SUCH DAMAGE",
    },
    Licence { id: "ISC", name: "ISC License", text: "Permission to use, copy, modify.*?PERFORMANCE OF THIS SOFTWARE" },
    Licence { id: "Zlib", name: "zlib License", text: "This software is provided 'as-is'.*?any source distribution" },
    Licence {
        id: "MIT-0",
        name: "MIT No Attribution",
        text: "Permission is hereby granted, free of charge.*?DEALINGS IN THE SOFTWARE",
    },
    Licence {
        id: "Apache-2.0",
        name: "Apache License 2.0",
        text: "Apache License Version 2\\.0.*?END OF TERMS AND CONDITIONS",
    },
    Licence {
        id: "Unicode-3.0",
        name: "Unicode License v3",
        text: "Permission is hereby granted, free of charge.*?authorization of the copyright holder",
    },
    Licence {
        id: "OFL-1.1",
        name: "SIL Open Font License 1.1",
        text: "SIL OPEN FONT LICENSE Version 1\\.1.*OTHER DEALINGS IN THE FONT SOFTWARE",
    },
    Licence {
        id: "Ubuntu-font-1.0",
        name: "Ubuntu Font Licence 1.0",
        text: "UBUNTU FONT LICENCE Version 1\\.0.*DEALINGS IN THE FONT SOFTWARE",
    },
    Licence {
        id: "Bitstream-Vera",
        name: "Bitstream Vera License",
        text: "Permission is hereby granted, free of charge, to any person obtaining a copy of the fonts.*?gnome dot org",
    },
];

/// Packages that bring no text of their own licence, or a file that only points to it: MIT, in the words of LevaLab's own copy.
const WITHOUT_TEXT: [&str; 5] = ["crc-catalog", "epaint_default_fonts", "plotters", "plotters-backend", "plotters-svg"];

/// Works within a package under a licence that its own expression leaves out: package, licence, file.
const WITHIN: [(&str, &str, &str); 1] = [("epaint_default_fonts", "Bitstream-Vera", "fonts/Hack-Regular.txt")];

/// One licence of one package.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// The package, with its version when it has one here.
    pub package: String,
    /// The licence's SPDX identifier.
    pub licence: &'static str,
    /// Whose work it is: lines that go with the text.
    pub holders: Vec<String>,
    /// The text; without one, that of the others under the same licence.
    pub text: Option<String>,
}

/// The licence of that identifier.
pub fn allowed(id: &str) -> Option<&'static Licence> {
    ALLOWED.iter().find(|licence| licence.id == id)
}

/// The notices of a package: one for each licence that has to be kept, where it offers several the first that is allowed.
pub fn of(package: &Package) -> Result<Vec<Notice>> {
    let files = licence_files(&package.folder)?;
    let mut notices = chosen(&package.expression)?
        .into_iter()
        .map(|licence| within(package, licence, &files))
        .collect::<Result<Vec<_>>>()?;
    for (_, id, file) in WITHIN.into_iter().filter(|(name, ..)| *name == package.name) {
        let licence = allowed(id).context(id)?;
        let text = fs::read_to_string(package.folder.join(file)).with_context(|| file.to_owned())?;
        notices.push(cut(package, licence, &text)?.with_context(|| format!("{file} holds no {id}"))?);
    }
    Ok(notices)
}

/// The licences to keep of those that an SPDX expression offers.
fn chosen(expression: &str) -> Result<Vec<&'static Licence>> {
    let parsed = Expression::parse_mode(expression, ParseMode::LAX).with_context(|| format!("`{expression}`"))?;
    let licensees = ALLOWED.iter().map(|licence| Licensee::parse(licence.id)).collect::<Result<Vec<_>, _>>()?;
    let Ok(kept) = parsed.minimized_requirements(&licensees) else {
        bail!("none of the allowed licences satisfies `{expression}`");
    };
    kept.iter().map(|kept: &LicenseReq| allowed(&kept.to_string()).with_context(|| kept.to_string())).collect()
}

/// The notice in the first file that holds that licence.
fn within(package: &Package, licence: &'static Licence, files: &[String]) -> Result<Notice> {
    for file in files {
        if let Some(notice) = cut(package, licence, file)? {
            return Ok(notice);
        }
    }
    ensure!(
        licence.id == "MIT" && WITHOUT_TEXT.contains(&package.name.as_str()),
        "no text of its licence {}",
        licence.id
    );
    let own = fs::read_to_string(project::path("LICENSE")).context("LICENSE")?;
    let notice = cut(package, licence, &own)?.context("LICENSE is another licence")?;
    let holders = package.authors.iter().map(|author| format!("Copyright (c) {author}")).collect();
    Ok(Notice { holders, ..notice })
}

/// Everything in a package that looks like a licence or a notice, in the order of names.
fn licence_files(folder: &Path) -> Result<Vec<String>> {
    let named = Regex::new(r"(?i)^((un)?licen[cs]e|copying|copyright|notice|ofl|ufl)")?;
    let mut texts = Vec::new();
    for entry in WalkDir::new(folder).max_depth(2).sort_by_file_name() {
        let entry = entry?;
        if entry.file_type().is_file() && named.is_match(&entry.file_name().to_string_lossy()) {
            texts.push(fs::read_to_string(entry.path()).with_context(|| entry.path().display().to_string())?);
        }
    }
    Ok(texts)
}

/// The licence's text in a file parted from whose work it is.
fn cut(package: &Package, licence: &Licence, file: &str) -> Result<Option<Notice>> {
    let pattern = licence.text.replace(' ', r"\s+");
    let pattern =
        RegexBuilder::new(&format!("{pattern}\\.?")).dot_matches_new_line(true).case_insensitive(true).build()?;
    let Some(found) = pattern.find(file) else { return Ok(None) };
    // A licence that only adds a clause to another one holds that one's text as well.
    let adds = licence.id == "BSD-2-Clause" && found.as_str().to_lowercase().contains("neither the name");
    let other = licence.id == "MIT" && found.as_str().contains("copy of the fonts");
    if adds || other {
        return Ok(None);
    }
    let (before, after) = (&file[..found.start()], &file[found.end()..]);
    let holders = before.lines().filter(|line| !is_title(line)).chain(after.lines().filter(|line| names_holder(line)));
    Ok(Some(Notice {
        package: package.to_string(),
        licence: allowed(licence.id).context(licence.id)?.id,
        holders: holders.map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect(),
        text: Some(found.as_str().to_owned()),
    }))
}

/// An empty line, a rule, or the name of a licence.
fn is_title(line: &str) -> bool {
    let line = line.trim_matches(|c: char| !c.is_alphanumeric()).to_lowercase();
    let names = ["license", "licence", "(mit", "clause", "version 2.0"];
    line.is_empty() || (!line.contains("copyright") && line.len() < 60 && names.iter().any(|name| line.contains(name)))
}

/// A line such as `Copyright 2020 Somebody`; the sample in the Apache licence's appendix names nobody.
fn names_holder(line: &str) -> bool {
    let line = line.trim().to_lowercase();
    line.starts_with("copyright") && line.contains(|c: char| c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package() -> Package {
        Package {
            name: "a".into(),
            version: "1.0.0".into(),
            expression: String::new(),
            authors: Vec::new(),
            folder: std::path::PathBuf::new(),
        }
    }

    fn ids(expression: &str) -> Result<Vec<&'static str>> {
        Ok(chosen(expression)?.into_iter().map(|licence| licence.id).collect())
    }

    #[test]
    fn of_several_licences_the_first_allowed_one_is_kept_and_of_added_ones_each() {
        assert_eq!(ids("Apache-2.0 OR MIT").expect("allowed"), ["MIT"]);
        assert_eq!(ids("Unlicense/MIT").expect("allowed"), ["MIT"]);
        let mut both = ids("(MIT OR Apache-2.0) AND Unicode-3.0").expect("allowed");
        both.sort_unstable();
        assert_eq!(both, ["MIT", "Unicode-3.0"]);
    }

    #[test]
    fn a_licence_that_is_not_allowed_is_refused() {
        for expression in ["GPL-3.0-only", "MIT AND MPL-2.0", "LGPL-2.1-or-later", "", "Proprietary"] {
            assert!(ids(expression).is_err(), "{expression}");
        }
    }

    #[test]
    fn a_text_is_parted_from_whose_work_it_is() {
        let mit = fs::read_to_string(project::path("LICENSE")).expect("LICENSE");
        let notice = cut(&package(), &ALLOWED[0], &mit).expect("a pattern").expect("an MIT license");
        assert_eq!(notice.holders, ["Copyright (c) 2026 the LevaLab authors"]);
        let text = notice.text.expect("a text");
        assert!(
            text.starts_with("Permission is hereby granted") && text.ends_with("DEALINGS IN THE\nSOFTWARE."),
            "{text}"
        );
        assert_eq!(cut(&package(), allowed("Zlib").expect("allowed"), &mit).expect("a pattern"), None);
    }

    #[test]
    fn a_package_without_a_text_is_refused() {
        let error = within(&package(), &ALLOWED[0], &[]).expect_err("there is none");
        assert_eq!(error.to_string(), "no text of its licence MIT");
    }
}
