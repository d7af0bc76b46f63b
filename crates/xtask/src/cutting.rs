//! The page's module for the first picture: what drawing it runs, and nothing else. The whole follows while that picture is looked at.
//!
//! What the first picture runs is not guessed: a watched copy of the module draws it (`first-picture.js`) and tells which stretches of code
//! it came through. The others are cut out; where one is needed after all, the module stops, and `web/engine.js` waits for the whole and
//! begins again with that. Constants that only those stretches read are left out too.

use std::{collections::HashSet, iter, mem, ops::Range};

use anyhow::{Result, bail, ensure};
use walrus::{
    ConstExpr, Data, DataKind, FunctionId, LocalFunction, Memory, Module, ModuleConfig, ValType,
    ir::{Instr, InstrSeqId, Unreachable, Value},
    passes::gc,
};

use crate::constants::Constants;

/// What the watched module exports for each stretch of code, with its number: 1 once it was entered.
const ENTERED: &str = "entered";

/// Fewest instructions in a row that are worth cutting out.
const WORTH_CUTTING: usize = 3;

/// What a function is called that is left whole: memory is found in other ways each time.
const UNCUT: [&str; 3] = ["dlmalloc", "__rdl_", "externref_table"];

/// A stretch of code that is entered at its beginning only: a place in a sequence, which it leaves at the next such place.
type Stretch = (InstrSeqId, usize);

/// The module with a flag for each stretch of its code that goes up when the stretch is entered.
pub fn watched(module: &[u8]) -> Result<Vec<u8>> {
    let mut module = parsed(module)?;
    let mut number = 0;
    for id in own_functions(&module) {
        let mut stretches = stretches(module.funcs.get(id).kind.unwrap_local());
        // From the back, so that places stay where they are.
        stretches.reverse();
        let last = number + stretches.len();
        for (before, &(sequence, place)) in stretches.iter().enumerate() {
            let flag = module.globals.add_local(ValType::I32, true, false, ConstExpr::Value(Value::I32(0)));
            module.exports.add(&format!("{ENTERED}{}", last - 1 - before), flag);
            let body = module.funcs.get_mut(id).kind.unwrap_local_mut().builder_mut();
            body.instr_seq(sequence).const_at(place, Value::I32(1)).global_set_at(place + 1, flag);
        }
        number = last;
    }
    Ok(module.emit_wasm())
}

/// What is left of a module whose functions still have their names; `entered` holds the numbers of the stretches that the first picture entered.
pub fn first(module: &[u8], entered: &HashSet<usize>, constants: &Constants) -> Result<Vec<u8>> {
    ensure!(!entered.is_empty(), "the first picture entered nothing");
    let mut module = parsed(module)?;
    cut(&mut module, entered)?;
    gc::run(&mut module);
    let unread = constants.unread(&module);
    keep_constants(&mut module, |place| between(place, &unread))?;
    Ok(module.emit_wasm())
}

/// Cuts out every stretch that was not entered.
fn cut(module: &mut Module, entered: &HashSet<usize>) -> Result<()> {
    let (mut number, mut left_whole) = (0, 0);
    for id in own_functions(module) {
        let function = module.funcs.get_mut(id);
        let whole = function.name.as_ref().is_some_and(|name| UNCUT.iter().any(|part| name.contains(part)));
        left_whole += usize::from(whole);
        let function = function.kind.unwrap_local_mut();
        let mut cut = HashSet::new();
        for (sequence, place) in stretches(function) {
            if !entered.contains(&number) && !whole && cut.insert(sequence) {
                cut_out(function, sequence, place);
            }
            number += 1;
        }
    }
    ensure!(left_whole > 0, "the functions have no names, or nothing reserves memory");
    Ok(())
}

/// The module with all its constants in one segment, as they were before they were told apart.
pub fn joined(module: &[u8]) -> Result<Vec<u8>> {
    let mut module = parsed(module)?;
    keep_constants(&mut module, |place| vec![place])?;
    Ok(module.emit_wasm())
}

