//! The rarer work of the page: the worked solution, the joining of requirements and the tournament of laws.
//!
//! A module of its own, loaded when one of them is asked for. The main module does not wait for it, and a visitor who
//! never asks does not load it.

mod joining;
mod solution;
mod tournament;

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
import type { Design, Language, SolutionNode } from "../types.d.ts";
"#;
