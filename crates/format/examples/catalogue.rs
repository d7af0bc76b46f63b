//! Prints two lines of JSON that the page keeps as scripts: what its forms are built from (laws, followers, kinds of cam, units and
//! limits), and the names of these things in each language.

use levalab_catalogue::{Language, page_names};
use std::collections::BTreeMap;

fn main() -> serde_json::Result<()> {
    println!("{}", serde_json::to_string(&levalab_format::Catalogue::default())?);
    let names = Language::ALL.map(|language| (language.tag(), page_names(language).into_iter().collect()));
    let names: BTreeMap<&str, BTreeMap<String, &str>> = names.into();
    println!("{}", serde_json::to_string(&names)?);
    Ok(())
}
