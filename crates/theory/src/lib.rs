//! The theory, the terms, the manual and the notices of others' works of LevaLab as static pages, in English and Spanish.
//!
//! Laws and followers come from their lists in the core: each has its section, with formulas printed from the curve that the core
//! computes with. Formulas are data ([`levalab_formula`]): they are printed as MathML, and the tests evaluate them against the core.
//! What the page has already is taken from it: labels of buttons for the manual, drawings as SVG ([`pages::Assets`]).
//!
//! Not here: the worked solution of a design, which is `levalab-solve`.

mod figure;
mod followers;
pub mod html;
mod law_facts;
mod laws;
mod licences;
mod notations;
pub mod pages;
mod terms;
pub mod words;

pub use pages::{Assets, pages};
