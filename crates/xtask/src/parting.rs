//! The page's module in two parts: what the first picture needs, and the rest, which follows while that picture is looked at.
//!
//! Which functions the first picture needs is not guessed: a watched copy of the module draws it (`first-picture.js`) and tells what it
//! entered. In the first part every other function is a stub that calls through the table; the rest, once there, puts its functions into
//! that table. Constants that only those read wait with them. Memory, tables and globals are one, so nothing has to be started afresh. A stub that is called too early finds an empty
//! slot, which is a trap: `web/engine.js` then waits for the rest.

use std::{
    collections::{HashMap, HashSet},
    iter, mem,
    ops::Range,
};

use anyhow::{Context, Result, bail, ensure};
use walrus::{
    ConstExpr, Data, DataKind, ElementItems, ElementKind, ExportItem, FunctionBuilder, FunctionId, FunctionKind,
    GlobalKind, ImportedFunction, Memory, Module, ModuleConfig, TableId, ValType,
    ir::{Value, Visitor, dfs_in_order},
    passes::gc,
};

use crate::constants::Constants;

/// The module whose exports the rest imports.
const FIRST: &str = "first";

/// What the watched module exports for each of its own functions, with its number: 1 once it was entered.
pub const ENTERED: &str = "entered";

/// Both parts, as files.
pub struct Parts {
    /// What the first picture needs.
    pub first: Vec<u8>,
    /// All else.
    pub rest: Vec<u8>,
}

/// The module with a flag for each of its own functions that goes up when the function is entered.
pub fn watched(module: &[u8]) -> Result<Vec<u8>> {
    let mut module = parsed(module)?;
    for (number, id) in own_functions(&module).into_iter().enumerate() {
        let flag = module.globals.add_local(ValType::I32, true, false, ConstExpr::Value(Value::I32(0)));
        module.exports.add(&format!("{ENTERED}{number}"), flag);
        let body = module.funcs.get_mut(id).kind.unwrap_local_mut().builder_mut();
        body.func_body().const_at(0, Value::I32(1)).global_set_at(1, flag);
    }
    Ok(module.emit_wasm())
}

/// Parts a module; `entered` holds the numbers of the functions that the first picture entered.
pub fn part(module: &[u8], entered: &HashSet<usize>, constants: &Constants) -> Result<Parts> {
    ensure!(!entered.is_empty(), "the first picture entered no function");
    let whole = parsed(module)?;
    let early = with_small_ones(&whole, entered);
    let late = constants.unread(&whole, &functions_where(&whole, &early, true));
    let (rest, needed) = rest(module, &early, &late)?;
    Ok(Parts { first: first(module, &early, &late, &needed)?, rest })
}

/// The functions of the first part: those that were entered, and the small ones that they call. Which turn a sort or a number takes
/// depends on the data, and leaving those out would save little.
fn with_small_ones(module: &Module, entered: &HashSet<usize>) -> HashSet<usize> {
    let functions: Vec<_> = module.funcs.iter_local().collect();
    let numbers: HashMap<_, _> = functions.iter().enumerate().map(|(number, &(id, _))| (id, number)).collect();
    let mut called = Called(HashSet::new());
    for &number in entered {
        let function = functions[number].1;
        dfs_in_order(&mut called, function, function.entry_block());
    }
    let small = called.0.iter().filter_map(|id| numbers.get(id)).filter(|&&number| functions[number].1.size() <= SMALL);
    entered.iter().chain(small).copied().collect()
}

/// Instructions of a function that is worth no stub.
const SMALL: u64 = 150;

/// Functions that are called by name.
struct Called(HashSet<FunctionId>);

impl Visitor<'_> for Called {
    fn visit_function_id(&mut self, function: &FunctionId) {
        self.0.insert(*function);
    }
}

