//! The rarer work of the page: the worked solution, the joining of requirements, the tournament of laws and the reduction of
//! measured data.
//!
//! A module of its own, loaded when one of them is asked for. The main module does not wait for it, and a visitor who
//! never asks does not load it.

mod joining;
mod measured;
mod solution;
mod tournament;

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
import type { Design, Language, Measured, MeasuredOrder, SolutionNode } from "../types.d.ts";
"#;
