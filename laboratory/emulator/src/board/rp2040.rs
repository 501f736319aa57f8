//! The RP2040 in rp2040js.

use std::ffi::OsStr;
use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;

use object::Endianness;
use object::read::elf::{ElfFile32, ProgramHeader};

use crate::Result;

/// The emulator's npm package and version.
const EMULATOR: &str = "rp2040js@1.4.1";
const FLASH: u32 = 0x1000_0000;

/// Runs a program by one of the scripts beside this file. Passes the steps that the script reports to `shown`, and returns its output, which is JSON.
pub(crate) fn run(
    script: &str,
    program: &Path,
    orders: impl AsRef<OsStr>,
    mut shown: impl FnMut(u32),
) -> Result<Vec<u8>> {
    let work = tempfile::tempdir()?;
    let flash = work.path().join("flash");
    fs::write(&flash, image(program)?)?;
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/board").join(script);
    let mut node = Command::new("node");
    node.arg(script).args([&emulator()?, &flash]).arg(orders).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut node = node.spawn().map_err(|error| format!("node: {error}"))?;
    let (mut output, errors) = (node.stdout.take().ok_or("no output")?, node.stderr.take().ok_or("no errors")?);
    let seen = thread::spawn(move || {
        let mut seen = Vec::new();
        output.read_to_end(&mut seen).map(|_| seen)
    });
    let mut complaint = String::new();
    for line in BufReader::new(errors).lines() {
        let line = line?;
        match line.strip_prefix("step ").and_then(|step| step.parse().ok()) {
            Some(step) => shown(step),
            None => complaint.extend([&line, "\n"]),
        }
    }
    let status = node.wait()?;
    let seen = seen.join().map_err(|_| "the emulator's output is lost")??;
    if status.success() { Ok(seen) } else { Err(complaint.into()) }
}

/// The contents of the flash for a program.
fn image(path: &Path) -> Result<Vec<u8>> {
    let data = fs::read(path)?;
    let file = ElfFile32::<Endianness>::parse(data.as_slice())?;
    let endian = file.endian();
    let mut flash = Vec::new();
    for segment in file.elf_program_headers() {
        let bytes = segment.data(endian, data.as_slice()).map_err(|()| "a segment beyond the file")?;
        let Some(start) = segment.p_paddr(endian).checked_sub(FLASH).filter(|_| !bytes.is_empty()) else { continue };
        let end = start as usize + bytes.len();
        if flash.len() < end {
            flash.resize(end, 0xff);
        }
        flash[start as usize..end].copy_from_slice(bytes);
    }
    Ok(flash)
}

/// The folder of rp2040js, in `KERCHIEF_CACHE` or else in the user's cache. npm installs it there if it is missing.
fn emulator() -> Result<PathBuf> {
    let cache = std::env::var_os("KERCHIEF_CACHE").map(PathBuf::from).or_else(|| {
        let base = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from);
        Some(base.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".cache")))?.join("kerchief"))
    });
    let cache = cache.ok_or("neither HOME nor KERCHIEF_CACHE is set")?;
    let installed = cache.join(EMULATOR);
    if !installed.exists() {
        install(&cache, &installed)?;
    }
    Ok(installed.join("rp2040js"))
}

/// Installs rp2040js into a temporary folder and renames that: another process may install it at the same time, and npm may be interrupted.
fn install(cache: &Path, place: &Path) -> Result<()> {
    fs::create_dir_all(cache)?;
    let work = tempfile::tempdir_in(cache)?;
    let npm = ["install", "--silent", "--no-save", "--prefix"];
    let output = Command::new("npm").args(npm).arg(work.path()).arg(EMULATOR).output()?;
    if !output.status.success() {
        return Err(format!("npm install {EMULATOR}: {}", String::from_utf8_lossy(&output.stderr)).into());
    }
    match fs::rename(work.path().join("node_modules"), place) {
        // another process was quicker
        Err(_) if place.exists() => Ok(()),
        moved => Ok(moved?),
    }
}
