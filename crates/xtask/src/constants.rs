//! Which constants a function reads, as the linker tells: linked so, each constant is a segment of its own, and every place that names one is
//! listed. A module alone does not tell: in it an address is a number like any other.

use std::{
    collections::{HashMap, HashSet},
    ops::Range,
};

use anyhow::{Context, Result, ensure};
use walrus::{
    Module,
    ir::{Load, MemArg, Store, Value, Visitor, dfs_in_order},
};
use wasmparser::{Data, DataKind, DefinedDataSymbol, KnownCustom, Linking, Operator, Parser, Payload, SymbolInfo};

/// What the compiler is told for a module whose constants are to be told apart. They begin behind 0x110000, a number that code is full of:
/// Unicode ends there.
pub const FLAGS: [&str; 4] = [
    "-Clink-arg=--no-merge-data-segments",
    "-Clink-arg=--emit-relocs",
    "-Clink-arg=--global-base=1179648",
    "-Cstrip=none",
];

/// What the linker adds to the module, and no later tool understands.
const LINKER_SECTIONS: [&str; 3] = ["linking", "reloc.CODE", "reloc.DATA"];

/// Fewest bytes in a row that are worth a segment of their own.
const WORTH_A_SEGMENT: u32 = 24;

/// The constants of a module.
pub struct Constants {
    /// Where each lies in memory, in order.
    places: Vec<Range<u32>>,
    /// The addresses that code names, and whose they are: the end of one constant may be the beginning of the next.
    named: HashMap<u32, HashSet<usize>>,
    /// The constants to which each points.
    pointed: HashMap<usize, HashSet<usize>>,
}

/// A segment of the linked module: where its bytes come to lie, and where they are in the file.
struct Segment {
    place: Range<u32>,
    file: Range<usize>,
}

impl Constants {
    /// The constants of a module that was linked with [`FLAGS`].
    pub fn of(linked: &[u8]) -> Result<Self> {
        let (mut segments, mut symbols, mut relocations, mut data_section) = (Vec::new(), Vec::new(), Vec::new(), 0);
        for payload in Parser::new(0).parse_all(linked) {
            match payload? {
                Payload::DataSection(section) => {
                    data_section = section.range().start;
                    for data in section {
                        segments.push(segment(&data?)?);
                    }
                }
                Payload::CustomSection(section) => match section.as_known() {
                    KnownCustom::Linking(linking) => {
                        for part in linking.subsections() {
                            if let Linking::SymbolTable(table) = part? {
                                symbols = table.into_iter().collect::<Result<Vec<_>, _>>()?;
                            }
                        }
                    }
                    KnownCustom::Reloc(entries) => relocations.push((section.name(), entries.entries())),
                    _ => {}
                },
                _ => {}
            }
        }
        ensure!(relocations.len() >= 2, "the linker did not list what names each constant");
        let address = |symbol: &DefinedDataSymbol, addend: i64| -> Result<u32> {
            let start = segments.get(symbol.index as usize).context("a constant in no segment")?.place.start;
            Ok(u32::try_from(i64::from(start) + i64::from(symbol.offset) + addend)?)
        };
        let (mut named, mut pointed) = (HashMap::<u32, HashSet<usize>>::new(), HashMap::<usize, HashSet<usize>>::new());
        for (section, entries) in relocations {
            for entry in entries {
                let entry = entry?;
                let Some(SymbolInfo::Data { symbol: Some(symbol), .. }) = symbols.get(entry.index as usize) else {
                    continue;
                };
                let constant = symbol.index as usize;
                if section == "reloc.DATA" {
                    let at = data_section + entry.offset as usize;
                    let own = segments.partition_point(|segment| segment.file.end <= at);
                    pointed.entry(own).or_default().insert(constant);
                } else if section == "reloc.CODE" {
                    named.entry(address(symbol, entry.addend)?).or_default().insert(constant);
                }
            }
        }
        Ok(Self { places: segments.into_iter().map(|segment| segment.place).collect(), named, pointed })
    }

