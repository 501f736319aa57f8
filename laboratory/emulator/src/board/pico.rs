//! The Raspberry Pi Pico in rp2040js.

use std::fs;
use std::path::Path;

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use image::{Rgb, RgbImage};
use serde::{Deserialize, Serialize};

use crate::board::rp2040;
use crate::program::{PAINT, Program};
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("examples/pico", "pico", &["thumbv6m-none-eabi"]);
/// Pixels a side.
pub const SIDE: u32 = pico::show::SCREEN.width;

/// What is done while the program runs: pictures are counted from one.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Plan {
    /// The step whose picture is the last; without one, the sheet comes to rest.
    pub until: Option<u32>,
    /// After which pictures, beside the last, the display is looked at.
    pub shots: Vec<usize>,
    /// After which pictures the button goes down or up.
    pub presses: Vec<(usize, bool)>,
    /// Whether what is read from the flash comes through a model of its cache, or at once.
    pub cached: bool,
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
    /// Bytes that the display received in a second of rest, and cycles in which the processor was awake, if it came to that.
    pub idle: Option<[u32; 2]>,
    /// Of the processor, Hz.
    pub frequency: u32,
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
    idle: Option<[u32; 2]>,
    frequency: u32,
    errors: Vec<String>,
}

/// Runs a program, and tells `shown` after every picture which step it shows.
///
/// # Errors
///
/// What is wrong with the program or the emulator. What the display and the chip found wrong is in the [`Run`].
pub fn run(path: &Path, plan: &Plan, shown: impl FnMut(u32)) -> Result<Run> {
    let program = Program::read(path)?;
    let work = tempfile::tempdir()?;
    let orders = work.path().join("orders");
    let mut order = serde_json::to_value(plan)?;
    order["stop"] = program.address("shown")?.into();
    order["failed"] = program.address("HardFault")?.into();
    order["log"] = program.address("_SEGGER_RTT")?.into();
    order["stack"] = vec![program.address("_stack_end")?, program.address("_stack_start")?].into();
    fs::write(&orders, order.to_string())?;
    let seen = rp2040::run("pico.mjs", path, &orders, shown)?;
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
        frequency: output.frequency,
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