/// The rest, and the names of all that it wants from the first part.
fn rest(bytes: &[u8], early: &HashSet<usize>, late_constants: &[Range<u32>]) -> Result<(Vec<u8>, Vec<String>)> {
    let mut module = parsed(bytes)?;
    keep_constants(&mut module, |_| late_constants.to_vec())?;
    let late = functions_where(&module, early, false);
    let (table, slots) = slots(&module)?;
    let exports: Vec<_> = module.exports.iter().map(walrus::Export::id).collect();
    exports.into_iter().for_each(|id| module.exports.delete(id));
    let imports: Vec<_> = module.imports.iter().map(walrus::Import::id).collect();
    imports.into_iter().for_each(|id| module.imports.delete(id));
    module.start = None;
    import_all(&mut module, &late.iter().copied().collect());
    let offset = ConstExpr::Value(Value::I32(slots));
    let filled = module.elements.add(ElementKind::Active { table, offset }, ElementItems::Functions(late));
    module.tables.get_mut(table).elem_segments.insert(filled);
    gc::run(&mut module);
    let needed = module.imports.iter().map(|import| import.name.clone()).collect();
    Ok((module.emit_wasm(), needed))
}

/// Everything but the functions `kept` comes from the first part: functions `f`, memories `m`, tables `t`, globals `g`, each with its place.
fn import_all(module: &mut Module, kept: &HashSet<FunctionId>) {
    let Module { funcs, memories, tables, globals, imports, elements, .. } = module;
    for (place, function) in funcs.iter_mut().enumerate() {
        if !kept.contains(&function.id()) {
            let import = imports.add(FIRST, &format!("f{place}"), function.id());
            function.kind = FunctionKind::Import(ImportedFunction { import, ty: function.ty() });
        }
    }
    for (place, memory) in memories.iter_mut().enumerate() {
        memory.import = Some(imports.add(FIRST, &format!("m{place}"), memory.id()));
    }
    for (place, table) in tables.iter_mut().enumerate() {
        table.import = Some(imports.add(FIRST, &format!("t{place}"), table.id()));
        // It will be longer by then.
        table.maximum = None;
        table.elem_segments.drain().for_each(|id| elements.delete(id));
    }
    let ids: Vec<_> = globals.iter().map(walrus::Global::id).collect();
    for (place, id) in ids.into_iter().enumerate() {
        globals.get_mut(id).kind = GlobalKind::Import(imports.add(FIRST, &format!("g{place}"), id));
    }
}

fn first(bytes: &[u8], early: &HashSet<usize>, late: &[Range<u32>], needed: &[String]) -> Result<Vec<u8>> {
    let mut module = parsed(bytes)?;
    keep_constants(&mut module, |place| between(place, late))?;
    let (table, slots) = slots(&module)?;
    let mut slot = slots;
    for id in functions_where(&module, early, false) {
        stub(&mut module, id, table, slot);
        slot += 1;
    }
    let room = u64::try_from(slot - slots)?;
    let table = module.tables.get_mut(table);
    table.initial += room;
    table.maximum = table.maximum.map(|most| most + room);
    for name in needed {
        let item = named(&module, name).with_context(|| format!("nothing is called {name}"))?;
        module.exports.add(name, item);
    }
    gc::run(&mut module);
    Ok(module.emit_wasm())
}

/// Makes new segments of constants out of all: one for each stretch of memory that `kept` names among all that they take up.
fn keep_constants(module: &mut Module, kept: impl Fn(Range<u32>) -> Vec<Range<u32>>) -> Result<()> {
    let segments: Vec<_> = module.data.iter().map(Data::id).collect();
    let mut pieces: Vec<(u32, Vec<u8>)> = Vec::new();
    let [memory] = module.memories.iter().map(Memory::id).collect::<Vec<_>>()[..] else {
        bail!("constants belong into one memory")
    };
    for id in segments {
        let segment = module.data.get_mut(id);
        let DataKind::Active { offset: ConstExpr::Value(Value::I32(start)), .. } = segment.kind else {
            bail!("a constant without a place")
        };
        pieces.push((start.cast_unsigned(), mem::take(&mut segment.value)));
        module.data.delete(id);
    }
    let memory_of = module.memories.get_mut(memory);
    memory_of.data_segments.clear();
    let start = pieces.iter().map(|(start, _)| *start).min().unwrap_or(0);
    let mut image: Vec<u8> = Vec::new();
    for (place, bytes) in &pieces {
        let place = (place - start) as usize;
        image.resize(image.len().max(place + bytes.len()), 0);
        image[place..place + bytes.len()].copy_from_slice(bytes);
    }
    for stretch in kept(start..start + u32::try_from(image.len())?) {
        let bytes = image[(stretch.start - start) as usize..(stretch.end - start) as usize].to_vec();
        let offset = ConstExpr::Value(Value::I32(stretch.start.cast_signed()));
        memory_of.data_segments.insert(module.data.add(DataKind::Active { memory, offset }, bytes));
    }
    Ok(())
}

