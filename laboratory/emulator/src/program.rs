//! Reads a linked program: the addresses of its symbols, and the table that decodes its log.

use std::fs;
use std::path::Path;

use defmt_decoder::{DecodeError, Table};
use object::read::elf::ElfFile32;
use object::{Endianness, Object, ObjectSymbol};

use crate::Result;

/// The word with which `cortex-m-rt` fills the stack before the program starts.
pub const PAINT: u32 = 0xcccc_cccc;

/// A linked program.
#[derive(Debug)]
pub struct Program {
    symbols: Vec<(String, u32)>,
    /// The format strings of the log, if the program has one.
    table: Option<Table>,
}

impl Program {
    /// Reads an ELF file.
    pub fn read(path: &Path) -> Result<Self> {
        let data = fs::read(path)?;
        let file = ElfFile32::<Endianness>::parse(data.as_slice())?;
        let name = |symbol: &object::read::elf::ElfSymbol32<'_, '_>| {
            let name = symbol.name().unwrap_or_default();
            format!("{:#}", rustc_demangle::demangle(name))
        };
        let symbols = file.symbols().map(|symbol| (name(&symbol), symbol.address() as u32)).collect();
        let table = Table::parse(&data)?;
        Ok(Self { symbols, table })
    }

    /// The address of the first symbol with this name, or of a function whose path ends with it. Bit 0 (Thumb) is cleared.
    pub fn address(&self, name: &str) -> Result<u32> {
        let ends = |full: &str| full == name || full.strip_suffix(name).is_some_and(|path| path.ends_with("::"));
        let found = self.symbols.iter().find(|(full, _)| ends(full));
        found.map(|(_, address)| address & !1).ok_or_else(|| format!("the program has no {name}").into())
    }

    /// Decodes the bytes of a log to lines.
    pub fn decode(&self, bytes: &[u8]) -> Result<Vec<String>> {
        let table = self.table.as_ref().ok_or("the program has no log")?;
        let mut decoder = table.new_stream_decoder();
        decoder.received(bytes);
        let mut lines = Vec::new();
        loop {
            match decoder.decode() {
                Ok(frame) => {
                    let level = frame.level().map_or("print", |level| level.as_str());
                    lines.push(format!("{level}: {}", frame.display_message()));
                }
                Err(DecodeError::UnexpectedEof) => return Ok(lines),
                Err(DecodeError::Malformed) => return Err("the log is malformed".into()),
            }
        }
    }
}
