//! The sections, the functions and the call graph of a linked program.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use emulator::footprint::footprint;
use object::read::elf::{ElfFile32, FileHeader};
use object::{Endianness, Object, ObjectSection, ObjectSymbol, SymbolKind, elf};

/// A program for an Arm microcontroller.
#[derive(Debug)]
pub(crate) struct Image {
    /// Bytes of flash.
    pub(crate) flash: u64,
    /// Bytes of RAM, without the stack.
    pub(crate) ram: u64,
    functions: Vec<Function>,
}

#[derive(Debug)]
struct Function {
    name: String,
    address: u64,
    end: u64,
    /// Targets of branches and calls that leave the function.
    targets: BTreeSet<u64>,
    /// Whether it calls an address in a register (BLX).
    indirect: bool,
}

impl Image {
    pub(crate) fn read(path: &Path) -> Self {
        let data = fs::read(path).expect("the program can be read");
        let file = ElfFile32::<Endianness>::parse(data.as_slice()).expect("the program is an ELF file");
        assert_eq!(file.elf_header().e_machine(file.endian()), elf::EM_ARM);
        let [flash, ram] = footprint(&file);
        Self { flash, ram, functions: functions(&file) }
    }

    /// The names of all functions.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.functions.iter().map(|function| function.name.as_str())
    }

    /// The names of the functions that may be reached from the function whose name ends with `root`, each with a chain of calls.
    pub(crate) fn reached(&self, root: &str) -> BTreeMap<&str, String> {
        let mut waiting: Vec<_> = self.functions.iter().filter(|function| function.name.ends_with(root)).collect();
        assert_eq!(waiting.len(), 1, "one function is called {root}");
        let mut reached = BTreeMap::from([(waiting[0].name.as_str(), root.to_owned())]);
        while let Some(function) = waiting.pop() {
            assert!(!function.indirect, "{} calls through a pointer: nobody knows what", function.name);
            for &target in &function.targets {
                let callee = self.functions.iter().find(|callee| (callee.address..callee.end).contains(&target));
                let callee = callee.unwrap_or_else(|| panic!("{} branches to {target:#x}, no function", function.name));
                if !reached.contains_key(callee.name.as_str()) {
                    let way = format!("{} > {}", reached[function.name.as_str()], callee.name);
                    reached.insert(&callee.name, way);
                    waiting.push(callee);
                }
            }
        }
        reached
    }
}

fn functions(file: &ElfFile32<'_>) -> Vec<Function> {
    let text = file.section_by_name(".text").expect("a program has code");
    let code = text.data().expect("code has bytes");
    let range = text.address()..text.address() + text.size();
    let inside = |address: &u64| range.contains(address);
    let symbols = || file.symbols().filter(|symbol| inside(&(symbol.address() & !1)));
    let name = |symbol: &object::read::elf::ElfSymbol32<'_, '_>| symbol.name().unwrap_or_default().to_owned();
    // mapping symbols mark the beginnings of code ($t) and constants ($d)
    let mut marks: Vec<(u64, bool)> = symbols()
        .filter(|symbol| name(symbol).starts_with("$t") || name(symbol).starts_with("$d"))
        .map(|symbol| (symbol.address(), name(&symbol).starts_with("$t")))
        .collect();
    marks.sort_unstable();
    let is_code = |address: u64| marks.iter().rev().find(|(start, _)| *start <= address).is_none_or(|(_, code)| *code);
    let mut starts: Vec<_> = symbols()
        .filter(|symbol| symbol.kind() == SymbolKind::Text && !name(symbol).starts_with('$'))
        .map(|symbol| (symbol.address() & !1, symbol.size(), name(&symbol)))
        .collect();
    starts.sort_unstable();
    // one address may have several names
    starts.dedup_by_key(|(address, ..)| *address);
    let ends = starts.iter().skip(1).map(|(address, ..)| *address).chain([range.end]).collect::<Vec<_>>();
    let function = |((address, size, name), next): ((u64, u64, String), u64)| {
        let end = if size == 0 { next } else { address + size };
        let mut function = Function {
            name: format!("{:#}", rustc_demangle::demangle(&name)),
            address,
            end,
            targets: BTreeSet::new(),
            indirect: false,
        };
        let half = |at: u64| {
            let offset = (at - range.start) as usize;
            code.get(offset..offset + 2).map_or(0, |bytes| u16::from_le_bytes([bytes[0], bytes[1]]))
        };
        let mut at = address;
        while at < end {
            if !is_code(at) {
                at += 2;
                continue;
            }
            let (first, second) = (half(at), half(at + 2));
            let wide = first >> 11 >= 0b11101;
            if let Some(target) = branch(at, first, wide.then_some(second))
                && !(address..end).contains(&target)
            {
                function.targets.insert(target);
            }
            function.indirect |= first & 0xff87 == 0x4780;
            at += if wide { 4 } else { 2 };
        }
        function
    };
    starts.into_iter().zip(ends).map(function).collect()
}

/// The target of a branch instruction, with or without link (Arm v7-M Architecture Reference Manual, A7.7.12 and A7.7.18).
fn branch(at: u64, first: u16, second: Option<u16>) -> Option<u64> {
    let (first, wide) = (u32::from(first), second.map(u32::from));
    let offset = match wide {
        None if first >> 12 == 0b1101 && (first >> 8) & 0xf < 0xe => extend((first & 0xff) << 1, 9),
        None if first >> 11 == 0b11100 => extend((first & 0x7ff) << 1, 12),
        Some(second) if first >> 11 == 0b11110 && second & 0x9000 == 0x9000 => {
            // BL and the unconditional branch: J1 and J2 are upper bits of the offset, inverted if the sign bit is clear
            let sign = (first >> 10) & 1;
            let [j1, j2] = [second >> 13, second >> 11].map(|bit| (bit & 1) ^ sign ^ 1);
            extend(sign << 24 | j1 << 23 | j2 << 22 | (first & 0x3ff) << 12 | (second & 0x7ff) << 1, 25)
        }
        Some(second) if first >> 11 == 0b11110 && second & 0xd000 == 0x8000 && (first >> 6) & 0xf < 0xe => {
            let [j1, j2] = [second >> 13, second >> 11].map(|bit| bit & 1);
            let sign = (first >> 10) & 1;
            extend(sign << 20 | j2 << 19 | j1 << 18 | (first & 0x3f) << 12 | (second & 0x7ff) << 1, 21)
        }
        _ => return None,
    };
    Some(at.wrapping_add(4).wrapping_add_signed(i64::from(offset)))
}

/// Sign-extends a number of `bits` bits.
fn extend(value: u32, bits: u32) -> i32 {
    (value << (32 - bits)) as i32 >> (32 - bits)
}