/// Where code can be entered: the beginning of each sequence, and what follows an instruction that may go elsewhere. In each sequence they
/// are in order, and where one is not entered, none behind it is.
fn stretches(function: &LocalFunction) -> Vec<Stretch> {
    let mut found = Vec::new();
    let mut waiting = vec![function.entry_block()];
    while let Some(sequence) = waiting.pop() {
        found.push((sequence, 0));
        for (place, (instruction, _)) in function.block(sequence).instrs.iter().enumerate() {
            let within = within(instruction);
            if !within.is_empty() || matches!(instruction, Instr::BrIf(_)) {
                found.push((sequence, place + 1));
            }
            waiting.extend(within);
        }
    }
    found
}

/// The sequences that an instruction holds.
fn within(instruction: &Instr) -> Vec<InstrSeqId> {
    match instruction {
        Instr::Block(block) => vec![block.seq],
        Instr::Loop(block) => vec![block.seq],
        Instr::IfElse(either) => vec![either.consequent, either.alternative],
        _ => Vec::new(),
    }
}

/// Stops at a place, instead of going on, when that makes the function shorter.
fn cut_out(function: &mut LocalFunction, sequence: InstrSeqId, place: usize) {
    if length(function, sequence, place) >= WORTH_CUTTING {
        let instructions = &mut function.builder_mut().instr_seq(sequence);
        instructions.instrs_mut().truncate(place);
        instructions.instr(Unreachable {});
    }
}

/// How many instructions there are from a place on.
fn length(function: &LocalFunction, sequence: InstrSeqId, place: usize) -> usize {
    let instructions = function.block(sequence).instrs.iter().skip(place);
    instructions
        .map(|(one, _)| 1 + within(one).into_iter().map(|inner| length(function, inner, 0)).sum::<usize>())
        .sum()
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

fn parsed(bytes: &[u8]) -> Result<Module> {
    ModuleConfig::new().generate_name_section(false).generate_producers_section(false).parse(bytes)
}

/// All but those that come from outside, in an order that is the same for the same bytes.
fn own_functions(module: &Module) -> Vec<FunctionId> {
    module.funcs.iter_local().map(|(id, _)| id).collect()
}
#[cfg(test)]
mod tests {
    use walrus::{FunctionBuilder, InstrSeqBuilder};

    use super::*;

    /// How many instructions are left of a function that takes one of two ways and then leaves or goes on, when it came through some of its
    /// stretches: 0 at the beginning, 1 behind the fork, 2 where it goes on, 3 and 4 the ways, of one step and of four. With those of one
    /// that finds memory.
    fn left(entered: &[usize]) -> Result<[usize; 2]> {
        let mut module = Module::default();
        let steps = |body: &mut InstrSeqBuilder, count: i32| (0..count).for_each(|n| _ = body.i32_const(n).drop());
        let mut forked = FunctionBuilder::new(&mut module.types, &[ValType::I32], &[]);
        let which = module.locals.add(ValType::I32);
        let mut body = forked.func_body();
        let whole = body.id();
        body.local_get(which).if_else(None, |way| steps(way, 4), |way| steps(way, 1));
        body.local_get(which).br_if(whole);
        steps(&mut body, 3);
        let forked = forked.finish(vec![which], &mut module.funcs);
        let mut memory = FunctionBuilder::new(&mut module.types, &[], &[]);
        memory.name("dlmalloc::malloc".to_owned());
        steps(&mut memory.func_body(), 5);
        let memory = memory.finish(Vec::new(), &mut module.funcs);
        cut(&mut module, &entered.iter().copied().collect())?;
        Ok([forked, memory].map(|id| {
            let function = module.funcs.get(id).kind.unwrap_local();
            length(function, function.entry_block(), 0)
        }))
    }

    #[test]
    fn what_was_not_entered_is_cut_out_when_that_is_shorter() -> Result<()> {
        let [all, memory] = left(&[0, 1, 2, 3, 4, 5])?;
        assert_eq!((all, memory), (2 + 2 + 8 + 2 + 6, 10));
        // What is cut out leaves one instruction, which stops.
        assert_eq!(left(&[0, 1, 2, 3])?, [all - 8 + 1, memory]);
        assert_eq!(left(&[0, 1, 3, 4])?, [all - 6 + 1, memory]);
        // One step has two instructions: not worth it.
        assert_eq!(left(&[0, 1, 2, 4])?, [all, memory]);
        assert_eq!(left(&[])?, [1, memory]);
        Ok(())
    }

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
