//! The Raspberry Pi Pico in rp2040js.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use image::{Rgb, RgbImage};
use object::Endianness;
use object::read::elf::{ElfFile32, ProgramHeader};
use serde::{Deserialize, Serialize};

use crate::firmware::Firmware;
use crate::gdb::Result;
use crate::program::{PAINT, Program};

const TARGET: &str = "thumbv6m-none-eabi";
/// The emulator's package.
const EMULATOR: &str = "rp2040js@1.4.1";
/// Steps in a second, as the example has them.
#[allow(dead_code, reason = "tests know the example itself")]
pub(crate) const RATE: u32 = 42;
/// Pixels a side.
pub(crate) const SIDE: u32 = 240;
const FLASH: u32 = 0x1000_0000;

/// What is done while the program runs: pictures are counted from one.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct Plan {
    /// The step whose picture is the last; without one, the sheet comes to rest.
    pub(crate) until: Option<u32>,
    /// After which pictures, beside the last, the display is looked at.
    pub(crate) shots: Vec<usize>,
    /// After which pictures the button goes down or up.
    pub(crate) presses: Vec<(usize, bool)>,
}

/// What was seen.
#[derive(Debug)]
pub(crate) struct Run {
    /// The step that each picture shows.
    pub(crate) steps: Vec<u32>,
    /// The display's pixels, row by row.
    pub(crate) shots: Vec<Vec<u16>>,
    pub(crate) log: Vec<String>,
    /// Bytes of stack that were used, and all.
    pub(crate) stack: [usize; 2],
    /// Bytes that the display received in a second of rest, if it came to that.
    #[allow(dead_code, reason = "for the tests")]
    pub(crate) idle: Option<u32>,
    /// What was wrong with what the display or the chip was told.
    pub(crate) errors: Vec<String>,
}

#[derive(Deserialize)]
struct Output {
    steps: Vec<u32>,
    shots: Vec<Vec<u16>>,
    log: Vec<u8>,
    stack: Vec<u8>,
    on: bool,
    idle: Option<u32>,
    errors: Vec<String>,
}

/// Builds the example.
pub(crate) fn build() -> PathBuf {
    let firmware = Firmware {
        example: "pico",
        board: None,
        features: "pico",
        profile: "board",
        targets: &[TARGET],
        only: [None; 2],
    };
    firmware.build()[TARGET].clone()
}

/// Runs a program.
pub(crate) fn run(path: &Path, plan: &Plan) -> Result<Run> {
    let program = Program::read(path)?;
    let work = tempfile::tempdir()?;
    let [flash, orders] = ["flash", "orders"].map(|name| work.path().join(name));
    fs::write(&flash, image(path)?)?;
    let mut order = serde_json::to_value(plan)?;
    order["stop"] = program.address("shown")?.into();
    order["failed"] = program.address("HardFault")?.into();
    order["log"] = program.address("_SEGGER_RTT")?.into();
    order["stack"] = vec![program.address("_stack_end")?, program.address("_stack_start")?].into();
    fs::write(&orders, order.to_string())?;
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/emulate/rp2040.mjs");
    let output = Command::new("node").arg(script).args([&emulator()?, &flash, &orders]).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let mut output: Output = serde_json::from_slice(&output.stdout)?;
    if !output.on {
        output.errors.push("the display is off".into());
    }
    let unused = output.stack.chunks_exact(4).take_while(|word| **word == PAINT.to_le_bytes()).count() * 4;
    Ok(Run {
        steps: output.steps,
        shots: output.shots,
        log: program.decode(&output.log)?,
        stack: [output.stack.len() - unused, output.stack.len()],
        idle: output.idle,
        errors: output.errors,
    })
}

/// The colours of pixels.
#[allow(dead_code, reason = "tests compare the pixels themselves")]
pub(crate) fn picture(shot: &[u16]) -> RgbImage {
    RgbImage::from_fn(SIDE, SIDE, |x, y| {
        let color = Rgb888::from(Rgb565::from(RawU16::new(shot[(y * SIDE + x) as usize])));
        Rgb([color.r(), color.g(), color.b()])
    })
}

/// What a program puts into the flash.
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

/// The emulator's folder, where npm puts it once: `KERCHIEF_CACHE`, or else the user's cache.
fn emulator() -> Result<PathBuf> {
    let cache = std::env::var_os("KERCHIEF_CACHE").map(PathBuf::from).or_else(|| {
        let base = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from);
        Some(base.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".cache")))?.join("kerchief"))
    });
    let cache = cache.ok_or("neither HOME nor KERCHIEF_CACHE is set")?;
    let package = cache.join("node_modules/rp2040js");
    if !package.exists() {
        fs::create_dir_all(&cache)?;
        let npm = ["install", "--silent", "--no-save", "--prefix"];
        let output = Command::new("npm").args(npm).arg(&cache).arg(EMULATOR).output()?;
        if !output.status.success() {
            return Err(format!("npm install {EMULATOR}: {}", String::from_utf8_lossy(&output.stderr)).into());
        }
    }
    Ok(package)
}
