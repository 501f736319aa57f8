//! The flash and RAM that a program takes.

use std::path::Path;

use object::read::elf::ElfFile32;
use object::{Endianness, Object, ObjectSection, SectionFlags, SectionKind, elf};

use crate::Result;

/// Like [`footprint`], for a program in a file.
///
/// # Errors
///
/// If the file can't be read or is not a 32-bit ELF file.
pub fn of(program: &Path) -> Result<[u64; 2]> {
    let data = std::fs::read(program)?;
    Ok(footprint(&ElfFile32::parse(data.as_slice())?))
}

/// Bytes of flash (vectors, code, constants and initial values of variables), and bytes of RAM for variables. The stack is not included.
pub fn footprint(file: &ElfFile32<'_, Endianness>) -> [u64; 2] {
    let (mut flash, mut ram) = (0, 0);
    for section in file.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else { continue };
        if sh_flags & u64::from(elf::SHF_ALLOC) == 0 {
            continue;
        }
        let size = section.size();
        let writable = sh_flags & u64::from(elf::SHF_WRITE) != 0;
        let empty = matches!(section.kind(), SectionKind::UninitializedData);
        flash += if empty { 0 } else { size };
        ram += if writable { size } else { 0 };
    }
    [flash, ram]
}
