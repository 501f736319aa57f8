//! The Raspberry Pi Pico in rp2040js.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use image::{Rgb, RgbImage};
use object::Endianness;
use object::read::elf::{ElfFile32, ProgramHeader};
use serde::{Deserialize, Serialize};

use crate::program::{PAINT, Program};
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("examples/pico", "pico", &["thumbv6m-none-eabi"]);
/// The emulator's package.
const EMULATOR: &str = "rp2040js@1.4.1";
/// Pixels a side.
pub const SIDE: u32 = pico::show::SCREEN.width;
const FLASH: u32 = 0x1000_0000;

/// What is done while the program runs: pictures are counted from one.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Plan {
    /// The step whose picture is the last; without one, the sheet comes to rest.
    pub until: Option<u32>,
    /// After which pictures, beside the last, the display is looked at.
    pub shots: Vec<usize>,
    /// After which pictures the button goes down or up.
    pub presses: Vec<(usize, bool)>,
}

/// What was seen.
#[derive(Debug)]
pub struct Run {
    /// The step that each picture shows.
    pub steps: Vec<u32>,
    /// The display's pixels, row by row.
    pub shots: Vec<Vec<u16>>,
    /// The lines of the log.
    pub log: Vec<String>,
    /// Bytes of stack that were used, and all.
    pub stack: [usize; 2],
    /// Bytes that the display received in a second of rest, if it came to that.
    pub idle: Option<u32>,
    /// What was wrong with what the display or the chip was told.
    pub errors: Vec<String>,
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

/// Runs a program, and tells `shown` after every picture which step it shows.
///
/// # Errors
///
/// What is wrong with the program or the emulator. What the display and the chip found wrong is in the [`Run`].
pub fn run(path: &Path, plan: &Plan, mut shown: impl FnMut(u32)) -> Result<Run> {
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
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/src/board/rp2040.mjs");
    let mut node = Command::new("node");
    node.arg(script).args([&emulator()?, &flash, &orders]).stdout(Stdio::piped()).stderr(Stdio::piped());
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
    if !status.success() {
        return Err(complaint.into());
    }
    let mut output: Output = serde_json::from_slice(&seen)?;
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
pub fn picture(shot: &[u16]) -> RgbImage {
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
