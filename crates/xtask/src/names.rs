//! Short names for what a module and its glue call each other: the generated ones are long and carry checksums, which do not pack.

use std::collections::HashMap;

use anyhow::Result;
use regex::{Captures, Regex};
use walrus::{ExportItem, Module};

/// How the functions of the glue begin that the module imports.
const IMPORTED: &str = "__wb";

/// Renames the functions that module and glue call in each other, in both.
pub fn shorten(glue: &str, module: &[u8]) -> Result<(String, Vec<u8>)> {
    let mut module = Module::from_buffer(module)?;
    let (mut exports, mut imports) = (HashMap::new(), HashMap::new());
    let functions = module.exports.iter_mut().filter(|export| matches!(export.item, ExportItem::Function(_)));
    for (number, export) in functions.enumerate() {
        let name = std::mem::replace(&mut export.name, format!("x{number}"));
        exports.insert(name, export.name.clone());
    }
    for (number, import) in module.imports.iter_mut().filter(|import| import.name.starts_with(IMPORTED)).enumerate() {
        let name = std::mem::replace(&mut import.name, format!("i{number}"));
        imports.insert(name, import.name.clone());
    }
    let word = Regex::new(r"(wasm\.)?\b(\w+)")?;
    let renamed = word.replace_all(glue, |found: &Captures| {
        let through = found.get(1).map_or("", |through| through.as_str());
        let name = &found[2];
        let names = if through.is_empty() { &imports } else { &exports };
        format!("{through}{}", names.get(name).map_or(name, String::as_str))
    });
    Ok((renamed.into_owned(), module.emit_wasm()))
}

#[cfg(test)]
mod tests {
    use walrus::{FunctionBuilder, ValType};

    use super::*;

    #[test]
    fn both_call_each_other_by_the_same_short_names() -> Result<()> {
        let mut module = Module::default();
        let signature = module.types.add(&[ValType::I32], &[]);
        module.add_import_func("./glue.js", "__wbg_fill_cb36fe21", signature);
        let nothing = FunctionBuilder::new(&mut module.types, &[], &[]).finish(Vec::new(), &mut module.funcs);
        module.exports.add("fill", nothing);
        let memory = module.memories.add_local(false, false, 1, None, None);
        module.exports.add("memory", memory);
        let glue = "function fill() { wasm.fill(wasm.memory); } return { __wbg_fill_cb36fe21: (x) => x.fill() };";
        let (glue, module) = shorten(glue, &module.emit_wasm())?;
        assert_eq!(glue, "function fill() { wasm.x0(wasm.memory); } return { i0: (x) => x.fill() };");
        let module = Module::from_buffer(&module)?;
        assert_eq!(module.exports.iter().map(|export| export.name.as_str()).collect::<Vec<_>>(), ["x0", "memory"]);
        assert_eq!(module.imports.iter().map(|import| import.name.as_str()).collect::<Vec<_>>(), ["i0"]);
        Ok(())
    }
}