    /// The stretches of memory that hold nothing but constants which no function of the module reads.
    pub fn unread(&self, module: &Module) -> Vec<Range<u32>> {
        let mut numbers = Numbers(HashSet::new());
        for (_, function) in module.funcs.iter_local() {
            dfs_in_order(&mut numbers, function, function.entry_block());
        }
        let mut waiting: Vec<usize> = numbers.0.into_iter().flat_map(|number| self.meant_by(number)).collect();
        let mut read: HashSet<usize> = HashSet::new();
        while let Some(constant) = waiting.pop() {
            if read.insert(constant) {
                waiting.extend(self.pointed.get(&constant).into_iter().flatten());
            }
        }
        let mut stretches: Vec<Range<u32>> = Vec::new();
        let mut before = false;
        for (constant, place) in self.places.iter().enumerate() {
            let unread = !read.contains(&constant);
            match stretches.last_mut().filter(|_| before) {
                Some(last) if unread => last.end = place.end,
                _ if unread => stretches.push(place.clone()),
                _ => {}
            }
            before = unread;
        }
        stretches.retain(|stretch| stretch.len() >= WORTH_A_SEGMENT as usize);
        stretches
    }

    /// The constants that a number in code may stand for. One that the linker does not list may come of two that an optimiser added, or be
    /// no address at all: what lies there counts as read.
    fn meant_by(&self, number: u32) -> Vec<usize> {
        if let Some(constants) = self.named.get(&number) {
            return constants.iter().copied().collect();
        }
        let place = self.places.partition_point(|place| place.end <= number);
        self.places.get(place).filter(|found| found.contains(&number)).map_or_else(Vec::new, |_| vec![place])
    }
}

/// The module without what only [`Constants`] understands.
pub fn without_lists(linked: &[u8]) -> Result<Vec<u8>> {
    let mut module = Module::from_buffer(linked)?;
    for section in LINKER_SECTIONS {
        module.customs.remove_raw(section);
    }
    Ok(module.emit_wasm())
}

fn segment(data: &Data) -> Result<Segment> {
    let DataKind::Active { offset_expr, .. } = &data.kind else { anyhow::bail!("a constant without a place") };
    let Operator::I32Const { value } = offset_expr.get_operators_reader().read()? else {
        anyhow::bail!("a constant whose place is not a number")
    };
    let start = value.cast_unsigned();
    let end = start + u32::try_from(data.data.len())?;
    Ok(Segment { place: start..end, file: data.range.end - data.data.len()..data.range.end })
}

/// The numbers in code that may be addresses.
struct Numbers(HashSet<u32>);

impl Numbers {
    fn insert(&mut self, arg: MemArg) {
        self.0.extend(u32::try_from(arg.offset));
    }
}

impl Visitor<'_> for Numbers {
    fn visit_value(&mut self, value: &Value) {
        if let Value::I32(number) = value {
            self.0.insert(number.cast_unsigned());
        }
    }

    fn visit_load(&mut self, load: &Load) {
        self.insert(load.arg);
    }

    fn visit_store(&mut self, store: &Store) {
        self.insert(store.arg);
    }
}

#[cfg(test)]
mod tests {
    use walrus::{FunctionBuilder, ValType};

    use super::*;

    /// A module with a function that does nothing but name some numbers.
    fn naming(numbers: &[i32]) -> Module {
        let mut module = Module::default();
        let mut builder = FunctionBuilder::new(&mut module.types, &[], &[ValType::I32]);
        let mut body = builder.func_body();
        for &number in numbers {
            body.i32_const(number).drop();
        }
        body.i32_const(0);
        builder.finish(Vec::new(), &mut module.funcs);
        module
    }

    fn unread(numbers: &[i32]) -> Vec<(u32, u32)> {
        let constants = Constants {
            places: vec![100..140, 140..150, 152..200, 200..210, 212..300],
            named: HashMap::from([(100, HashSet::from([0])), (140, HashSet::from([0, 1])), (212, HashSet::from([4]))]),
            pointed: HashMap::from([(4, HashSet::from([2]))]),
        };
        constants.unread(&naming(numbers)).into_iter().map(|stretch| (stretch.start, stretch.end)).collect()
    }

    #[test]
    fn what_no_function_names_is_unread_in_one_stretch_with_the_gaps_between() {
        assert_eq!(unread(&[7, 99, 300]), [(100, 300)]);
    }

    #[test]
    fn what_is_named_or_pointed_to_is_read() {
        assert_eq!(unread(&[100]), [(140, 300)]);
        // Constant 4 points to 2; between them lies what is not worth a segment.
        assert_eq!(unread(&[212]), [(100, 150)]);
        // An address between two constants may belong to either.
        assert_eq!(unread(&[140]), [(152, 300)]);
    }

    #[test]
    fn what_the_linker_does_not_list_counts_as_read_where_it_lies() {
        assert_eq!(unread(&[160]), [(100, 150), (200, 300)]);
    }
}
