//! A plugin for QEMU that counts executed instructions. It is independent of the boards' clock: QEMU reports the blocks of instructions that run, so
//! that the plugin needs neither a timer nor `-icount`.
//!
//! ```sh
//! qemu-system-arm … -plugin libcounter.so,mark=ADDRESS,counts=FILE
//! ```
//!
//! Whenever the function at the address starts, the plugin appends a line to the file: the number of instructions executed before.
//!
//! The interface is QEMU's `qemu-plugin.h`, version 1 (QEMU 4.2 to 8.2). It is declared by hand, because distributions don't ship the header.
#![allow(unsafe_code, reason = "QEMU calls it, and is called, as C")]

use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::fs::File;
use std::io::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

/// The version of the interface. QEMU refuses versions that it doesn't know.
#[unsafe(no_mangle)]
#[allow(non_upper_case_globals, reason = "QEMU looks for this name")]
pub static qemu_plugin_version: c_int = 1;

/// A translation block: instructions that run in sequence and are left only after the last.
#[repr(C)]
struct Block([u8; 0]);

/// A callback at the start of a block. Its arguments are the number of the processor and the registered data.
type Started = extern "C" fn(c_uint, *mut c_void);

/// `QEMU_PLUGIN_CB_NO_REGS`: the callback accesses no registers.
const NO_REGISTERS: c_int = 0;

unsafe extern "C" {
    fn qemu_plugin_register_vcpu_tb_trans_cb(plugin: u64, translated: extern "C" fn(u64, *mut Block));
    fn qemu_plugin_register_vcpu_tb_exec_cb(block: *mut Block, started: Started, flags: c_int, data: *mut c_void);
    fn qemu_plugin_tb_n_insns(block: *const Block) -> usize;
    fn qemu_plugin_tb_vaddr(block: *const Block) -> u64;
}

/// Instructions so far.
static COUNT: AtomicU64 = AtomicU64::new(0);
static MARK: OnceLock<Mark> = OnceLock::new();

/// The arguments of the plugin.
struct Mark {
    address: u64,
    counts: File,
}

impl Mark {
    fn parse(words: impl Iterator<Item = String>) -> Result<Self, String> {
        let (mut address, mut counts) = (None, None);
        for word in words {
            let failed = |error: &dyn std::fmt::Display| format!("{word}: {error}");
            match word.split_once('=') {
                Some(("mark", value)) => address = Some(value.parse().map_err(|error| failed(&error))?),
                Some(("counts", value)) => counts = Some(File::create(value).map_err(|error| failed(&error))?),
                _ => return Err(format!("{word}: neither mark=ADDRESS nor counts=FILE")),
            }
        }
        let (Some(address), Some(counts)) = (address, counts) else {
            return Err("mark=ADDRESS and counts=FILE are needed".to_owned());
        };
        Ok(Self { address, counts })
    }
}

/// The entry point, which QEMU calls first.
///
/// # Safety
///
/// `words` must point to `count` C strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn qemu_plugin_install(
    plugin: u64,
    _info: *const c_void,
    count: c_int,
    words: *const *const c_char,
) -> c_int {
    let word = |index| {
        // SAFETY: the caller passes `count` strings, and `index` is less.
        let word = unsafe { CStr::from_ptr(*words.add(index)) };
        word.to_string_lossy().into_owned()
    };
    let mark = Mark::parse((0..count as usize).map(word));
    if let Err(error) = mark.and_then(|mark| MARK.set(mark).map_err(|_| "it is loaded twice".to_owned())) {
        return complain(&error);
    }
    // SAFETY: the plugin's own identifier, and a function that lives as long as the process.
    unsafe { qemu_plugin_register_vcpu_tb_trans_cb(plugin, translated) };
    0
}

fn complain(error: &str) -> c_int {
    eprintln!("counter: {error}");
    1
}

/// Registers the callback of a newly translated block.
extern "C" fn translated(_plugin: u64, block: *mut Block) {
    // SAFETY: QEMU passes a valid block, which is used only while it is translated.
    unsafe {
        let instructions = qemu_plugin_tb_n_insns(block);
        let is_mark = MARK.get().is_some_and(|mark| mark.address == qemu_plugin_tb_vaddr(block));
        let started = if is_mark { marked } else { counted };
        qemu_plugin_register_vcpu_tb_exec_cb(block, started, NO_REGISTERS, instructions as *mut c_void);
    }
}

extern "C" fn counted(_processor: c_uint, instructions: *mut c_void) {
    COUNT.fetch_add(instructions as u64, Ordering::Relaxed);
}

extern "C" fn marked(processor: c_uint, instructions: *mut c_void) {
    let written = MARK.get().map(|mark| writeln!(&mark.counts, "{}", COUNT.load(Ordering::Relaxed)));
    if let Some(Err(error)) = written {
        complain(&error.to_string());
    }
    counted(processor, instructions);
}