/// What is left of a range without some of its parts, which are in order.
fn between(whole: Range<u32>, without: &[Range<u32>]) -> Vec<Range<u32>> {
    let starts = iter::once(whole.start).chain(without.iter().map(|gap| gap.end));
    let ends = without.iter().map(|gap| gap.start).chain([whole.end]);
    starts.zip(ends).map(|(start, end)| start..end).filter(|left| !left.is_empty()).collect()
}

/// Makes a function pass its arguments on to whatever a slot of the table holds.
fn stub(module: &mut Module, id: FunctionId, table: TableId, slot: i32) {
    let of = module.funcs.get(id).ty();
    let (parameters, results) = (module.types.params(of).to_vec(), module.types.results(of).to_vec());
    let mut builder = FunctionBuilder::new(&mut module.types, &parameters, &results);
    let arguments: Vec<_> = parameters.iter().map(|&parameter| module.locals.add(parameter)).collect();
    let mut body = builder.func_body();
    for &argument in &arguments {
        body.local_get(argument);
    }
    body.i32_const(slot).call_indirect(of, table);
    module.funcs.get_mut(id).kind = FunctionKind::Local(builder.local_func(arguments));
}

/// What a letter and a place stand for.
fn named(module: &Module, name: &str) -> Option<ExportItem> {
    let (letter, place) = name.split_at_checked(1)?;
    let place = place.parse().ok()?;
    Some(match letter {
        "f" => module.funcs.iter().nth(place)?.id().into(),
        "m" => module.memories.iter().nth(place)?.id().into(),
        "t" => module.tables.iter().nth(place)?.id().into(),
        "g" => module.globals.iter().nth(place)?.id().into(),
        _ => return None,
    })
}

fn parsed(bytes: &[u8]) -> Result<Module> {
    ModuleConfig::new().generate_name_section(false).generate_producers_section(false).parse(bytes)
}

/// All but those that come from outside, in an order that is the same for the same bytes.
fn own_functions(module: &Module) -> Vec<FunctionId> {
    module.funcs.iter_local().map(|(id, _)| id).collect()
}

/// Those with a number among the early ones, or the others.
fn functions_where(module: &Module, early: &HashSet<usize>, wanted: bool) -> Vec<FunctionId> {
    let functions = own_functions(module).into_iter().enumerate();
    functions.filter(|(number, _)| early.contains(number) == wanted).map(|(_, id)| id).collect()
}

/// The table of functions, and its first slot beyond those of the whole module.
fn slots(module: &Module) -> Result<(TableId, i32)> {
    let table = module.tables.main_function_table()?.context("the module has no table of functions")?;
    Ok((table, module.tables.get(table).initial.try_into()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_of_a_range_and_its_parts_cover_it() {
        let left = |without: &[Range<u32>]| -> Vec<u32> { between(10..20, without).into_iter().flatten().collect() };
        assert_eq!(left(&[]), (10..20).collect::<Vec<u32>>());
        assert_eq!(left(&[10..12, 15..20]), [12, 13, 14]);
        assert_eq!(left(&[11..12, 12..18]), [10, 18, 19]);
    }

    #[test]
    fn each_byte_of_the_constants_is_in_one_part() -> Result<()> {
        let whole = || {
            let mut module = Module::default();
            let memory = module.memories.add_local(false, false, 1, None, None);
            for (start, bytes) in [(16, b"abcd"), (20, b"efgh"), (28, b"ijkl")] {
                let offset = ConstExpr::Value(Value::I32(start));
                let id = module.data.add(DataKind::Active { memory, offset }, bytes.to_vec());
                module.memories.get_mut(memory).data_segments.insert(id);
            }
            module
        };
        let kept = |keep: &dyn Fn(Range<u32>) -> Vec<Range<u32>>| -> Result<Vec<u8>> {
            let mut module = whole();
            keep_constants(&mut module, keep)?;
            Ok(module.data.iter().flat_map(|data| data.value.clone()).collect())
        };
        let late = [18..22, 30..32];
        assert_eq!(kept(&|_| late.to_vec())?, b"cdefkl");
        assert_eq!(kept(&|place| between(place, &late))?, b"abgh\0\0\0\0ij");
        Ok(())
    }
}
