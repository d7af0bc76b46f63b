//! What the laws, followers, kinds of cam, applications and findings of LevaLab are called.
//!
//! One row for each thing: its id, its code in a link, the version that first knew it, its name in English and in Spanish,
//! the idea in one sentence, and the source. Menus, links, sentences, the command line, the pages of theory and the tables
//! of the documentation read these rows, so that a thing has one name wherever it is shown. The core lists laws, followers
//! and applications; one that has no row here does not compile, and neither does a row that lacks a field.
//!
//! ```
//! use levalab_catalogue::{Language, law_label};
//! use levalab_core::Law;
//!
//! let label = Law::by_id("modified-sine").and_then(law_label).unwrap();
//! assert_eq!(label.noun.within(Language::Es), "de seno modificado");
//! assert_eq!(label.link, "M");
//! ```
//!
//! Not here: sentences about a cam, symbols and units.

mod applications;
mod check;
mod findings;
mod followers;
mod kinds;
mod label;
mod language;
mod laws;
mod page;
mod two;

pub use applications::{APPLICATIONS, ApplicationRow, PartName, application_label, part_name};
pub use findings::{FINDINGS, FindingLabel, FindingRow, finding_label};
pub use followers::{FOLLOWERS, FollowerRow, follower_label, follower_row};
pub use kinds::{KINDS, KindRow, is_a_kind, kind_label};
pub use label::{Label, Name, Version};
pub use language::Language;
pub use laws::{LAWS, LawRow, law_group, law_label, law_row};
pub use page::page_names;
pub use two::{Two, capital, two};

#[cfg(test)]
mod tests;
